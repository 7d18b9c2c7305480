"""Particle impacts: invariants of frame, unit, exchange and scale; limits from both sides; refusals."""

import math
from itertools import pairwise
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.impact.conventions import (
    Axes,
    ByMass,
    BySpeed,
    ByVelocity,
    ByWeight,
    Energetic,
    Fixed,
    PdofZero,
    Restituted,
    delta_v,
    direction_of,
)
from dynamics_cli.impact.held.seize import AnyBody, seize
from dynamics_cli.impact.held.step import Factor, step
from dynamics_cli.impact.particles.central import Collinear, Struck, central
from dynamics_cli.impact.particles.chain import Body, ChainLaw, chain
from dynamics_cli.impact.particles.drop import FlightTimes, ReboundHeight, RestTime, drop
from dynamics_cli.impact.particles.hunt_crossley import HuntCrossley
from dynamics_cli.impact.particles.oblique import Met, Moving, Normal, Offset, oblique
from dynamics_cli.impact.particles.pendulum import Block, Hinged, Rise, Swing, pendulum
from dynamics_cli.impact.particles.springs import Hertz, Spring
from dynamics_cli.numerics.tracked import Tracked

MASS = st.floats(0.01, 1e4)


def no_dust(x: float) -> float:
    """Numbers below a trillionth are beyond any instrument, and some below 1e-40 are refused."""
    return x if abs(x) > 1e-12 else 0.0


SPEED = st.floats(-50.0, 50.0).map(no_dust)
RATIO = st.floats(0.0, 1.0).map(no_dust)
ANGLE = st.floats(-3.0, 3.0).map(no_dust)


def hit(m1: float, v1: float, m2: float, v2: float, e: float, **more: Any) -> Any:
    return central(first=Collinear(ByMass(m1), v1), second=Struck(ByMass(m2), v2), contact=Restituted(e), **more)


@given(MASS, MASS, SPEED, st.floats(0.1, 50.0), RATIO)
def test_a_central_impact_keeps_momentum_and_restitution(m1: float, m2: float, v: float, u: float, e: float) -> None:
    found = hit(m1, v + u, m2, v, e)
    assert all(check.passed for check in found.checks)
    assert {check.name for check in found.checks} >= {"momentum", "restitution", "energy", "no energy is gained"}
    assert found.energy_lost >= 0.0


@given(MASS, MASS, SPEED, st.floats(0.1, 50.0), RATIO, SPEED)
def test_the_frame_does_not_matter(m1: float, m2: float, v: float, u: float, e: float, frame: float) -> None:
    here = hit(m1, v + u, m2, v, e, closing_speed=u)
    there = hit(m1, v + u + frame, m2, v + frame, e, closing_speed=u)
    assert there.impulse == here.impulse
    assert there.energy_lost == here.energy_lost
    assert there.first.velocity - here.first.velocity == pytest.approx(frame, abs=1e-11)


@given(MASS, MASS, SPEED, st.floats(0.1, 50.0), RATIO)
def test_exchanged_bodies_seen_from_the_other_side(m1: float, m2: float, v: float, u: float, e: float) -> None:
    here = hit(m1, v + u, m2, v, e)
    there = hit(m2, -v, m1, -(v + u), e)
    assert there.impulse == here.impulse
    assert (there.first.velocity, there.second.velocity) == (-here.second.velocity, -here.first.velocity)


@pytest.mark.parametrize("e", [0.0, 1e-39, 0.5, 1.0 - 2.0**-53, 1.0])
def test_restitution_from_end_to_end(e: float) -> None:
    found = hit(3.0, 2.0, 5.0, -1.0, e)
    assert found.separation_speed == e * 3.0
    assert found.share_lost == (1.0 - e) * (1.0 + e)


def test_a_wall_is_the_limit_of_a_heavy_body() -> None:
    wall = central(first=Collinear(ByMass(2.0), 3.0), second=Struck(Fixed(True), -1.0), contact=Restituted(0.4))
    heavy = hit(2.0, 3.0, 1e18, -1.0, 0.4)
    assert wall.first.velocity == pytest.approx(heavy.first.velocity, rel=1e-15)
    assert wall.second.velocity == -1.0
    assert wall.energy_lost == pytest.approx(heavy.energy_lost, rel=1e-15)
    assert wall.second.mass is None


def test_weight_is_mass_times_gravity() -> None:
    light = central(
        first=Collinear(ByWeight(20.0), 3.0), second=Struck(ByWeight(30.0)), contact=Restituted(0.4), gravity=10.0
    )
    assert light.impulse == hit(2.0, 3.0, 3.0, 0.0, 0.4).impulse


@pytest.mark.parametrize(
    ("v1", "v2"), [(0.0, 0.0), (1.0, 1.0), (1.0, 2.0), (-10.0, 0.0), (1.0, math.nextafter(1.0, 2.0))]
)
def test_bodies_that_do_not_approach_do_not_collide(v1: float, v2: float) -> None:
    with pytest.raises(InadmissibleError, match="no impact") as refused:
        hit(1.0, v1, 1.0, v2, 0.5)
    assert refused.value.code == "no-impact"


def test_the_least_approach_is_an_impact() -> None:
    assert hit(1.0, math.nextafter(1.0, 2.0), 1.0, 1.0, 0.5).impulse > 0.0


def test_only_an_energetic_contact_gives_energy() -> None:
    found = central(first=Collinear(ByMass(1.0), 1.0), second=Struck(ByMass(1.0)), contact=Energetic(2.0))
    assert found.energy_lost < 0.0
    assert [one.code for one in found.advice] == ["energetic-contact"]
    assert "no energy is gained" not in {check.name for check in found.checks}


def test_a_closing_speed_that_contradicts_is_refused() -> None:
    with pytest.raises(InadmissibleError, match=r"differ by 2 m/s, but the closing speed is 3"):
        hit(1.0, 3.0, 1.0, 1.0, 0.5, closing_speed=3.0)


@given(MASS, MASS, st.floats(0.1, 50.0), RATIO, st.floats(1e2, 1e9))
def test_a_spring_contact_lasts_as_its_own_oscillation(m1: float, m2: float, u: float, e: float, k: float) -> None:
    found = hit(m1, u, m2, 0.0, e, force=Spring(k))
    reduced = m1 * m2 / (m1 + m2)
    assert found.push.duration == pytest.approx((1.0 + e) * 0.5 * math.pi * math.sqrt(reduced / k), rel=1e-13)
    assert found.push.peak_force**2 == pytest.approx(k * reduced * u * u, rel=1e-13)
    assert found.push.mean_force * found.push.duration == pytest.approx(found.impulse, rel=1e-13)


@given(MASS, st.floats(0.01, 50.0), st.floats(1e-3, 1.0), st.floats(1e6, 1e12))
def test_hertz_by_marching_the_contact(mass: float, u: float, radius: float, modulus: float) -> None:
    push = central(
        first=Collinear(ByMass(mass), u), second=Struck(Fixed(True)), contact=Restituted(1.0),
        force=Hertz(radius, modulus),
    ).push  # fmt: skip
    assert push is not None
    # x'' = −x^1.5·5/4 in units of depth and depth/u, by symplectic steps to the turning point
    x, v, t, dt = 0.0, 1.0, 0.0, 1e-3
    while v > 0.0:
        half = v - 0.5 * dt * 1.25 * x**1.5
        x += dt * half
        v = half - 0.5 * dt * 1.25 * x**1.5
        t += dt
    t += v / (1.25 * x**1.5)
    assert push.duration == pytest.approx(2.0 * t * push.compression / u, rel=1e-5)
    assert x == pytest.approx(1.0, abs=1e-5)
    assert push.peak_force == pytest.approx(4.0 / 3.0 * modulus * math.sqrt(radius) * push.compression**1.5, rel=1e-12)


def spheres(turn: float, axes: str, e: float = 0.6, zero: str = "heading") -> Any:
    """A crash turned as a whole, its angles written in some axes."""
    ways = {"mathematical": 1.0, "iso": 1.0, "sae": -1.0, "compass": -1.0}
    sense, start = ways[axes], 0.5 * math.pi if axes == "compass" else 0.0
    first, second, line = (start + sense * (turn + angle) for angle in (0.2, 2.5, 0.5))
    return oblique(
        first=Moving(ByMass(2.0), BySpeed(9.0, first)), second=Met(ByMass(3.0), BySpeed(4.0, second)),
        line=Normal(line), contact=Restituted(e), axes=Axes(axes), pdof_zero=PdofZero(zero),
    )  # fmt: skip


@given(ANGLE, st.sampled_from(Axes.names), st.sampled_from(["heading", "travel"]))
def test_turning_the_scene_or_its_axes_changes_nothing_physical(turn: float, axes: str, zero: str) -> None:
    base, turned = spheres(0.0, "mathematical"), spheres(turn, axes, zero=zero)
    for name in ("impulse", "closing_speed", "sliding_speed", "energy_lost"):
        assert getattr(turned, name) == pytest.approx(getattr(base, name), rel=1e-13)
    for one, other in ((turned.first, base.first), (turned.second, base.second)):
        assert one.speed == pytest.approx(other.speed, rel=1e-13)
        assert one.delta_v.pdof == pytest.approx(other.delta_v.pdof, abs=1e-13)
        assert one.delta_v.clock == other.delta_v.clock
        left = -1.0 if axes == "sae" else 1.0
        assert one.delta_v.lateral == pytest.approx(left * other.delta_v.lateral, rel=1e-12)


@pytest.mark.parametrize(
    ("side", "angle", "hour"),
    [("front", 0.0, 12), ("right", 90.0, 3), ("rear", 180.0, 6), ("left", -90.0, 9)],
)
@pytest.mark.parametrize("axes", Axes.names)
def test_pdof_counts_clockwise_from_the_nose(axes: str, side: str, angle: float, hour: int) -> None:
    nose = direction_of(0.7, Axes(axes))
    right = (-nose[1], nose[0]) if axes == "sae" else (nose[1], -nose[0])
    towards = {"front": nose, "right": right, "rear": (-nose[0], -nose[1]), "left": (-right[0], -right[1])}[side]
    found = delta_v((-towards[0], -towards[1]), 2.0, nose, axes=Axes(axes))
    assert math.degrees(found.pdof) == pytest.approx(angle, abs=1e-13) or angle == 180.0 == abs(
        math.degrees(found.pdof)
    )
    assert found.clock == hour


@pytest.mark.parametrize(("pdof", "hour"), [(14.9, 12), (15.1, 1), (-14.9, 12), (-15.1, 11), (164.9, 5), (-165.1, 6)])
def test_hours_change_halfway(pdof: float, hour: int) -> None:
    angle = math.radians(pdof)
    # clockwise from the nose along x, the force comes from (cos, −sin)
    found = delta_v((-math.cos(angle), math.sin(angle)), 1.0, (1.0, 0.0))
    assert found.clock == hour


def test_an_offset_of_nothing_is_central() -> None:
    one, two = Moving(ByMass(2.0), ByVelocity((3.0, 0.0))), Met(ByMass(1.0))
    straight = oblique(first=one, second=two, line=Offset(0.0, 0.1, 0.2), contact=Restituted(0.5))
    assert straight.impulse == hit(2.0, 3.0, 1.0, 0.0, 0.5).impulse
    left = oblique(first=one, second=two, line=Offset(0.1, 0.1, 0.2), contact=Restituted(0.5))
    right = oblique(first=one, second=two, line=Offset(-0.1, 0.1, 0.2), contact=Restituted(0.5))
    assert left.second.velocity[1] == -right.second.velocity[1] > 0.0


@given(st.floats(0.05, 0.99), st.floats(0.1, 10.0))
def test_restitution_by_height_by_flights_and_by_rest_agree(e: float, height: float) -> None:
    fall = math.sqrt(2.0 * height / 9.80665)
    ways = (
        drop(evidence=ReboundHeight(e * e * height), height=height),
        drop(evidence=ReboundHeight(e**6 * height, 3), height=height),
        drop(evidence=FlightTimes(2.0 * e * fall, 2.0 * e * e * fall)),
        drop(evidence=RestTime(fall * (1.0 + e) / (1.0 - e)), height=height),
    )
    for found in ways:
        assert found.restitution == pytest.approx(e, rel=1e-11)
        assert found.drop_height == pytest.approx(height, rel=1e-11)
        assert all(check.passed for check in found.checks)


@given(st.floats(0.001, 0.5), st.floats(0.1, 10.0), st.floats(0.01, 1.5), st.floats(0.2, 3.0))
def test_a_point_on_a_massless_rod_is_the_simple_pendulum(m: float, big: float, swing: float, length: float) -> None:
    simple = pendulum(shot_mass=m, block=Block(ByMass(big)), swing=Swing(swing, length))
    rod = Hinged(swing, big * length * length, length, length)
    hinged = pendulum(shot_mass=m, block=Block(ByMass(big)), swing=rod)
    assert hinged.speed == pytest.approx(simple.speed, rel=1e-13)
    assert hinged.hinge_impulse == pytest.approx(0.0, abs=1e-12 * hinged.impulse)


def test_an_inertia_about_the_mass_centre_is_refused() -> None:
    with pytest.raises(InadmissibleError, match="about the hinge"):
        pendulum(shot_mass=0.01, block=Block(ByMass(3.0)), swing=Hinged(0.3, 0.1, 0.6, 0.6))
    with pytest.raises(InadmissibleError, match="rise of the block must be above zero"):
        pendulum(shot_mass=0.01, block=Block(ByMass(3.0)), swing=Rise(0.0))


@pytest.mark.parametrize("factor", [0.4, 0.5, 1.0])
def test_the_least_speed_just_gets_over_and_a_little_less_does_not(factor: float) -> None:
    least = step(radius=0.3, height=0.1, wheel=Factor(factor)).least_speed
    below = step(radius=0.3, height=0.1, wheel=Factor(factor), speed=least * (1.0 - 1e-9))
    above = step(radius=0.3, height=0.1, wheel=Factor(factor), speed=least * (1.0 + 1e-9))
    assert (below.gets_over, above.gets_over) == (False, True)
    assert below.greatest_rise == pytest.approx(0.1, rel=1e-8)
    assert above.speed_on_step == pytest.approx(0.0, abs=1e-3)
    assert [one.code for one in step(radius=0.3, height=0.1, speed=3.0).advice] == ["jumps"]
    assert [one.code for one in step(radius=0.3, height=0.25).advice] == ["leaves-edge"]


UNIT = ((0.4, 0.0, 0.0), (0.0, 0.4, 0.0), (0.0, 0.0, 0.4))


@given(st.tuples(ANGLE, ANGLE, ANGLE), st.tuples(ANGLE, ANGLE, ANGLE), st.tuples(ANGLE, ANGLE, ANGLE))
def test_a_seized_body_keeps_its_angular_momentum_and_loses_energy(spin: Any, speed: Any, point: Any) -> None:
    if sum(abs(x) for x in (*spin, *speed)) < 1e-3:
        return
    found = seize(body=AnyBody(2.0, UNIT, spin, point, speed))
    assert all(check.passed for check in found.checks)
    assert 0.0 <= found.energy_ratio <= 1.0 + 1e-12
    # held once more at the same point it goes on as it is
    again = (
        seize(body=AnyBody(2.0, UNIT, found.angular_velocity, point, found.centre_velocity))
        if (found.energy_after > 1e-6)
        else None
    )
    if again is not None:
        assert again.energy_ratio == pytest.approx(1.0, rel=1e-9)


def test_a_thin_rod_held_on_its_own_line_is_refused() -> None:
    rod = ((0.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    with pytest.raises(InadmissibleError, match="no inertia"):
        seize(body=AnyBody(1.0, rod, (1.0, 1.0, 0.0), (1.0, 0.0, 0.0)))
    with pytest.raises(InadmissibleError, match="belongs to no body"):
        seize(body=AnyBody(1.0, ((5.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)), (1.0, 0.0, 0.0), (1.0, 0.0, 0.0)))


def row(*bodies: Body, law: str, e: float = 1.0) -> list[float]:
    return [one.velocity for one in chain(bodies=bodies, restitution=e, law=ChainLaw(law)).bodies]


def test_newtons_cradle_by_both_laws() -> None:
    balls = Body(1.0, 1.0), Body(1.0), Body(1.0)
    assert row(*balls, law="sequential") == [0.0, 0.0, 1.0]
    assert row(*balls, law="simultaneous") == pytest.approx([-1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0], rel=1e-15)
    assert [one.code for one in chain(bodies=balls, restitution=1.0).advice] == ["not-unique"]
    two = Body(1.0, 1.0), Body(1.0, 1.0), Body(1.0), Body(1.0)
    assert row(*two, law="sequential") == [0.0, 0.0, 1.0, 1.0]


# many collisions take long on a busy machine; how long is not what is tested
@settings(deadline=None)
@given(st.lists(st.tuples(MASS, SPEED), min_size=2, max_size=6), RATIO)
def test_chains_keep_momentum_lose_energy_and_end_apart(parts: list[tuple[float, float]], e: float) -> None:
    bodies = tuple(Body(*part) for part in parts)
    if all(one.velocity <= other.velocity for one, other in pairwise(bodies)):
        with pytest.raises(InadmissibleError, match="no impact"):
            chain(bodies=bodies, restitution=e)
        return
    found = chain(bodies=bodies, restitution=e)
    assert all(check.passed for check in found.checks), found.checks


def test_two_bodies_need_no_law() -> None:
    bodies = Body(2.0, 3.0), Body(1.0)
    expected = hit(2.0, 3.0, 1.0, 0.0, 0.5)
    for law in ("sequential", "simultaneous"):
        found = row(*bodies, law=law, e=0.5)
        assert found == pytest.approx([expected.first.velocity, expected.second.velocity], rel=1e-15)
    assert chain(bodies=bodies, restitution=0.5).advice == ()


@pytest.mark.parametrize("e", [0.3, 0.5, 0.8, 0.97])
def test_hunt_crossley_by_marching_the_contact(e: float) -> None:
    from scipy.integrate import solve_ivp

    from dynamics_cli.impact.particles.hunt_crossley import loss, shape

    x = loss(e)

    def slope(_: float, state: Any) -> list[float]:
        return [state[1], -(max(state[0], 0.0) ** 1.5) * (1.0 + x * state[1])]

    def released(t: float, state: Any) -> float:
        return float(state[0]) if t > 0.1 else 1.0

    released.terminal = True  # type: ignore[attr-defined]
    way = solve_ivp(
        slope, (0.0, 50.0), [0.0, 1.0], method="DOP853", rtol=1e-12, atol=1e-14, events=released, max_step=0.02
    )
    forces = [max(d, 0.0) ** 1.5 * (1.0 + x * v) for d, v in way.y.T]
    time, peak, depth = shape(e)
    assert way.y[1][-1] == pytest.approx(-e, rel=1e-9)
    assert time == pytest.approx(way.t[-1], rel=1e-9)
    assert peak == pytest.approx(max(forces), rel=1e-3)
    assert peak >= max(forces) * (1.0 - 1e-9)
    assert depth == pytest.approx(max(way.y[0]), rel=1e-3)


def test_hunt_crossley_without_loss_is_hertz_and_knows_its_slope() -> None:
    ball = Collinear(ByMass(0.2), 3.0)

    def push(force: Any, e: Any) -> Any:
        return central(first=ball, second=Struck(Fixed(True)), contact=Restituted(e), force=force).push

    loss, plain = HuntCrossley(0.02, 2e9, True), Hertz(0.02, 2e9)
    for name in ("duration", "peak_force", "compression"):
        assert getattr(push(loss, 1.0), name) == pytest.approx(getattr(push(plain, 1.0), name), rel=1e-13)
        own = getattr(push(loss, Tracked(0.6, 0.0, (1.0,))), name)
        ends = [getattr(push(loss, 0.6 + side), name) for side in (-1e-5, 1e-5)]
        assert own.value == getattr(push(loss, 0.6), name)
        assert own.slopes[0] == pytest.approx((ends[1] - ends[0]) / 2e-5, rel=1e-5)
    for refused in (0.0, 0.0999):
        with pytest.raises(InadmissibleError, match=r"restitutions from 0\.1"):
            push(loss, refused)


def test_sizes_no_calculation_can_carry_are_refused_by_name() -> None:
    with pytest.raises(InadmissibleError, match=r"swing\.impact_distance is 1e-150"):
        pendulum(shot_mass=0.01, block=Block(ByMass(3.0)), swing=Hinged(0.3, 1.1, 0.5, 1e-150))
    with pytest.raises(InadmissibleError, match=r"first\.mass is 1e\+60"):
        hit(1e60, 1.0, 1.0, 0.0, 0.5)
    # an angle may be as small as it likes
    tiny = oblique(
        first=Moving(ByMass(1.0), BySpeed(1.0, 1e-300)),
        second=Met(ByMass(1.0)),
        line=Normal(0.0),
        contact=Restituted(0.5),
    )
    assert tiny.impulse == 0.75
