"""Profiles, pressure angles and curvatures held against 40-digit envelopes of another construction."""

from math import hypot

import pytest
from geometry_cases import NOTHING, cases, follower_of
from mpmath import mp, mpf

from dynamics_cli.cam.geometry.followers import Flank, KnifeEdge, Rotation
from dynamics_cli.cam.geometry.profile import profile
from dynamics_cli.cam.sizing import records as asked
from dynamics_cli.cam.sizing import size

CASES = cases()


@pytest.fixture(params=CASES, ids=[case["name"] for case in CASES])
def case(request: pytest.FixtureRequest) -> dict:
    return request.param


def answer(case: dict):
    given = case["inputs"]
    return profile(
        NOTHING,
        program=given["program"],
        follower=follower_of(given["follower"]),
        rotation=Rotation(given["rotation"]),
        flank=Flank(given["flank"]),
        points=given["points"],
    )


def test_there_are_hard_cases() -> None:
    assert sum(case["kind"] == "hard" for case in CASES) >= 20
    assert all(case["kind"] == "ordinary" or case["why"] for case in CASES)


def test_points_are_within_1e_14_of_the_size(case: dict) -> None:
    made, (mp.dps) = answer(case), 50
    arrays = made.points.arrays
    # the size of the cam and its follower: what the coordinates are differences of
    sizes = [float(v) for k, v in case["inputs"]["follower"].items() if k not in ("record", "arm_angle", "offset")]
    size = mpf(max(sum(sizes), float(max(arrays["radius"]))))
    for name, text in case["results"].items():
        if not name.endswith((".x", ".y")):
            continue
        index, key = int(name[7 : name.index("]")]), name[-1]
        assert abs(mpf(float(arrays[key][index])) - mpf(text)) <= mpf("1e-14") * size, name


def test_pressure_angles_and_extremes(case: dict) -> None:
    made, (mp.dps) = answer(case), 50
    bounds = {bound.result: bound for bound in made.numerics.bounds}
    for name in ("largest_pressure_angle", "least_pressure_angle"):
        value, reference = mpf(getattr(made, name)), mpf(case["results"][name])
        assert abs(value - reference) <= mpf("1e-12") * max(abs(reference), mpf("1e-3")), name
        if name in bounds:
            assert abs(value - reference) <= mpf(bounds[name].bound) * abs(value), name
    for name, text in case["results"].items():
        if name.endswith(".pressure_angle"):
            value = made.points.arrays["pressure_angle"][int(name[7 : name.index("]")])]
            assert abs(mpf(float(value)) - mpf(text)) <= mpf("2e-13"), name


def test_the_least_radius_of_curvature(case: dict) -> None:
    made, (mp.dps) = answer(case), 50
    reference = mpf(case["results"]["least_convex_radius"])
    follower = follower_of(case["inputs"]["follower"])
    scale = abs(reference) + mpf(getattr(follower, "roller_radius", follower.base_radius))
    if made.least_convex_radius is None:
        assert reference < 0
        return
    assert abs(mpf(made.least_convex_radius) - reference) <= mpf("1e-12") * scale


def test_the_table_agrees_with_itself(case: dict) -> None:
    arrays = answer(case).points.arrays
    for index in range(len(arrays["x"])):
        x, y = float(arrays["x"][index]), float(arrays["y"][index])
        assert hypot(x, y) == pytest.approx(float(arrays["radius"][index]), rel=1e-15, abs=1e-300)


SIZES = cases("size")


@pytest.mark.parametrize("case", SIZES, ids=[case["name"] for case in SIZES])
def test_sizes_are_within_1e_12(case: dict) -> None:
    mp.dps = 50
    given = case["inputs"]
    tree = given["follower"]
    follower = getattr(asked, tree["record"])(**{k: float(v) for k, v in tree.items() if k != "record"})
    limits = {key: float(value) for key, value in given.items() if key.endswith(("_limit", "_radius"))}
    made = size.size(NOTHING, program=given["program"], follower=follower, **limits)
    start = mpf(case["results"].get("start_radius", case["results"]["base_radius"]))
    for name, text in case["results"].items():
        assert abs(mpf(getattr(made, name)) - mpf(text)) <= mpf("1e-12") * abs(start), name
    bound = made.numerics.bounds[0]
    assert bound.result == "base_radius"
    reference = mpf(case["results"]["base_radius"])
    assert abs(mpf(made.base_radius) - reference) <= mpf(bound.bound) * abs(reference)


@pytest.mark.parametrize("base", [0.01, 1e-3, 1e-4, 1e-5])
def test_length_and_area_near_the_axis_are_within_their_bounds(base: float) -> None:
    """A knife-edge whose cam comes near the axis: its curve turns fast there."""
    from mpmath import quad, sqrt

    program = "rise 10 mm in 120 deg 3-4-5; return in 240 deg 3-4-5"
    made = profile(NOTHING, program=program, follower=KnifeEdge(base))
    stated = {bound.result: bound.bound for bound in made.numerics.bounds}
    with mp.workdps(40):
        lift = mpf(1) / 100

        def radius(t):
            return mpf(base) + lift * t**3 * (10 - 15 * t + 6 * t * t)

        def slope(t, span):
            return lift * 30 * t * t * (1 - t) ** 2 / span

        places = [0, mpf(1) / 64, mpf(1) / 16, mpf(1) / 4, 1]
        spans = (mp.pi * 2 / 3, mp.pi * 4 / 3)
        length = sum(span * quad(lambda t, w=span: sqrt(radius(t) ** 2 + slope(t, w) ** 2), places) for span in spans)
        area = sum(span * quad(lambda t: radius(t) ** 2, places) / 2 for span in spans)
        assert abs(made.perimeter / length - 1) <= stated["perimeter"]
        assert abs(made.area / area - 1) <= stated["area"]
        assert stated["area"] <= 1e-13
