#!/bin/sh
# Installs what Gnomon's tests, reference and command need from Debian's packages. The
# library itself needs a C compiler alone. Does nothing where everything is there.
set -eu

packages="pkg-config clang g++ libpng-dev libosmesa6-dev libcglm-dev libcmocka-dev
libassimp-dev libstb-dev libmpfr-dev libsimde-dev"

say() { echo "setup: $*"; }
fail() { echo "setup: $*" >&2; exit 1; }

case "${1:-}" in
"") ;;
-h | --help)
    echo "tools/setup.sh: install the Debian packages that are missing of:"
    echo $packages
    exit 0
    ;;
*) fail "unknown argument '$1'; there are none but --help" ;;
esac

for tool in dpkg-query apt-get; do
    command -v $tool >/dev/null 2>&1 || fail "this is no Debian system ($tool is missing);" \
        "install these, or what they are called here:" $packages
done

missing=""
for package in $packages; do
    state=$(dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null | head -n 1) || true
    [ "$state" = installed ] || missing="$missing $package"
done
missing=${missing# }

if [ -z "$missing" ]; then
    say "everything is there"
    exit 0
fi
[ "$(id -u)" = 0 ] || fail "not root; install the missing packages with:" \
    "apt-get install --no-install-recommends $missing"

export DEBIAN_FRONTEND=noninteractive
log=$(mktemp)
trap 'rm -f "$log"' EXIT

# Runs one step quietly; what it printed is shown where it fails.
step() {
    say "$1"
    shift
    if ! "$@" >"$log" 2>&1; then
        cat "$log" >&2
        fail "failed: $*"
    fi
}

step "reading the package lists" apt-get -o DPkg::Lock::Timeout=900 -q update
step "installing $missing" \
    apt-get -o DPkg::Lock::Timeout=900 -q -y --no-install-recommends install $missing
say "done"
