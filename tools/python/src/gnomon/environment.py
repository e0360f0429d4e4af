"""The floating-point environment that the library needs."""

from __future__ import annotations

from functools import wraps
from typing import Any, Callable, TypeVar, cast

from ._native import ffi, lib

Function = TypeVar("Function", bound=Callable[..., Any])


def exact(function: Function) -> Function:
    """Runs a function with denormal numbers kept and rounding to nearest.

    A program may have loaded code, compiled with -ffast-math, that set its threads to flush
    denormal numbers to zero. The thread's own environment is restored afterwards.
    """

    @wraps(function)
    def run(*arguments: Any, **named: Any) -> Any:
        environment = ffi.new("char[]", lib.VIEWS_ENVIRONMENT)
        lib.views_enter(environment)
        try:
            return function(*arguments, **named)
        finally:
            lib.views_leave(environment)

    return cast(Function, run)
