"""Impacts of Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 9.11 and 9.12."""

import math

import pytest

from dynamics_cli.impact.conventions import ByMass, ByVelocity, Restituted
from dynamics_cli.impact.held.seize import SeizedPart, SquarePlate, seize
from dynamics_cli.impact.particles.oblique import Met, Moving, Normal, oblique

# Printed to four figures.
PRINTED = 5e-4


def test_billiard_balls_of_section_9_11() -> None:
    first = Moving(ByMass(1.0), ByVelocity((0.1414, 0.1414)))
    second = Met(ByMass(1.0), ByVelocity((-0.1299, 0.075)))
    hit = oblique(first=first, second=second, line=Normal(0.0), contact=Restituted(0.95))
    assert hit.first.normal_velocity == pytest.approx(-0.1231, rel=PRINTED)
    # Equation 9.11.10 prints 1.12 cm/s; momentum and restitution require 13.46 cm/s.
    assert hit.second.normal_velocity == pytest.approx(0.1346175, rel=1e-12)
    total = hit.first.normal_velocity + hit.second.normal_velocity
    assert total == pytest.approx(0.1414 - 0.1299, rel=1e-13)
    assert hit.first.tangential_velocity == 0.1414
    assert hit.second.tangential_velocity == 0.075


@pytest.mark.parametrize(("mass", "side", "spin"), [(1.0, 1.0, 10.0), (2.5, 0.3, -4.0)])
def test_plate_whose_edge_is_seized_of_section_9_12(mass: float, side: float, spin: float) -> None:
    held = seize(body=SquarePlate(mass, side, spin, SeizedPart("edge")))
    assert held.angular_ratio == pytest.approx(math.sqrt(2.0) / 8.0, rel=1e-15)
    assert held.energy_ratio == pytest.approx(0.125, rel=1e-15)
    # by momentum: m v of the mass centre, half a side from the hinge
    assert held.impulse_size == pytest.approx(mass * side * abs(spin) * math.sqrt(2.0) / 16.0, rel=1e-14)
    # by energy: what the velocities lost carried, of which the spin about the diagonal held m a² Ω²/24
    assert held.energy_lost == pytest.approx(0.875 * mass * side**2 * spin**2 / 24.0, rel=1e-14)


def test_plate_whose_corner_is_seized_of_section_9_12() -> None:
    held = seize(body=SquarePlate(1.0, 1.0, 10.0, SeizedPart("corner")))
    assert held.angular_ratio == pytest.approx(1.0 / 7.0, rel=1e-14)
    assert held.energy_ratio == pytest.approx(1.0 / 7.0, rel=1e-14)
    assert held.angular_velocity[0] == pytest.approx(held.angular_velocity[1], rel=1e-14)
    assert held.couple is None
