"""Arrays as the library takes them: checked, contiguous, and converted only where they must be."""

from __future__ import annotations

from typing import Any, Sequence, Tuple

import numpy as np
import numpy.typing as npt

from ._native import ffi
from .errors import refuse

Floats = npt.NDArray[np.float32]
Shape = Tuple[int, ...]


def shaped(value: Any, name: str, shape: Sequence[Any]) -> Floats:
    """Returns an array of float32 with the given shape, in which None fits any length.

    A contiguous array of float32 is returned as it is.
    """
    try:
        array = np.ascontiguousarray(value, dtype=np.float32)
    except (TypeError, ValueError):
        raise refuse(name, "is no array of numbers") from None
    fits = array.ndim == len(shape) and all(
        wanted is None or size == wanted for size, wanted in zip(array.shape, shape)
    )
    if not fits:
        wanted_text = ", ".join("any" if n is None else str(n) for n in shape)
        raise refuse(name, f"has the shape {array.shape}, not ({wanted_text})")
    return array


def vector(value: Any, name: str, size: int = 3) -> Floats:
    """Returns a vector of float32."""
    return shaped(value, name, [size])


def pointer(array: npt.NDArray[Any], c_type: str) -> Any:
    """Returns a C pointer to the memory of a contiguous array, which keeps the array alive."""
    return ffi.from_buffer(c_type, array)


def matrix_to_c(matrix: Floats, target: Any) -> None:
    """Writes a square matrix to a gn_mat3 or gn_mat4, whose columns follow one another."""
    ffi.memmove(ffi.addressof(target), np.ascontiguousarray(matrix.T), matrix.nbytes)


def matrix_of(source: Any, size: int) -> Floats:
    """Returns the matrix in a gn_mat3 or gn_mat4."""
    numbers = np.frombuffer(ffi.buffer(ffi.addressof(source)), dtype=np.float32)
    return np.ascontiguousarray(numbers.reshape(size, size).T)


def vector_to_c(value: Any, name: str, target: Any) -> None:
    """Writes a vector of three numbers to a gn_vec3."""
    target.x, target.y, target.z = (float(v) for v in vector(value, name))
