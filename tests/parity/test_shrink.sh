#!/bin/sh
# Checks that a failing scene keeps its failure when it is made smaller. The scenes here have two
# failures: a draw that the library refuses, and a draw that the library refuses for another reason or
# draws otherwise than the reference, whose scissors leak among samples (reference/RULES.md).
# usage: test_shrink.sh PARITY-PROGRAM   (from the root of the project)
set -u
. tests/script.sh
begin shrinking
parity=$1

triangle='  vertices 3
  position 2
   -1 -1
   3 -1
   -1 3'
outside="draw vertex-color
$triangle
  indices uint8 3
   0 1 7
  elements 0 3
end-draw"
other_refusal='draw vertex-color
  raster.topology lines
  raster.line_width nan:7fc00000
  vertices 2
  position 2
   -1 -1
   1 1
  elements 0 2
end-draw'
leak="draw vertex-color
  raster.scissor.set on
  raster.scissor.x 3
  raster.scissor.y 3
  raster.scissor.width 5
  raster.scissor.height 5
$triangle
  color 4
   1 1 1 1
   1 1 1 1
   1 1 1 1
  elements 0 3
end-draw"
says_outside='an index or range lies outside'
says_other='NaN or infinite'
says_differ='no error'

# check WHAT EXPECTED DRAW...: shrinking a scene of these draws keeps one draw, whose message is
# EXPECTED.
check() {
    case=$1 expected=$2
    {
        printf 'gnomon-scene 1\nsize 8 8\ncolor-format rgba8\ndepth-format none\n'
        printf 'clear-color 0 0 0 0\nclear-depth 1\nclear-stencil 0\nsamples 4\n'
        shift 2
        printf '%s\n' "$@" end-scene
    } >"$work/scene"
    "$parity" --replay "$work/scene" --shrink --keep "$work/kept" >"$work/log" 2>&1
    "$parity" --replay "$work/kept" >"$work/replayed" 2>&1
    status=$?
    result "$case: exit status $status: $(tail -n 2 "$work/log")" [ $status -eq 1 ]
    result "$case: what is said" grep "$expected" "$work/replayed"
    result "$case: one draw is left" [ "$(grep -c '^draw' "$work/kept")" -eq 1 ]
}

check "refused twice, the first" "$says_outside" "$outside" "$other_refusal"
check "refused twice, the other first" "$says_other" "$other_refusal" "$outside"
check "refused, then other pixels" "$says_outside" "$outside" "$leak"
check "other pixels, then refused" "$says_outside" "$leak" "$outside"
check "other pixels alone" "$says_differ" "$leak" "$leak"
finish
