"""Impacts of two bodies in the plane and in space by textbooks: friction as it slides at first, or none slides at last.

Velocities after come first, by numpy; changes of velocity and energies are differences of before and after.
"""

from math import asin, atan2, cos, hypot, pi, remainder, sin

from dynamics_cli.accuracy.alternatives.impact.plane import angle_of, change, heading_of, mass_of, velocity_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    import numpy as np

    Array = np.ndarray[Any, np.dtype[Any]]


class Body:
    """A body: mass and inverse inertia (None: fixed), where it is struck, and how it moves; a plane's has z = 0."""

    def __init__(self, given: "Any", gravity: float, axes: str, *, planar: bool) -> None:
        import numpy as np

        self.mass = mass_of(given.bulk, gravity)
        self.nose = given.nose
        spin = getattr(given, "spin", 0.0)
        self.spin = np.array([0.0, 0.0, spin] if planar else spin)
        self.velocity = np.array([*velocity_of(given.motion, axes), 0.0] if planar else given.velocity)
        self.lever, self.inertia = np.zeros(3), np.eye(3)
        if self.mass is None or not hasattr(given, "arm"):
            return
        if not hasattr(given.arm, "lever"):
            # placed by its centre or on its nose: left to those who read scenes
            raise ArithmeticError
        if planar:
            radius = getattr(given.turning, "radius_of_gyration", None)
            self.inertia[2, 2] = given.turning.inertia if radius is None else self.mass * radius**2
        else:
            self.inertia = np.array(given.inertia)
        self.lever[: len(given.arm.lever)] = given.arm.lever

    def mobility(self) -> "Array":
        """K = 1/m − [r]·I⁻¹·[r]."""
        import numpy as np

        if self.mass is None:
            return np.zeros((3, 3))
        x, y, z = self.lever
        arm = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
        return np.eye(3) / self.mass - arm @ np.linalg.inv(self.inertia) @ arm  # type: ignore[no-any-return]

    def energy(self, velocity: "Array", spin: "Array") -> float:
        """½·m·v² + ½·ω·I·ω."""
        return float(0.5 * (self.mass or 0.0) * velocity @ velocity + 0.5 * spin @ self.inertia @ spin)


class Meeting:
    """Two bodies, the frame of their contact as rows (its normal, last, points at the first), K and velocity there."""

    def __init__(self, given: "dict[str, Any]") -> None:
        import numpy as np

        self.axes: str = given.get("axes", "mathematical")
        self.zero: str = given.get("pdof_zero", "heading")
        if given.get("moment_restitution", 1.0) != 1.0:
            raise ArithmeticError
        self.planar = hasattr(given["first"], "motion")
        gravity = given.get("gravity", 9.80665)
        self.bodies = [Body(given[name], gravity, self.axes, planar=self.planar) for name in ("first", "second")]
        self.mu, self.e = given.get("friction", 0.0), given["contact"].restitution
        self.law = str(given.get("law", "newton"))
        if self.planar:
            angle = self._line(given["line"]) if "line" in given else angle_of(given["normal"], self.axes)
            c, s = cos(angle), sin(angle)
            self.frame = np.array([[s, -c, 0.0], [0.0, 0.0, 1.0], [-c, -s, 0.0]])
        else:
            normal = -np.array(given["normal"]) / np.linalg.norm(given["normal"])
            # any two axes across it
            self.frame = np.vstack([np.linalg.svd(normal[None, :])[2][1:], normal])
        self.k = self.frame @ sum(body.mobility() for body in self.bodies) @ self.frame.T
        self.u = self.relative([(body.velocity, body.spin) for body in self.bodies])
        if given.get("closing_speed") is not None:
            self.u[2] = -given["closing_speed"]

    def _line(self, line: "Any") -> float:
        """The angle of the line of impact; of an offset d by sin θ = d/(r₁ + r₂) from the relative path."""
        if hasattr(line, "normal"):
            return angle_of(line.normal, self.axes)
        x, y, _ = self.bodies[0].velocity - self.bodies[1].velocity
        if hasattr(line, "offset"):
            return atan2(y, x) + asin(line.offset / (line.first_radius + line.second_radius))
        one, two = line.first_centre, line.second_centre
        return atan2(two[1] - one[1], two[0] - one[0])

    def relative(self, motions: "list[tuple[Array, Array]]") -> "Array":
        """The first's velocity less the second's at the contact, in its frame."""
        import numpy as np

        one, two = (v + np.cross(w, body.lever) for body, (v, w) in zip(self.bodies, motions, strict=True))
        return self.frame @ (one - two)  # type: ignore[no-any-return]


def _results(m: Meeting, parts: "Array") -> "dict[str, float]":
    """Velocities after an impulse on the first, and all else from them, under the names in the plane and in space."""
    import numpy as np

    push = m.frame.T @ parts
    motions, lost = [], 0.0
    vectors: dict[str, Array] = {"impulse": -push}
    results: dict[str, float] = {}
    for name, body, impulse in zip(("first", "second"), m.bodies, (push, -push), strict=True):
        velocity, spin = body.velocity, body.spin
        if body.mass is not None:
            velocity = velocity + impulse / body.mass
            spin = spin + np.linalg.solve(body.inertia, np.cross(body.lever, impulse))
            gain = body.energy(velocity, spin) - body.energy(body.velocity, body.spin)
            lost -= gain
            results |= {f"{name}.energy_change": gain, **_change(m, name, body, velocity)}
            vectors[f"{name}.delta_v"] = velocity - body.velocity
        motions.append((velocity, spin))
        along = m.frame @ velocity
        results |= {
            f"{name}.speed": float(np.linalg.norm(velocity)), f"{name}.spin": spin[2],
            f"{name}.heading": heading_of(velocity[0], velocity[1], m.axes), f"{name}.normal_velocity": -along[2],
            f"{name}.spin_change": spin[2] - body.spin[2], f"{name}.tangential_velocity": -along[0],
        }  # fmt: skip
        vectors |= {f"{name}.velocity": velocity, f"{name}.spin": spin, f"{name}.spin_change": spin - body.spin}
    new = m.relative(motions)
    across = parts[0] if m.planar else hypot(parts[0], parts[1])
    if m.planar:
        results |= {"sliding_before": -m.u[0], "sliding_after": -new[0], "sliding_speed": abs(m.u[0])}
    vectors |= {"sliding_before": m.u[:2] @ m.frame[:2], "sliding_after": new[:2] @ m.frame[:2]}
    if m.bodies[1].mass is not None:
        results["energy_lost"] = lost
    results |= {
        "impulse": parts[2], "impulse_magnitude": float(np.linalg.norm(push)), "normal_impulse": parts[2],
        "tangential_impulse": across, "impulse_ratio": across / parts[2], "closing_speed": -m.u[2],
        "separation_speed": new[2], "impulse_direction": heading_of(-push[0], -push[1], m.axes),
        "normal_direction": heading_of(-m.frame[2, 0], -m.frame[2, 1], m.axes),
    }  # fmt: skip
    return results | {f"{name}[{k}]": float(x) for name, vector in vectors.items() for k, x in enumerate(vector)}


def _change(m: Meeting, name: str, body: Body, velocity: "Array") -> "dict[str, float]":
    """The change of a body's velocity by size and direction."""
    if m.planar:
        before, after = body.velocity[:2].tolist(), velocity[:2].tolist()
        return change(name, before, after, body.nose, m.axes, m.zero)
    nose, (x, y, z) = body.velocity if body.nose is None else body.nose, body.velocity - velocity
    return {
        f"{name}.delta_v_magnitude": hypot(x, y, z), f"{name}.elevation": atan2(z, hypot(x, y)),
        f"{name}.pdof": remainder(atan2(nose[1], nose[0]) - atan2(y, x), 2.0 * pi),
    }  # fmt: skip


def oblique(**given: "Any") -> "dict[str, float]":
    """v₁ₙ' = (m₁v₁ₙ + m₂v₂ₙ − m₂e(v₁ₙ − v₂ₙ))/(m₁ + m₂), tangential parts kept; all else as differences."""
    import numpy as np

    m = Meeting(given)
    one, two = (body.mass for body in m.bodies)
    a, b = (float(m.frame[2] @ body.velocity) for body in m.bodies)
    assert one is not None
    after = b - m.e * (a - b) if two is None else (one * a + two * b - two * m.e * (a - b)) / (one + two)
    return _results(m, np.array([0.0, 0.0, one * after - one * a]))


def by_system(**given: "Any") -> "dict[str, float]":
    """Newton's law: friction against the slip as it was at the start, or no slip at the end, by `numpy.linalg.solve`.

    Slip that turns or stops on the way is not thought of, as in textbooks; other laws are answered while it slides.
    """
    import numpy as np

    m = Meeting(given)
    slip, rise = float(np.hypot(m.u[0], m.u[1])), -(1.0 + m.e) * m.u[2]
    if slip:
        way = np.array([-m.mu * m.u[0] / slip, -m.mu * m.u[1] / slip, 1.0])
        slope = float(m.k[2] @ way)
        if slope > 0.0 and float((m.u + m.k @ (rise / slope * way))[:2] @ m.u[:2]) >= 0.0:
            return _results(m, rise / slope * way)
    if m.law != "newton":
        raise ArithmeticError
    return _results(m, np.linalg.solve(m.k, np.array([-m.u[0], -m.u[1], rise])))
