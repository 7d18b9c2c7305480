"""Central impacts, bounces, pendulums and bodies held as textbooks print them: energies as differences."""

from math import acos, cos, sin, sqrt

from dynamics_cli.accuracy.alternatives.impact.plane import mass_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def central(
    *, first: "Any", second: "Any", contact: "Any", gravity: float, closing_speed: "float | None" = None, **_: "Any"
) -> "dict[str, float]":
    """V₁' = (m₁v₁ + m₂v₂ − m₂e(v₁ − v₂))/(m₁ + m₂), likewise v₂'; ΔV, impulse and loss as differences."""
    m1, m2, e = mass_of(first.bulk, gravity), mass_of(second.bulk, gravity), contact.restitution
    assert m1 is not None
    v1, v2 = first.velocity, second.velocity
    if closing_speed is not None:
        v1, v2 = (v2 + closing_speed, v2) if v1 is None and v2 is not None else (v1 or 0.0, (v1 or 0.0) - closing_speed)
    v1, v2 = v1 or 0.0, v2 or 0.0
    w1, w2 = v2 - e * (v1 - v2), v2
    if m2 is not None:
        w1 = (m1 * v1 + m2 * v2 - m2 * e * (v1 - v2)) / (m1 + m2)
        w2 = (m1 * v1 + m2 * v2 + m1 * e * (v1 - v2)) / (m1 + m2)
    gain = 0.5 * m1 * w1 * w1 - 0.5 * m1 * v1 * v1
    results = {
        "first.velocity": w1, "second.velocity": w2, "first.delta_v": w1 - v1, "second.delta_v": w2 - v2,
        "first.energy_change": gain, "impulse": m1 * v1 - m1 * w1, "separation_speed": w2 - w1,
    }  # fmt: skip
    if m2 is not None:
        more = 0.5 * m2 * w2 * w2 - 0.5 * m2 * v2 * v2
        before = 0.5 * m1 * m2 / (m1 + m2) * (v1 - v2) ** 2
        lost = -gain - more
        results |= {"second.energy_change": more, "energy_lost": lost, "share_lost": lost / before}
    return results


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
    results = {"restitution": e, "drop_height": h, "impact_speed": speed, "fall_time": fall, "share_lost": 1.0 - e**2}
    if e < 1.0:
        results |= {"time_to_rest": fall * (1.0 + e) / (1.0 - e), "way_to_rest": h * (1.0 + e**2) / (1.0 - e**2)}
    if mass is not None:
        results["energy_lost"] = mass * gravity * h - mass * gravity * h * e**2
    for n in range(bounces):
        # t₀·(1 + 2e + … + 2eⁿ)
        results[f"bounces[{n}].time"] = fall * (1.0 + 2.0 * sum(e**k for k in range(1, n + 1)))
        results[f"bounces[{n}].rebound_speed"] = speed * e ** (n + 1)
        results[f"bounces[{n}].height"] = h * e ** (2 * n + 2)
    return results


def pendulum(*, shot_mass: float, block: "Any", swing: "Any", restitution: float, gravity: float) -> "dict[str, float]":
    """V = (m + M)/((1 + e)·m)·√(2·g·L·(1 − cos θ)); hinged: ½·I·ω² = (M·d + m·b)·g·(1 − cos θ)."""
    mass = mass_of(block.bulk, gravity)
    assert mass is not None
    effective, results = mass, {}
    if hasattr(swing, "inertia"):
        arm, along = swing.impact_distance, shot_mass if restitution == 0.0 else 0.0
        lift, inertia = mass * swing.centre_distance + along * arm, swing.inertia + along * arm**2
        spin = sqrt(2.0 * lift * gravity * (1.0 - cos(swing.swing)) / inertia)
        rise, u, effective = lift / (mass + along) * (1.0 - cos(swing.swing)), arm * spin, swing.inertia / arm**2
        results["angular_velocity"] = spin
    else:
        # digits go as the swing becomes small
        if hasattr(swing, "travel"):
            rise = swing.length - sqrt(swing.length**2 - swing.travel**2)
        else:
            rise = swing.length * (1.0 - cos(swing.swing)) if hasattr(swing, "length") else swing.rise
        u = sqrt(2.0 * gravity * rise)
    v = (shot_mass + effective) / ((1.0 + restitution) * shot_mass) * u
    w = u - restitution * v
    before = 0.5 * shot_mass * v * v
    lost = before - 0.5 * shot_mass * w * w - 0.5 * effective * u * u
    return results | {
        "speed": v, "shot_speed_after": w, "pendulum_speed": u, "rise": rise, "impulse": shot_mass * (v - w),
        "energy_before": before, "energy_lost": lost, "share_lost": lost / before,
    }  # fmt: skip


def step(
    *, radius: float, height: float, wheel: "Any", gravity: float, speed: "float | None" = None,
    mass: "float | None" = None,
) -> "dict[str, float]":  # fmt: skip
    """Ω'/ω = (I + m·r·(r − h))/(I + m·r²), v = √(2·g·h·I_O/m)·r/(…); losses as differences of energies.

    Impulses as differences of momenta, with the edge seen under cos φ = (r − h)/r.
    """
    inertia = wheel.inertia_factor * radius**2 if hasattr(wheel, "inertia_factor") else wheel.axle_inertia / mass
    about = inertia + radius**2
    kept = (inertia + radius * (radius - height)) / about
    results = {
        "angular_ratio": kept, "share_lost": 1.0 - kept**2,
        "least_speed": sqrt(2.0 * gravity * height / about) * radius / kept,
        "leaves_edge_speed": sqrt(gravity * (radius - height)) / kept,
    }  # fmt: skip
    if speed is None:
        return results
    spin, after = speed / radius, kept * speed / radius
    energy = 0.5 * about * after**2
    left = energy - gravity * height
    results |= {
        "angular_velocity_after": after, "centre_speed_after": after * radius,
        "speed_on_step": radius * sqrt(2.0 * left / about) if left >= 0.0 else 0.0,
        "greatest_rise": 0.0 if left >= 0.0 else energy / gravity,
    }  # fmt: skip
    if mass is not None:
        angle = acos((radius - height) / radius)
        results |= {
            "energy_lost": mass * (0.5 * about * spin**2 - energy),
            "impulse_forward": mass * kept * speed * cos(angle) - mass * speed,
            "impulse_upward": mass * kept * speed * sin(angle),
        }
    return results
