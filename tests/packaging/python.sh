#!/bin/sh
# Installs the Python package as a user does, with pip into an environment over Debian's packages and
# without downloads, and runs its tests and the check of its types.
# usage: python.sh BUILD-DIRECTORY   (from the root of the project; `make python-parts` has run)
set -u
. tests/script.sh
begin Python
python=${PYTHON:-/usr/bin/python3}
mkdir -p "$1/python"
GNOMON_BUILD=$(cd "$1" && pwd) || exit 2
export GNOMON_BUILD
environment=$GNOMON_BUILD/python/environment

needed='import cffi, numpy, setuptools, wheel, pytest, hypothesis, venv, pip, PIL'
if ! "$python" -c "$needed" 2>/dev/null; then
    skip "Python: needs python3-cffi, -numpy, -setuptools, -pytest, -hypothesis, -venv, -pip and -pil: 'make setup' installs them"
    finish
fi
[ -x "$environment/bin/python" ] || "$python" -m venv --system-site-packages "$environment" || exit 1
result "pip install" "$environment/bin/pip" install --quiet --no-build-isolation --no-index --force-reinstall --no-deps ./tools/python
rm -f tools/python/build/libgnomon.so
result "make python" make -s python BUILD="$1" PYTHON="$environment/bin/python"
result "make python takes the library that is built" [ ! -e tools/python/build/libgnomon.so ]

# Outside the project, so that the installed package is imported.
result "tests" sh -c 'cd / && HYPOTHESIS_STORAGE_DIRECTORY=$GNOMON_BUILD/python/hypothesis "$1/bin/python" -m pytest -q -p no:cacheprovider "$2"' \
    - "$environment" "$(pwd)/tools/python/tests"
count=$(sed -n 's/^\([0-9]*\) passed.*/\1/p' "$work/said")
result "at least 60 tests run, not ${count:=0}" [ "$count" -ge 60 ]
passed=$((passed + count))

if "$python" -c 'import mypy' 2>/dev/null; then
    result "types" "$python" -m mypy --cache-dir "$1/python/mypy" --config-file tools/python/pyproject.toml tools/python/src/gnomon
else
    skip "Python's types: needs mypy: 'make setup' installs it"
fi
result "code of the documentation" tests/packaging/guide.sh --python "$environment/bin/python"
# The reference may be unpacked beside the build, with a loader of its own.
loader=$(ls "${MESA:-build/mesa}"/usr/lib/*/ld-linux*.so.* 2>/dev/null | head -n 1)
result "benchmark" ${loader:+"$loader" --library-path "${loader%/*}"} "$environment/bin/python" tools/python/bench.py --views 20
finish
