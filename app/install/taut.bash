# Completion for bash, and through _taut_choices for zsh and fish. What there is to choose from is asked of the program
# itself, which alone knows.
_taut() {
  local program=${COMP_WORDS[0]} command=${COMP_WORDS[1]}
  local previous=${COMP_WORDS[COMP_CWORD - 1]} word=${COMP_WORDS[COMP_CWORD]}
  local choices help commands
  commands='/^Subcommands:/,/^$/s/^  \([a-z][a-z-]*\) .*/\1/p'
  if ((COMP_CWORD == 1)); then
    choices="--help --help-all --version $("$program" --help | sed -n "$commands")"
  elif [[ $command == help ]]; then
    choices="scene stats $("$program" --help | sed -n "$commands")"
  elif [[ $previous == --set ]]; then
    choices=$("$program" help scene | sed -n 's/^  \([a-z_.]*\) = .*/\1=/p')
    compopt -o nospace
  elif [[ $previous == --fabric ]]; then
    choices=$("$program" fabrics | sed -n '3,$s/ .*//p')
  else
    help=$(COLUMNS=999 "$program" "$command" --help-all)
    choices=$(sed -n "s/^  $previous {\([^}]*\)}.*/\1/p" <<<"$help" | tr , ' ')
    if [[ -z $choices && $word == -* ]]; then
      choices=$(sed -n 's/^  \(-[a-z],\)\{0,1\}\(--[a-z-]*\).*/\2/p' <<<"$help")
    elif [[ -z $choices && $previous != --* ]] && grep -q '^  SCENE' <<<"$help"; then
      choices=$("$program" scenes | sed 's/ .*//')
    fi
  fi
  mapfile -t COMPREPLY < <(compgen -W "$choices" -- "$word")
}
complete -o default -F _taut taut  # default: names of files where nothing else fits

# _taut_choices INDEX WORD...: prints what the word of that index, from 0, may become.
_taut_choices() {
  COMP_CWORD=$1 COMP_WORDS=("${@:2}")
  _taut
  printf '%s\n' "${COMPREPLY[@]}"
}
