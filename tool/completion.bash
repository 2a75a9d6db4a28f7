# Completion of symreal for bash: subcommands, and the options that --help lists.
_symreal() {
  local current=${COMP_WORDS[COMP_CWORD]} tool=${COMP_WORDS[0]}
  if [ "$COMP_CWORD" -eq 1 ] || { [ "$COMP_CWORD" -eq 2 ] && [ "${COMP_WORDS[1]}" = help ]; }; then
    mapfile -t COMPREPLY < <(compgen -W "help $("$tool" help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z][a-z-]*\) .*/\1/p')" -- "$current")
  elif [[ $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$("$tool" "${COMP_WORDS[1]}" --help | sed -n 's/^ *\(-.,\)\{0,1\}\(--\{0,1\}[a-z][a-z-]*\).*/\2/p')" -- "$current")
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$current")
  fi
}
complete -o filenames -F _symreal symreal
