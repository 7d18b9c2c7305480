"""Followers carried round a cam: envelopes by their definition, derivatives by Taylor arithmetic (taylor.py).

The roller is a moving circle, |z − c(θ)|² = R², in the cam's frame; the cam is where ∂/∂θ of that vanishes. A flat face
is a moving line treated alike. Curvatures come from differentiating the curve itself, extremes from a look at many
places in doubles and Newton's method on the derivative in 90 digits.
"""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from digits import DOUBLES, MANY, Field
from taylor import Plane, circle, diff, expanded, sqrt

Lift = Callable[[Any], Any]
Branch = tuple[Any, Any, Lift]


def asin(field: Field, x: Any) -> Any:
    """The arc sine of a number."""
    return field.library.arcsin(x) if field is DOUBLES else field.library.asin(x)


def atan2(field: Field, y: Any, x: Any) -> Any:
    """The direction of a vector; of series, by the derivative of the angle."""
    if hasattr(y, "c") or hasattr(x, "c"):
        one = y if hasattr(y, "c") else x
        y, x = y + 0 * one, x + 0 * one
        slope = _turning(x, y)
        first = field.library.arctan2(y.c[0], x.c[0]) if field is DOUBLES else field.library.atan2(y.c[0], x.c[0])
        return type(one)([first, *(slope.c[k] / (k + 1) for k in range(len(slope.c)))])
    return field.library.arctan2(y, x) if field is DOUBLES else field.library.atan2(y, x)


def _turning(x: Any, y: Any) -> Any:
    """(x y′ − y x′)/(x² + y²), one coefficient shorter."""
    kind, n = type(x), len(x.c) - 1
    dx, dy = (kind([(k + 1) * part.c[k + 1] for k in range(n)]) for part in (x, y))
    x, y = kind(x.c[:n]), kind(y.c[:n])
    return (x * dy - y * dx) / (x * x + y * y) if n else kind([])


class Carried:
    """A follower carried round the cam: where its circle or line is, in the cam's frame, at a cam angle."""

    def __init__(self, follower: dict[str, str], turn: int, side: int, field: Field = MANY) -> None:
        self.f = f = {key: field.double(value) for key, value in follower.items() if key != "record"}
        self.kind = follower["record"]
        self.turn, self.side, self.field = turn, side, field
        self.flat = self.kind in ("FlatFace", "OscillatingFlat")
        zero = field.number(0)
        self.roller, self.offset = f.get("roller_radius", zero), f.get("offset", zero)
        prime = f["base_radius"] + self.roller
        if self.kind in ("KnifeEdge", "Roller", "ConjugateRoller"):
            self.start = field.sqrt(prime**2 - self.offset**2)
        elif self.kind in ("OscillatingRoller", "ConjugateOscillatingRoller"):
            arm, pivot = f["arm"], f["pivot_distance"]
            self.start = asin(field, 1) - asin(field, (pivot**2 + arm**2 - prime**2) / (2 * arm * pivot))
        elif self.kind == "OscillatingFlat":
            self.start = asin(field, (f["base_radius"] + f.get("face_offset", zero)) / f["pivot_distance"])
        else:
            self.start = f["base_radius"]

    def _pointing(self, angle: Any) -> Plane:
        """exp(−i angle)."""
        c, s = circle(self.field, angle)
        return Plane(c, -s)

    def _arm(self, s: Any) -> Any:
        return self.start + s - self.f.get("arm_angle", 0)

    def centre(self, s: Any) -> Plane:
        """Fixed-frame centre of the roller."""
        if self.kind in ("KnifeEdge", "Roller"):
            return Plane(self.offset, self.start + s)
        if self.kind == "ConjugateRoller":
            return Plane(self.offset, self.start + s - self.f["roller_distance"])
        out = self._pointing(self._arm(s)) * -self.f["arm"]
        return Plane(out.real + self.f["pivot_distance"], out.imag)

    def way(self, s: Any) -> Plane:
        """Unit direction in which the follower is driven."""
        if self.kind in ("KnifeEdge", "Roller", "FlatFace"):
            return Plane(0, 1)
        if self.kind == "ConjugateRoller":
            return Plane(0, -1)
        return Plane(0, -1 if "arm_angle" in self.f else 1) * self._pointing(self._arm(s))

    def face(self, s: Any) -> tuple[Plane, Any]:
        """Fixed-frame normal of a flat face and the distance of its line from the cam's axis."""
        if self.kind == "FlatFace":
            return Plane(0, 1), self.start + s
        normal = Plane(0, 1) * self._pointing(self.start + s)
        # sin ψ is the normal's first part
        return normal, self.f["pivot_distance"] * normal.real - self.f.get("face_offset", 0)

    def back(self, theta: Any) -> Plane:
        """The turn from the fixed frame to the cam's."""
        return self._pointing(self.turn * theta)

    def carried(self, lift: Lift) -> Callable[[Any], Plane]:
        """The roller's centre in the cam's frame, of the cam angle."""
        return lambda t: self.centre(lift(t)) * self.back(t)

    def point(self, lift: Lift, theta: Any) -> tuple[Plane, Plane]:
        """Envelope point in the cam's frame and the outward normal there."""
        if self.flat:
            # the line Re(conj(n) z) = h and its derivative by θ, solved for z; n′ = i a n with a real
            n, n1 = expanded(lambda t: self.face(lift(t))[0] * self.back(t), theta, 1)
            h, h1 = expanded(lambda t: self.face(lift(t))[1], theta, 1)
            a = (n1 * n.conjugate()).imag
            return n * Plane(h, h1 / a), n
        c, c1 = expanded(self.carried(lift), theta, 1)
        # the circle's point whose radius is square to the centre's velocity, on the outer side
        n = Plane(0, self.turn) * c1 * (1 / sqrt(self.field, c1.square()))
        return c - n * (self.roller * self.side), n

    def pressure(self, lift: Lift, theta: Any) -> Any:
        """The angle from the way of the follower to the normal."""
        if self.kind == "FlatFace":
            return 0 * theta
        z, n = self.point(lift, theta)
        forth = self.back(theta).conjugate()
        if self.kind == "OscillatingFlat":
            # the point of the face moves square to its arm
            arm = z * forth - Plane(self.f["pivot_distance"], 0)
            way = Plane(0, -1) * arm
        else:
            way = self.way(lift(theta))
        ratio = n * forth * way.conjugate()
        return self.turn * atan2(self.field, ratio.imag, ratio.real)

    def radius(self, lift: Lift, theta: Any) -> Any:
        """Radius of curvature of the cam, from derivatives of its points' carrier."""
        if self.flat:
            z1 = diff(lambda t: self.point(lift, t)[0], theta)
            n1 = diff(lambda t: self.point(lift, t)[1], theta)
            return (z1 * n1.conjugate()).real / n1.square()
        return 1 / self.bend(lift, theta) - self.side * self.roller

    def bend(self, lift: Lift, theta: Any) -> Any:
        """Curvature of the path of the roller's centre."""
        _, c1, c2 = expanded(self.carried(lift), theta, 2)
        square = c1.square()
        return -self.turn * (c1.conjugate() * c2).imag / (square * sqrt(self.field, square))


# where a law leaves its dwell with a high power, places crowd towards the ends
_CROWD = [2.0**-j for j in range(8, 40)]
SHARES = np.array(sorted({k / 160 for k in range(1, 160)} | set(_CROWD) | {1.0 - share for share in _CROWD}))


def extreme(
    function: Callable[[Lift, Any], Any], branches: Sequence[tuple[Branch, Branch]], sign: int,
    coarse: Callable[[Lift, Any], Any] | None = None, only: Callable[[Lift, Any], Any] | None = None,
) -> Any:  # fmt: skip
    """The greatest of sign·function over branches given in many digits and in doubles.

    Every top is climbed that slopes at many places show (they show it where values in doubles would all be alike), and
    the ends count. `coarse` is the function in doubles where that is not the same one; `only` says where it counts.
    """
    best = None
    for (start, end, lift), (a, b, rough) in branches:
        places = a + (b - a) * SHARES
        with np.errstate(all="ignore"):
            slopes = sign * diff(lambda t, rough=rough: (coarse or function)(rough, t), places) + 0 * places
            counts = np.isfinite(slopes) if only is None else np.isfinite(slopes) & only(rough, places)
        candidates = [start, end]
        for index in tops(slopes, counts):
            around = [start + (end - start) * float(share) for share in SHARES[index : index + 2]]
            found = top(lambda t, lift=lift: function(lift, t), *around, sign)
            candidates.extend([*around, *found])
        for at in candidates:
            if only is None or only(lift, at):
                value = sign * function(lift, at)
                best = value if best is None or value > best else best
    return None if best is None else sign * best


def tops(slopes: Any, counts: Any) -> list[int]:
    """Places after which a slope falls through zero before the next."""
    falls = (slopes[:-1] > 0) & (slopes[1:] <= 0)
    return [int(i) for i in np.flatnonzero(falls & counts[:-1] & counts[1:])]


def top(function: Callable[[Any], Any], low: Any, high: Any, sign: int) -> list[Any]:
    """Where the derivative falls through zero between two places, if it does: Newton's method, halving where it leaves.

    A slope in doubles may be rounding; that it is none is seen in many digits.
    """
    span = high - low
    if sign * diff(function, low) <= 0 or sign * diff(function, high) >= 0:
        return []
    at = (low + high) / 2
    for _ in range(80):
        _, slope, bend = expanded(function, at, 2)
        if slope == 0:
            return [at]
        low, high = (at, high) if sign * slope > 0 else (low, at)
        step = -slope / bend if bend else span
        if abs(step) <= span / 10**50:
            return [at]
        at = at + step if low < at + step < high else (low + high) / 2
    # what is zero everywhere has only rounding to climb: any place of it will do
    if abs(function(at)) > 10**-60:
        raise ArithmeticError("no top found")
    return [at]
