"""Wavefront OBJ files: what the examples and tests need of them."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, List, Tuple, Union

import numpy as np

from .errors import refuse
from .scene import Mesh

_SIZES = {"v": 3, "vt": 2, "vn": 3}


def read_obj(path: Union[str, Path]) -> Mesh:
    """Returns the mesh of an OBJ file; polygons become fans of triangles.

    Reads v, vt, vn and f and skips all other lines. Raises Error, with the number of the line, for
    what is no such file. Libraries for models, such as trimesh, read more.
    """
    lists: Dict[str, List[List[float]]] = {key: [] for key in _SIZES}
    corners: Dict[Tuple[int, int, int], int] = {}
    faces: List[Tuple[int, int, int]] = []
    with open(path, encoding="utf-8", errors="replace") as file:
        for number, line in enumerate(file, 1):
            words = line.split()
            try:
                if words and words[0] in _SIZES:
                    size = _SIZES[words[0]]
                    values = [float(word) for word in words[1 : 1 + size]]
                    if len(values) != size:
                        raise ValueError
                    lists[words[0]].append(values)
                elif words and words[0] == "f":
                    polygon = [_corner(word, lists, corners) for word in words[1:]]
                    if len(polygon) < 3:
                        raise ValueError
                    faces += [(polygon[0], b, c) for b, c in zip(polygon[1:], polygon[2:])]
            except ValueError:
                raise refuse(str(path), f"line {number} cannot be read: {line.strip()}") from None
    if not faces:
        raise refuse(str(path), "has no faces")
    return _mesh(lists, corners, faces)


def _corner(
    word: str, lists: Dict[str, List[List[float]]], corners: Dict[Tuple[int, int, int], int]
) -> int:
    """Returns the number of the vertex with these indices: position/texture/normal."""
    parts = (word.split("/") + ["", ""])[:3]
    key = []
    for part, kind in zip(parts, ("v", "vt", "vn")):
        index = int(part) if part else 0
        size = len(lists[kind])
        if not -size <= index <= size or (kind == "v" and index == 0):
            raise ValueError
        key.append(index - 1 if index > 0 else size + index if index < 0 else -1)
    return corners.setdefault((key[0], key[1], key[2]), len(corners))


def _mesh(
    lists: Dict[str, List[List[float]]],
    corners: Dict[Tuple[int, int, int], int],
    faces: List[Tuple[int, int, int]],
) -> Mesh:
    chosen = np.array(list(corners), np.int64)

    def attribute(column: int, kind: str) -> Any:
        if (chosen[:, column] < 0).any():
            return None
        return np.array(lists[kind], np.float32)[chosen[:, column]]

    return Mesh(
        attribute(0, "v"),
        np.array(faces, np.uint32),
        texcoords=attribute(1, "vt"),
        normals=attribute(2, "vn"),
    )
