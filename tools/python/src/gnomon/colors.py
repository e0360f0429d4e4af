"""Colours: bytes are of uint8, floats go from 0 to 1, and no other type can be told apart."""

from __future__ import annotations

from typing import Any

import numpy as np

from .arrays import Array, Floats, array_of, numbers, vector, vector_to_c
from .errors import refuse

# Rounding takes results such as interpolated colours a little beyond 0 to 1. Half a step of a byte
# is drawn as 0 or 1 is.
_BEYOND = 0.5 / 255


def check_range(colors: Array, name: str) -> None:
    """Refuses finite floats that are not 0 to 1, as bytes that became floats are."""
    for number in (colors.min(), colors.max()) if colors.size else ():
        if not -_BEYOND <= number <= 1 + _BEYOND:
            raise refuse(name, f"has {number!s}, not 0 to 1; bytes are of uint8")


def floats_of(value: Any, name: str) -> Array:
    """Returns an array of floats, in which the byte 255 is 1.

    Integers of other types may mean bytes, numbers of 16 bits or floats, so they are refused. Only
    lists of Python's 0 and 1 cannot be mistaken.
    """
    given = array_of(value, name)
    if given.dtype == np.uint8:
        return given / np.float32(255)
    is_list = not hasattr(value, "dtype")
    if is_list and given.dtype.kind in "iu" and np.isin(given, (0, 1)).all():
        return given.astype(np.float32)
    if given.dtype.kind in "biu":
        raise refuse(
            name, f"is of {given.dtype}; colours are bytes of uint8 or floats of 0 to 1, such as 1.0"
        )
    return numbers(given, name)


def color(value: Any, name: str, channels: int) -> Floats:
    """Returns one colour of 0 to 1 as float32."""
    result = vector(floats_of(value, name), name, channels)
    check_range(result, name)
    return result


def light_to_c(value: Any, name: str, target: Any) -> None:
    """Writes a colour of a light, which may be brighter than 1, to a gn_vec3."""
    vector_to_c(floats_of(value, name), name, target)
