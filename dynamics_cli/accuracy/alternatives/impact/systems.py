"""Rigid impacts as systems of equations, by LAPACK, and by integration along the impulse; all else as differences."""

from math import cos, hypot, sin

from dynamics_cli.accuracy.alternatives.impact import paths
from dynamics_cli.accuracy.alternatives.impact.plane import (
    angle_of,
    change,
    heading_of,
    kinetic,
    mass_of,
    state,
    velocity_of,
)
from dynamics_cli.accuracy.alternatives.march import own

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.accuracy.alternatives.impact.plane import Pair

    # Velocity and spin after, of each body.
    After = list[tuple[Pair, float]]


class Body:
    """A body in the plane: mass and inertia (None: fixed), where it is struck, and how it moves."""

    def __init__(self, given: "Any", gravity: float, axes: str) -> None:
        self.mass = mass_of(given.bulk, gravity)
        self.velocity, self.spin = velocity_of(given.motion, axes), given.spin
        self.nose: float | None = given.nose
        self.inertia: float | None = None
        self.lever = 0.0, 0.0
        if self.mass is not None:
            if not hasattr(given.arm, "lever"):
                # placed by its centre or on its nose: left to those who read scenes
                raise ArithmeticError
            turning = given.turning
            radius = getattr(turning, "radius_of_gyration", None)
            self.inertia = turning.inertia if radius is None else self.mass * radius**2
            self.lever = given.arm.lever

    def at_contact(self, velocity: "Pair", spin: float) -> "Pair":
        """V + ω × r."""
        return velocity[0] - spin * self.lever[1], velocity[1] + spin * self.lever[0]


class Meeting:
    """Two bodies, the frame of their contact, and the relative velocity there."""

    def __init__(self, given: "dict[str, Any]") -> None:
        if given.get("moment_restitution", 1.0) != 1.0:
            raise ArithmeticError
        self.axes: str = given.get("axes", "mathematical")
        self.zero: str = given.get("pdof_zero", "heading")
        gravity = given.get("gravity", 9.80665)
        self.bodies = [Body(given[name], gravity, self.axes) for name in ("first", "second")]
        angle = angle_of(given["normal"], self.axes)
        # the frame's normal points at the first body
        self.n = -cos(angle), -sin(angle)
        self.t = -self.n[1], self.n[0]
        self.mu, self.e, self.law = given["friction"], given["contact"].restitution, str(given["law"])
        self.slip, self.approach = self.parts([(body.velocity, body.spin) for body in self.bodies])
        if given.get("closing_speed") is not None:
            self.approach = -given["closing_speed"]

    def parts(self, motion: "After") -> "Pair":
        """Relative velocity at the contact, across and along the normal."""
        (a, b), (c, d) = (body.at_contact(*moves) for body, moves in zip(self.bodies, motion, strict=True))
        x, y = a - c, b - d
        return x * self.t[0] + y * self.t[1], x * self.n[0] + y * self.n[1]


def _results(m: Meeting, after: "After") -> "dict[str, float]":
    """Everything from velocities and spins after: ΔV, impulse and energies as differences."""
    one = m.bodies[0]
    assert one.mass is not None
    x, y = (one.mass * (after[0][0][k] - one.velocity[k]) for k in (0, 1))
    normal, across = x * m.n[0] + y * m.n[1], x * m.t[0] + y * m.t[1]
    slip, parting = m.parts(after)
    results = {
        "impulse[0]": -x, "impulse[1]": -y, "impulse_magnitude": hypot(x, y), "normal_impulse": normal,
        "tangential_impulse": across, "impulse_direction": heading_of(-x, -y, m.axes),
        "impulse_ratio": across / normal, "closing_speed": -m.approach, "separation_speed": parting,
        "sliding_before": -m.slip, "sliding_after": -slip,
    }  # fmt: skip
    lost = 0.0
    for name, body, (velocity, spin) in zip(("first", "second"), m.bodies, after, strict=True):
        results |= state(name, velocity, m.axes)
        results |= {f"{name}.spin": spin, f"{name}.spin_change": spin - body.spin}
        if body.mass is None or body.inertia is None:
            continue
        gain = kinetic(body.mass, velocity) + 0.5 * body.inertia * spin**2
        gain -= kinetic(body.mass, body.velocity) + 0.5 * body.inertia * body.spin**2
        lost -= gain
        results[f"{name}.energy_change"] = gain
        results |= change(name, body.velocity, velocity, body.nose, m.axes, m.zero)
    if m.bodies[1].mass is not None:
        results["energy_lost"] = lost
    return results


def _solved(m: Meeting, last: "list[float]", value: float) -> "tuple[After, float]":
    """Momentum, angular momentum and restitution, and one more equation, for all velocities and the impulse: LAPACK.

    Unknowns are x, y and spin of each body, and the normal and the tangential impulse on the first.
    """
    import numpy as np

    whole, right = np.zeros((8, 8)), np.zeros(8)
    ends = np.zeros((2, 8))
    for k, (body, sign) in enumerate(zip(m.bodies, (1.0, -1.0), strict=True)):
        at = 3 * k
        moves = np.array([*body.velocity, body.spin])
        pulls = np.array([[m.n[0], m.t[0]], [m.n[1], m.t[1]], [0.0, 0.0]])
        pulls[2] = body.lever[0] * pulls[1] - body.lever[1] * pulls[0]
        weights = np.ones(3)
        if body.mass is not None and body.inertia is not None:
            weights = np.array([body.mass, body.mass, body.inertia])
        whole[at : at + 3, at : at + 3] = np.diag(weights)
        whole[at : at + 3, 6:] = 0.0 if body.mass is None else -sign * pulls
        right[at : at + 3] = weights * moves
        # the velocity at the contact is what the impulse's pulls are to velocity and spin
        ends[:, at : at + 3] = sign * pulls.T
    whole[6], right[6] = ends[0], -m.e * m.approach
    whole[7], right[7] = (ends[1], value) if not last else ([0.0] * 6 + last, value)
    x = np.linalg.solve(whole, right).tolist()
    return [((x[0], x[1]), x[2]), ((x[3], x[4]), x[5])], x[6]


def by_system(**given: "Any") -> "dict[str, float]":
    """Newton's law: one system with friction as it slides, or without slip at the end, as textbooks teach it.

    Slip that stops or turns round on the way is not thought of; other laws are answered while it slides.
    """
    m = Meeting(given)
    if m.slip:
        ratio = -m.mu if m.slip > 0.0 else m.mu
        after, normal = _solved(m, [-ratio, 1.0], 0.0)
        if normal > 0.0 and m.parts(after)[0] * m.slip >= 0.0:
            return _results(m, after)
    if m.law != "newton":
        raise ArithmeticError
    return _results(m, _solved(m, [], 0.0)[0])


def by_integration(**given: "Any") -> "dict[str, float]":
    """The path in normal impulse by Dormand–Prince steps, on K = Σ (1/m + r²/J); Newton, Poisson, Stronge."""
    m = Meeting(given)
    if m.law not in ("newton", "poisson", "stronge"):
        raise ArithmeticError
    kt = kx = kn = 0.0
    for body in m.bodies:
        if body.mass is None or body.inertia is None:
            continue
        rn, rt = (body.lever[0] * d[0] + body.lever[1] * d[1] for d in (m.n, m.t))
        kt, kx, kn = kt + 1.0 / body.mass + rn**2 / body.inertia, kx - rn * rt / body.inertia, (
            kn + 1.0 / body.mass + rt**2 / body.inertia
        )  # fmt: skip
    contact = paths.Contact((kt, kx, kn), (m.slip, m.approach), m.mu, m.e, m.law)
    pn, pt = paths.integral(contact, own(1e-12))
    after: After = []
    for body, sign in zip(m.bodies, (1.0, -1.0), strict=True):
        x, y = (sign * (pn * n + pt * t) for n, t in zip(m.n, m.t, strict=True))
        if body.mass is None or body.inertia is None:
            after.append((body.velocity, body.spin))
            continue
        velocity = body.velocity[0] + x / body.mass, body.velocity[1] + y / body.mass
        after.append((velocity, body.spin + (body.lever[0] * y - body.lever[1] * x) / body.inertia))
    return _results(m, after)
