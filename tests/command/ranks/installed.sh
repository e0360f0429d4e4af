#!/bin/sh
# Installs the command that is built for MPI, with each engine's compiler, and runs it over ranks.
# usage: installed.sh BUILD-DIRECTORY   (from the root of the project, with the command in it)
set -u
. tests/skip.sh
. tests/result.sh
. tests/command/ranks/launch.sh
export MAKEFLAGS=
build=$1
work=$(cd "$1" && pwd)/embed/mpi
rm -rf "$work"
mkdir -p "$work"

needs_mpi() { objdump -p "$1" | grep 'NEEDED *libmpi'; }
# says EXPECTED TEXT COMMAND...: the status, and one line of gnomon's, which begins with the text.
says() {
    expected=$1
    text=$2
    shift 2
    "$@" >"$work/out" 2>&1
    status=$?
    cat "$work/out"
    [ $status = "$expected" ] && [ "$(grep -c '^gnomon' "$work/out")" = 1 ] && grep -q "$text" "$work/out"
}
version=$("$build/gnomon" --version)
find_present "$build" 'command for MPI, installed'

for engine in $present; do
    command=$work/$engine/usr/bin/gnomon
    to="BUILD=$build DESTDIR=$work/$engine PREFIX=/usr"
    result "$engine, installed" make -s install-command MPI=yes MPICC="mpicc.$engine" $to
    result "$engine, is linked with it" needs_mpi "$command"
    result "$engine, alone" says 0 "^$version" "$command" --version
    result "$engine, three ranks say it once" says 0 "^$version" over_ranks "$engine" 3 "$command" --version
    result "$engine, what cannot be divided is refused once" says 2 '^gnomon info: works in one process, and 3 were started' \
        over_ranks "$engine" 3 "$command" info README.md
    make -s uninstall MPI=yes $to
    result "$engine, uninstalled" [ -z "$(find "$work/$engine" -type f)" ]
    over_ranks "$engine" 2 "$build/gnomon" --version >"$work/out" 2>&1
    result "$engine, the command without MPI says why it cannot" grep 'built without MPI' "$work/out"
done

result "without MPI=yes, installed" make -s install-command BUILD="$build" DESTDIR="$work/plain" PREFIX=/usr
needs_mpi "$work/plain/usr/bin/gnomon"
result "without MPI=yes, no engine is needed" [ $? -ne 0 ]
refuses() { # refuses TEXT OPTION...
    text=$1
    shift
    ! make -s install-command "$@" BUILD="$build" DESTDIR="$work/wrong" >"$work/out" 2>&1 && grep -e "$text" "$work/out" && [ ! -e "$work/wrong" ]
}
result "another word than yes or no is refused by name" refuses 'MPI must be yes or no' MPI='yes no'
result "an absent compiler is named" refuses 'mpicc.none is missing' MPI=yes MPICC=mpicc.none
echo "command for MPI, installed: $passed passed, $failed failed"
[ "$failed" = 0 ]
