"""Images of textures, decoded by Pillow: files, or bytes inside a model."""

from __future__ import annotations

import importlib
import io
import os
from typing import Any, Union

import numpy as np
import numpy.typing as npt

Bytes = npt.NDArray[np.uint8]

# Pillow knows more formats, some of which run other programs. Images are not trusted.
FORMATS = ("BMP", "JPEG", "PNG", "PPM", "TGA")


class ImageFault(Exception):
    """Why an image cannot be read, in words that follow its name."""


def decode(source: Union[str, bytes], most: int) -> Bytes:
    """Returns an image of 1, 3 or 4 channels, with its top row first, from a path or from bytes.

    `most` is the bytes that its texels may have.
    """
    if isinstance(source, str) and not os.path.isfile(source):
        problem = "it is not a regular file" if os.path.exists(source) else "there is no such file"
        raise ImageFault(f"cannot be read: {problem}")
    try:
        pillow: Any = importlib.import_module("PIL.Image")
    except ImportError:
        raise ImageFault("needs Pillow to be read (pip install pillow)") from None
    try:
        image = pillow.open(source if isinstance(source, str) else io.BytesIO(source), "r", FORMATS)
    except pillow.UnidentifiedImageError:
        raise ImageFault(f"is none of {', '.join(FORMATS)}") from None
    except (OSError, pillow.DecompressionBombError) as error:
        raise ImageFault(f"cannot be read: {error}") from None
    with image:
        if 4 * image.width * image.height > most:
            size = f"{image.width}x{image.height}"
            raise ImageFault(f"has {size} texels, more than the memory allows")
        try:
            return _texels(image)
        except (OSError, SyntaxError, ValueError, EOFError) as error:
            raise ImageFault(f"cannot be read: {error}") from None


def _texels(image: Any) -> Bytes:
    if image.mode.startswith("I"):
        # Grey of 16 bits, for which Pillow has several modes. 257 times a byte has the same colour.
        grey = np.asarray(image).astype(np.int64)
        return ((np.clip(grey, 0, 65535) + 128) // 257).astype(np.uint8)
    if image.mode in ("1", "L"):
        mode = "L"
    elif image.mode in ("LA", "La", "PA", "RGBA", "RGBa") or "transparency" in image.info:
        mode = "RGBA"
    else:
        mode = "RGB"
    return np.array(image.convert(mode), np.uint8)


def has_alpha(image: Bytes) -> bool:
    """Returns whether a texel is not opaque."""
    return image.ndim == 3 and image.shape[2] == 4 and bool((image[..., 3] < 255).any())


def is_grey(image: Bytes) -> bool:
    """Returns whether all texels are grey, as heights are and normals are not."""
    if image.ndim == 2:
        return True
    return bool((image[..., 0] == image[..., 1]).all() and (image[..., 1] == image[..., 2]).all())


def times(image: Bytes, factor: Any) -> Bytes:
    """Returns an image times a colour, as bytes of three channels."""
    colors = image[..., np.newaxis] if image.ndim == 2 else image[..., :3]
    product = np.clip(colors * np.asarray(factor, np.float64), 0.0, 255.0)
    return (product + 0.5).astype(np.uint8)
