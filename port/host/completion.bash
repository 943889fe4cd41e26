# SPDX-License-Identifier: MIT
# Completion for bash: source this file. Words come from the program's own help, so that they are always its own.

_glint() {
    local program=${COMP_WORDS[0]} word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}
    local command=${COMP_WORDS[1]} words value
    if [ "$COMP_CWORD" -eq 1 ]; then
        words="$("$program" help | sed -n 's/^glint \([a-z]*\) [A-Z[].*/\1/p') --version"
    elif [[ $word == -* ]]; then
        words=$("$program" "$command" --help | sed -n 's/^  \(--*[a-z-]*\) .*/\1/p')
    else
        # an option's value: one of few, as in infinite|local, or a FILE
        value=$("$program" "$command" --help | sed -n "s/^  $before  *\([a-z0-9|]*|[a-z0-9|]*\) .*/\1/p; s/^  $before  *\(FILE\) .*/\1/p")
        if [ "$value" = FILE ]; then
            words=$(compgen -f -- "$word")
        elif [ -n "$value" ]; then
            words=${value//|/ }
        elif [ "$command" = scene ]; then
            words=$("$program" scene --list | sed -n 's/^\([a-z-]*\) (.*/\1/p; s/^  \([a-z:-]*\) .*/\1/p')
        elif [ "$command" = help ]; then
            words=$("$program" help | sed -n 's/^glint \([a-z-]*\) .*/\1/p')
        else
            words=$(compgen -f -- "$word"; "$program" help | sed -n 's/^  \([a-z-]*[:[]\).*/\1/p' | tr -d '[')
        fi
    fi
    # shellcheck disable=SC2207 # words without blanks
    COMPREPLY=($(compgen -W "$words" -- "$word"))
}
complete -o filenames -F _glint glint
