#!/bin/sh
# Proves properties of the library's C functions with Frama-C: by WP that functions hold to their
# contracts, never overflow, stay in bounds and end; by Eva that no operation of a function is
# undefined for the inputs of a driver. Both read the portable lanes in plain C99, sixteen of them.
# usage: prove_code.sh [-q] [--all] [--only FUNCTION] [--once] [--timeout SECONDS]
#                      [--jobs N] [ROOT]
#   -q          prints failures and the last line only
#   --all       also, what is wrong must be rejected (test_prove.sh, test_prove_code.sh)
#   --only F    only the function F, or the driver F of Eva
#   --once      only cvc5, 10 seconds for each goal; otherwise what it leaves is proved by z3 and cvc5
#   --timeout   seconds by the clock for each goal and prover (60)
#   --jobs N    provers at the same time (2), as long as cvc5 is alone
#   ROOT        the directory that has src/ (default: this repository)
#
# Contracts for WP are in code/contracts, a file for each source; code/splits says at which places Eva
# looks at ranges of values one by one. annotate.awk inserts them into a copy of the source; the
# script checks that nothing else differs. Comments at the start of code/wp_*.c and
# code/eva_*.c say which functions are proved:
#   @functions: NAMES   WP proves these
#   @defines: OPTIONS   the library's configuration, if it is not the default
#   @sources: FILES     Eva analyses these with the driver
#   @options: OPTIONS   more options of WP or Eva
#   @reaches: NAMES     Eva must have reached these, otherwise the driver fails
# Without --only, Gappa proves its bounds as well (prove.sh).
# The last line is "proved: N / N goals (WP n, Eva n functions reached[, Gappa n bounds, n mutants
# rejected])". A driver of Eva with an alarm is a goal that is not proved. Exit status 1 if one goal is
# not proved, one alarm is left, or one mutant is not rejected. Provers are stopped by the clock:
# --timeout must be longer on a machine with much load.
# What is not proved, and what the proofs take for granted: code/not_proved.txt.
set -u
here=$(cd "$(dirname "$0")" && pwd)
quiet=""
all=""
only=""
once=""
timeout=60
jobs=2
while [ $# -gt 0 ]; do
    case $1 in
    -q) quiet=yes ;;
    --all) all=yes ;;
    --only) only=$2 && shift ;;
    --once) once=yes ;;
    --jobs) jobs=$2 && shift ;;
    --timeout) timeout=$2 && shift ;;
    --help) sed -n '2,/^set -u/{/^set -u/!s/^# \{0,1\}//p}' "$0" && exit 0 ;;
    -*) echo "prove_code: unknown option $1; see --help" >&2 && exit 2 ;;
    *) break ;;
    esac
    shift
done
root=$(cd "${1:-$here/../..}" && pwd) || exit 2
sources=$root/src
[ -d "$sources" ] || { echo "prove_code: $root has no src/; see --help" >&2; exit 2; }
for tool in frama-c why3 z3 cvc5 gappa; do
    command -v $tool >/dev/null 2>&1 || { echo "prove_code: $tool is missing: make setup-verify" >&2; exit 1; }
done
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM
goals=0
proved=0
wp=0
functions=0

say() { [ -n "$quiet" ] || echo "$1"; }
progress() { echo "prove_code: $1" >&2; }
fail() { echo "FAILED: $1"; }

# words FILE KEY: the words that the first comment of a file lists under a key.
words() { sed -n "s|^ \* @$2: *||p" "$1" | sed 's| \*/$||' | tr '\n' ' '; }

# wanted NAME: whether the function or driver is to be proved.
wanted() { [ -z "$only" ] || [ "$only" = "$1" ]; }

# Why3 of Debian 12 does not know cvc5, which speaks the language of its predecessor.
set_up_why3() {
    printf 'prelude "(set-logic ALL)"\nimport "/usr/share/why3/drivers/cvc4_16.gen"\n' >"$work/cvc5.drv"
    cat >"$work/why3.conf" <<END
[main]
magic = 14
memlimit = 2000
running_provers_max = 2
timelimit = 10

[partial_prover]
name = "Z3"
path = "z3"
version = "4.8.12"

[prover]
name = "CVC5"
command = "cvc5 --stats --tlimit=%t000 --lang=smt2 %f"
command_steps = "cvc5 --stats --rlimit=%S --lang=smt2 %f"
driver = "$work/cvc5.drv"
version = "1.0.3"
shortcut = "cvc5"
END
    export WHY3CONFIG="$work/why3.conf"
}

# annotate FROM TO: copies the sources to $work/TO and inserts the annotations of code/FROM.
annotate() {
    cp -r "$sources" "$work/$2" || exit 1
    (cd "$here/code/$1" && find . -name '*.acsl') | sed 's|^\./||' | sort >"$work/list"
    while read -r annotations; do
        source=${annotations%.acsl}
        awk -f "$here/code/annotate.awk" "$here/code/$1/$annotations" "$sources/$source" \
            >"$work/$2/$source" || { fail "annotations of $source do not fit it"; exit 1; }
        ! diff "$sources/$source" "$work/$2/$source" | grep -q '^<' ||
            { fail "annotations changed $source"; exit 1; }
    done <"$work/list"
}

# analyse SOURCES ARGUMENT...: spans Frama-C over the lanes in plain C99.
analyse() {
    directory=$1
    shift
    frama-c -machdep x86_64 -cpp-extra-args="-I$here/../../include -I$directory -I$here/code \
-U__GNUC__ -U__SSE2__ -DGN_ONLY_PORTABLE -DGN_NO_VECTORS $defines" "$@"
}

# Counts one goal, proved if the second argument is 0.
count_goal() {
    goals=$((goals + 1))
    if [ "$2" -eq 0 ]; then
        proved=$((proved + 1))
        say "proved: $1"
    else
        fail "$1"
    fi
}

prove_axioms() {
    answers=$(z3 "$here/code/axioms.smt2" | sort -u)
    [ "$answers" = unsat ]
    count_goal "the axioms of machine arithmetic hold for all numbers of 64 bits" $?
}

# run_wp FILE FUNCTIONS PROVERS SECONDS JOBS: spans WP once, and sets `of` and `held` to the numbers of
# goals and of proved ones; `of` is empty if WP ended without them.
run_wp() {
    # The functions called through pointers are those that `calls` names.
    analyse "$work/wp" "$1" -wp -wp-rte -rte-no-pointer-call -warn-special-float none -wp-prover "$3" -wp-timeout "$4" $(words "$1" options) \
        -wp-par $5 -wp-cache none -wp-fct "$(echo $2 | tr ' ' ',')" >"$work/log" 2>&1
    figures=$(sed -n 's|^\[wp\] Proved goals: *\([0-9]*\) / \([0-9]*\)$|\1 \2|p' "$work/log")
    held=${figures% *} of=${figures#* }
}

# not_proved: the names of the goals in the log that are not proved.
not_proved() {
    sed -n '/ : Valid/!s/^\[wp\] \[[^]]*\] Goal \(typed_\)\{0,1\}\(cast_\)\{0,1\}\([^ ]*\).*/\3/p' "$work/log" | sort -u
}

# prove_functions FILE FUNCTIONS: WP. cvc5 alone proves nearly all goals, in half the time that both
# provers take side by side. Both then prove the functions again that have an unproved goal.
prove_functions() {
    progress "WP: $2"
    defines=$(words "$1" defines)
    run_wp "$1" "$2" cvc5 $((timeout < 10 ? timeout : 10)) "$jobs"
    total=$of
    for function in $2; do
        grep -q "^\[rte:annot\] annotating function $function\$" "$work/log" || count_goal "WP did not find $function" 1
    done
    if [ -z "$once" ] && [ -n "$of" ] && [ "$held" -lt "$of" ]; then
        not_proved >"$work/left"
        again=""
        cp "$work/left" "$work/nameless"
        for function in $2; do
            grep -q "^${function}_" "$work/left" || continue
            again="$again $function"
            sed -i "/^${function}_/d" "$work/nameless"
        done
        # All functions, if an unproved goal is not listed or has no function's name.
        [ "$(wc -l <"$work/left")" -eq $((of - held)) ] && [ ! -s "$work/nameless" ] || again=" $2"
        progress "WP again:$again"
        run_wp "$1" "${again# }" z3,cvc5 "$timeout" 2
    fi
    if [ -z "$of" ]; then
        count_goal "WP on $1 ended without figures" 1
        tail -15 "$work/log" | sed 's/^/    /'
        return
    fi
    held=$((total - of + held))
    goals=$((goals + total))
    proved=$((proved + held))
    wp=$((wp + held))
    not_proved | sed 's/^/FAILED: /'
    say "proved: $held of $total goals of $2"
}

# prove_driver FILE: Eva.
prove_driver() {
    progress "Eva: $(basename "$1" .c)"
    defines=$(words "$1" defines)
    files=$(words "$1" sources)
    analyse "$work/eva" "$1" $(printf "$work/eva/%s " $files | sed "s|$work/eva/ ||") -eva -eva-precision 6 \
        -eva-split-return auto -eva-equality-through-calls formals -warn-special-float none \
        $(words "$1" options) >"$work/log" 2>&1
    for function in $(words "$1" reaches); do
        grep -q "Values at end of function $function:" "$work/log"
        reached=$?
        count_goal "Eva: $function is reached" "$reached"
        functions=$((functions + 1 - (reached > 0)))
    done
    grep -q '^  0 alarms generated by the analysis' "$work/log" &&
        grep -q 'No errors or warnings raised' "$work/log" &&
        ! grep -q '^    \(Assertions\|Preconditions\) .* [1-9][0-9]* \(unknown\|invalid\)' "$work/log"
    clean=$?
    count_goal "Eva: no alarm in all that $(basename "$1" .c) calls" $clean
    [ $clean -eq 0 ] || grep -A 3 'eva:alarm\|User Error\|alarms\{0,1\} generated' "$work/log" | sed 's/^/    /'
}

set_up_why3
annotate contracts wp
annotate splits eva
[ -n "$only" ] || prove_axioms
for file in "$here"/code/wp_*.c; do
    list=""
    for function in $(words "$file" functions); do
        ! wanted "$function" || list="$list $function"
    done
    [ -z "$list" ] || prove_functions "$file" "${list# }"
done
for file in "$here"/code/eva_*.c; do
    ! wanted "$(basename "$file" .c)" || prove_driver "$file"
done
bounds=""
if [ -z "$only" ]; then
    progress "Gappa"
    "$here/prove.sh" -q "$root" >"$work/log"
    count=$(sed -n 's/^\([0-9]*\) bounds proved.*/\1/p' "$work/log")
    failures=$(sed -n 's/.* bounds proved, \([0-9]*\) failed$/\1/p' "$work/log")
    grep -e '^FAILED' -e '^    ' "$work/log"
    goals=$((goals + ${count:-0} + ${failures:-1}))
    proved=$((proved + ${count:-0}))
    bounds=", Gappa ${count:-0} bounds"
fi
if [ -n "$all" ]; then
    mutants=0
    for test in test_prove.sh "test_prove_code.sh --jobs $jobs"; do
        progress "$test"
        "$here"/$test >"$work/log" || goals=$((goals + 1))
        grep -e '^FAILED' -e '^    ' "$work/log"
        mutants=$((mutants + $(sed -n 's/.*: \([0-9]*\) rejected, [0-9]* not$/\1/p' "$work/log")))
    done
    bounds="$bounds, $mutants mutants rejected"
fi
[ "$goals" -gt 0 ] || echo "prove_code: no function or driver was proved${only:+: $only is not there, or left out}" >&2
echo "proved: $proved / $goals goals (WP $wp, Eva $functions functions reached$bounds)"
[ "$goals" -gt 0 ] && [ "$proved" -eq "$goals" ]
