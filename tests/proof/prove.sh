#!/bin/sh
# Proves bounds on rounding errors with Gappa (https://gappa.gitlabpages.inria.fr), about the
# text of the C sources: see the templates beside this script.
# usage: prove.sh [-q] [SOURCES [TEMPLATE.proof ...]]
# SOURCES is the directory of src/ (default: this repository's). Each goal is one run of Gappa,
# or one for every case of @case. It counts as proved where Gappa succeeds without a warning
# in all of them; the hypotheses must not prove what is false too. Prints a line a goal (-q:
# only of failures), ends with "N bounds proved, N failed". Exit status 1 where one failed.
#
# A template is a script of Gappa's with lines
#   @kernel FILE NAME ROUNDING   the kernel's statements (extract.awk)
#   @assume HYPOTHESIS           a hypothesis of all goals
#   @case NAME=VALUE ...         definitions, one line for each case to be proved; they stand
#   @define                      here
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
sources=${1:-$here/../..}
[ $# -gt 0 ] && shift
[ $# -gt 0 ] || set -- "$here"/*.proof
directory=$(mktemp -d)
trap 'rm -rf "$directory"' EXIT
proved=0
failed=0

command -v gappa >/dev/null 2>&1 || { echo "prove: gappa is missing: make setup" >&2; exit 1; }

# part LETTERS: the arguments of the template's lines of that kind.
part() { sed -n "s/^@$1 //p" "$template"; }

# definitions CASE: the template's, with kernels and the case's definitions in their places.
definitions() {
    grep -e '^@kernel' -e '^@define' -e '^[^@#]' "$template" |
    while read -r first file name rounding; do
        if [ "$first" = @define ]; then
            printf '%s;\n' $1
        elif [ "$first" = @kernel ]; then
            awk -f "$here/extract.awk" -v kernel="$name" -v rounding="$rounding" \
                "$sources/$file" || return 1
        else
            printf '%s\n' "$first $file $name $rounding"
        fi
    done
}

# gappa_proves CASE PROPOSITION: leaves the script and what Gappa said.
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

# proves PROPOSITION: in every case.
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
