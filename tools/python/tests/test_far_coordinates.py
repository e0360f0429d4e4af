"""Scenes far from the origin: what is drawn there equals the same scene at the origin."""

import numpy as np
import pytest

import gnomon

K = np.array([[200.0, 0, 127.5], [0, 200.0, 95.5], [0, 0, 1]])
SIZE = {"width": 256, "height": 192}
# The last is in metres on a map (UTM), where a float32 has steps of half a metre.
OFFSETS = [(1000.0, 1000.0, 10.0), (10000.0, 10000.0, 10.0), (500000.0, 4500000.0, 120.0)]
# Coordinates of float64 have steps of 2^-30 at 4.5 million: a pixel's centre that is nearer to an
# edge than that may change sides.
MOST_OTHER_PIXELS = 4


def triangles():
    """Returns 20 triangles in front of a camera at the origin, as float64, and their normals."""
    random = np.random.default_rng(1)
    vertices = random.uniform(-1, 1, (60, 3)) * [2, 2, 0.5] + [0, 0, 6]
    normals = random.uniform(-1, 1, (60, 3)) - [0, 0, 2]
    return vertices, np.arange(60).reshape(20, 3), normals


def moved(offset):
    matrix = np.eye(4)
    matrix[:3, 3] = offset
    return matrix


def assert_same_scene(found, expected):
    inside = found.labels >= 0
    assert (expected.labels >= 0).sum() > 5000
    other = (found.labels != expected.labels) | (inside != (expected.labels >= 0))
    assert other.sum() <= MOST_OTHER_PIXELS
    assert np.abs(found.depth - expected.depth)[~other].max() < 1e-4
    assert np.abs(found.normals - expected.normals)[~other].max() < 1e-4
    steps = np.abs(found.color.astype(int) - expected.color.astype(int))[~other]
    assert steps.max() <= 1


@pytest.mark.parametrize("offset", OFFSETS)
@pytest.mark.parametrize("with_normals", [False, True])
def test_far_vertices_and_poses(offset, with_normals):
    vertices, faces, normals = triangles()
    given = {"normals": normals} if with_normals else {}
    expected = gnomon.render(vertices, faces, K, **given, **SIZE)
    found = gnomon.render(
        vertices + offset, faces, K, moved(-np.array(offset)), **given, **SIZE
    )
    assert_same_scene(found, expected)


@pytest.mark.parametrize("offset", OFFSETS)
def test_far_models(offset):
    vertices, faces, _ = triangles()
    expected = gnomon.render(vertices, faces, K, **SIZE)
    away, back = moved(offset), moved(-np.array(offset))
    assert_same_scene(gnomon.render(vertices, faces, K, back, model=away, **SIZE), expected)
    assert_same_scene(gnomon.render(vertices + offset, faces, K, model=back, **SIZE), expected)
    assert_same_scene(
        gnomon.render(vertices, faces, K, back[:3], model=away[:3], **SIZE), expected
    )


@pytest.mark.parametrize("offset", OFFSETS)
def test_far_lights_and_highlights(offset):
    vertices, faces, normals = triangles()
    material = gnomon.Material(specular=(0.5, 0.5, 0.5), exponent=8)
    place = np.array([1.0, -1.0, 2.0])
    near = gnomon.Light(position=place, attenuation=(1.0, 0.1, 0.01))
    far = gnomon.Light(position=place + offset, attenuation=(1.0, 0.1, 0.01))
    mesh = gnomon.Mesh(vertices, faces, normals=normals)
    expected = gnomon.render(mesh, K=K, light=near, material=material, **SIZE)
    mesh = gnomon.Mesh(vertices + offset, faces, normals=normals)
    pose = moved(-np.array(offset))
    found = gnomon.render(mesh, K=K, pose=pose, light=far, material=material, **SIZE)
    assert_same_scene(found, expected)


def test_far_batches_are_single_pictures():
    vertices, faces, _ = triangles()
    offset = np.array(OFFSETS[2])
    turns = [gnomon.rotate_y(0.05 * n).matrix.astype(np.float64) for n in range(3)]
    poses = np.stack([turn @ moved(-offset) for turn in turns])
    batch = gnomon.render(vertices + offset, faces, K, poses, **SIZE)
    for n, turn in enumerate(turns):
        one = gnomon.render(vertices + offset, faces, K, poses[n], **SIZE)
        assert np.array_equal(batch.labels[n], one.labels)
        assert np.array_equal(batch.depth[n], one.depth)
        # poses[n] rounds turn * offset to steps of 2^-30 too.
        near = gnomon.render(vertices, faces, K, turn, **SIZE)
        assert (batch.labels[n] != near.labels).sum() <= MOST_OTHER_PIXELS


def test_vertices_that_no_face_has_do_not_matter():
    vertices, faces, _ = triangles()
    offset = np.array(OFFSETS[2])
    more = np.concatenate([vertices + offset, [[0, 0, 0], [np.nan, np.inf, 0]]])
    found = gnomon.render(more, faces, K, moved(-offset), **SIZE)
    assert_same_scene(found, gnomon.render(vertices, faces, K, **SIZE))


def test_near_vertices_are_used_where_they_are():
    vertices = np.float32([[-1, -1, 4], [1, -1, 4], [0, 1, 4]])
    mesh = gnomon.Mesh(vertices, [[0, 1, 2]])
    assert mesh.vertices is vertices
    mesh.vertices[:, 2] = 5
    picture = gnomon.render(mesh, K=K, **SIZE)
    assert np.allclose(picture.depth[picture.labels >= 0], 5, atol=1e-5)
    with pytest.raises(AttributeError):
        mesh.vertices = vertices


def test_far_vertices_are_copied_so_they_cannot_be_written():
    far = np.array([[-1, -1, 4], [1, -1, 4], [0, 1, 4]]) + OFFSETS[2]
    mesh = gnomon.Mesh(far, [[0, 1, 2]])
    assert np.array_equal(mesh.vertices, far)
    with pytest.raises(ValueError, match="read-only"):
        mesh.vertices[:, 2] = 5


def test_float32_and_float64_of_the_same_numbers_are_the_same_picture():
    vertices, faces, _ = triangles()
    for offset in ((0, 0, 0), (4096, -4096, 64)):
        narrow = (vertices + offset).astype(np.float32)
        a = gnomon.render(narrow, faces, K, moved(-np.array(offset)), **SIZE)
        b = gnomon.render(narrow.astype(np.float64), faces, K, moved(-np.array(offset)), **SIZE)
        for name in gnomon.OUTPUTS:
            assert np.array_equal(getattr(a, name), getattr(b, name))


def test_numbers_beyond_float32_are_refused():
    vertices, faces, _ = triangles()
    with pytest.raises(gnomon.Error, match="vertices: has a number that float32 cannot hold"):
        gnomon.render(vertices * 1e300, faces, K, **SIZE)
    with pytest.raises(gnomon.Error, match="pose: has a number that float32 cannot hold"):
        gnomon.render(vertices, faces, K, moved((0, 0, 1e200)), **SIZE)
    with pytest.raises(gnomon.Error, match="model: has a number that float32 cannot hold"):
        gnomon.render(vertices, faces, K, model=np.diag([1e200, 1, 1, 1]), **SIZE)
