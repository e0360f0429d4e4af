"""Arrays as the library takes them: checked, contiguous, and converted only where they must be."""

from __future__ import annotations

import operator
from typing import Any, Iterable, Optional, Sequence, Tuple

import numpy as np
import numpy.typing as npt

from ._native import ffi
from .errors import Error, refuse

Array = npt.NDArray[Any]
Floats = npt.NDArray[np.float32]
Doubles = npt.NDArray[np.float64]
Shape = Tuple[int, ...]


def array_of(value: Any, name: str) -> Array:
    """Returns an array of any type. Rows of different lengths and masked numbers are refused."""
    try:
        array = np.asarray(value)
    except ValueError:
        raise refuse(name, "is no array of numbers: its rows have different lengths") from None
    except TypeError:
        raise refuse(name, f"is of {type(value).__name__}, not an array of numbers") from None
    if isinstance(value, np.ma.MaskedArray) and np.any(value.mask):
        raise refuse(name, "has masked numbers")
    return array


def numbers(value: Any, name: str) -> Array:
    """Returns an array of integers or floats; other types, booleans among them, are refused."""
    array = array_of(value, name)
    try:
        if array.dtype.kind == "O":
            array = array.astype(np.float64)
    except (TypeError, ValueError, OverflowError):
        raise refuse(name, "is no array of numbers") from None
    if array.dtype.kind not in "iuf":
        raise refuse(name, f"is no array of numbers: it is of {array.dtype}")
    return array


def fitting(array: Array, name: str, shape: Sequence[Any]) -> Array:
    """Returns the array if it has the given shape, in which None fits any length."""
    fits = array.ndim == len(shape) and all(
        wanted is None or size == wanted for size, wanted in zip(array.shape, shape)
    )
    if not fits:
        wanted_text = ", ".join("any" if n is None else str(n) for n in shape)
        raise refuse(name, f"has the shape {array.shape}, not ({wanted_text})")
    return array


def narrow(array: Array, name: str, used: Optional[npt.NDArray[np.bool_]] = None) -> Floats:
    """Returns a contiguous array of float32; one that is such an array is returned as it is.

    Finite numbers that would become infinite are refused, in all rows or in those `used`.
    """
    with np.errstate(over="ignore"):
        result = np.ascontiguousarray(array, dtype=np.float32)
    if array.dtype != np.float32:
        overflows = np.isinf(result) & np.isfinite(array)
        if (overflows if used is None else overflows[used]).any():
            raise refuse(name, "has a number that float32 cannot hold")
    return result


def shaped(value: Any, name: str, shape: Sequence[Any]) -> Floats:
    """Returns an array of float32 with the given shape, in which None fits any length.

    A contiguous array of float32 is returned as it is.
    """
    return narrow(fitting(numbers(value, name), name, shape), name)


def finite(array: Array, name: str) -> Array:
    """Returns the array if all its numbers are finite."""
    if not np.isfinite(array).all():
        raise Error("GN_NOT_FINITE", f"{name}: has a number that is not finite")
    return array


def finite_rows(array: Array, name: str, used: Optional[npt.NDArray[np.bool_]]) -> None:
    """Refuses numbers that are not finite, in all rows or in those `used`."""
    if np.isfinite(array).all():
        return
    rows = np.isfinite(array).all(axis=1)
    if used is not None:
        rows |= ~used
    if not rows.all():
        row = int(np.argmin(rows))
        raise Error("GN_NOT_FINITE", f"{name}: row {row} has a number that is not finite")


def vector(value: Any, name: str, size: int = 3) -> Floats:
    """Returns a vector of float32 whose numbers are finite."""
    result: Floats = finite(shaped(value, name, [size]), name)
    return result


def integer(value: Any, name: str, least: int, most: int) -> int:
    """Returns an integer of a range; floats and booleans are refused."""
    try:
        if isinstance(value, (bool, np.bool_)):
            raise TypeError
        number = operator.index(value)
    except TypeError:
        raise refuse(name, f"is {value!r}, not an integer") from None
    if not least <= number <= most:
        raise refuse(name, f"is {number}, not in {least} to {most}")
    return number


def real(value: Any, name: str) -> float:
    """Returns a number as a float; texts, booleans and arrays are refused."""
    try:
        if isinstance(value, (bool, np.bool_, str, bytes, bytearray)) or np.ndim(value):
            raise TypeError
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise refuse(name, f"is {value!r}, not a number") from None


def flag(value: Any, name: str) -> bool:
    """Returns True or False; other types are refused."""
    if not isinstance(value, (bool, np.bool_)):
        raise refuse(name, f"is {value!r}, not True or False")
    return bool(value)


def choice(value: Any, name: str, choices: Iterable[str]) -> str:
    """Returns one of several names; all else is refused."""
    known = list(choices)
    if not isinstance(value, str) or value not in known:
        raise refuse(name, f"is {value!r}, not one of {', '.join(known)}")
    return value


def instance(value: Any, name: str, wanted: type) -> None:
    """Refuses what is not an object of the wanted class."""
    if not isinstance(value, wanted):
        raise refuse(name, f"is of {type(value).__name__}, not {wanted.__name__}")


def pointer(array: Array, c_type: str) -> Any:
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
