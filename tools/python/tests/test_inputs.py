"""Input that cannot be drawn as it is meant: what is taken, and the words that refuse the rest."""

import math

import numpy as np
import pytest

import gnomon

K = np.array([[40.0, 0, 31.5], [0, 40.0, 23.5], [0, 0, 1]])
SIZE = {"width": 64, "height": 48}
VERTICES = np.array([[-1, -1, 4], [1, -1, 4], [1, 1, 4], [-1, 1, 4]], np.float32)
FACES = np.array([[0, 1, 2], [0, 2, 3]], np.uint32)
NORMALS = np.tile(np.float32([0, 0, -1]), (4, 1))
TEXCOORDS = np.float32([[0, 1], [1, 1], [1, 0], [0, 0]])
IMAGE = np.full((2, 2, 3), 200, np.uint8)


def draw(**change):
    return gnomon.render(**{"vertices": VERTICES, "faces": FACES, "K": K, **SIZE, **change})


def refused(words, **change):
    with pytest.raises(gnomon.Error, match=words):
        draw(**change)


def middle(**change):
    return draw(shader="unlit", **change).color[24, 32].tolist()


def test_bytes_and_floats_are_colours():
    for channels in (3, 4):
        grey = np.full((4, channels), 128, np.uint8)
        assert middle(colors=grey)[:3] == [128, 128, 128]
        # A float of 0 to 1 becomes the nearest byte.
        for dtype in (np.float16, np.float32, np.float64):
            assert middle(colors=np.full((4, channels), 0.25, dtype))[:3] == [64, 64, 64]
    assert middle(colors=[[1, 0, 0]] * 4) == [255, 0, 0, 255]
    assert middle(colors=[[1.0, 0, 0.0]] * 4) == [255, 0, 0, 255]


INTEGERS = [np.int8, np.int16, np.uint16, np.int32, np.uint32, np.int64, np.uint64, np.bool_]


@pytest.mark.parametrize("dtype", INTEGERS)
@pytest.mark.parametrize("number", [1, 100])
def test_other_integers_are_no_colours(dtype, number):
    name = np.dtype(dtype).name
    way = f"is of {name}.* uint8 .* floats of 0 to 1"
    refused(f"colors: {way}", colors=np.full((4, 3), number, dtype))
    refused(f"background: {way}", background=np.full(4, number, dtype))
    for member in ("ambient", "diffuse"):
        light = gnomon.Light(**{member: np.full(3, number, dtype)})
        refused(f"{member}: {way}", light=light)
    material = gnomon.Material(specular=np.full(3, number, dtype))
    refused(f"specular: {way}", material=material)
    with pytest.raises(gnomon.Error, match=f"image: .* of {name}; bytes need"):
        gnomon.Texture(np.full((2, 2, 3), number, dtype))


def test_lists_of_integers_are_colours_of_zeros_and_ones_only():
    refused("colors: is of int64", colors=[[255, 128, 0]] * 4)
    refused("colors: is of bool", colors=[[True, False, False]] * 4)
    refused("background: is of int64", background=(255, 255, 255, 255))
    refused("diffuse: is of int64", light=gnomon.Light(diffuse=(255, 255, 255)))
    assert draw(background=(0, 1, 0, 1)).color[0, 0].tolist() == [0, 255, 0, 255]


def test_bytes_are_colours_everywhere():
    picture = draw(background=np.uint8([10, 20, 30, 255]))
    assert picture.color[0, 0].tolist() == [10, 20, 30, 255]
    dark = gnomon.Light(direction=(0, 0, 1), ambient=np.uint8([51, 102, 0]), diffuse=(0, 0, 0))
    assert draw(light=dark).color[24, 32].tolist() == [51, 102, 0, 255]


@pytest.mark.parametrize("number", [-0.5, 1.01, 255.0])
def test_floats_beyond_zero_to_one_are_no_colours(number):
    refused(f"colors: has {number}, not 0 to 1", colors=np.full((4, 3), number))
    refused(f"background: has {number}, not 0 to 1", background=(0, 0, number, 1))
    with pytest.raises(gnomon.Error, match=f"image: has {number}, not 0 to 1"):
        gnomon.Texture(np.full((2, 2, 4), number, np.float32))


def test_colours_that_rounding_took_beyond_one_are_ones():
    assert middle(colors=np.full((4, 3), np.nextafter(np.float32(1), 2))) == [255] * 4
    assert middle(colors=np.full((4, 3), -1e-9)) == [0, 0, 0, 255]


def test_lights_may_be_brighter_than_one():
    bright = gnomon.Light(direction=(0, 0, 1), ambient=(2.0, 0.0, 0.0), diffuse=(0, 0, 0))
    grey = np.full((4, 3), 51, np.uint8)
    assert draw(light=bright, colors=grey).color[24, 32].tolist() == [102, 0, 0, 255]


@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.bool_])
def test_faces_and_labels_are_integers(dtype):
    refused("faces: .* of (float|bool).*, not .any, 3. of integers", faces=FACES.astype(dtype))
    refused("labels: .* of (float|bool).* of integers", labels=np.ones(2, dtype))


def test_faces_name_vertices():
    refused("faces: has -1, not 0 to 3, as there are 4 vertices", faces=[[0, 1, -1]])
    refused("faces: has 4, not 0 to 3", faces=np.array([[0, 1, 4]], np.int8))
    refused("faces: has 18446744073709551615, not", faces=np.uint64([[0, 1, 2**64 - 1]]))
    refused("faces: has 0, but there are no vertices", vertices=np.zeros((0, 3)), faces=[[0, 0, 0]])
    refused("faces: is missing", faces=None)
    refused("labels: has -1, not 0 to", labels=[0, -1])


@pytest.mark.parametrize("name", ["diffuse", "normal", "specular_map", "glow"])
def test_maps_need_texture_coordinates(name):
    maps = gnomon.Material(**{name: gnomon.Texture(IMAGE)}, specular=(0.5, 0.5, 0.5))
    refused(f"material.{name}: needs texcoords", material=maps, normals=NORMALS)
    draw(material=maps, normals=NORMALS, texcoords=TEXCOORDS)


def test_textures_need_texture_coordinates():
    refused("texture: needs texcoords", texture=IMAGE)
    refused("texture: needs texcoords", texture=gnomon.Texture(IMAGE))
    assert middle(texture=IMAGE, texcoords=TEXCOORDS) == [200, 200, 200, 255]
    shape = r"texcoords: has the shape \(3, 2\), not \(4, 2\)"
    refused(shape, texture=IMAGE, texcoords=TEXCOORDS[:3])
    # Nothing is drawn of a mesh without vertices, so nothing is missing.
    draw(vertices=np.zeros((0, 3)), faces=np.zeros((0, 3), int), texture=IMAGE)


@pytest.mark.parametrize("name", ["normal", "specular_map", "glow"])
def test_maps_of_lit_shaders_need_normals(name):
    maps = gnomon.Material(**{name: gnomon.Texture(IMAGE)}, specular=(0.5, 0.5, 0.5))
    refused(f"material.{name}: needs normals", material=maps, texcoords=TEXCOORDS)


def test_normal_maps_of_tangents_need_tangents():
    maps = gnomon.Material(normal=gnomon.Texture(IMAGE), tangent_space=True)
    refused("material.normal: needs tangents", material=maps, normals=NORMALS, texcoords=TEXCOORDS)


def test_specular_maps_need_a_colour():
    maps = gnomon.Material(specular_map=gnomon.Texture(IMAGE))
    refused("specular_map is multiplied by specular, which is 0", material=maps, normals=NORMALS, texcoords=TEXCOORDS)


def test_maps_are_textures():
    refused("material.diffuse: is of ndarray, not Texture", material=gnomon.Material(IMAGE), texcoords=TEXCOORDS)
    refused("material: is of ndarray, not Material", material=IMAGE, texcoords=TEXCOORDS)
    refused("light: is of tuple, not Light", light=(0, 0, 1))


def moved(x, y, z):
    matrix = np.eye(4)
    matrix[:3, 3] = x, y, z
    return matrix


@pytest.mark.parametrize("name", ["pose", "model"])
def test_transposed_matrices_are_refused(name):
    words = f"{name}: its last row is 1 2 3 1, not 0 0 0 1; is it transposed"
    refused(words, **{name: moved(1, 2, 3).T})
    refused(f"{name}: its last row is 0 0 0 2", **{name: 2 * np.eye(4)})
    # The rounding of an inverse is no fault.
    close = moved(0, 0, 1)
    close[3] = 1e-17, -0.0, 0, 1 + 1e-16
    assert draw(**{name: close}).depth[24, 32] == pytest.approx(5)


def test_one_transposed_pose_of_a_batch_is_refused():
    poses = np.stack([np.eye(4), moved(0, 0, 1), moved(0, 0, 1).T])
    refused(r"pose\[2\]: its last row is 0 0 1 1", pose=poses)


@pytest.mark.parametrize("number", [math.nan, math.inf, -math.inf])
def test_matrices_are_finite(number):
    for name in ("pose", "model"):
        refused(f"{name}: has a number that is not finite", **{name: moved(0, number, 0)})
    projection = gnomon.perspective(1.0, 1.0, 0.1, 10).matrix.copy()
    projection[0, 0] = number
    refused("projection: has a number that is not finite", K=None, projection=projection)


@pytest.mark.parametrize(
    "matrix, words",
    [
        (np.diag([1, 1, 1, 0]), "its last row is 0 0 0 0"),
        (np.diag([1, 1, 1, -1]), "its last row is 0 0 0 -1"),
        (gnomon.perspective(1.0, 1.0, 0.1, 10).matrix.T, "is it transposed"),
        (gnomon.perspective(1.0, 1.0, 0.1).matrix.T, "is it transposed"),
        (gnomon.orthographic(-1, 1, -1, 1, 2, 10).matrix.T, "is it transposed"),
        (gnomon.orthographic(-1, 1, -1, 2, 0, 10).matrix.T, "is it transposed"),
        (
            gnomon.perspective(1.0, 1.0, 0.1, 10).matrix
            @ gnomon.look_at((3, 2, 1), (0, 0, 0), (0, 1, 0)).matrix,
            "its view is the argument pose",
        ),
    ],
)
def test_projections_have_a_w_of_their_own(matrix, words):
    refused(f"projection: .*{words}", K=None, projection=matrix)


def test_projections_of_all_kinds_are_taken():
    for convention in gnomon.CONVENTIONS:
        for matrix in (
            gnomon.perspective(1.0, 1.5, 0.5, 10, convention),
            gnomon.perspective(1.0, 1.5, 0.5, convention=convention),
            gnomon.frustum(-1, 2, -1, 3, 0.5, 10, convention),
            gnomon.orthographic(-1, 2, -1, 3, 0.5, 10, convention),
        ):
            draw(K=None, projection=matrix)
            draw(K=None, projection=3 * matrix.matrix.astype(np.float64))


def test_projections_whose_depths_fall_are_refused():
    for matrix in (
        gnomon.perspective(1.0, 1.5, 0.5, 10, reversed_depth=True),
        gnomon.perspective(1.0, 1.5, 0.5, 10, "lh_zo", True),
        np.diag([1, 1, 0, 1]),
    ):
        refused("projection: its depths do not grow", K=None, projection=matrix)


def test_parallel_projections_look_either_way():
    # The square is at z = 4; a left-handed camera at the origin looks along +z, and a right-handed
    # one sees it from z = 7, looking along -z.
    box = -2, 2, -1.5, 1.5, 1, 10
    for handedness, pose, distance in (("lh", None, 4), ("rh", moved(0, 0, -7), 3)):
        matrix = gnomon.orthographic(*box, f"{handedness}_no")
        picture = draw(K=None, projection=matrix, pose=pose)
        inside = picture.labels >= 0
        assert inside.sum() == 32 * 32 and np.allclose(picture.depth[inside], distance)


@pytest.mark.parametrize("number", [math.nan, math.inf])
def test_attributes_are_finite(number):
    def spoiled(array):
        copy = np.array(array, np.float64)
        copy[2, 1] = number
        return copy

    for name, array in (("vertices", VERTICES), ("normals", NORMALS), ("texcoords", TEXCOORDS)):
        refused(f"{name}: row 2 has a number that is not finite", **{name: spoiled(array)})
    refused("colors: row 2 has a number", colors=spoiled(np.full((4, 3), 0.5)))
    with pytest.raises(gnomon.Error, match="image: has a number that is not finite"):
        gnomon.Texture(np.full((2, 2, 4), number, np.float32))
    refused("background: has a number that is not finite", background=(0, 0, number, 1))
    for name in ("ambient", "diffuse", "position", "direction", "attenuation"):
        light = gnomon.Light(**{name: (0, number, 1.0)})
        refused(f"{name}: has a number that is not finite", light=light)


@pytest.mark.parametrize(
    "array", [np.ones((4, 3), bool), np.ones((4, 3), complex), np.full((4, 3), "1")]
)
def test_attributes_are_numbers(array):
    for name in ("vertices", "normals"):
        refused(f"{name}: is no array of numbers", **{name: array})
    refused("K: is no array of numbers", K=array[:3])
    refused("pose: is no array of numbers", pose=np.ones((4, 4), array.dtype))


def test_rows_have_one_length():
    for name in ("vertices", "faces", "colors", "labels"):
        refused(f"{name}: is no array of numbers", **{name: [[0, 1, 2], [0, 1, 2, 3]]})
    refused("image: is no array of numbers", texture=[[[0, 0, 0]], [[0, 0, 0], [0, 0, 0]]])


def test_masked_numbers_are_refused():
    masked = np.ma.masked_less(VERTICES, 0)
    for name in ("vertices", "normals", "colors"):
        refused(f"{name}: has masked numbers", **{name: masked})
    refused("faces: has masked numbers", faces=np.ma.masked_equal(FACES, 3))
    draw(vertices=np.ma.masked_less(VERTICES, -9))


@pytest.mark.parametrize("number", [64.0, 64.5, "64", None, True, np.float32(64)])
def test_sizes_are_integers(number):
    for name in ("width", "height", "threads"):
        if name != "threads" or number is not None:
            refused(f"{name}: is .*, not an integer", **{name: number})
    for name in ("exponent", "bands"):
        refused(f"{name}: is .*, not an integer", material=gnomon.Material(**{name: number}))


def test_batches_have_a_camera():
    refused("K: has 0 matrices", K=np.zeros((0, 3, 3)))
    refused("pose: has 0 matrices", pose=np.zeros((0, 4, 4)))


def test_sizes_are_any_integers():
    assert draw(width=np.int64(64), height=np.uint8(48)).labels.shape == (48, 64)


@pytest.mark.parametrize("near, far", [(1, 1), (2, 1), (0, 1), (-1, 1), (1, math.inf), (math.nan, 1)])
def test_near_and_far_are_distances(near, far):
    refused("0 < near < far", near=near, far=far)


def test_antialias_and_outputs_say_what_they_take():
    refused("antialias: is 4, not True or False", antialias=4)
    refused("outputs: is the string 'color', not a list of strings", outputs="color")


def test_arrays_to_draw_to_have_the_shapes_of_the_call():
    first = draw()
    refused("out: is of dict, not Pictures", out={"color": first.color})
    words = r"out: color is no contiguous array of uint8, \(48, 64, 4\)"

    def of(**arrays):
        return gnomon.Pictures(**{name: arrays.get(name) for name in gnomon.OUTPUTS})

    for color in (
        first.color.tolist(),
        first.color.astype(np.float32),
        np.zeros((64, 48, 4), np.uint8),  # the same size in bytes, but transposed
        np.zeros((1, 48, 64, 4), np.uint8),
        np.zeros((48, 64, 4), np.uint8)[::-1],
        np.zeros((48, 128, 4), np.uint8)[:, ::2],
    ):
        refused(words, out=of(color=color))
    refused("out: normals is no contiguous array", out=of(normals=np.zeros((48, 64, 4), np.float32)))
    refused("out: normals is no contiguous array", out=of(normals=first.normals[::-1]))
    fixed = np.zeros((48, 64, 3), np.float32)
    fixed.flags.writeable = False
    refused("out: normals cannot be written", out=of(normals=fixed))
    normals = np.zeros((48, 64, 3), np.float32)
    assert draw(out=of(normals=normals)).normals is not None and np.array_equal(normals, first.normals)
    drawn = draw(out=of(color=np.zeros((48, 64, 4), np.uint8)))
    assert np.array_equal(drawn.color, first.color)
