#!/bin/sh
# Installs Debian packages without which tests are skipped: compilers, C libraries and emulators for
# `make cross`, `make size` and `make bench-embedded`, more than 1 GB, the libraries other than cglm
# with which `make accuracy` compares, and debootstrap, with which a bare Debian is tried.
# Does nothing if everything is installed.
set -eu
self=setup-cross
. "$(dirname "$0")/debian.sh"

node=nodejs
if command -v node >/dev/null 2>&1; then
    node=""
fi

install_packages "gcc-aarch64-linux-gnu libc6-dev-arm64-cross gcc-arm-linux-gnueabihf
libc6-dev-armhf-cross gcc-s390x-linux-gnu libc6-dev-s390x-cross gcc-powerpc64-linux-gnu
libc6-dev-ppc64-cross gcc-riscv64-linux-gnu libc6-dev-riscv64-cross gcc-i686-linux-gnu
libc6-dev-i386-cross gcc-mingw-w64-x86-64 wine wine64 musl-tools tcc qemu-user clang-19 lld-19
wasi-libc libclang-rt-19-dev-wasm32 gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm gcc-riscv64-unknown-elf
qemu-system-misc
libglm-dev libeigen3-dev debootstrap $node" "$@"
