"""Drawing: one picture or a batch of them, to numpy arrays."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass
from typing import Any, Dict, Iterable, List, Optional, Tuple

import numpy as np
import numpy.typing as npt

from ._native import ffi, lib
from .arrays import Floats, instance, integer, matrix_to_c, narrow, pointer
from .cameras import affine_matrices, write_cameras
from .colors import color
from .environment import exact
from .errors import check, refuse, words
from .models import Model
from .placing import between_origins, world_origin
from .scene import Light, Material, Mesh, Texture

OUTPUTS = ("color", "depth", "normals", "labels")
SHADERS = ("unlit", "flat", "gouraud", "toon", "phong", "blinn_phong", "normal_color")
CULLS = {"none": "GN_CULL_NONE", "back": "GN_CULL_BACK", "front": "GN_CULL_FRONT"}
MOST_THREADS = 64
MOST_SIZE = 16384


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
    """Draws a mesh or a model seen by one camera, or by each of several.

    vertices, faces  a Mesh, a Model, or arrays of shape (v, 3) and (f, 3); normals, colors,
                     texcoords and labels are the Mesh's. All meshes of a Model are drawn into the
                     same picture, with labels as its `merged` mesh has them
    K, pose          an intrinsic matrix of shape (3, 3) and the matrix from the world to the
                     camera, of shape (4, 4) or (3, 4), as in OpenCV: x to the right, y down,
                     looking along +z. Either may have n in front, for a batch
    projection       instead of K: a Transform or a matrix of shape (4, 4), with the clip space of
                     OpenGL; pose is then the view, from the world to the projection's space
    near, far        with K: the distances between which the mesh is drawn
    model            a Transform or a matrix of shape (4, 4), from the mesh to the world
    texture          an image or a Texture: the diffuse map, which needs texcoords. material has
                     further maps; a shader draws those that gnomon/shaders.h says it uses.
                     Without either, each mesh is drawn with the material that it has
    shader           one of SHADERS; without it "phong" if there are normals, otherwise "flat"
    background       red, green, blue and alpha: floats of 0 to 1, or bytes as uint8
    antialias        colours are averages of four samples; the other outputs have one sample
    outputs          what to draw, of OUTPUTS
    out              the arrays to draw to, as a call with the same shapes has returned them
    threads          how many threads draw; all processors' if None. The pixels are the same

    Raises Error in the library's words. Arrays of float32 (faces: uint32) that are contiguous are
    read where they are; the results are written once, by the library.

    Far coordinates, such as metres on a map, may be given as float64: vertices, pose, model and a
    light's position. The mesh is far if its middle is more than 64 half sizes from the origin. A
    far mesh is moved to the origin in double precision, with the cameras and the light, and then
    becomes float32. A Transform is float32, so far poses must be arrays.
    """
    meshes = _meshes(vertices, faces, normals, colors, texcoords, labels)
    textured = "material"
    if texture is not None:
        if material is not None:
            raise refuse("render", "takes texture or material, not both")
        material = Material(texture if isinstance(texture, Texture) else Texture(texture))
        textured = "texture"
    light = Light() if light is None else light
    instance(light, "light", Light)
    materials = [_material(mesh, material, textured) for mesh in meshes]
    width, height = integer(width, "width", 1, MOST_SIZE), integer(height, "height", 1, MOST_SIZE)
    if not isinstance(antialias, (bool, np.bool_)):
        raise refuse("antialias", f"is {antialias!r}, not True or False")

    world_from_model = affine_matrices(np.eye(4) if model is None else model, "model")
    if len(world_from_model) != 1:
        raise refuse("model", f"has {len(world_from_model)} matrices, not one")
    origin = world_origin(world_from_model[0], [mesh.placed for mesh in meshes])
    cameras, is_batch = write_cameras(K, pose, projection, width, height, near, far, origin)
    parts = ffi.new("views_part[]", len(meshes))
    kept: List[Any] = [meshes, materials, cameras, parts]
    job = ffi.new("views_job *")
    for i, mesh in enumerate(meshes):
        mesh.write(parts[i].mesh)
        between = between_origins(world_from_model[0], mesh.placed.origin, origin)
        _write_model(parts[i], narrow(between, "model"))
        materials[i].write(parts[i].material)
        parts[i].shader = _shader(shader, mesh, materials[i])
    light.write(job, origin)
    _write_state(job, cull, background)
    job.part, job.part_count = parts, len(parts)
    job.smooth_edges = bool(antialias)
    job.camera, job.count = cameras, len(cameras)
    job.reversed = projection is None
    job.width, job.height = width, height
    arrays = _arrays(job, outputs, out, is_batch)
    first_label = 0
    for i, mesh in enumerate(meshes):
        if "normals" in arrays and mesh.normals is None:
            parts[i].face_normals = _face_normals(parts[i], mesh, kept)
        if mesh.labels is not None and len(mesh.labels):
            parts[i].labels = pointer(mesh.labels, "int32_t[]")
        parts[i].first_label = first_label
        first_label += len(mesh.faces)
    _draw(job, threads)
    return _pictures(arrays, is_batch)


def _meshes(vertices: Any, faces: Any, *attributes: Any) -> List[Mesh]:
    """Returns what to draw: the meshes that are given, or the mesh of the arrays."""
    if isinstance(vertices, (Mesh, Model)):
        if faces is not None or any(x is not None for x in attributes):
            what = type(vertices).__name__
            raise refuse("render", f"takes no faces and no attributes beside a {what}")
        if isinstance(vertices, Mesh):
            return [vertices]
        if not vertices.meshes:
            raise refuse("render", "draws triangles; the Model has only lines or points")
        return vertices.meshes
    normals, colors, texcoords, labels = attributes
    mesh = Mesh(vertices, faces, normals=normals, colors=colors, texcoords=texcoords, labels=labels)
    return [mesh]


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
    name = given or ("unlit" if material.unlit else usual)
    if name not in SHADERS:
        raise refuse("shader", f"is {name!r}, not one of {', '.join(SHADERS)}")
    if name not in ("unlit", "flat") and mesh.normals is None:
        raise refuse("shader", f"{name} needs normals")
    number: int = getattr(lib, f"VIEWS_{name.upper()}")
    return number


def _write_state(job: Any, cull: str, background: Any) -> None:
    if cull not in CULLS:
        raise refuse("cull", f"is {cull!r}, not one of {', '.join(CULLS)}")
    job.raster.cull = getattr(lib, CULLS[cull])
    job.background = [float(v) for v in color(background, "background", 4)]


def _face_normals(part: Any, mesh: Mesh, kept: List[Any]) -> Any:
    """Returns the normals of the faces in the world, and keeps their memory."""
    normals = mesh.face_normals()
    memory = ffi.cast("gn_vec3 *", pointer(normals, "float[]"))
    matrix = ffi.addressof(part.normal_matrix)
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
    if isinstance(outputs, str):
        raise refuse("outputs", f"is the string {outputs!r}, not a list of strings")
    wanted = set(outputs)
    unknown = sorted(wanted - set(OUTPUTS))
    if unknown or not wanted:
        what = f"has {unknown[0]!r}, which is" if unknown else "is empty:"
        raise refuse("outputs", f"{what} not one of {', '.join(OUTPUTS)}")
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
    """Returns the array of the given shape whose memory `given` shows.

    An earlier call has returned `given`: all of that memory, or, for normals, three of the four
    floats of each pixel.
    """
    whole: Any = given
    if name == "normals":
        while isinstance(whole, np.ndarray) and whole.size != math.prod(shape):
            whole = whole.base
    if (
        isinstance(whole, np.ndarray)
        and whole.dtype == dtype
        and whole.size == math.prod(shape)
        and whole.flags.c_contiguous
        and _shows(given, _view(whole.reshape(shape), name, is_batch))
    ):
        if not given.flags.writeable:
            raise refuse("out", f"{name} cannot be written")
        result: npt.NDArray[Any] = whole.reshape(shape)
        return result
    raise refuse("out", f"{name} is no array that a call with these shapes has returned")


def _shows(given: npt.NDArray[Any], view: npt.NDArray[Any]) -> bool:
    """Returns whether two arrays have the same numbers at the same places in memory."""
    return bool(
        given.shape == view.shape
        and given.ctypes.data == view.ctypes.data
        and all(n == 1 or a == b for n, a, b in zip(view.shape, given.strides, view.strides))
    )


def _view(array: npt.NDArray[Any], name: str, is_batch: bool) -> npt.NDArray[Any]:
    """Returns what the caller sees of an array that the library draws to."""
    one: npt.NDArray[Any] = array if is_batch else array[0]
    return one[..., :3] if name == "normals" else one


def _pictures(arrays: Dict[str, npt.NDArray[Any]], is_batch: bool) -> Pictures:
    views = {name: _view(array, name, is_batch) for name, array in arrays.items()}
    return Pictures(*(views.get(name) for name in OUTPUTS))


def _thread_count(threads: Optional[int]) -> int:
    if threads is None:
        return min(len(os.sched_getaffinity(0)), MOST_THREADS)
    return integer(threads, "threads", 1, MOST_THREADS)


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

