#!/bin/sh
# Tests that contract-check finds what has changed: one constant in one back end, another scene, a
# damaged contract.
# usage: test_contract.sh BUILD   (from the root of the project; BUILD has contract-check)
set -u
build=$1
contract=tests/contract/contract.txt
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
passed=0
failed=0

# check WHAT STATUS PATTERN PROGRAM ARGUMENT...: the exit status, and a line of the output.
check() {
    what=$1
    expected=$2
    pattern=$3
    shift 3
    "$@" >"$work/log" 2>&1
    status=$?
    if [ $status -eq "$expected" ] && grep -q -- "$pattern" "$work/log"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $what: exit status $status"
        sed 's/^/    /' "$work/log"
    fi
}

check "the contract holds" 0 '0 differ (' "$build/contract-check" --every 20
# Machines without OSMesa, or with its run-time package alone, build everything.
check "no program is linked with OSMesa" 0 '^none' sh -c "! grep -l -e -lOSMesa $build/*.command && echo none"
check "a contract on standard input" 0 '^contract: 1 scenes, 1 classes, 1 equal, 0 differ' \
    sh -c "$build/contract-check --class ties --every 1000 - <$contract"

# A library whose portable back end stores depths of 24 bits with a constant that is 1 smaller; its
# other back ends are whole.
cp -r src "$work/src"
sed -i 's/lanes_splat(16777215\.0f)/lanes_splat(16777214.0f)/' "$work/src/fragment/depth.h"
object=$build/src/backends/portable.o
compile=$(cat "$object.command")
link=$(sed "s|$object|$work/portable.o|" "$build/contract-check.command")
if cmp -s src/fragment/depth.h "$work/src/fragment/depth.h" ||
    ! $compile -O0 -c "$work/src/backends/portable.c" -o "$work/portable.o" || ! $link -o "$work/mutant"; then
    failed=$((failed + 1))
    echo "FAILED: there is no mutant"
else
    check "a constant is wrong" 1 'class depth-state: of .* have other pixels (portable): numbers ' \
        "$work/mutant" --class depth-state --every 10 --keep "$work/kept.scene"
    check "the scene is kept" 0 '^end-scene' cat "$work/kept.scene"
    check "not for pictures without depth" 0 '0 differ' "$work/mutant" --class logic --every 1000
fi

# changed WHAT PATTERN SED-SCRIPT: a changed contract is refused.
changed() {
    sed "$3" "$contract" >"$work/contract.txt"
    check "$1" 1 "$2" "$build/contract-check" --every 1000 "$work/contract.txt"
}

first=$(grep -n '^class tiny ' "$contract" | sed 's/:.*//')
changed "another seed" 'are other scenes than the contract.s: numbers 0' 's/^seed .*/seed 5/'
changed "a changed hash" "damaged: the sums of class tiny" "$((first + 1))s/.\$/x/; $((first + 1))s/^\(.* \)\(.*\)x\$/\1\20/; $((first + 2))s/^./7/"
changed "a scene is missing" 'class tiny has [0-9]* scenes, not' "$((first + 1))d"
changed "no class tiny" 'scenes, not [0-9]' '/^class tiny/,/^class slivers/{/^class slivers/!d}'
changed "a class that the generator lacks" 'class tinier is not one of the generator' 's/^class tiny /class tinier /'
changed "another version" 'no contract of version 1' 's/^gnomon-contract 1/gnomon-contract 2/'
changed "cut off" 'ends too early' '/^end-contract/d'
check "no file" 1 'cannot read' "$build/contract-check" "$work/absent"
check "a wrong option" 2 'unknown option' "$build/contract-check" --sometimes

# The page's pictures.
pictures=tests/contract/pictures.txt
changed_pictures() {
    sed "$3" $pictures >"$work/pictures.txt"
    check "$1" 1 "$2" "$build/pictures-check" "$work/pictures.txt"
}
changed_pictures "pictures: a changed hash" '"model=triangle": another picture with the back end portable' \
    '20,$d; s/^....\(.*\) model=triangle$/abcd\1 model=triangle/'
changed_pictures "pictures: too few" 'too few pictures' '20,$d'
changed_pictures "pictures: a key that is none" '"\(.*\)": no state: "colour" is no key' '20,$d; s/model=square/colour=red/'
changed_pictures "pictures: not canonical" 'not canonical; it is ' '20,$d; s/model=square$/model=square\&fov=35/'
check "pictures: no file" 1 'cannot read' "$build/pictures-check" "$work/absent"
check "pictures: a wrong option" 2 'usage' "$build/pictures-check" --sometimes
echo "contract: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
