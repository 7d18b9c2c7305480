"""Measuring sizes printed in the KHK Gear Technical Reference (SDP/SI, Elements of Metric Gear Technology).

The span of a spur gear, and SDP/SI table 10-1 (chordal thickness at the pitch circle). Half a unit of the last printed
digit is the tolerance, or a whole one, since some printed digits of these tables are cut and not rounded.
"""

import math

import pytest

from dynamics_cli.gear.measure.measurement import measure
from dynamics_cli.gear.measure.sizes import shift_from_chord
from dynamics_cli.gear.mesh.mesh import mesh
from dynamics_cli.gear.pitch import NormalModule
from dynamics_cli.gear.single.toothing import Toothing

MM = 1e-3
FOUR_DIGITS = 5.1e-5
FIVE_DIGITS = 5.1e-6


def test_span_of_a_profile_shifted_spur_gear() -> None:
    """z = 24, m = 3, α = 20°, x = 0.4: z_mf = 3.78787, W = 32.8266 over 4 teeth."""
    span = measure(teeth=24, pitch=NormalModule(3 * MM), profile_shift=0.4).span
    assert span is not None
    assert span.over == 4
    assert span.ideal_over == pytest.approx(3.78787, abs=FIVE_DIGITS)
    assert span.span / MM == pytest.approx(32.8266, abs=FOUR_DIGITS)


def test_chordal_thickness_of_a_spur_gear() -> None:
    """Table 10-1: z = 12, m = 10, α = 20°, x = 0.3, h_a = 13: s = 17.8918, θ = 8.5427°, s̄ = 17.8256, h̄ = 13.6657."""
    answer = measure(teeth=12, pitch=NormalModule(10 * MM), profile_shift=0.3)
    assert answer.chordal is not None
    assert answer.normal_thickness / MM == pytest.approx(17.8918, abs=FOUR_DIGITS)
    assert answer.chordal.thickness / MM == pytest.approx(17.8256, abs=FOUR_DIGITS)
    assert answer.chordal.height / MM == pytest.approx(13.6657, abs=FOUR_DIGITS)
    half_angle = math.degrees(math.asin(answer.chordal.thickness / (120 * MM)))
    assert half_angle == pytest.approx(8.5427, abs=FOUR_DIGITS)


def test_the_printed_chord_gives_the_shift_back() -> None:
    """A digit of the printed chord is worth 2·10⁻⁵ of the shift."""
    gear = Toothing(12, False, 10 * MM, math.radians(20.0), 0.0, 0.0, 73 * MM, 50 * MM)
    assert shift_from_chord(gear, 17.8256 * MM) == pytest.approx(0.3, abs=2e-5)


def test_the_internal_pair_of_the_handbook_fails_its_own_inequality() -> None:
    """z = 16 and 24, x₂ = 0.5: a_w = 13.1683, but the pinion has no involute where the ring's tips would begin contact.

    The handbook's condition z₁/z₂ ≥ 1 − tan α_a2/tan α_w is missed by 0.0014, so its contact ratio is a nominal one.
    """
    answer = mesh(
        first_teeth=16,
        second_teeth=24,
        pitch=NormalModule(3 * MM),
        internal=True,
        second_profile_shift=-0.5,
        points=1000,
    )
    assert answer.centre_distance / MM == pytest.approx(13.1683, abs=FOUR_DIGITS)
    assert answer.begins_at == "form circle of gear 1"
    assert answer.contact_ratio < answer.nominal_contact_ratio
    tip_angle = math.acos(24 * 3 * math.cos(math.radians(20.0)) / 69.0)
    limit = 1.0 - math.tan(tip_angle) / math.tan(answer.working_pressure_angle)
    assert limit > 16 / 24
    assert limit == pytest.approx(0.66809, abs=FIVE_DIGITS)


def test_shortened_tips_give_the_handbook_contact_ratio() -> None:
    """Table 4.3: z = 12 and 24, x = 0.6 and 0.36, d_a = 44.84 and 79.40 (cut digits): ε_α = 1.202."""
    answer = mesh(
        first_teeth=12,
        second_teeth=24,
        pitch=NormalModule(3 * MM),
        first_profile_shift=0.6,
        second_profile_shift=0.36,
        first_tip_diameter=44.840 * MM,
        second_tip_diameter=79.400 * MM,
        points=1000,
    )
    assert answer.centre_distance / MM == pytest.approx(56.4999, abs=FOUR_DIGITS)
    assert math.degrees(answer.working_pressure_angle) == pytest.approx(26.0886, abs=FOUR_DIGITS)
    assert answer.nominal_contact_ratio == pytest.approx(1.202, abs=5.1e-4)
    assert answer.runs
