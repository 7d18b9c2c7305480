"""Slides back from rest and thousands at once: round trips, 30 digits, edges, derivatives."""

import math
import time
from typing import Any

import pytest

from dynamics_cli.impact.slide.records import AtRest, Ground, Separation, SlideResult
from dynamics_cli.impact.slide.task import slide
from tests.impact.test_slide import CAR, CASES, DEGREE, WHEELS, motion, posed

ROLLING: dict[str, Any] = {**CAR, "braking": 0.05}
# speed, course and spin, and the shares of the wheels: the last two roll far in line, where rest hardly tells the spin
ROUND_TRIPS = (
    (12.0, 30.0, 3.0, 1.0), (5.0, 0.0, -7.0, 1.0), (8.0, 30.0, 3.0, 0.05), (8.0, 10.0, -4.0, 0.1),
    (0.5, 0.0, 6.0, 0.02), (5.0, 30.0, 2.0, 0.05), (10.0, 0.0, 2.5, 0.02),
)  # fmt: skip


@pytest.mark.parametrize(("speed", "course", "spin", "share"), ROUND_TRIPS)
def test_back_from_where_it_went(speed: float, course: float, spin: float, share: float) -> None:
    car = {**CAR, "braking": share}
    forward = slide(motion=Separation(speed, course * DEGREE, spin), **car)
    back_again = slide(motion=AtRest(forward.rest_position, forward.rest_heading), **car)
    # one direction of the three is seen a thousandth as well as the others
    assert back_again.speed == pytest.approx(speed, rel=1e-3)
    assert back_again.course == pytest.approx(course * DEGREE, abs=1e-3)
    assert back_again.spin == pytest.approx(spin, abs=1e-3 * (speed + 1.0))
    assert back_again.rest_position == pytest.approx(
        forward.rest_position, abs=2e-6 * (1.0 + forward.straight_distance)
    )


def test_back_of_a_rolling_car_takes_a_fraction_of_a_second() -> None:
    forward = slide(motion=Separation(8.0, 0.5, 3.0), **ROLLING)
    slide(motion=AtRest(forward.rest_position, forward.rest_heading), **ROLLING)
    begin = time.process_time()
    slide(motion=AtRest(forward.rest_position, forward.rest_heading), **ROLLING)
    # 0.3 s on the quiet machine of development; a loaded or slower one is allowed three times the half second promised
    assert time.process_time() - begin < 1.5


def lanes_of(case: dict[str, Any], edges: list[Any]) -> tuple[Any, Any]:
    """A reference case as lanes: its car and its velocities."""
    import numpy as np

    from dynamics_cli.impact.slide.lanes import Lanes
    from dynamics_cli.impact.slide.task import car_of

    given = posed(case)
    shares = [given[name] for name in WHEELS]
    car = car_of(
        given["front_axle"], given["rear_axle"], given["track"], given["radius_of_gyration"], given["friction"], shares,
        given["grip_slope"], given["steer"], 9.80665, tuple(edges),
    )  # fmt: skip
    start = motion(case)
    velocity = [start.speed * math.cos(start.course), start.speed * math.sin(start.course)]
    return Lanes(car, nose=given["nose"]), np.array([[*velocity, car.gyration * start.spin]]).T


@pytest.mark.parametrize("case", CASES, ids=[case["name"] for case in CASES])
def test_lanes_against_thirty_digits(case: dict[str, Any]) -> None:
    """Many slides at once, to the digits asked for; one among others is what it is alone."""
    import numpy as np

    lanes, velocity = lanes_of(case, [])
    wanted = [float(part) for part in (*case["rest"], case["nose"], case["time"], case["path"])]
    size = float(case["path"]) + 1.0
    for tolerance in (1e-4, 1e-6):
        ended = lanes.ends(velocity, tolerance)[:, 0]
        assert ended == pytest.approx(wanted, rel=0.0, abs=20.0 * tolerance * size)
    among = lanes.ends(np.hstack([0.5 * velocity, velocity, 1.2 * velocity]), 1e-6)[:, 1]
    assert among == pytest.approx(ended, abs=1e-12 * size)


@pytest.mark.parametrize(("offset", "width"), [(3.0, None), (6.0, None), (3.0, 1.0)])
def test_lanes_over_an_edge_end_where_single_slides_do(offset: float, width: float | None) -> None:
    grass = Ground(0.35, (offset, 10.0), (offset, -10.0), width, patch=width is not None)
    lanes, velocity = lanes_of(CASES[0], [grass])
    ended = lanes.ends(velocity, 1e-5)[:3, 0]
    single = slide(motion=motion(CASES[0]), grounds=(grass,), **posed(CASES[0]))
    assert ended == pytest.approx([*single.rest_position, single.rest_heading], abs=2e-3)


def test_rates_of_lanes_have_the_derivatives_they_state() -> None:
    """The exact derivatives that the steps solve with, against differences."""
    import numpy as np

    lanes, _ = lanes_of(next(case for case in CASES if case["name"] == "steered"), [])
    lanes.smooth = 1e-8
    state = np.array([[0.8], [0.45], [-0.39], [0.3], [1.0], [2.0], [0.5], [1.5]])
    moved: list[Any] = []
    lanes.rates(state, np.array([40.0]), moved)
    square, others, x_by_nose, y_by_nose, by_time = (part[..., 0] for part in moved)
    stated = np.vstack([square, others])
    ends = [
        [lanes.rates(state + sign * 1e-6 * np.eye(8)[:, [k]], np.array([40.0]))[:, 0] for sign in (1.0, -1.0)]
        for k in range(4)
    ]
    slopes = np.array([(one - other) / 2e-6 for one, other in ends]).T
    assert stated == pytest.approx(slopes[:, :3], rel=1e-6, abs=1e-6)
    assert [x_by_nose, y_by_nose] == pytest.approx(slopes[4:6, 3], rel=1e-6)
    later, earlier = (lanes.rates(state, np.array([40.0 * math.exp(-2.0 * t)]))[:, 0] for t in (1e-6, -1e-6))
    assert by_time == pytest.approx((later - earlier) / 2e-6, rel=1e-5, abs=1e-6)


@pytest.mark.parametrize("back", [True, False])
@pytest.mark.parametrize("edge", [True, False])
def test_samples_side_by_side_are_what_they_are_alone(back: bool, edge: bool) -> None:
    """Every input varies; a refused case among others is refused as it is alone."""
    import numpy as np

    from dynamics_cli.errors import InadmissibleError
    from dynamics_cli.impact.slide.many import slides
    from dynamics_cli.sampling import Drawing

    cases: list[dict[str, Any]] = []
    for z in np.random.default_rng(1).standard_normal((6, 12)).tolist():
        rest = AtRest((9.6 + 0.2 * z[0], 5.6 + 0.2 * z[1]), (192.0 + 3.0 * z[2]) * DEGREE)
        grass = Ground(0.5 + 0.02 * z[3], (5.0, -20.0), (5.0 + 0.1 * z[0], -25.0))
        cases.append(
            {
                "motion": rest if back else Separation(9.6 + 0.3 * z[0], 0.4 + 0.05 * z[1], 3.0 + 0.2 * z[2]),
                "front_axle": 1.2 + 0.02 * z[4], "rear_axle": 1.4 + 0.02 * z[5], "track": 1.5 + 0.02 * z[6],
                "radius_of_gyration": 1.35 + 0.03 * z[7], "friction": 0.7 + 0.05 * z[8], "nose": 0.05 * z[9],
                "place": (0.1 * z[10], 0.1 * z[11]), "braking": 0.02, "left_front": 1.0, "mass": 1500.0,
                "grounds": (grass,) if edge else (),
            }
        )  # fmt: skip
    cases[2]["radius_of_gyration"] = 30.0
    with Drawing():
        many = slides(cases)
    assert isinstance(many.pop(2), InadmissibleError)
    del cases[2]
    assert not any(isinstance(sample, Exception) for sample in many)
    # two alone take as long as hundreds side by side
    for index in (0, -1):
        sample: Any = many[index]
        alone = slide(**cases[index])
        # of what a hundredth of a measurement's deviation is, an edge that is jumped over costs the more
        tolerance = 3e-4 if edge else 2e-5
        for name in ("time", "path_length", "rest_heading", "turned", "straight_distance", "mean_share", "energy"):
            assert getattr(sample, name) == pytest.approx(getattr(alone, name), rel=tolerance), name
        assert sample.bend == pytest.approx(alone.bend, abs=tolerance)
        assert sample.rest_position == pytest.approx(alone.rest_position, rel=tolerance)
        for name in ("speed", "course", "spin") if back else ():
            assert getattr(sample, name) == pytest.approx(getattr(alone, name), rel=tolerance), name


def test_samples_that_do_not_settle_are_solved_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    from dynamics_cli.impact.slide import many
    from dynamics_cli.sampling import Drawing

    cases = [{**CAR, "motion": AtRest((x, 5.6 * x / 9.6), 192.0 * DEGREE)} for x in (0.0, 9.6, 9.7, 9.8, 9.9)]
    cases[0]["motion"] = AtRest((0.0, 0.0), 0.0)
    with Drawing():
        refused, *_, together = many.slides(cases)
    monkeypatch.setattr(many, "SETTLED", 0.0)
    with Drawing():
        *_, alone = many.slides(cases)
    assert isinstance(refused, Exception)
    assert not isinstance(together, Exception)
    assert not isinstance(alone, Exception)
    assert alone.wheels
    assert not together.wheels
    assert together.speed == pytest.approx(alone.speed, rel=1e-5)


@pytest.mark.parametrize(("spread", "drowned"), [(0.3, True), (1e-5, False)])
def test_large_samples_go_to_as_many_digits_as_their_spread_needs(spread: float, drowned: bool) -> None:
    from dynamics_cli.impact.slide import many
    from dynamics_cli.sampling import Drawing

    cases = [{**CAR, "motion": Separation(12.0 + spread * (i / 256.0 - 1.0), 0.5, 3.0)} for i in range(many.MANY)]
    drawing = Drawing()
    with drawing:
        found = many.slides(cases)
    single = slide(**cases[100])
    one = found[100]
    assert isinstance(one, SlideResult)
    apart = math.dist(one.rest_position, single.rest_position)
    assert (drawing.missed > 0.0) is drowned
    assert apart < (2e-4 if drowned else 5e-6)


def test_samples_leave_no_trace_in_later_answers() -> None:
    """The same input gives the same answer to the last digit, whatever the process solved before."""
    from dynamics_cli.impact.slide.separation import separation
    from dynamics_cli.sampling import Drawing

    body, rest = (1.2, 1.5, 1.5, 1.35, 0.1, 1.0, 0.05, 0.05, 0.05), (10.6, 0.72, -2.4)
    with Drawing():
        separation(body, 10.5, 0.7, -2.38)
        among_samples = separation(body, *rest)
    alone = separation(body, *rest)
    with Drawing():
        assert separation(body, *rest) == alone
    assert among_samples != alone
    assert among_samples == pytest.approx(alone, rel=1e-6)
