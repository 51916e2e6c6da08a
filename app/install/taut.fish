# Completion for fish: the choices of bash's, beside names of files.
set -g __taut_bash (status dirname)/../../bash-completion/completions/taut
function __taut_choices
    set -l words (commandline -opc) (commandline -ct)
    bash -c 'source "$0"; _taut_choices "$@"' $__taut_bash (math (count $words) - 1) $words 2>/dev/null
end
complete -c taut -a '(__taut_choices)'
