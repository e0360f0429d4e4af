"""Models from files: what their formats say, drawn and as arrays; faults and warnings."""

import base64
import json
import math
import os
import re
import struct
import sys
import warnings
import zlib
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import gnomon

K = np.array([[40.0, 0, 31.5], [0, 40.0, 23.5], [0, 0, 1]])
SIZE = {"width": 64, "height": 48}
RED, GREEN, BLUE, WHITE = [255, 0, 0], [0, 255, 0], [0, 0, 255], [255, 255, 255]


def png(image, bits=8, color=2):
    """Returns a PNG (PNG specification, section 11.2): colour type 0 is grey, 2 RGB, 6 RGBA."""

    def chunk(kind, data):
        checked = kind + data
        return struct.pack(">I", len(data)) + checked + struct.pack(">I", zlib.crc32(checked))

    height, width = image.shape[:2]
    rows = b"".join(b"\0" + row.astype(f">u{bits // 8}").tobytes() for row in image)
    header = struct.pack(">IIBBBBB", width, height, bits, color, 0, 0, 0)
    parts = (b"IHDR", header), (b"IDAT", zlib.compress(rows)), (b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + b"".join(chunk(*part) for part in parts)


def quarters():
    """Returns an image of 8x8 texels: red and green above blue and white."""
    image = np.zeros((8, 8, 3), np.uint8)
    image[:4, :4], image[:4, 4:], image[4:, :4], image[4:, 4:] = RED, GREEN, BLUE, WHITE
    return image


def square_of_obj(x=0, z=4, material="", first=1):
    """Returns a square of 2x2 before a camera of OpenCV, whose y grows downward: its upper left
    corner is that of the image."""
    corners = [(x - 1, -1, 0, 1), (x + 1, -1, 1, 1), (x + 1, 1, 1, 0), (x - 1, 1, 0, 0)]
    text = "".join(f"v {a} {b} {z}\nvt {s} {t}\n" for a, b, s, t in corners)
    face = " ".join(f"{i}/{i}" for i in range(first, first + 4))
    return f"{text}usemtl {material}\nf {face}\n" if material else f"{text}f {face}\n"


def write(path, text):
    path.parent.mkdir(exist_ok=True)
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


def load(path, **named):
    """Loads a model that has no warnings."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        model = gnomon.load(path, **named)
    assert model.warnings == []
    return model


def refused(words, path, **named):
    with pytest.raises(gnomon.Error, match=words) as caught:
        gnomon.load(path, **named)
    assert str(path) in str(caught.value)


@pytest.fixture(name="textured")
def textured_obj(tmp_path):
    """Writes a textured square, with backslashes as some exporters write them."""
    write(tmp_path / "maps/four quarters.png", png(quarters()))
    write(
        tmp_path / "a.mtl",
        "newmtl m\nKd 1 1 1\nKs 0.5 0.25 0.125\nNs 10\nillum 2\nmap_Kd maps\\four quarters.png\n",
    )
    return write(tmp_path / "a.obj", "mtllib a.mtl\n" + square_of_obj(material="m"))


def test_obj_with_material_and_texture(textured):
    model = load(textured)
    (mesh,) = model.meshes
    assert mesh.vertices.dtype == np.float32 and mesh.vertices.shape == (4, 3)
    assert mesh.faces.dtype == np.uint32 and len(mesh.faces) == 2
    corners = sorted(mesh.vertices.tolist())
    assert corners == [[-1, -1, 4], [-1, 1, 4], [1, -1, 4], [1, 1, 4]]
    assert mesh.colors.tolist() == [[1, 1, 1, 1]] * 4
    # Counter-clockwise in x, y: the normals are along z.
    lengths = np.linalg.norm(mesh.normals, axis=1, keepdims=True)
    assert np.allclose(mesh.normals / lengths, [[0, 0, 1]] * 4)
    assert mesh.material.specular == (0.5, 0.25, 0.125) and mesh.material.exponent == 10
    assert np.array_equal(mesh.material.diffuse.image, quarters())
    assert mesh.material.diffuse.wrap == ("repeat", "repeat")
    assert model.points is None and model.lines is None and model.lights == []


def test_a_model_is_drawn_with_its_texture(textured):
    picture = gnomon.render(load(textured), K=K, shader="unlit", **SIZE)
    # 20 pixels from (22, 14) on show 8 texels: these are the middles of the quarters.
    found = [picture.color[y, x, :3].tolist() for y in (18, 28) for x in (26, 36)]
    assert found == [RED, GREEN, BLUE, WHITE]
    bare = gnomon.render(load(textured, textures=False), K=K, shader="unlit", **SIZE)
    assert bare.color[18, 26].tolist() == WHITE + [255]


def two_squares(tmp_path, z=4, illum="illum 2\n"):
    """Writes a green square to the right of a red one, in this order."""
    write(
        tmp_path / "two.mtl",
        f"newmtl red\nKd 0.6 0 0\n{illum}newmtl green\nKd 0 0.2 0\nillum 2\n",
    )
    text = "mtllib two.mtl\n" + square_of_obj(x=-1, material="red")
    return write(tmp_path / "two.obj", text + square_of_obj(1, z, "green", 5))


def test_all_meshes_are_drawn_into_one_picture(tmp_path):
    model = load(two_squares(tmp_path))
    assert [mesh.colors[0].tolist() for mesh in model.meshes] == [
        pytest.approx([0.6, 0, 0, 1]),
        pytest.approx([0, 0.2, 0, 1]),
    ]
    picture = gnomon.render(model, K=K, shader="unlit", **SIZE)
    # 0.6 * 255 is 153, 0.2 * 255 is 51.
    assert picture.color[20, 26].tolist() == [153, 0, 0, 255]
    assert picture.color[20, 36].tolist() == [0, 51, 0, 255]
    assert set(np.unique(picture.labels[:, :32])) == {-1, 0, 1}
    assert set(np.unique(picture.labels[:, 32:])) == {-1, 2, 3}


@pytest.mark.parametrize("way", [{}, {"antialias": True}, {"threads": 2}, {"outputs": ["depth"]}])
def test_a_model_is_drawn_as_its_merged_mesh(tmp_path, way):
    model = load(two_squares(tmp_path, z=5))
    poses = np.stack([np.eye(4)] * 3)
    poses[1, 0, 3], poses[2, 2, 3] = 0.5, 1.25
    for pose in (np.eye(4), poses):
        found = gnomon.render(model, K=K, pose=pose, shader="unlit", **SIZE, **way)
        merged = gnomon.render(model.merged(), K=K, pose=pose, shader="unlit", **SIZE, **way)
        for name in way.get("outputs", gnomon.OUTPUTS):
            assert np.array_equal(getattr(found, name), getattr(merged, name)), name
        assert (found.depth > 0).any()


@pytest.mark.parametrize("threads", [1, 2])
def test_a_large_mesh_behind_a_small_one(threads):
    # A workspace has room for the largest mesh.
    y, x = np.mgrid[-1:1:150j, -1:1:150j]
    grid = np.stack([x, y, 5 + x * y], axis=-1).reshape(-1, 3)
    corner = np.arange(149 * 150).reshape(149, 150)[:, :-1].reshape(-1, 1)
    large = gnomon.Mesh(grid, np.concatenate([corner + [0, 1, 150], corner + [1, 151, 150]]))
    small = gnomon.Mesh([[0, 0, 3], [1, 0, 3], [0, 1, 3]], [[0, 1, 2]])
    model = gnomon.Model([small, large], None, None, [], [])
    found = gnomon.render(model, K=K, threads=threads, **SIZE)
    merged = gnomon.render(model.merged(), K=K, threads=threads, **SIZE)
    for name in gnomon.OUTPUTS:
        assert np.array_equal(getattr(found, name), getattr(merged, name)), name
    assert found.labels[25, 33] == 0 and found.labels.max() > 40000


def test_a_mesh_hides_another(tmp_path):
    near = square_of_obj(0, 4, "red")
    text = "mtllib two.mtl\n" + near + square_of_obj(0, 6, "green", 5)
    two_squares(tmp_path)
    for first in (0, 1):
        model = load(write(tmp_path / "hidden.obj", text))
        meshes = model.meshes if first == 0 else model.meshes[::-1]
        other = gnomon.Model(meshes, None, None, [], [])
        picture = gnomon.render(other, K=K, shader="unlit", **SIZE)
        assert picture.color[20, 30].tolist() == [153, 0, 0, 255]
        assert picture.depth[20, 30] == pytest.approx(4)


def test_unlit_materials(tmp_path):
    # Without ambient light and from behind, what is lit is black; illum 0 is not lit.
    dark = gnomon.Light(direction=(0, 0, -1), ambient=(0.0, 0.0, 0.0))
    model = load(two_squares(tmp_path, illum="illum 0\n"))
    assert [mesh.material.unlit for mesh in model.meshes] == [True, False]
    picture = gnomon.render(model, K=K, light=dark, **SIZE)
    assert picture.color[20, 26].tolist() == [153, 0, 0, 255]
    assert picture.color[20, 36].tolist() == [0, 0, 0, 255]
    lit = gnomon.render(model, K=K, light=dark, shader="gouraud", **SIZE)
    assert lit.color[20, 26].tolist() == [0, 0, 0, 255]


def test_merged(tmp_path):
    path = two_squares(tmp_path)
    mesh = load(path).merged()
    assert len(mesh.vertices) == 8 and len(mesh.faces) == 4 and mesh.material is None
    xs = mesh.vertices[mesh.faces][:, :, 0]
    assert (xs[:2].min(), xs[:2].max(), xs[2:].min(), xs[2:].max()) == (-2, 0, 0, 2)
    assert mesh.texcoords.shape == (8, 2)
    bare = path.read_text() + "usemtl red\nf 1 2 3\n"
    path = write(tmp_path / "bare.obj", bare)
    assert gnomon.load(path).merged().texcoords is None


def test_lines_and_points_of_obj(tmp_path):
    path = write(tmp_path / "l.obj", "v 0 0 0\nv 1 0 0\nv 1 2 0\nv 5 6 7\nl 1 2 3\np 4\n")
    model = load(path)
    assert model.meshes == []
    ends = model.lines.vertices[model.lines.segments]
    assert ends.tolist() == [[[0, 0, 0], [1, 0, 0]], [[1, 0, 0], [1, 2, 0]]]
    assert model.lines.colors.shape == (len(model.lines.vertices), 4)
    assert model.points.vertices.tolist() == [[5, 6, 7]]
    with pytest.raises(gnomon.Error, match="only lines or points"):
        gnomon.render(model, K=K)
    with pytest.raises(gnomon.Error, match="no triangles"):
        model.merged()


PLY = (
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty {0} x\nproperty {0} y\nproperty {0} z\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n"
)


def test_clouds_of_points(tmp_path):
    rows = "0 0.5 1 255 0 0\n2 3 4 0 51 0\n5 6 7 0 0 102\n"
    model = load(write(tmp_path / "cloud.ply", PLY.format("float") + rows))
    assert model.meshes == [] and model.lines is None
    assert model.points.vertices.dtype == np.float32
    assert model.points.vertices.tolist() == [[0, 0.5, 1], [2, 3, 4], [5, 6, 7]]
    expected = [[1, 0, 0, 1], [0, 0.2, 0, 1], [0, 0, 0.4, 1]]
    assert np.allclose(model.points.colors, expected, atol=1e-7)
    assert model.points.normals is None


def test_far_clouds(tmp_path):
    # UTM: eastings and northings in metres, with centimetres, which float32 cannot hold.
    places = np.array([[0.25, 0.5, 0.125], [1.5, 2.75, 1], [3, 1, -0.5]]) + [500000, 4500000, 120]
    rows = "".join(f"{x} {y} {z} 0 0 0\n" for x, y, z in places)
    points = load(write(tmp_path / "utm.ply", PLY.format("double") + rows)).points
    assert points.vertices.dtype == np.float64
    assert np.abs(points.vertices - places).max() < 1e-6


def test_far_meshes(tmp_path):
    offset = np.array([500000.0, 4500000.0, 120.0])
    triangle = np.array([[-1, -1, 4], [1, -1, 4.25], [0.5, 1.75, 4.5]])
    lines = [f"v {x!r} {y!r} {z!r}\n" for x, y, z in (triangle + offset).tolist()]
    (mesh,) = load(write(tmp_path / "utm.obj", "".join(lines) + "f 1 2 3\n")).meshes
    assert mesh.vertices.dtype == np.float64
    assert np.abs(mesh.vertices[mesh.faces[0]] - (triangle + offset)).max() < 1e-6
    back = np.eye(4)
    back[:3, 3] = -offset
    far = gnomon.render(mesh, K=K, pose=back, **SIZE)
    near = gnomon.render(triangle, [[0, 1, 2]], K, **SIZE)
    assert (near.labels == 0).sum() > 100
    assert (far.labels != near.labels).sum() <= 4


def test_far_models_of_several_meshes(tmp_path):
    offset = np.array([500000.0, 4500000.0, 120.0])
    path = two_squares(tmp_path)
    near = load(path)
    lines = path.read_text().splitlines()
    for i, line in enumerate(lines):
        kind, *numbers = line.split()
        if kind == "v":
            x, y, z = np.array(numbers, float) + offset
            lines[i] = f"v {x} {y} {z}"
    far = load(write(tmp_path / "far.obj", "\n".join(lines)))
    back = np.eye(4)
    back[:3, 3] = -offset
    found = gnomon.render(far, K=K, pose=back, **SIZE)
    expected = gnomon.render(near, K=K, **SIZE)
    assert (expected.labels >= 0).sum() > 500
    assert (found.labels != expected.labels).sum() <= 8
    assert (np.abs(found.depth - expected.depth) > 1e-4).sum() <= 8


def test_creases(tmp_path):
    roof = "v -1 0 -1\nv 0 0 0\nv 0 1 0\nv -1 1 -1\nv 1 0 -1\nv 1 1 -1\nf 1 2 3 4\nf 2 5 6 3\n"
    path = write(tmp_path / "roof.obj", roof)
    half = math.sqrt(0.5)
    for crease, vertices in ({}, 8), ({"crease": 89}, 8), ({"crease": 91}, 6), ({"crease": 180}, 6):
        mesh = gnomon.load(path, **crease).meshes[0]
        ridge = mesh.normals[mesh.vertices[:, 0] == 0]
        assert len(mesh.vertices) == vertices
        sides = [-half, half] if vertices == 8 else [0]
        assert np.allclose(sorted(set(np.round(ridge[:, 0], 5))), sides, atol=1e-5)
    for crease in -1, 180.5, math.nan:
        with pytest.raises(gnomon.Error, match="crease"):
            gnomon.load(path, crease=crease)


def test_stl(tmp_path):
    text = (
        "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 3 0\n"
        "endloop\nendfacet\nendsolid s\n"
    )
    (mesh,) = load(write(tmp_path / "a.stl", text)).meshes
    assert mesh.vertices[mesh.faces].tolist() == [[[0, 0, 0], [2, 0, 0], [0, 3, 0]]]
    assert np.allclose(mesh.normals, [[0, 0, 1]] * 3)
    assert mesh.texcoords is None


def data_uri(kind, contents):
    return f"data:{kind};base64,{base64.b64encode(contents).decode()}"


def gltf(tmp_path, material, image=None, sampler=None, nodes=(), name="a.gltf"):
    """Writes a glTF of one square with texture coordinates, whose image and buffer are in it."""
    corners = [(-1, -1, 4), (1, -1, 4), (1, 1, 4), (-1, 1, 4)]
    positions = np.array(corners, "<f4").tobytes()
    texcoords = np.array([0, 0, 1, 0, 1, 1, 0, 1], "<f4").tobytes()
    buffer = positions + texcoords + np.array([0, 1, 2, 0, 2, 3], "<u2").tobytes()
    primitive = {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}
    lights = [
        {"type": "directional", "color": [1, 0.5, 0.25], "intensity": 2},
        {"type": "point", "intensity": 3},
        {"type": "spot"},
        {"type": "point", "range": 5},
    ]
    root = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": list(range(len(nodes) + 1))}],
        "nodes": [{"mesh": 0}, *nodes],
        "meshes": [{"primitives": [primitive]}],
        "materials": [material],
        "buffers": [
            {"byteLength": len(buffer), "uri": data_uri("application/octet-stream", buffer)}
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": 48},
            {"buffer": 0, "byteOffset": 48, "byteLength": 32},
            {"buffer": 0, "byteOffset": 80, "byteLength": 12},
        ],
        "accessors": [
            {
                "bufferView": 0,
                "componentType": 5126,
                "count": 4,
                "type": "VEC3",
                "min": [-1, -1, 4],
                "max": [1, 1, 4],
            },
            {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
            {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"},
        ],
        "extensionsUsed": ["KHR_lights_punctual"],
        "extensions": {"KHR_lights_punctual": {"lights": lights}},
    }
    if image is not None:
        root["images"] = [{"uri": data_uri("image/png", image), "name": "inner"}]
        root["samplers"] = [sampler or {}]
        root["textures"] = [{"source": 0, "sampler": 0}]
    return write(tmp_path / name, json.dumps(root))


def base_texture(**more):
    return {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, **more}}


def test_gltf_in_one_text(tmp_path):
    sampler = {"wrapS": 33648, "wrapT": 33071, "magFilter": 9728}
    path = gltf(tmp_path, base_texture(baseColorFactor=[1, 0, 1, 1]), png(quarters()), sampler)
    (mesh,) = load(path).meshes
    assert mesh.vertices[mesh.faces].reshape(-1, 3).tolist() == [
        [-1, -1, 4], [1, -1, 4], [1, 1, 4], [-1, -1, 4], [1, 1, 4], [-1, 1, 4],
    ]
    assert (mesh.colors == [1, 0, 1, 1]).all()
    diffuse = mesh.material.diffuse
    assert np.array_equal(diffuse.image, quarters())
    assert (diffuse.wrap, diffuse.filter) == (("mirror", "clamp"), "nearest")
    picture = gnomon.render(mesh, K=K, shader="unlit", **SIZE)
    # A glTF's (0, 0) is the image's upper left corner. Green times magenta is black.
    found = [picture.color[y, x, :3].tolist() for y in (18, 28) for x in (26, 36)]
    assert found == [RED, [0, 0, 0], BLUE, [255, 0, 255]]


def test_glow_is_the_map_times_the_factor(tmp_path):
    image = png(np.full((2, 2, 3), [200, 100, 40], np.uint8))
    material = {"emissiveTexture": {"index": 0}, "emissiveFactor": [0.5, 1, 0.25]}
    (mesh,) = load(gltf(tmp_path, material, image)).meshes
    assert mesh.material.glow.image[0, 0].tolist() == [100, 100, 10]


def test_normal_maps_have_tangents(tmp_path):
    flat = png(np.full((2, 2, 3), [128, 128, 255], np.uint8))
    (mesh,) = load(gltf(tmp_path, {"normalTexture": {"index": 0}}, flat)).meshes
    assert mesh.material.tangent_space and mesh.material.normal is not None
    # s grows along x.
    assert np.allclose(mesh.tangents[:, :3], [1, 0, 0])
    gnomon.render(mesh, K=K, **SIZE)


def test_lights(tmp_path):
    nodes = [
        {"extensions": {"KHR_lights_punctual": {"light": 0}}},
        {"extensions": {"KHR_lights_punctual": {"light": 1}}, "translation": [1, 2, 3]},
        {"extensions": {"KHR_lights_punctual": {"light": 2}}},
    ]
    model = gnomon.load(gltf(tmp_path, {}, nodes=nodes))
    sun, lamp, spot = model.lights
    # A light shines along -z of its node.
    assert np.allclose(sun.direction, [0, 0, 1]) and sun.position is None
    assert np.allclose(sun.diffuse, [2, 1, 0.5]) and np.allclose(sun.ambient, 0)
    assert np.allclose(lamp.position, [1, 2, 3]) and lamp.direction is None
    assert np.allclose(lamp.diffuse, 3) and lamp.attenuation == (0, 0, 1)
    assert lamp.range == 0
    assert np.allclose(spot.direction, [0, 0, 1]) and np.allclose(spot.position, 0)
    assert np.allclose(spot.cone, [0, math.pi / 4]) and spot.attenuation == (0, 0, 1)
    # The square is at z = 4 and the lights shine along -z, but for the lamp at its corner.
    picture = gnomon.render(model, K=K, light=model.lights, **SIZE)
    assert picture.color[24, 32].max() > 0


def test_ranges_of_lights(tmp_path):
    nodes = [{"extensions": {"KHR_lights_punctual": {"light": 3}}}]
    (lamp,) = gnomon.load(gltf(tmp_path, {}, nodes=nodes)).lights
    assert lamp.range == 5


@pytest.mark.parametrize(
    "image, expected",
    [
        (png(np.full((2, 2), 77, np.uint8), color=0), [77, 77, 77]),
        (png(np.full((2, 2), 77 * 257, np.uint16), bits=16, color=0), [77, 77, 77]),
        (png(np.full((2, 2, 4), [1, 2, 3, 4], np.uint8), color=6), [1, 2, 3]),
    ],
)
def test_kinds_of_images(tmp_path, image, expected):
    (mesh,) = load(gltf(tmp_path, base_texture(), image)).meshes
    # The material is opaque, so alpha has no meaning.
    assert mesh.material.diffuse.image.tolist() == [[expected] * 2] * 2


def test_alpha_is_warned_of(tmp_path):
    image = png(np.full((2, 2, 4), [1, 2, 3, 4], np.uint8), color=6)
    for mode, words in (("BLEND", "without blending"), ("MASK", "drawn whole")):
        path = gltf(tmp_path, {**base_texture(), "alphaMode": mode}, image)
        with pytest.warns(gnomon.ModelWarning, match=words):
            (mesh,) = gnomon.load(path).meshes
        assert mesh.material.diffuse.image[0, 0].tolist() == [1, 2, 3, 4]


def test_heights_are_not_drawn(textured):
    image = write(textured.parent / "bump.png", png(np.full((2, 2), 9, np.uint8), color=0))
    library = textured.parent / "a.mtl"
    library.write_text(library.read_text() + f"map_bump {image.name}\n")
    with pytest.warns(gnomon.ModelWarning, match="bump.png holds heights"):
        (mesh,) = gnomon.load(textured).meshes
    assert mesh.material.normal is None and mesh.material.diffuse is not None


def test_warnings_are_given_once(tmp_path):
    text = "mtllib none.mtl\n" + square_of_obj(material="m")
    path = write(tmp_path / "w.obj", text + "usemtl m\nf 1 2 3\n")
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        model = gnomon.load(path)
    assert [str(w.message) for w in caught] == model.warnings
    assert all(w.category is gnomon.ModelWarning for w in caught)
    assert caught[0].filename == __file__
    assert len(set(model.warnings)) == len(model.warnings)
    assert any("none.mtl" in text and str(path) in text for text in model.warnings)
    assert len(model.meshes) >= 1


def test_faults_name_the_file_and_the_place(tmp_path):
    path = write(tmp_path / "x.obj", "v 1 2 3\nv 1 2 4\nv 1 3 3\n\nf 1 2 4\n")
    refused("x.obj: line 5: .*4", path)
    refused("x.obj: line 1: ", write(path, "v 1 2\n"))
    refused("x.ply: .*line 2", write(tmp_path / "x.ply", "ply\nformat ascii 7.0\nend_header\n"))
    refused("x.gltf: ", write(tmp_path / "x.gltf", "{"))
    refused("x.obj: it is empty", write(path, ""))
    refused("x.obj: there are no triangles, lines or points", write(path, "vn 1 2 3\n"))
    refused("x.xyz: its extension", write(tmp_path / "x.xyz", "1 2 3\n"))
    with pytest.raises(FileNotFoundError, match="none.obj"):
        gnomon.load(tmp_path / "none.obj")
    with pytest.raises(IsADirectoryError):
        gnomon.load(tmp_path)


def test_memory_is_limited(textured):
    refused("memory= allows more", textured, memory=10)
    refused("memory= allows more", textured, memory=textured.stat().st_size + 10)
    large = np.zeros((300, 300, 3), np.uint8)
    write(textured.parent / "maps/four quarters.png", png(large))
    refused("has 300x300 texels, more than the memory allows", textured, memory=300_000)
    load(textured, memory=300_000, textures=False)
    for wrong in (0, -1, 1.5, True):
        with pytest.raises(gnomon.Error, match="memory"):
            gnomon.load(textured, memory=wrong)


def test_textures_that_cannot_be_read(textured):
    image = textured.parent / "maps/four quarters.png"
    whole = image.read_bytes()
    for contents, words in (
        (b"not an image", "is none of BMP, JPEG, PNG, PPM, TGA"),
        (whole[:60], "cannot be read: "),
        # Encapsulated PostScript is a format that Pillow would hand to another program.
        (b"%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 0 0 1 1\n", "is none of"),
    ):
        image.write_bytes(contents)
        refused(f"its texture .*four quarters.png' {words}.*textures=False", textured)
        load(textured, textures=False)
    image.unlink()
    refused("its texture .*four quarters.png' cannot be read: there is no such file", textured)
    os.mkfifo(image)
    refused("cannot be read: it is not a regular file", textured)


def test_a_pipe_beside_a_model_does_not_block(textured):
    (textured.parent / "a.mtl").unlink()
    os.mkfifo(textured.parent / "a.mtl")
    with pytest.warns(gnomon.ModelWarning, match="not a regular file"):
        gnomon.load(textured)


def test_pillow_is_named_where_it_is_missing(textured, monkeypatch):
    monkeypatch.setitem(sys.modules, "PIL", None)
    monkeypatch.setitem(sys.modules, "PIL.Image", None)
    refused("four quarters.png' needs Pillow", textured)
    load(textured, textures=False)


@pytest.mark.filterwarnings("ignore::gnomon.ModelWarning")
def test_threads_do_not_mix_their_messages(tmp_path):
    """A warning names the line of its own file, although two files are read at once."""

    def lines(first):
        text = "\n" * first + "".join(f"word{n}\n" + "again\n" * 200 for n in range(150))
        path = write(tmp_path / f"{first}.obj", text + "v 0 0 0\nf 1 1 1\n")
        for _ in range(10):
            for words in gnomon.load(path).warnings:
                number = re.search(r"line (\d+): word(\d+) is", words)
                if number:
                    assert int(number[1]) == first + 201 * int(number[2]) + 1

    with ThreadPoolExecutor(2) as threads:
        list(threads.map(lines, (0, 5000)))
