#!/bin/sh
# man_page.sh TAUT: the manual page, made of what the program says with --help-all.
set -eu
taut=$1
export COLUMNS=999  # a line for each option

# In the language of man pages; in lists of options and commands, what stands left and what stands right of two spaces.
formatted() {
  awk '
    function escaped(text) {
      gsub(/\\/, "\\e", text)
      gsub(/-/, "\\-", text)
      sub(/^[.\047]/, "\\\\\\&&", text)
      return text
    }
    /^Examples?:$/ { print ".PP\n" $0 "\n.nf"; is_example = 1; next }
    is_example { if ($0 == "") { print ".fi"; is_example = 0 } else print escaped($0); next }
    /^(Positionals|Options):$/ || /^  (-h,)?--help/ { next }
    /^(Garment|Body|Picture|Output|Run):$/ { print ".PP\n.I " $0; next }
    /^Subcommands:$/ { is_list_of_commands = 1 }
    is_list_of_commands { is_list_of_commands = $0 != ""; next }
    /^Usage: / { print ".PP\n.B " escaped(substr($0, 8)); next }
    /^  [^ ]/ {
      text = substr($0, 3)
      gap = match(text, /   *[^ ]/)
      print ".TP\n.B " escaped(gap ? substr(text, 1, gap - 1) : text)
      if (gap) print escaped(substr(text, gap + RLENGTH - 1))
      next
    }
    { sub(/^ +/, ""); print $0 == "" ? ".PP" : escaped($0) }'
}

printf '.TH TAUT 1 "" "%s" "User Commands"\n' "$("$taut" --version)"
printf '.SH NAME\ntaut \\- simulates garments that do not over-stretch and draws them\n'
printf '.SH DESCRIPTION\n'
"$taut" --help | formatted
printf '.SH COMMANDS\n'
for command in $("$taut" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z][a-z-]*\) .*/\1/p'); do
  printf '.SS taut %s\n' "$command"
  "$taut" "$command" --help-all | formatted
done
cat <<'END'
.SH ENVIRONMENT
.TP
.B TAUT_ASSETS
a folder with other
.I scenes
and
.I garments
than those that come along
END
