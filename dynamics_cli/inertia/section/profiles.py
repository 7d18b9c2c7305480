"""Rolled and drawn profiles by their sizes, as the contours of a section."""

from fractions import Fraction

from dynamics_cli.errors import require
from dynamics_cli.quantities import Annotated, SectionCoordinate, SectionSize
from dynamics_cli.records import Choice, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

    Corner: TypeAlias = tuple[Fraction, Fraction]
    # Sign, corners (of a circle its centre, of a fillet its corner), diameter or radius, and the way of a fillet.
    Outline: TypeAlias = tuple[int, list[Corner], Fraction, tuple[int, int] | None]

# The sizes that each profile takes.
FLANGED = ("height", "width", "web", "flange")
SIZES = {
    "i-beam": FLANGED,
    "channel": FLANGED,
    "tee": FLANGED,
    "angle": ("height", "width", "thickness"),
    "box": ("height", "width", "thickness"),
    "tube": ("diameter", "thickness"),
    "flat": ("height", "width"),
    "round": ("diameter",),
}
FILLETED = ("i-beam", "channel", "tee", "angle")
ALL_SIZES = (*FLANGED, "thickness", "diameter")


class Form(Choice):
    """A profile."""

    names = tuple(SIZES)
    aliases = {  # noqa: RUF012
        **dict.fromkeys(("i", "h", "h-beam", "wide-flange"), "i-beam"),
        **{"c": "channel", "u": "channel", "t": "tee", "l": "angle", "rectangular-tube": "box", "square-tube": "box"},
        **{"pipe": "tube", "rectangle": "flat", "bar": "flat", "circle": "round", "rod": "round"},
    }


@record
class Bar:
    """A profile about the middle of its height and width, which lies at (x, y)."""

    profile: Annotated[Form, "i-beam, channel (web on the left), tee (flange on top), angle, box, tube, flat, round."]
    height: Annotated[SectionSize | None, "Whole height, along y, e.g. 200 mm."] = None
    width: Annotated[SectionSize | None, "Whole width, along x, e.g. 100 mm."] = None
    web: Annotated[SectionSize | None, "Thickness of the web, e.g. 6 mm."] = None
    flange: Annotated[SectionSize | None, "Thickness of the flanges, e.g. 9 mm."] = None
    thickness: Annotated[SectionSize | None, "Thickness of an angle's legs, of a wall, e.g. 5 mm."] = None
    diameter: Annotated[SectionSize | None, "Outer diameter, e.g. 60 mm."] = None
    fillet: Annotated[SectionSize, "Radius of the inner corners of open profiles, e.g. 12 mm."] = 0.0
    x: Annotated[SectionCoordinate, "Where the middle of width and height is [m]."] = 0.0
    y: Annotated[SectionCoordinate, "Where the middle of width and height is [m]."] = 0.0


def exact(number: float) -> Fraction:
    """A double or a number as typed, as a ratio."""
    return Fraction(*number.as_integer_ratio())


def outlines(item: Bar) -> "list[Outline]":
    """The contours of a profile, and the fillets of its inner corners.

    Raises InadmissibleError when a size is missing, of another profile, or too large for the others.
    """
    form = item.profile
    for name in ALL_SIZES:
        given = getattr(item, name) is not None
        require(
            given == (name in SIZES[form]),
            "{profile} takes no {size}" if given else "{profile} needs its {size}",
            code="exclusive" if given else "missing",
            hint=f"its sizes are {', '.join(SIZES[form])}" + (", fillet" if form in FILLETED else ""),
            profile=f"an {form}" if form[0] in "ai" else f"a {form}",
            size=name,
        )
    h, w, web, flange, t, d = (exact(getattr(item, name) or 0.0) for name in ALL_SIZES)
    dx, dy, fillet = exact(item.x), exact(item.y), exact(item.fillet)
    web, flange = (t, t) if form == "angle" else (web, flange)
    if form in ("tube", "round"):
        require(2 * t < d, "the wall fills the tube", code="size")
        bore = [(-1, [(dx, dy)], d - 2 * t, None)] if t else []
        return [(1, [(dx, dy)], d, None), *bore]
    x, y = w / 2, h / 2
    fits = {"i-beam": (web, 2 * flange), "channel": (web, 2 * flange), "box": (2 * t, 2 * t)}.get(form, (web, flange))
    require(fits[0] < w and fits[1] < h, "the walls fill the profile", code="size", hint="give thinner ones")
    corners, inner = _corners(form, x, y, web, flange, t)
    # two fillets beside or above each other share the room
    beside, above = (2 if form in forms else 1 for forms in (("i-beam", "tee"), ("i-beam", "channel")))
    room = min((w - fits[0]) / beside, (h - fits[1]) / above) if inner else Fraction(0)
    require(
        fillet <= room,
        "a fillet of {fillet} does not fit: there is room for {room}" if inner else "{profile} takes no fillet",
        code="size",
        fillet=(float(fillet), SectionSize),
        room=(float(room), SectionSize),
        profile=f"a {form}",
    )
    out: list[Outline] = [(sign, [(a + dx, b + dy) for a, b in points], Fraction(0), None) for sign, points in corners]
    return out + [(1, [(a + dx, b + dy)], fillet, way) for a, b, way in inner if fillet]


def _corners(
    form: str, x: Fraction, y: Fraction, web: Fraction, flange: Fraction, t: Fraction
) -> "tuple[list[tuple[int, list[Corner]]], list[tuple[Fraction, Fraction, tuple[int, int]]]]":
    """Polygons within ±x, ±y with their signs, and the inner corners with the way into the open."""
    low, high, left = flange - y, y - flange, web - x
    outside: list[Corner] = [(-x, -y), (x, -y), (x, y), (-x, y)]
    if form == "flat":
        return [(1, outside)], []
    if form == "box":
        a, b = x - t, y - t
        return [(1, outside), (-1, [(-a, -b), (a, -b), (a, b), (-a, b)])], []
    if form == "angle":
        return [(1, [(-x, -y), (x, -y), (x, low), (left, low), (left, y), (-x, y)])], [(left, low, (1, 1))]
    if form == "channel":
        arms = [(x, -y), (x, low), (left, low), (left, high), (x, high), (x, y)]
        return [(1, [(-x, -y), *arms, (-x, y)])], [(left, low, (1, 1)), (left, high, (1, -1))]
    half = web / 2
    if form == "tee":
        right = [(half, -y), (half, high), (x, high), (x, y)]
        return [(1, _mirrored(right))], [(half, high, (1, -1)), (-half, high, (-1, -1))]
    right = [(x, -y), (x, low), (half, low), (half, high), (x, high), (x, y)]
    ways = [(half, low, (1, 1)), (half, high, (1, -1)), (-half, low, (-1, 1)), (-half, high, (-1, -1))]
    return [(1, _mirrored(right))], ways


def _mirrored(right: "list[Corner]") -> "list[Corner]":
    """A contour of its right half."""
    return [*right, *((-x, y) for x, y in reversed(right))]
