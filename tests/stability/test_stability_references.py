"""Every task of stability against references by other methods."""

import math
from typing import Any

import numpy as np
import pytest

from dynamics_cli.accuracy import catalogue
from dynamics_cli.accuracy.cases import load
from dynamics_cli.accuracy.measure import errors_of
from dynamics_cli.numerics.exact.polynomial_text import read, whole
from dynamics_cli.records import Formula, Let
from dynamics_cli.stability.array import array
from dynamics_cli.stability.counting import count
from dynamics_cli.stability.delay import delay
from dynamics_cli.stability.discrete import discrete
from dynamics_cli.stability.equilibria.equilibrium import equilibrium
from dynamics_cli.stability.equilibria.rates import Rates, State
from dynamics_cli.stability.gain import gain
from dynamics_cli.stability.interval import interval
from dynamics_cli.stability.matrix import matrix
from dynamics_cli.stability.routh import routh

EXACT = 4e-15


def near(value: Any, text: str, tolerance: float = EXACT) -> None:
    assert value == pytest.approx(float(text), rel=tolerance, abs=0.0)


@pytest.mark.parametrize(
    ("text", "counts"),
    [
        ("((s + 1e-6)^2 + 1)^3 (s + 1)", (7, 0, 0)),
        ("((s - 1e-12)^2 + 1)(s^2 + 3s + 7)", (2, 2, 0)),
        ("((s + 1e-12)^2 + 1)(s^2 + 3s + 7)", (4, 0, 0)),
        ("(s^2 + 1)^2 (s + 1)", (1, 0, 4)),
        ("s^2 (s + 1)", (1, 0, 2)),
        ("(s + 1e-20)(s + 1e20)(s^2 + 1e-9 s + 1e9)", (4, 0, 0)),
    ],
)
def test_counts_where_companion_roots_lie_on_the_wrong_side(text: str, counts: Any) -> None:
    made = routh(text)
    assert (made.left, made.right, made.axis) == counts


def test_repeated_roots_on_the_axis_are_unstable() -> None:
    assert routh("(s^2+1)^2(s+1)").repeated == 2
    assert routh("(s^2+1)^2(s+1)").verdict == "unstable: repeated roots on the axis"
    assert routh("(s^2+1)(s+1)").verdict.startswith("marginally stable")


def test_roots_to_the_last_bit() -> None:
    made = routh("((s + 1e-6)^2 + 1)^3 (s + 1)")
    pair = next(root for root in made.roots if root.pair)
    assert (pair.real, pair.imaginary, pair.multiplicity) == (-1e-6, 1.0, 3)
    assert [root.real for root in routh("(s+1)(s+2)(s+3)(s+4)(s+5)(s+6)(s+7)(s+8)").roots] == [
        -float(k) for k in range(1, 9)
    ]


def test_array_of_a_textbook() -> None:
    """Row of zeros of s⁵ + 2s⁴ + 24s³ + 48s² − 25s − 50, whose auxiliary polynomial is 2s⁴ + 48s² − 50."""
    rows = array(whole(read("1, 2, 24, 48, -25, -50"))[0][0])
    assert [row.elements for row in rows] == ["1  24  -25", "2  48  -50", "8  96", "24  -50", "338/3", "-50"]
    assert rows[2].note == "row of zeros: derivative of the row above"


def test_array_keeps_the_scale_as_typed() -> None:
    made = routh("2.5, 1/3, 7")
    assert made.array is not None
    assert [row.elements for row in made.array] == ["5/2  7", "1/3", "7"]


def test_critical_gains_are_shown_with_twenty_digits() -> None:
    """Digits of another program's, by Newton's method on p(iω) = 0 in many digits."""
    made = gain("s(s+4)(s+6)(s^2+1.4s+1) + K(s^2+2s+4)")
    assert made.critical is not None
    assert [one.digits for one in made.critical[1:]] == [
        "15.610621364406734484", "67.512600498704510212", "163.5567781368887553"
    ]  # fmt: skip
    assert [one.right for one in made.ranges] == [1, 0, 2, 0, 2]


def test_gain_at_which_the_degree_drops() -> None:
    made = gain("(1+K)s^2 + s + 1")
    assert made.stable == "K > -1"
    assert made.critical is not None
    assert made.critical[0].frequency is None


def test_gain_with_a_factor_at_every_gain() -> None:
    assert gain("(s^2+1)(s+K)").stable == "no gain"
    assert gain("(s+1)(s(s+1)(s+2) + K)").stable == "0 < K < 6"


def test_gain_in_higher_powers() -> None:
    """s² + (K² − 2)s + 1: stable beyond ±√2."""
    made = gain("s^2 + (K^2 - 2)s + 1")
    assert made.critical is not None
    assert [one.digits for one in made.critical] == ["-1.4142135623730950488", "1.4142135623730950488"]


def test_a_loop_returns_to_stability_as_the_delay_grows() -> None:
    made = delay("s^2 + 0.4s + 1", delayed="0.5")
    assert [one.right for one in made.ranges[:5]] == [0, 2, 0, 2, 0]


@pytest.mark.parametrize(("before", "right"), [("1.5707", 0), ("1.5709", 2)])
def test_both_sides_of_a_delay(before: str, right: int) -> None:
    """ẋ = −x(t − τ) is stable below π/2."""
    made = delay("s", delayed="1", delay=float(before))
    assert made.verdict == ("unstable" if right else "asymptotically stable")
    near(made.first_unstable, str(math.pi / 2))


def test_delay_that_stabilizes() -> None:
    """An oscillator without damping: s² + 2 − e^(−sτ) has roots ±i without delay, and the least delay damps them."""
    made = delay("s^2 + 2", delayed="-1")
    assert made.ranges[0].right == 0
    assert made.stable.startswith("0 s < delay")


def _skew(g: str) -> Any:
    top, bottom = whole(read(g))[0][0][0], whole(read(g))[1]
    return (((0, 1), (-top, bottom)), ((top, bottom), (0, 1)))


@pytest.mark.parametrize(("gyroscopic", "held"), [("2.4", False), ("2.42", True), ("3", True)])
def test_gyroscopic_stabilization(gyroscopic: str, held: bool) -> None:
    """Stable from 1 + √2."""
    one, minus = (1, 1), (-1, 1)
    made = matrix(
        mass=((one, (0, 1)), ((0, 1), one)),
        gyroscopic=_skew(gyroscopic),
        stiffness=((minus, (0, 1)), ((0, 1), (-2, 1))),
    )
    assert made.without_gyroscopic == "unstable"
    assert (made.rightmost > 0.0, bool(made.growth), bool(made.advice)) == (not held, not held, held)


def test_repeated_frequencies_of_two_modes_are_no_resonance() -> None:
    zero, one = (0, 1), (1, 1)
    unit = ((one, zero), (zero, one))
    assert matrix(mass=unit, stiffness=unit).verdict.startswith("marginally")
    assert matrix(((zero, one), (zero, zero))).verdict.startswith("unstable: repeated")
    assert matrix(((zero, zero), (zero, zero))).verdict.startswith("marginally")


def test_four_polynomials() -> None:
    assert interval("1, 2..3, 3..4, 1..5").verdict == "robustly stable"
    made = interval("1, 2..3, 3..4, 1..7")
    assert (made.failing, made.worst_right) == ("1, 2, 3, 7", 2)
    assert interval("-1, -3..-2, -4..-3, -5..-1").verdict == "robustly stable"


def test_circle() -> None:
    made = discrete("(z+1)^2(z-1)(z^2+z+1)z(z-2)")
    assert (made.inside, made.outside, made.circle, made.repeated) == (1, 1, 5, 2)
    near(discrete("z^2 - 1.5z + 0.7").largest, str(math.sqrt(0.7)))


def test_bead_on_a_hoop() -> None:
    potential = Formula("-m*g*r*cos(theta) - m*r^2*w^2*sin(theta)^2/2", 1.0, "J")
    let = (Let("m", 0.2, "kg"), Let("g", 9.81, "m/s^2"), Let("r", 0.3, "m"), Let("w", 8.0, "rad/s"))
    made = equilibrium(potential=potential, let=let, inertia=0.2 * 0.09)
    assert [place.verdict for place in made.places] == ["stable", "unstable", "stable", "unstable"]
    level = 9.81 / (0.3 * 64.0)
    assert made.places[2].angle == pytest.approx(math.acos(level), rel=1e-13)
    assert made.places[2].frequency == pytest.approx(8.0 * math.sqrt(1.0 - level**2) / (2.0 * math.pi), rel=1e-13)
    assert made.places[1].growth == pytest.approx(8.0 * math.sqrt(1.0 - level), rel=1e-13)


def test_derivatives_of_higher_order_decide() -> None:
    for text, verdict in (("x^4", "stable"), ("-x^4", "unstable"), ("x^3", "unstable on one side")):
        made = equilibrium(potential=Formula(text, 1.0, "J"), lowest=-1.0, highest=1.2)
        assert len(made.places) == 1
        assert made.places[0].verdict.split(",")[0] == verdict
        assert made.places[0].position == pytest.approx(0.0, abs=1e-9)


def test_products_count_as_their_factors() -> None:
    first, second = whole(read("s^3 + 2s + 3"))[0][0], whole(read("s^4 + s + 1"))[0][0]
    together = count(whole(read("(s^3 + 2s + 3)(s^4 + s + 1)"))[0][0])
    assert together.right == count(first).right + count(second).right


VERDICTS = {
    "stable node": ("-x", "-2*y"),
    "unstable node": ("x", "2*y"),
    "saddle": ("x", "-y"),
    "stable focus": ("y", "-x-y/2"),
    "unstable focus": ("y", "(1-x^2)*y - x"),
    "undecided: centre of the linear terms": ("y*(1 + x)", "-x*(1 + x)"),
    "undecided: a root at zero": ("y", "-x^3"),
    "unstable, by terms of fifth order": ("x^5", "-y"),
    "stable, by terms of fifth order": ("x*y - 2*x^5", "-y + x^4"),
    "unstable on one side, by terms of fourth order": ("x*y", "-y + x^3"),
    "stable centre: the area of states is kept": ("y", "-sin(x)"),
    "stable focus, by terms of third order": ("y + x*y", "-x - x^2 - x^2*y"),
    "unstable focus, by terms of third order": ("y + x*z", "-x + y*z", "-z + x^2"),
    "stable, by terms of third order": ("y", "-y - x^3"),
    "unstable, by terms of third order": ("x*y - x^3", "-y + 2*x^2"),
    "unstable on one side, by terms of second order": ("x^2 - x*y", "-y + x^2"),
    "unstable on one side, degenerate: by the term of order 2": ("x^2 - x^4",),
    "stable equilibrium, degenerate: by the term of order 3": ("-x^3",),
    "unstable equilibrium, degenerate: by the term of order 5": ("x^5",),
    "stable equilibrium": ("-x",),
    "unstable equilibrium": ("x - x^3/9e9",),
    "saddle-focus: 2 unstable, 1 stable": ("x/10 - y", "x + y/10", "-z"),
    "stable focus-node": ("-x - y", "x - y", "-z"),
    "saddle: 1 unstable, 2 stable": ("x", "-y", "-2*z"),
    "undecided: a pair on the axis": ("y", "-x", "-z"),
}


@pytest.mark.parametrize("verdict", VERDICTS)
def test_verdicts_on_states(verdict: str) -> None:
    """Textbook cases at the origin; a node with one direction, whose roots are double, is still a node."""
    states = tuple(State(name, rate, -2.0, 2.0) for name, rate in zip("xyz", VERDICTS[verdict], strict=False))
    points = equilibrium(states=states).points
    assert points is not None
    assert [point.verdict for point in points if not any(point.at)] == [verdict]


@pytest.mark.parametrize(
    "rates",
    [("x^2 - x*y", "-y + x^2"), ("y", "-x - x^2*y"), ("y", "-x + x*y + 2*x^2*y"), ("y + x*z", "-x + y*z", "-z + x^2")],
)
def test_a_weak_focus_is_what_its_motion_shows(rates: tuple[str, ...]) -> None:
    """Third-order terms against integration from beside the equilibrium, through a hundred turns."""
    from scipy.integrate import solve_ivp

    states = tuple(State(name, rate) for name, rate in zip("xyz", rates, strict=False))
    points = equilibrium(states=states).points
    assert points is not None
    (point,) = (point for point in points if "third order" in point.verdict)
    law = Rates(states, ())
    start = [at + 0.02 for at in point.at]
    run = solve_ivp(lambda _, x: law.at(x), (0.0, 700.0), start, method="DOP853", rtol=1e-11, atol=1e-13)
    sizes = np.linalg.norm(run.y - np.array(point.at)[:, None], axis=0)
    early, late = sizes[(run.t > 20.0) & (run.t < 40.0)].max(), sizes[run.t > 680.0].max()
    assert (late < early) == point.verdict.startswith("stable")


@pytest.mark.parametrize(
    ("rate", "at", "order"),
    [
        ("-(x - 1)^3", 1.0, 3),
        # expanded, its place is lost to a third of the digits, unless it is looked for as a triple one
        ("-x^3 + 3*x^2 - 3*x + 1", 1.0, 3),
        ("-(x - 0.7)^5*(x^2 + 1)", 0.7, 5),
        ("1 - cos(x - 0.3)", 0.3, 2),
        ("exp(x) - 1 - x", 0.0, 2),
    ],
)
def test_a_multiple_zero_of_a_rate_is_one_equilibrium(rate: str, at: float, order: int) -> None:
    points = equilibrium(states=(State("x", rate),)).points
    assert points is not None
    (point,) = points
    assert point.at[0] == pytest.approx(at, rel=1e-15, abs=1e-15)
    assert point.rightmost == 0.0
    way = "unstable on one side" if order == 2 else "stable equilibrium"
    assert point.verdict == f"{way}, degenerate: by the term of order {order}"


@pytest.mark.parametrize(
    ("rate", "at", "words"),
    [
        ("(x - 1)^2 - y", 1.0, "unstable on one side, by terms of second order"),
        ("-(x - 1)^3 + y", 1.0, "stable, by terms of third order"),
        ("-x^3 + 3*x^2 - 3*x + 1 + x*y", 1.0, "stable, by terms of third order"),
        ("(x - 0.5)^5 + y", 0.5, "unstable, by terms of fifth order"),
    ],
)
def test_a_multiple_equilibrium_of_two_states_is_one(rate: str, at: float, words: str) -> None:
    points = equilibrium(states=(State("x", rate), State("y", "-y"))).points
    assert points is not None
    assert [(*point.at, point.verdict, point.rightmost) for point in points] == [
        (pytest.approx(at, rel=1e-14), 0.0, words, 0.0)
    ]


@pytest.mark.parametrize(("rate", "places"), [("x^3 - 1e-10*x", [-1e-5, 0.0, 1e-5]), ("x^2 - 1e-12", [-1e-6, 1e-6])])
def test_zeros_close_together_are_not_taken_for_one(rate: str, places: list[float]) -> None:
    points = equilibrium(states=(State("x", rate),)).points
    assert points is not None
    assert [point.at[0] for point in points] == pytest.approx(places, rel=1e-12)


@pytest.mark.parametrize(
    ("potential", "at", "verdict"),
    [
        ("x^4 - 1.2*x^3 + 0.54*x^2 - 0.108*x + 0.0081", 0.3, "stable, degenerate: by the derivative of order 4"),
        ("cos(x) + x^2/2", 0.0, "stable, degenerate: by the derivative of order 4"),
        ("(x - 0.3)^5", 0.3, "unstable on one side, degenerate: by the derivative of order 5"),
        ("cos(theta) + 0.25*cos(2*theta) - 1", math.pi, "stable, degenerate: by the derivative of order 4"),
    ],
)
def test_a_multiple_equilibrium_of_a_potential_is_one(potential: str, at: float, verdict: str) -> None:
    """Rounding leaves lower derivatives behind, and parts the place into neighbours."""
    places = equilibrium(potential=Formula(potential, 1.0, "J"), lowest=-2.0, highest=2.0).places
    assert places is not None
    found = [(place.angle if place.position is None else place.position, place.verdict) for place in places]
    assert found[-1] == (pytest.approx(at, rel=1e-15, abs=1e-15), verdict)


def test_a_node_of_one_direction_and_both_laws_agree() -> None:
    """A defective Jacobian; a potential as states of position and velocity has the same frequencies."""
    points = equilibrium(states=(State("x", "-x + y"), State("y", "-y"))).points
    assert points is not None
    assert (points[0].verdict, points[0].roots[0].multiplicity) == ("stable node", 2)
    well = equilibrium(potential=Formula("x^4/4 - x^2/2", 1.0, "J"), lowest=-2.0, highest=2.0, mass=1.0)
    flow = equilibrium(states=(State("x", "v", -2.0, 2.0), State("v", "x - x^3", -2.0, 2.0)))
    assert well.places is not None
    assert flow.points is not None
    for place, point in zip(well.places, flow.points, strict=True):
        assert point.at == pytest.approx((place.position, 0.0), abs=1e-12)
        assert point.frequency == (place.frequency and pytest.approx(place.frequency, rel=1e-12))
        assert point.rightmost == pytest.approx(place.growth or 0.0, rel=1e-12, abs=1e-12)


@pytest.mark.parametrize("question", catalogue.questions("stability", ""), ids=lambda question: question.name)
def test_reference_cases_to_the_last_bits(question: Any) -> None:
    """Slopes and their roots at an equilibrium are those of a place that is a double."""
    cases = [case for case in load(question.file) if case.task == question.cases]
    errors = errors_of(question.methods[0].call(), cases, catalogue.groups("stability"), tracked=False)
    assert (errors.refused, errors.cases, errors.broken) == (0, len(cases), 0)
    # counts are exact
    assert (errors.bounded > 0) == (question.task != "interval")
    assert max(errors.relative) <= (1e-9 if question.task == "equilibrium" else 3e-16), errors.worst
