"""Far coordinates: what is far from the origin is shifted to it before it becomes float32.

A float32 has 24 bits, so a coordinate x is rounded by up to |x| * 2^-24. On maps x is some millions
of metres, and the mesh a few metres. Where the matrices then bring the mesh to the camera, x
vanishes and its rounding stays. So the mesh's and the world's middle are taken from the coordinates
in double precision, and are added to the matrices, whose translations cancel in double precision.

All sums are written out: the order of a matrix product's sums depends on the machine.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Optional, Sequence, Tuple

import numpy as np
import numpy.typing as npt

from .arrays import Array, Doubles, Floats, narrow

# Half sizes between the origin and the middle of what is far. If it is nearer, rounding is below
# 64 * 2^-24 half sizes. That is 0.002 pixels where the mesh is 1,000 pixels wide, and half a step of
# the rasterizer, which has 256 in a pixel. What is not far keeps its bits.
FAR = 64.0


@dataclass(frozen=True)
class Placed:
    """Vertices as float32 relative to an origin, and their bounds, which are not relative to it."""

    vertices: Floats
    origin: Doubles
    middle: Doubles
    half: Doubles


def _far(middle: Doubles, half: Doubles) -> Doubles:
    """Returns the middle of bounds if it is far, otherwise the origin."""
    is_far = np.abs(middle).max() > FAR * half.max()
    return middle if is_far else np.zeros(3)


def place(vertices: Array, name: str, used: Optional[npt.NDArray[np.bool_]]) -> Placed:
    """Returns the vertices relative to their middle if that is far. `used` excludes vertices that
    no face has; None excludes none.
    """
    drawn = vertices if used is None else vertices[used]
    if not len(drawn):
        nothing = np.zeros(3)
        return Placed(narrow(vertices, name, used), nothing, nothing, nothing)
    low, high = drawn.min(axis=0).astype(np.float64), drawn.max(axis=0).astype(np.float64)
    middle, half = low / 2 + high / 2, high / 2 - low / 2
    origin = _far(middle, half)
    if origin.any():
        vertices = vertices.astype(np.float64) - origin
    return Placed(narrow(vertices, name, used), origin, middle, half)


def _product(matrices: Doubles, vector: Doubles) -> Doubles:
    """Returns the upper left 3x3 of one or more matrices times a vector."""
    x, y, z = (matrices[..., :3, i] * vector[i] for i in range(3))
    result: Doubles = x + y + z
    return result


def world_bounds(placed: Sequence[Placed], matrices: Sequence[Doubles]) -> Tuple[Doubles, Doubles]:
    """Returns the middle and the half sizes of what several meshes take up in the world together.
    Each has the matrix that takes it there.
    """
    pairs = list(zip(placed, matrices))
    pairs = [pair for pair in pairs if len(pair[0].vertices)] or pairs
    boxes = []
    with np.errstate(over="ignore", invalid="ignore"):
        for mesh, matrix in pairs:
            middle = _product(matrix, mesh.middle) + matrix[:3, 3]
            boxes.append((middle, _product(np.abs(matrix), mesh.half)))
        if len(boxes) == 1:
            return boxes[0]
        low = np.min([middle - half for middle, half in boxes], axis=0)
        high = np.max([middle + half for middle, half in boxes], axis=0)
        return low / 2 + high / 2, high / 2 - low / 2


def world_origin(bounds: Tuple[Doubles, Doubles]) -> Doubles:
    """Returns the middle of bounds in the world if it is far, otherwise the origin."""
    middle, half = bounds
    return _far(middle, half) if np.isfinite(middle).all() else np.zeros(3)


def between_origins(matrices: Doubles, source: Doubles, target: Doubles) -> Doubles:
    """Returns affine matrices that take coordinates relative to `source` to those relative to
    `target`.
    """
    if not source.any() and not target.any():
        return matrices
    result = matrices.copy()
    with np.errstate(over="ignore", invalid="ignore"):
        result[..., :3, 3] = (_product(matrices, source) + matrices[..., :3, 3]) - target
    return result
