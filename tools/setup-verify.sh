#!/bin/sh
# Installs the Debian packages that `make prove`, `make fuzz`, `make coverage`, `make deb` and the
# step osmesa/mujoco of `make whole` need, about 1 GB. Does nothing if everything is installed.
set -eu
self=setup-verify
. "$(dirname "$0")/debian.sh"

install_packages "frama-c-base why3 z3 cvc5 gappa afl++ clang-19 libclang-rt-19-dev llvm-19
debhelper dpkg-dev fakeroot lintian libmujoco-dev libmujoco-samples" "$@"
