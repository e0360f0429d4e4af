"""Why a picture is empty, in words."""

from __future__ import annotations

from typing import Any, List

import numpy as np

from .arrays import Doubles, matrix_of
from .scene import Mesh


def _clip_space(job: Any, meshes: List[Mesh]) -> Doubles:
    """Returns the vertices that faces have as the first camera's clip space has them, (n, 4)."""
    from_world = matrix_of(job.camera[0].clip_from_world, 4).astype(np.float64)
    places = []
    for i, mesh in enumerate(meshes):
        matrix = from_world @ matrix_of(job.part[i].world_from_model, 4).astype(np.float64)
        vertices = mesh.placed.vertices[np.unique(mesh.faces)].astype(np.float64)
        places.append(vertices @ matrix[:, :3].T + matrix[:, 3])
    return np.concatenate(places)


def reason(job: Any, meshes: List[Mesh]) -> str:
    """Returns why a views_job has drawn nothing, as the first camera sees it. The words have no
    numbers, so that Python shows the same warning of the same line once.
    """
    if not any(len(mesh.faces) for mesh in meshes):
        return "there are no faces"
    x, y, z, w = _clip_space(job, meshes).T
    nearer, farther = (z > w, z < 0) if job.reversed else (z < -w, z > w)
    places = (
        (w <= 0, "is behind the camera"),
        (nearer, "is nearer than the near plane, or behind the camera"),
        (farther, "is beyond the far plane"),
        (x < -w, "is to the left of the picture"),
        (x > w, "is to the right of the picture"),
        (y < -w, "is below the picture"),
        (y > w, "is above the picture"),
    )
    for is_there, words in places:
        if is_there.all():
            return f"everything {words}" + (" in the first picture" if job.count > 1 else "")
    return "no face that is in view covers a pixel's centre, or all are culled"
