#!/bin/sh
# Runs a Windows program under Wine, whose files are kept in build/wine (WINEPREFIX), and prints what
# it prints with lines that end as they do here. usage: windows.sh PROGRAM [ARGUMENT...]
set -eu
WINEPREFIX=${WINEPREFIX:-$(pwd)/build/wine}
export WINEPREFIX WINEDEBUG=-all WINEDLLOVERRIDES=mscoree,mshtml=
mkdir -p "$WINEPREFIX"
program=$1
[ -e "$program" ] || program=$program.exe
shift
printed=$(mktemp)
trap 'rm -f "$printed"' EXIT
trap 'exit 1' INT TERM HUP
status=0
wine "$program" "$@" >"$printed" || status=$?
tr -d '\r' <"$printed"
exit "$status"
