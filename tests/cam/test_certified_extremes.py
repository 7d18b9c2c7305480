"""A thousand random cams: no extreme of pressure angle or curvature is missed against a dense grid."""

import random

import numpy as np
import pytest
from geometry_cases import KINDS, NOTHING, SWINGING, random_follower, random_program

from dynamics_cli.cam.analysis import analyse
from dynamics_cli.cam.contact import Geometry
from dynamics_cli.cam.program import motion_of
from dynamics_cli.errors import InadmissibleError

GRID = np.linspace(0.0, 1.0, 1501)


def compared(kind: str, seed: int) -> bool:
    chance = random.Random(seed)
    motion = motion_of(NOTHING, random_program(chance, swing=kind in SWINGING))
    try:
        geometry = Geometry(random_follower(chance, kind), chance.choice(("ccw", "cw")))
        found = analyse(geometry, motion)
    except InadmissibleError:
        return False
    highs, lows = [], []
    for index in range(len(motion.zones)):
        touch = geometry.touch(*motion.in_zone(index, GRID, 2))
        bend = touch.curvature if touch.radius is None else touch.radius
        rows = np.stack(np.broadcast_arrays(bend, touch.pressure_angle))
        highs.append(rows.max(axis=1))
        lows.append(rows.min(axis=1))
    for row, extremes in enumerate((found.curvature, found.pressure)):
        high, low = max(part[row] for part in highs), min(part[row] for part in lows)
        scale = max(abs(high), abs(low))
        # no dense grid goes beyond what was found, and what was found is not beyond what a grid can miss
        assert extremes.largest()[0] >= high - 1e-12 * scale, (kind, seed, row)
        assert extremes.smallest()[0] <= low + 1e-12 * scale, (kind, seed, row)
        assert extremes.largest()[0] <= high + 2e-4 * scale + 1e-14, (kind, seed, row)
        assert extremes.smallest()[0] >= low - 2e-4 * scale - 1e-14, (kind, seed, row)
        # the value is that of the function at the place
        for value, place in (extremes.largest(), extremes.smallest()):
            sides = [geometry.touch(*(np.atleast_1d(v) for v in motion.at(place, 2, side))) for side in (1, -1)]
            bends = [(t.curvature if t.radius is None else t.radius, t.pressure_angle)[row] for t in sides]
            assert min(abs(float(np.ravel(b)[0]) - value) for b in bends) <= 1e-9 * scale, (kind, seed, row)
    return True


@pytest.mark.parametrize("kind", KINDS)
def test_none_is_missed_in_two_hundred_cams_of_each_kind(kind: str) -> None:
    assert sum(compared(kind, seed) for seed in range(200)) >= 190
