"""Bodies in space in many bits: what a contact sees of them, and what an impulse there does to them."""

from collections.abc import Callable
from fractions import Fraction
from typing import Any, NamedTuple

from precise import FUNCTIONS, Exact
from references.impact_keller import End

Number = Any
Vector = tuple[Number, ...]
sqrt, atan2 = FUNCTIONS["sqrt"], FUNCTIONS["atan2"]
# What a path followed in 128 bits, and one in closed form, may itself be off by beside the sizes of what it is made of.
CURVED, STRAIGHT = Exact(2) ** -66, Exact(2) ** -200


def vector(numbers: Any) -> Vector:
    return tuple(Exact(x) for x in numbers)


def dot(a: Vector, b: Vector) -> Number:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> Vector:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def plus(a: Vector, b: Vector, factor: Number = 1) -> Vector:
    return a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]


def size(a: Vector) -> Number:
    return sqrt(dot(a, a))


def scaled(a: Vector, factor: Number) -> Vector:
    return a[0] * factor, a[1] * factor, a[2] * factor


class Solid(NamedTuple):
    """A body; without mass it is fixed, without the inverse of its inertia a particle."""

    mass: Number
    inertia: Any
    inverse: Any
    lever: Vector
    velocity: Vector
    spin: Vector

    def at_contact(self, velocity: Vector, spin: Vector) -> Vector:
        """Velocity of its point at the contact."""
        return plus(velocity, cross(spin, self.lever))

    def turned(self, impulse: Vector) -> Vector:
        """Change of spin by an impulse at the contact."""
        if self.inverse is None:
            return vector((0, 0, 0))
        moment = cross(self.lever, impulse)
        return tuple(dot(row, moment) for row in self.inverse)

    def answer(self, impulse: Vector) -> Vector:
        """Change of velocity at the contact."""
        if self.mass is None:
            return vector((0, 0, 0))
        return plus(scaled(impulse, 1 / self.mass), cross(self.turned(impulse), self.lever))

    def reported(self, name: str, impulse: Vector) -> dict[str, Number]:
        """What is said of it after an impulse."""
        turn, change = self.turned(impulse), vector((0, 0, 0))
        found: dict[str, Number] = {}
        if self.mass is not None:
            change = scaled(impulse, 1 / self.mass)
            found[f"{name}.delta_v_magnitude"] = size(change)
            found |= {f"{name}.delta_v[{i}]": part for i, part in enumerate(change)}
        velocity, spin = plus(self.velocity, change), plus(self.spin, turn)
        found[f"{name}.speed"] = size(velocity)
        for key, parts in (("velocity", velocity), ("spin", spin), ("spin_change", turn)):
            found |= {f"{name}.{key}[{i}]": part for i, part in enumerate(parts)}
        energy = dot(impulse, plus(self.velocity, change, Exact(1) / 2))
        energy += dot(cross(self.lever, impulse), plus(self.spin, turn, Exact(1) / 2))
        return found | {f"{name}.energy_change": energy} | self._directions(name, impulse)

    def _directions(self, name: str, impulse: Vector) -> dict[str, Number]:
        """Where the force came from: from the direction of travel, clockwise, and from above."""
        x, y, z = impulse
        if self.mass is None or not (x * x + y * y) > dot(impulse, impulse) * Exact(2) ** -120:
            return {}
        nose = (Exact(1), Exact(0)) if not any(self.velocity[:2]) else self.velocity[:2]
        angle = atan2(y * nose[0] - x * nose[1], -x * nose[0] - y * nose[1])
        return {f"{name}.pdof": angle, f"{name}.elevation": atan2(-z, sqrt(x * x + y * y))}


def inverse_of(rows: Any) -> list[Vector]:
    """Inverse of a symmetric matrix, by cofactors."""
    a, b, c = (vector(row) for row in rows)
    det = dot(a, cross(b, c))
    return [scaled(part, 1 / det) for part in (cross(b, c), cross(c, a), cross(a, b))]


class Met(NamedTuple):
    """Two bodies at their contact: frame of two tangents and the normal at body 1, K and relative velocity in it."""

    bodies: tuple[Solid, Solid]
    frame: tuple[Vector, Vector, Vector]
    mobility: list[list[Number]]
    before: list[Number]


def meet(one: Solid, two: Solid, normal: Any, along: Vector | None = None) -> Met:
    """The contact; the first tangent is the slip's direction, else as near `along` as it may be, else any."""
    towards = vector(normal)
    inward = scaled(towards, -1 / size(towards))
    u = plus(one.at_contact(one.velocity, one.spin), two.at_contact(two.velocity, two.spin), -1)
    slip = plus(u, inward, -dot(u, inward))
    # what is left of no slip at all is rounding
    if not size(slip) > size(u) * Exact(2) ** -180:
        slip = vector((0, 0, 0))
    guide = next(
        way
        for way in (slip, along, vector((1, 2, -3)), vector((3, 1, 1)))
        if way is not None and size(cross(way, inward)) > 0
    )
    tangent = plus(guide, inward, -dot(guide, inward))
    first = scaled(tangent, 1 / size(tangent))
    frame = first, cross(inward, first), inward
    moved = [plus(one.answer(axis), two.answer(axis)) for axis in frame]
    return Met((one, two), frame, [[dot(change, axis) for axis in frame] for change in moved],
               [size(slip), Exact(0), dot(u, inward)])  # fmt: skip


def results(met: Met, end: End) -> dict[str, Number]:
    """Everything that an impact in space reports as a number."""
    first, second, inward = met.frame
    x, y, z = end.impulse
    impulse = plus(plus(scaled(first, x), second, y), inward, z)
    sideways = sqrt(x * x + y * y)
    k, u = met.mobility, met.before
    after = [u[i] + k[i][0] * x + k[i][1] * y + k[i][2] * z for i in range(3)]
    det = k[0][0] * k[1][1] - k[0][1] * k[0][1]
    hold = k[0][1] * k[1][2] - k[1][1] * k[0][2], k[0][1] * k[0][2] - k[0][0] * k[1][2]
    lost = -(x * (u[0] + after[0]) + y * (u[1] + after[1]) + z * (u[2] + after[2])) / 2
    found = {
        "impulse_magnitude": size(impulse), "normal_impulse": z, "tangential_impulse": sideways,
        "impulse_ratio": sideways / z, "compression_impulse": end.compression, "closing_speed": -u[2],
        "stick_friction": sqrt(hold[0] * hold[0] + hold[1] * hold[1]) / det, "separation_speed": after[2],
        "energy_lost": lost, "energy_lost_tangential": end.heat, "energy_lost_normal": lost - end.heat,
        "slip_impulse": end.slip,
    }  # fmt: skip
    slid = plus(scaled(first, after[0]), second, after[1])
    for key, parts in (
        ("impulse", scaled(impulse, -1)),
        ("sliding_before", scaled(first, u[0])),
        ("sliding_after", slid),
    ):
        found |= {f"{key}[{i}]": part for i, part in enumerate(parts)}
    one, two = met.bodies
    return found | one.reported("first", impulse) | two.reported("second", scaled(impulse, -1))


def slacks(met: Met, end: End, noise: Number) -> Callable[[str], Number]:
    """What the exact results may be off by, beside the sizes of what they are sums of."""
    impulse, k = size(end.impulse), met.mobility
    speed = size(tuple(met.before)) + max(k[0][0], k[1][1], k[2][2]) * impulse
    sizes = {"": impulse, "sliding_after": speed, "separation_speed": speed, "sliding_before": speed}
    sizes |= dict.fromkeys(("energy_lost", "energy_lost_normal", "energy_lost_tangential"), impulse * speed)
    sizes |= {"impulse_ratio": Exact(1), "stick_friction": Exact(1)}
    # a direction in the plane is as uncertain as the impulse's part there is small beside the whole
    x, y, _ = plus(
        scaled(met.frame[0], end.impulse[0]),
        plus(scaled(met.frame[1], end.impulse[1]), scaled(met.frame[2], end.impulse[2])),
    )
    flat = sqrt(x * x + y * y)
    for name, body in zip(("first", "second"), met.bodies, strict=True):
        change = impulse / body.mass if body.mass is not None else Exact(0)
        turn = size(body.turned(end.impulse)) if body.inverse is not None else Exact(0)
        turn = max(turn, *(size(body.turned(axis)) * impulse for axis in met.frame))
        fast, spun = size(body.velocity) + change, size(body.spin) + turn
        sizes |= {f"{name}.{key}": fast for key in ("velocity", "speed", "delta_v", "delta_v_magnitude")}
        sizes |= {f"{name}.spin": spun, f"{name}.spin_change": spun}
        sizes |= {f"{name}.pdof": impulse / flat if flat else Exact(0), f"{name}.elevation": Exact(1)}
        sizes[f"{name}.energy_change"] = impulse * (fast + spun * size(body.lever))
    return lambda name: noise * sizes.get(name.partition("[")[0], impulse)


def exactly(numbers: Any) -> tuple[Fraction, ...]:
    """Doubles as they are."""
    return tuple(Fraction(x) for x in numbers)


def parallel(a: Any, b: Any) -> bool:
    """Whether two vectors of doubles or fractions lie on one line, exactly."""
    return not any(cross(exactly(a), exactly(b)))
