"""Models: what a file holds, as meshes, points and lines."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, List, Optional

import numpy as np
import numpy.typing as npt

from .arrays import Array, Floats
from .errors import refuse
from .lights import Light
from .scene import Mesh


@dataclass(frozen=True, eq=False)
class Points:
    """Points, in the order of the file."""

    vertices: Array  # (n, 3): float32, or float64 far from the origin
    colors: Floats  # (n, 4): red, green, blue, alpha
    normals: Optional[Floats]  # (n, 3), of any length; None if the file has none


@dataclass(frozen=True, eq=False)
class Lines:
    """Segments between vertices."""

    vertices: Array  # (v, 3): float32, or float64 far from the origin
    segments: npt.NDArray[np.uint32]  # (n, 2): the numbers of the ends in vertices
    colors: Floats  # (v, 4): red, green, blue, alpha


@dataclass(frozen=True, eq=False)
class Model:
    """What a file holds. There is one mesh for each material; `render` draws them all.

    `lights` are for `render`'s `light`, which takes a list of up to 8. `warnings` name what is drawn differently from what
    the file says.
    """

    meshes: List[Mesh]
    points: Optional[Points]
    lines: Optional[Lines]
    lights: List[Light]
    warnings: List[str]

    def merged(self) -> Mesh:
        """Returns all triangles as one Mesh, in the order of `meshes`, without materials.

        Normals, colors, texcoords and tangents are there if every mesh has them.
        """
        if not self.meshes:
            raise refuse("merged", "the Model has no triangles")
        starts = np.cumsum([0] + [len(mesh.vertices) for mesh in self.meshes[:-1]])
        if int(starts[-1]) + len(self.meshes[-1].vertices) > 2**32:
            raise refuse("merged", "the Model has more than 2^32 vertices")
        faces = [m.faces + np.uint32(start) for m, start in zip(self.meshes, starts)]

        def joined(attribute: Callable[[Mesh], Optional[Array]]) -> Optional[Array]:
            arrays = [attribute(mesh) for mesh in self.meshes]
            present = [array for array in arrays if array is not None]
            return np.concatenate(present) if len(present) == len(arrays) else None

        return Mesh(
            joined(lambda mesh: mesh.vertices),
            np.concatenate(faces),
            normals=joined(lambda mesh: mesh.normals),
            colors=joined(lambda mesh: mesh.colors),
            texcoords=joined(lambda mesh: mesh.texcoords),
            tangents=joined(lambda mesh: mesh.tangents),
        )
