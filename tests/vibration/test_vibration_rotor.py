"""Rotors on several bearings against closed forms, the disk on a massless shaft, and transfer matrices."""

import math
from typing import Any

import numpy as np
import pytest
from harness import answer, run
from scipy.linalg import expm
from scipy.optimize import brentq

from dynamics_cli.pictures import Band, Mark
from dynamics_cli.vibration.shafts.rotor import Bearing, Disk, Section, rotor
from dynamics_cli.vibration.shafts.whirl import Bar, whirl
from dynamics_cli.vibration.single.pictures import over_speed

E, RHO = 210e9, 7850.0
# 40 elements: the third mode is within 2e-6, lower ones nearer.
MESH = 5e-6


@pytest.mark.parametrize("speed", [0.0, 300.0, 4000.0])
def test_a_uniform_shaft_between_short_bearings_whirls_as_its_closed_form(speed: float) -> None:
    """Rayleigh beam, pinned: λ²(ρA + ρIk²) − 2ρIk²Ωλ − EIk⁴ = 0 with k = nπ/L."""
    length, diameter, bore = 1.2, 0.06, 0.02
    area, second = math.pi / 4 * (diameter**2 - bore**2), math.pi / 64 * (diameter**4 - bore**4)
    made = rotor(sections=Section(length, diameter, bore), bearings=(Bearing(0.0), Bearing(length)), speed=speed)
    assert made.mass == pytest.approx(RHO * area * length, rel=1e-12)
    assert made.whirls is not None
    for row in made.whirls:
        k = row.mode * math.pi / length
        roots = np.roots([RHO * area + RHO * second * k**2, -2.0 * RHO * second * k**2 * speed, -E * second * k**4])
        assert row.forward == pytest.approx(max(roots) / (2.0 * math.pi), rel=MESH)
        assert row.backward == pytest.approx(-min(roots) / (2.0 * math.pi), rel=MESH)
    forward = [row for row in made.criticals if row.whirl == "forward"]
    for row in forward:
        k = row.mode * math.pi / length
        assert row.speed == pytest.approx(math.sqrt(E * second * k**4 / (RHO * (area - second * k**2))), rel=MESH)


@pytest.mark.parametrize("overhung", [False, True])
def test_a_light_shaft_is_the_disk_on_a_massless_one(overhung: bool) -> None:
    """Two light shafts give the limit without mass by a straight line."""
    disk: dict[str, Any] = {"mass": 30.0, "polar_inertia": 0.5, "diametral_inertia": 0.25}
    shaft = Bar(0.04, 0.6, support="overhung") if overhung else Bar(0.04, 0.9, 0.3)  # type: ignore[arg-type]
    exact = whirl(shaft=shaft, eccentricity=2e-5, speed=377.0, orders=(1.0, 2.0), **disk)
    held = (Bearing(0.0, None, 1e13),) if overhung else (Bearing(0.0), Bearing(0.9))
    place = 0.6 if overhung else 0.3
    light = [
        rotor(sections=Section(shaft.length, 0.04), bearings=held, disks=(Disk(place, **disk),), orders=(1.0, 2.0),
              density=density)
        for density in (2.0, 1.0)
    ]  # fmt: skip
    speeds = [{(row.order, row.whirl, row.mode): row.speed for row in one.criticals} for one in light]
    assert exact.criticals is not None
    for row in exact.criticals:
        two, one = (each[row.order, row.whirl, row.mode] for each in speeds)
        assert 2.0 * one - two == pytest.approx(row.speed, rel=1e-6)


def test_a_stepped_rotor_agrees_with_transfer_matrices() -> None:
    """The exact solution of every section by the exponential of its equations, from one free end to the other."""
    sections = (Section(0.2, 0.05), Section(0.5, 0.065, 0.02), Section(0.3, 0.05))
    bearings = (Bearing(0.06, 80e6, 1e4), Bearing(0.75, 60e6))
    disks = (Disk(0.4, 35.0, 0.8), Disk(0.97, 12.0, 0.2, 0.11))
    speed = 500.0
    made = rotor(sections=sections, bearings=bearings, disks=disks, speed=speed)
    assert made.whirls is not None
    for row in made.whirls:
        for rate in (2.0 * math.pi * row.forward, -2.0 * math.pi * row.backward):
            root = brentq(
                _residual, 0.999 * rate, 1.001 * rate, (speed, sections, bearings, disks), xtol=1e-9 * abs(rate)
            )
            assert rate == pytest.approx(root, rel=MESH)
    for critical in made.criticals:
        sign = 1.0 if critical.whirl == "forward" else -1.0
        root = brentq(lambda w, s=sign: _residual(s * w, w, sections, bearings, disks), 0.999 * critical.speed,
                      1.001 * critical.speed)  # fmt: skip
        assert critical.speed == pytest.approx(root, rel=MESH)


def _residual(rate: float, speed: float, sections: Any, bearings: Any, disks: Any) -> float:
    """The determinant of moment and force at the right end: w, φ, M, V with both zero at the left one."""
    events = sorted([*bearings, *disks], key=lambda part: part.position)
    state, at = np.eye(4)[:, :2], 0.0

    def jump(part: Any) -> None:
        nonlocal state
        step = np.eye(4)
        if isinstance(part, Bearing):
            step[3, 0], step[2, 1] = part.stiffness or 0.0, part.tilting
        else:
            across = 0.5 * part.polar_inertia if part.diametral_inertia is None else part.diametral_inertia
            step[3, 0], step[2, 1] = -(rate**2) * part.mass, -(rate**2 * across - rate * speed * part.polar_inertia)
        state = step @ state

    for part in sections:
        area, second = math.pi / 4 * (part.diameter**2 - part.bore**2), math.pi / 64 * (part.diameter**4 - part.bore**4)
        turn = RHO * second * (rate**2 - 2.0 * rate * speed)
        law = np.zeros((4, 4))
        law[0, 1], law[1, 2], law[2, 1], law[2, 3], law[3, 0] = (
            1.0,
            1.0 / (E * second),
            -turn,
            -1.0,
            -(rate**2) * RHO * area,
        )
        end = at + part.length
        while events and events[0].position < end:
            state = expm(law * (events[0].position - at)) @ state
            at = events[0].position
            jump(events.pop(0))
        state = expm(law * (end - at)) @ state
        at = end
    return float(np.linalg.det(state[2:]))


REFUSED = {
    "position": '--bearing "position=2 m" --bearing "position=0 m"',
    "mechanism": '--bearing "position=0.2 m"',
    "soft-bearings": '--bearing "position=0 m, stiffness=1e-12 N/m" --bearing "position=1 m, stiffness=1e-12 N/m"',
    "section": '--bearing "position=0 m" --bearing "position=1 m" --bore "50 mm"',
}


@pytest.mark.parametrize("code", REFUSED)
def test_refusals(code: str) -> None:
    import shlex

    out = run("vibration", "rotor", "--length", "1 m", "--diameter", "40 mm", *shlex.split(REFUSED[code]), "--json")
    assert (out.status, out.error["code"]) == (3, code)


def test_a_speed_near_a_critical_one_is_warned_of() -> None:
    typed = ("--length", "1 m", "--diameter", "40 mm", "--bearing", "position=0 m", "--bearing", "position=1 m")
    document = answer("vibration", "rotor", *typed, "--speed", "4800 rpm")
    assert [each["code"] for each in document["warnings"]] == ["near-critical"]
    assert 0.8 < document["results"]["margin"]["value"] < 1.2


def test_the_eccentricity_is_named_beside_its_line() -> None:
    """Its line has the pen of the critical speed: a legend would not tell them apart."""
    panel = over_speed(whirl(shaft=Bar(0.04, 0.9), mass=30.0, eccentricity=2e-5, speed=300.0), 0.0, "whirl", "e")
    assert [item.label for item in panel.items if isinstance(item, Band)] == ["critical", ""]
    assert [item.y for item in panel.items if isinstance(item, Mark) and item.label == "e"] == [pytest.approx(2e-5)]
