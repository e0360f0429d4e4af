#!/bin/sh
# Tests tools/setup.sh with stand-ins for dpkg-query, apt-get and id: nothing is installed.
# usage: test_setup.sh [PATH_OF_SETUP]
set -u
unset REFERENCE
setup=$(realpath "${1:-$(dirname "$0")/../../tools/setup.sh}")
directory=$(mktemp -d)
trap 'rm -rf "$directory"' EXIT
trap 'exit 1' INT TERM HUP
passed=0
failed=0

# stand_in NAME BODY: makes a command that PATH finds before the real one.
stand_in() {
    printf '#!/bin/sh\n%s\n' "$2" >"$directory/bin/$1"
    chmod +x "$directory/bin/$1"
}

begin() {
    rm -rf "$directory/bin" "$directory/calls"
    mkdir "$directory/bin"
    : >"$directory/calls"
    stand_in apt-get 'echo "apt-get $* [$DEBIAN_FRONTEND]" >>'"$directory/calls"
    stand_in dpkg-query 'for last; do :; done
case " $MISSING " in *" $last "*) echo "no package $last" >&2; exit 1 ;; esac
echo installed'
    stand_in id 'echo "$USER_ID"'
}

# run MISSING USER_ID ARGUMENT...: sets status, out and error.
run() {
    missing=$1
    user=$2
    shift 2
    MISSING=$missing USER_ID=$user PATH="$directory/bin:$PATH" sh "$setup" "$@" >"$directory/out" \
        2>"$directory/error"
    status=$?
}

# check WHAT CONDITION...
check() {
    what=$1
    shift
    if "$@"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $what" >&2
        sed 's/^/    /' "$directory/out" "$directory/error" "$directory/calls" >&2
    fi
}

begin
run "" 1000
check "all there: success" [ "$status" = 0 ]
check "all there: nothing is called" [ ! -s "$directory/calls" ]

begin
run "libpng-dev libstb-dev" 1000
check "no root: status 1" [ "$status" = 1 ]
check "no root: the packages, and no others" grep -q -- \
    "--no-install-recommends libpng-dev libstb-dev\$" "$directory/error"
check "no root: one line" [ "$(wc -l <"$directory/error")" = 1 ]
check "no root: nothing is called" [ ! -s "$directory/calls" ]

begin
run "libpng-dev libstb-dev" 0
check "root: success" [ "$status" = 0 ]
check "root: update, then install" [ "$(sed 's/.* \(update\|install\).*/\1/' \
    "$directory/calls" | tr '\n' ' ')" = "update install " ]
check "root: what is missing is installed" grep -q \
    "install libpng-dev libstb-dev \[noninteractive\]" "$directory/calls"
check "root: waits for the lock" [ "$(grep -c 'DPkg::Lock::Timeout=900' "$directory/calls")" = 2 ]
check "root: no recommendations" grep -q -- "--no-install-recommends install" "$directory/calls"

begin
run "libassimp-dev clang libosmesa6 libsdl2-dev" 0 --demo
check "demo: success" [ "$status" = 0 ]
check "demo: only what it needs" grep -q "install libassimp-dev libosmesa6 \[" "$directory/calls"

begin
run "clang" 0 --demos
check "unknown argument: status 1" [ "$status" = 1 ]
check "unknown argument: named" grep -q -e "--demos" "$directory/error"
check "unknown argument: nothing is called" [ ! -s "$directory/calls" ]

begin
export REFERENCE=egl
run "libpng-dev libosmesa6" 0
unset REFERENCE
check "EGL: success" [ "$status" = 0 ]
check "EGL: OSMesa is not installed" grep -q "install libpng-dev \[" "$directory/calls"

begin
stand_in apt-get 'echo "the archive burns"; exit 100'
run "libpng-dev" 0
check "apt fails: status 1" [ "$status" = 1 ]
check "apt fails: its words are shown" grep -q "the archive burns" "$directory/error"

begin
here=$setup
setup=$(dirname "$here")/setup-mpi.sh
run "mpich" 0
setup=$here
check "MPI: success" [ "$status" = 0 ]
check "MPI: both engines, of which one is missing" grep -q "install mpich \[" "$directory/calls"

# Not Debian: a PATH that has neither tool.
begin
rm "$directory/bin/dpkg-query" "$directory/bin/apt-get"
for tool in sh echo dirname head mktemp rm cat; do
    ln -s "$(command -v $tool)" "$directory/bin/$tool" 2>/dev/null
done
PATH="$directory/bin" "$directory/bin/sh" "$setup" >"$directory/out" 2>"$directory/error"
status=$?
check "no Debian: status 1" [ "$status" = 1 ]
check "no Debian: says so, with the packages" grep -q "no Debian.*libosmesa6" \
    "$directory/error"

echo "setup: $passed passed, $failed failed"
[ "$failed" = 0 ]
