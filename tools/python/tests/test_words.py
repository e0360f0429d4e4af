"""Arguments of wrong types: every function refuses them in the library's words, none in Python's."""

import inspect
import warnings

import numpy as np
import pytest

import gnomon

warnings.simplefilter("ignore", gnomon.EmptyWarning)
MESH = gnomon.Mesh([[-1, -1, 4], [1, -1, 4], [0, 1, 4]], [[0, 1, 2]], texcoords=[[0, 0], [1, 0], [0, 1]])
K = [[40, 0, 31.5], [0, 40, 23.5], [0, 0, 1]]
WRONG = [
    None, True, -1, 0, 3, 1e300, 10**400, 1.5, float("nan"), 1j, "x", b"x", [], ["x"], [None], [[1], [2, 3]],
    {}, {"a": 1}, object(), int, np.zeros(3, complex), np.array("x"), np.array([None]), np.array(1), np.zeros((2, 2, 2)),
    (1, "x"), [True], np.datetime64("2020-01-01"), {1}, lambda: 1, [[[]]],
]
VALID = {
    "render": {"vertices": MESH, "K": K, "width": 64, "height": 48},
    "Mesh": {"vertices": MESH.vertices, "faces": MESH.faces},
    "Texture": {"image": np.zeros((2, 2, 3), np.uint8)},
    "Light": {}, "Material": {}, "contract": {"every": 5000}, "identity": {},
    "Transform": {"matrix": np.eye(4), "inverse": np.eye(4)},
    "translate": {"offset": (1, 2, 3)}, "scale": {"factors": 2.0},
    "rotate_x": {"radians": 1.0}, "rotate_y": {"radians": 1.0}, "rotate_z": {"radians": 1.0},
    "rotate_axis": {"axis": (1, 0, 0), "radians": 1.0}, "rotation_matrix": {"axis": (1, 0, 0), "radians": 1.0},
    "affine": {"linear": np.eye(3)}, "trs": {"translation": (1, 2, 3), "rotation": np.eye(3), "factors": (1, 1, 1)},
    "look_at": {"eye": (1, 2, 3), "target": (0, 0, 0), "up": (0, 1, 0)},
    "perspective": {"fov_y": 1.0, "aspect": 1.0, "near": 0.1, "far": 10.0},
    "frustum": {"left": -1, "right": 1, "bottom": -1, "top": 1, "near": 0.1, "far": 10.0},
    "orthographic": {"left": -1, "right": 1, "bottom": -1, "top": 1, "near": 0.1, "far": 10.0},
    "viewport": {"x": 0, "y": 0, "width": 64, "height": 48},
    "intrinsics": {"K": K, "width": 64, "height": 48, "near": 0.1, "far": 10.0},
    "load": {},
}
NO_FUNCTIONS = {"CONVENTIONS", "OUTPUTS", "SHADERS", "Contract", "Error", "EmptyWarning", "ModelWarning",
                "Lines", "Model", "Pictures", "Points"}


def test_the_table_has_every_function():
    assert set(VALID) == set(gnomon.__all__) - NO_FUNCTIONS


@pytest.mark.parametrize(
    "function, name",
    [(f, name) for f in VALID for name in inspect.signature(getattr(gnomon, f)).parameters],
)
def test_wrong_types_are_refused_in_words(function, name, tmp_path):
    if function == "load":
        (tmp_path / "a.obj").write_text("v 0 0 1\nv 1 0 1\nv 0 1 1\nf 1 2 3\n")
    for wrong in WRONG:
        if function == "contract" and isinstance(wrong, int) and 0 < wrong < 100:
            continue  # draws thousands of scenes
        given = {"path": tmp_path / "a.obj"} if function == "load" else VALID[function]
        given = {**given, name: wrong}
        try:
            made = getattr(gnomon, function)(**given)
            # What these hold is looked at when it is drawn.
            if function == "Light":
                gnomon.render(MESH, K=K, light=made, width=64, height=48)
            if function == "Material":
                gnomon.render(MESH, K=K, material=made, width=64, height=48)
            if function == "Mesh":
                gnomon.render(made, K=K, width=64, height=48)
        except gnomon.Error as error:
            assert ": " in str(error), f"{name}={wrong!r}: {error}"
        except OSError:
            assert function == "load", f"{name}={wrong!r}"
        except Exception as error:
            raise AssertionError(f"{name}={wrong!r}: {type(error).__name__}: {error}") from error


def test_products_of_transforms():
    with pytest.raises(gnomon.Error, match="a @ b: is of ndarray, not Transform"):
        gnomon.identity() @ np.eye(4)
    with pytest.raises(gnomon.Error, match="points: "):
        gnomon.identity().points("x")
