"""Gears in exact numbers (MPFR of 240 bits, mpmath's where that is not installed), by other ways than the program's.

Involutes are roots of tan α − α; the root is the envelope of the rack's corner in the parameter of its ellipse, moved
until its normal passes through the pitch point; what follows from both is in gear_mesh_exact.py, gear_table_exact.py
and gear_profile_exact.py.
"""

from typing import Any

from mpmath import mp, mpf

try:
    import gmpy2
except ImportError:
    gmpy2 = None

BITS = 240
LIB = gmpy2 or mp
Exact = type(gmpy2.mpfr(0)) if gmpy2 else mpf
sin, cos, tan, atan, atan2, acos, sqrt = (
    getattr(LIB, n) for n in ("sin", "cos", "tan", "atan", "atan2", "acos", "sqrt")
)
RACKS = {
    "a": (1.0, 1.25, 0.38),
    "b": (1.0, 1.25, 0.3),
    "c": (1.0, 1.25, 0.25),
    "d": (1.0, 1.4, 0.39),
    "stub": (0.8, 1.0, 0.3),
    "agma-coarse": (1.0, 1.25, 0.3),
    "agma-fine": (1.0, 1.2, 0.0),
}


def many_bits() -> None:
    """Make this thread's arithmetic of 240 bits."""
    mp.prec = BITS
    if gmpy2:
        gmpy2.set_context(gmpy2.context(precision=BITS))


def pi() -> Any:
    """π to all bits."""
    return gmpy2.const_pi() if gmpy2 else +mp.pi


def text(value: Any) -> str:
    """40 digits."""
    return mp.nstr(mpf(str(value)) if gmpy2 else value, 40)


def involute(angle: Any) -> Any:
    """The involute function."""
    return tan(angle) - angle


def involute_angle(value: Any) -> Any:
    """The angle of an involute function, by Newton's method from above, where the residual is convex."""
    angle = (3 * value) ** (Exact(1) / 3) if value < 1 else pi() / 2 - 1 / (value + pi() / 2)
    for _ in range(200):
        tangent = tan(angle)
        step = (tangent - angle - value) / (tangent * tangent)
        angle -= step
        if abs(step) <= abs(angle) * Exact(2) ** (16 - BITS):
            return angle
    raise ArithmeticError("no involute angle found")


class NoSuchGear(ArithmeticError):
    """What is asked for is no gear; the program refuses it too."""


class Tooth:
    """One gear: angles and radii in metres, of doubles as they are."""

    def __init__(
        self, teeth: int, module: float, *, alpha: float, beta: float = 0.0, x: float = 0.0, internal: bool = False,
        profile: str = "a", tip: float | None = None, rho: float | None = None, addendum: float | None = None,
        dedendum: float | None = None,
    ) -> None:  # fmt: skip
        ha, hf, own = RACKS[profile]
        self.z, self.internal, self.m, self.x = teeth, internal, Exact(module), Exact(x)
        self.alpha, self.beta = Exact(alpha), abs(Exact(beta))
        ha, hf = Exact(ha if addendum is None else addendum), Exact(hf if dedendum is None else dedendum)
        self.hf = hf
        sine, cosine = sin(self.alpha), cos(self.alpha)
        widest = (pi() / 4 * cosine - hf * sine) / (1 - sine)
        self.rho = Exact(rho) if rho is not None else min(Exact(own), widest)
        self.at = atan(tan(self.alpha) / cos(self.beta))
        self.r = self.z * self.m / (2 * cos(self.beta))
        self.rb = self.r * cos(self.at)
        way = -1 if internal else 1
        self.tip = Exact(tip) / 2 if tip is not None else self.r + way * self.m * (ha + self.x)
        self.root = self.r - way * self.m * (hf - self.x)
        # half of what the involutes bound at the base circle: a tooth, or a ring's space
        self.solid = (pi() / 2 + way * 2 * self.x * tan(self.alpha)) / self.z + involute(self.at)
        k = 1 / cos(self.beta)
        offset = (pi() / 4 - hf * sine / cosine - self.rho * (1 - sine) / cosine) * k
        # what the transverse plane widens, and where the corner's centre stands below and beside the rack's middle
        self.rack = k, hf - self.rho - self.x, offset
        self.fillet = self.m * (Exact(0.2) if rho is None else Exact(rho)) if internal else None
        self.corner: Any = None
        self.form = self._ring_form() if internal else self._form()
        self.undercut = not internal and self.corner is not None

    def half(self, radius: Any) -> Any:
        """Half angle of what the involutes bound at a radius."""
        return self.solid - involute(acos(self.rb / radius))

    def length(self, radius: Any) -> Any:
        """Length of the line of action from the base circle to a radius."""
        return sqrt((radius - self.rb) * (radius + self.rb))

    def _ring_form(self) -> Any:
        centre = self.root - self.fillet
        if centre <= self.rb:
            raise NoSuchGear
        # the fillet's normal at the flank is a tangent of the base circle
        reach = self.length(centre) + self.fillet
        self.fillet_half = self.solid - involute(acos(self.rb / centre)) - self.fillet / self.rb
        return sqrt(self.rb * self.rb + reach * reach)

    def rolled(self, t: Any) -> tuple[Any, Any, Any, Any]:
        """A point of the trochoid in the frame of its space (x along the middle), and the normal into the space.

        The rack's corner at the parameter t of its ellipse, moved until its normal passes through the pitch point.
        """
        k, hc, offset = self.rack
        rho = self.rho
        st, ct = sin(t), cos(t)
        px, py = offset + k * rho * ct, -(hc + rho * st)
        # the normal (cos t, −k sin t) from (px + travel, py) to the origin
        nx, ny = ct, -k * st
        across = py * nx / ny
        turn = (across - px) * self.m / self.r
        x, y = (self.r + self.m * py), self.m * across
        c, s = cos(turn), sin(turn)
        size = sqrt(nx * nx + ny * ny)
        # in the space's frame heights are along x, and the rack's outward normal points away from the space
        nx, ny = -ny / size, -nx / size
        return x * c + y * s, y * c - x * s, nx * c + ny * s, ny * c - nx * s

    def _form(self) -> Any:
        depth = self.hf - self.rho * (1 - sin(self.alpha)) - self.x
        xi = self.r * sin(self.at) - self.m * depth / sin(self.at)
        if xi >= 0:
            return sqrt(self.rb * self.rb + xi * xi)
        low, high = self._bracket()

        def off(t: Any) -> Any:
            x, y, _, _ = self.rolled(t)
            radius = sqrt(x * x + y * y)
            return atan2(y, x) - (pi() / self.z - self.half(max(radius, self.rb)))

        self.corner = illinois(off, low, high)
        x, y, _, _ = self.rolled(self.corner)
        return sqrt(x * x + y * y)

    def _bracket(self) -> tuple[Any, Any]:
        """Corner parameters between which the trochoid meets the involute: the base circle, and just past the flank."""

        def beyond(t: Any) -> Any:
            x, y, _, _ = self.rolled(t)
            return sqrt(x * x + y * y) - self.rb

        low, high = self.alpha, pi() / 2
        # the trochoid's radius falls as t grows, but for the short way back from the flank's end to the base circle
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if beyond(middle) > 0 else (low, middle)
        return self.alpha + (low - self.alpha) / Exact(16), low


def illinois(function: Any, low: Any, high: Any) -> Any:
    """A root in a bracket, to all bits."""
    f_low, f_high = function(low), function(high)
    if (f_low > 0) == (f_high > 0):
        raise NoSuchGear
    for _ in range(300):
        middle = (low * f_high - high * f_low) / (f_high - f_low)
        value = function(middle)
        if value == 0 or abs(high - low) < abs(high) * Exact(2) ** (20 - BITS):
            return middle
        if (value > 0) == (f_high > 0):
            f_low = f_low / 2
        else:
            low, f_low = high, f_high
        if abs(middle - high) < abs(high) * Exact(2) ** (20 - BITS):
            return middle
        high, f_high = middle, value
    return high
