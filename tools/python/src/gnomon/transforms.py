"""Transforms: matrices together with their inverses, both from formulas, none inverted numerically.

Matrices are numpy arrays of shape (4, 4) that multiply column vectors. The contracts, with bounds of
the errors, are those of the C functions of the same names (gnomon/transform.h, projection.h).
"""

from __future__ import annotations

import math
from typing import Any, Callable, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from ._native import ffi, lib
from .arrays import Floats, array_of, choice, flag, instance, integer, matrix_of, matrix_to_c
from .arrays import numbers, pointer, real, shaped, vector, vector_to_c
from .environment import exact
from .errors import check, refuse

CONVENTIONS = ("rh_no", "rh_zo", "lh_no", "lh_zo")
Vector = Union[Sequence[float], npt.NDArray[Any]]


class Transform:
    """A matrix and its inverse.

    `a @ b` is b followed by a. `~a` exchanges matrix and inverse. To numpy a transform is
    its matrix: `np.array(a)`.
    """

    __slots__ = ("matrix", "inverse")

    def __init__(self, matrix: Any, inverse: Any) -> None:
        """Takes both matrices as they are; the functions below make them."""
        self.matrix: Floats = shaped(matrix, "matrix", [4, 4])
        self.inverse: Floats = shaped(inverse, "inverse", [4, 4])

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> npt.NDArray[Any]:
        if copy is False:
            if dtype is not None and np.dtype(dtype) != self.matrix.dtype:
                raise ValueError("a Transform is float32; another type needs a copy")
            return self.matrix
        return np.array(self.matrix, dtype)

    def __matmul__(self, other: Transform) -> Transform:
        instance(other, "a @ b", Transform)
        a, b = _to_c(self), _to_c(other)
        return _made("a @ b", lambda result: lib.gn_transform_compose(a, b, result))

    def __invert__(self) -> Transform:
        return Transform(self.inverse, self.matrix)

    def __repr__(self) -> str:
        return f"Transform(matrix={self.matrix.tolist()}, inverse={self.inverse.tolist()})"

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, Transform)
            and bool(np.array_equal(self.matrix, other.matrix))
            and bool(np.array_equal(self.inverse, other.inverse))
        )

    __hash__ = None  # type: ignore[assignment]

    def normal_matrix(self) -> Floats:
        """Returns the matrix of shape (3, 3) that takes normals to the transformed surface's."""
        result = ffi.new("gn_mat3 *")
        check(lib.gn_transform_normal_matrix(_to_c(self), result), "normal_matrix")
        return matrix_of(result[0], 3)

    def points(self, points: Any) -> Floats:
        """Returns the matrix times (x, y, z, 1) for points of shape (n, 3), without w."""
        return self._packed(lib.gn_mat4_transform_point_packed, points, "points")

    def directions(self, directions: Any) -> Floats:
        """Returns the matrix times (x, y, z, 0) for directions of shape (n, 3)."""
        return self._packed(lib.gn_mat4_transform_direction_packed, directions, "directions")

    @exact
    def _packed(self, function: Callable[..., Any], values: Any, name: str) -> Floats:
        given = shaped(values, name, [None, 3])
        result = np.empty_like(given)
        matrix = ffi.new("gn_mat4 *")
        matrix_to_c(self.matrix, matrix[0])
        status = function(
            matrix,
            ffi.cast("gn_vec3 *", pointer(given, "float[]")),
            ffi.cast("gn_vec3 *", pointer(result, "float[]")),
            len(given),
            lib.GN_BACKEND_AUTO,
        )
        check(status, name)
        return result


def _to_c(transform: Transform) -> Any:
    result = ffi.new("gn_transform *")
    matrix_to_c(transform.matrix, result.matrix)
    matrix_to_c(transform.inverse, result.inverse)
    return result


@exact
def _made(what: str, write: Callable[[Any], Any], fault: Optional[str] = None) -> Transform:
    result = ffi.new("gn_transform *")
    check(write(result), what, fault)
    return Transform(matrix_of(result.matrix, 4), matrix_of(result.inverse, 4))


def _vec3(value: Any, name: str) -> Any:
    result = ffi.new("gn_vec3 *")
    vector_to_c(value, name, result)
    return result[0]


def identity() -> Transform:
    """Returns the transform that changes nothing."""
    return _made("identity", lib.gn_transform_identity)


def translate(offset: Vector) -> Transform:
    """Returns the translation by an offset."""
    return _made("translate", lambda r: lib.gn_translate(_vec3(offset, "offset"), r))


def scale(factors: Union[float, Vector]) -> Transform:
    """Returns the transform that multiplies x, y and z by factors, or all of them by one."""
    three = factors if np.ndim(array_of(factors, "factors")) else [real(factors, "factors")] * 3
    return _made("scale", lambda r: lib.gn_scale(_vec3(three, "factors"), r))


def rotate_x(radians: float) -> Transform:
    """Returns the rotation about the x axis; by pi/2 it takes y to z."""
    angle = real(radians, "radians")
    return _made("rotate_x", lambda r: lib.gn_rotate_x(angle, r))


def rotate_y(radians: float) -> Transform:
    """Returns the rotation about the y axis; by pi/2 it takes z to x."""
    angle = real(radians, "radians")
    return _made("rotate_y", lambda r: lib.gn_rotate_y(angle, r))


def rotate_z(radians: float) -> Transform:
    """Returns the rotation about the z axis; by pi/2 it takes x to y."""
    angle = real(radians, "radians")
    return _made("rotate_z", lambda r: lib.gn_rotate_z(angle, r))


def rotate_axis(axis: Vector, radians: float) -> Transform:
    """Returns the rotation about an axis through the origin, of any length but zero."""
    angle = real(radians, "radians")
    return _made("rotate_axis", lambda r: lib.gn_rotate_axis(_vec3(axis, "axis"), angle, r))


def affine(linear: Any, offset: Vector = (0.0, 0.0, 0.0)) -> Transform:
    """Returns the map linear * v + offset; `linear` has the shape (3, 3)."""
    upper_left = ffi.new("gn_mat3 *")
    matrix_to_c(shaped(linear, "linear", [3, 3]), upper_left[0])
    return _made("affine", lambda r: lib.gn_affine(upper_left, _vec3(offset, "offset"), r))


def trs(translation: Vector, rotation: Any, factors: Vector) -> Transform:
    """Returns T R S: points are scaled, then turned by a matrix of shape (3, 3), then moved."""
    turn = ffi.new("gn_mat3 *")
    matrix_to_c(shaped(rotation, "rotation", [3, 3]), turn[0])
    offset, three = _vec3(translation, "translation"), _vec3(factors, "factors")
    return _made("trs", lambda r: lib.gn_trs(offset, turn, three, r))


def look_at(eye: Vector, target: Vector, up: Vector, handedness: str = "rh") -> Transform:
    """Returns the view of a camera at the eye that looks at the target."""
    choice(handedness, "handedness", ("rh", "lh"))
    function = lib.gn_look_at_rh if handedness == "rh" else lib.gn_look_at_lh
    arguments = _vec3(eye, "eye"), _vec3(target, "target"), _vec3(up, "up")
    return _made("look_at", lambda r: function(*arguments, r))


def _reals(**named: Any) -> Tuple[float, ...]:
    """Returns numbers, whose names are the arguments', as floats."""
    return tuple(real(value, name) for name, value in named.items())


def _family(name: str, convention: str, is_reversed: bool, is_infinite: bool) -> Any:
    choice(convention, "convention", CONVENTIONS)
    is_reversed = flag(is_reversed, "reversed_depth")
    endings = ("_infinite" if is_infinite else "") + ("_reversed" if is_reversed else "")
    return getattr(lib, f"gn_{name}_{convention}{endings}")


def perspective(
    fov_y: float,
    aspect: float,
    near: float,
    far: float = math.inf,
    convention: str = "rh_no",
    reversed_depth: bool = False,
) -> Transform:
    """Returns the perspective projection with a vertical field of view in radians.

    `convention` is one of CONVENTIONS: the view space's handedness and the depths of clip space.
    """
    fov_y, aspect, near, far = _reals(fov_y=fov_y, aspect=aspect, near=near, far=far)
    infinite = math.isinf(far)
    function = _family("perspective", convention, reversed_depth, infinite)
    distances = (near,) if infinite else (near, far)
    fault = lib.gn_perspective_fault(fov_y, aspect, near, far)
    text = None if fault == ffi.NULL else ffi.string(fault).decode()
    return _made("perspective", lambda r: function(fov_y, aspect, *distances, r), text)


def frustum(
    left: float,
    right: float,
    bottom: float,
    top: float,
    near: float,
    far: float = math.inf,
    convention: str = "rh_no",
    reversed_depth: bool = False,
) -> Transform:
    """Returns the perspective projection through a rectangle at the near distance."""
    box = _reals(left=left, right=right, bottom=bottom, top=top)
    near, far = _reals(near=near, far=far)
    infinite = math.isinf(far)
    function = _family("frustum", convention, reversed_depth, infinite)
    distances = (near,) if infinite else (near, far)
    return _made("frustum", lambda r: function(*box, *distances, r))


def orthographic(
    left: float,
    right: float,
    bottom: float,
    top: float,
    near: float,
    far: float,
    convention: str = "rh_no",
    reversed_depth: bool = False,
) -> Transform:
    """Returns the parallel projection of a box."""
    box = _reals(left=left, right=right, bottom=bottom, top=top, near=near, far=far)
    function = _family("orthographic", convention, reversed_depth, False)
    return _made("orthographic", lambda r: function(*box, r))


def viewport(
    x: float, y: float, width: float, height: float, depth: str = "no", y_down: bool = False
) -> Transform:
    """Returns the map from normalised device coordinates to the window and depths of 0 to 1."""
    choice(depth, "depth", ("no", "zo"))
    place = _reals(x=x, y=y, width=width, height=height)
    function = getattr(lib, f"gn_viewport_{depth}{'_y_down' if flag(y_down, 'y_down') else ''}")
    return _made("viewport", lambda r: function(*place, 0.0, 1.0, r))


@exact
def intrinsics(K: Any, width: int, height: int, near: float, far: float) -> Transform:
    """Returns the projection of a camera with the intrinsic matrix K, as OpenCV defines it.

    The camera looks along +z, x points to the right of the picture and y down. The centre of the
    pixel in column i and row j has the coordinates (i, j). Both matrices are computed in double
    precision and rounded once.
    """
    given = numbers(K, "K").astype(np.float64)
    if given.shape != (3, 3):
        raise refuse("K", f"has the shape {given.shape}, not (3, 3)")
    k = [[float(v) for v in row] for row in given]
    if not all(math.isfinite(v) for row in k for v in row):
        raise refuse("K", "has a number that is not finite")
    if k[1][0] != 0 or k[2] != [0, 0, 1] or k[0][0] == 0 or k[1][1] == 0:
        raise refuse("K", "is not [[fx, s, cx], [0, fy, cy], [0, 0, 1]] with fx and fy not 0")
    width = integer(width, "width", 1, 2**31 - 1)
    height = integer(height, "height", 1, 2**31 - 1)
    near, far = _reals(near=near, far=far)
    if not 0 < near < far < math.inf:
        raise refuse("intrinsics", "needs 0 < near < far, both finite")
    a, s, b = 2 * k[0][0] / width, 2 * k[0][1] / width, -2 * k[1][1] / height
    u, v = (2 * k[0][2] + 1) / width - 1, 1 - (2 * k[1][2] + 1) / height
    c, d = (far + near) / (far - near), -2 * far * near / (far - near)
    matrix = [[a, s, u, 0], [0, b, v, 0], [0, 0, c, d], [0, 0, 1, 0]]
    inverse = [
        [1 / a, -s / (a * b), 0, (s * v / b - u) / a],
        [0, 1 / b, 0, -v / b],
        [0, 0, 0, 1],
        [0, 0, 1 / d, -c / d],
    ]
    return Transform(np.array(matrix, np.float32), np.array(inverse, np.float32))


def rotation_matrix(axis: Vector, radians: float) -> Floats:
    """Returns the upper-left 3x3 of rotate_axis, for trs."""
    return np.ascontiguousarray(rotate_axis(vector(axis, "axis"), radians).matrix[:3, :3])
