#!/bin/sh
# Tests `make report` with a few scenes of two classes: the page is well-formed and needs no other
# file; its counts are those of build/parity, its errors those of build/accuracy, its claims those of
# the records; a pixel that is changed on purpose is found; nothing is written if something is
# missing.
# usage: test_report.sh BUILD-DIRECTORY   (from the root of the project)
set -u
. tests/skip.sh
. tests/result.sh
build=$1
seed=7 scenes=9
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
if ! command -v python3 >/dev/null; then
    skip "report: needs python3: 'make setup' installs it"
    echo "0 passed, $failed failed"
    exit "$failed"
fi

# A build directory with records of its own, which nothing else changes: one record is stale, one
# failed.
mkdir "$work/build" "$work/build/web"
for program in report-pictures accuracy texture-accuracy bench-states; do
    ln -s "$(realpath "$build")/$program" "$work/build/$program"
done
text=$(tests/assurance/record.sh --text)
{
    printf 'make blits\t2026-02-03\t5\ta machine, 3 processors\t000000000000\theld\tblits: 1234 | made up for this test\n'
    printf 'make texels\t2026-02-04\t5\ta machine, 3 processors\t%s\tFAILED\ttexels: 5 differ\n' "$text"
} >"$work/build/records.txt"

report() { # report OPTION...
    tools/report/report.py "$work/build" --seed $seed --scenes $scenes --shown 2 --inputs 300 --lookups 30 \
        --class blend --class samples "$@"
}
check() { # check PAGE WHAT...
    python3 tests/report/check_page.py "$@"
}
page=$work/build/report.html

result "a page is written" sh -c '"$@" >"$0" 2>"$0.errors"' "$work/line" tools/report/report.py "$work/build" --seed $seed \
    --scenes $scenes --shown 2 --inputs 300 --lookups 30 --class blend --class samples
result "the closing line" grep -qx "report: 2 classes, 18 scenes, 4 shown, 0 pixels differ, 0\.[0-9] MB: $page" "$work/line"
result "the page is copied beside the web page" cmp "$page" "$work/build/web/report.html"
result "the page is well-formed and stands alone" check "$page" form
result "no address of a network" sh -c '! grep -oE "https?://.{20}" "$0"' "$page"
result "the seed is on the page" grep -q "<dt>seed</dt><dd><code>$seed</code></dd>" "$page"

# class scenes primitives pixels drawn differ
for class in blend samples; do
    "$build/parity" --class $class --scenes $scenes --seed $seed --keep "$work/failure" |
        awk -v class=$class '$1 == class { print $1, $2, $3, $4, $5, $6 + $7 }'
done >"$work/parity"
check "$page" classes >"$work/classes"
result "parity has counted both classes" test "$(grep -c '' "$work/parity")" -eq 2
result "the counts are those of build/parity" diff "$work/parity" "$work/classes"

"$build/accuracy" --seed $seed --inputs 300 | sed -n '/^error in/,$p' | sed -e '1d;$d' -e 's/  closer: .*//' | tr -d ' ' >"$work/accuracy"
check "$page" accuracy >"$work/errors"
result "the errors are those of build/accuracy" diff "$work/accuracy" "$work/errors"
result "there are errors" test "$(grep -c '' "$work/errors")" -ge 80
result "the claims are those of the records" check "$page" claims tests/assurance/claims.txt "$text" tests/assurance/records.txt \
    "$work/build/records.txt"
result "a stale figure has a star" grep -q 'blits: 1234 | made up for this test</td>.*2026-02-03 [A-Z]\*' "$page"
result "a failure is marked" grep -q '<strong>FAILED</strong>: texels: 5 differ' "$page"

check "$page" pictures >"$work/pictures"
result "four pictures, both sides equal, differences black" awk '$3 != 0 || $4 != 0 { exit 1 } END { exit NR != 4 }' "$work/pictures"
result "without results of states the command is named" grep -q '<code>make bench-states</code>' "$page"

"$build/bench-states" --frames 1 --row "stencil increment, sphere" --json "$work/states.json" >"$work/printed" 2>&1
result "a page with speeds" report --states "$work/states.json" --output "$work/speeds.html"
result "the page with speeds is well-formed" check "$work/speeds.html" form
result "the picture of states is there" grep -q '<title>Every state beside llvmpipe</title>' "$work/speeds.html"

# One pixel of ours is changed.
report --break --output "$work/broken.html" >"$work/line" 2>"$work/printed"
status=$?
result "a changed pixel: exit status 1" test $status -eq 1
result "a changed pixel: the closing line" grep -q ', 1 pixel differs, ' "$work/line"
check "$work/broken.html" classes >"$work/classes"
result "a changed pixel: counted in its class" grep -q '^blend .* 1$' "$work/classes"
result "a changed pixel: not in the other" grep -q '^samples .* 0$' "$work/classes"
check "$work/broken.html" pictures >"$work/pictures"
result "a changed pixel: seen in its picture alone" \
    awk '$4 == 1 && $1 " " $2 == "blend 0" { ++seen } { sum += $4 } END { exit seen != 1 || sum != 1 }' "$work/pictures"

# What is missing.
result "without the reference: exit status 1" sh -c '! REFERENCE=none "$@" >"$0" 2>&1' "$work/printed" tools/report/report.py \
    "$work/build" --scenes 1 --class blend --output "$work/none.html"
result "without the reference: one line says so" sh -c 'test "$(grep -c "" "$0")" -eq 1 && grep -q "the reference is missing" "$0"' "$work/printed"
report --output "$work/nowhere/report.html" >"$work/printed" 2>&1
result "a directory that is not there" grep -q "nowhere/report.html cannot be written" "$work/printed"
report --states "$work/absent.json" --output "$work/none.html" >"$work/printed" 2>&1
result "results of states that are not there" grep -q "absent.json is missing" "$work/printed"
result "then nothing is written" test ! -e "$work/none.html"
report --class nothing --output "$work/none.html" >"$work/printed" 2>&1
result "a wrong class: exit status 2" test $? -eq 2
result "no partial file is left" sh -c '! find "$0" -name "*.partial" | grep .' "$work"

# What a page must not have.
for change in 's|src="data:image/png[^"]*"|src="picture.png"|' 's|</main>||' 's|<caption>[^<]*</caption>||' \
    's|<p>|<p><script>1</script>|' 's|href="#claims"|href="#lost"|' 's|alt="[^"]*"||' 's|</style>|a{background:url(a.png)}</style>|'; do
    sed "$change" "$page" >"$work/changed.html"
    result "found in a changed page: $change" sh -c '! python3 tests/report/check_page.py "$0" form' "$work/changed.html"
done

echo "report: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
