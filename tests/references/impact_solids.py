"""Rigid bodies in space in many digits: what a contact sees of them, and what an impulse there does to them."""

from typing import Any

from mpmath import atan2, cos, lu_solve, matrix, mpf, nint, pi, sin, sqrt

Vector = tuple[Any, ...]


def vector(numbers: Any) -> Vector:
    return tuple(map(mpf, numbers))


def dot(a: Vector, b: Vector) -> Any:
    return sum(x * y for x, y in zip(a, b, strict=True))


def cross(a: Vector, b: Vector) -> Vector:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def plus(a: Vector, b: Vector, factor: Any = 1) -> Vector:
    return tuple(x + factor * y for x, y in zip(a, b, strict=True))


def size(a: Vector) -> Any:
    return sqrt(dot(a, a))


def frame(normal: Vector) -> tuple[Vector, Vector, Vector]:
    """Two tangents and the normal, at length one; which tangents does not matter to any result."""
    n = tuple(x / size(normal) for x in normal)
    seed = (mpf(1), mpf(2), mpf(-3))
    tangent = plus(seed, n, -dot(seed, n))
    first = tuple(x / size(tangent) for x in tangent)
    return first, cross(n, first), n


class Solid:
    """A body from doubles, which are exact; without mass it is fixed."""

    def __init__(self, tree: dict[str, Any]) -> None:
        self.mass = None if tree["bulk"]["record"] == "Fixed" else mpf(tree["bulk"]["mass"])
        self.r: Vector = (mpf(0),) * 3
        self.inertia = None
        if self.mass is not None:
            self.inertia = matrix([vector(row) for row in tree["inertia"]])
            self.r = vector(tree["arm"]["lever"])
        self.v, self.w = vector(tree["velocity"]), vector(tree["spin"])
        nose = vector(tree["nose"]) if "nose" in tree else self.v
        across = sqrt(nose[0] ** 2 + nose[1] ** 2)
        self.nose = (nose[0] / across, nose[1] / across) if across else (mpf(1), mpf(0))

    def at_contact(self, v: Vector, w: Vector) -> Vector:
        return plus(v, cross(w, self.r))

    def struck(self, impulse: Vector) -> tuple[Vector, Vector]:
        """Velocity and spin after an impulse at the contact."""
        if self.mass is None:
            return self.v, self.w
        turned = lu_solve(self.inertia, matrix(cross(self.r, impulse)))
        return plus(self.v, impulse, 1 / self.mass), plus(self.w, tuple(turned))

    def answer(self, impulse: Vector) -> Vector:
        """Change of velocity at the contact."""
        return plus(self.at_contact(*self.struck(impulse)), self.at_contact(self.v, self.w), -1)

    def kinetic(self, v: Vector, w: Vector) -> Any:
        turned = tuple(self.inertia * matrix(w))
        return (self.mass * dot(v, v) + dot(w, turned)) / 2

    def after(self, name: str, impulse: Vector) -> dict[str, Any]:
        """What is reported of it."""
        v, w = self.struck(impulse)
        found: dict[str, Any] = {f"{name}.speed": size(v)}
        vectors = {"velocity": v, "spin": w, "spin_change": plus(w, self.w, -1)}
        if self.mass is None:
            found[f"{name}.energy_change"] = dot(impulse, self.at_contact(self.v, self.w))
        else:
            change = plus(v, self.v, -1)
            vectors["delta_v"] = change
            along = impulse[0] * self.nose[0] + impulse[1] * self.nose[1]
            left = impulse[1] * self.nose[0] - impulse[0] * self.nose[1]
            angle = atan2(left, -along)
            hours = int(nint(angle * 6 / pi))
            found |= {
                f"{name}.delta_v_magnitude": size(change),
                f"{name}.pdof": angle,
                f"{name}.clock": mpf(hours + 12 if hours <= 0 else hours),
                f"{name}.elevation": atan2(-impulse[2], sqrt(impulse[0] ** 2 + impulse[1] ** 2)),
                f"{name}.energy_change": self.kinetic(v, w) - self.kinetic(self.v, self.w),
            }
        for key, parts in vectors.items():
            found |= {f"{name}.{key}[{i}]": part for i, part in enumerate(parts)}
        return found


def turned_about(axis: int, angle: float, rows: list[list[float]]) -> list[list[float]]:
    """A tensor turned about a coordinate axis, rounded to doubles and symmetric."""
    c, s = cos(mpf(angle)), sin(mpf(angle))
    one, two = (axis + 1) % 3, (axis + 2) % 3
    q = matrix(3, 3)
    q[axis, axis], q[one, one], q[two, two], q[one, two], q[two, one] = 1, c, c, -s, s
    full = q * matrix(rows) * q.T
    return [[float(full[min(i, j), max(i, j)]) for j in range(3)] for i in range(3)]
