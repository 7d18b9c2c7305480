"""Rotors on bearings of eight coefficients against transfer matrices to 40 digits, Jeffcott's rotor, and laws."""

import cmath
import json
import math
from pathlib import Path
from typing import Any

import pytest
from harness import answer, run

from dynamics_cli.sampling import Drawing
from dynamics_cli.vibration.rotors.orbit_records import Bearing, RotorResponse, Unbalance
from dynamics_cli.vibration.rotors.response import rotor_response
from dynamics_cli.vibration.rotors.stepped import Disk, Section

CASES: list[dict[str, Any]] = json.loads(Path(__file__).with_name("rotor_response.json").read_text("utf-8"))
# Frequencies are off by 1e-6 for the mesh; amplitudes by as much more as the speed is near a peak.
MESH = 2e-6
# Of a sample of uncertain inputs.
FEW_ELEMENTS = 1e-4


def made(case: dict[str, Any], speed: float, **more: Any) -> RotorResponse:
    return rotor_response(
        sections=tuple(Section(*each) for each in case["sections"]),
        bearings=tuple(
            Bearing(**dict(zip(("position", "kxx", "kyy", "cxx", "cyy", "kxy", "kyx", "cxy", "cyx", "swirl"), each,
                               strict=True)))
            for each in case["bearings"]
        ),
        disks=tuple(Disk(*each) for each in case["disks"]),
        unbalances=tuple(Unbalance(*each) for each in case["unbalances"]),
        read_at=tuple(case["read"]), speed=speed, **more,
    )  # fmt: skip


@pytest.mark.parametrize("case", CASES, ids=[case["name"] for case in CASES])
def test_orbits_forces_and_whirls_are_those_of_the_exact_sections(case: dict[str, Any]) -> None:
    orbits, forces = [], []
    for speed in case["speeds"]:
        at = made(case, speed, highest_speed=speed)
        assert at.orbits is not None
        assert at.loads is not None
        orbits += [(row.horizontal, row.horizontal_lag, row.vertical, row.vertical_lag) for row in at.orbits]
        forces += [(row.horizontal, row.vertical) for row in at.loads]
    for found, exact in zip(orbits, case["results"]["orbits"], strict=True):
        for n in (0, 2):
            given = cmath.rect(float(exact[n]), float(exact[n + 1]))
            assert abs(cmath.rect(found[n], found[n + 1]) - given) < 2.0 * MESH * abs(given)
    for loads, exact in zip(forces, case["results"]["forces"], strict=True):
        assert loads == pytest.approx([float(each) for each in exact], rel=2.0 * MESH)
    whole = made(case, case["free"], highest_speed=case["free"])
    with Drawing():  # fewer elements and modes
        sample = made(case, case["free"], highest_speed=case["free"])
    assert (sample.amplitude, sample.force) == pytest.approx((whole.amplitude, whole.force), rel=FEW_ELEMENTS)
    modes = whole.modes
    assert modes is not None
    rates = [2.0 * math.pi * row.frequency * complex(-row.decrement / (2.0 * math.pi), 1.0) for row in modes]
    for real, imaginary in case["results"]["whirls"]:
        exact_rate = complex(float(real), float(imaginary))
        assert min(abs(rate - exact_rate) for rate in rates) < MESH * abs(exact_rate)


def jeffcott(density: float, **more: Any) -> RotorResponse:
    """A disk amid a thin shaft of a stiff metal."""
    held = {"kxx": 4e6, "kyy": 9e6, "cxx": 900.0, "cyy": 1500.0} | more
    bearings = (Bearing(0.0, **held), Bearing(0.8, **held))
    return rotor_response(
        sections=Section(0.8, 4e-5), bearings=bearings, disks=(Disk(0.4, 20.0),), speed=320.0, highest_speed=1200.0,
        unbalances=(Unbalance(0.4, 1e-3),), elastic_modulus=210e21, density=density,
    )  # fmt: skip


def test_a_light_shaft_in_two_bearings_is_jeffcotts_rotor() -> None:
    """Shaft and bearings in series in each direction: X = U·Ω²/(1/(1/k_s + 1/(2(k + iΩc))) − mΩ²)."""
    shaft = 48.0 * 210e21 * math.pi / 64.0 * 4e-5**4 / 0.8**3

    def deflection(speed: float, k: float, c: float) -> complex:
        return 1e-3 * speed**2 / (1.0 / (1.0 / shaft + 0.5 / (k + 1j * speed * c)) - 20.0 * speed**2)

    two, one = (jeffcott(density) for density in (2e5, 1e5))
    assert one.orbits is not None
    assert two.orbits is not None
    row, heavy = one.orbits[0], two.orbits[0]
    for name, k, c in (("horizontal", 4e6, 900.0), ("vertical", 9e6, 1500.0)):
        exact = deflection(320.0, k, c)
        assert 2.0 * getattr(row, name) - getattr(heavy, name) == pytest.approx(abs(exact), rel=1e-5)
        assert getattr(row, f"{name}_lag") == pytest.approx(-cmath.phase(exact), rel=1e-3)
    # between its two critical speeds it whirls backward
    assert row.whirl == "backward"
    assert one.peaks is not None
    assert len(one.peaks) == 2


def test_an_oil_film_starts_to_whip_at_the_frequency_of_the_shaft_over_its_swirl() -> None:
    """The film's force vanishes where the whirl is as fast as the film: ω² = k/m of shaft and bearings in series."""
    shaft = 48.0 * 210e21 * math.pi / 64.0 * 4e-5**4 / 0.8**3
    rate = math.sqrt(1.0 / (1.0 / shaft + 0.5 / 4e6) / 20.0)
    made_of = {density: jeffcott(density, kyy=4e6, cxx=3000.0, cyy=3000.0, swirl=0.45) for density in (2e5, 1e5)}
    onsets = [made_of[density].onset for density in (2e5, 1e5)]
    assert None not in onsets
    assert 2.0 * onsets[1] - onsets[0] == pytest.approx(rate / 0.45, rel=1e-6)  # type: ignore[operator]
    light = made_of[1e5]
    assert light.onset_frequency == pytest.approx(rate / (2.0 * math.pi), rel=1e-3)
    assert "unstable" not in [each.code for each in light.advice]


def test_twice_the_unbalance_moves_it_twice_as_far() -> None:
    case = CASES[1]
    doubled = {**case, "unbalances": [[place, 2.0 * size, angle] for place, size, angle in case["unbalances"]]}
    one, two = made(case, 420.0), made(doubled, 420.0)
    assert one.orbits is not None
    assert two.orbits is not None
    assert two.orbits[0].major == pytest.approx(2.0 * one.orbits[0].major, rel=1e-12)


HELD = ("--bearing", "position=0 m", "--bearing", "position=1 m")
TYPED = ("--length", "1 m", "--diameter", "40 mm")
REFUSED = {
    "position": (*HELD, "--unbalance", "position=2 m, unbalance=1 g*mm"),
    "mechanism": ("--bearing", "position=0.2 m"),
    "missing": ("--bearing", "position=0 m, cxx=5 N*s/m", "--bearing", "position=1 m"),
    "negative": (*HELD, "--bearing", "position=0.5 m, kxx=1 N/mm, kxy=2 N/mm, kyx=2 N/mm"),
    "negative ": ("--bearing", "position=0 m, kxx=1 N/mm, cxx=-5 N*s/m", "--bearing", "position=1 m"),
}  # fmt: skip


@pytest.mark.parametrize("code", REFUSED)
def test_refusals(code: str) -> None:
    out = run("vibration", "rotor-response", *TYPED, *REFUSED[code], "--json")
    assert (out.status, out.error["code"]) == (3, code.strip())


def test_a_rotor_that_whips_and_one_without_damping_are_warned_of() -> None:
    whips = "kxx=40 kN/mm, cxx=1 kN*s/m, kxy=20 kN/mm, kyx=-20 kN/mm"
    typed = ("--bearing", f"position=0 m, {whips}", "--bearing", f"position=1 m, {whips}")
    document = answer("vibration", "rotor-response", *TYPED, *typed)
    assert [each["code"] for each in document["warnings"]] == ["unstable"]
    document = answer("vibration", "rotor-response", *TYPED, *HELD, "--unbalance", "position=0.4 m, unbalance=9 g*mm")
    assert [each["code"] for each in document["warnings"]] == ["undamped"]
    assert document["results"]["critical_speed"] is None
