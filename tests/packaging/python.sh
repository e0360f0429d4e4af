#!/bin/sh
# Builds the Python package's wheel, installs it with pip into an environment over Debian's packages, without
# downloads, and runs its tests and the check of its types.
# usage: python.sh BUILD-DIRECTORY   (from the root of the project; `make python-parts` has run)
set -u
. tests/script.sh
begin Python
python=${PYTHON:-/usr/bin/python3}
mkdir -p "$1/python"
GNOMON_BUILD=$(cd "$1" && pwd) || exit 2
export GNOMON_BUILD
environment=$GNOMON_BUILD/python/environment

needed='import cffi, numpy, pytest, hypothesis, venv, pip, PIL'
if ! "$python" -c "$needed" 2>/dev/null; then
    skip "Python: needs python3-cffi, -numpy, -pytest, -hypothesis, -venv, -pip and -pil: 'make setup' installs them"
    finish
fi
[ -x "$environment/bin/python" ] || "$python" -m venv --system-site-packages "$environment" || exit 1
rm -rf "$1/python/wheel"
result "make wheel" make -s wheel BUILD="$1" PYTHON="$python"
cp "$work/said" "$work/progress"
result "one line for each file that is compiled" grep -q '^  CC views.c$' "$work/progress"
wheel=$(ls "$1"/python/wheel/gnomon-*-cp39-abi3-*.whl)
result "pip installs the wheel" "$environment/bin/pip" install --quiet --no-index --force-reinstall --no-deps "$wheel"

# pip builds it with neither setuptools nor wheel, which Python 3.12 does not bring.
mkdir "$work/absent" "$work/again"
for module in setuptools wheel; do
    echo "raise ImportError('$module')" >"$work/absent/$module.py"
done
result "pip builds the same wheel, without setuptools" env PYTHONPATH="$work/absent" "$environment/bin/pip" wheel --quiet \
    --no-build-isolation --no-index --no-deps --wheel-dir "$work/again" ./tools/python
result "equal bytes" cmp "$wheel" "$work/again/${wheel##*/}"
echo "raise ImportError('cffi')" >"$work/absent/cffi.py"
PYTHONPATH=$work/absent "$python" tools/python/build_wheel.py "$work/again" >"$work/refused" 2>&1
result "a Python without cffi is told so" grep -q 'has no cffi; install it, or name another: make wheel PYTHON=' "$work/refused"

# Outside the project, so that the installed package is imported.
result "tests" sh -c 'cd / && HYPOTHESIS_STORAGE_DIRECTORY=$GNOMON_BUILD/python/hypothesis "$1/bin/python" -m pytest -q -p no:cacheprovider "$2"' \
    - "$environment" "$(pwd)/tools/python/tests"
count=$(sed -n 's/^\([0-9]*\) passed.*/\1/p' "$work/said")
result "at least 300 tests run, not ${count:=0}" [ "$count" -ge 300 ]
passed=$((passed + count))

if "$python" -c 'import mypy' 2>/dev/null; then
    result "types" "$python" -m mypy --cache-dir "$1/python/mypy" --config-file tools/python/pyproject.toml tools/python/src/gnomon
else
    skip "Python's types: needs mypy: 'make setup' installs it"
fi
result "code of the documentation" tests/packaging/guide.sh --python "$environment/bin/python"
# The reference may be unpacked beside the build, with a loader of its own.
loader=$(ls "${MESA:-build/mesa}"/usr/lib/*-linux-gnu/ld-linux*.so.* 2>/dev/null | head -n 1)
result "benchmark" ${loader:+"$loader" --library-path "${loader%/*}"} "$environment/bin/python" tools/python/bench.py --views 20
finish
