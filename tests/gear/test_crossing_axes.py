"""Bevel, crossed, worm and hypoid pairs, rolling wheels: cones by vectors, forces as one force, limits, refusals."""

from math import cos, degrees, hypot, pi, radians, sin, tan

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics_cli.errors import DynamicsError, InadmissibleError, MissingError
from dynamics_cli.gear.crossing.bevel import bevel
from dynamics_cli.gear.crossing.bevel_records import Flank, Kind
from dynamics_cli.gear.crossing.crossed import Screw, crossed
from dynamics_cli.gear.crossing.hypoid import hypoid
from dynamics_cli.gear.crossing.worm import AxialModule, DiameterFactor, LeadAngle, WormDiameter, WormNormalModule, worm
from dynamics_cli.gear.trains.wheels import Drive, wheels

STANDARD = Kind("standard")


@given(st.integers(8, 80), st.integers(0, 80), st.floats(1.0, 179.0))
def test_pitch_cones_share_a_generator(z1: int, more: int, shafts: float) -> None:
    z2 = z1 + more
    answer = bevel(
        first_teeth=z1, second_teeth=z2, module=0.002, face_width=1e-4, shaft_angle=radians(shafts), kind=STANDARD
    )
    first, second = answer.first.pitch_angle, answer.second.pitch_angle
    assert first + second == pytest.approx(radians(shafts), rel=1e-14)
    assert sin(second) * z1 == pytest.approx(sin(first) * z2, rel=1e-12)
    assert all(check.passed for check in answer.checks)


def test_known_shaft_angles() -> None:
    sixty = bevel(first_teeth=20, second_teeth=40, module=0.002, face_width=0.005, shaft_angle=radians(60.0))
    assert (degrees(sixty.first.pitch_angle), degrees(sixty.second.pitch_angle)) == pytest.approx(
        (19.1066, 40.8934), abs=1e-4
    )
    equal = bevel(first_teeth=20, second_teeth=20, module=0.002, face_width=0.005, shaft_angle=radians(120.0))
    assert degrees(equal.first.pitch_angle) == pytest.approx(60.0, rel=1e-14)
    crown = bevel(
        first_teeth=20, second_teeth=40, module=0.002, face_width=0.005, shaft_angle=radians(120.0), kind=STANDARD
    )
    assert degrees(crown.second.pitch_angle) == pytest.approx(90.0, rel=1e-14)
    assert crown.second.virtual_teeth is None
    assert crown.advice[0].code == "crown-wheel"
    internal = bevel(
        first_teeth=20, second_teeth=40, module=0.002, face_width=0.005, shaft_angle=radians(140.0), kind=STANDARD
    )
    assert internal.second.virtual_teeth < 0.0
    assert internal.contact_ratio > crown.contact_ratio > sixty.contact_ratio


@pytest.mark.parametrize("kind", ["gleason", "spiral", "zerol"])
@pytest.mark.parametrize("flank", ["concave", "convex"])
def test_bevel_forces_are_one_force(kind: str, flank: str) -> None:
    """The force on the wheel is the opposite of that on the pinion, as components along both axes."""
    shafts = radians(75.0)
    answer = bevel(
        first_teeth=15, second_teeth=40, module=0.004, face_width=0.02, shaft_angle=shafts,
        kind=Kind(kind), flank=Flank(flank), torque=30.0,
    )  # fmt: skip
    k1, k2 = np.array([1.0, 0.0]), np.array([cos(shafts), sin(shafts)])
    n1, n2 = np.array([0.0, 1.0]), np.array([sin(shafts), -cos(shafts)])
    pinion, wheel = answer.first, answer.second
    # in the plane of the axes; the mean point lies from either axis towards the other
    on_pinion = pinion.axial_force * k1 - pinion.radial_force * n1
    on_wheel = wheel.axial_force * k2 - wheel.radial_force * n2
    assert on_pinion + on_wheel == pytest.approx(np.zeros(2), abs=1e-9)
    if kind == "spiral":
        assert (pinion.axial_force > 0.0) == (flank == "concave")


def test_bevel_refusals() -> None:
    base = {"first_teeth": 20, "second_teeth": 40, "module": 0.002, "face_width": 0.005}
    for code, more in {
        "shaft-angle": {"shaft_angle": pi},
        "internal-pinion": {"first_teeth": 40, "second_teeth": 20, "shaft_angle": radians(150.0)},
        "face-width": {"face_width": 0.2},
        "internal-wheel": {"shaft_angle": radians(140.0)},
        "spiral-angle": {"spiral_angle": 0.3},
        "pressure-angle": {"pressure_angle": 1.7},
    }.items():
        with pytest.raises(InadmissibleError) as caught:
            bevel(**(base | more))  # type: ignore[arg-type]
        assert caught.value.code == code


@given(st.integers(1, 8), st.floats(6.0, 25.0), st.floats(0.0, 0.25))
def test_worms_and_their_efficiency(threads: int, factor: float, friction: float) -> None:
    answer = worm(
        threads=threads, teeth=40, size=AxialModule(0.004), worm=DiameterFactor(factor), friction=friction, torque=5.0
    )
    same = worm(
        threads=threads, teeth=40, size=AxialModule(0.004), worm=WormDiameter(0.004 * factor), friction=friction
    )
    assert same.lead_angle == pytest.approx(answer.lead_angle, rel=1e-14)
    assert (answer.backward_efficiency < 0.0) == (answer.lead_angle < answer.friction_angle)
    rise = tan(answer.lead_angle)
    drop = (cos(radians(20.0)) * rise - friction) / (rise * (cos(radians(20.0)) + friction * rise))
    assert answer.backward_efficiency == pytest.approx(drop, rel=1e-9, abs=1e-12)
    # power in is power out and friction
    assert answer.wheel_torque == pytest.approx(5.0 * 40 / threads * answer.efficiency, rel=1e-12)
    assert all(check.passed for check in answer.checks)


def test_every_way_to_a_worm() -> None:
    one = worm(threads=3, teeth=50, size=AxialModule(0.005), worm=WormDiameter(0.05))
    by_lead = worm(threads=3, teeth=50, size=AxialModule(0.005), worm=LeadAngle(one.lead_angle))
    normal = worm(threads=3, teeth=50, size=WormNormalModule(one.normal_module), worm=WormDiameter(0.05))
    assert by_lead.worm_diameter == pytest.approx(0.05, rel=1e-14)
    assert normal.axial_module == pytest.approx(0.005, rel=1e-13)
    for code, more in {
        "no-root": {"worm": WormDiameter(0.01)},
        "worm-diameter": {"size": WormNormalModule(0.02)},
        "lead-angle": {"worm": LeadAngle(0.0)},
        "locked": {"friction": 8.0},
        "load": {"torque": 1.0, "power": 2.0},
    }.items():
        with pytest.raises(InadmissibleError) as caught:
            worm(**({"threads": 3, "teeth": 50, "size": AxialModule(0.005), "worm": WormDiameter(0.05)} | more))  # type: ignore[arg-type]
        assert caught.value.code == code


def test_crossed_gears_at_right_angles_are_a_worm() -> None:
    answer = crossed(first=Screw(2, radians(75.0)), second=Screw(30, radians(15.0)), module=0.003, friction=0.08)
    same = worm(
        threads=2, teeth=30, size=WormNormalModule(0.003), worm=WormDiameter(answer.first_diameter), friction=0.08
    )
    assert degrees(answer.shaft_angle) == pytest.approx(90.0, rel=1e-14)
    assert answer.centre_distance == pytest.approx(same.centre_distance, rel=1e-13)
    assert answer.efficiency == pytest.approx(same.efficiency, rel=1e-12)
    assert answer.backward_efficiency == pytest.approx(same.backward_efficiency, rel=1e-10)


def test_crossed_sliding_by_velocities_and_refusals() -> None:
    answer = crossed(first=Screw(15, 0.5), second=Screw(24, 0.3), module=0.003, speed=50.0)
    v1, v2 = 25.0 * answer.first_diameter, 25.0 * answer.second_diameter * 15 / 24
    # velocities at the pitch point, each across its own axis
    assert answer.sliding_speed == pytest.approx(hypot(v1 - v2 * cos(0.8), v2 * sin(0.8)), rel=1e-12)
    assert answer.advice == ()
    with pytest.raises(InadmissibleError, match="parallel"):
        crossed(first=Screw(15, 0.5), second=Screw(24, -0.5), module=0.003)
    with pytest.raises(InadmissibleError, match="below 0"):
        crossed(first=Screw(10, 0.1, -0.5), second=Screw(10, 0.1, -0.5), module=0.003)


@settings(max_examples=50, deadline=None)
@given(st.integers(6, 20), st.floats(2.5, 6.0), st.floats(-0.3, 0.45), st.floats(60.0, 120.0), st.floats(0.4, 0.9))
def test_hypoid_pitch_point_by_vectors(z1: int, u: float, share: float, shafts: float, spiral: float) -> None:
    """Both axes, cones and tooth directions rebuilt in space: the cones touch, the axes lie the offset apart."""
    if abs(share) < 1e-6:
        return
    try:
        answer = hypoid(first_teeth=z1, second_teeth=round(u * z1), offset=0.1 * share, wheel_radius=0.1,
                        pinion_spiral_angle=spiral, shaft_angle=radians(shafts))  # fmt: skip
    except InadmissibleError as error:
        if error.code in ("offset", "wheel-pitch-angle"):
            return
        raise
    eta, wheel, first = answer.axial_offset_angle, answer.second_pitch_angle, answer.first_pitch_angle
    point = 0.1 * np.array([cos(eta), sin(eta), 0.0])
    normal = np.array([cos(wheel) * cos(eta), cos(wheel) * sin(eta), sin(wheel)])
    axis = np.array([sin(radians(shafts)), 0.0, -cos(radians(shafts))])
    foot = point + answer.first_pitch_radius / cos(first) * normal
    assert foot[1] == pytest.approx(0.1 * share, rel=1e-9)
    assert normal @ axis == pytest.approx(sin(first), rel=1e-12)
    apex = foot - answer.first_pitch_radius / (cos(first) * sin(first)) * axis
    to_apex, to_own = apex - point, np.array([0.0, 0.0, 0.1 / tan(wheel)]) - point
    assert to_apex @ normal == pytest.approx(0.0, abs=1e-13)
    assert to_own @ normal == pytest.approx(0.0, abs=1e-13)
    assert np.linalg.norm(to_apex) == pytest.approx(answer.first_cone_distance, rel=1e-10)
    between = to_apex @ to_own / (np.linalg.norm(to_apex) * np.linalg.norm(to_own))
    assert between == pytest.approx(cos(answer.pitch_offset_angle), rel=1e-9)
    # the crossing point of the axes in the view along their common perpendicular
    crossing = foot - foot[0] / axis[0] * axis
    assert (apex - crossing) @ axis == pytest.approx(answer.first_apex_distance, abs=1e-10)
    assert 0.1 / tan(wheel) - crossing[2] == pytest.approx(answer.second_apex_distance, abs=1e-10)
    assert all(check.passed for check in answer.checks)


def test_hypoid_refusals_and_the_limit_of_a_bevel_pair() -> None:
    small = hypoid(first_teeth=10, second_teeth=40, offset=1e-7, wheel_radius=0.08, pinion_spiral_angle=0.6)
    flat = bevel(first_teeth=10, second_teeth=40, module=0.004, face_width=0.01)
    assert small.first_pitch_angle == pytest.approx(flat.first.pitch_angle, abs=1e-9)
    assert small.second_spiral_angle == pytest.approx(0.6, abs=1e-5)
    assert small.enlargement == pytest.approx(1.0, abs=1e-5)
    for code, more in {
        "no-offset": {"offset": 0.0},
        "offset": {"offset": 0.09},
        "shaft-angle": {"shaft_angle": 0.0},
        "wheel-pitch-angle": {"wheel_pitch_angle": 1.6},
    }.items():
        with pytest.raises(InadmissibleError) as caught:
            hypoid(**({"first_teeth": 10, "second_teeth": 40, "offset": 0.02, "wheel_radius": 0.08} | more))  # type: ignore[arg-type]
        assert caught.value.code == code


@given(st.floats(0.01, 1.0), st.floats(0.01, 1.0), st.floats(1.0, 10.0))
def test_belts_close(one: float, two: float, share: float) -> None:
    distance = share * 0.5 * (one + two)
    for drive, turns in (("open-belt", 1.0), ("crossed-belt", 0.0)):
        answer = wheels(first_diameter=one, second_diameter=two, drive=Drive(drive), centre_distance=distance)
        assert all(check.passed for check in answer.checks)
        assert answer.first_wrap + (2 * turns - 1) * answer.second_wrap == pytest.approx(2.0 * pi * turns, abs=1e-14)
        assert answer.belt_length >= (2.0 * distance + pi * min(one, two)) * (1.0 - 1e-9)
    crossed_length = answer.belt_length
    opened = wheels(first_diameter=one, second_diameter=two, drive=Drive("open-belt"), centre_distance=distance)
    assert crossed_length >= opened.belt_length


def test_friction_carries_the_load() -> None:
    answer = wheels(first_diameter=0.1, second_diameter=0.3, drive=Drive("open-belt"), centre_distance=0.5,
                    speed=150.0, power=2000.0, friction=0.3, belt_mass=0.2)  # fmt: skip
    lifted = 0.2 * answer.rim_speed**2
    assert answer.tight_tension - answer.slack_tension == pytest.approx(2000.0 / 7.5)
    assert (answer.tight_tension - lifted) / (answer.slack_tension - lifted) == pytest.approx(answer.tension_ratio)
    rolled = wheels(first_diameter=0.1, second_diameter=0.3, torque=3.0, friction=0.2)
    assert rolled.normal_force == pytest.approx(3.0 / 0.05 / 0.2)
    assert rolled.ratio == pytest.approx(-3.0)
    for code, more in {
        "no-distance": {"drive": Drive("belt")},
        "overlap": {"drive": Drive("belt"), "centre_distance": 0.1},
        "distance": {"centre_distance": 0.3},
        "equal-wheels": {"drive": Drive("internal"), "second_diameter": 0.1},
        "friction": {"friction": 0.0, "torque": 1.0},
        "diameter": {"first_diameter": 0.0},
    }.items():
        with pytest.raises(DynamicsError) as caught:
            wheels(**({"first_diameter": 0.1, "second_diameter": 0.3} | more))  # type: ignore[arg-type]
        assert caught.value.code == code


def test_a_worm_that_fills_a_centre_distance() -> None:
    found = worm(threads=2, teeth=39, size=AxialModule(4e-3), centre_distance=0.1)
    assert found.worm_diameter == pytest.approx(44e-3, rel=1e-14)
    assert (found.profile_shift, found.centre_distance) == (0.0, pytest.approx(0.1, rel=1e-15))
    shifted = worm(threads=2, teeth=39, size=AxialModule(4e-3), centre_distance=0.1, profile_shift=0.5)
    assert shifted.worm_diameter == pytest.approx(40e-3, rel=1e-14)
    assert shifted.centre_distance == pytest.approx(0.1, rel=1e-15)
    with pytest.raises(InadmissibleError, match="does not fit"):
        worm(threads=2, teeth=50, size=AxialModule(4e-3), centre_distance=0.1)
    with pytest.raises(MissingError, match="diameter is not given"):
        worm(threads=2, teeth=39, size=WormNormalModule(4e-3), centre_distance=0.1)
