"""Transforms: inverses, composition, and the formulas of the numpy user's own."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import gnomon

numbers = st.floats(-100, 100, width=32)
vectors = st.tuples(numbers, numbers, numbers)
angles = st.floats(-7, 7, width=32)


def product_error(t: gnomon.Transform) -> float:
    product = t.matrix.astype(np.float64) @ t.inverse.astype(np.float64)
    bound = np.abs(t.matrix.astype(np.float64)) @ np.abs(t.inverse.astype(np.float64))
    return float((np.abs(product - np.eye(4)) / np.maximum(bound, 1)).max())


@given(vectors, angles, vectors)
def test_rotations_move_points_as_numpy_does(axis, angle, point):
    length = math.sqrt(sum(float(x) ** 2 for x in axis))
    if length < 1e-3:
        return
    t = gnomon.rotate_axis(axis, angle)
    assert product_error(t) < 1e-5
    k = np.array(axis, np.float64) / length
    v = np.array(point, np.float64)
    expected = (
        v * math.cos(angle)
        + np.cross(k, v) * math.sin(angle)
        + k * np.dot(k, v) * (1 - math.cos(angle))
    )
    found = t.points(np.array([point], np.float32))[0]
    assert np.allclose(found, expected, atol=1e-3)


@given(vectors, vectors)
def test_composition_is_matrix_product(a, b):
    t = gnomon.translate(a) @ gnomon.rotate_x(0.5) @ gnomon.translate(b)
    expected = gnomon.translate(a).matrix.astype(np.float64)
    expected = expected @ gnomon.rotate_x(0.5).matrix @ gnomon.translate(b).matrix
    assert np.allclose(t.matrix, expected, atol=1e-4)
    assert product_error(t) < 1e-5
    assert (~t).matrix is t.inverse


def test_trs_and_normals():
    turn = gnomon.rotation_matrix((0, 0, 1), math.pi / 2)
    t = gnomon.trs((1, 2, 3), turn, (2, 4, 8))
    assert np.allclose(t.points([[1, 1, 1]])[0], [1 - 4, 2 + 2, 3 + 8])
    assert np.allclose(t.directions([[1, 0, 0]])[0], [0, 2, 0], atol=1e-6)
    normal = t.normal_matrix() @ np.array([1, 1, 0], np.float32)
    along = t.directions([[1, -1, 0]])[0]
    assert abs(float(normal @ along)) < 1e-6


@pytest.mark.parametrize("convention", gnomon.CONVENTIONS)
@pytest.mark.parametrize("far", [100.0, math.inf])
@pytest.mark.parametrize("reversed_depth", [False, True])
def test_projections_take_near_and_far_to_their_depths(convention, far, reversed_depth):
    t = gnomon.perspective(1.0, 1.5, 0.5, far, convention, reversed_depth)
    assert product_error(t) < 1e-5
    sign = -1 if convention.startswith("rh") else 1
    low = -1 if convention.endswith("no") else 0
    near = t.matrix.astype(np.float64) @ [0, 0, sign * 0.5, 1]
    most = t.matrix.astype(np.float64) @ [0, 0, sign * min(far, 1e9), 1]
    wanted = (1, low) if reversed_depth else (low, 1)
    assert near[2] / near[3] == pytest.approx(wanted[0], abs=1e-5)
    assert most[2] / most[3] == pytest.approx(wanted[1], abs=1e-5)


@given(
    st.floats(10, 2000), st.floats(10, 2000), st.floats(-50, 50), st.floats(0, 600),
    st.floats(0, 600), st.tuples(st.floats(-3, 3), st.floats(-3, 3), st.floats(0.2, 50)),
)
def test_intrinsics_take_points_to_opencvs_pixels(fx, fy, skew, cx, cy, point):
    width, height = 640, 480
    t = gnomon.intrinsics([[fx, skew, cx], [0, fy, cy], [0, 0, 1]], width, height, 0.1, 100.0)
    assert product_error(t) < 1e-5
    x, y, z = point
    clip = t.matrix.astype(np.float64) @ [x, y, z, 1]
    ndc = clip[:3] / clip[3]
    column = (ndc[0] + 1) / 2 * width - 0.5
    row = (1 - ndc[1]) / 2 * height - 0.5
    far = 1e-6 * (abs(fx) + abs(fy) + abs(skew) + width) * (1 + abs(x / z) + abs(y / z))
    assert column == pytest.approx((fx * x + skew * y) / z + cx, abs=far)
    assert row == pytest.approx(fy * y / z + cy, abs=far)


def test_faults_are_in_the_librarys_words():
    with pytest.raises(gnomon.Error) as error:
        gnomon.look_at((1, 2, 3), (1, 2, 3), (0, 1, 0))
    assert error.value.status == "GN_DEGENERATE"
    with pytest.raises(gnomon.Error) as error:
        gnomon.scale((1, 0, 1))
    assert error.value.status == "GN_SINGULAR"
    with pytest.raises(gnomon.Error, match="fov_y"):
        gnomon.perspective(180.0, 1.0, 0.1, 10.0)
    with pytest.raises(gnomon.Error, match="convention: is 'xx'"):
        gnomon.perspective(1.0, 1.0, 0.1, 10.0, "xx")
    with pytest.raises(gnomon.Error, match=r"points: has the shape \(3,\)"):
        gnomon.identity().points([1, 2, 3])
    with pytest.raises(gnomon.Error, match="K: is not"):
        gnomon.intrinsics(np.ones((3, 3)), 10, 10, 1, 2)
    with pytest.raises(gnomon.Error, match="K: has the shape"):
        gnomon.intrinsics(np.eye(4), 10, 10, 1, 2)


def test_numpy_takes_a_transform_as_its_matrix():
    t = gnomon.translate((1, 2, 3))
    assert np.array_equal(np.array(t), t.matrix)
    assert np.array(t).dtype == np.float32 and np.array(t, np.float64).dtype == np.float64
    copy = np.array(t)
    copy[0, 3] = 7
    assert t.matrix[0, 3] == 1
    assert t.__array__(copy=False) is t.matrix
    with pytest.raises(ValueError, match="another type needs a copy"):
        t.__array__(np.float64, copy=False)
    assert np.array_equal(np.linalg.inv(t), t.inverse)


def test_a_pose_may_be_an_array_made_of_a_transform():
    mesh = gnomon.Mesh([[-1, -1, 0], [1, -1, 0], [0, 1, 0]], [[0, 1, 2]])
    K = [[50, 0, 31.5], [0, 50, 23.5], [0, 0, 1]]
    camera = ~gnomon.look_at((0.5, 1, 3), (0, 0, 0), (0, 1, 0))
    of_transform, of_array = (
        gnomon.render(mesh, K=K, camera_pose=pose, width=64, height=48)
        for pose in (camera, np.array(camera))  # the array is inverted numerically
    )
    assert of_transform.labels.max() == 0
    assert np.isclose(of_array.depth, of_transform.depth, atol=1e-4).mean() > 0.99
