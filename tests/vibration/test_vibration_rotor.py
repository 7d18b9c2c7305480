"""Rotors on several bearings against closed forms, the disk on a massless shaft, and transfer matrices to 40 digits."""

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from harness import answer, run

from dynamics_cli.pictures import Band, Mark
from dynamics_cli.sampling import Drawing
from dynamics_cli.vibration.rotors.rotor import Bearing, rotor
from dynamics_cli.vibration.rotors.stepped import Disk, Material, Section
from dynamics_cli.vibration.shafts.whirl import Bar, whirl
from dynamics_cli.vibration.single.pictures import over_speed

E, RHO = 210e9, 7850.0
# Along an element the shear is constant: the error grows with the square of the mode, 6e-5 at the third.
MESH = 7e-6
# Of a sample of uncertain inputs, with a third of the elements.
FEW_ELEMENTS = 1e-4
CASES: list[dict[str, Any]] = json.loads(Path(__file__).with_name("rotor.json").read_text("utf-8"))
LISTED = 2


@pytest.mark.parametrize("speed", [0.0, 300.0, 4000.0])
def test_a_uniform_shaft_between_short_bearings_whirls_as_its_closed_form(speed: float) -> None:
    """Timoshenko beam, pinned: (Sk² − ρAλ²)(EIk² + S − ρIλ² + 2ρIΩλ) = S²k² with S = κGA and k = nπ/L."""
    length, diameter, bore = 1.2, 0.06, 0.02
    made = rotor(sections=Section(length, diameter, bore), bearings=(Bearing(0.0), Bearing(length)), speed=speed)
    bending, shear, mass, inertia = Material(E, 0.3, RHO).section(diameter, bore)
    assert made.mass == pytest.approx(RHO * math.pi / 4 * (diameter**2 - bore**2) * length, rel=1e-12)

    def rates(k: float, turning: float, gyroscopic: float) -> list[float]:
        """Real roots for a shaft that turns at `turning`, or at the rate times −`gyroscopic`."""
        shift = np.poly1d([-mass, 0.0, shear * k**2])
        tilt = np.poly1d([inertia * (gyroscopic - 1.0), 2.0 * inertia * turning, bending * k**2 + shear])
        return sorted(float(root.real) for root in (shift * tilt - shear**2 * k**2).r if abs(root.imag) < 1.0)

    assert made.whirls is not None
    for row in made.whirls:
        found = rates(row.mode * math.pi / length, speed, 0.0)
        assert row.forward == pytest.approx(min(x for x in found if x > 0.0) / (2.0 * math.pi), rel=MESH * row.mode**2)
        assert row.backward == pytest.approx(
            min(-x for x in found if x < 0.0) / (2.0 * math.pi), rel=MESH * row.mode**2
        )
    for row in made.criticals:
        if row.whirl == "forward":
            found = rates(row.mode * math.pi / length, 0.0, 2.0)
            assert row.speed == pytest.approx(min(x for x in found if x > 0.0), rel=MESH * row.mode**2)


@pytest.mark.parametrize("overhung", [False, True])
def test_a_light_shaft_is_the_disk_on_a_massless_one(overhung: bool) -> None:
    """Two light shafts give the limit without mass by a straight line; thin ones of a stiff metal do not shear."""
    thin, stiff = 4e-5, 210e21
    disk: dict[str, Any] = {"mass": 30.0, "polar_inertia": 0.5, "diametral_inertia": 0.25}
    shaft = (
        Bar(thin, 0.6, support="overhung", elastic_modulus=stiff)  # type: ignore[arg-type]
        if overhung
        else Bar(thin, 0.9, 0.3, elastic_modulus=stiff)
    )
    exact = whirl(shaft=shaft, eccentricity=2e-5, speed=377.0, orders=(1.0, 2.0), **disk)
    held = (Bearing(0.0, None, 1e13),) if overhung else (Bearing(0.0), Bearing(0.9))
    place = 0.6 if overhung else 0.3
    light = [
        rotor(sections=Section(shaft.length, thin), bearings=held, disks=(Disk(place, **disk),), orders=(1.0, 2.0),
              density=density, elastic_modulus=stiff)
        for density in (2e6, 1e6)
    ]  # fmt: skip
    speeds = [{(row.order, row.whirl, row.mode): row.speed for row in one.criticals} for one in light]
    assert exact.criticals is not None
    for row in exact.criticals:
        two, one = (each[row.order, row.whirl, row.mode] for each in speeds)
        assert 2.0 * one - two == pytest.approx(row.speed, rel=1e-6)


@pytest.mark.parametrize("case", CASES, ids=[case["name"] for case in CASES])
def test_rotors_whirl_as_the_exact_solution_of_their_sections(case: dict[str, Any]) -> None:
    sections, bearings, disks = (
        tuple(kind(*each) for each in case[name])
        for name, kind in (("sections", Section), ("bearings", Bearing), ("disks", Disk))
    )
    made = rotor(sections=sections, bearings=bearings, disks=disks, speed=case["speed"], orders=(1.0, 2.0))
    assert made.whirls is not None
    with Drawing():  # fewer elements
        sample = rotor(sections=sections, bearings=bearings, disks=disks)
    assert (sample.critical_speed, sample.mass) == pytest.approx((made.critical_speed, made.mass), rel=FEW_ELEMENTS)
    for way in ("forward", "backward"):
        exact = [float(rate) for rate in case["results"][way]]
        found = [2.0 * math.pi * getattr(row, way) for row in made.whirls]
        assert found[: len(exact)] == pytest.approx(exact, rel=4.0 * MESH), way
        for order in (1.0, 2.0):
            exact = [float(speed) for speed in case["results"][f"{way} {order:g}"]]
            found = [row.speed for row in made.criticals if (row.order, row.whirl) == (order, way)]
            assert found[: len(exact)] == pytest.approx(exact, rel=4.0 * MESH), (way, order)
            # what the references do not list lies beyond where they were looked for
            assert len(exact) == LISTED or all(speed * order > case["highest"] for speed in found[len(exact) :])


REFUSED = {
    "position": '--bearing "position=2 m" --bearing "position=0 m"',
    "mechanism": '--bearing "position=0.2 m"',
    "soft-bearings": '--bearing "position=0 m, stiffness=1e-12 N/m" --bearing "position=1 m, stiffness=1e-12 N/m"',
    "material": '--bearing "position=0 m" --bearing "position=1 m" --density "0 kg/m^3"',
    "poisson": '--bearing "position=0 m" --bearing "position=1 m" --poisson-ratio 3',
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
