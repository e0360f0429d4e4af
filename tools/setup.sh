#!/bin/sh
# Installs the Debian packages that Gnomon's tests and command need. The
# library itself needs only a C compiler. Does nothing if everything is installed.
# usage: setup.sh [--demo | --help]     --demo: only what `make demo` needs
set -eu
self=setup
. "$(dirname "$0")/debian.sh"

packages="libpng-dev libassimp-dev libstb-dev zlib1g-dev libegl-dev"
if [ "${1:-}" = --demo ]; then
    shift
else
    packages="$packages pkg-config clang clang-format libclang-rt-dev g++ cmake libcglm-dev libcmocka-dev libsdl2-dev
xvfb mandoc zsh parallel python3 meson ninja-build doxygen libgmp-dev libmpfr-dev libsimde-dev gappa python3-markdown-it python3-pygments
python3-dev python3-cffi python3-numpy python3-venv python3-pip python3-pytest python3-hypothesis python3-opengl python3-pil mypy khronos-api"
fi
install_packages "$packages" "$@"
