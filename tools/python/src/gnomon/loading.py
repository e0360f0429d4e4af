"""Reads models: OBJ with MTL, PLY, STL and glTF 2.0, with the C readers of the command."""

from __future__ import annotations

import os
import warnings
from typing import Any, List, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from ._native import ffi, lib
from .arrays import Array, flag, integer, real
from .environment import exact
from .errors import Error, ModelWarning, refuse
from .lights import Light
from .materials import Materials, drawable
from .models import Lines, Model, Points
from .scene import Mesh


def load(
    path: Union[str, os.PathLike[str]],
    *,
    textures: bool = True,
    crease: float = 40.0,
    memory: int = 2**31,
) -> Model:
    """Reads a model: .obj with its .mtl, .ply, .stl, .gltf or .glb.

    textures  whether to read the images that materials name, with Pillow; they may be BMP, JPEG,
              PNG, PPM or TGA, beside the model or inside it
    crease    degrees, 0 to 180, for normals that the file does not have: where two triangles meet and
              turn by more, the edge stays sharp, and its vertices are doubled; 180 keeps every
              vertex of the file as it is
    memory    bytes: the most that the reader allocates, that the files have together and that the
              images have as texels

    Vertices are float32, or float64 if the model is far from the origin, as on maps. Normals that
    the file does not have are computed from the triangles. Colours are the material's times the
    vertex's. Raises Error, which names the file and the place in it, for what cannot be read, and
    OSError if the file cannot be opened. What is drawn differently from what the file says is a
    ModelWarning, and is in the result's `warnings`.
    """
    if not isinstance(path, (str, bytes, os.PathLike)):
        raise refuse("path", f"is of {type(path).__name__}, not a path")
    flag(textures, "textures")
    name = os.fsdecode(path)
    crease = real(crease, "crease")
    if not 0.0 <= crease <= 180.0:
        raise refuse("crease", f"is {crease}, not 0 to 180 degrees")
    contents = _contents(name, integer(memory, "memory", 1, 2**63 - 1))
    model = _read(name, contents, textures, crease, memory)
    for text in model.warnings:
        warnings.warn(text, ModelWarning, stacklevel=2)
    return model


def _contents(name: str, memory: int) -> bytes:
    with open(name, "rb") as file:
        if os.fstat(file.fileno()).st_size > memory:
            raise _too_large(name, memory)
        return file.read()


def _too_large(name: str, memory: int) -> Error:
    return refuse(name, f"needs more memory than {memory} bytes; memory= allows more")


def _words(text: Any) -> str:
    words: str = ffi.string(text).decode("utf-8", "replace")
    return words


@exact
def _read(name: str, contents: bytes, textures: bool, crease: float, memory: int) -> Model:
    path = os.fsencode(name.replace(os.sep, "/"))
    data = ffi.from_buffer("uint8_t[]", contents)
    read = lib.load_model(path, data, len(contents), memory, crease)
    if read == ffi.NULL:
        raise MemoryError(name)
    try:
        if read.is_memory_fault:
            raise _too_large(name, memory)
        if read.fault != ffi.NULL:
            raise refuse(_words(read.fault_file), _words(read.fault))
        return _Builder(name, read, textures, memory).model()
    finally:
        lib.load_free(read)


class _Builder:
    """Copies what was read to arrays."""

    def __init__(self, name: str, read: Any, textures: bool, memory: int) -> None:
        self._name = name
        self._model = read.model
        self._origin = np.array(list(read.model.origin))
        self._warnings = [_warning(read.warnings[i]) for i in range(read.warning_count)]
        self._materials = Materials(name, read.model, textures, memory, self._warn)

    def _warn(self, text: str) -> None:
        words = f"{self._name}: {text}"
        if words not in self._warnings:
            self._warnings.append(words)

    def model(self) -> Model:
        """Returns the model. Its lists are in the order of the file."""
        parts = [self._model.parts[i] for i in range(self._model.part_count)]
        kinds = (lib.MODEL_TRIANGLES, lib.MODEL_POINTS, lib.MODEL_LINES)
        triangles, points, lines = ([p for p in parts if p.kind == kind] for kind in kinds)
        return Model(
            [self._mesh(part) for part in triangles],
            self._points(points) if points else None,
            self._lines(lines) if lines else None,
            self._lights(),
            self._warnings,
        )

    def _vertices(self, part: Any) -> Array:
        positions = _array(part.positions, part.vertex_count, 3)
        result: Array = positions + self._origin if self._origin.any() else positions
        return result

    def _colors(self, part: Any) -> Array:
        return drawable(_array(part.colors, part.vertex_count, 4), self._warn)

    def _mesh(self, part: Any) -> Mesh:
        count = part.vertex_count
        return Mesh(
            self._vertices(part),
            _indices(part, 3),
            normals=_array(part.normals, count, 3),
            colors=self._colors(part),
            texcoords=_array(part.texcoords, count, 2) if part.has_texcoords else None,
            tangents=_array(part.tangents, count, 4) if part.has_tangents else None,
            material=self._materials.of_part(part),
        )

    def _points(self, parts: List[Any]) -> Points:
        used = [_indices(part, 1).reshape(-1) for part in parts]
        normals: Optional[Array] = None
        if all(part.has_normals for part in parts):
            normals = np.concatenate(
                [_array(p.normals, p.vertex_count, 3)[i] for p, i in zip(parts, used)]
            )
        return Points(
            np.concatenate([self._vertices(part)[i] for part, i in zip(parts, used)]),
            np.concatenate([self._colors(part)[i] for part, i in zip(parts, used)]),
            normals,
        )

    def _lines(self, parts: List[Any]) -> Lines:
        starts = np.cumsum([0] + [part.vertex_count for part in parts[:-1]])
        if int(starts[-1]) + parts[-1].vertex_count > 2**32:
            raise refuse(self._name, "its lines have more than 2^32 vertices")
        segments = [_indices(part, 2) + np.uint32(start) for part, start in zip(parts, starts)]
        return Lines(
            np.concatenate([self._vertices(part) for part in parts]),
            np.concatenate(segments),
            np.concatenate([self._colors(part) for part in parts]),
        )

    def _lights(self) -> List[Light]:
        result = []
        for i in range(self._model.light_count):
            light = self._model.lights[i]
            color: Tuple[float, ...] = tuple(light.color)
            towards = [-x for x in light.direction]
            if light.kind == lib.GN_LIGHT_DIRECTIONAL:
                result.append(Light(direction=towards, ambient=(0.0, 0.0, 0.0), diffuse=color))
                continue
            # The intensity of a glTF's light is divided by the square of the distance.
            is_spot = light.kind == lib.GN_LIGHT_SPOT
            lamp = Light(
                direction=towards if is_spot else None,
                position=list(light.position),
                ambient=(0.0, 0.0, 0.0),
                diffuse=color,
                attenuation=(0.0, 0.0, 1.0),
                range=light.range,
            )
            if is_spot:
                lamp.cone = light.inner, light.outer
            result.append(lamp)
        return result


def _warning(given: Any) -> str:
    times = f" ({given.count} times)" if given.count > 1 else ""
    return f"{_words(given.file)}: {_words(given.text)}{times}"


def _array(floats: Any, count: int, columns: int) -> Array:
    """Returns a copy of C's array of floats."""
    if not count:
        return np.zeros((0, columns), np.float32)
    numbers = np.frombuffer(ffi.buffer(floats, 4 * count * columns), np.float32)
    return numbers.reshape(count, columns).copy()


def _indices(part: Any, columns: int) -> npt.NDArray[np.uint32]:
    size = 4 * part.index_count
    if not size:
        return np.zeros((0, columns), np.uint32)
    indices = np.frombuffer(ffi.buffer(part.indices, size), np.uint32)
    return indices.reshape(-1, columns).copy()
