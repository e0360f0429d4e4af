#!/bin/sh
# Proves bounds on rounding errors with Gappa (https://gappa.gitlabpages.inria.fr) from the text of
# the C sources, by the templates beside this script.
# usage: prove.sh [-q] [ROOT [TEMPLATE.proof ...]]
# ROOT is the directory that has src/ (default: this repository). Each goal is one span of Gappa, or
# one span for every case of @case. A goal counts as proved if Gappa succeeds without a warning in
# all spans; and the hypotheses must not prove a false statement. Prints one line per goal (-q: only
# failures), ends with "N bounds proved, N failed". Exit status 1 if one failed.
#
# A template is a script for Gappa with lines
#   @kernel FILE NAME ROUNDING   the kernel's statements (extract.awk)
#   @assume HYPOTHESIS           a hypothesis of all goals
#   @case NAME=VALUE ...         definitions, one line for each case to be proved; they are
#   @define                      inserted here
#   @goal NAME: PROPOSITION      a goal
#   @hint EXPRESSION             a rewriting, which Gappa checks to be an identity
# and definitions, which are copied.
set -u
here=$(dirname "$0")
quiet=""
if [ "${1:-}" = -q ]; then
    quiet=yes
    shift
fi
root=${1:-$here/../..}
[ -d "$root/src" ] || { echo "prove: $root has no src/" >&2; exit 2; }
[ $# -gt 0 ] && shift
[ $# -gt 0 ] || set -- "$here"/*.proof
directory=$(mktemp -d)
trap 'rm -rf "$directory"' EXIT
trap 'exit 1' INT TERM HUP
proved=0
failed=0

command -v gappa >/dev/null 2>&1 || { echo "prove: gappa is missing: make setup" >&2; exit 1; }

# part LETTERS: prints the arguments of the template's lines of this kind.
part() { sed -n "s/^@$1 //p" "$template"; }

# definitions CASE: prints the template's definitions, with kernels and the case's definitions inserted.
definitions() {
    grep -e '^@kernel' -e '^@define' -e '^[^@#]' "$template" |
    while read -r first file name rounding; do
        if [ "$first" = @define ]; then
            printf '%s;\n' $1
        elif [ "$first" = @kernel ]; then
            awk -f "$here/extract.awk" -v kernel="$name" -v rounding="$rounding" \
                "$root/$file" || return 1
        else
            printf '%s\n' "$first $file $name $rounding"
        fi
    done
}

# gappa_proves CASE PROPOSITION: leaves the script and Gappa's output in files.
gappa_proves() {
    definitions "$1" >"$directory/script" || return 1
    {
        printf '{ '
        part assume | sed 's/$/ \/\\/' | sed '$s/ \/\\$/ ->/'
        printf '%s }\n' "$2"
        part hint | sed 's/$/;/'
    } >>"$directory/script"
    gappa "$directory/script" >"$directory/output" 2>&1 &&
        ! grep -v 'Warning: renaming identifier' "$directory/output" | grep -q .
}

# proves PROPOSITION: whether Gappa proves it in every case.
proves() {
    if [ -z "$cases" ]; then
        gappa_proves "" "$1"
        return
    fi
    printf '%s\n' "$cases" >"$directory/cases"
    while read -r case; do
        gappa_proves "$case" "$1" || return 1
    done <"$directory/cases"
}

for template; do
    cases=$(part case)
    part goal >"$directory/goals"
    if proves "0 in [1,2]"; then
        echo "FAILED: $template: the hypotheses contradict each other"
        failed=$((failed + 1))
    fi
    while IFS= read -r goal; do
        [ -t 2 ] && printf '\r%s\033[K\r' "$goal" | cut -c -100 | tr -d '\n' >&2
        if proves "${goal#*: }"; then
            proved=$((proved + 1))
            [ -n "$quiet" ] || echo "proved: $goal"
        else
            failed=$((failed + 1))
            echo "FAILED: $goal"
            sed 's/^/    /' "$directory/output"
        fi
    done <"$directory/goals"
done
echo "$proved bounds proved, $failed failed"
[ "$failed" -eq 0 ] && [ "$proved" -gt 0 ]
