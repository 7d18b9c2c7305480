"""Motion of several masses over time against one exponential of system and load in 32 digits."""

import json
import math
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from harness import answer, run

from dynamics_cli.records import Formula
from dynamics_cli.vibration.shocks.pulses import Shape
from dynamics_cli.vibration.shocks.transient import Push, transient
from dynamics_cli.vibration.single.oscillator import DampingShare, Spring
from dynamics_cli.vibration.systems.history import history
from dynamics_cli.vibration.systems.inputs import Line, Matrices, System
from dynamics_cli.vibration.systems.loads import BaseLaw, ForceLaw, MotionLaw, Recorded, SineBase, SineForce, SineMotion
from dynamics_cli.vibration.systems.modal import Modal

REFERENCES: dict[str, Any] = json.loads((Path(__file__).parent / "motion.json").read_text(encoding="utf-8"))
WAVE = 9.0 / (2.0 * math.pi)
RECORD = [(0.0, 0.0), (0.1, 5.0), (0.3, -2.0), (0.35, 4.0), (0.8, 0.0)]
# Share of the largest displacement: a closed form; up to 60,000 steps, each rounded; the limit of two step sizes.
ROOM = {"sine": 1e-12, "record": 1e-11, "formula": 1e-9}
# Cubics between forty steps in a period.
BETWEEN = 5e-6


def given(name: str) -> tuple[Line, float | None]:
    masses, springs, dampers, ratio = REFERENCES["systems"][name]
    line = Line(tuple(map(float, masses)), tuple(map(float, springs)), tuple(map(float, dampers or ())))
    return line, None if ratio is None else float(ratio)


@pytest.mark.parametrize(
    "case", REFERENCES["histories"], ids=lambda case: f"{case['system']} {case['load']} {case['base']}"
)
def test_the_state_at_the_end(case: dict[str, Any], tmp_path: Path) -> None:
    system, ratio = given(case["system"])
    load: Any
    if case["load"] == "sine":
        load = SineBase(1.0, WAVE) if case["base"] else SineForce(1.0, WAVE)
    elif case["load"] == "formula":
        law = Formula("exp(-3*t)*sin(9*t)", 1.0, "N")
        load = BaseLaw(law) if case["base"] else ForceLaw(law)
    else:
        file = tmp_path / "load.csv"
        file.write_text(f"t[s],{'a[m/s^2]' if case['base'] else 'F[N]'}\n" + "".join(f"{t},{f}\n" for t, f in RECORD))
        load = Recorded(str(file))
    last = str(len(system.masses))
    made = history(system=system, damping_ratio=ratio, load=load, force_at="1", read_at=last, duration=0.8)
    table = made.history.arrays
    room, largest = ROOM[case["load"]], abs(made.peak)
    assert table["displacement"][-1] == pytest.approx(float(case["displacement"]), abs=room * largest)
    assert table["velocity"][-1] == pytest.approx(float(case["velocity"]), abs=1e3 * room * largest)
    assert all(check.passed for check in made.checks)


@pytest.mark.parametrize("case", REFERENCES["moved_bases"], ids=lambda case: f"{case['system']} {case['load']}")
def test_on_a_base_that_is_moved(case: dict[str, Any]) -> None:
    """Absolute motion against one exponential in absolute coordinates, the force of a jump on the dampers included."""
    system, ratio = given(case["system"])
    wave = SineMotion(1.0, WAVE) if case["load"] == "sine" else MotionLaw(Formula("exp(-3*t)*cos(9*t)", 1.0, "m"))
    made = history(system=system, damping_ratio=ratio, load=wave, read_at=str(len(system.masses)), duration=0.8)
    table, room = made.history.arrays, ROOM["sine" if case["load"] == "sine" else "formula"]
    assert table["base_displacement"][-1] == pytest.approx(float(case["base"]), abs=1e-13)
    for name, size in (("absolute", "absolute_displacement"), ("absolute_velocity",) * 2, ("acceleration",) * 2):
        scale = max(abs(table[size]).max(), abs(made.peak))
        assert table[size][-1] == pytest.approx(float(case[name]), abs=1e3 * room * scale), name
    assert table["absolute_displacement"] == pytest.approx(table["displacement"] + table["base_displacement"])
    assert all(check.passed for check in made.checks)


def test_a_recorded_displacement_is_that_of_its_formula(tmp_path: Path) -> None:
    """A spline through close samples, in mm from any zero; a coarse one is reported."""
    line = Line((2.0, 1.0), (200.0, 90.0), (1.0, 0.3))
    file = tmp_path / "base.csv"
    samples = [(0.01 * i, 7.0 + 20.0 * (1.0 - math.cos(0.06 * i))) for i in range(201)]
    file.write_text("t[s],x[mm]\n" + "".join(f"{t},{x}\n" for t, x in samples))
    made = history(system=line, load=Recorded(str(file)))
    typed = history(system=line, load=MotionLaw(Formula("20*(1 - cos(6*t))", 1e-3, "mm")), duration=2.0)
    assert made.peak == pytest.approx(typed.peak, rel=1e-6)
    assert [row.absolute for row in made.peaks] == pytest.approx([row.absolute for row in typed.peaks], rel=1e-6)
    assert made.advice == ()
    file.write_text("t[s],x[mm]\n0,0\n0.1,0\n0.2,20\n0.4,20\n1,20\n")
    assert [one.code for one in history(system=line, load=Recorded(str(file))).advice] == ["coarse"]


def test_an_acceleration_of_the_base_and_its_displacement_are_one() -> None:
    line = Line((2.0, 1.0), (200.0, 90.0), (1.0, 0.3))
    pulled = history(system=line, load=SineBase(2.0, WAVE), duration=2.0)
    # the displacement that it has from rest
    moved = history(system=line, load=MotionLaw(Formula("2/81*(1 - cos(9*t))", 1.0, "m")), duration=2.0)
    for name in ("displacement", "acceleration", "absolute_displacement", "base_displacement"):
        assert pulled.history.arrays[name][-1] == pytest.approx(moved.history.arrays[name][-1], rel=1e-7)


def test_one_mass_is_that_of_transient(tmp_path: Path) -> None:
    """Peaks between steps, beside the closed form."""
    file = tmp_path / "push.csv"
    file.write_text("t[s],F[N]\n0,50\n5,50\n10,50\n")
    alone = transient(mass=2.0, spring=Spring(50.0), damping=DampingShare(0.05), load=Push(50.0, Shape("step")))
    made = history(system=Line((2.0,), (50.0,)), damping_ratio=0.05, load=Recorded(str(file)), force_at="1")
    assert made.peak == pytest.approx(alone.peak, rel=BETWEEN)
    assert made.peak_time == pytest.approx(alone.peak_time, rel=1e-4)
    assert 2.0 * made.peaks[0].acceleration == pytest.approx(50.0, rel=1e-12)


def test_loads_add_and_two_ways_agree() -> None:
    """Superposition; dampers in proportion by modes, and by the state matrix when one damper is a hair off."""
    line = Line((1.0, 2.0), (100.0, 60.0), (1.0, 0.6))
    off = Line((1.0, 2.0), (100.0, 60.0), (1.0, 0.6 * (1.0 + 1e-9)))
    assert Modal(System(line), None).full is None
    assert Modal(System(off), None).full is not None

    def at_end(system: Line, text: str) -> float:
        made = history(system=system, load=ForceLaw(Formula(text, 1.0, "N")), force_at="1", read_at="2", duration=2.0)
        return float(made.history.arrays["displacement"][-1])

    one, other = at_end(line, "t"), at_end(line, "sin(5*t)")
    assert at_end(line, "t + sin(5*t)") == pytest.approx(one + other, rel=1e-7)
    assert at_end(off, "t") == pytest.approx(one, rel=1e-7)


def test_receptances_of_coupled_modes_by_both_ways() -> None:
    """Sums over complex modes, and solutions at each frequency; eigenvectors that fall together leave the second."""
    of = Modal(System(Line((1.0, 2.0, 3.0), (100.0, 200.0, 50.0), (0.5, 0.0, 7.0))), None)
    weights, rates = of.shapes[:, 0], np.geomspace(0.5, 50.0, 200)
    modal = of.curve(rates, weights, 2)
    direct = np.array([of.column(float(rate), weights)[2] for rate in rates])
    assert np.allclose(modal, direct, rtol=1e-11, atol=0.0)
    # both modes critically damped, and coupled: a defective state matrix
    one = tuple((Fraction(x).numerator, Fraction(x).denominator) for x in (1, 0))
    mass = (one, one[::-1])
    stiffness = tuple(tuple((x, 1) for x in row) for row in ((4, 1), (1, 3)))
    damping = tuple(tuple((x, 1) for x in row) for row in ((5, 0), (0, 2)))
    odd = Modal(System(Matrices(mass, stiffness, damping)), None)
    assert odd.full is not None
    curve = odd.curve(rates, odd.shapes[:, 0], 1)
    assert np.allclose(curve, [odd.column(float(rate), odd.shapes[:, 0])[1] for rate in rates], rtol=1e-10)


def test_what_is_refused_or_said(tmp_path: Path) -> None:
    short = tmp_path / "base.csv"
    short.write_text("t[s],x[mm]\n0,0\n1,3\n2,0\n")
    two = ("--masses", "1, 1 kg", "--stiffnesses", "10, 10 N/m")
    for more, code in (
        (("--force", "1 N", "--frequency", "1 Hz", "--force-at", "1"), "no-duration"),
        (("--force", "1 N", "--frequency", "1 Hz", "--duration", "1 s"), "no-place"),
        (("--force", "1 N", "--frequency", "0 Hz", "--force-at", "1", "--duration", "1 s"), "at-rest"),
        (("--force-law", "sin(t)/t N", "--force-at", "1", "--duration", "1 s"), "no-value"),
        (("--force-law", "0*t N", "--force-at", "1", "--duration", "1 s"), "no-load"),
        (("--base-motion", "0*t mm", "--duration", "1 s"), "no-load"),
        (("--base-motion", "abs(t - 0) mm", "--duration", "1 s"), "no-value"),
        (("--file", str(short), "--duration", "9 s"), "length"),
    ):
        outcome = run("vibration", "history", *two, *more, "--json")
        assert outcome.status == 3, outcome.out
        assert outcome.error["code"] == code
    free = ("--masses", "1, 1 kg", "--stiffnesses", "10 N/m")
    shaken = ("--base-amplitude", "10 mm", "--frequency", "2 Hz", "--duration", "1 s", "--json")
    assert [one["code"] for one in run("vibration", "history", *free, *shaken).document["warnings"]] == ["no-base"]
    assert run("vibration", "history", *two, *shaken).document["warnings"] == []
    stiff = ("--masses", "1, 1 kg", "--stiffnesses", "10, 1e12 N/m")
    document = answer("vibration", "history", *stiff, "--force", "1 N", "--frequency", "1 Hz", "--force-at", "1",
                      "--duration", "9 s")  # fmt: skip
    assert [one["code"] for one in document["warnings"]] == ["steps"]
    assert document["checks"] == []
