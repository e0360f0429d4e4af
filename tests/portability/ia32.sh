#!/bin/sh
# Runs a program for 32-bit x86: on this processor, or under qemu-i386 if the kernel does not start such
# programs (kernels without IA32 emulation).
# usage: ia32.sh PROGRAM [ARGUMENT...]
if "$1" --help >/dev/null 2>&1; then
    exec "$@"
fi
command -v qemu-i386 >/dev/null 2>&1 || {
    echo "ia32.sh: the kernel does not start programs for 32-bit x86, and qemu-i386 is absent; package qemu-user" >&2
    exit 1
}
exec qemu-i386 "$@"
