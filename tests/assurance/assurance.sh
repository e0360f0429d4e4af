#!/bin/sh
# Writes VERIFICATION.md from claims.txt, which says what is claimed and which command shows it, and
# from the records of these commands (record.sh). `make assurance` first runs every command that has
# no record of the library's present text.
# usage: assurance.sh BUILD-DIRECTORY            run what is left to run, then write
#        assurance.sh BUILD-DIRECTORY --write    write from the records there are
#        assurance.sh BUILD-DIRECTORY --print    print what --write would write, and write nothing
#        assurance.sh BUILD-DIRECTORY --left     list what is left to run
#        assurance.sh BUILD-DIRECTORY --check    check that VERIFICATION.md is what the claims and
#                                                the records make, and that every command exists
# The last line says how many claims have figures. Exit status 1 if a command failed.
set -u
here=$(dirname "$0")
usage() { sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$0"; }
case "${1:-}" in
-h | --help) usage; exit 0 ;;
"") usage >&2; exit 2 ;;
esac
build=$1
mode=${2:---run}
claims=$here/claims.txt
records=$here/records.txt
text=$("$here/record.sh" --text)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# newest: prints the last record of every key, of the committed ones and of those in the build.
newest() {
    cat "$records" "$build/records.txt" 2>/dev/null |
        awk -F '\t' '{ last[$1] = $0 } END { for (key in last) print last[key] }' | LC_ALL=C sort
}

# commands: prints the commands of the claims, once each; a step is one of `make test`.
commands() { sed -n -e 's/ \/ .*//' -e 's/^run: /make /p' "$claims" | awk '!seen[$0]++'; }

# left: prints the commands that have no record of this text of the library.
left() {
    newest >"$work/newest"
    commands | awk -F '\t' -v text="$text" '
        FILENAME == ARGV[1] { if ($5 == text && $6 == "held") done[$1] = 1; next }
        !($0 in done)' "$work/newest" -
}

write() { # write FILE
    newest >"$work/newest"
    awk -v text="$text" -v records="$work/newest" -f "$here/verification.awk" "$claims" >"$1"
}

check() {
    failed=0
    write "$work/made"
    cmp -s "$work/made" VERIFICATION.md || {
        echo "FAILED: VERIFICATION.md is not what claims.txt and records.txt make: tests/assurance/assurance.sh build --write"
        failed=1
    }
    commands | cut -d ' ' -f 2 | sort -u >"$work/keys"
    sed -n 's/^\([a-z][a-z-]*\):.*## .*/\1/p' Makefile tools/packaging/packaging.mk tests/longer.mk tests/steps.mk | sort -u >"$work/targets"
    for missing in $(comm -23 "$work/keys" "$work/targets"); do
        echo "FAILED: claims.txt names 'make $missing', which is no target"
        failed=$((failed + 1))
    done
    sed -n 's/^run: test \/ //p' "$claims" | while IFS= read -r step; do
        grep -q -F "'$step=" tests/steps.mk || [ -f "tests/unit/${step#sanitized }.c" ] ||
            echo "FAILED: claims.txt names the step '$step', which 'make test' does not have"
    done >"$work/steps"
    cat "$work/steps"
    failed=$((failed + $(grep -c '' "$work/steps")))
    # Every command that the README or the guide gives as evidence has a claim.
    grep -ho '`make [a-z-]*' README.md tools/guide/*.md | cut -c 7- | sort -u >"$work/readme"
    grep -v -x -F -f "$here/no-claims.txt" "$work/readme" | comm -23 - "$work/keys" >"$work/without"
    while IFS= read -r name; do
        echo "FAILED: the README or the guide names 'make $name', which is in neither claims.txt nor no-claims.txt"
        failed=$((failed + 1))
    done <"$work/without"
    echo "assurance: $(grep -c '^claim: ' "$claims") claims, $failed failed"
    [ "$failed" -eq 0 ]
}

case $mode in
--check) build=/nonexistent check; exit ;;
--left) left; exit ;;
--print) write "$work/made" && cat "$work/made"; exit ;;
--write) ;;
--run)
    left >"$work/left"
    number=0
    while IFS= read -r typed <&3; do
        number=$((number + 1))
        echo "assurance: $number of $(grep -c '' "$work/left"): $typed" >&2
        mkdir -p "$build"
        sh -c "$typed BUILD=$build" >"$build/assurance.log" 2>&1 || {
            echo "assurance: failed: $typed" >&2
            tail -n 5 "$build/assurance.log" >&2
        }
    done 3<"$work/left"
    ;;
*) usage >&2; exit 2 ;;
esac

newest >"$work/kept"
cp "$work/kept" "$records"
write VERIFICATION.md
awk -F '\t' -v text="$text" '
    FILENAME == ARGV[1] { if ($6 != "held") failed[$1] = 1; else held[$1] = 1; next }
    /^claim: / { claims++ }
    /^run: / {
        key = "make " substr($0, 6)
        sub(/^make test \/ /, "test/", key)
        wrong += key in failed
        with += key in held
    }
    END {
        printf "assurance: %d claims, %d with figures, %d failed\n", claims, with, wrong
        exit wrong > 0
    }' "$records" "$claims"
