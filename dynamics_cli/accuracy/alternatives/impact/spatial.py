"""Impacts in space with matrices of numpy: slides or sticks, or integrated by impulse; all else as differences."""

from math import atan2, hypot, pi

from dynamics_cli.accuracy.alternatives.impact import space
from dynamics_cli.accuracy.alternatives.impact.plane import mass_of
from dynamics_cli.accuracy.alternatives.march import own

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    import numpy as np

    Array = np.ndarray[Any, np.dtype[Any]]
    After = list[tuple[Array, Array]]


class Body:
    """A body in space: mass and inverse inertia (None: fixed), where it is struck, and how it moves."""

    def __init__(self, given: "Any", gravity: float) -> None:
        import numpy as np

        self.mass = mass_of(given.bulk, gravity)
        self.velocity, self.spin = np.array(given.velocity), np.array(given.spin)
        self.lever = np.zeros(3)
        self.nose = given.velocity if given.nose is None else given.nose
        if self.mass is not None:
            if not hasattr(given.arm, "lever"):
                raise ArithmeticError
            self.lever = np.array(given.arm.lever)
            self.inertia = np.array(given.inertia)
            self.inverse = np.linalg.inv(self.inertia)

    def energy(self, velocity: "Array", spin: "Array") -> float:
        """½·m·v² + ½·ω·I·ω."""
        assert self.mass is not None
        return float(0.5 * self.mass * velocity @ velocity + 0.5 * spin @ self.inertia @ spin)


class Meeting:
    """Two bodies, the frame of their contact as rows, K = Σ (1/m − [r]·I⁻¹·[r]) and the velocity there, in it."""

    def __init__(self, given: "dict[str, Any]") -> None:
        import numpy as np

        gravity = given.get("gravity", 9.80665)
        self.bodies = [Body(given[name], gravity) for name in ("first", "second")]
        normal = -np.array(given["normal"]) / np.linalg.norm(given["normal"])
        # any two axes across it
        self.frame = np.vstack([np.linalg.svd(normal[None, :])[2][1:], normal])
        self.mu, self.e, self.law = given["friction"], given["contact"].restitution, str(given["law"])
        k = np.zeros((3, 3))
        for body in self.bodies:
            if body.mass is not None:
                x, y, z = body.lever
                arm = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
                k += np.eye(3) / body.mass - arm @ body.inverse @ arm
        self.k = self.frame @ k @ self.frame.T
        self.u = self.relative([(body.velocity, body.spin) for body in self.bodies])

    def relative(self, motion: "After") -> "Array":
        """The first's velocity less the second's at the contact, in its frame."""
        import numpy as np

        one, two = (v + np.cross(w, body.lever) for body, (v, w) in zip(self.bodies, motion, strict=True))
        return self.frame @ (one - two)  # type: ignore[no-any-return]


def _results(m: Meeting, parts: "Array") -> "dict[str, float]":
    """Velocities after an impulse, and ΔV, sizes and energies as differences of them."""
    import numpy as np

    push = m.frame.T @ parts
    after: After = []
    vectors: dict[str, Array] = {"impulse": -push}
    results: dict[str, float] = {}
    lost = 0.0
    for name, body, impulse in zip(("first", "second"), m.bodies, (push, -push), strict=True):
        velocity, spin = body.velocity, body.spin
        if body.mass is not None:
            velocity = velocity + impulse / body.mass
            spin = spin + body.inverse @ np.cross(body.lever, impulse)
            gain = body.energy(velocity, spin) - body.energy(body.velocity, body.spin)
            lost -= gain
            way = velocity - body.velocity
            vectors[f"{name}.delta_v"] = way
            turn = atan2(body.nose[1], body.nose[0]) - atan2(-way[1], -way[0])
            angle = turn - 2.0 * pi * round(turn / (2.0 * pi))
            hours = round(angle * 6.0 / pi)
            results |= {
                f"{name}.delta_v_magnitude": float(np.linalg.norm(way)), f"{name}.pdof": angle,
                f"{name}.clock": float(hours if hours > 0 else hours + 12),
                f"{name}.elevation": atan2(-way[2], hypot(way[0], way[1])), f"{name}.energy_change": gain,
            }  # fmt: skip
        after.append((velocity, spin))
        results[f"{name}.speed"] = float(np.linalg.norm(velocity))
        vectors |= {f"{name}.velocity": velocity, f"{name}.spin": spin, f"{name}.spin_change": spin - body.spin}
    new = m.relative(after)
    across = float(np.hypot(parts[0], parts[1]))
    vectors["sliding_before"] = m.u[:2] @ m.frame[:2]
    vectors["sliding_after"] = new[:2] @ m.frame[:2]
    if m.bodies[1].mass is not None:
        results["energy_lost"] = lost
    results |= {
        "impulse_magnitude": float(np.linalg.norm(push)), "normal_impulse": float(parts[2]),
        "tangential_impulse": across, "impulse_ratio": across / float(parts[2]),
        "closing_speed": -float(m.u[2]), "separation_speed": float(new[2]),
    }  # fmt: skip
    return results | {f"{name}[{k}]": float(x) for name, vector in vectors.items() for k, x in enumerate(vector)}


def by_system(**given: "Any") -> "dict[str, float]":
    """Newton's law: friction against the slip as it was at the start, or no slip at the end, by `numpy.linalg.solve`.

    Slip that turns or stops on the way is not thought of, as in textbooks; other laws are answered while it slides.
    """
    import numpy as np

    m = Meeting(given)
    slip, rise = float(np.hypot(m.u[0], m.u[1])), -(1.0 + m.e) * m.u[2]
    if slip:
        way = -m.mu * np.array([m.u[0] / slip, m.u[1] / slip, 0.0]) + np.array([0.0, 0.0, 1.0])
        slope = float(m.k[2] @ way)
        if slope > 0.0:
            parts = rise / slope * way
            if float((m.u + m.k @ parts)[:2] @ m.u[:2]) >= 0.0:
                return _results(m, parts)
    if m.law != "newton":
        raise ArithmeticError
    return _results(m, np.linalg.solve(m.k, np.array([-m.u[0], -m.u[1], rise])))


def by_integration(**given: "Any") -> "dict[str, float]":
    """Keller's equations by Dormand–Prince steps to 1e-10, on K of numpy."""
    import numpy as np

    m = Meeting(given)
    k = tuple(tuple(row) for row in m.k.tolist())
    x, y, z = m.u.tolist()
    contact = space.Contact(k, (x, y, z), m.mu, m.e, m.law)
    return _results(m, np.array(space.integral(contact, own(1e-10))))
