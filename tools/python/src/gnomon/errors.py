"""Errors: the library's statuses and words as one exception."""

from __future__ import annotations

from typing import Any, Optional

from ._native import ffi, lib


class Error(ValueError):
    """The library refused what it was given.

    `status` is the name of the library's status, such as "GN_INDEX_OUT_OF_RANGE".
    """

    def __init__(self, status: str, text: str) -> None:
        super().__init__(text)
        self.status = status


class ModelWarning(UserWarning):
    """Something in a model file is drawn differently from what the file says."""


class EmptyWarning(UserWarning):
    """Nothing is drawn, which is hardly ever meant."""


def words(text: Any) -> Optional[str]:
    """Returns C's string, or None for a null pointer."""
    return None if text == ffi.NULL else ffi.string(text).decode()


def check(status: int, what: str, fault: Optional[str] = None) -> None:
    """Raises Error unless the status is GN_OK. `fault` names the field, if the library knows it."""
    if status != lib.GN_OK:
        name = ffi.typeof("gn_status").elements[status]
        raise Error(name, f"{what}: {fault or words(lib.gn_status_text(status))}")


def refuse(what: str, fault: str) -> Error:
    """Returns the exception for an argument that the package itself refuses."""
    return Error("GN_OUT_OF_RANGE", f"{what}: {fault}")
