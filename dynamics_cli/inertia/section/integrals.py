"""Area integrals of contours as exact ratios of whole numbers, π cut after 100 decimals, each result rounded once."""

from math import isqrt

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.section.contours import Contour

PI, PI_SCALE = (
    31415926535897932384626433832795028841971693993751058209749445923078164062862089986280348253421170679,
    10**100,
)
# Common denominator of all integrals, apart from powers of the unit: 24 for polygons, 64 for circles.
_D = 24 * 64 * PI_SCALE
_ROOT_BITS = 160
# Enough for the distance of a fibre that is nearly on an axis.
_DIRECTION_BITS = 400


class Integrals:
    """∫dA, ∫x, ∫y, ∫x², ∫y², ∫xy over a section, times a common denominator, in units of 1/`unit` m."""

    __slots__ = ("area", "unit", "x", "xx", "xy", "y", "yy")

    def __init__(self, contours: "list[Contour]", unit: int) -> None:
        self.unit = unit
        self.area = self.x = self.y = self.xx = self.yy = self.xy = 0
        for contour in contours:
            parts = _circle(contour) if contour.diameter else _fillet(contour) if contour.way else _polygon(contour)
            sign = contour.sign if parts[0] >= 0 else -contour.sign
            self.area += sign * parts[0]
            self.x += sign * parts[1]
            self.y += sign * parts[2]
            self.xx += sign * parts[3]
            self.yy += sign * parts[4]
            self.xy += sign * parts[5]

    def central(self) -> "tuple[int, int, int]":
        """∫y², ∫x², ∫xy about the centroid, times `central_scale`."""
        return (
            self.yy * self.area - self.y * self.y,
            self.xx * self.area - self.x * self.x,
            self.xy * self.area - self.x * self.y,
        )

    @property
    def central_scale(self) -> int:
        """Denominator of the central moments, in m⁴."""
        return self.area * _D * self.unit**4

    def moment(self, integral: int, degree: int) -> "tuple[int, int]":
        """An integral as a ratio in metres, of degree 2 (area) to 4."""
        return integral, _D * self.unit**degree


def _polygon(contour: "Contour") -> "tuple[int, ...]":
    area = x = y = xx = yy = xy = 0
    for (ax, ay), (bx, by) in contour.sides():
        cross = ax * by - bx * ay
        area += cross
        x += cross * (ax + bx)
        y += cross * (ay + by)
        xx += cross * (ax * ax + ax * bx + bx * bx)
        yy += cross * (ay * ay + ay * by + by * by)
        xy += cross * (ax * (2 * ay + by) + bx * (ay + 2 * by))
    return area * (_D // 2), x * (_D // 6), y * (_D // 6), xx * (_D // 12), yy * (_D // 12), xy * (_D // 24)


def _circle(contour: "Contour") -> "tuple[int, ...]":
    (x, y), d = contour.corners[0], contour.diameter
    pi = PI * (_D // PI_SCALE)
    area, central = pi // 4 * d * d, pi // 64 * d**4
    return area, area * x, area * y, central + area * x * x, central + area * y * y, area * x * y


def _fillet(contour: "Contour") -> "tuple[int, ...]":
    """A square beside a corner less the quarter of a disk about its far corner (cx, cy)."""
    assert contour.way
    (i, j), r, pi = contour.way, contour.radius, PI * (_D // PI_SCALE)
    cx, cy = contour.corners[0][0] + i * r, contour.corners[0][1] + j * r
    area, second = (4 * _D - pi) // 4 * r * r, (16 * _D - 3 * pi) // 48 * r**4
    first_x, first_y = -i * (_D // 6) * r**3, -j * (_D // 6) * r**3
    x, y = cx * area + first_x, cy * area + first_y
    xx, yy = cx * (x + first_x) + second, cy * (y + first_y) + second
    return area, x, y, xx, yy, cx * y + cy * first_x + i * j * (_D // 8) * r**4


def root(numerator: int, denominator: int) -> "tuple[int, int]":
    """The square root of a ratio, to more than a hundred bits."""
    shift = max(0, _ROOT_BITS + denominator.bit_length() - numerator.bit_length())
    shift += shift % 2
    return isqrt((numerator << (2 * shift)) // denominator), 1 << shift


def principal(xx: int, yy: int, xy: int) -> "tuple[tuple[int, int], tuple[int, int]]":
    """Greatest and least of the moments about axes through one point, as ratios to the scale of those given.

    The least is the determinant over the greatest: a difference would lose the digits of a thin section.
    """
    spread = (xx - yy) ** 2 + 4 * xy * xy
    up, down = root(spread, 1)
    greatest = (xx + yy) * down + up
    return (greatest, 2 * down), (2 * down * (xx * yy - xy * xy), greatest)


def direction(xx: int, yy: int, xy: int) -> "tuple[int, int]":
    """The axis of the greatest moment, in whole numbers: tan 2φ = −2 Ixy/(Ix − Iy) (Josephs & Huston, section 7.9)."""
    up, down = root((xx - yy) ** 2 + 4 * xy * xy, 1)
    along, across = up + abs(xx - yy) * down, -2 * xy * down
    excess = max(along.bit_length(), across.bit_length()) - _DIRECTION_BITS
    if excess > 0:
        along, across = along >> excess, across >> excess
    return (along, across) if xx >= yy else (abs(across), along if across >= 0 else -along)
