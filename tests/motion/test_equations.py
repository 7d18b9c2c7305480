"""`dynamics motion equations`: invariants, the book's closed forms, both methods, refusals."""

import json
import math
from pathlib import Path
from typing import Any

import pytest
from harness import answer, run
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics_cli.motion.chain import chain
from dynamics_cli.motion.equations.records import Body, Equations, Scene, Sliding, Spring, Turn, Turning, Upward
from dynamics_cli.motion.equations.task import equations
from dynamics_cli.motion.rods import chain_of
from dynamics_cli.records import Formula

EXAMPLE = Path(__file__).resolve().parents[2] / "examples" / "sliding_rod" / "sliding_rod.toml"
ANGLES = st.floats(-3.0, 3.0)
RATES = st.floats(-6.0, 6.0)


def metres(text: str) -> Any:
    return Formula(text, 1.0, "m")


def radians(text: str) -> Any:
    return Formula(text, 1.0, "rad")


def seconds(made: Equations) -> list[float]:
    assert all(check.passed for check in made.checks), made.checks
    return [row.acceleration.value for row in made.equations]


def two_rods(a: Turning, b: Turning, turn: str = "b") -> Scene:
    """Uniform rods of 1 m and 0.6 m, 1 kg and 2 kg; `turn` is the second rod's angle."""
    upper = Body("upper", 1.0, metres("0.5*sin(a)"), metres("-0.5*cos(a)"), angle=radians("a"), inertia=1.0 / 12.0)
    lower = Body(
        "lower", 2.0, metres(f"sin(a) + 0.3*sin({turn})"), metres(f"-cos(a) - 0.3*cos({turn})"),
        angle=radians(turn), inertia=2.0 * 0.36 / 12.0,
    )  # fmt: skip
    return Scene((a, b), (upper, lower))


@settings(max_examples=25, deadline=None)
@given(ANGLES, ANGLES, RATES, RATES)
def test_two_rods_are_the_chain(a: float, b: float, one: float, two: float) -> None:
    rods = chain_of((1.0, 0.6), (1.0, 2.0), (), (), None, 9.80665)
    made = seconds(equations(two_rods(Turning("a", a, one), Turning("b", b, two))))
    assert made == pytest.approx(rods.rate(0.0, [a, b, one, two])[2:], rel=1e-10, abs=1e-10)


@settings(max_examples=25, deadline=None)
@given(ANGLES, ANGLES, RATES, RATES)
def test_other_coordinates_describe_the_same_motion(a: float, b: float, one: float, two: float) -> None:
    """The second angle from the first rod instead of from the vertical."""
    plain = equations(two_rods(Turning("a", a, one), Turning("b", b, two)))
    relative = equations(two_rods(Turning("a", a, one), Turning("b", b - a, two - one), "(a + b)"))
    first, second = seconds(plain), seconds(relative)
    assert second[0] == pytest.approx(first[0], rel=1e-9, abs=1e-9)
    assert second[0] + second[1] == pytest.approx(first[1], rel=1e-9, abs=1e-9)
    assert relative.kinetic_energy == pytest.approx(plain.kinetic_energy, rel=1e-12, abs=1e-13)
    # Q by the chain rule
    forces = [[row.active_force.value for row in made.equations] for made in (plain, relative)]
    assert forces[1] == pytest.approx([forces[0][0] + forces[0][1], forces[0][1]], rel=1e-9, abs=1e-10)


@pytest.mark.parametrize("name", ["a", "b"])
def test_shares_add_up(name: str) -> None:
    made = equations(two_rods(Turning("a", 0.4, 2.0), Turning("b", -0.9, 3.0)), terms=name)
    (row,) = (row for row in made.equations if row.name == name)
    assert made.terms is not None
    active = sum(share.share.value for share in made.terms if share.sort != "inertia")
    assert active == pytest.approx(row.active_force.value, rel=1e-14)
    assert sum(share.share.value for share in made.terms) == pytest.approx(0.0, abs=1e-13)


def test_a_turning_tube_needs_a_drive() -> None:
    """r̈ = Ω²·r, and the drive gives 2·m·r·ṙ·Ω² with what the ball gains: m·ṙ·r̈ + m·r·ṙ·Ω²."""
    ball = Body("ball", 0.2, metres("r*cos(5*t)"), metres("r*sin(5*t)"))
    made = equations(Scene((Sliding("r", 0.4, 0.3),), (ball,)), time=0.7, up=Upward("none"))
    assert seconds(made) == pytest.approx([25.0 * 0.4], rel=1e-13)
    assert made.drive_power == pytest.approx(2.0 * 0.2 * 0.4 * 0.3 * 25.0, rel=1e-13)


def test_a_free_body_keeps_to_eulers_equations() -> None:
    """About its principal axes: I₁·ω̇₁ = (I₂ − I₃)·ω₂·ω₃; a turn about one axis alone at first."""
    turns = tuple(Turn(axis, radians(name)) for axis, name in zip("xyz", ("p", "q", "r"), strict=True))
    body = Body("body", 1.0, metres("0"), metres("0"), metres("0"), turns=turns, moments=(2.0, 3.0, 4.0))
    rates = (0.7, -1.1, 0.4)
    scene = Scene(tuple(Turning(n, 0.0, w) for n, w in zip("pqr", rates, strict=True)), (body,))
    made = equations(scene, up=Upward("none"))
    p, q, r = seconds(made)
    # all angles zero: ω = (ṗ, q̇, ṙ), and its rate in the body is that of the rates and of the turned axes
    turned = (p + rates[1] * rates[2], q - rates[0] * rates[2], r + rates[0] * rates[1])
    wanted = ((3.0 - 4.0) / 2.0 * rates[1] * rates[2], (4.0 - 2.0) / 3.0 * rates[2] * rates[0],
              (2.0 - 3.0) / 4.0 * rates[0] * rates[1])  # fmt: skip
    assert turned == pytest.approx(wanted, rel=1e-13)
    assert made.kinetic_energy == pytest.approx(0.5 * (2.0 * 0.49 + 3.0 * 1.21 + 4.0 * 0.16), rel=1e-14)


def test_it_starts_a_chain_as_the_integration_does() -> None:
    made = seconds(equations(two_rods(Turning("a", 1.0), Turning("b", -0.5))))
    step = 1e-3
    moved = chain(lengths=(1.0, 0.6), masses=(1.0, 2.0), angles=(1.0, -0.5), duration=step)
    assert moved.rods is not None
    assert [rod.rate / step for rod in moved.rods] == pytest.approx(made, rel=1e-4)


def test_a_spring_without_length_may_pull_nothing() -> None:
    """Of no free length it is smooth there; with one its direction is unknown."""
    body = Body("ball", 1.0, metres("x"), metres("0"))
    at_rest = Scene((Sliding("x", 0.0),), (body,), springs=(Spring("band", "origin", "ball", stiffness=9.0),))
    assert seconds(equations(at_rest)) == [0.0]
    stiff = Scene((Sliding("x", 0.0),), (body,), springs=(Spring("band", "origin", "ball", 9.0, 0.1),))
    with pytest.raises(Exception, match="band has no length at this instant"):
        equations(stiff)


BALL = '[[bodies]]\nname = "ball"\nmass = "1 kg"\nx = "x m"\ny = "0 m"\n'
X = '[[coordinates]]\nname = "x"\nposition = "0.1 m"\n'
REFUSED = {
    "massless": (X + '[[coordinates]]\nname = "y"\nposition = "0 m"\n' + BALL, "massless"),
    "dependent": (X + '[[coordinates]]\nname = "y"\nposition = "0 m"\n' + BALL.replace('"x m"', '"x + y m"'),
                  "dependent"),
    "no value": (X + BALL.replace('"x m"', '"sqrt(x - 1) m"'), "no-value"),
    "no slope": (X + BALL.replace('"x m"', '"sqrt(x - 0.1) m"'), "no-value"),
    "unknown": (X + BALL.replace('"x m"', '"x + L m"'), "expression"),
    "unit": (X + BALL.replace('"x m"', '"x mm"'), "mixed-units"),
    "taken": (X.replace('"x"', '"t"') + BALL, "name"),
    "twice": (X + BALL + BALL, "name"),
    "nowhere": (X + BALL + '[[forces]]\nname = "push"\nat = "bal"\nx = "3 N"\n', "unknown-name"),
    "no angle": (X + BALL + 'inertia = "2 kg*m^2"\n', "turns"),
    "no body": (X + BALL + 'turns = [{axis = "x", angle = "0 rad"}]\nmoments = "1, 1, 5 kg*m^2"\n', "inertia"),
}  # fmt: skip


@pytest.mark.parametrize("name", REFUSED)
def test_refusals(name: str, tmp_path: Path) -> None:
    text, code = REFUSED[name]
    path = tmp_path / "scene.toml"
    path.write_text(text, encoding="utf-8")
    out = run("motion", "equations", str(path), "--json")
    assert out.status in (2, 3)
    assert out.error["code"] == code, json.dumps(out.error)


def test_the_example_by_hand() -> None:
    """A block on a spring and a damper with a rod on it: two equations that anyone can write down."""
    made = answer("motion", "equations", str(EXAMPLE))["results"]
    c, s = math.cos(math.pi / 6), math.sin(math.pi / 6)
    mass, mixed, turn = 3.0, 0.4 * c, 0.16 + 0.05333333333333333
    right = (-50.0 * 0.1 - 4.0 * 0.5 + 0.4 * s * 4.0, -9.80665 * 0.4 * s)
    whole = mass * turn - mixed * mixed
    wanted = [(turn * right[0] - mixed * right[1]) / whole, (mass * right[1] - mixed * right[0]) / whole]
    assert [row["acceleration"]["value"] for row in made["equations"]] == pytest.approx(wanted, rel=1e-14)


def test_an_unknown_coordinate_has_no_terms() -> None:
    out = run("motion", "equations", str(EXAMPLE), "--terms", "y", "--json")
    assert out.error["code"] == "unknown-name"
