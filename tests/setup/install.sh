#!/usr/bin/env bash
# install.sh CMAKE BUILD SOURCES [hidden]: the installed program, moved to another folder, does what the README says first;
# its manual page and its completions know every command. With `hidden` nothing of the sources can be read meanwhile.
set -euo pipefail
cmake=$1 build=$2 sources=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
. "$(dirname "$0")/../support/fail.sh"

hiding=()
if [ "${4-}" = hidden ]; then
  hiding=(unshare --mount)
  [ "$(id -u)" -eq 0 ] || hiding+=(--map-root-user)
  hiding+=(sh -c 'mount -t tmpfs none "$1" && shift && exec "$@"' sh "$sources")
  reason=$("${hiding[@]}" true 2>&1) || {
    echo "SKIPPED: the sources cannot be hidden from one process here: $reason"
    exit 77
  }
fi

"$cmake" --install "$build" --prefix "$folder/staged" >"$folder/log.txt" || fail "$(cat "$folder/log.txt")"
mv "$folder/staged" "$folder/usr"
mkdir "$folder/empty"
cd "$folder/empty"
export PATH="$folder/usr/bin:$PATH"
# without_sources COMMAND...
without_sources() {
  "${hiding[@]}" "$@"
}

bash "$sources/tests/library/installed.sh" "$cmake" "$sources" "$folder/usr" "${hiding[@]}"

commands='figures render simulate view inspect fit sew bench scenes help'
without_sources taut scenes | grep -q '^tshirt-wind-10 ' || fail "taut scenes does not list them"
cp "$folder/usr/share/taut/scenes/pinned-9x9-5.toml" "$folder/usr/share/taut/scenes/installed-alone.toml"
without_sources taut scenes | grep -q '^installed-alone ' || fail "the scenes are others than those installed"
rm "$folder/usr/share/taut/scenes/installed-alone.toml"
without_sources taut figures --only fig1 >log.txt
without_sources taut render tshirt-wind-10 --frames 0:0 --resolution 64,64 >log.txt
without_sources taut render pinned-9x9-5 --frames 0:0 --resolution 64,64 >log.txt
without_sources taut simulate pinned-9x9-5 --frames 2 --stats run.jsonl >log.txt
without_sources taut inspect "$folder/usr/share/taut/garments/tshirt_1028.obj" | grep -q 'triangles *1028' ||
  fail "taut inspect reads no garment"
for file in figures/fig1.png figures/fig1.pdf tshirt-wind-10.png pinned-9x9-5.png run.jsonl; do
  [ -s $file ] || fail "there is no $file"
done

page=$folder/usr/share/man/man1/taut.1
for command in $commands; do
  grep -qx ".SS taut $command" "$page" || fail "the manual page lacks taut $command"
done
grep -q '^\.B \\-\\-supersampling NUMBER$' "$page" || fail "the manual page lacks options"
grep -qx '\.I Picture:' "$page" || fail "the manual page lacks the groups of options"
[ -s "$folder/usr/share/doc/taut/LICENSE" ] || fail "there is no licence"

# A stand-in for what bash has in an interactive shell alone.
compopt() { :; }
. "$folder/usr/share/bash-completion/completions/taut"
# completes WORD... WANTED: the last word of the command line becomes each of the WANTED, a list.
completes() {
  local wanted=${*: -1} choice
  COMP_WORDS=("${@:1:$#-1}")
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  _taut
  for choice in $wanted; do
    [[ " ${COMPREPLY[*]} " == *" $choice "* ]] || fail "'${COMP_WORDS[*]}' becomes '${COMPREPLY[*]}', without $choice"
  done
}
completes taut '' "$commands --help --help-all --version"
completes taut rend render
completes taut render tshirt-w 'tshirt-wind-1 tshirt-wind-10'
completes taut render tshirt-gravity --s '--set --stats --stretch --samples --supersampling'
completes taut render tshirt-gravity --set wind. 'wind.speed= wind.direction='
completes taut render tshirt-gravity --fabric '' 'denim jersey silk'
completes taut render tshirt-gravity --backend '' 'auto osmesa egl'
completes taut figures --only '' 'fig1 fig7'
completes taut help '' "$commands scene stats"
completes taut help st stats
# What the completions of other shells ask for.
share=$folder/usr/share
becomes=$(bash -c 'source "$0"; _taut_choices "$@"' "$share/bash-completion/completions/taut" 2 taut render tshirt-wi 2>/dev/null | xargs)
[ "$becomes" = 'tshirt-wind-1 tshirt-wind-10' ] || fail "in other shells 'taut render tshirt-wi' becomes '$becomes'"
for file in zsh/vendor-completions/_taut fish/vendor_completions.d/taut.fish applications/taut.desktop \
  thumbnailers/taut.thumbnailer icons/hicolor/scalable/apps/taut.svg; do
  [ -s "$share/$file" ] || fail "there is no share/$file"
done
