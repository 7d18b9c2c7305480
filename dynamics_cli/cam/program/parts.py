"""Segments of a motion between exact ends, and the parts of its laws, in cam angles."""

from dynamics_cli.cam.laws.components import U, carrying
from dynamics_cli.cam.laws.normalised import Law  # noqa: TC001 (annotations of a record)
from dynamics_cli.quantities import Annotated
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# π cut after 50 decimals, over 10^50.
_PI = 314159265358979323846264338327950288419716939937510
_PI_SCALE = 10**50
Exact = tuple[int, int]


def radians(angle: "Exact") -> "tuple[float, float]":
    """An exact number of degrees in radians, as the nearest double and its rounding error."""
    top, bottom = angle[0] * _PI, angle[1] * 180 * _PI_SCALE
    high = top / bottom
    a, b = high.as_integer_ratio()
    return high, (top * b - a * bottom) / (bottom * b)


def from_radians(angle: "Exact") -> "Exact":
    """Degrees of an exact number of radians, to 50 digits."""
    return angle[0] * 180 * _PI_SCALE, angle[1] * _PI


@record
class Span:
    """One segment of a motion, ready for evaluation."""

    start: Annotated["Exact", "Its ends, exactly, in degrees."]
    end: Annotated["Exact", "Its ends, exactly, in degrees."]
    low: Annotated[float, "Lift at its start and end."]
    high: Annotated[float, "Lift at its start and end."]
    law: Annotated["Law | None", "The law from one to the other; None in a dwell."]
    name: Annotated[str, "Its name."] = ""
    scale: Annotated[float | None, "Lift that the law's unit stands for; the difference of the ends if left out."] = (
        None
    )
    off: Annotated[
        "tuple[float, float]", "Rounding error of the lifts at its ends, which are sums of the given ones."
    ] = (0.0, 0.0)


@record
class Zone:
    """Cam angles between which all derivatives of the lift exist."""

    start: Annotated[float, "Its ends [rad]."]
    end: Annotated[float, "Its ends [rad]."]
    segment: Annotated[int, "Index of its segment, from 0."]
    dwell: Annotated[bool, "Whether it is a dwell."]


class Part:
    """A piece of a law in cam angles: s = base + scales[0] g(t), t = ±((θ − origin) − origin_low)/span."""

    __slots__ = ("base", "law_piece", "off", "origin", "origin_low", "scales", "segment", "sign", "span")

    def __init__(self, span: "Span", segment: int, piece: "Any") -> None:
        width = (span.end[0] * span.start[1] - span.start[0] * span.end[1], span.end[1] * span.start[1])
        far = piece is not None and piece.far
        self.span = radians(width)[0]
        self.segment = segment
        self.origin, self.origin_low = radians(span.end if far else span.start)
        self.sign = -1.0 if far else 1.0
        self.base = span.high if far else span.low
        # the lift difference has the errors of both ends
        self.off = span.off[0] + span.off[1]
        self.law_piece = piece
        rise = span.high - span.low if span.scale is None else span.scale
        self.scales = [rise * self.sign]
        for order in range(1, 5):
            rise = rise / self.span
            self.scales.append(rise if not far or order % 2 else -rise)

    def negated(self) -> "Part":
        """The same piece of the motion upside down."""
        negative = Part.__new__(Part)
        for name in self.__slots__:
            setattr(negative, name, getattr(self, name))
        negative.base, negative.scales = -self.base, [-scale for scale in self.scales]
        return negative

    def local(self, theta: "Any") -> "Any":
        """Distance from the end of the segment this piece is measured from, as a share of the segment."""
        away = theta - self.origin
        if type(away) is float:
            return self.sign * ((away - self.origin_low) / self.span) if away else 0.0
        t = (away - self.origin_low) * (self.sign / self.span)
        t[away == 0.0] = 0.0
        return t

    def local_of_sorted(self, theta: "Any") -> "Any":
        """The same for ordered angles, of which only the first or the last can be the origin."""
        t = (theta - self.origin - self.origin_low) * (self.sign / self.span)
        if theta[0] == self.origin:
            t[: theta.searchsorted(self.origin, side="right")] = 0.0
        elif theta[-1] == self.origin:
            t[theta.searchsorted(self.origin) :] = 0.0
        return t

    def give(self, t: "Any", derivatives: int) -> "list[Any]":
        """Lift and derivatives per radian."""
        if self.law_piece is None:
            still = 0.0 * t
            return [still + self.base] + [still] * derivatives
        orders = self.law_piece.shape(t, derivatives)
        lift = self.scales[0] * orders[0]
        out = [self.base + lift if self.base else lift]
        out.extend(self.scales[order] * orders[order] for order in range(1, derivatives + 1))
        return out

    def bounded(self, t: "Any", derivatives: int) -> "list[Any]":
        """The same at a place that carries its error, with the rounding of the part's own constants."""
        if self.law_piece is None:
            still = 0.0 * t
            return [still + carrying(self.base, self.off, t)] + [still] * derivatives
        # an error of the ends is an error of the rise; a rise counts two roundings, each division by the span two more
        level = self.off / abs(self.scales[0]) if self.scales[0] else 0.0
        shares = [level + (2.0 + 2.0 * order) * U for order in range(derivatives + 1)]
        orders = [
            carrying(scale, share * abs(scale), t) * value
            for scale, share, value in zip(self.scales, shares, self.law_piece.shape(t, derivatives), strict=False)
        ]
        return [orders[0] + carrying(self.base, self.off, t) if self.base or self.off else orders[0], *orders[1:]]
