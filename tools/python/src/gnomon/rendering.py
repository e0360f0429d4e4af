"""Drawing: one picture or a batch of them, to numpy arrays."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass
from typing import Any, Dict, Iterable, List, Optional, Tuple

import numpy as np
import numpy.typing as npt

from ._native import ffi, lib
from .arrays import Floats, matrix_to_c, pointer, shaped, vector
from .environment import exact
from .errors import Error, check, refuse, words
from .scene import Light, Material, Mesh, Texture
from .transforms import Transform, intrinsics

OUTPUTS = ("color", "depth", "normals", "labels")
SHADERS = ("unlit", "flat", "gouraud", "toon", "phong", "blinn_phong", "normal_color")
CULLS = {"none": "GN_CULL_NONE", "back": "GN_CULL_BACK", "front": "GN_CULL_FRONT"}
MOST_THREADS = 64


@dataclass(frozen=True)
class Pictures:
    """The arrays of a drawing, with the top row first; None where an output was not asked for.

    A batch of n cameras has n in front of each shape.
    """

    color: Optional[npt.NDArray[np.uint8]]  # (height, width, 4): red, green, blue, alpha
    depth: Optional[Floats]  # (height, width): distances along the view; 0 where nothing is
    normals: Optional[Floats]  # (height, width, 3): unit length, in the world; 0 where nothing is
    labels: Optional[npt.NDArray[np.int32]]  # (height, width): -1 where nothing is


@exact
def render(
    vertices: Any,
    faces: Any = None,
    K: Any = None,
    pose: Any = None,
    *,
    width: int = 640,
    height: int = 480,
    projection: Any = None,
    near: float = 0.05,
    far: float = 1000.0,
    model: Any = None,
    normals: Any = None,
    colors: Any = None,
    texcoords: Any = None,
    labels: Any = None,
    texture: Any = None,
    material: Optional[Material] = None,
    light: Optional[Light] = None,
    shader: Optional[str] = None,
    background: Any = (0.0, 0.0, 0.0, 0.0),
    cull: str = "none",
    antialias: bool = False,
    outputs: Iterable[str] = OUTPUTS,
    out: Optional[Pictures] = None,
    threads: Optional[int] = None,
) -> Pictures:
    """Draws a mesh seen by one camera, or by each of several.

    vertices, faces  a Mesh, or arrays of shape (v, 3) and (f, 3); normals, colors, texcoords and
                     labels are the Mesh's
    K, pose          an intrinsic matrix of shape (3, 3) and the matrix from the world to the
                     camera, of shape (4, 4) or (3, 4), as in OpenCV: x to the right, y down,
                     looking along +z. Either may have n in front, for a batch
    projection       instead of K: a Transform or a matrix of shape (4, 4), with the clip space of
                     OpenGL; pose is then the view, from the world to the projection's space
    near, far        with K: the distances between which the mesh is drawn
    model            a Transform or a matrix of shape (4, 4), from the mesh to the world
    texture          an image or a Texture: the diffuse map. material has further maps
    shader           one of SHADERS; without it "phong" if there are normals, otherwise "flat"
    background       red, green, blue and alpha, 0 to 1
    antialias        colours are averages of four samples; the other outputs have one sample
    outputs          what to draw, of OUTPUTS
    out              the arrays to draw to, as a call with the same shapes has returned them
    threads          how many threads draw; all processors' if None. The pixels are the same

    Raises Error in the library's words. Arrays of float32 (faces: uint32) that are contiguous are
    read where they are; the results are written once, by the library.
    """
    if isinstance(vertices, Mesh):
        if faces is not None or any(x is not None for x in (normals, colors, texcoords, labels)):
            raise refuse("render", "takes no faces and no attributes beside a Mesh")
        mesh = vertices
    else:
        mesh = Mesh(
            vertices, faces, normals=normals, colors=colors, texcoords=texcoords, labels=labels
        )
    if texture is not None:
        if material is not None:
            raise refuse("render", "takes texture or material, not both")
        material = Material(texture if isinstance(texture, Texture) else Texture(texture))
    for name, size in (("width", width), ("height", height)):
        if not 1 <= size <= 16384:
            raise refuse(name, f"is {size}, not in 1 to 16384")

    cameras, is_batch = _cameras(K, pose, projection, width, height, near, far)
    kept: List[Any] = [mesh, material, cameras]
    job = ffi.new("views_job *")
    mesh.write(job.mesh)
    _write_model(job, model)
    (material or Material()).write(job.material)
    (light or Light()).write(job)
    _write_state(job, mesh, shader, cull, background)
    job.smooth_edges = antialias
    job.camera, job.count = cameras, len(cameras)
    job.reversed = projection is None
    job.width, job.height = width, height
    arrays = _arrays(job, set(outputs), out, is_batch)
    if "normals" in arrays and mesh.normals is None:
        job.face_normals = _face_normals(job, mesh, kept)
    if mesh.labels is not None and len(mesh.labels):
        job.labels = pointer(mesh.labels, "int32_t[]")
    _draw(job, threads)
    return _pictures(arrays, is_batch)


def _matrices(value: Any, name: str) -> Floats:
    """Returns an array of shape (n, 4, 4) of one or more matrices with 3 or 4 rows."""
    if isinstance(value, Transform):
        return value.matrix[None]
    given = np.asarray(value, dtype=np.float32)
    one = given[None] if given.ndim == 2 else given
    if one.ndim != 3 or one.shape[1:] not in ((3, 4), (4, 4)):
        raise refuse(name, f"has the shape {given.shape}, not (4, 4), (3, 4) or n of these")
    whole = np.zeros((len(one), 4, 4), np.float32)
    whole[:, 3, 3] = 1
    whole[:, : one.shape[1]] = one
    return whole


def _cameras(
    K: Any, pose: Any, projection: Any, width: int, height: int, near: float, far: float
) -> Tuple[Any, bool]:
    """Returns an array of views_camera, and whether the result is a batch."""
    if (K is None) == (projection is None):
        raise refuse("render", "needs K or projection, and takes one of them")
    poses = np.eye(4, dtype=np.float32)[None] if pose is None else _matrices(pose, "pose")
    is_batch = pose is not None and not isinstance(pose, Transform) and np.ndim(pose) == 3
    if K is None:
        projections = _matrices(projection, "projection")
        is_batch = is_batch or (not isinstance(projection, Transform) and np.ndim(projection) == 3)
    else:
        given = np.asarray(K, dtype=np.float64)
        several = given if given.ndim == 3 else given[None]
        is_batch = is_batch or given.ndim == 3
        matrices = [intrinsics(k, width, height, near, far) for k in several]
        projections = np.stack([_reversed(matrix, near, far) for matrix in matrices])
    count = max(len(poses), len(projections))
    if not is_batch:
        count = 1
    for name, array in (("pose", poses), ("K" if projection is None else "projection", projections)):
        if len(array) not in (1, count) or count == 0:
            raise refuse(name, f"has {len(array)} matrices for {count} cameras")
    cameras = ffi.new("views_camera[]", count)
    clip, view, inverse = ffi.new("gn_mat4 *"), ffi.new("gn_mat4 *"), ffi.new("gn_mat4 *")
    for n, camera in enumerate(cameras):
        eye_space = poses[n if len(poses) > 1 else 0]
        clip_space = projections[n if len(projections) > 1 else 0]
        if not (np.isfinite(eye_space).all() and np.isfinite(clip_space).all()):
            raise refuse("camera", "has a number that is not finite")
        matrix_to_c(clip_space, clip[0])
        matrix_to_c(eye_space, view[0])
        lib.gn_mat4_multiply(clip, view, ffi.addressof(camera.clip_from_world))
        check(lib.gn_mat4_invert_affine(view, inverse), "pose")
        camera.eye.x, camera.eye.y, camera.eye.z = (inverse.m[3][i] for i in range(3))
        # The view looks along +z if w grows with z, otherwise along -z.
        sign = 1.0 if K is not None or clip_space[3, 2] > 0 else -1.0
        forward = ffi.new("gn_vec3 *", [sign * float(x) for x in eye_space[2, :3]])
        check(lib.gn_vec3_normalize(forward[0], ffi.addressof(camera.forward)), "pose")
        camera.z_per_distance = sign * float(clip_space[2, 2])
        camera.w_per_distance = sign * float(clip_space[3, 2])
        camera.z, camera.w = float(clip_space[2, 3]), float(clip_space[3, 3])
    return cameras, is_batch


def _reversed(projection: Transform, near: float, far: float) -> Floats:
    """Returns the matrix with depths from 1, near, to 0, far, which are precise at all distances."""
    matrix = projection.matrix.copy()
    matrix[2, 2], matrix[2, 3] = -near / (far - near), far * near / (far - near)
    return matrix


def _write_model(job: Any, model: Any) -> None:
    matrix = np.eye(4, dtype=np.float32) if model is None else _matrices(model, "model")
    if matrix.ndim == 3:
        if len(matrix) != 1:
            raise refuse("model", f"has {len(matrix)} matrices, not one")
        matrix = matrix[0]
    transform = ffi.new("gn_transform *")
    linear, offset = ffi.new("gn_mat3 *"), ffi.new("gn_vec3 *")
    matrix_to_c(np.ascontiguousarray(matrix[:3, :3]), linear[0])
    offset.x, offset.y, offset.z = (float(v) for v in matrix[:3, 3])
    check(lib.gn_affine(linear, offset[0], transform), "model")
    job.world_from_model = transform.matrix
    check(
        lib.gn_transform_normal_matrix(transform, ffi.addressof(job.normal_matrix)),
        "model",
    )


def _write_state(job: Any, mesh: Mesh, shader: Optional[str], cull: str, background: Any) -> None:
    name = shader or ("phong" if mesh.normals is not None else "flat")
    if name not in SHADERS:
        raise refuse("shader", f"is {name!r}, not one of {', '.join(SHADERS)}")
    if name not in ("unlit", "flat") and mesh.normals is None:
        raise refuse("shader", f"{name} needs normals")
    if cull not in CULLS:
        raise refuse("cull", f"is {cull!r}, not one of {', '.join(CULLS)}")
    job.shader = getattr(lib, f"VIEWS_{name.upper()}")
    job.raster.cull = getattr(lib, CULLS[cull])
    job.background = [float(v) for v in vector(background, "background", 4)]


def _face_normals(job: Any, mesh: Mesh, kept: List[Any]) -> Any:
    """Returns the normals of the faces in the world, and keeps their memory."""
    normals = mesh.face_normals()
    memory = ffi.cast("gn_vec3 *", pointer(normals, "float[]"))
    matrix = ffi.addressof(job.normal_matrix)
    status = lib.gn_mat3_multiply_vec3_packed(
        matrix, memory, memory, len(normals), lib.GN_BACKEND_AUTO
    )
    check(status, "normals")
    kept.append(normals)
    return pointer(normals, "float[]") if len(normals) else ffi.NULL


_SHAPES: Dict[str, Tuple[Any, Tuple[int, ...]]] = {
    "color": (np.uint8, (4,)),
    "depth": (np.float32, ()),
    "normals": (np.float32, (4,)),
    "labels": (np.int32, ()),
}


def _arrays(
    job: Any, outputs: Any, out: Optional[Pictures], is_batch: bool
) -> Dict[str, npt.NDArray[Any]]:
    """Returns the arrays to draw to, with a picture for each camera, and writes their pointers."""
    arrays: Dict[str, npt.NDArray[Any]] = {}
    for name in OUTPUTS:
        if name in outputs:
            dtype, channels = _SHAPES[name]
            shape = (job.count, job.height, job.width) + channels
            given = None if out is None else getattr(out, name)
            arrays[name] = (
                np.empty(shape, dtype) if given is None else _given(given, name, shape, dtype)
            )
    unknown = sorted(set(outputs) - set(OUTPUTS))
    if unknown or not arrays:
        what = f"has {unknown[0]!r}, which is" if unknown else "is empty:"
        raise refuse("outputs", f"{what} not one of {', '.join(OUTPUTS)}")
    for name, c_type, field in (
        ("color", "uint8_t[]", "color"),
        ("depth", "float[]", "depth"),
        ("normals", "float[]", "normals"),
        ("labels", "int32_t[]", "labels_drawn"),
    ):
        if name in arrays:
            setattr(job, field, ffi.cast(c_type.replace("[]", " *"), pointer(arrays[name], c_type)))
    return arrays


def _given(given: Any, name: str, shape: Tuple[int, ...], dtype: Any) -> npt.NDArray[Any]:
    """Returns the array that owns the memory of `given`, which an earlier call has returned."""
    whole: npt.NDArray[Any] = given
    while whole.base is not None and isinstance(whole.base, np.ndarray) and whole.shape != shape:
        whole = whole.base
    if whole.dtype != dtype or whole.size != math.prod(shape) or not whole.flags.c_contiguous:
        raise refuse("out", f"{name} is no array that a call with these shapes has returned")
    if not whole.flags.writeable:
        raise refuse("out", f"{name} cannot be written")
    return whole.reshape(shape)


def _pictures(arrays: Dict[str, npt.NDArray[Any]], is_batch: bool) -> Pictures:
    views = {name: array if is_batch else array[0] for name, array in arrays.items()}
    if "normals" in views:
        views["normals"] = views["normals"][..., :3]
    return Pictures(*(views.get(name) for name in OUTPUTS))


def _thread_count(threads: Optional[int]) -> int:
    if threads is None:
        return min(len(os.sched_getaffinity(0)), MOST_THREADS)
    if not 1 <= threads <= MOST_THREADS:
        raise refuse("threads", f"is {threads}, not in 1 to {MOST_THREADS}")
    return threads


def _draw(job: Any, threads: Optional[int]) -> None:
    count = _thread_count(threads)
    size = lib.views_memory(job, count)
    try:
        memory = np.empty(size, np.uint8)
    except (MemoryError, ValueError):
        raise MemoryError(f"{size} bytes for {count} threads") from None
    if not lib.views_draw(job, ffi.from_buffer("char[]", memory), size, count):
        raise OSError(f"{count} threads cannot be started")
    check(job.error, "render", words(job.fault))


__all__ = ["Error", "OUTPUTS", "SHADERS", "Pictures", "render", "shaped"]
