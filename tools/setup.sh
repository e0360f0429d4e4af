#!/bin/sh
# Installs what Gnomon's tests, reference and command need from Debian's packages. The
# library itself needs a C compiler alone. Does nothing where everything is there.
set -eu
self=setup
. "$(dirname "$0")/debian.sh"

install_packages "pkg-config clang libclang-rt-14-dev g++ cmake libpng-dev libosmesa6-dev libcglm-dev libcmocka-dev
libassimp-dev libstb-dev libmpfr-dev libsimde-dev gappa" "$@"
