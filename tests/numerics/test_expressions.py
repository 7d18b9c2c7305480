"""Formulas as typed: what they read as, their derivatives by jets, where they have poles, and what is refused."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp

from dynamics_cli.core.inputs.forms.formulas import read_formula
from dynamics_cli.errors import UsageError
from dynamics_cli.numerics.exact.many_digits import ManyDigits, run
from dynamics_cli.numerics.expressions import FUNCTIONS, begin, parse
from dynamics_cli.numerics.expressions.domain import first_fault
from dynamics_cli.numerics.expressions.jets import Jet
from dynamics_cli.numerics.expressions.laws import law_of
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.tracked import Tracked
from dynamics_cli.quantities import AngleFormula, EnergyFormula, ForceFormula, LengthFormula, TorqueFormula
from dynamics_cli.records import Let

# Taylor coefficients of order 4 of functions of order one lose a few last bits.
SAME = 1e-13
PAIRS = [
    ("3*t^2 - 2*t + 1", lambda t: 3 * t**2 - 2 * t + 1),
    ("-t^2", lambda t: -(t**2)),
    ("2^-t", lambda t: mp.mpf(2) ** -t),
    ("2^3^2 - t", lambda t: 512 - t),
    ("8/4/2*t", lambda t: t),
    ("t**2.5/(1+t)", lambda t: t ** mp.mpf("2.5") / (1 + t)),
    ("t^-2", lambda t: t**-2),
    ("t^t", lambda t: t**t),
    ("1.5e-1*sin(3*t)*cos(t) − t·t÷2", lambda t: mp.mpf(0.15) * mp.sin(3 * t) * mp.cos(t) - t * t / 2),
    (
        "tan(t/2) + asin(t/3) - acos(t/3) + atan(2*t)",
        lambda t: mp.tan(t / 2) + mp.asin(t / 3) - mp.acos(t / 3) + mp.atan(2 * t),
    ),
    ("sinh(t) - cosh(2*t)*tanh(t)", lambda t: mp.sinh(t) - mp.cosh(2 * t) * mp.tanh(t)),
    (
        "exp(-t)*log(1+t)/sqrt(2+t) + abs(t-5) + pi",
        lambda t: mp.exp(-t) * mp.log(1 + t) / mp.sqrt(2 + t) + abs(t - 5) + mp.pi,
    ),
]


@pytest.mark.parametrize(("text", "function"), PAIRS)
def test_values_and_derivatives(text: str, function: object) -> None:
    mp.dps = 40
    formula = parse(text, ("t",))
    jet = formula(t=Jet.variable(0.8, 4))
    wanted = mp.taylor(function, mp.mpf(0.8), 4)
    for part, exact in zip(jet.parts, wanted, strict=True):
        assert part == pytest.approx(float(exact), rel=SAME, abs=SAME)
    assert formula(t=0.8) == pytest.approx(float(wanted[0]), rel=SAME)


@pytest.mark.parametrize(("text", "function"), PAIRS)
def test_every_sort_of_number_goes_through(text: str, function: object) -> None:
    formula = parse(text)
    value = formula(t=0.8)
    tracked = formula(t=Jet.variable(Tracked(0.8, 0.0, (1.0,)), 3))
    assert tracked.parts[0].value == formula(t=Jet.variable(0.8, 3)).parts[0]
    assert tracked.parts[0].slopes[0] == pytest.approx(plain(tracked.parts[1]), rel=1e-12)
    exact = run(lambda: formula(t=Jet.variable(ManyDigits.inputs([0.8])[0], 3)))
    for part, other in zip(tracked.parts, exact.parts, strict=True):
        if isinstance(part, Tracked):
            assert abs(part.value - getattr(other, "value", other)) <= part.error * 1.001
    column = formula(t=np.array([0.8, 1.1]))
    assert column[0] == pytest.approx(value, rel=1e-15)


@settings(max_examples=40, deadline=None)
@given(st.floats(-3.0, 3.0), st.floats(0.1, 3.0), st.sampled_from(("sin", "cos", "exp", "atan", "sinh", "tanh")))
def test_derivatives_are_those_of_difference_quotients(at: float, rate: float, name: str) -> None:
    formula = parse(f"{name}(a*t)*t + a")
    jet = formula(t=Jet.variable(at, 2), a=rate)
    step = 1e-5
    quotient = (formula(t=at + step, a=rate) - formula(t=at - step, a=rate)) / (2.0 * step)
    assert jet.derivative(1) == pytest.approx(quotient, rel=1e-5, abs=1e-5 * (1.0 + abs(jet.derivative(1))))


def test_what_follows_a_formula_is_left_to_its_reader() -> None:
    for text, rest in (
        ("20*t - 2*t^2 m", "m"),
        ("5 m/s^2", "m/s^2"),
        ("(t) 1/m", "1/m"),
        ("sin(t)m", "m"),
        ("2e3m", "m"),
    ):
        assert text[begin(text).end :].strip() == rest


@pytest.mark.parametrize(
    ("text", "place", "words"),
    [
        ("3*", 3, "ends where"),
        ("sin t", 1, "brackets"),
        ("2**", 4, "ends where"),
        ("foo(t)", 1, "no function 'foo'"),
        ("(t+1", 1, "not closed"),
        ("t t", 3, "cannot follow here"),
        ("t + speed", 5, "'speed' has no value"),
        ("1e999", 1, "not a number"),
        ("1.2.3", 1, "not a number"),
        ("3$", 2, "cannot follow here"),
        ("", 1, "ends where"),
        ("*t", 1, "not expected"),
        ("(" * 80 + "t", 62, "nested too deeply"),
        ("__import__('os')", 1, "no function"),
        ("t.real", 2, "cannot follow here"),
        ("-" * 200 + "t", 63, "too many signs"),
        ("٣", 1, "not a number"),
    ],
)
def test_a_refusal_names_the_place(text: str, place: int, words: str) -> None:
    with pytest.raises(UsageError) as caught:
        parse(text, ("t",))
    assert words in caught.value.message
    assert abs(int(caught.value.message.rpartition("at character ")[2].split(" ")[0]) - place) <= 1


def test_long_formulas_are_refused() -> None:
    with pytest.raises(UsageError, match="characters"):
        parse("t+" * 1500 + "t")


@pytest.mark.parametrize(
    ("text", "low", "high", "fault"),
    [
        ("tan(t)", 0.0, 3.0, math.pi / 2),
        ("tan(t)", 0.0, 1.57, None),
        ("1/(t-1)", 0.0, 3.0, 1.0),
        ("1/(t-1)", 1.001, 3.0, None),
        ("sqrt(t-1)", 1.0, 3.0, 1.0),
        ("sqrt(t-1)", 1.0001, 3.0, None),
        ("sqrt(t-1)", 0.0, 3.0, 0.0),
        ("abs(t-1)", 0.0, 3.0, 1.0),
        ("1/(t^2-2*t+1.0001)", 0.0, 3.0, None),
        ("log(2-t)", 0.0, 1.999, None),
        ("log(2-t)", 0.0, 2.5, 2.0),
        ("sin(t)/t", 0.1, 9.0, None),
        ("asin(t)", -0.5, 0.9, None),
        ("asin(t)", 0.0, 1.5, 1.0),
        ("cosh(t)^0.5", -3.0, 3.0, None),
        ("a/(t-b)", 0.0, 3.0, 2.0),
        ("exp(-t^2)*atan(t)+tanh(t)", -3.0, 3.0, None),
        ("2^t", 0.0, 3.0, None),
    ],
)
def test_poles_corners_and_gaps_are_where_they_are(text: str, low: float, high: float, fault: float | None) -> None:
    formula = parse(text)
    others = {name: value for name, value in (("a", 3.0), ("b", 2.0)) if name in formula.names}
    found = first_fault(formula, "t", low, high, **others)
    assert (found is None) == (fault is None)
    assert found is None or found == pytest.approx(fault, abs=1e-3)


def test_every_function_is_known_on_cells() -> None:
    for name in FUNCTIONS:
        assert first_fault(parse(f"{name}(t)"), "t", 0.2, 0.7) is None


@pytest.mark.parametrize("name", ["abs", "sqrt"])
def test_a_corner_has_no_derivative(name: str) -> None:
    with pytest.raises(ZeroDivisionError):
        parse(f"{name}(t)")(t=Jet.variable(0.0, 2))


@pytest.mark.parametrize(
    ("text", "kind", "variables", "value"),
    [
        ("20 N*sin(3 rad/s*t)", ForceFormula, {"t": 0.4}, 20.0 * math.sin(1.2)),
        ("(20 + 5*sin(90 deg/s*t)) kN", ForceFormula, {"t": 1.0 / 3.0}, 22500.0),
        ("-5 N*s/m*vx - 2 N/mm*x", ForceFormula, {"vx": 3.0, "x": 0.01}, -35.0),
        ("0.5 kg/m^3*0.7 m^2*vx^2", ForceFormula, {"vx": 2.0}, 1.4),
        ("3 N*m - 2 N·m·s*speed", TorqueFormula, {"speed": 0.5}, 2.0),
        ("6 m/s*t/2 + 1 ft", LengthFormula, {"t": 3.0}, 9.3048),
        ("sqrt(4 m^2 + (3 m/s*t)^2)", LengthFormula, {"t": 0.5}, 2.5),
        ("2 m*2^(t/3 s)", LengthFormula, {"t": 3.0}, 4.0),
        ("3 m*t²/1 s²", LengthFormula, {"t": 2.0}, 12.0),
        ("300 rpm*t", AngleFormula, {"t": 2.0}, 20.0 * math.pi),
        ("200 N/m*x^2/2 - 3 kg*9.81 m/s^2*x", EnergyFormula, {"x": 0.1}, 1.0 - 2.943),
        ("2 m*cos(2*pi*5 Hz*t)", LengthFormula, {"t": 0.1}, -2.0),
    ],
)  # fmt: skip
def test_numbers_with_units(text: str, kind: Any, variables: dict[str, float], value: float) -> None:
    if "t²" in text:
        text = text.replace("t²", "t^2")
    law = law_of(read_formula(text, kind), (), tuple(variables))
    assert law(**variables) == pytest.approx(value, rel=1e-14)


@pytest.mark.parametrize(
    ("text", "kind", "words"),
    [
        ("20 N*sin(3*t)", ForceFormula, "has sin(…) of something in s"),
        ("20 N*sin(3 rad/s*t)*x", ForceFormula, "gives N*m, wanted N"),
        ("20 N + 3 m", ForceFormula, "adds N and m"),
        ("20 N - 3", ForceFormula, "subtracts N and a plain number"),
        ("3 rad/s*t^2", AngleFormula, "gives s, wanted rad"),
        ("20 N*2 m^t", ForceFormula, "has a power of something in s"),
        ("20 N*(2 m)^x*2 m", ForceFormula, "has a power of something in m"),
        ("3 kg*9.81 m/s^2*x^2", EnergyFormula, "gives kg*m^3/s^2, wanted J"),
        ("2 N*sin(5 Hz*t)", ForceFormula, "Hz, which counts turns"),
        ("20 N*q", ForceFormula, "'q' has no value"),
        ("20 degC + 3 N", ForceFormula, "neither a unit"),
    ],
)
def test_dimensions_that_do_not_fit(text: str, kind: Any, words: str) -> None:
    with pytest.raises(UsageError) as refusal:
        law_of(read_formula(text, kind), (), ("t", "x"))
    assert words in str(refusal.value)


def test_variables_of_let_have_dimensions_and_go_before_units() -> None:
    # L is the litre too, and m the metre
    let = (Let("L", 0.8, "m", (1, 0, 0, 0, 0, 0, 0)), Let("m", 2.0, "kg", (0, 1, 0, 0, 0, 0, 0)))
    assert law_of(read_formula("9.81 m/s^2*m*L", EnergyFormula), let[:1], ("x", "m"))(x=0.0, m=2.0) == pytest.approx(
        15.696
    )
    with pytest.raises(UsageError, match="gives kg"):
        law_of(read_formula("m*L m", LengthFormula), let, ("t",))
    assert law_of(read_formula("L*sin(3*t) + 2*L m", LengthFormula), let, ("t",))(t=0.0) == pytest.approx(1.6)


@given(st.floats(0.1, 9.0), st.floats(0.1, 9.0), st.floats(0.0, 3.0))
@settings(max_examples=30)
def test_units_of_numbers_only_scale_them(a: float, w: float, t: float) -> None:
    plain_law = law_of(read_formula(f"{a!r}*sin({w!r}*t) - {a!r}*t m", LengthFormula), (), ("t",))
    for unit, size in (("mm", 1e-3), ("ft", 0.3048), ("km", 1e3)):
        text = f"{a!r} {unit}*sin({w!r} rad/s*t) - {a!r} {unit}/s*t"
        assert law_of(read_formula(text, LengthFormula), (), ("t",))(t=t) == pytest.approx(
            size * plain_law(t=t), rel=1e-12, abs=1e-12
        )
