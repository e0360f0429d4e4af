#!/bin/sh
# Installs the command that is built for MPI, with each engine's compiler, and runs it over ranks.
# usage: installed.sh BUILD-DIRECTORY   (from the root of the project, with the command in it)
set -eu
. tests/skip.sh
. tests/result.sh
. tests/command/ranks/launch.sh
export MAKEFLAGS=
build=$1
work=$(cd "$1" && pwd)/embed/mpi
rm -rf "$work"
mkdir -p "$work"

# is_linked COMMAND: whether the command needs a library of MPI.
is_linked() { objdump -p "$1" | grep -q 'NEEDED *libmpi'; }
# says EXPECTED TEXT COMMAND...: the status and one line with the text.
says() {
    expected=$1
    text=$2
    shift 2
    "$@" >"$work/out" 2>&1 && status=0 || status=$?
    cat "$work/out"
    [ "$status" = "$expected" ] && [ "$(grep -c '^gnomon' "$work/out")" = 1 ] && grep -q "^$text" "$work/out"
}
version=$("$build/gnomon" --version)

for engine in $engines; do
    if ! has_engine "$engine" || ! command -v "mpicc.$engine" >/dev/null; then
        skip "command for MPI, installed: $engine is absent: 'make setup-mpi' installs it"
        continue
    fi
    command=$work/$engine/usr/bin/gnomon
    result "$engine, installed" make -s install-command MPI=yes MPICC="mpicc.$engine" BUILD="$build" \
        DESTDIR="$work/$engine" PREFIX=/usr
    result "$engine, is linked with it" is_linked "$command"
    result "$engine, man page and completions" [ "$(find "$work/$engine" -type f | wc -l)" = 4 ]
    result "$engine, alone" says 0 "$version" "$command" --version
    result "$engine, three ranks say it once" says 0 "$version" over_ranks "$engine" 3 "$command" --version
    result "$engine, what cannot be divided is refused once" says 2 'gnomon info: works in one process, and 3 were started' \
        over_ranks "$engine" 3 "$command" info README.md
    result "$engine, uninstalled" make -s uninstall MPI=yes BUILD="$build" DESTDIR="$work/$engine" PREFIX=/usr
    result "$engine, nothing is left" [ -z "$(find "$work/$engine" -type f)" ]
    result "$engine, the command without MPI says why it cannot" sh -c \
        ". tests/command/ranks/launch.sh; over_ranks $engine 2 '$build/gnomon' --version 2>&1 | grep -q 'built without MPI'"
done

result "without MPI=yes, installed" make -s install-command BUILD="$build" DESTDIR="$work/plain" PREFIX=/usr
result "without MPI=yes, no engine is needed" sh -c "! objdump -p '$work/plain/usr/bin/gnomon' | grep 'NEEDED *libmpi'"
for wrong in 1 'yes no' ''; do
    result "MPI='$wrong' is refused by name" sh -c "! make -s install-command MPI='$wrong' BUILD='$build' DESTDIR='$work/wrong' 2>&1 |
        grep -v '^make' >'$work/refusal'; grep -q 'MPI must be yes or no' '$work/refusal'"
done
result "an absent compiler is named" sh -c "make -s install-command MPI=yes MPICC=mpicc.none BUILD='$build' DESTDIR='$work/wrong' 2>&1 |
    grep -q 'mpicc.none is missing'"
result "nothing was written" [ ! -e "$work/wrong" ]
echo "command for MPI, installed: $passed passed, $failed failed"
[ "$failed" = 0 ]
