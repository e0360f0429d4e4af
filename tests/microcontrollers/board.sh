#!/bin/sh
# Runs a program for a microcontroller in the emulator, on a board of Arm's MPS2 family.
# usage: board.sh BOARD PROGRAM [ARGUMENT...]
set -eu
board=$1 program=$2
shift 2
config=enable=on,target=native,arg=program
for argument in "$@"; do
    config=$config,arg=$argument
done
exec qemu-system-arm -M "$board" -display none -monitor none -serial none \
    -semihosting-config "$config" -kernel "$program"
