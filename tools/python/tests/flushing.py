"""Prints "equal" if pictures stay equal when a library sets denormal numbers to be flushed.

usage: flushing.py LIBRARY   (which sets that when it is loaded)
"""

import ctypes
import platform
import sys

import numpy as np

import gnomon

TINY = np.float32(2.0**-140)
SQUARE = np.float32([[-1, -1, 4], [1, -1, 4], [1, 1, 4], [-1, 1, 4]]) * np.float32(2.0**-130)


def drawn(threads: int) -> list:
    """Returns the arrays of a square whose vertices are denormal numbers, and of its transform."""
    model = gnomon.scale(2.0**120)
    faces = np.uint32([[0, 1, 2], [0, 2, 3]])
    picture = gnomon.render(
        SQUARE, faces, [[40, 0, 31.5], [0, 40, 23.5], [0, 0, 1]], model=model, near=2.0**-12,
        far=1.0, width=64, height=48, labels=[1, 2], threads=threads,
    )
    moved = gnomon.translate((2.0**-140, 0, 0)) @ gnomon.identity()
    return [picture.color, picture.depth, picture.normals, picture.labels, moved.matrix]


before = drawn(1)
assert (before[3] >= 0).any(), "nothing was drawn"
ctypes.CDLL(sys.argv[1])
flushes = float(TINY * np.float32(1)) == 0
assert flushes or platform.machine() != "x86_64", "the library does not flush denormal numbers"
for threads in (1, 2):
    for a, b in zip(before, drawn(threads)):
        assert a.tobytes() == b.tobytes(), f"{threads} threads: the arrays differ"
assert (float(TINY * np.float32(1)) == 0) == flushes, "the environment is not restored"
print("equal")
