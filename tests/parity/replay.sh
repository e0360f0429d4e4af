#!/bin/sh
# Replays scenes that once failed, or that are about a rule: each must equal the reference. To add a
# scene, add its file to tests/parity/scenes.
# usage: replay.sh PARITY-PROGRAM [DIRECTORY]
set -u
parity=$1
directory=${2:-tests/parity/scenes}
passed=0
failed=0
log=$(mktemp)
trap 'rm -f "$log"' EXIT
trap 'exit 1' INT TERM HUP
for scene in "$directory"/*.scene; do
    if "$parity" --replay "$scene" >"$log" 2>&1; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $scene"
        cat "$log"
    fi
done
echo "scenes: $passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
