"""What is drawn: meshes, textures, materials and lights."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, List, Optional, Tuple

import numpy as np
import numpy.typing as npt

from ._native import ffi, lib
from .arrays import Floats, pointer, shaped, vector, vector_to_c
from .environment import exact
from .errors import check, refuse, words

# Labels are stored in the bits of floats, of which those from here on are no numbers.
MOST_LABEL = 0x7F7FFFFF

_FORMATS = {
    (np.uint8, 3): "GN_FORMAT_RGB8",
    (np.uint8, 4): "GN_FORMAT_RGBA8",
    (np.float32, 4): "GN_FORMAT_RGBA32F",
}
_FILTERS = ("nearest", "linear", "trilinear")
_WRAPS = {"repeat": "GN_WRAP_REPEAT", "clamp": "GN_WRAP_CLAMP_TO_EDGE"}


def _optional(value: Any, name: str, shape: List[Any]) -> Optional[Floats]:
    return None if value is None else shaped(value, name, shape)


class Mesh:
    """Triangles: vertices of shape (v, 3), faces of shape (f, 3), and what each vertex has.

    `colors` has the shape (v, 3) or (v, 4), as floats of 0 to 1 or bytes; `texcoords` (v, 2), with
    t = 0 at the bottom of a texture; `tangents` (v, 4). `labels` has a number for each face.
    Arrays of float32, and of uint32 for faces, that are contiguous are used where they are.
    """

    def __init__(
        self,
        vertices: Any,
        faces: Any,
        *,
        normals: Any = None,
        colors: Any = None,
        texcoords: Any = None,
        tangents: Any = None,
        labels: Any = None,
    ) -> None:
        self.vertices = shaped(vertices, "vertices", [None, 3])
        self.faces = _faces(faces, len(self.vertices))
        count = len(self.vertices)
        self.normals = _optional(normals, "normals", [count, 3])
        self.colors = None if colors is None else _colors(colors, count)
        self.texcoords = _optional(texcoords, "texcoords", [count, 2])
        self.tangents = _optional(tangents, "tangents", [count, 4])
        self.labels = None if labels is None else _labels(labels, len(self.faces))

    def face_normals(self) -> Floats:
        """Returns the normals of the faces, of shape (f, 3) and any length."""
        a, b, c = (self.vertices[self.faces[:, i]] for i in range(3))
        e, f = b - a, c - a
        normals = np.empty((len(self.faces), 3), np.float32)
        for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
            normals[:, i] = e[:, j] * f[:, k] - e[:, k] * f[:, j]
        return normals

    def write(self, mesh: Any) -> None:
        """Writes the pointers to a gn_mesh; the arrays must outlive it."""
        arrays = (
            (lib.GN_ATTRIBUTE_POSITION, self.vertices),
            (lib.GN_ATTRIBUTE_COLOR, self.colors),
            (lib.GN_ATTRIBUTE_NORMAL, self.normals),
            (lib.GN_ATTRIBUTE_TEXCOORD, self.texcoords),
            (lib.GN_ATTRIBUTE_TANGENT, self.tangents),
        )
        for number, array in arrays:
            if array is not None and len(array):
                mesh.attribute[number].data = pointer(array, "float[]")
                mesh.attribute[number].components = array.shape[1]
        if len(self.faces):
            mesh.indices = pointer(self.faces, "uint32_t[]")
        mesh.index_format = lib.GN_INDEX_UINT32
        mesh.vertex_count = len(self.vertices)
        mesh.count = self.faces.size


def _faces(faces: Any, count: int) -> npt.NDArray[np.uint32]:
    given = np.asarray(faces)
    if given.ndim != 2 or given.shape[1] != 3 or given.dtype.kind not in "iu":
        raise refuse("faces", f"has the shape {given.shape} of {given.dtype}, not (any, 3) of integers")
    if given.size and (given.min() < 0 or given.max() >= count):
        raise refuse("faces", f"has a number that is not in 0 to {count - 1}, as there are {count} vertices")
    return np.ascontiguousarray(given, dtype=np.uint32)


def _colors(colors: Any, count: int) -> Floats:
    given = np.asarray(colors)
    if given.dtype == np.uint8:
        given = given / np.float32(255)
    if given.ndim != 2 or given.shape[1] not in (3, 4):
        raise refuse("colors", f"has the shape {given.shape}, not ({count}, 3) or ({count}, 4)")
    return shaped(given, "colors", [count, given.shape[1]])


def _labels(labels: Any, count: int) -> npt.NDArray[np.int32]:
    given = np.asarray(labels)
    if given.shape != (count,) or given.dtype.kind not in "iu":
        raise refuse("labels", f"has the shape {given.shape} of {given.dtype}, not ({count},) of integers")
    if given.size and (given.min() < 0 or given.max() > MOST_LABEL):
        raise refuse("labels", f"has a number that is not in 0 to {MOST_LABEL}")
    return np.ascontiguousarray(given, dtype=np.int32)


class Texture:
    """An image of shape (height, width, channels) with its top row first, as image files have it.

    Bytes with 3 or 4 channels and floats with 4 channels are used where they are; bytes with one
    channel are repeated in three. `filter` is "nearest", "linear" or "trilinear"; `wrap` is
    "repeat" or "clamp".
    """

    def __init__(self, image: Any, filter: str = "linear", wrap: str = "repeat") -> None:
        if filter not in _FILTERS:
            raise refuse("filter", f"is {filter!r}, not one of {', '.join(_FILTERS)}")
        if wrap not in _WRAPS:
            raise refuse("wrap", f"is {wrap!r}, not one of {', '.join(_WRAPS)}")
        given = np.asarray(image)
        if given.ndim == 2 or (given.ndim == 3 and given.shape[2] == 1):
            given = np.repeat(given.reshape(given.shape[0], given.shape[1], 1), 3, axis=2)
        name = _FORMATS.get((given.dtype.type, given.shape[2])) if given.ndim == 3 else None
        if name is None:
            raise refuse(
                "image",
                f"has the shape {given.shape} of {given.dtype}; bytes need 1, 3 or 4 channels, "
                "float32 needs 4",
            )
        self.image = np.ascontiguousarray(given)
        self.filter = filter
        self.wrap = wrap
        self._levels: Optional[npt.NDArray[np.uint32]] = None
        self.texture = ffi.new("gn_texture *")
        self._describe(getattr(lib, name))

    @exact
    def _describe(self, format_number: int) -> None:
        height, width, channels = self.image.shape
        row = width * channels * self.image.itemsize
        texels = ffi.cast("const char *", pointer(self.image, "char[]"))
        texture = self.texture
        texture.target = lib.GN_TEXTURE_2D
        texture.format = format_number
        texture.width, texture.height = width, height
        texture.level[0].texels = texels + row * (height - 1)
        texture.level[0].row_stride = -row
        fault = words(lib.gn_texture_fault(texture))
        check(lib.gn_texture_check(texture), "texture", fault)
        if self.filter == "trilinear":
            levels = max(width, height).bit_length()
            size = lib.gn_texture_memory_size(
                lib.GN_TEXTURE_2D, format_number, width, height, 1, levels
            )
            self._levels = np.empty(size // 4 + 1, np.uint32)
            memory = pointer(self._levels, "char[]")
            check(lib.gn_texture_generate_levels(texture, memory, len(memory)), "texture")

    def write_sampler(self, sampler: Any) -> None:
        """Writes the filter and the wrap to a gn_sampler."""
        sampler.wrap_s = sampler.wrap_t = getattr(lib, _WRAPS[self.wrap])
        nearest = self.filter == "nearest"
        sampler.magnify = lib.GN_MAGNIFY_NEAREST if nearest else lib.GN_MAGNIFY_LINEAR
        sampler.minify = {
            "nearest": lib.GN_MINIFY_NEAREST,
            "linear": lib.GN_MINIFY_LINEAR,
            "trilinear": lib.GN_MINIFY_LINEAR_MIPMAP_LINEAR,
        }[self.filter]


@dataclass
class Material:
    """Maps and highlights of the lit shaders (gnomon/light.h). All maps share one filter."""

    diffuse: Optional[Texture] = None
    normal: Optional[Texture] = None
    specular_map: Optional[Texture] = None
    glow: Optional[Texture] = None
    tangent_space: bool = False
    specular: Tuple[float, float, float] = (0.0, 0.0, 0.0)
    exponent: int = 32
    bands: int = 4

    def write(self, material: Any) -> None:
        """Writes a gn_material; the textures must outlive it."""
        maps = (
            ("diffuse_map", self.diffuse),
            ("normal_map", self.normal),
            ("specular_map", self.specular_map),
            ("glow_map", self.glow),
        )
        ways = {(texture.filter, texture.wrap) for _, texture in maps if texture}
        if len(ways) > 1:
            raise refuse("material", "has maps of different filters or wraps")
        for name, texture in maps:
            if texture:
                setattr(material, name, texture.texture)
                texture.write_sampler(material.sampler)
        material.normal_space = (
            lib.GN_NORMAL_OF_TANGENTS if self.tangent_space else lib.GN_NORMAL_OF_MODEL
        )
        vector_to_c(self.specular, "specular", material.specular)
        for name in ("exponent", "bands"):
            value = getattr(self, name)
            if not 0 <= value < 2**32:
                raise refuse(name, f"is {value}, not in 0 to 4294967295")
            setattr(material, name, value)


@dataclass
class Light:
    """A light. Without direction and position it shines from the camera.

    `direction` points towards the light, in the world. With `position` it is a point light, whose
    light is divided by constant + linear * distance + quadratic * distance^2.
    """

    direction: Optional[Any] = None
    position: Optional[Any] = None
    ambient: Any = (0.15, 0.15, 0.15)
    diffuse: Any = (0.85, 0.85, 0.85)
    attenuation: Tuple[float, float, float] = field(default=(0.0, 0.0, 0.0))

    def write(self, job: Any) -> None:
        """Writes the light of a views_job."""
        light = job.light
        if self.direction is not None and self.position is not None:
            raise refuse("light", "has a direction and a position")
        job.light_follows = self.direction is None and self.position is None
        if self.direction is not None:
            unit = ffi.new("gn_vec3 *")
            vector_to_c(self.direction, "direction", unit)
            check(lib.gn_vec3_normalize(unit[0], unit), "light.direction")
            light.direction = unit[0]
        if self.position is not None:
            light.is_point = True
            vector_to_c(self.position, "position", light.position)
        vector_to_c(self.ambient, "ambient", light.ambient)
        vector_to_c(self.diffuse, "diffuse", light.diffuse)
        light.constant, light.linear, light.quadratic = (
            float(v) for v in vector(self.attenuation, "attenuation")
        )
