"""Impacts on a line as textbooks print them: central impact, bounces, the ballistic pendulum, a chain of bodies."""

from math import cos, sqrt

from dynamics_cli.accuracy.alternatives.impact.plane import mass_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def _speeds(first: "Any", second: "Any", closing: "float | None") -> "tuple[float, float]":
    """Velocities before; the one that is missing from the closing speed."""
    v1, v2 = first.velocity, second.velocity
    if closing is not None and v2 is None:
        return v1 or 0.0, (v1 or 0.0) - closing
    if closing is not None and v1 is None:
        return v2 + closing, v2
    return v1 or 0.0, v2 or 0.0


def _central(
    masses: "tuple[float, float | None]", before: "tuple[float, float]", after: "tuple[float, float]"
) -> "dict[str, float]":
    """ΔV, impulse and energies as differences of what was before and after."""
    (m1, m2), (v1, v2), (w1, w2) = masses, before, after
    gain = 0.5 * m1 * w1 * w1 - 0.5 * m1 * v1 * v1
    results = {
        "first.velocity": w1, "second.velocity": w2, "first.delta_v": w1 - v1, "second.delta_v": w2 - v2,
        "first.energy_change": gain, "first.mass": m1, "impulse": m1 * v1 - m1 * w1,
        "closing_speed": v1 - v2, "separation_speed": w2 - w1,
    }  # fmt: skip
    if m2 is None:
        return results | {"reduced_mass": m1, "common_velocity": v2, "compression_impulse": m1 * (v1 - v2)}
    common, reduced = (m1 * v1 + m2 * v2) / (m1 + m2), m1 * m2 / (m1 + m2)
    more = 0.5 * m2 * w2 * w2 - 0.5 * m2 * v2 * v2
    lost = -gain - more
    return results | {
        "second.energy_change": more, "second.mass": m2, "energy_lost": lost,
        "share_lost": lost / (0.5 * reduced * (v1 - v2) * (v1 - v2)), "reduced_mass": reduced,
        "common_velocity": common, "compression_impulse": m1 * v1 - m1 * common,
    }  # fmt: skip


def central(
    *, first: "Any", second: "Any", contact: "Any", gravity: float, closing_speed: "float | None" = None,
    force: "Any" = None,
) -> "dict[str, float]":  # fmt: skip
    """V₁' = (m₁v₁ + m₂v₂ − m₂e(v₁ − v₂))/(m₁ + m₂), likewise v₂'; ΔV, impulse and loss as differences."""
    m1, m2, e = mass_of(first.bulk, gravity), mass_of(second.bulk, gravity), contact.restitution
    assert m1 is not None
    v1, v2 = _speeds(first, second, closing_speed)
    if m2 is None:
        return _central((m1, m2), (v1, v2), (v2 - e * (v1 - v2), v2))
    w1 = (m1 * v1 + m2 * v2 - m2 * e * (v1 - v2)) / (m1 + m2)
    w2 = (m1 * v1 + m2 * v2 + m1 * e * (v1 - v2)) / (m1 + m2)
    return _central((m1, m2), (v1, v2), (w1, w2))


def _restitution(evidence: "Any", height: "float | None", gravity: float) -> "tuple[float, float]":
    """E = (hₙ/h)^(1/2n), t₂/t₁ or (T − t₀)/(T + t₀), and the height; of flight times h = g·(t₁/e)²/8."""
    if hasattr(evidence, "flight_time"):
        e = evidence.next_flight_time / evidence.flight_time
        return e, gravity * (evidence.flight_time / e) ** 2 / 8.0 if height is None else height
    assert height is not None
    if hasattr(evidence, "rebound_height"):
        return (evidence.rebound_height / height) ** (1.0 / (2 * evidence.after_bounces)), height
    if hasattr(evidence, "rest_time"):
        fall = sqrt(2.0 * height / gravity)
        return (evidence.rest_time - fall) / (evidence.rest_time + fall), height
    return evidence.restitution, height


def drop(
    *, evidence: "Any", height: "float | None" = None, bounces: int, gravity: float, mass: "float | None" = None
) -> "dict[str, float]":
    """Hₙ = h·e²ⁿ, T = t₀·(1 + e)/(1 − e), S = h·(1 + e²)/(1 − e²) as printed: digits go as e comes near one."""
    e, h = _restitution(evidence, height, gravity)
    fall, speed = sqrt(2.0 * h / gravity), sqrt(2.0 * gravity * h)
    results = {
        "restitution": e, "drop_height": h, "impact_speed": speed, "fall_time": fall, "share_lost": 1.0 - e**2,
    }  # fmt: skip
    if e < 1.0:
        results |= {"time_to_rest": fall * (1.0 + e) / (1.0 - e), "way_to_rest": h * (1.0 + e**2) / (1.0 - e**2)}
    if mass is not None:
        results["energy_lost"] = mass * gravity * h - mass * gravity * h * e**2
    for n in range(bounces):
        results |= {
            f"bounces[{n}].number": n + 1.0,
            # t₀·(1 + 2e + … + 2eⁿ)
            f"bounces[{n}].time": fall * (1.0 + 2.0 * sum(e**k for k in range(1, n + 1))),
            f"bounces[{n}].impact_speed": speed * e**n,
            f"bounces[{n}].rebound_speed": speed * e ** (n + 1),
            f"bounces[{n}].height": h * e ** (2 * n + 2),
            f"bounces[{n}].flight_time": 2.0 * speed * e ** (n + 1) / gravity,
        }
    return results


def _rise(swing: "Any") -> float:
    """H = L·(1 − cos θ), or L − √(L² − x²): digits go as the swing becomes small."""
    if hasattr(swing, "rise") and not hasattr(swing, "length"):
        return float(swing.rise)
    if hasattr(swing, "travel"):
        return float(swing.length - sqrt(swing.length**2 - swing.travel**2))
    return float(swing.length * (1.0 - cos(swing.swing)))


def _shot(m: float, effective: float, v: float, w: float, u: float, rise: float) -> "dict[str, float]":
    """Impulse and loss as differences of momenta and energies: v before, w of the shot after, u of what was struck."""
    before = 0.5 * m * v * v
    lost = before - 0.5 * m * w * w - 0.5 * effective * u * u
    return {
        "speed": v, "shot_speed_after": w, "pendulum_speed": u, "rise": rise, "effective_mass": effective,
        "impulse": m * v - m * w, "energy_before": before, "energy_lost": lost, "share_lost": lost / before,
    }  # fmt: skip


def pendulum(*, shot_mass: float, block: "Any", swing: "Any", restitution: float, gravity: float) -> "dict[str, float]":
    """V = (m + M)/((1 + e)·m)·√(2·g·L·(1 − cos θ)); hinged: ½·I·ω² = (M·d + m·b)·g·(1 − cos θ)."""
    mass = mass_of(block.bulk, gravity)
    assert mass is not None
    if not hasattr(swing, "inertia"):
        rise = _rise(swing)
        u = sqrt(2.0 * gravity * rise)
        v = (shot_mass + mass) / ((1.0 + restitution) * shot_mass) * u
        return _shot(shot_mass, mass, v, u - restitution * v, u, rise)
    arm, along = swing.impact_distance, shot_mass if restitution == 0.0 else 0.0
    lift, inertia = mass * swing.centre_distance + along * arm, swing.inertia + along * arm**2
    spin = sqrt(2.0 * lift * gravity * (1.0 - cos(swing.swing)) / inertia)
    effective, u = swing.inertia / arm**2, arm * spin
    v = (shot_mass + effective) / ((1.0 + restitution) * shot_mass) * u
    rise = lift / (mass + along) * (1.0 - cos(swing.swing))
    results = _shot(shot_mass, effective, v, u - restitution * v, u, rise)
    hinge = results["impulse"] - mass * swing.centre_distance * spin
    return results | {"angular_velocity": spin, "hinge_impulse": hinge}
