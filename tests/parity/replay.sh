#!/bin/sh
# Replays scenes that once failed, or that are about a rule: each must equal the reference. To add a
# scene, add its file to tests/parity/scenes.
# usage: replay.sh PARITY-PROGRAM [DIRECTORY]   (from the root of the project)
set -u
. tests/script.sh
begin scenes
parity=$1
for scene in "${2:-tests/parity/scenes}"/*.scene; do
    result "$scene" "$parity" --replay "$scene"
done
finish
