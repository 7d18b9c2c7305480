"""The plate of a cam: of an undercut one what is left, where the velocity jumps the arc between both contacts."""

import random
from math import isfinite, pi

import mpmath as mp
import numpy as np
import pytest
from geometry_cases import CYCLE, LAWS, NOTHING, STEEP, by_rays
from harness import answer

from dynamics_cli.cam.geometry import followers
from dynamics_cli.cam.geometry.contact import Geometry
from dynamics_cli.cam.geometry.profile import CamProfile, profile
from dynamics_cli.cam.program.reading import motion_of

LINEAR = "rise 10 mm in 80 deg linear; dwell 100 deg; return in 100 deg linear; dwell"


def steep_plate() -> dict[str, mp.mpf]:
    """The plate of STEEP with 40 digits: twice what is left of one flank, its ends found by Newton, and the dwells."""
    base = roller = mp.mpf(15) / 1000
    span = mp.pi / 4

    def point(theta: mp.mpf) -> mp.mpc:
        share = theta / span
        lift = (share - mp.sin(2 * mp.pi * share) / (2 * mp.pi)) / 50
        speed = (1 - mp.cos(2 * mp.pi * share)) / span / 50
        height = base + roller + lift
        normal = mp.mpc(-speed, height) / mp.sqrt(height * height + speed * speed)
        return (mp.mpc(0, height) - roller * normal) * mp.exp(-1j * theta)

    def gap(first: mp.mpf, second: mp.mpf) -> tuple[mp.mpf, mp.mpf]:
        away = point(first) - point(second)
        return away.real, away.imag

    leaves, returns = mp.findroot(gap, (mp.mpf("0.4596"), mp.mpf("0.7812")))
    total = [mp.mpf(0)] * 3
    for low, high in ((mp.mpf(0), leaves), (returns, span)):
        middle = (low + high) / 2
        for order, density in enumerate(
            (
                lambda z, dz: -(z.conjugate() * dz).imag / 2,
                lambda z, dz: abs(dz),
                lambda z, dz: -(z.conjugate() * dz).imag * abs(z) ** 2 / 4,
            )
        ):
            total[order] += mp.quad(lambda t, f=density: f(point(t), mp.diff(point, t)), [low, middle, high])
    # both dwells are sectors of circles
    top = base + mp.mpf(1) / 50
    area = 2 * total[0] + top**2 * mp.pi / 4 + base**2 * mp.pi / 2
    length = 2 * total[1] + top * mp.pi / 2 + base * mp.pi
    polar = 2 * total[2] + top**4 * mp.pi / 8 + base**4 * mp.pi / 4
    return {"area": area, "perimeter": length, "polar": polar}


def test_the_plate_left_of_an_undercut_cam_to_its_bounds() -> None:
    with mp.workdps(40):
        wanted = steep_plate()
        # as published with 24 digits and more
        assert mp.almosteq(wanted["area"] * 10**6, mp.mpf("1617.95850502703078578221"), mp.mpf("1e-18"))
        assert mp.almosteq(wanted["perimeter"] * 1000, mp.mpf("156.539551146983049271639"), mp.mpf("1e-18"))
        assert mp.almosteq(wanted["polar"] * 10**12, mp.mpf("708971.449865065588341710"), mp.mpf("1e-18"))
    for rotation in ("ccw", "cw"):
        found = profile(
            NOTHING, program=STEEP, follower=followers.Roller(0.015, 0.015), rotation=followers.Rotation(rotation),
            points=4, thickness=0.01, density=7850.0,
        )  # fmt: skip
        assert found.numerics is not None
        bounds = {one.result: one for one in found.numerics.bounds}
        values = {
            "area": (found.area, wanted["area"]),
            "perimeter": (found.perimeter, wanted["perimeter"]),
            "mass": (found.mass, wanted["area"] * mp.mpf(78.5)),
            "inertia": (found.inertia, wanted["polar"] * mp.mpf(78.5)),
            "centroid_x": (abs(found.centroid_x), mp.mpf("0.0125374656411182610386176")),
        }
        for name, (value, exact) in values.items():
            bound = bounds[name].bound * (abs(exact) if bounds[name].relative else 1)
            assert abs(mp.mpf(value) - exact) <= bound, name
            assert bound < 5e-14 * abs(exact)


def shown(found: CamProfile) -> tuple[float, float, float]:
    return found.area, found.perimeter, found.inertia


@pytest.mark.parametrize(
    ("program", "follower"),
    [
        (STEEP, followers.Roller(0.015, 0.015)),
        (STEEP, followers.Roller(0.013, 0.014, 0.004)),
        (CYCLE, followers.FlatFace(0.012)),
        # flanks far apart cut each other: the loop swallows the dwell
        ("rise 30 mm in 30 deg cycloidal; dwell 5 deg; return in 30 deg; dwell", followers.FlatFace(0.002)),
        # the edge goes round the roller, or along the face, where the velocity jumps upwards
        (LINEAR, followers.Roller(0.03, 0.005)),
        (LINEAR, followers.FlatFace(0.03)),
        ("rise 20 mm in 60 deg linear; dwell 60 deg; return in 60 deg linear; dwell", followers.Roller(0.02, 0.01)),
    ],
)  # fmt: skip
@pytest.mark.parametrize("rotation", ["ccw", "cw"])
def test_a_plate_is_what_no_position_of_the_follower_covers(program, follower, rotation) -> None:
    motion, geometry = motion_of(NOTHING, program), Geometry(follower, rotation)
    found = profile(
        NOTHING, program=program, follower=follower, rotation=followers.Rotation(rotation), thickness=1.0, density=1.0
    )
    assert shown(found) == pytest.approx(by_rays(geometry, motion), rel=1e-3)


def test_random_undercut_plates_against_rays() -> None:
    chance, trimmed = random.Random(61), 0
    for _ in range(8):
        up, down, top = chance.randint(40, 90), chance.randint(40, 90), chance.randint(1, 40)
        program = (
            f"rise {chance.uniform(8, 20):.3f} mm in {up} deg {chance.choice(LAWS)}; dwell {top} deg; "
            f"return in {down} deg {chance.choice(LAWS)}; dwell"
        )
        base = chance.uniform(0.012, 0.03)
        follower = chance.choice(
            [followers.Roller(base, chance.uniform(0.008, 0.02), 0.2 * base), followers.FlatFace(base)]
        )
        motion, geometry = motion_of(NOTHING, program), Geometry(follower)
        found = profile(NOTHING, program=program, follower=follower, thickness=1.0, density=1.0)
        assert shown(found) == pytest.approx(by_rays(geometry, motion), rel=1e-3), program
        trimmed += any(one.code == "trimmed-plate" for one in found.advice)
        assert all(isfinite(one.bound) for one in found.numerics.bounds)
    assert trimmed >= 3


def test_the_plate_of_a_tiny_undercut_joins_that_of_none() -> None:
    plates = [
        profile(NOTHING, program=CYCLE, follower=followers.FlatFace(0.0155 + step), thickness=1.0, density=1.0)
        for step in np.linspace(-4e-3, 4e-3, 9)
    ]
    codes = [[one.code for one in plate.advice] for plate in plates]
    assert codes[0] == ["undercut", "trimmed-plate"]
    assert codes[-1] == []
    assert [plate.area for plate in plates] == sorted(plate.area for plate in plates)


def test_where_nothing_is_left_only_the_plate_is_refused() -> None:
    program = "return 30 mm in 90 deg cycloidal; dwell 90 deg; rise 30 mm in 90 deg cycloidal; dwell"
    found = answer(
        "cam", "profile", "--program", program, "--follower", "flat-face", "--base-radius", "12 mm", "--points", "4",
        "--thickness", "10 mm", "--density", "7850 kg/m^3",
    )  # fmt: skip
    results = found["results"]
    for name in ("area", "perimeter", "centroid_x", "centroid_y", "mass", "inertia", "inertia_about_centroid"):
        assert results[name] is None
        assert name not in found["numerics"]["error_bound"]
    assert results["least_convex_radius"]["value"] < 0.0
    assert sum("no plate remains" in one["message"] for one in found["warnings"]) == 7


def test_pieces_cut_off_do_not_count() -> None:
    program = "rise 200 mm in 6 deg cycloidal; dwell 40 deg; return in 6 deg cycloidal; dwell"
    found = profile(NOTHING, program=program, follower=followers.Roller(0.005, 0.02))
    assert found.area < pi * 0.06**2
    assert any("pieces cut off: 1" in one.message for one in found.advice)
