"""Lights, and the shadow map of the one that casts shadows."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any, List, Optional, Sequence, Tuple

import numpy as np

from ._native import ffi, lib
from .arrays import Doubles, finite, fitting, flag, instance, matrix_to_c, numbers, pointer
from .arrays import real, vector, vector_to_c
from .colors import light_to_c
from .errors import check, refuse
from .transforms import Transform, look_at, orthographic, perspective

# Texels along a side of a shadow map.
SHADOW_SIZE = 2048
# Space around the scene in the shadow map, so that nothing lies on its border.
_MARGIN = 1.01
# A point light's map is a picture of the whole scene, so the light must be outside of it.
_NEAREST = 1.05


@dataclass
class Light:
    """A light. Without direction and position it shines from the camera.

    With `direction`, which points towards the light, in the world, it shines from far away, as the
    sun does; with `position` it shines to all sides, with both into a cone. `cone` has the angles
    between the cone's axis and where the light begins to fade, and where it ends, in radians.

    The light of a position is divided by constant + linear * distance + quadratic * distance^2, of
    which `attenuation` has the three, and ends at the distance `range`, unless that is 0. `ambient`
    and `diffuse` are floats, which may be above 1, or bytes as uint8. Of several lights, all add
    their ambient. One light may cast `shadows`, which the shaders flat, toon, phong and
    blinn_phong draw; if it has a position, it must be outside of the scene.
    """

    direction: Optional[Any] = None
    position: Optional[Any] = None
    ambient: Any = (0.15, 0.15, 0.15)
    diffuse: Any = (0.85, 0.85, 0.85)
    attenuation: Tuple[float, float, float] = field(default=(0.0, 0.0, 0.0))
    range: float = 0.0
    cone: Tuple[float, float] = (0.0, math.pi / 4)
    shadows: bool = False

    def write(self, light: Any, origin: Doubles) -> bool:
        """Writes a gn_light, whose world is relative to an origin. Returns whether the light
        follows the camera.
        """
        if self.direction is not None:
            light.direction = _unit(self.direction)
        if self.position is not None:
            light.kind = lib.GN_LIGHT_POINT if self.direction is None else lib.GN_LIGHT_SPOT
            position = fitting(numbers(self.position, "position"), "position", [3])
            vector_to_c(position.astype(np.float64) - origin, "position", light.position)
        light_to_c(self.ambient, "ambient", light.ambient)
        light_to_c(self.diffuse, "diffuse", light.diffuse)
        light.constant, light.linear, light.quadratic = (
            float(v) for v in vector(self.attenuation, "attenuation")
        )
        light.range = real(self.range, "range")
        if not 0 <= light.range < math.inf:
            raise refuse("range", f"is {self.range}, not a distance")
        inner, outer = (float(v) for v in vector(self.cone, "cone", 2))
        if not 0 <= inner <= outer <= np.float32(math.pi / 2):
            raise refuse("cone", f"is {self.cone}, not two rising angles from 0 to pi / 2")
        light.inner_cosine, light.outer_cosine = lib.gn_cos(inner), lib.gn_cos(outer)
        return self.direction is None and self.position is None


def _unit(direction: Any) -> Any:
    unit = ffi.new("gn_vec3 *")
    vector_to_c(direction, "direction", unit)
    check(lib.gn_vec3_normalize(unit[0], unit), "light.direction")
    return unit[0]


def lights_of(given: Any, most: int) -> List[Light]:
    """Returns the lights of an argument, the one that casts shadows first."""
    is_list = isinstance(given, (list, tuple)) and (not given or isinstance(given[0], Light))
    lights = [Light()] if given is None else list(given) if is_list else [given]
    for light in lights:
        instance(light, "light", Light)
    if not 1 <= len(lights) <= most:
        raise refuse("light", f"has {len(lights)} lights, not 1 to {most}")
    casting = [light for light in lights if flag(light.shadows, "light.shadows")]
    if len(casting) > 1:
        raise refuse("light", f"has {len(casting)} lights that cast shadows, not one")
    return casting + [light for light in lights if not light.shadows]


def write_lights(
    job: Any, lights: Sequence[Light], bounds: Tuple[Doubles, Doubles], origin: Doubles
) -> Any:
    """Writes the lights of a views_job. Returns the memory of its shadow map, which must outlive
    it, or None. `bounds` are the middle and the half sizes of what is drawn, in the world.
    """
    job.light_count = len(lights)
    for i, light in enumerate(lights):
        if light.write(job.light[i], origin):
            job.light_follows |= 1 << i
    if not lights[0].shadows:
        return None
    middle, half = bounds
    radius = float(np.sqrt((half**2).sum())) * _MARGIN
    if radius == 0:
        return None
    seen = _seen_from(lights[0], middle - origin, origin, radius)
    matrix_to_c(seen.matrix, job.shadow_from_world)
    memory = np.empty((SHADOW_SIZE, SHADOW_SIZE), np.float32)
    job.shadow, job.shadow_size = pointer(memory, "float[]"), SHADOW_SIZE
    return memory


def _seen_from(light: Light, middle: Doubles, origin: Doubles, radius: float) -> Transform:
    """Returns the light's clip space, which encloses a sphere."""
    is_far = light.position is None
    if light.position is not None:
        to_light = np.asarray(light.position, np.float64) - origin - middle
        distance = float(np.sqrt((to_light**2).sum()))
        if distance < _NEAREST * radius:
            raise refuse("light", "casts shadows, so its position must be outside of the scene")
    elif light.direction is not None:
        to_light, distance = np.asarray(light.direction, np.float64), 2 * radius
    else:
        raise refuse("light", "casts shadows, so it needs a direction or a position")
    finite(to_light, "light")
    towards = to_light / np.sqrt((to_light**2).sum())
    up = (0.0, 1.0, 0.0) if abs(towards[1]) < 0.9 else (0.0, 0.0, 1.0)
    view = look_at(middle + distance * towards, middle, up)
    near, far = distance - radius, distance + radius
    if is_far:
        return orthographic(-radius, radius, -radius, radius, near, far) @ view
    return perspective(2 * math.asin(radius / distance), 1.0, near, far) @ view
