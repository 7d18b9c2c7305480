"""A body suddenly held and a wheel that meets a step: energies as differences, and momentum with its constraints."""

from math import sqrt

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    import numpy as np

    Array = np.ndarray[Any, np.dtype[Any]]


class Held:
    """Mass, inertia, motion, and the point and axis held, as arrays; a plate's axes lie along its edges."""

    def __init__(self, body: "Any") -> None:
        import numpy as np

        if hasattr(body, "plate_mass"):
            moment, half = body.plate_mass * body.side**2 / 12.0, 0.5 * body.side
            edge = body.seized == "edge"
            self.mass = body.plate_mass
            self.inertia = np.diag([moment, moment, 2.0 * moment])
            self.spin = np.array([body.spin, body.spin, 0.0]) / sqrt(2.0)
            self.velocity = np.zeros(3)
            self.point = np.array([0.0 if edge else half, -half, 0.0])
            axis: Any = (1.0, 0.0, 0.0) if edge else None
        else:
            self.mass = body.mass
            self.inertia = np.array(body.inertia)
            self.spin, self.velocity = np.array(body.angular_velocity), np.array(body.velocity)
            self.point, axis = np.array(body.point), body.axis
        self.axis = None if axis is None else np.array(axis) / np.linalg.norm(axis)


def _results(b: Held, spin: "Array", velocity: "Array") -> "dict[str, float]":
    """Impulse and couple as differences of momenta, the loss as a difference of energies."""
    import numpy as np

    def energy(w: "Array", v: "Array") -> float:
        return float(0.5 * w @ b.inertia @ w + 0.5 * b.mass * v @ v)

    impulse = b.mass * velocity - b.mass * b.velocity
    before, after = energy(b.spin, b.velocity), energy(spin, velocity)
    size, old = (float(np.linalg.norm(v)) for v in (spin, b.spin))
    results = {
        "angular_speed": size, "impulse_size": float(np.linalg.norm(impulse)), "energy_before": before,
        "energy_after": after, "energy_lost": before - after, "energy_ratio": after / before,
    }  # fmt: skip
    vectors = {"angular_velocity": spin, "centre_velocity": velocity, "impulse": impulse}
    if old:
        results["angular_ratio"] = size / old
    if b.axis is not None:
        vectors["couple"] = b.inertia @ spin - b.inertia @ b.spin - np.cross(b.point, impulse)
        results["couple_size"] = float(np.linalg.norm(vectors["couple"]))
    return results | {f"{name}[{k}]": float(x) for name, vector in vectors.items() for k, x in enumerate(vector)}


def seize_by_book(*, body: "Any") -> "dict[str, float]":
    """I_O = I_G + m·(r²·1 − r·rᵀ), H_O = I_G·ω − r × m·v; ω' = I_O⁻¹·H_O, of an axis a·(a·H_O)/(a·I_O·a)."""
    import numpy as np

    b = Held(body)
    r = b.point
    about = b.inertia + b.mass * (r @ r * np.eye(3) - np.outer(r, r))
    momentum = b.inertia @ b.spin - np.cross(r, b.mass * b.velocity)
    if b.axis is None:
        spin = np.linalg.inv(about) @ momentum
    else:
        spin = b.axis * (b.axis @ momentum) / (b.axis @ about @ b.axis)
    return _results(b, spin, np.cross(spin, -r))


class Wheel:
    """A wheel's moment over its mass (or for a mass of one), and what it meets."""

    def __init__(self, radius: float, height: float, wheel: "Any", mass: "float | None") -> None:
        self.radius, self.height, self.mass = radius, height, mass
        if hasattr(wheel, "inertia_factor"):
            self.inertia = wheel.inertia_factor * radius**2
        else:
            assert mass is not None
            self.inertia = wheel.axle_inertia / mass


def _climbs(w: Wheel, speed: "float | None", kept: float, least: float, gravity: float) -> "dict[str, float]":
    """What becomes of the wheel, from energies before and after; I_O = I + m·r² about the edge."""
    about = w.inertia + w.radius**2
    leaves = sqrt(gravity * (w.radius - w.height)) / kept
    climbs = {"angular_ratio": kept, "share_lost": 1.0 - kept**2, "least_speed": least, "leaves_edge_speed": leaves}
    if speed is None:
        return climbs
    spin = speed / w.radius
    after = kept * spin
    energy = 0.5 * about * after**2
    left = energy - gravity * w.height
    over = left >= 0.0
    climbs |= {
        "angular_velocity": spin, "angular_velocity_after": after, "centre_speed_after": after * w.radius,
        "speed_on_step": w.radius * sqrt(2.0 * left / about) if over else 0.0,
        "greatest_rise": 0.0 if over else energy / gravity,
    }  # fmt: skip
    if w.mass is not None:
        climbs["energy_lost"] = w.mass * (0.5 * about * spin**2 - energy)
    return climbs


def step_by_book(
    *, radius: float, height: float, wheel: "Any", gravity: float, speed: "float | None" = None,
    mass: "float | None" = None,
) -> "dict[str, float]":  # fmt: skip
    """Ω'/ω = (I + m·r·(r − h))/(I + m·r²), v = √(2·g·h·I_O/m)·r/(…); losses as differences of energies.

    Impulses as differences of momenta, with the edge seen under cos φ = (r − h)/r.
    """
    from math import acos, cos, sin

    w = Wheel(radius, height, wheel, mass)
    about = w.inertia + radius**2
    kept = (w.inertia + radius * (radius - height)) / about
    least = sqrt(2.0 * gravity * height / about) * radius / kept
    climbs = _climbs(w, speed, kept, least, gravity)
    if speed is not None and mass is not None:
        angle, after = acos((radius - height) / radius), kept * speed
        climbs |= {
            "impulse_forward": mass * after * cos(angle) - mass * speed,
            "impulse_upward": mass * after * sin(angle),
        }
    return climbs
