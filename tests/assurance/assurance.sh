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
# Records that no claim names are not committed.
# The last line says how many claims have figures. Exit status 1 if a command failed or was left
# without figures.
set -u
here=$(dirname "$0")
usage() { sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$0"; }
case "${1:-}" in
-h | --help) usage; exit 0 ;;
"" | -*) usage >&2; exit 2 ;;
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

# keys: prints the keys of the claims' records, once each: "make blits", "test/NAME" for a step.
keys() { sed -n -e 's/^run: test \/ /test\//p' -e 's/^run: /make /p' "$claims" | awk '!seen[$0]++'; }

# left: prints the commands of which a record of this text of the library is missing. `make test`
# runs the steps.
left() {
    newest >"$work/newest"
    keys | awk -F '\t' -v text="$text" '
        FILENAME == ARGV[1] { if ($5 == text && $6 == "held") done[$1] = 1; next }
        !($0 in done) { sub(/^test\/.*/, "make test"); if (!seen[$0]++) print }' "$work/newest" -
}

# steps: prints the names of the steps of `make test`, which are fewer than those of `make whole`.
steps() {
    env -u MAKEFLAGS -u MAKEOVERRIDES -u WHOLE make -n --no-print-directory test-steps BUILD=build |
        tr '\n' ' ' | grep -o "'[^']*'" | sed -n "s/^'\([^=]*\)=.*/\1/p"
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
    sed -n -e 's/^run: \([a-z-]*\).*/\1/p' "$claims" | sort -u >"$work/keys"
    # Not every folder has a makefile.
    cat Makefile tests/*.mk tests/*/*.mk tools/*/*.mk 2>/dev/null |
        sed -n 's/^\([a-z][a-z-]*\):.*## .*/\1/p' | sort -u >"$work/targets"
    for missing in $(comm -23 "$work/keys" "$work/targets"); do
        echo "FAILED: claims.txt names 'make $missing', which is no target"
        failed=$((failed + 1))
    done
    steps | sort -u >"$work/steps"
    sed -n 's/^run: test \/ //p' "$claims" | sort -u | comm -23 - "$work/steps" >"$work/without"
    while IFS= read -r step; do
        echo "FAILED: claims.txt names the step '$step', which 'make test' does not have"
        failed=$((failed + 1))
    done <"$work/without"
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

incomplete=0
case $mode in
--check) build=/nonexistent check; exit ;;
--left) left; exit ;;
--print) write "$work/made" && cat "$work/made"; exit ;;
--write) ;;
--run)
    export GN_NO_SKIP=1
    left >"$work/left"
    number=0
    while IFS= read -r typed <&3; do
        number=$((number + 1))
        echo "assurance: $number of $(grep -c '' "$work/left"): $typed" >&2
        mkdir -p "$build"
        sh -c "$typed BUILD=$build" >"$build/assurance.log" 2>&1 || {
            echo "assurance: failed: $typed" >&2
            tail -n 5 "$build/assurance.log" >&2
            incomplete=1
        }
    done 3<"$work/left"
    left | sed 's/^/assurance: without figures that held: /' >"$work/without"
    cat "$work/without" >&2
    [ ! -s "$work/without" ] || incomplete=1
    ;;
*) usage >&2; exit 2 ;;
esac

keys >"$work/keys"
newest >"$work/newest"
awk -F '\t' 'FILENAME == ARGV[1] { claimed[$0] = 1; next } $1 in claimed' "$work/keys" "$work/newest" >"$work/kept"
cp "$work/kept" "$records"
write VERIFICATION.md
awk -F '\t' -v incomplete=$incomplete '
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
        exit wrong > 0 || incomplete
    }' "$records" "$claims"
