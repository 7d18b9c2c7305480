"""`motion equations` with conditions on rates: book cases by Newton and Euler in 40 digits, energy, other speeds."""

import json
import math
from pathlib import Path
from typing import Any

import pytest
from harness import run
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import cos, lu_solve, matrix, mp, mpf, sin

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.motion.equations.records import (
    Axis,
    Body,
    Condition,
    Equations,
    Force,
    GeneralizedSpeed,
    Scene,
    Sliding,
    Turn,
    Turning,
    Upward,
)
from dynamics_cli.motion.equations.task import equations
from dynamics_cli.records import Formula

# Doubles against 40 digits: some roundings of terms of like size.
SAME = 1e-13
ANGLES, RATES = st.floats(-1.2, 1.2), st.floats(-3.0, 3.0)


def formula(text: str, unit: str = "m") -> Formula:
    return Formula(text, 1.0, unit)


def speed(text: str) -> Formula:
    return formula(text, "m/s")


def seconds(made: Equations) -> list[float]:
    return [row.acceleration.value for row in made.equations]


def sleigh(theta: float, v: float, w: float, *, speeds: bool = True, **rest: Any) -> Scene:
    coordinates = (Sliding("x", 0.3, v * math.cos(theta)), Sliding("y", -0.1, v * math.sin(theta)),
                   Turning("theta", theta, w))  # fmt: skip
    body = Body("sleigh", 4.0, formula("x + 0.3*cos(theta)"), formula("y + 0.3*sin(theta)"),
                angle=formula("theta", "rad"), inertia=0.5)  # fmt: skip
    edge = Condition("edge", speed("cos(theta)*y_dot - sin(theta)*x_dot"))
    own = (GeneralizedSpeed("v", speed("cos(theta)*x_dot + sin(theta)*y_dot")),
           GeneralizedSpeed("omega", rate=formula("theta_dot", "rad/s")))  # fmt: skip
    return Scene(coordinates, (body,), conditions=(edge,), speeds=own if speeds else (), **rest)


@settings(max_examples=25, deadline=None)
@given(ANGLES, RATES, RATES)
def test_a_sleigh_on_a_knife_edge(theta: float, v: float, w: float) -> None:
    """Chaplygin: v̇ = a·ω², (I + m·a²)·ω̇ = −m·a·v·ω; the edge pushes m·(v·ω + a·ω̇)."""
    made = equations(sleigh(theta, v, w), up=Upward("none"))
    assert made.speeds is not None
    assert made.conditions is not None
    turning = -4.0 * 0.3 * v * w / (0.5 + 4.0 * 0.09)
    wanted = [0.3 * w * w, turning]
    assert [row.acceleration.value for row in made.speeds] == pytest.approx(wanted, rel=1e-12, abs=1e-12)
    force = made.conditions[0]
    assert force.force.value == pytest.approx(4.0 * (v * w + 0.3 * turning), rel=1e-11, abs=1e-11)
    assert force.by_lagrange.value == pytest.approx(force.force.value, rel=1e-11, abs=1e-11)
    assert all(check.passed for check in made.checks)
    assert made.drive_power is None
    # rates of coordinates in place of the speeds: the same motion
    plain = equations(sleigh(theta, v, w, speeds=False), up=Upward("none"))
    assert seconds(plain) == pytest.approx(seconds(made), rel=1e-10, abs=1e-10)


R, M = 0.3, 2.0
TURNS = tuple(Turn(Axis(axis), formula(name, "rad")) for axis, name in (("z", "h"), ("x", "q"), ("y", "s")))


def disk(h: float, q: float, rates: tuple[float, float, float], thick: float = 0.0) -> Scene:
    """A disk on the plane: contact x, y, heading h, lean q, spin s."""
    turned = [Turning(name, at, rate) for name, at, rate in zip("hqs", (h, q, 0.4), rates, strict=True)]
    ahead = R * rates[2]
    places = (Sliding("x", 0.2, ahead * math.cos(h)), Sliding("y", 0.5, ahead * math.sin(h)))
    moments = (M * R * R * (0.25 + thick), M * R * R * 0.5, M * R * R * (0.25 + thick))
    centre = ("x + 0.3*sin(q)*sin(h)", "y - 0.3*sin(q)*cos(h)", "0.3*cos(q)")
    body = Body("disk", M, *map(formula, centre), turns=TURNS, moments=moments)
    rolls = (Condition("along x", speed("x_dot - 0.3*cos(h)*s_dot")),
             Condition("along y", speed("y_dot - 0.3*sin(h)*s_dot")))  # fmt: skip
    return Scene((*places, *turned), (body,), conditions=rolls)


def of_newton_and_euler(q: float, rates: tuple[float, float, float]) -> list[Any]:
    """ḧ, q̈, s̈ from dH/dt + r × m·(a + g·Z) = 0, in the axes e ahead, b the disk's own, u from the contact up."""
    mp.dps = 40
    hd, qd, sd = map(mpf, rates)
    lean, r, m, g = mpf(q), mpf("0.3"), mpf(2), mpf("9.80665")
    moments = (m * r * r / 4, m * r * r / 2, m * r * r / 4)
    up = (mpf(0), sin(lean), cos(lean))

    def cross(a: Any, b: Any) -> tuple[Any, ...]:
        return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])

    def plus(a: Any, b: Any) -> tuple[Any, ...]:
        return tuple(x + y for x, y in zip(a, b, strict=True))

    frame = (qd, hd * up[1], hd * up[2])
    spin = plus(frame, (0, sd, 0))
    arm = (mpf(0), mpf(0), r)

    def left(seconds: tuple[Any, Any, Any]) -> tuple[Any, ...]:
        hdd, qdd, sdd = seconds
        own = (qdd, hdd * up[1] + hd * up[2] * qd + sdd, hdd * up[2] - hd * up[1] * qd)
        alpha = plus(own, cross(frame, spin))
        momentum = tuple(i * w for i, w in zip(moments, spin, strict=True))
        change = plus((moments[0] * own[0], moments[1] * own[1], moments[2] * own[2]), cross(frame, momentum))
        a = plus(cross(alpha, arm), cross(spin, cross(frame, arm)))
        return plus(change, cross(arm, tuple(m * (x + g * z) for x, z in zip(a, up, strict=True))))

    base = left((mpf(0), mpf(0), mpf(0)))
    columns = [left(tuple(mpf(j == k) for j in range(3))) for k in range(3)]  # type: ignore[arg-type]
    rows = matrix([[columns[k][i] - base[i] for k in range(3)] for i in range(3)])
    return list(lu_solve(rows, matrix([-x for x in base])))


@pytest.mark.parametrize(
    ("h", "q", "rates"),
    [
        (0.7, 0.3, (1.1, -0.4, 9.0)), (-2.0, -0.9, (0.0, 0.0, 0.0)), (0.0, 1.2, (4.0, 0.0, -2.0)),
        (0.1, 1e-9, (0.0, 1e-6, 30.0)), (2.5, 0.5, (-7.0, 3.0, 0.5)),
    ],
)  # fmt: skip
def test_a_rolling_disk(h: float, q: float, rates: tuple[float, float, float]) -> None:
    made = equations(disk(h, q, rates), up=Upward("z"))
    wanted = of_newton_and_euler(q, rates)
    # terms of the size of the rates' squares cancel
    size = max(map(abs, wanted)) + sum(rate * rate for rate in rates)
    for value, exact in zip(seconds(made)[2:], wanted, strict=True):
        assert abs(value - exact) <= SAME * size
    assert made.difference < SAME
    assert [check.passed for check in made.checks] == [True, True]


def test_a_disk_in_steady_circular_rolling_stays_in_it() -> None:
    """Lean and turn that belong together: the heading and the lean keep their rates."""
    q, turn = 0.4, 2.0
    # the spin at which q̈ = 0, which is linear in it
    spins = [of_newton_and_euler(q, (turn, 0.0, spin))[1] for spin in (0.0, 1.0)]
    spin = float(-spins[0] / (spins[1] - spins[0]))
    made = seconds(equations(disk(0.3, q, (turn, 0.0, spin)), up=Upward("z")))
    assert made[2:] == pytest.approx([0.0, 0.0, 0.0], abs=1e-12)


def test_a_ball_on_a_turntable() -> None:
    """A homogeneous ball on a plate that turns at Ω: its centre accelerates by (2/7)·Ω × v, whatever its spin."""
    v, spins = (0.4, -0.7), (1.3, 0.2, -2.0)
    table, r = 3.0, 0.1
    # rolling: v − ω × (−r·Z) … = Ω × place
    x, y = 0.6, 0.25
    spins = ((-(v[1] - table * x)) / r, (v[0] + table * y) / r, spins[2])
    turns = tuple(Turn(Axis(axis), formula(name, "rad")) for axis, name in zip("xyz", "pqw", strict=True))
    ball = Body("ball", 1.5, formula("x"), formula("y"), formula("0.1"), turns=turns, moments=(0.006,) * 3)
    coordinates = (Sliding("x", x, v[0]), Sliding("y", y, v[1]),
                   *(Turning(name, 0.0, spin) for name, spin in zip("pqw", spins, strict=True)))  # fmt: skip
    # ω of turns about x, y, z at any p, q
    along_x, along_y = "(p_dot + sin(q)*w_dot)", "(cos(p)*q_dot - sin(p)*cos(q)*w_dot)"
    rolls = (
        Condition("x", speed(f"x_dot - 0.1*{along_y} + 3*y")),
        Condition("y", speed(f"y_dot + 0.1*{along_x} - 3*x")),
    )
    made = equations(Scene(coordinates, (ball,), conditions=rolls), up=Upward("z"))
    wanted = (-2.0 / 7.0 * table * v[1], 2.0 / 7.0 * table * v[0])
    assert seconds(made)[:2] == pytest.approx(wanted, rel=1e-12)
    # the plate's drive gives what the ball gains
    force = [1.5 * a for a in wanted]
    plate = (-table * y, table * x)
    assert made.drive_power == pytest.approx(sum(f * u for f, u in zip(force, plate, strict=True)), rel=1e-12)


def test_rolling_down_a_slope_and_pulled() -> None:
    """A cylinder: (2/3)·(g·sin α + P/m), with conditions or by a formula."""
    body = Body("roll", 3.0, formula("x*cos(0.3)"), formula("-x*sin(0.3)"), angle=formula("-f", "rad"), inertia=0.015)
    pull = Force("pull", "roll", formula("6*cos(0.3)", "N"), formula("-6*sin(0.3)", "N"))
    rolls = Condition("rolls", speed("x_dot - 0.1*f_dot"))
    made = equations(
        Scene((Sliding("x", 0.0, 0.5), Turning("f", 0.0, 5.0)), (body,), forces=(pull,), conditions=(rolls,))
    )
    wanted = 2.0 / 3.0 * (9.80665 * math.sin(0.3) + 2.0)
    assert seconds(made) == pytest.approx([wanted, wanted / 0.1], rel=1e-13)
    assert made.conditions is not None
    # friction turns the cylinder: it pulls back along the slope
    assert made.conditions[0].force.value == pytest.approx(-0.015 * wanted / 0.01, rel=1e-12)
    scene = Scene((Sliding("x", 0.0, 0.5), Turning("f", 0.0, 5.0)), (body,), forces=(pull,), conditions=(rolls,),
                  speeds=(GeneralizedSpeed("v", speed("x_dot")),))  # fmt: skip
    assert sum(share.share.value for share in equations(scene, terms="v").terms or ()) == pytest.approx(0.0, abs=1e-13)


@settings(max_examples=15, deadline=None)
@given(ANGLES, ANGLES, RATES, RATES, RATES)
def test_conditions_take_no_power(h: float, q: float, a: float, b: float, c: float) -> None:
    made = equations(disk(h, q, (a, b, c), thick=0.05), up=Upward("z"))
    assert [check.passed for check in made.checks] == [True, True]
    assert made.difference < 1e-12


REFUSED = {
    "not kept": ("cos(theta)*y_dot - sin(theta)*x_dot + 1", "not-kept"),
    "not linear": ("cos(theta)*y_dot^2 - sin(theta)^2*x_dot^2/cos(theta)", "not-linear"),
    "no rate": ("x - 0.3", "dependent"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_conditions_that_cannot_be(name: str) -> None:
    text, code = REFUSED[name]
    scene = sleigh(0.5, 1.0, 2.0, speeds=False)
    bad = Scene(scene.coordinates, scene.bodies, conditions=(Condition("edge", speed(text)),))
    with pytest.raises(InadmissibleError) as refusal:
        equations(bad, up=Upward("none"))
    assert refusal.value.code == code


def test_speeds_that_do_not_fit() -> None:
    scene = sleigh(0.5, 1.0, 2.0)
    for speeds, code in (
        (scene.speeds[:1], "count"),
        ((scene.speeds[0], GeneralizedSpeed("w", speed("2*x_dot*cos(theta) + 2*sin(theta)*y_dot"))), "dependent"),
    ):
        with pytest.raises(InadmissibleError) as refusal:
            equations(
                Scene(scene.coordinates, scene.bodies, conditions=scene.conditions, speeds=speeds), up=Upward("none")
            )
        assert refusal.value.code == code
    twice = Scene(
        scene.coordinates,
        scene.bodies,
        conditions=(*scene.conditions, Condition("again", speed("sin(theta)*x_dot - cos(theta)*y_dot"))),
    )
    with pytest.raises(InadmissibleError, match="depend on each other"):
        equations(twice, up=Upward("none"))


def test_the_example_says_what_slips(tmp_path: Path) -> None:
    text = (Path(__file__).parents[2] / "examples/sleigh/sleigh.toml").read_text(encoding="utf-8")
    (tmp_path / "s.toml").write_text(text.replace('velocity = "1 m/s"', 'velocity = "0 m/s"'), encoding="utf-8")
    out = run("motion", "equations", str(tmp_path / "s.toml"))
    assert out.status == 3
    assert "edge is not kept: it is -0.866 m/s with these rates" in out.err
    assert "y_dot = 1 would do" in out.err
    good = json.loads(run("motion", "equations", "examples/sleigh/sleigh.toml", "--json").out)["results"]
    assert good["conditions"][0]["force"]["unit"] == "N"
