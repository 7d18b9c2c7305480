"""Curves by name: where a point is at a parameter, for numbers of any type and for jets, which give the derivatives.

The parameter u is an angle (circle, ellipse, helix, cycloid, involute, spirals, Lissajous), the arc length (line,
clothoid), x (parabola, catenary) or the time (projectile). A jet stands on the left of a product.
"""

from dynamics_cli.errors import require
from dynamics_cli.numerics import elementary
from dynamics_cli.numerics.elementary import pi_beside
from dynamics_cli.numerics.expressions import jets
from dynamics_cli.numerics.expressions.jets import Jet
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.quadrature.gauss import legendre
from dynamics_cli.numerics.vectors import Vector
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Annotated,
    Direction,
    Distance,
    Gravity,
    Length,
    Ratio,
    Speed,
)
from dynamics_cli.records import record, tagged

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    Place = tuple[Any, Any, Any]


def _integrated(u: Jet, slopes: "tuple[Jet, Jet]", place: "Callable[[Any], Place]") -> "Place":
    """The coordinates with these derivatives by the parameter; for a speed alone, without their values."""
    x, y, _ = place(u.parts[0]) if len(u.parts) > 2 else (0.0, 0.0, 0.0)
    return u.integral(slopes[0], x), u.integral(slopes[1], y), 0.0


@tagged("curve")
@record
class Line:
    """A straight line; its parameter is the length along it."""

    direction: Annotated[Direction, "Direction of the line, e.g. 1, 2, 0."]
    parameter = "length"

    def place(self, u: "Any") -> "Place":
        """Position at a parameter."""
        x, y, z = self._unit()
        return u * x, u * y, u * z

    def _unit(self) -> Vector:
        x, y, z = self.direction
        size = elementary.hypot(elementary.hypot(x, y), z)
        require(plain(size) > 0.0, "the direction of the line is zero", code="zero-direction")
        return x / size, y / size, z / size


@tagged("curve")
@record
class Circle:
    """A circle about the origin; its parameter is the angle."""

    radius: Annotated[Distance, "Radius, of a wheel or a base circle too, e.g. 0.5 m."]
    parameter = "angle"

    def place(self, u: "Any") -> "Place":
        """Position at a parameter."""
        return elementary.cos(u) * self.radius, elementary.sin(u) * self.radius, 0.0


@tagged("curve")
@record
class Ellipse:
    """An ellipse about the origin; its parameter is the eccentric angle."""

    x_radius: Annotated[Distance, "Half axis along x, e.g. 3 m."]
    y_radius: Annotated[Distance, "Half axis along y, e.g. 2 m."]
    parameter = "angle"

    def place(self, u: "Any") -> "Place":
        """Position at a parameter."""
        return elementary.cos(u) * self.x_radius, elementary.sin(u) * self.y_radius, 0.0


@tagged("curve")
@record
class Parabola:
    """The parabola y = x²/(4f); its parameter is x."""

    focal_length: Annotated[Distance, "Distance of the focus from the vertex, e.g. 0.5 m."]
    parameter = "length"

    def place(self, u: "Any") -> "Place":
        """Position at a parameter."""
        return u, u * u / (4.0 * self.focal_length), 0.0


@tagged("curve")
@record
class Projectile:
    """A throw without drag; its parameter is the time."""

    launch_speed: Annotated[Speed, "Speed at the start, e.g. 20 m/s."]
    launch_angle: Annotated[Angle, "Angle above the horizontal at the start, e.g. 30 deg."]
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY
    parameter = "time"

    def place(self, u: "Any") -> "Place":
        """Position at a parameter."""
        along = self.launch_speed * elementary.cos(self.launch_angle)
        up = self.launch_speed * elementary.sin(self.launch_angle)
        return u * along, u * (u * (-0.5 * self.gravity) + up), 0.0


@tagged("curve")
@record
class Helix:
    """A helix about the z-axis; its parameter is the angle."""

    radius: Annotated[Distance, "Radius of the helix, e.g. 0.5 m."]
    pitch: Annotated[Length, "Advance in one turn; left-handed negative, e.g. 0.2 m."]
    parameter = "angle"

    def _rise(self) -> "Any":
        return self.pitch / (2.0 * pi_beside(self.pitch))

    def place(self, u: "Any") -> "Place":
        """Position at a parameter."""
        return elementary.cos(u) * self.radius, elementary.sin(u) * self.radius, u * self._rise()


@tagged("curve")
@record
class Cycloid:
    """The path of a point of a wheel that rolls along x; its parameter is the angle rolled, from the lowest point."""

    radius: Annotated[Distance, "Radius of the wheel, e.g. 0.3 m."]
    arm: Annotated[Distance | None, "Point's distance from the wheel's centre, e.g. 0.2 m."] = None  # fmt: skip
    parameter = "angle"

    def place(self, u: "Any") -> "Place":
        """Position at a parameter."""
        arm = self.radius if self.arm is None else self.arm
        if isinstance(u, Jet):
            # r − d cos u without cancelling at the cusp
            half: Any = jets.sin(u * 0.5)
            along = half * half * (2.0 * arm) + (0.0 if self.arm is None else self.radius - arm)
            return _integrated(u, (along, jets.sin(u) * arm), self.place)
        return u * self.radius - elementary.sin(u) * arm, elementary.cos(u) * -arm + self.radius, 0.0


@tagged("curve")
@record
class Involute:
    """The involute of a circle; its parameter is the angle unrolled."""

    radius: Annotated[Distance, "Radius of the base circle, e.g. 30 mm."]
    parameter = "angle"

    def place(self, u: "Any") -> "Place":
        """Position at a parameter."""
        cosine, sine = elementary.cos(u), elementary.sin(u)
        return (cosine + u * sine) * self.radius, (sine - u * cosine) * self.radius, 0.0


@tagged("curve")
@record
class Archimedes:
    """The spiral of Archimedes; its parameter is the angle."""

    spacing: Annotated[Length, "Distance of one turn from the next, e.g. 0.1 m."]
    parameter = "angle"

    def _rate(self) -> "Any":
        return self.spacing / (2.0 * pi_beside(self.spacing))

    def place(self, u: "Any") -> "Place":
        """Position at a parameter."""
        reach = u * self._rate()
        return reach * elementary.cos(u), reach * elementary.sin(u), 0.0


@tagged("curve")
@record
class Bernoulli:
    """The logarithmic spiral r = a·exp(b·u); its parameter is the angle."""

    start_radius: Annotated[Distance, "Distance a from the pole at the angle 0, e.g. 1 m."]
    growth: Annotated[Ratio, "Growth b of log(radius) by the angle, e.g. 0.1."]
    parameter = "angle"

    def place(self, u: "Any") -> "Place":
        """Position at a parameter."""
        reach = elementary.exp(u * self.growth) * self.start_radius
        return reach * elementary.cos(u), reach * elementary.sin(u), 0.0


@tagged("curve")
@record
class Clothoid:
    """The transition curve whose curvature grows with its length, s/A²; its parameter is the length s."""

    clothoid_parameter: Annotated[Distance, "Parameter A, with A² = radius · length, e.g. 80 m."]
    parameter = "length"

    def place(self, u: "Any") -> "Place":
        """Position at a parameter, by Gauss–Legendre quadrature over pieces of a quarter radian."""
        if isinstance(u, Jet):
            angle: Any = (u / self.clothoid_parameter) * (u / self.clothoid_parameter) * 0.5
            return _integrated(u, (jets.cos(angle), jets.sin(angle)), self.place)
        end, size = plain(u), plain(self.clothoid_parameter)
        turned = 0.5 * (end / size) ** 2
        require(turned < 1e4, "the clothoid turns {count} times", code="turns", count=round(turned / 6.3))
        pieces = 1 + int(4.0 * turned)
        x = y = 0.0 * u
        for piece in range(pieces):
            for node, weight in legendre(12):
                s = u * ((piece + node) / pieces)
                angle = 0.5 * (s / self.clothoid_parameter) * (s / self.clothoid_parameter)
                x, y = x + elementary.cos(angle) * weight, y + elementary.sin(angle) * weight
        return x * u / pieces, y * u / pieces, 0.0


@tagged("curve")
@record
class Catenary:
    """A hanging chain, y = a·cosh(x/a); its parameter is x."""

    catenary_parameter: Annotated[Distance, "Parameter a of y = a·cosh(x/a), e.g. 2 m."]
    parameter = "length"

    def place(self, u: "Any") -> "Place":
        """Position at a parameter."""
        return u, elementary.cosh(u / self.catenary_parameter) * self.catenary_parameter, 0.0


@tagged("curve")
@record
class Lissajous:
    """Two harmonic motions at right angles, x = a·sin(p·u + δ), y = b·sin(q·u); its parameter is the angle u."""

    x_radius: Annotated[Distance, "Amplitude along x, e.g. 3 m."]
    y_radius: Annotated[Distance, "Amplitude along y, e.g. 2 m."]
    x_ratio: Annotated[Ratio, "Cycles p along x, e.g. 3."]
    y_ratio: Annotated[Ratio, "Cycles q along y, e.g. 2."]
    phase: Annotated[Angle, "Phase δ along x, e.g. 90 deg."] = 0.0
    parameter = "angle"

    def place(self, u: "Any") -> "Place":
        """Position at a parameter."""
        across = elementary.sin(u * self.x_ratio + self.phase) * self.x_radius
        return across, elementary.sin(u * self.y_ratio) * self.y_radius, 0.0


Shape = (
    Line | Circle | Ellipse | Parabola | Projectile | Helix | Cycloid | Involute | Archimedes | Bernoulli | Clothoid
    | Catenary | Lissajous
)  # fmt: skip
