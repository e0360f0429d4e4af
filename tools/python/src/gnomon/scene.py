"""What is drawn: meshes, textures and materials."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, List, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from ._native import ffi, lib
from .arrays import Array, Floats, array_of, choice, finite, finite_rows, fitting, flag, instance
from .arrays import integer, narrow, numbers, pointer
from .colors import check_range, floats_of, light_to_c
from .environment import exact
from .errors import check, refuse, words
from .images import ImageFault, decode
from .placing import place

# Labels are stored in the bits of floats, of which those from here on are no numbers.
MOST_LABEL = 0x7F7FFFFF

# Bytes of the texels of an image that is read.
MOST_IMAGE = 2**31

_FORMATS = {
    (np.uint8, 3): "GN_FORMAT_RGB8",
    (np.uint8, 4): "GN_FORMAT_RGBA8",
    (np.float32, 4): "GN_FORMAT_RGBA32F",
}
_FILTERS = ("nearest", "linear", "trilinear")
_WRAPS = {
    "repeat": "GN_WRAP_REPEAT",
    "clamp": "GN_WRAP_CLAMP_TO_EDGE",
    "mirror": "GN_WRAP_MIRRORED_REPEAT",
    "border": "GN_WRAP_CLAMP_TO_BORDER",
}
Wrap = Union[str, Tuple[str, str]]
Used = Optional[npt.NDArray[np.bool_]]


class Mesh:
    """Triangles: vertices of shape (v, 3), faces of shape (f, 3), and what each vertex has.

    `colors` has the shape (v, 3) or (v, 4), as floats of 0 to 1 or as bytes, which are of uint8;
    other integers are refused. `texcoords` has the shape (v, 2), with t = 0 at the bottom of a
    texture; `tangents` (v, 4). `labels` has an integer for each face, or is one for all. `material` is what `render`
    draws the mesh with if it is given no other. The numbers of vertices that
    faces have must be finite. Arrays of float32, and of uint32 for faces, that are contiguous are
    used where they are. Vertices far from the origin may be float64; see `render`.
    """

    @exact
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
        material: Optional[Material] = None,
    ) -> None:
        given = fitting(numbers(vertices, "vertices"), "vertices", [None, 3])
        count = len(given)
        self.faces = _faces(faces, count)
        used = _used(self.faces, count)
        finite_rows(given, "vertices", used)
        self.placed = place(given, "vertices", used)
        self._far = given.view() if self.placed.origin.any() else None
        if self._far is not None:
            self._far.flags.writeable = False
        self.normals = _attribute(normals, "normals", [count, 3], used)
        self.colors = None if colors is None else _colors(colors, count, used)
        self.texcoords = _attribute(texcoords, "texcoords", [count, 2], used)
        self.tangents = _attribute(tangents, "tangents", [count, 4], used)
        self.labels = None if labels is None else _labels(labels, len(self.faces))
        self.material = material

    @property
    def vertices(self) -> Array:
        """The vertices where they were given. Far ones cannot be written: others are drawn."""
        return self.placed.vertices if self._far is None else self._far

    def write(self, mesh: Any) -> None:
        """Writes the pointers to a gn_mesh; the arrays must outlive it."""
        arrays = (
            (lib.GN_ATTRIBUTE_POSITION, self.placed.vertices),
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


def _used(faces: npt.NDArray[np.uint32], count: int) -> Used:
    """Returns which vertices faces have, or None if they have all."""
    used = np.zeros(count, bool)
    used[faces.reshape(-1)] = True
    return None if used.all() else used


def _attribute(value: Any, name: str, shape: List[Any], used: Used) -> Optional[Floats]:
    if value is None:
        return None
    given = fitting(numbers(value, name), name, shape)
    finite_rows(given, name, used)
    return narrow(given, name, used)


def _refuse_number(name: str, given: Array, most: int, why: str = "") -> None:
    """Refuses integers that are not 0 to `most`."""
    for number in (given.min(), given.max()) if given.size else ():
        if not 0 <= int(number) <= most:
            raise refuse(name, f"has {number}, not 0 to {most}{why}")


def _faces(faces: Any, count: int) -> npt.NDArray[np.uint32]:
    if faces is None:
        raise refuse("faces", "is missing")
    given = array_of(faces, "faces")
    if given.ndim != 2 or given.shape[1] != 3 or given.dtype.kind not in "iu":
        raise refuse("faces", f"has the shape {given.shape} of {given.dtype}, not (any, 3) of integers")
    if given.size and not count:
        raise refuse("faces", f"has {given.min()}, but there are no vertices")
    _refuse_number("faces", given, count - 1, f", as there are {count} vertices")
    return np.ascontiguousarray(given, dtype=np.uint32)


def _colors(colors: Any, count: int, used: Used) -> Floats:
    given = floats_of(colors, "colors")
    if given.ndim != 2 or given.shape[1] not in (3, 4):
        raise refuse("colors", f"has the shape {given.shape}, not ({count}, 3) or ({count}, 4)")
    result = _attribute(given, "colors", [count, given.shape[1]], used)
    assert result is not None
    check_range(result if used is None else result[used], "colors")
    return result


def _labels(labels: Any, count: int) -> npt.NDArray[np.int32]:
    given = array_of(labels, "labels")
    if given.shape == ():
        given = np.repeat(given, count)
    if given.shape != (count,) or given.dtype.kind not in "iu":
        raise refuse("labels", f"has the shape {given.shape} of {given.dtype}, not ({count},) of integers")
    _refuse_number("labels", given, MOST_LABEL)
    return np.ascontiguousarray(given, dtype=np.int32)


def _read(path: Union[str, os.PathLike[str]]) -> Array:
    """Returns the image of a file."""
    name = os.fsdecode(path)
    try:
        return decode(name, MOST_IMAGE)
    except ImageFault as fault:
        raise refuse("texture", f"{name!r} {fault}") from None


class Texture:
    """An image of shape (height, width, channels) with its top row first, or the path of a file.

    Files are BMP, JPEG, PNG, PPM or TGA, and need Pillow.

    Bytes with 3 or 4 channels and float32 of 0 to 1 with 4 channels are used where they are; bytes
    with one channel are repeated in three. `filter` is "nearest", "linear" or "trilinear"; `wrap` is
    "repeat", "clamp", "mirror" or "border", which is white, or has one of them for s and one for t.
    """

    def __init__(self, image: Any, filter: str = "linear", wrap: Wrap = "repeat") -> None:
        choice(filter, "filter", _FILTERS)
        pair = wrap if isinstance(wrap, (tuple, list)) else (wrap, wrap)
        if len(pair) != 2 or any(not isinstance(w, str) or w not in _WRAPS for w in pair):
            raise refuse("wrap", f"is {wrap!r}, not one of {', '.join(_WRAPS)}, or a pair of them")
        self.wrap = tuple(pair)
        given = _read(image) if isinstance(image, (str, os.PathLike)) else array_of(image, "image")
        if given.ndim == 2 or (given.ndim == 3 and given.shape[2] == 1):
            given = np.repeat(given.reshape(given.shape[0], given.shape[1], 1), 3, axis=2)
        name = _FORMATS.get((given.dtype.type, given.shape[2])) if given.ndim == 3 else None
        if name is None:
            raise refuse(
                "image",
                f"has the shape {given.shape} of {given.dtype}; bytes need 1, 3 or 4 channels, "
                "float32 needs 4",
            )
        if given.dtype == np.float32:
            check_range(finite(given, "image"), "image")
        self.image = np.ascontiguousarray(given)
        self.filter = filter
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
        sampler.wrap_s, sampler.wrap_t = (getattr(lib, _WRAPS[name]) for name in self.wrap)
        sampler.border = [1.0, 1.0, 1.0, 1.0]
        nearest = self.filter == "nearest"
        sampler.magnify = lib.GN_MAGNIFY_NEAREST if nearest else lib.GN_MAGNIFY_LINEAR
        sampler.minify = {
            "nearest": lib.GN_MINIFY_NEAREST,
            "linear": lib.GN_MINIFY_LINEAR,
            "trilinear": lib.GN_MINIFY_LINEAR_MIPMAP_LINEAR,
        }[self.filter]


@dataclass
class Material:
    """Maps and highlights of the lit shaders (gnomon/light.h). All maps share one filter.

    Maps need the mesh's texcoords; all but `diffuse` need its normals; with `tangent_space`,
    `normal` needs its tangents. `specular` is the colour by which `specular_map` is multiplied. A
    material that is `unlit` is drawn by the shader of that name if `render` is given no shader.
    """

    diffuse: Optional[Texture] = None
    normal: Optional[Texture] = None
    specular_map: Optional[Texture] = None
    glow: Optional[Texture] = None
    tangent_space: bool = False
    specular: Tuple[float, float, float] = (0.0, 0.0, 0.0)
    exponent: int = 32
    bands: int = 4
    unlit: bool = False

    def check_mesh(self, mesh: Mesh, name: str) -> None:
        """Refuses maps that cannot be drawn on a mesh. `name` is the argument's, for the words."""
        for kind in ("diffuse", "normal", "specular_map", "glow"):
            texture = getattr(self, kind)
            if texture is None:
                continue
            instance(texture, f"material.{kind}", Texture)
            needs = {"texcoords": mesh.texcoords}
            if kind != "diffuse":
                needs["normals"] = mesh.normals
            if kind == "normal" and flag(self.tangent_space, "tangent_space"):
                needs["tangents"] = mesh.tangents
            for attribute, array in needs.items():
                if array is None and len(mesh.vertices):
                    what = name if name == "texture" else f"material.{kind}"
                    raise refuse(what, f"needs {attribute}, for each vertex of the mesh")

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
            lib.GN_NORMAL_OF_TANGENTS
            if flag(self.tangent_space, "tangent_space")
            else lib.GN_NORMAL_OF_MODEL
        )
        light_to_c(self.specular, "specular", material.specular)
        if self.specular_map is not None and not np.any(self.specular):
            raise refuse("material", "its specular_map is multiplied by specular, which is 0")
        for name in ("exponent", "bands"):
            setattr(material, name, integer(getattr(self, name), name, 0, 2**32 - 1))
