"""Drawing: where things are, what the arrays hold, batches, threads, memory and faults."""

import math
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import gnomon

K = np.array([[40.0, 0, 31.5], [0, 40.0, 23.5], [0, 0, 1]])
SIZE = {"width": 64, "height": 48}


def square(z=4.0, half=1.0):
    vertices = np.array(
        [[-half, -half, z], [half, -half, z], [half, half, z], [-half, half, z]], np.float32
    )
    return vertices, np.array([[0, 1, 2], [0, 2, 3]], np.uint32)


def hashes(pictures):
    return [getattr(pictures, name).tobytes() for name in gnomon.OUTPUTS]


def test_a_square_is_where_opencv_puts_it():
    picture = gnomon.render(*square(), K, **SIZE)
    # 40 pixels at distance 1: 10 to either side of the middle, 31.5 and 23.5.
    rows, columns = np.nonzero(picture.labels >= 0)
    assert (columns.min(), columns.max()) == (22, 41)
    assert (rows.min(), rows.max()) == (14, 33)
    assert picture.labels.shape == (48, 64) and picture.labels.dtype == np.int32
    assert picture.color.shape == (48, 64, 4) and picture.color.dtype == np.uint8
    assert picture.normals.shape == (48, 64, 3) and picture.normals.flags.c_contiguous
    inside = picture.labels >= 0
    assert np.allclose(picture.depth[inside], 4, atol=1e-5)
    assert (picture.depth[~inside] == 0).all() and (picture.color[~inside] == 0).all()
    assert (np.abs(picture.normals[inside]) == [0, 0, 1]).all()
    assert (picture.normals[~inside] == 0).all()
    assert set(np.unique(picture.labels)) == {-1, 0, 1}
    # y points down: the first face, at the upper right, has the first vertex' row above.
    assert picture.labels[15, 40] == 0 and picture.labels[32, 23] == 1


@settings(deadline=None, max_examples=40)
@given(
    st.tuples(st.floats(-0.5, 0.5), st.floats(-0.4, 0.4), st.floats(2, 6)),
    st.floats(-1, 1),
    st.integers(0, 2**32 - 1),
)
def test_depths_and_normals_are_those_of_rays(centre, tilt, seed):
    """A tilted square: each pixel's ray is intersected in double precision."""
    turn = gnomon.rotate_axis((1, 0.5, 0.25), tilt).matrix[:3, :3]
    vertices, faces = square(0.0, 0.75)
    model = np.eye(4, dtype=np.float32)
    model[:3, :3] = turn
    model[:3, 3] = centre
    picture = gnomon.render(vertices, faces, K, model=model, **SIZE)
    inside = picture.labels >= 0
    normal = turn[:, 2].astype(np.float64)
    rows, columns = np.nonzero(inside)
    assert len(rows)
    rays = np.stack([(columns - 31.5) / 40, (rows - 23.5) / 40, np.ones(len(rows))], axis=1)
    distances = np.dot(centre, normal) / (rays @ normal)
    assert np.allclose(picture.depth[inside], distances, rtol=1e-5)
    assert np.allclose(np.abs(picture.normals[inside] @ normal), 1, atol=1e-5)


@pytest.mark.parametrize("distance", [0.06, 1.0, 30.0, 999.0])
def test_depths_are_precise_at_all_distances(distance):
    vertices, faces = square(distance, distance)
    for outputs in (["depth"], ["depth", "labels"], ["depth", "color"]):
        depth = gnomon.render(vertices, faces, K, outputs=outputs, **SIZE).depth
        assert np.allclose(depth[depth > 0], distance, rtol=1e-5) and (depth > 0).any()


def test_poses_move_the_camera():
    pose = np.eye(4)
    pose[0, 3] = 0.5  # from the world to the camera: what is seen moves to the right
    moved = gnomon.render(*square(), K, pose, **SIZE)
    columns = np.nonzero(moved.labels >= 0)[1]
    assert (columns.min(), columns.max()) == (27, 46)
    assert hashes(moved) == hashes(gnomon.render(*square(), K, pose[:3], **SIZE))
    assert (moved.labels >= 0).sum() == 400


def test_projections_of_opengl_look_along_minus_z():
    view = gnomon.look_at((0, 0, 4), (0, 0, 0), (0, 1, 0))
    projection = gnomon.perspective(math.pi / 2, 64 / 48, 0.1, 10)
    vertices, faces = square(0.0)
    picture = gnomon.render(vertices, faces, projection=projection, pose=view, **SIZE)
    inside = picture.labels >= 0
    assert inside.sum() == 12 * 12 and np.allclose(picture.depth[inside], 4)
    box = gnomon.orthographic(-2, 2, -1.5, 1.5, 0, 10)
    picture = gnomon.render(vertices, faces, projection=box, pose=view, **SIZE)
    inside = picture.labels >= 0
    assert inside.sum() == 32 * 32 and np.allclose(picture.depth[inside], 4)


def test_batches_are_single_pictures_whatever_the_threads():
    poses = np.stack([gnomon.rotate_y(0.1 * n).matrix for n in range(7)])
    single = [gnomon.render(*square(), K, pose, **SIZE, threads=1) for pose in poses]
    for threads in (1, 2, 3, 8):
        batch = gnomon.render(*square(), K, poses, **SIZE, threads=threads)
        assert batch.color.shape == (7, 48, 64, 4)
        assert batch.normals.shape == (7, 48, 64, 3)
        for n, one in enumerate(single):
            for name in gnomon.OUTPUTS:
                assert np.array_equal(getattr(batch, name)[n], getattr(one, name))
    several = gnomon.render(*square(), np.stack([K] * 7), poses, **SIZE)
    assert np.array_equal(several.color, batch.color)


def test_large_pictures_are_the_same_with_threads():
    random = np.random.default_rng(1)
    vertices = random.normal(size=(3000, 3)).astype(np.float32) + np.float32([0, 0, 5])
    faces = np.arange(3000, dtype=np.uint32).reshape(1000, 3)
    large = {"width": 640, "height": 480}
    k = [[400, 0, 319.5], [0, 400, 239.5], [0, 0, 1]]
    one = gnomon.render(vertices, faces, k, threads=1, antialias=True, **large)
    four = gnomon.render(vertices, faces, k, threads=4, antialias=True, **large)
    assert hashes(one) == hashes(four)


def test_arrays_are_drawn_to_where_they_are():
    first = gnomon.render(*square(), K, **SIZE)
    kept = {name: getattr(first, name) for name in gnomon.OUTPUTS}
    before = hashes(first)
    other = gnomon.render(*square(5.0), K, **SIZE, out=first)
    for name, array in kept.items():
        assert np.shares_memory(array, getattr(other, name))
    assert hashes(first) != before and hashes(first) == hashes(other)
    with pytest.raises(gnomon.Error, match="out: color"):
        gnomon.render(*square(), K, width=32, height=32, out=first)


def test_only_the_outputs_asked_for():
    picture = gnomon.render(*square(), K, **SIZE, outputs=["depth"])
    assert picture.color is None and picture.normals is None and picture.labels is None
    random = np.random.default_rng(2)
    vertices = random.normal(size=(300, 3)).astype(np.float32) + np.float32([0, 0, 4])
    faces = np.arange(300).reshape(100, 3)
    for antialias in (False, True):
        depths = [
            gnomon.render(vertices, faces, K, **SIZE, outputs=outputs, antialias=antialias).depth
            for outputs in (["depth"], ["depth", "color"], ["depth", "labels"], gnomon.OUTPUTS)
        ]
        assert (depths[0] > 0).any()
        assert all(np.array_equal(depths[0], depth) for depth in depths)
    for outputs, words in ((["colour"], "'colour'"), ([], "is empty")):
        with pytest.raises(gnomon.Error, match=words):
            gnomon.render(*square(), K, **SIZE, outputs=outputs)


def test_labels_colors_and_textures():
    vertices, faces = square()
    mesh = gnomon.Mesh(vertices, faces, labels=[7, gnomon.scene.MOST_LABEL])
    picture = gnomon.render(mesh, K=K, **SIZE)
    assert set(np.unique(picture.labels)) == {-1, 7, gnomon.scene.MOST_LABEL}
    reds = np.tile(np.array([200, 0, 0], np.uint8), (4, 1))
    picture = gnomon.render(vertices, faces, K, colors=reds, shader="unlit", **SIZE)
    assert (picture.color[picture.labels >= 0] == [200, 0, 0, 255]).all()
    image = np.zeros((2, 2, 3), np.uint8)
    image[0, 0], image[0, 1], image[1, 0] = (255, 0, 0), (0, 255, 0), (0, 0, 255)
    # The camera's y points down, so v = 1 at the smaller y is at the top.
    texcoords = [[0, 1], [1, 1], [1, 0], [0, 0]]
    for filter in ("nearest", "linear", "trilinear"):
        picture = gnomon.render(
            vertices, faces, K, texcoords=texcoords, shader="unlit",
            texture=gnomon.Texture(image, filter, "clamp"), **SIZE,
        )
        assert picture.color[14, 22, :3].tolist() == [255, 0, 0]
        assert picture.color[14, 41, :3].tolist() == [0, 255, 0]
        assert picture.color[33, 22, :3].tolist() == [0, 0, 255]


def test_light_and_shaders():
    vertices, faces = square()
    normals = np.tile(np.float32([0, 0, -1]), (4, 1))
    mesh = gnomon.Mesh(vertices, faces, normals=normals)
    inside = gnomon.render(mesh, K=K, **SIZE).labels >= 0
    for shader in gnomon.SHADERS:
        picture = gnomon.render(mesh, K=K, shader=shader, **SIZE)
        assert (picture.color[inside][:, 3] == 255).all()
    front = gnomon.render(mesh, K=K, shader="phong", **SIZE).color[24, 32, 0]
    assert front == 255
    side = gnomon.Light(direction=(1, 0, 0), ambient=(0.2, 0.2, 0.2))
    dark = gnomon.render(mesh, K=K, light=side, **SIZE).color[24, 32, 0]
    assert dark == 51
    near = gnomon.Light(position=(0, 0, 0), attenuation=(0, 0, 1 / 16), ambient=(0, 0, 0), diffuse=(0.5, 0.5, 0.5))
    assert gnomon.render(mesh, K=K, light=near, **SIZE).color[24, 32, 0] in (127, 128)


def test_culling_and_background():
    vertices, faces = square()
    back = gnomon.render(vertices, faces, K, cull="back", background=(1, 0, 0, 1), **SIZE)
    front = gnomon.render(vertices, faces, K, cull="front", background=(1, 0, 0, 1), **SIZE)
    assert {(back.labels >= 0).sum(), (front.labels >= 0).sum()} == {0, 400}
    assert (back.color[0, 0] == [255, 0, 0, 255]).all()


def test_nothing_to_draw_is_no_fault():
    picture = gnomon.render(np.zeros((0, 3)), np.zeros((0, 3), int), K, **SIZE)
    assert (picture.labels == -1).all() and (picture.depth == 0).all()
    behind = gnomon.render(*square(-4.0), K, **SIZE)
    assert (behind.labels == -1).all()


@pytest.mark.parametrize(
    "change, words",
    [
        ({"faces": [[0, 1, 4]]}, "faces: has 4, not 0 to 3, as there are 4 vertices"),
        ({"faces": [[0, 1]]}, r"faces: has the shape \(1, 2\)"),
        ({"faces": [[0.0, 1.0, 2.0]]}, "not .any, 3. of integers"),
        ({"vertices": [[0, 1]]}, r"vertices: has the shape \(1, 2\), not \(any, 3\)"),
        ({"vertices": "abc"}, "vertices: is no array of numbers"),
        ({"normals": [[0, 0, 1]]}, r"normals: has the shape \(1, 3\), not \(4, 3\)"),
        ({"K": None}, "needs K or projection"),
        ({"projection": np.eye(4)}, "needs K or projection, and takes one of them"),
        ({"K": np.full((3, 3), math.nan)}, "K: has a number that is not finite"),
        ({"pose": np.full((4, 4), math.nan)}, "pose: has a number that is not finite"),
        ({"pose": np.zeros((4, 4))}, "pose: "),
        ({"pose": np.eye(3)}, r"pose: has the shape \(3, 3\)"),
        ({"width": 0}, "width: is 0, not in 1 to 16384"),
        ({"height": 20000}, "height: is 20000"),
        ({"threads": 0}, "threads: is 0, not in 1 to 64"),
        ({"shader": "blinn"}, "shader: is 'blinn', not one of unlit"),
        ({"shader": "phong"}, "phong needs normals"),
        ({"cull": "left"}, "cull: is 'left'"),
        ({"near": 2.0, "far": 1.0}, "0 < near < far"),
        ({"labels": [1]}, r"labels: has the shape \(1,\)"),
        ({"labels": [1, -1]}, "labels: has -1, not 0 to"),
        ({"model": np.zeros((4, 4))}, "model: "),
        ({"background": (0, 0, 0)}, r"background: has the shape \(3,\), not \(4\)"),
        ({"texture": np.zeros((2, 2, 2), np.uint8)}, "image: has the shape"),
        ({"texture": np.zeros((0, 2, 3), np.uint8)}, "texture: "),
        ({"light": gnomon.Light(direction=(0, 0, 0))}, "light.direction: "),
        ({"light": gnomon.Light(position=(0, 0, 1), range=-1)}, "range: is -1, not a distance"),
        ({"light": gnomon.Light(cone=(1.0, 0.5))}, r"cone: is \(1.0, 0.5\), not two rising angles"),
        ({"light": gnomon.Light(cone=(0.0, 1.6))}, "cone: is .* not two rising angles"),
        ({"material": gnomon.Material(bands=1)}, "render: "),
    ],
)
def test_faults(change, words):
    vertices, faces = square()
    arguments = {"vertices": vertices, "faces": faces, "K": K, **SIZE, **change}
    with pytest.raises(gnomon.Error, match=words):
        gnomon.render(**arguments)


def test_flushing_denormals_changes_nothing(tmp_path):
    """Code of others, such as what GCC before 13 made with -ffast-math, flushes denormal numbers when loaded."""
    compiler = shutil.which("cc")
    assert compiler, "the test needs a C compiler"
    source, library = tmp_path / "fast.c", tmp_path / "fast.so"
    source.write_text(
        "#ifdef __SSE__\n#include <xmmintrin.h>\n"
        "__attribute__((constructor)) static void flush(void) { _mm_setcsr(_mm_getcsr() | 0x8040); }\n"
        "#endif\nint gnomon_test_fast;\n"
    )
    build = [compiler, "-shared", "-fPIC", str(source), "-o", str(library)]
    subprocess.run(build, check=True)
    script = Path(__file__).with_name("flushing.py")
    done = subprocess.run(
        [sys.executable, str(script), str(library)], capture_output=True, text=True, check=False
    )
    assert done.stdout.strip() == "equal", done.stdout + done.stderr


def test_contract_holds():
    result = gnomon.contract(every=20)
    assert result and result.differing == 0
    assert result.classes > 50 and result.scenes >= 200
    with pytest.raises(ValueError, match="every"):
        gnomon.contract(0)


def test_wraps():
    # Texture coordinates from -1 to 2 in s: the image is in the middle third, 22 to 41 / 3.
    vertices, faces = square(half=3.0)
    texcoords = np.array([[-1, 0], [2, 0], [2, 1], [-1, 1]], np.float32)
    image = np.array([[[255, 0, 0], [0, 255, 0]]], np.uint8)
    red, green, white = [255, 0, 0], [0, 255, 0], [255, 255, 255]
    expected = {
        "repeat": [red, green, red, green, red, green],
        "clamp": [red, red, red, green, green, green],
        "mirror": [green, red, red, green, green, red],
        "border": [white, white, red, green, white, white],
    }
    for wrap, colors in expected.items():
        for given in (wrap, (wrap, "repeat")):
            texture = gnomon.Texture(image, "nearest", given)
            mesh = gnomon.Mesh(vertices, faces, texcoords=texcoords)
            picture = gnomon.render(mesh, K=K, texture=texture, shader="unlit", **SIZE)
            # 60 pixels from 1.5 on show 6 texels.
            row = picture.color[24, 7:62:10, :3]
            assert row.tolist() == colors, wrap
    for wrong in ("tile", ("repeat", "tile"), ("repeat",)):
        with pytest.raises(gnomon.Error, match="wrap"):
            gnomon.Texture(image, wrap=wrong)
