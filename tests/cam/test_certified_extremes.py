"""Random cams: no extreme of pressure angle or curvature is missed against a dense grid, and the proved error holds in
60 digits (SEARCH_EVALUATIONS=400 draws 200 cams of each kind).
"""

import random

import numpy as np
import pytest
from geometry_cases import CYCLE, KINDS, NOTHING, SWINGING, random_follower, random_program
from mpmath import mpf
from search_length import EVALUATIONS
from test_proof import cams, of_numbers

from dynamics_cli.cam.export.path import Path
from dynamics_cli.cam.geometry import followers
from dynamics_cli.cam.geometry.analysis import analyse
from dynamics_cli.cam.geometry.contact import Geometry
from dynamics_cli.cam.program.reading import motion_of
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
    highs, lows, slowest = [], [], 1.0
    for index in range(len(motion.zones)):
        state = motion.in_zone(index, GRID, 2)
        slowest = min(slowest, float((1.0 + geometry.turn * state[1]).min())) if kind == "rocker" else 1.0
        touch = geometry.touch(*state)
        bend = touch.curvature if touch.radius is None else touch.radius
        rows = np.stack(np.broadcast_arrays(bend, touch.pressure_angle))
        highs.append(rows.max(axis=1))
        lows.append(rows.min(axis=1))
    for row, extremes in enumerate((found.curvature, found.pressure)):
        high, low = max(part[row] for part in highs), min(part[row] for part in lows)
        scale = max(abs(high), abs(low))
        # no dense grid goes beyond what was found, and what was found is not beyond what a grid can miss
        # the grid's own values are rounded, by less than what is in the error for the proxy's
        assert extremes.largest()[0] + 2.0 * extremes.error >= high, (kind, seed, row)
        assert extremes.smallest()[0] - 2.0 * extremes.error <= low, (kind, seed, row)
        # small angles are compared with a tenth of a radian; a rocker nearly as fast as the cam magnifies roundings
        assert extremes.error <= 1e-12 * (max(scale, 0.1) / slowest if row else scale), (kind, seed, row)
        assert extremes.largest()[0] <= high + 2e-4 * scale + 1e-14, (kind, seed, row)
        assert extremes.smallest()[0] >= low - 2e-4 * scale - 1e-14, (kind, seed, row)
        # the value is that of the function at the place
        for value, place in (extremes.largest(), extremes.smallest()):
            sides = [geometry.touch(*(np.atleast_1d(v) for v in motion.at(place, 2, side))) for side in (1, -1)]
            bends = [(t.curvature if t.radius is None else t.radius, t.pressure_angle)[row] for t in sides]
            assert min(abs(float(np.ravel(b)[0]) - value) for b in bends) <= 1e-9 * scale, (kind, seed, row)
    return True


@pytest.mark.parametrize("kind", KINDS)
def test_none_is_missed_in_cams_of_each_kind(kind: str) -> None:
    cams = EVALUATIONS // 2
    assert sum(compared(kind, seed) for seed in range(cams)) >= 0.95 * cams


def test_extremes_are_those_of_sixty_digits_within_the_proved_error() -> None:
    for name, cam in cams(2):
        motion = cam.path.motion
        found = analyse(cam.geometry, motion)
        for value, place in (found.pressure.largest(), found.pressure.smallest()):
            inner = any(zone.start + 1e-6 < place < zone.end - 1e-6 for zone in motion.zones)
            if name == "flat" or not inner:
                continue
            # the place is rounded; the function turns there, and hardly moves
            exact = cam.carried.pressure(of_numbers(cam.lift), mpf(place))
            assert abs(exact - mpf(value)) <= mpf(found.pressure.error) + mpf(10) ** -17, name
        for value, place in (found.curvature.largest(), found.curvature.smallest()):
            if not any(zone.start + 1e-6 < place < zone.end - 1e-6 for zone in motion.zones):
                continue
            radius = cam.carried.radius(of_numbers(cam.lift), mpf(place))
            reach = cam.geometry.side * mpf(cam.geometry.roller)
            exact = radius if cam.geometry.flat else 1 / (radius + reach)
            assert abs(exact - mpf(value)) <= mpf(found.curvature.error) + mpf(10) ** -16 * abs(value), name


@pytest.mark.parametrize("beyond", [-1e-9, 1e-9])
def test_a_cusp_is_told_from_none(beyond: float) -> None:
    motion = motion_of(NOTHING, CYCLE)
    free = analyse(Geometry(followers.KnifeEdge(0.03)), motion)
    sharpest = free.curvature.largest()[0]
    # a roller a nanometre smaller or larger than the least radius of curvature of its pitch curve
    roller = 1.0 / sharpest + beyond
    path = Path(Geometry(followers.Roller(0.03 - roller, roller)), motion, away=0.0)
    if beyond > 0.0:
        with pytest.raises(InadmissibleError, match="undercut"):
            path.require_regular()
    else:
        path.require_regular()
