#!/bin/sh
# Tests tests/assurance/assurance.sh in a small project of its own: what is left to run, its exit
# status, and the steps that a claim may name.
# usage: test_assurance.sh   (from the root of the project)
set -u
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM HUP
. tests/result.sh

tree=$work/tree
mkdir -p "$tree/tests/assurance" "$tree/src" "$tree/include" "$tree/tools/guide" "$tree/build"
cp tests/assurance/assurance.sh tests/assurance/record.sh tests/assurance/verification.awk "$tree/tests/assurance"
touch "$tree/tests/assurance/no-claims.txt" "$tree/README.md" "$tree/tools/guide/guide.md"
echo 'int gn_one;' >"$tree/src/one.c"
cat >"$tree/Makefile" <<'END'
RECORD = tests/assurance/record.sh
good: ## holds
	@$(RECORD) $(BUILD)/records.txt 'make good' echo '1 passed, 0 failed'
half: ## its record holds, and then it fails
	@$(RECORD) $(BUILD)/records.txt 'make half' echo '1 passed, 0 failed'
	@false
silent: ## ends well without a record
	@true
strict: ## holds where nothing may be skipped
	@$(RECORD) $(BUILD)/records.txt 'make strict' sh -c 'echo "$$GN_NO_SKIP"; [ "$$GN_NO_SKIP" = 1 ]'
test: ## has one step
	@$(RECORD) --add $(BUILD)/records.txt test/short 1 held '1 passed, 0 failed'
	@$(RECORD) --add $(BUILD)/records.txt 'make test' 1 held '1 passed, 0 failed'
test-steps:
	@run $(if $(WHOLE),'long=true') 'short=true'
END

# claims RUN...: the project's claims, one for each command; no record is committed.
claims() {
    for run in "$@"; do
        printf 'claim: %s\nevidence: a test\nrun: %s\n' "$run" "$run"
    done >"$tree/tests/assurance/claims.txt"
    rm -f "$tree/build/records.txt"
    : >"$tree/tests/assurance/records.txt"
    : >"$tree/VERIFICATION.md"
}

assurance() { (cd "$tree" && tests/assurance/assurance.sh "$@"); }
fails() { ! "$@"; }
refuses_its_place() {
    cp "$tree/VERIFICATION.md" "$work/before"
    assurance --print >/dev/null 2>&1
    [ $? -eq 2 ] && cmp "$work/before" "$tree/VERIFICATION.md"
}
refused() { assurance build --check >"$work/check" && return 1; grep -e "$1" "$work/check"; }
in_whole() (export WHOLE=yes MAKEFLAGS=WHOLE=yes && "$@")
committed() { [ "$(cut -f 1 "$tree/tests/assurance/records.txt" | tr '\n' ',')" = "$1," ]; }
left() { [ "$(assurance build --left | tr '\n' ',')" = "$1" ]; }

claims good strict 'test / short'
result "everything is left" left 'make good,make strict,make test,'
result "every command holds" assurance build
result "nothing is left" left ''
result "the build directory comes first" refuses_its_place
result "the check" assurance build --check
(cd "$tree" && tests/assurance/record.sh --add build/records.txt 'make good SEED=3' 1 held '1 passed, 0 failed')
result "a command with other settings" assurance build --write
result "records of claims alone are committed" committed 'make good,make strict,test/short'
claims good half
result "a command that fails behind its record" fails assurance build
result "the other commands have figures" grep -q '^| good .* 1 passed' "$tree/VERIFICATION.md"
claims good silent
result "a command that records nothing" fails assurance build
claims good 'test / long'
(cd "$tree" && make -s test BUILD=build)
result "a step without a record of its own" left 'make good,make test,'
result "the table" assurance build --write
result "a step of make whole alone" in_whole refused "names the step 'long'"
claims good nothing
result "no such target" refused "names 'make nothing'"
echo "assurance: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
