"""Materials of models: what the shaders draw of a part's surface and maps."""

from __future__ import annotations

import os
from typing import Any, Callable, Dict, Optional, Set, Tuple

import numpy as np

from ._native import ffi, lib
from .arrays import Floats
from .errors import refuse
from .images import Bytes, ImageFault, decode, has_alpha, is_grey, times
from .scene import Material, Mesh, Texture, Wrap

Warn = Callable[[str], None]

# gn_wrap.
_WRAPS = {
    lib.GN_WRAP_REPEAT: "repeat",
    lib.GN_WRAP_CLAMP_TO_EDGE: "clamp",
    lib.GN_WRAP_MIRRORED_REPEAT: "mirror",
    lib.GN_WRAP_CLAMP_TO_BORDER: "border",
}
_DRAWN = {
    lib.MAP_DIFFUSE: "diffuse",
    lib.MAP_NORMAL: "normal",
    lib.MAP_SPECULAR: "specular",
    lib.MAP_GLOW: "glow",
}
_NOT_DRAWN = {
    lib.MAP_OPACITY: "opacity",
    lib.MAP_ROUGHNESS: "roughness",
    lib.MAP_OCCLUSION: "occlusion",
}


class Materials:
    """Makes the materials of one model. Parts share the textures of images that they share."""

    def __init__(self, path: str, model: Any, textures: bool, memory: int, warn: Warn) -> None:
        self._path = path
        self._model = model
        self._reads = textures
        self._left = memory
        self._warn = warn
        self._images: Dict[int, Bytes] = {}
        self._textures: Dict[Tuple[Any, ...], Texture] = {}

    def of_part(self, part: Any) -> Material:
        """Returns the material of a model_part."""
        surface, shine = part.surface, part.surface.shine
        self._warn_of_alpha(surface.alpha)
        result = Material(
            specular=(shine.specular[0], shine.specular[1], shine.specular[2]),
            exponent=shine.exponent,
            unlit=bool(surface.is_unlit),
        )
        maps = self._maps(part)
        if any(surface.emissive) and not surface.is_unlit and lib.MAP_GLOW not in maps:
            self._warn("the light that a material gives off is drawn only with a map of it")
        first = min(maps, default=None)
        for kind in sorted(maps):
            wrap, other = self._wrap(part.maps[kind]), self._wrap(part.maps[first])
            if wrap != other:
                what = f"its {_DRAWN[kind]} map repeats otherwise than its first map"
                self._warn(f"{what}; it is drawn as that")
            texture = self._texture(part, kind, part.maps[first], other)
            if texture is not None:
                name = "specular_map" if kind == lib.MAP_SPECULAR else _DRAWN[kind]
                setattr(result, name, texture)
        result.tangent_space = result.normal is not None
        return result

    def _warn_of_alpha(self, alpha: int) -> None:
        if alpha == lib.MODEL_BLEND:
            self._warn("its translucent parts are drawn without blending")
        elif alpha == lib.MODEL_MASK:
            self._warn("parts that alpha cuts out are drawn whole")

    def _maps(self, part: Any) -> Set[int]:
        """Returns the kinds of the part's maps that are drawn."""
        named = {i for i in range(lib.MAP_COUNT) if part.maps[i].image < self._model.image_count}
        if not self._reads or not part.has_texcoords:
            return set()
        for kind in sorted(named & set(_NOT_DRAWN)):
            self._warn(f"its {_NOT_DRAWN[kind]} map is not drawn")
        drawn = named & set(_DRAWN)
        if lib.MAP_NORMAL in drawn and not part.has_tangents:
            self._warn("its normal map is not drawn: there are no tangents")
            drawn.remove(lib.MAP_NORMAL)
        if not any(part.surface.shine.specular):
            drawn.discard(lib.MAP_SPECULAR)
        if not any(part.surface.emissive):
            drawn.discard(lib.MAP_GLOW)
        return drawn

    @staticmethod
    def _wrap(named: Any) -> Wrap:
        return _WRAPS.get(named.wrap_s, "clamp"), _WRAPS.get(named.wrap_t, "clamp")

    @staticmethod
    def _filter(named: Any) -> str:
        """Returns the filter of a map; a Texture has one for both directions."""
        if named.has_filters and named.magnify == lib.GN_MAGNIFY_NEAREST:
            return "nearest"
        plain = (lib.GN_MINIFY_NEAREST, lib.GN_MINIFY_LINEAR)
        return "linear" if named.has_filters and named.minify in plain else "trilinear"

    def _texture(self, part: Any, kind: int, sampled: Any, wrap: Wrap) -> Optional[Texture]:
        """Returns the texture of a map, with the filter and the wrap of the map `sampled`."""
        number = part.maps[kind].image
        image = self._image(number)
        if kind == lib.MAP_NORMAL and is_grey(image):
            self._warn(f"its bump map {self._name(number)} holds heights, which are not drawn")
            return None
        says_opacity = part.maps[kind].has_opacity
        if kind == lib.MAP_DIFFUSE and not says_opacity and has_alpha(image):
            words = "alpha in its diffuse map is not drawn: the material names no map of opacity"
            self._warn(words)
        has_opacity = says_opacity and part.surface.alpha != lib.MODEL_OPAQUE
        glow = tuple(part.surface.emissive) if kind == lib.MAP_GLOW else (1.0, 1.0, 1.0)
        key = (number, self._filter(sampled), wrap, has_opacity, glow)
        if key not in self._textures:
            if image.ndim == 3 and not has_opacity:
                image = image[..., :3]
            if glow != (1.0, 1.0, 1.0):
                image = times(image, glow)
            self._textures[key] = Texture(image, self._filter(sampled), wrap)
        return self._textures[key]

    def _name(self, number: int) -> str:
        return os.fsdecode(ffi.string(self._model.images[number].name))

    def _image(self, number: int) -> Bytes:
        if number not in self._images:
            named = self._model.images[number]
            name = self._name(number)
            # Some exporters write backslashes.
            beside = os.path.join(os.path.dirname(self._path), name.replace("\\", "/"))
            inside = bytes(ffi.buffer(named.bytes, named.size)) if named.bytes != ffi.NULL else None
            try:
                image = decode(beside if inside is None else inside, self._left)
            except ImageFault as fault:
                words = f"its texture '{name}' {fault}; textures=False goes on without it"
                raise refuse(self._path, words) from None
            self._left -= image.nbytes
            self._images[number] = image
        return self._images[number]


def drawable(colors: Floats, warn: Warn) -> Floats:
    """Returns colours as a Mesh takes them."""
    if colors.size and (colors.min() < 0 or colors.max() > 1):
        warn("colours beyond 0 to 1 are cut off")
        return np.clip(colors, np.float32(0), np.float32(1))
    return colors
