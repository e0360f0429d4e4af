"""Scenes: several meshes, cameras by their place in the world, lights, shadows, files of textures."""

import math
import warnings

import numpy as np
import pytest

import gnomon

K = np.array([[40.0, 0, 31.5], [0, 40.0, 23.5], [0, 0, 1]])
SIZE = {"width": 64, "height": 48}
FACES = np.array([[0, 1, 2], [0, 2, 3]], np.uint32)


def square(z=4.0, half=1.0, x=0.0, **more):
    vertices = np.float32([[-half, -half, z], [half, -half, z], [half, half, z], [-half, half, z]])
    return gnomon.Mesh(vertices + np.float32([x, 0, 0]), FACES, **more)


def moved(x, y, z):
    matrix = np.eye(4)
    matrix[:3, 3] = x, y, z
    return matrix


def same(a, b):
    return all(np.array_equal(getattr(a, name), getattr(b, name)) for name in gnomon.OUTPUTS)


def refused(words, *arguments, **named):
    with pytest.raises(gnomon.Error, match=words):
        gnomon.render(*arguments, **{"K": K, **SIZE, **named})


def test_several_meshes_are_one_picture():
    left, right = square(x=-1.0, half=0.5), square(x=1.0, half=0.5)
    found = gnomon.render([left, right], K=K, **SIZE)
    both = gnomon.Mesh(
        np.concatenate([left.vertices, right.vertices]), np.concatenate([FACES, FACES + 4])
    )
    assert same(found, gnomon.render(both, K=K, **SIZE))
    assert set(np.unique(found.labels)) == {-1, 0, 1, 2, 3}
    assert same(found, gnomon.render((left, right), K=K, **SIZE))


def test_a_mesh_hides_another_of_the_list():
    near, far = square(3.0, 0.5, labels=1), square(5.0, 3.0, labels=2)
    for order in ([near, far], [far, near]):
        picture = gnomon.render(order, K=K, **SIZE)
        assert picture.labels[24, 32] == 1 and picture.labels[2, 10] == 2


def test_each_mesh_has_its_place():
    one = square(0.0, 0.5, labels=7)
    places = [moved(-1, 0, 4), moved(1, 0, 4)]
    found = gnomon.render([one, one], K=K, model=places, **SIZE)
    expected = gnomon.render(
        [square(x=-1.0, half=0.5, labels=7), square(x=1.0, half=0.5, labels=7)], K=K, **SIZE
    )
    assert np.array_equal(found.labels, expected.labels) and (found.labels == 7).sum() > 100
    as_transforms = [gnomon.translate((-1, 0, 4)), gnomon.translate((1, 0, 4))]
    assert same(found, gnomon.render([one, one], K=K, model=as_transforms, **SIZE))
    refused("model: has 3 matrices for 2 meshes", [one, one], model=np.stack([np.eye(4)] * 3))
    refused("vertices: is of ndarray, not Mesh", [one, one.vertices])
    refused("no faces and no attributes beside a Mesh", [one], FACES)


def test_far_meshes_have_their_places():
    one, far = square(0.0, 0.5), np.array([4e6, 5e6, 100.0])
    places = [moved(-1, 0, 4), moved(1, 0, 4)]
    expected = gnomon.render([one, one], K=K, model=places, **SIZE)
    away = [moved(*far) @ place for place in places]
    found = gnomon.render([one, one], K=K, pose=moved(*-far), model=away, **SIZE)
    assert np.array_equal(found.labels, expected.labels)
    assert np.allclose(found.depth, expected.depth, atol=1e-4)


def test_bounds_of_several_meshes():
    one, flat = square(0.0, 0.5).placed, square(2.0, 1.0).placed
    twice = np.diag([2.0, 2.0, 2.0, 1.0])
    middle, half = gnomon.placing.world_bounds([one, flat], [moved(-3, 0, 4), twice])
    assert middle.tolist() == [-0.75, 0, 4] and half.tolist() == [2.75, 2, 0]
    # Meshes without vertices take up nothing.
    nothing = gnomon.Mesh(np.zeros((0, 3)), np.zeros((0, 3), int)).placed
    middle, half = gnomon.placing.world_bounds([nothing, one], [np.eye(4), moved(-3, 0, 4)])
    assert middle.tolist() == [-3, 0, 4] and half.tolist() == [0.5, 0.5, 0]


def turned(seed):
    """Returns the pose of a camera in the world, whose axes are OpenGL's."""
    random = np.random.default_rng(seed)
    turn = gnomon.rotation_matrix(random.normal(size=3), 0.3).astype(np.float64)
    pose = moved(*random.uniform(-0.5, 0.5, 3))
    pose[:3, :3] = turn @ np.diag([1, -1, -1])
    return pose


@pytest.mark.parametrize("seed", range(4))
def test_camera_poses_are_those_of_opengl(seed):
    camera = turned(seed)
    mesh = square()
    found = gnomon.render(mesh, K=K, camera_pose=camera, **SIZE)
    to_camera = np.diag([1.0, -1, -1, 1]) @ np.linalg.inv(camera)
    assert (found.labels >= 0).any()
    expected = gnomon.render(mesh, K=K, pose=to_camera, **SIZE)
    assert (found.labels != expected.labels).sum() <= 2
    assert np.abs(found.depth - expected.depth)[found.labels == expected.labels].max() < 1e-5
    # A camera at the origin of K's axes is the identity with y and z reversed.
    assert same(
        gnomon.render(mesh, K=K, camera_pose=np.diag([1, -1, -1, 1]), **SIZE),
        gnomon.render(mesh, K=K, **SIZE),
    )


def test_camera_poses_go_with_projections():
    eye = gnomon.look_at((1, 2, 8), (0, 0, 4), (0, 1, 0))
    for convention in ("rh_no", "rh_zo"):
        lens = {"projection": gnomon.perspective(1.0, 64 / 48, 0.1, 20, convention)}
        expected = gnomon.render(square(), pose=eye, **lens, **SIZE)
        assert (expected.labels >= 0).any()
        found = gnomon.render(square(), camera_pose=~eye, **lens, **SIZE)
        assert (found.labels != expected.labels).sum() <= 2
    left = {"projection": gnomon.perspective(1.0, 64 / 48, 0.1, 20, "lh_no")}
    # The camera's own axes do not depend on the projection's handedness.
    found = gnomon.render(square(), camera_pose=~eye, **left, **SIZE)
    assert (found.labels != expected.labels).sum() <= 2


def test_batches_of_camera_poses():
    cameras = np.stack([turned(seed) for seed in range(5)])
    batch = gnomon.render(square(), K=K, camera_pose=cameras, **SIZE)
    assert batch.labels.shape == (5, 48, 64)
    for n, camera in enumerate(cameras):
        one = gnomon.render(square(), K=K, camera_pose=camera, **SIZE)
        assert np.array_equal(batch.color[n], one.color) and np.array_equal(batch.depth[n], one.depth)
    listed = gnomon.render(square(), K=K, camera_pose=list(cameras), **SIZE)
    assert same(listed, batch)
    poses = [gnomon.translate((0, 0, z)) for z in (0, 1)]
    assert gnomon.render(square(), K=K, pose=poses, **SIZE).labels.shape == (2, 48, 64)


def test_faults_of_camera_poses():
    refused("takes pose, .* or camera_pose", square(), pose=np.eye(4), camera_pose=np.eye(4))
    flat = np.eye(4)
    flat[2, 2] = 0
    refused("camera_pose: has no inverse", square(), camera_pose=flat)
    refused("camera_pose: its last row is 1 2 3 1", square(), camera_pose=moved(1, 2, 3).T)
    lenses = np.stack([gnomon.perspective(1.0, 1.0, 0.1, 9, c).matrix for c in ("rh_no", "lh_no")])
    refused("look along", square(), K=None, projection=lenses, camera_pose=np.eye(4))


@pytest.mark.parametrize("smooth", [False, True])
@pytest.mark.parametrize("seed", range(3))
def test_normals_in_the_axes_of_the_camera(seed, smooth):
    random = np.random.default_rng(seed)
    vertices = random.uniform(-1, 1, (30, 3)) + [0, 0, 4]
    given = {"normals": random.normal(size=(30, 3))} if smooth else {}
    mesh = gnomon.Mesh(vertices, np.arange(30).reshape(10, 3), **given)
    camera = turned(seed)
    turn = camera[:3, :3]
    world = gnomon.render(mesh, K=K, camera_pose=camera, **SIZE)
    drawn = world.labels >= 0
    assert drawn.any()
    found = gnomon.render(mesh, K=K, camera_pose=camera, normals_in="camera", **SIZE)
    # Between vertices whose normals nearly cancel, rounding becomes larger.
    assert np.allclose(found.normals[drawn], world.normals[drawn] @ turn, atol=5e-5)
    assert (found.normals[~drawn] == 0).all()
    # With pose, they are the axes of OpenCV: y down, z forward.
    pose = np.diag([1.0, -1, -1, 1]) @ np.linalg.inv(camera)
    cv = gnomon.render(mesh, K=K, pose=pose, normals_in="camera", **SIZE)
    both = drawn & (cv.labels == found.labels)
    assert np.allclose(cv.normals[both], found.normals[both] * [1, -1, -1], atol=5e-5)
    refused("normals_in: is 'eye', not one of world, camera", mesh, normals_in="eye")


def test_normals_of_faces_of_any_size():
    for size in (1e-12, 1.0, 1e12):
        vertices = np.float32([[-1, -1, 1], [1, -1, 1], [0, 1, 1]]) * np.float32(size)
        picture = gnomon.render(
            vertices, [[0, 1, 2]], K, near=0.5 * size, far=2 * size, outputs=["normals"], **SIZE
        )
        assert np.abs(picture.normals[24, 32]).tolist() == [0, 0, 1], size


def test_several_lights_add_up():
    mesh = square(normals=np.tile(np.float32([0, 0, -1]), (4, 1)))
    dark = {"ambient": (0, 0, 0)}
    red = gnomon.Light(direction=(0, 0, -1), diffuse=(0.4, 0, 0), **dark)
    green = gnomon.Light(position=(0, 0, -1e4), diffuse=(0, 0.2, 0), **dark)
    blue = gnomon.Light(diffuse=(0, 0, 0.6), **dark)  # from the camera
    for lights in ([red, green, blue], (blue, green, red)):
        picture = gnomon.render(mesh, K=K, light=lights, **SIZE)
        assert picture.color[24, 32].tolist() == [102, 51, 153, 255]
    turned_away = gnomon.render(mesh, K=K, light=[blue] * 8, **SIZE).color[24, 32, 2]
    assert turned_away == 255
    refused("light: has 9 lights, not 1 to 8", mesh, light=[blue] * 9)
    refused("light: has 0 lights", mesh, light=[])
    refused("light: is of str, not Light", mesh, light=[red, "blue"])


def test_cones_and_ranges():
    """A plane that faces the camera, lit from there: each pixel's light is computed from its ray."""
    wall = square(4.0, 8.0, normals=np.tile(np.float32([0, 0, -1]), (4, 1)))
    inner, outer, reach = 0.2, 0.4, 6.0
    spot = gnomon.Light(
        direction=(0, 0, -1), position=(0, 0, 0), cone=(inner, outer), range=reach, ambient=(0, 0, 0),
        diffuse=(0.8, 0.8, 0.8),
    )
    found = gnomon.render(wall, K=K, light=spot, **SIZE).color[..., 0].astype(float) / 255
    x, y = np.meshgrid((np.arange(64) - 31.5) / 40, (np.arange(48) - 23.5) / 40)
    cosine = 1 / np.sqrt(x * x + y * y + 1)
    fade = (cosine - math.cos(outer)) / (math.cos(inner) - math.cos(outer))
    window = np.maximum(1 - (4 / cosine / reach) ** 4, 0)
    expected = 0.8 * cosine * np.clip(fade, 0, 1) ** 2 * window
    assert (expected == 0).any() and ((0 < fade) & (fade < 1)).any() and expected.max() > 0.5
    assert np.abs(found - expected).max() < 0.6 / 255
    # A direction alone is the sun's, and a position alone shines to all sides.
    bulb = gnomon.Light(position=(0, 0, 0), ambient=(0, 0, 0), diffuse=(0.8, 0.8, 0.8))
    found = gnomon.render(wall, K=K, light=bulb, **SIZE).color[..., 0].astype(float) / 255
    assert np.abs(found - 0.8 * cosine).max() < 0.6 / 255


def shadowed(light, shader="phong"):
    """Returns the red of the floor below a small square, and of the floor beside it."""
    floor = square(6.0, 4.0, normals=np.tile(np.float32([0, 0, -1]), (4, 1)))
    small = square(4.0, 0.5, normals=np.tile(np.float32([0, 0, -1]), (4, 1)))
    # The camera looks from the side, so that it sees the floor below the square.
    pose = gnomon.look_at((6, 0, -2), (0, 0, 6), (0, 1, 0))
    lens = gnomon.perspective(1.0, 64 / 48, 0.1, 50)
    picture = gnomon.render(
        [floor, small], projection=lens, pose=pose, light=light, shader=shader, **SIZE
    )
    clip = lens @ pose

    def at(x, y, z):
        place = clip.matrix @ [x, y, z, 1]
        column, row = place[:2] / place[3] * [32, -24] + [32, 24]
        return int(picture.color[int(row), int(column), 0])

    return at(0, 0, 6), at(2, 2, 6)


@pytest.mark.parametrize("shader", ["flat", "toon", "phong", "blinn_phong"])
@pytest.mark.parametrize(
    "place",
    [
        {"direction": (0, 0, -1)},
        {"position": (0, 0, -8)},
        {"direction": (0, 0, -1), "position": (0, 0, -8), "cone": (0.7, 0.8)},
    ],
)
def test_shadows(place, shader):
    with_shadows = gnomon.Light(**place, ambient=(0.2, 0, 0), shadows=True)
    without = gnomon.Light(**place, ambient=(0.2, 0, 0))
    below, beside = shadowed(with_shadows, shader)
    assert below == 51 and beside > 150
    assert min(shadowed(without, shader)) > 150
    # The other lights cast none, wherever they are in the list.
    other = gnomon.Light(direction=(0, 0, -1), ambient=(0, 0, 0), diffuse=(0.2, 0.2, 0.2))
    for lights in ([other, with_shadows], [with_shadows, other]):
        assert shadowed(lights, shader)[0] == 102


@pytest.mark.parametrize("place", [{"direction": (3, 2, -1)}, {"position": (9, 6, 1)}])
def test_surfaces_do_not_shadow_themselves(place):
    mesh = square(4.0, 2.0, normals=np.tile(np.float32([0, 0, -1]), (4, 1)))
    lit, cast = (
        gnomon.render(mesh, K=K, light=gnomon.Light(**place, shadows=shadows), **SIZE).color
        for shadows in (False, True)
    )
    assert lit[24, 32, 0] > 60 and np.array_equal(lit, cast)


def test_faults_of_shadows():
    sun = gnomon.Light(direction=(0, 0, -1), shadows=True)
    refused("light: has 2 lights that cast shadows", square(), light=[sun, sun])
    refused("needs a direction or a position", square(), light=gnomon.Light(shadows=True))
    inside = gnomon.Light(position=(0, 0, 4), shadows=True)
    refused("must be outside of the scene", square(), light=inside)
    refused("light.shadows: is 1, not True or False", square(), light=gnomon.Light(shadows=1))


def test_textures_of_files(tmp_path):
    image = pytest.importorskip("PIL.Image")
    path = tmp_path / "red.png"
    image.new("RGB", (2, 2), (200, 10, 0)).save(path)
    mesh = square(texcoords=np.float32([[0, 1], [1, 1], [1, 0], [0, 0]]))
    for texture in (path, str(path), gnomon.Texture(path), gnomon.Texture(str(path), "nearest")):
        picture = gnomon.render(mesh, K=K, texture=texture, shader="unlit", **SIZE)
        assert picture.color[24, 32].tolist() == [200, 10, 0, 255]
    refused("texture: .*none.png' cannot be read: there is no such file", mesh, texture=tmp_path / "none.png")
    (tmp_path / "text.png").write_text("no picture")
    refused("texture: .*text.png' is none of BMP", mesh, texture=tmp_path / "text.png")


def empty(words, *arguments, **named):
    with pytest.warns(gnomon.EmptyWarning, match=words) as caught:
        gnomon.render(*arguments, **{"K": K, **SIZE, **named})
    assert len(caught) == 1 and caught[0].filename == __file__


def test_empty_pictures_are_warned_of_once():
    mesh = square()
    for outputs in (["color"], ["depth"], ["labels"], gnomon.OUTPUTS):
        for antialias in (False, True):
            empty("everything is behind", mesh, pose=moved(0, 0, -8), outputs=outputs, antialias=antialias)
    empty("to the right", mesh, pose=moved(20, 0, 0))
    empty("to the left", mesh, pose=moved(-20, 0, 0))
    empty("below", mesh, pose=moved(0, 20, 0))
    empty("above", mesh, pose=moved(0, -20, 0))
    empty("nearer than the near plane", mesh, near=5.0)
    empty("beyond the far plane", mesh, far=3.0)
    empty("no face that is in view covers", mesh, model=np.diag([1e-4, 1e-4, 1, 1]))
    empty("or all are culled", mesh, cull="back")
    empty("there are no faces", np.full((3, 3), math.nan), np.zeros((0, 3), int))
    empty("there are no faces", np.zeros((0, 3)), np.zeros((0, 3), int))
    lens = gnomon.perspective(1.0, 1.0, 0.1, 20)
    empty("behind the camera", mesh, K=None, projection=lens)
    away = np.stack([moved(20, 0, 0), moved(0, 20, 0)])
    empty("to the right of the picture in the first picture", mesh, pose=away)


def test_pictures_that_show_something_are_not_warned_of():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        gnomon.render(square(), K=K, **SIZE)
        gnomon.render(square(), K=K, pose=np.stack([moved(20, 0, 0), np.eye(4)]), **SIZE)
        # One sample of one pixel.
        tiny = np.float32([[0, 0, 4], [0.04, 0, 4], [0.04, 0.04, 4], [0, 0.04, 4]])
        gnomon.render(tiny, FACES, K, antialias=True, outputs=["color"], **SIZE)
