# bash completion of isogloss: the command itself tells what fits (isogloss complete --help).
_isogloss() {
  # Bash cuts words at = and :, unlike the command line that it will run.
  local words=() word before='' line
  for word in "${COMP_WORDS[@]:1:COMP_CWORD}"; do
    if [[ ${#words[@]} -gt 0 && ( $word == [=:]* || $before == [=:] ) && ( $before != = || $word != -* ) ]]; then
      words[-1]+=$word
    else
      words+=("$word")
    fi
    before=$word
  done
  local current=${words[-1]}
  # What stands before the last = or : is a word of its own to readline, which replaces only what follows it.
  local kept=''
  [[ $current == -*=* ]] && kept=${current%%=*}= && current=${current#*=}
  local head=''
  [[ $COMP_WORDBREAKS == *:* && $current == *:* ]] && head=${current%:*}:
  [[ $COMP_WORDBREAKS == *=* && $current == *=* ]] && head=${current%=*}=

  COMPREPLY=()
  while IFS= read -r line; do
    case $line in
      ':files '*)
        compopt -o filenames 2>/dev/null
        local pattern=${line#:files }
        mapfile -t -O ${#COMPREPLY[@]} COMPREPLY < <(compgen -d -- "$current"
          if [[ $pattern == '*' ]]; then compgen -f -- "$current" | while IFS= read -r word; do
            [[ -d $word ]] || printf '%s\n' "$word"; done
          else compgen -f -X "!$pattern" -- "$current"; fi)
        ;;
      :folders)
        compopt -o filenames 2>/dev/null
        mapfile -t -O ${#COMPREPLY[@]} COMPREPLY < <(compgen -d -- "$current")
        ;;
      :open) compopt -o nospace 2>/dev/null ;;
      :*) ;;
      *)
        line=${line%%$'\t'*}
        line=${line#"$head"}
        [[ $line != *' '* ]] || printf -v line %q "$line"
        COMPREPLY+=("$line")
        ;;
    esac
  done < <("$1" complete -- "${words[@]:0:${#words[@]}-1}" "$kept$current" 2>/dev/null)
}
complete -F _isogloss isogloss
