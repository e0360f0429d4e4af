"""Cameras: the matrices that a caller gives, checked, as the library's."""

from __future__ import annotations

from typing import Any, Tuple

import numpy as np

from ._native import ffi, lib
from .arrays import Doubles, Floats, array_of, finite, matrix_to_c, narrow, numbers
from .errors import Error, check, refuse
from .placing import between_origins
from .transforms import Transform, intrinsics

# Of a matrix that was computed, numbers that should be 0 or 1 may differ by rounding.
_ROUNDING = 1e-6


def _matrices(value: Any, name: str) -> Doubles:
    """Returns an array of shape (n, 4, 4) of one or more matrices with 3 or 4 rows."""
    if isinstance(value, (list, tuple)):
        value = [item.matrix if isinstance(item, Transform) else item for item in value]
    given = value.matrix if isinstance(value, Transform) else numbers(value, name)
    one = given[None] if given.ndim == 2 else given
    if one.ndim != 3 or one.shape[1:] not in ((3, 4), (4, 4)):
        raise refuse(name, f"has the shape {given.shape}, not (4, 4), (3, 4) or n of these")
    finite(given, name)
    whole = np.zeros((len(one), 4, 4))
    whole[:, 3, 3] = 1
    whole[:, : one.shape[1]] = one
    return whole


def _text(row: Doubles) -> str:
    return " ".join(f"{number:g}" for number in row)


def affine_matrices(value: Any, name: str) -> Doubles:
    """Returns an array of shape (n, 4, 4) of matrices whose last row is 0 0 0 1."""
    whole = _matrices(value, name)
    wanted = np.array([0.0, 0.0, 0.0, 1.0])
    wrong = np.nonzero((np.abs(whole[:, 3] - wanted) > _ROUNDING).any(axis=1))[0]
    if len(wrong):
        which = name if len(whole) == 1 else f"{name}[{wrong[0]}]"
        row = _text(whole[wrong[0], 3])
        raise refuse(which, f"its last row is {row}, not 0 0 0 1; is it transposed?")
    whole[:, 3] = wanted
    return whole


def _projections(value: Any) -> Doubles:
    """Returns an array of shape (n, 4, 4) of perspective or parallel projections."""
    whole = _matrices(value, "projection")
    for n in range(len(whole)):
        matrix: Doubles = whole[n]
        fault = _projection_fault(matrix)
        if fault:
            raise refuse("projection" if len(whole) == 1 else f"projection[{n}]", fault)
    return whole


def _zeros(row: Doubles) -> Any:
    """Returns which numbers of a row are 0 apart from rounding."""
    return (np.abs(row) <= _ROUNDING * np.abs(row).max()).tolist()


def _is_perspective(projection: Doubles) -> bool:
    return bool(_zeros(projection[3]) == [True, True, False, True])


def _along(projection: Doubles) -> float:
    """Returns 1 if a projection looks along +z, -1 if along -z: w, or else z, grows with distance."""
    grows = projection[3, 2] if _is_perspective(projection) else projection[2, 2]
    return 1.0 if grows > 0 else -1.0


def _projection_fault(matrix: Doubles) -> str:
    """Returns what is wrong with a projection, or an empty text.

    Distances are calculated from z and w, so they must be functions of the distance alone.
    """
    z, w = matrix[2], matrix[3]
    is_perspective = _is_perspective(matrix)
    if not is_perspective and (_zeros(w) != [True, True, True, False] or w[3] < 0):
        return (
            f"its last row is {_text(w)}, which is neither 0 0 w 0 nor 0 0 0 w with w above 0; is it "
            "transposed? its view is the argument pose"
        )
    # The transposed matrix of a perspective has w's factor, 1 or -1, there.
    if is_perspective and abs(z[3]) == 1 and abs(w[2]) != 1:
        return f"its last rows are {_text(z)} and {_text(w)}; is it transposed?"
    if _zeros(z)[:2] != [True, True]:
        return f"its third row is {_text(z)}: depths depend on x or y; its view is the argument pose"
    # The derivative of (z2 d + z3) / (w2 d + w3), times the square of the denominator.
    if _along(matrix) * (z[2] * w[3] - z[3] * w[2]) <= 0:
        return "its depths do not grow with the distance; is it reversed?"
    return ""


def _is_several(value: Any, name: str) -> bool:
    """Returns whether an argument has several matrices, even if they are one."""
    if isinstance(value, (list, tuple)) and value and isinstance(value[0], Transform):
        return True
    return not isinstance(value, Transform) and array_of(value, name).ndim == 3


def _inverted(matrices: Doubles, name: str) -> Doubles:
    """Returns the inverses of affine matrices, from their cofactors. All sums are written out: the
    order of the sums of numpy's functions depends on the machine.
    """
    m, result = matrices[:, :3, :3], np.zeros_like(matrices)
    for i in range(3):
        for j in range(3):
            a, b, c, d = (i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3
            result[:, j, i] = m[:, a, c] * m[:, b, d] - m[:, a, d] * m[:, b, c]
    determinant = m[:, 0, 0] * result[:, 0, 0] + m[:, 0, 1] * result[:, 1, 0]
    determinant = determinant + m[:, 0, 2] * result[:, 2, 0]
    if not np.all(determinant):
        raise Error("GN_SINGULAR", f"{name}: has no inverse")
    result[:, :3, :3] /= determinant[:, None, None]
    x, y, z = (result[:, :3, i] * matrices[:, i, 3, None] for i in range(3))
    result[:, :3, 3] = -(x + y + z)
    result[:, 3, 3] = 1
    return result


def _axes(K: Any, projections: Floats) -> Doubles:
    """Returns the signs by which the axes of a camera that looks along -z with y up, as OpenGL's do,
    become those of K or of the projections.
    """
    if K is not None:
        return np.array([1.0, -1.0, -1.0])
    along = {_along(projection.astype(np.float64)) for projection in projections}
    if len(along) > 1:
        raise refuse("projection", "has matrices that look along +z and others along -z")
    return np.array([1.0, 1.0, -along.pop()])


def _poses(pose: Any, camera_pose: Any, axes: Doubles) -> Tuple[Doubles, Doubles]:
    """Returns the matrices from the world to the cameras, and the signs of the cameras' axes that
    normals in the camera's space have.
    """
    if camera_pose is None:
        return affine_matrices(np.eye(4) if pose is None else pose, "pose"), np.ones(3)
    if pose is not None:
        raise refuse("render", "takes pose, from the world, or camera_pose, to the world, not both")
    inverse = _inverted(affine_matrices(camera_pose, "camera_pose"), "camera_pose")
    inverse[:, :3] *= axes[:, None]
    return inverse, axes


def _reversed(projection: Transform, near: float, far: float) -> Floats:
    """Returns the matrix with depths from 1, near, to 0, far, which are precise at all distances."""
    matrix = projection.matrix.copy()
    matrix[2, 2], matrix[2, 3] = -near / (far - near), far * near / (far - near)
    return matrix


def _clip_spaces(
    K: Any, projection: Any, width: int, height: int, near: float, far: float
) -> Tuple[Floats, bool]:
    """Returns the projections, and whether they are several."""
    if K is None:
        projections = narrow(_projections(projection), "projection")
        return projections, _is_several(projection, "projection")
    given = numbers(K, "K").astype(np.float64)
    several = given if given.ndim == 3 else given[None]
    if not len(several):
        raise refuse("K", "has 0 matrices")
    matrices = [intrinsics(k, width, height, near, far) for k in several]
    near, far = float(near), float(far)
    return np.stack([_reversed(matrix, near, far) for matrix in matrices]), given.ndim == 3


def write_cameras(
    K: Any,
    pose: Any,
    camera_pose: Any,
    projection: Any,
    width: int,
    height: int,
    near: float,
    far: float,
    origin: Doubles,
) -> Tuple[Any, bool]:
    """Returns an array of views_camera, and whether the result is a batch.

    The cameras' coordinates in the world are relative to the origin.
    """
    if (K is None) == (projection is None):
        raise refuse("render", "needs K or projection, and takes one of them")
    projections, are_several = _clip_spaces(K, projection, width, height, near, far)
    given, axes = _poses(pose, camera_pose, _axes(K, projections))
    poses = narrow(between_origins(given, origin, np.zeros(3)), "pose")
    name, moved = ("pose", pose) if camera_pose is None else ("camera_pose", camera_pose)
    is_batch = are_several or (moved is not None and _is_several(moved, name))
    count = max(len(poses), len(projections)) if is_batch else 1
    for name, array in ((name, poses), ("K" if projection is None else "projection", projections)):
        if len(array) not in (1, count) or count == 0:
            raise refuse(name, f"has {len(array)} matrices for {count} cameras")
    cameras = ffi.new("views_camera[]", count)
    clip, view, inverse = ffi.new("gn_mat4 *"), ffi.new("gn_mat4 *"), ffi.new("gn_mat4 *")
    linear = ffi.new("gn_mat3 *")
    name = "pose" if camera_pose is None else "camera_pose"
    for n, camera in enumerate(cameras):
        eye_space = poses[n if len(poses) > 1 else 0]
        clip_space = projections[n if len(projections) > 1 else 0]
        matrix_to_c(clip_space, clip[0])
        matrix_to_c(eye_space, view[0])
        lib.gn_mat4_multiply(clip, view, ffi.addressof(camera.clip_from_world))
        check(lib.gn_mat4_invert_affine(view, inverse), name)
        camera.eye.x, camera.eye.y, camera.eye.z = (inverse.m[3][i] for i in range(3))
        matrix_to_c(np.asarray(axes[:, None] * eye_space[:3, :3], np.float32), linear[0])
        lib.gn_mat4_from_mat3(linear, view)
        check(lib.gn_mat4_normal_matrix(view, ffi.addressof(camera.camera_from_world)), name)
        sign = 1.0 if K is not None else _along(clip_space.astype(np.float64))
        forward = ffi.new("gn_vec3 *", [sign * float(x) for x in eye_space[2, :3]])
        check(lib.gn_vec3_normalize(forward[0], ffi.addressof(camera.forward)), "pose")
        camera.z_per_distance = sign * float(clip_space[2, 2])
        camera.w_per_distance = sign * float(clip_space[3, 2])
        camera.z, camera.w = float(clip_space[2, 3]), float(clip_space[3, 3])
    return cameras, is_batch
