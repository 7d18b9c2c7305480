"""What holds of every vibration: superposition, balance of energy and power, reciprocity, units of mass and time."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics_cli.vibration.shafts.campbell import TiltingDisk
from dynamics_cli.vibration.shafts.line import BySpeeds, Gear, Rate, Rotor, Shaft
from dynamics_cli.vibration.shafts.shaft import shaft
from dynamics_cli.vibration.shocks.pulses import Oscillators, Piece
from dynamics_cli.vibration.single.base import Shaking, base
from dynamics_cli.vibration.single.forced import forced
from dynamics_cli.vibration.single.free import free
from dynamics_cli.vibration.single.isolator import Passing, isolator
from dynamics_cli.vibration.single.oscillator import AtFrequency, AtRatio, DampingShare, Natural, Spring
from dynamics_cli.vibration.systems.inputs import Line
from dynamics_cli.vibration.systems.modes import modes
from dynamics_cli.vibration.systems.response import response

few = settings(max_examples=25, deadline=None)
sizes = st.floats(0.2, 5.0)
ratios = st.floats(0.3, 3.0)
zetas = st.floats(0.01, 2.5)


@few
@given(zetas, st.floats(-1.0, 1.0), st.floats(-1.0, 1.0), st.floats(0.0, 8.0))
def test_free_motions_add(zeta: float, x: float, v: float, t: float) -> None:
    def at(x: float, v: float) -> tuple[float, float]:
        made = free(spring=Natural(0.2), damping=DampingShare(zeta), displacement=x, start_velocity=v, time=t)
        assert made.position is not None
        assert made.velocity is not None
        return made.position, made.velocity

    both, one, other = at(x, v), at(x, 0.0), at(0.0, v)
    assert both == pytest.approx((one[0] + other[0], one[1] + other[1]), abs=1e-13)


@few
@given(zetas, st.floats(-1.0, 1.0), st.floats(-1.0, 1.0), st.floats(0.0, 4.0), st.floats(0.0, 4.0))
def test_free_motion_goes_on_from_where_it_is(zeta: float, x: float, v: float, t: float, more: float) -> None:
    def at(x: float, v: float, t: float) -> tuple[float, float]:
        made = free(spring=Natural(0.2), damping=DampingShare(zeta), displacement=x, start_velocity=v, time=t)
        assert made.position is not None
        assert made.velocity is not None
        return made.position, made.velocity

    assert at(*at(x, v, t), more) == pytest.approx(at(x, v, t + more), abs=1e-12)


@few
@given(sizes, sizes, st.floats(0.01, 1.0), ratios)
def test_power_of_the_force_is_what_the_damper_takes(m: float, k: float, zeta: float, r: float) -> None:
    made = forced(mass=m, spring=Spring(k), damping=DampingShare(zeta), force=2.0, excitation=AtRatio(r))
    omega = r * math.sqrt(k / m)
    given_in = 0.5 * 2.0 * made.amplitude * omega * math.sin(made.phase)
    lost = 0.5 * 2.0 * zeta * math.sqrt(k * m) * (made.amplitude * omega) ** 2
    assert given_in == pytest.approx(lost, rel=1e-12)


@few
@given(st.floats(0.01, 0.9), st.floats(0.0, 0.5))
def test_an_isolator_lets_pass_what_was_wished(passed: float, zeta: float) -> None:
    made = isolator(excitation=AtFrequency(25.0), wish=Passing(passed), damping_ratio=zeta)
    again = base(
        spring=Natural(made.natural_frequency), damping=DampingShare(zeta), motion=Shaking(1e-3),
        excitation=AtFrequency(25.0),
    )  # fmt: skip
    assert again.transmissibility == pytest.approx(passed, rel=1e-12)


@few
@given(st.lists(sizes, min_size=2, max_size=6), st.data())
def test_modes_carry_trace_and_mass(masses: list[float], data: st.DataObject) -> None:
    n = len(masses)
    stiffnesses = data.draw(st.lists(sizes, min_size=n, max_size=n))
    made = modes(system=Line(tuple(masses), tuple(stiffnesses)))
    squares = sum((row.angular_frequency or 0.0) ** 2 for row in made.modes)
    diagonal = [stiffnesses[i] + (stiffnesses[i + 1] if i + 1 < n else 0.0) for i in range(n)]
    assert squares == pytest.approx(sum(k / m for k, m in zip(diagonal, masses, strict=True)), rel=1e-13)
    assert all(check.passed for check in made.checks)
    assert made.numerics is not None
    assert made.numerics.bounds


def test_modes_that_hardly_move_the_whole_keep_their_digits() -> None:
    stiff = modes(system=Line((1.0, 2.0, 3.0), (1.0, 1e14, 1000.0))).modes
    assert stiff[2].effective_share == pytest.approx(4.9382716049163e-30, rel=1e-13)  # by mpmath, 50 digits
    assert stiff[1].effective_share == pytest.approx(6.24999882819461e-08, rel=1e-8)
    free = modes(system=Line((1.0, 2.0, 3.0), (1.0e4, 2.0e4))).modes
    assert [one.effective_share for one in free] == [pytest.approx(1.0), 0.0, 0.0]


@few
@given(st.lists(sizes, min_size=3, max_size=5), st.data(), st.floats(0.1, 0.6))
def test_response_is_reciprocal(masses: list[float], data: st.DataObject, hertz: float) -> None:
    n = len(masses)
    stiffnesses, dampings = (tuple(data.draw(st.lists(sizes, min_size=n, max_size=n))) for _ in range(2))
    system = Line(tuple(masses), stiffnesses, dampings)
    there, back = (
        response(system=system, force_at=a, read_at=b, excitation=AtFrequency(hertz))
        for a, b in (("1", "3"), ("3", "1"))
    )  # fmt: skip
    assert there.amplitude == pytest.approx(back.amplitude, rel=1e-9)
    assert math.cos((there.lag or 0.0) - (back.lag or 0.0)) == pytest.approx(1.0)


@few
@given(st.floats(0.2, 5.0), st.floats(0.5, 4.0))
def test_a_geared_line_is_the_same_from_either_shaft(inertia: float, turns: float) -> None:
    rotors = tuple(Rotor(name, size) for name, size in (("a", 1.0), ("b", 0.2), ("c", 0.3), ("d", inertia)))
    shafts = (Shaft("a", "b", Rate(50.0)), Shaft("c", "d", Rate(80.0)))
    gears = (Gear("b", "c", BySpeeds(turns)),)
    one, other = (shaft(rotors=rotors, shafts=shafts, gears=gears, reference=name) for name in ("a", "d"))
    assert [row.frequency for row in one.modes] == pytest.approx([row.frequency for row in other.modes], rel=1e-14)
    assert one.rigid_modes == 1


@few
@given(st.floats(0.0, 2.0), st.floats(0.01, 3.0), st.floats(-1.0, 1.0), st.floats(-1.0, 1.0), st.floats(0.01, 2.0))
def test_a_piece_of_load_may_be_cut_anywhere(zeta: float, omega: float, a: float, b: float, t: float) -> None:
    """Constant, ramp and wave, at small and large ω·t, on both sides of the switch between series and closed form."""
    of = Oscillators(np.array([omega, 1e-4 * omega, 30.0 * omega]), zeta)
    rest = (np.zeros(3), np.zeros(3))
    whole = of.after(*rest, Piece(0.0, t, a=a, b=b, c=0.3 - 0.2j, p=2.0), t)
    half = of.after(*rest, Piece(0.0, t, a=a, b=b, c=0.3 - 0.2j, p=2.0), 0.4 * t)
    turned = (0.3 - 0.2j) * np.exp(0.8j * t)
    joined = of.after(*half, Piece(0.0, t, a=a + 0.4 * b * t, b=b, c=turned, p=2.0), 0.6 * t)
    assert np.allclose(whole[0], joined[0], rtol=1e-10, atol=1e-12)
    assert np.allclose(whole[1], joined[1], rtol=1e-10, atol=1e-12)


@few
@given(sizes, sizes, sizes, st.floats(-0.95, 0.95), sizes, sizes, st.floats(0.01, 30.0))
def test_whirls_are_the_eigenvalues_of_the_gyroscopic_system(
    m: float, direct: float, tilting: float, coupling: float, polar: float, diametral: float, speed: float
) -> None:
    cross = coupling * math.sqrt(direct * tilting)
    disk = TiltingDisk(m, (direct, tilting, direct * tilting - cross * cross), polar, diametral)
    mass, stiffness = np.diag([m, diametral]), np.array([[direct, cross], [cross, tilting]])
    gyroscopic = np.diag([0.0, -1j * polar * speed])
    below = -np.linalg.solve(mass, np.hstack([stiffness, gyroscopic]))
    rates = np.linalg.eigvals(np.vstack([np.eye(2, 4, 2), below])).imag
    ahead, back = sorted(rates[rates > 0.0]), sorted(-rates[rates < 0.0])
    assert disk.whirls(speed) == pytest.approx((back[0], ahead[0], back[1], ahead[1]), rel=1e-9)


@few
@given(sizes, sizes, sizes, st.floats(-0.95, 0.95), sizes, sizes, st.floats(0.3, 4.0))
def test_a_critical_speed_is_where_the_order_meets_the_whirl(
    m: float, direct: float, tilting: float, coupling: float, polar: float, diametral: float, order: float
) -> None:
    disk = TiltingDisk(m, (direct, tilting, (1.0 - coupling * coupling) * direct * tilting), polar, diametral)
    rates = {("backward", 1): 0, ("forward", 1): 1, ("backward", 2): 2, ("forward", 2): 3}
    crossings = disk.criticals(order)
    assert len(crossings) == 3 + (diametral * order > polar)
    for speed, whirl, mode in crossings:
        assert disk.whirls(speed)[rates[whirl, mode]] == pytest.approx(order * speed, rel=1e-9)
