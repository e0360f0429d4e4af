#!/bin/sh
# Installs the Python package as a user does, with pip into an environment over Debian's packages and
# without downloads, and runs its tests and the check of its types.
# usage: python.sh BUILD-DIRECTORY   (from the root of the project; `make python-parts` has run)
set -u
. tests/skip.sh
python=${PYTHON:-/usr/bin/python3}
environment=$1/python/environment
passed=0
failed=0

needed='import cffi, numpy, setuptools, wheel, pytest, hypothesis, venv, pip, PIL'
if ! "$python" -c "$needed" 2>/dev/null; then
    skip "Python: needs python3-cffi, -numpy, -setuptools, -pytest, -hypothesis, -venv, -pip and -pil: 'make setup' installs them"
    echo "0 passed, $failed failed"
    exit "$failed"
fi

run() { # run NAME COMMAND...: passes if the command does
    name=$1
    shift
    if "$@" >"$log" 2>&1; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $name"
        tail -n 30 "$log"
    fi
}

mkdir -p "$1/python"
log=$1/python/log.txt
GNOMON_BUILD=$(cd "$1" && pwd) || exit 2
export GNOMON_BUILD
[ -x "$environment/bin/python" ] || "$python" -m venv --system-site-packages "$environment" || exit 1
run "pip install" "$environment/bin/pip" install --quiet --no-build-isolation --no-index --force-reinstall --no-deps ./tools/python
rm -f tools/python/build/libgnomon.so
run "make python" env MAKEFLAGS= make -s python BUILD="$1" PYTHON="$environment/bin/python"
run "make python takes the library that is built" [ ! -e tools/python/build/libgnomon.so ]

# Outside the project, so that the installed package is imported.
tests=$(pwd)/tools/python/tests
if (cd / && HYPOTHESIS_STORAGE_DIRECTORY=$GNOMON_BUILD/python/hypothesis \
    "$GNOMON_BUILD/python/environment/bin/python" -m pytest -q -p no:cacheprovider "$tests") >"$log" 2>&1; then
    count=$(sed -n 's/^\([0-9]*\) passed.*/\1/p' "$log")
    passed=$((passed + ${count:-0}))
    [ "${count:-0}" -ge 60 ] || { failed=$((failed + 1)); echo "FAILED: only ${count:-0} tests ran"; }
else
    failed=$((failed + 1))
    tail -n 40 "$log"
fi

if "$python" -c 'import mypy' 2>/dev/null; then
    run "types" "$python" -m mypy --cache-dir "$1/python/mypy" --config-file tools/python/pyproject.toml tools/python/src/gnomon
else
    skip "Python's types: needs mypy: 'make setup' installs it"
fi
run "code of the documentation" tests/packaging/guide.sh --python "$environment/bin/python"
# The reference may be unpacked beside the build, with a loader of its own.
loader=$(ls "${MESA:-build/mesa}"/usr/lib/*/ld-linux*.so.* 2>/dev/null | head -n 1)
run "benchmark" ${loader:+"$loader" --library-path "${loader%/*}"} "$environment/bin/python" tools/python/bench.py --views 20
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
