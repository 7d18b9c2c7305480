"""Extremes of motions, forces, torques, stress and jump speed against dense grids of random programs."""

import random
from math import pi
from typing import Any

import numpy as np
import pytest
from geometry_cases import KINDS, NOTHING, SWINGING, random_follower
from search_length import EVALUATIONS

from dynamics_cli.cam.forces.forces import force
from dynamics_cli.cam.forces.loads import load_of
from dynamics_cli.cam.forces.records import ArmOnSpring, ArmOnTorsionSpring, Contact, Forces, Slide
from dynamics_cli.cam.geometry import followers
from dynamics_cli.cam.geometry.contact import Geometry
from dynamics_cli.cam.laws.names import LawName
from dynamics_cli.cam.program.reading import motion_of
from dynamics_cli.cam.program.summary import extreme
from dynamics_cli.errors import InadmissibleError

LAWS = [name for name in LawName.names if name not in ("scca", "polynomial", "spline") and not name.startswith("half")]
GRID = np.linspace(0.0, 1.0, 1501)
FREE = (
    "rise 20 mm in 90 deg {}; return 5 mm in 40 deg polynomial; return 10 mm in 50 deg linear; "
    "return 5 mm in 40 deg polynomial; dwell"
)


def program(chance: random.Random, swing: bool) -> str:
    spans = [round(chance.uniform(25, 110), 2) for _ in range(3)]
    lift = f"{chance.uniform(2, 15):.2f} deg" if swing else f"{chance.uniform(2, 25):.2f} mm"
    first, second = chance.choice(LAWS), chance.choice(LAWS)
    return f"rise {lift} in {spans[0]} deg {first}; dwell {spans[1]} deg; return in {spans[2]} deg {second}; dwell"


def free_program(chance: random.Random) -> str:
    """Free polynomials, a spline's neighbours and shares of one's own, for a slide."""
    a, b, c = (round(chance.uniform(30, 90), 2) for _ in range(3))
    share = round(chance.uniform(0.05, 0.4), 3)
    law = f"scca {share} {round(0.9 - share, 3)} 0.1" if chance.random() < 0.5 else "modified-constant-velocity"
    part = round(chance.uniform(1, 8), 2)
    return (
        f"rise 20 mm in {a} deg {law}; return {part} mm in {b} deg polynomial; "
        f"return {10 - part:.2f} mm in 30 deg linear; return 10 mm in {c} deg polynomial; dwell"
    )


def train_of(chance: random.Random, swing: bool) -> Any:
    if not swing:
        return Slide(chance.uniform(0.05, 2), chance.uniform(0, 40000), chance.uniform(0.5, 300), chance.uniform(0, 50))
    if chance.random() < 0.5:
        return ArmOnTorsionSpring(chance.uniform(1e-4, 0.01), chance.uniform(0, 50), chance.uniform(0.1, 5))
    inertia, radius = chance.uniform(1e-4, 0.01), chance.uniform(0.02, 0.1)
    return ArmOnSpring(inertia, radius, chance.uniform(0, 4e4), chance.uniform(1, 90))


def curves(motion: Any, geometry: Geometry, load: Any, kind: str) -> dict[str, list[Any]]:
    """Every quantity on a dense grid of every zone, by other formulas than the program's."""
    found: dict[str, list[Any]] = {name: [] for name in ("force", "torque", "contact_force", "crowding", "jump")}
    follower: Any = geometry.follower
    for index in range(len(motion.zones)):
        s, s1, s2 = motion.in_zone(index, GRID, 2)
        pressing = load.force(s, s2)
        touch = geometry.touch(s, s1, s2)
        (x, y), (nx, ny) = touch.point, touch.normal
        if kind in SWINGING:
            # moment balance of the arm about its pivot
            normal = pressing / -((x - follower.pivot_distance) * ny - y * nx)
        else:
            normal = pressing / np.cos(touch.pressure_angle)
        with np.errstate(all="ignore"):
            bend = 1.0 / touch.radius if geometry.flat else 1.0 / (1.0 / touch.curvature - geometry.roller)
        bend = bend + (0.0 if geometry.flat or not geometry.roller else 1.0 / geometry.roller)
        down = s2 < 0.0
        speeds = (load.rate * s[down] + load.steady) / (-load.inertia * s2[down])
        for name, values in (
            ("force", pressing), ("torque", pressing * s1), ("contact_force", normal), ("crowding", normal * bend),
            ("jump", speeds),
        ):  # fmt: skip
            found[name].append(values)
    return found


def compared(kind: str, seed: int) -> bool:
    chance = random.Random(1000 + seed)
    swing = kind in SWINGING
    line = free_program(chance) if seed % 4 == 3 and not swing else program(chance, swing)
    train, follower = train_of(chance, swing), random_follower(chance, kind)
    speed, rotation = chance.uniform(5, 200), followers.Rotation(chance.choice(("ccw", "cw")))
    try:
        found = force(NOTHING, program=line, shaft_speed=speed, train=train, follower=follower, rotation=rotation,
                      count=2, at_lifts=None if swing else ())  # fmt: skip
    except InadmissibleError:
        return False
    motion = motion_of(NOTHING, line)
    if any(advice.code == "velocity-jump" for advice in found.advice):
        return False
    _motion_compared(kind, seed, motion)
    load, geometry = load_of(train, motion, speed), Geometry(follower, rotation)
    dense = curves(motion, geometry, load, kind)
    assert all(check.passed for check in found.checks), (kind, seed)
    for name in ("force", "torque", "contact_force"):
        own = "arm_torque" if swing and name == "force" else name
        high, low = (end(map(end, dense[name])) for end in (max, min))
        least, greatest = getattr(found, f"least_{own}"), getattr(found, f"greatest_{own}")
        scale = max(abs(high), abs(low))
        # no dense grid goes beyond what was found, and what was found is not beyond what a grid can miss
        assert greatest >= high - 1e-12 * scale, (kind, seed, name)
        assert least <= low + 1e-12 * scale, (kind, seed, name)
        assert greatest <= high + 5e-4 * scale, (kind, seed, name)
        assert least >= low - 5e-4 * scale, (kind, seed, name)
    slowest = min(float(part.min()) for part in dense["jump"] if part.size) ** 0.5
    assert slowest * (1.0 - 5e-4) <= found.jump_speed <= slowest * (1.0 + 1e-12), (kind, seed)
    _stress_compared(kind, seed, found, dense, (line, speed, train, follower, rotation))
    return True


def _motion_compared(kind: str, seed: int, motion: Any) -> None:
    states = [motion.in_zone(index, GRID) for index in range(len(motion.zones))]
    for order in range(4):
        ends = extreme(motion, order)
        size = max(abs(ends.least), abs(ends.greatest))
        for values in (state[order] for state in states):
            assert values.max() <= ends.greatest + 1e-14 * size, (kind, seed, order)
            assert values.min() >= ends.least - 1e-14 * size, (kind, seed, order)


def _stress_compared(kind: str, seed: int, found: Forces, dense: Any, given: Any) -> None:
    line, speed, train, follower, rotation = given
    try:
        pressed = force(NOTHING, program=line, shaft_speed=speed, train=train, follower=follower, rotation=rotation,
                        contact=Contact(0.01), count=2)  # fmt: skip
    except InadmissibleError as refused:
        if refused.code not in ("undercut", "edge"):
            raise
        return
    give = 2.0 * (1.0 - 0.09) / 206e9
    top = max(float(part.max()) for part in dense["crowding"])
    worst = (max(top, 0.0) / (pi * 0.01 * give)) ** 0.5
    assert pressed.stress >= worst * (1.0 - 1e-11), (kind, seed)
    assert pressed.stress <= worst * (1.0 + 1e-3), (kind, seed)
    assert pressed.greatest_force == found.greatest_force


@pytest.mark.parametrize("kind", KINDS)
def test_no_extreme_is_missed_in_cams_of_each_kind(kind: str) -> None:
    cams = EVALUATIONS // 5
    assert sum(compared(kind, seed) for seed in range(cams)) >= 0.8 * cams


@pytest.mark.parametrize("line", [f"rise 20 mm in 90 deg {law}; return in 90 deg {law}; dwell" for law in LAWS] + [
    FREE.format("polynomial"), FREE.format("modified-sine")])  # fmt: skip
def test_without_preload_the_jump_is_where_the_follower_slows_down(line: str) -> None:
    # where it rests both the spring's force and what it has to hold are zero, or rounding about it
    found = force(NOTHING, program=line, shaft_speed=10.0, train=Slide(0.5, 5000.0), count=2, at_lifts=())
    if any(advice.code == "velocity-jump" for advice in found.advice):
        assert found.jump_speed == 0.0
        return
    motion = motion_of(NOTHING, line)
    squares = []
    for index in range(len(motion.zones)):
        s, _, s2 = motion.in_zone(index, GRID, 2)
        down = s2 < -1e-6
        squares += (5000.0 * s[down] / (-0.5 * s2[down])).tolist()
    slowest = min(squares) ** 0.5
    assert slowest * (1.0 - 1e-5) <= found.jump_speed <= slowest * (1.0 + 1e-12)
