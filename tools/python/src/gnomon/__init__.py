"""Software rendering to numpy arrays, with the same pixels on every machine.

    import gnomon, numpy as np

    vertices = np.array([[-1, -1, 4], [1, -1, 4], [0, 1, 4]], np.float32)
    faces = np.array([[0, 1, 2]], np.uint32)
    K = [[500, 0, 319.5], [0, 500, 239.5], [0, 0, 1]]
    picture = gnomon.render(vertices, faces, K, width=640, height=480)
    picture.color, picture.depth, picture.normals, picture.labels
"""

from ._native import lib as _lib
from .contract import Contract, contract
from .errors import EmptyWarning, Error, ModelWarning
from .lights import Light
from .loading import load
from .models import Lines, Model, Points
from .rendering import OUTPUTS, SHADERS, Pictures, render
from .scene import Material, Mesh, Texture
from .transforms import (
    CONVENTIONS,
    Transform,
    affine,
    frustum,
    identity,
    intrinsics,
    look_at,
    orthographic,
    perspective,
    rotate_axis,
    rotate_x,
    rotate_y,
    rotate_z,
    rotation_matrix,
    scale,
    translate,
    trs,
    viewport,
)

_number: int = _lib.gn_version()
__version__ = f"{_number // 1000000}.{_number // 1000 % 1000}.{_number % 1000}"

__all__ = [
    "CONVENTIONS",
    "Contract",
    "EmptyWarning",
    "Error",
    "Light",
    "Lines",
    "Material",
    "Mesh",
    "Model",
    "ModelWarning",
    "OUTPUTS",
    "Pictures",
    "Points",
    "SHADERS",
    "Texture",
    "Transform",
    "affine",
    "contract",
    "frustum",
    "identity",
    "intrinsics",
    "load",
    "look_at",
    "orthographic",
    "perspective",
    "render",
    "rotate_axis",
    "rotate_x",
    "rotate_y",
    "rotate_z",
    "rotation_matrix",
    "scale",
    "translate",
    "trs",
    "viewport",
]
