"""Drawing: one picture or a batch of them, to numpy arrays."""

from __future__ import annotations

import os
import warnings
from dataclasses import dataclass
from typing import Any, Dict, Iterable, List, Optional, Tuple

import numpy as np
import numpy.typing as npt

from ._native import ffi, lib
from .arrays import Doubles, Floats, choice, flag, instance, integer, matrix_to_c, narrow, pointer
from .cameras import affine_matrices, write_cameras
from .colors import color
from .emptiness import reason
from .environment import exact
from .errors import EmptyWarning, check, refuse, words
from .lights import lights_of, write_lights
from .models import Model
from .placing import between_origins, world_bounds, world_origin
from .scene import Material, Mesh, Texture

OUTPUTS = ("color", "depth", "normals", "labels")
SHADERS = ("unlit", "flat", "gouraud", "toon", "phong", "blinn_phong", "normal_color")
NORMALS_IN = ("world", "camera")
CULLS = {"none": "GN_CULL_NONE", "back": "GN_CULL_BACK", "front": "GN_CULL_FRONT"}
MOST_THREADS = 64
MOST_SIZE = 16384
# Starting a thread takes as long as drawing some ten thousands of pixels.
PIXELS_A_THREAD = 65536


@dataclass(frozen=True)
class Pictures:
    """The arrays of a drawing, with the top row first; None where an output was not asked for.

    A batch of n cameras has n in front of each shape.
    """

    color: Optional[npt.NDArray[np.uint8]]  # (height, width, 4): red, green, blue, alpha
    depth: Optional[Floats]  # (height, width): distances along the view; 0 where nothing is
    normals: Optional[Floats]  # (height, width, 3): unit length; 0 where nothing is
    labels: Optional[npt.NDArray[np.int32]]  # (height, width): -1 where nothing is


@exact
def render(
    vertices: Any,
    faces: Any = None,
    K: Any = None,
    pose: Any = None,
    *,
    camera_pose: Any = None,
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
    light: Any = None,
    shader: Optional[str] = None,
    background: Any = (0.0, 0.0, 0.0, 0.0),
    cull: str = "none",
    antialias: bool = False,
    outputs: Iterable[str] = OUTPUTS,
    normals_in: str = "world",
    out: Optional[Pictures] = None,
    threads: Optional[int] = None,
) -> Pictures:
    """Draws meshes seen by one camera, or by each of several.

    vertices, faces  a Mesh, a Model or a list of these; or arrays of shape (v, 3) and (f, 3), and
                     then normals, colors, texcoords and labels are the Mesh's. All are drawn into
                     the same picture. Faces without labels of yours are numbered on from mesh to
                     mesh
    K, pose          an intrinsic matrix of shape (3, 3) and the matrix from the world to the
                     camera, of shape (4, 4) or (3, 4), as in OpenCV: x to the right, y down,
                     looking along +z. Either may have n in front, or be a list, for a batch
    camera_pose      instead of pose: the matrix from the camera to the world, as in OpenGL, pyrender
                     and Blender: x to the right, y up, looking along -z. It goes with K, too
    projection       instead of K: a Transform or a matrix of shape (4, 4), with the clip space of
                     OpenGL; pose is then the view, from the world to the projection's space
    near, far        with K: the distances between which the mesh is drawn
    model            a Transform or a matrix of shape (4, 4), from the meshes to the world; or a
                     list with one for each item of the list of meshes
    texture          an image, its path or a Texture: the diffuse map, which needs texcoords. material has
                     further maps; a shader draws those that gnomon/shaders.h says it uses.
                     Without either, each mesh is drawn with the material that it has
    light            a Light or a list of up to 8; without it one that shines from the camera
    shader           one of SHADERS; without it "phong" if there are normals, otherwise "flat"
    background       red, green, blue and alpha: floats of 0 to 1, or bytes as uint8
    antialias        colours are averages of four samples; the other outputs have one sample
    outputs          what to draw, of OUTPUTS
    normals_in       "world", or "camera" for the axes of the camera: those of pose or camera_pose
    out              the Pictures to draw to, as a call with the same shapes has returned them
    threads          how many threads draw; if None, one for each processor, but fewer for a small
                     picture. The pixels are the same

    A call that draws nothing in any picture gives an EmptyWarning, which says why.
    Raises Error in the library's words. Arrays of float32 (faces: uint32) that are contiguous are
    read where they are; the results are written once, by the library.

    Far coordinates, such as metres on a map, may be given as float64: vertices, pose, model and a
    light's position. The mesh is far if its middle is more than 64 half sizes from the origin. A
    far mesh is moved to the origin in double precision, with the cameras and the light, and then
    becomes float32. A Transform is float32, so far poses must be arrays.
    """
    items = _items(vertices, faces, normals, colors, texcoords, labels)
    meshes = [mesh for item in items for mesh in item]
    textured = "material"
    if texture is not None:
        if material is not None:
            raise refuse("render", "takes texture or material, not both")
        material = Material(texture if isinstance(texture, Texture) else Texture(texture))
        textured = "texture"
    materials = [_material(mesh, material, textured) for mesh in meshes]
    width, height = integer(width, "width", 1, MOST_SIZE), integer(height, "height", 1, MOST_SIZE)
    models = _models(model, items)
    bounds = world_bounds([mesh.placed for mesh in meshes], models)
    origin = world_origin(bounds)
    cameras, is_batch = write_cameras(
        K, pose, camera_pose, projection, width, height, near, far, origin
    )
    parts = ffi.new("views_part[]", len(meshes))
    kept: List[Any] = [meshes, materials, cameras, parts]
    job = ffi.new("views_job *")
    first_label = 0
    for part, mesh, own, matrix in zip(parts, meshes, materials, models):
        mesh.write(part.mesh)
        _write_model(part, narrow(between_origins(matrix, mesh.placed.origin, origin), "model"))
        own.write(part.material)
        part.shader = _shader(shader, mesh, own)
        if mesh.labels is not None and len(mesh.labels):
            part.labels = pointer(mesh.labels, "int32_t[]")
        part.first_label = first_label
        first_label += len(mesh.faces)
    kept.append(write_lights(job, lights_of(light, len(job.light)), bounds, origin))
    _write_state(job, cull, background)
    job.part, job.part_count = parts, len(parts)
    job.smooth_edges = flag(antialias, "antialias")
    job.normals_of_camera = choice(normals_in, "normals_in", NORMALS_IN) == "camera"
    job.camera, job.count = cameras, len(cameras)
    job.reversed = projection is None
    job.width, job.height = width, height
    arrays = _arrays(job, outputs, out, is_batch)
    _draw(job, threads)
    if job.is_empty:
        warnings.warn(f"nothing is drawn: {reason(job, meshes)}", EmptyWarning, stacklevel=3)
    return _pictures(arrays, is_batch)


def _items(vertices: Any, faces: Any, *attributes: Any) -> List[List[Mesh]]:
    """Returns what to draw: the meshes of each item that is given, or the mesh of the arrays."""
    given = vertices if isinstance(vertices, (list, tuple)) else [vertices]
    if not any(isinstance(item, (Mesh, Model)) for item in given):
        normals, colors, texcoords, labels = attributes
        return [
            [Mesh(vertices, faces, normals=normals, colors=colors, texcoords=texcoords, labels=labels)]
        ]
    if faces is not None or any(x is not None for x in attributes):
        raise refuse("render", "takes no faces and no attributes beside a Mesh or a Model")
    return [_meshes_of(item) for item in given]


def _meshes_of(item: Any) -> List[Mesh]:
    if isinstance(item, Model):
        if not item.meshes:
            raise refuse("render", "draws triangles; the Model has only lines or points")
        return item.meshes
    instance(item, "vertices", Mesh)
    return [item]


def _models(model: Any, items: List[List[Mesh]]) -> List[Doubles]:
    """Returns for each mesh the matrix that takes it to the world."""
    matrices = affine_matrices(np.eye(4) if model is None else model, "model")
    if len(matrices) not in (1, len(items)):
        raise refuse("model", f"has {len(matrices)} matrices for {len(items)} meshes")
    several = list(matrices) * len(items) if len(matrices) == 1 else list(matrices)
    return [matrix for matrix, item in zip(several, items) for _ in item]


def _material(mesh: Mesh, given: Optional[Material], textured: str) -> Material:
    """Returns the material of a mesh. `textured` is the argument that gave it, for the words."""
    material = given if given is not None else mesh.material
    if material is None:
        return Material()
    instance(material, "material", Material)
    material.check_mesh(mesh, textured)
    return material


def _write_model(part: Any, matrix: Floats) -> None:
    transform = ffi.new("gn_transform *")
    linear, offset = ffi.new("gn_mat3 *"), ffi.new("gn_vec3 *")
    matrix_to_c(np.ascontiguousarray(matrix[:3, :3]), linear[0])
    offset.x, offset.y, offset.z = (float(v) for v in matrix[:3, 3])
    check(lib.gn_affine(linear, offset[0], transform), "model")
    part.world_from_model = transform.matrix
    check(
        lib.gn_transform_normal_matrix(transform, ffi.addressof(part.normal_matrix)),
        "model",
    )


def _shader(given: Optional[str], mesh: Mesh, material: Material) -> int:
    usual = "phong" if mesh.normals is not None else "flat"
    name = "unlit" if flag(material.unlit, "material.unlit") else usual
    if given is not None:
        name = choice(given, "shader", SHADERS)
    if name not in ("unlit", "flat") and mesh.normals is None:
        raise refuse("shader", f"{name} needs normals")
    number: int = getattr(lib, f"VIEWS_{name.upper()}")
    return number


def _write_state(job: Any, cull: str, background: Any) -> None:
    job.raster.cull = getattr(lib, CULLS[choice(cull, "cull", CULLS)])
    job.background = [float(v) for v in color(background, "background", 4)]


_SHAPES: Dict[str, Tuple[Any, Tuple[int, ...]]] = {
    "color": (np.uint8, (4,)),
    "depth": (np.float32, ()),
    "normals": (np.float32, (3,)),
    "labels": (np.int32, ()),
}


def _arrays(
    job: Any, outputs: Any, out: Optional[Pictures], is_batch: bool
) -> Dict[str, npt.NDArray[Any]]:
    """Returns the arrays to draw to, with a picture for each camera, and writes their pointers."""
    if isinstance(outputs, str):
        raise refuse("outputs", f"is the string {outputs!r}, not a list of strings")
    try:
        names = list(outputs)
    except TypeError:
        raise refuse("outputs", f"is {outputs!r}, not a list of strings") from None
    wanted = [choice(name, "outputs", OUTPUTS) for name in names]
    if not wanted:
        raise refuse("outputs", f"is empty: not one of {', '.join(OUTPUTS)}")
    if out is not None:
        instance(out, "out", Pictures)
    arrays: Dict[str, npt.NDArray[Any]] = {}
    for name in OUTPUTS:
        if name in wanted:
            dtype, channels = _SHAPES[name]
            shape = (job.count, job.height, job.width) + channels
            given = None if out is None else getattr(out, name)
            arrays[name] = (
                np.empty(shape, dtype)
                if given is None
                else _given(given, name, shape, dtype, is_batch)
            )
    for name, c_type, field in (
        ("color", "uint8_t[]", "color"),
        ("depth", "float[]", "depth"),
        ("normals", "float[]", "normals"),
        ("labels", "int32_t[]", "labels_drawn"),
    ):
        if name in arrays:
            setattr(job, field, ffi.cast(c_type.replace("[]", " *"), pointer(arrays[name], c_type)))
    return arrays


def _given(
    given: Any, name: str, shape: Tuple[int, ...], dtype: Any, is_batch: bool
) -> npt.NDArray[Any]:
    """Returns an array of `out` in the given shape, whose first number is that of the pictures."""
    wanted = shape if is_batch else shape[1:]
    if (
        not isinstance(given, np.ndarray)
        or given.dtype != dtype
        or given.shape != wanted
        or not given.flags.c_contiguous
    ):
        raise refuse("out", f"{name} is no contiguous array of {np.dtype(dtype)}, {wanted}")
    if not given.flags.writeable:
        raise refuse("out", f"{name} cannot be written")
    return given.reshape(shape)


def _pictures(arrays: Dict[str, npt.NDArray[Any]], is_batch: bool) -> Pictures:
    views = {name: array if is_batch else array[0] for name, array in arrays.items()}
    return Pictures(*(views.get(name) for name in OUTPUTS))


def _thread_count(job: Any, threads: Optional[int]) -> int:
    if threads is not None:
        return integer(threads, "threads", 1, MOST_THREADS)
    useful = job.count if job.count > 1 else 1 + job.width * job.height // PIXELS_A_THREAD
    return min(len(os.sched_getaffinity(0)), MOST_THREADS, int(useful))


def _draw(job: Any, threads: Optional[int]) -> None:
    count = _thread_count(job, threads)
    size = lib.views_memory(job, count)
    try:
        memory = np.empty(size, np.uint8)
    except (MemoryError, ValueError):
        raise MemoryError(f"{size} bytes for {count} threads") from None
    if not lib.views_draw(job, ffi.from_buffer("char[]", memory), size, count):
        raise OSError(f"{count} threads cannot be started")
    check(job.error, "render", words(job.fault))

