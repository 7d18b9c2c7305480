"""The curve of a coupler point: its shape, length, cusps, crossings, cognates, and files of it."""

from dynamics_cli.errors import require
from dynamics_cli.linkage.fourbar.closure import OPEN, Branch, frame
from dynamics_cli.linkage.fourbar.grashof import closeness, kind_of
from dynamics_cli.linkage.fourbar.lengths import require_links
from dynamics_cli.linkage.fourbar.records import CurvePoint, Special, Straight
from dynamics_cli.outlines import Drawing
from dynamics_cli.quantities import Annotated, Area, Coordinate, Count, PartPoint, Size, Text
from dynamics_cli.records import Advice, Check, Choice, Columns, ErrorBound, Numerics, record
from dynamics_cli.sampling import drawing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.linkage.fourbar.circuit import Circuit


class Form(Choice):
    """Kind of pieces of the drawing."""

    names = ("arcs", "cubics", "lines")
    aliases = {"splines": "cubics", "spline": "cubics", "polyline": "lines", "arc": "arcs"}  # noqa: RUF012


ARCS = Form("arcs")
MANY = 1_000_000
NOWHERE = (
    Advice("no-straight-part", "no part of the curve is that straight", remedy="allow a larger --straight-within"),
)


@record
class Cognate:
    """A four-bar that traces the same curve (Roberts–Chebyshev)."""

    name: Annotated[Text, "Which of the two."]
    crank: Annotated[Size, "Its link at its first pivot [m]."]
    coupler: Annotated[Size, "Its coupler [m]."]
    rocker: Annotated[Size, "Its link at the third pivot C₀ [m]."]
    ground: Annotated[Size, "Its ground link [m]."]
    pivot: Annotated[PartPoint, "Its first pivot [m]."]
    third_pivot: Annotated[PartPoint, "The third pivot C₀ [m]."]
    point: Annotated[PartPoint, "The coupler point along and left of its coupler [m]."]


@record
class CouplerCurve:
    """A coupler curve."""

    length: Annotated[Size, "Length of the closed curve [m]."]
    area: Annotated[Area, "Enclosed area; loops in opposite directions subtract [m^2]."]
    left: Annotated[Coordinate, "Smallest x [m]."]
    right: Annotated[Coordinate, "Largest x [m]."]
    bottom: Annotated[Coordinate, "Smallest y [m]."]
    top: Annotated[Coordinate, "Largest y [m]."]
    crank_turns: Annotated[Count, "Turns of the crank in which it closes; 0 if the crank swings."]
    kind: Annotated[Text, "Class of the linkage."]
    cognates: Annotated[tuple[Cognate, ...], "The two other four-bars that trace it."]
    points: Annotated[Columns[CurvePoint], "The curve, its first point not repeated."]
    cusps: Annotated[tuple[Special, ...] | None, "Where the point stops and turns back."] = None
    crossings: Annotated[tuple[Special, ...] | None, "Points that the curve passes twice."] = None
    straight: Annotated[tuple[Straight, ...] | None, "The longest straight part, where it is asked for."] = None
    deviation: Annotated[Size | None, "Largest distance between drawing and exact curve, as proved [m]."] = None
    pieces: Annotated[Count | None, "Arcs, cubics or lines of the drawing."] = None
    shape: Annotated[Drawing | None, "The curve."] = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def coupler(
    *,
    crank: Annotated[Size, "Length a of the driving link, from O₂ to A, e.g. 40 mm."],
    coupler: Annotated[Size, "Length b of the link between the pins A and B, e.g. 120 mm."],
    rocker: Annotated[Size, "Length c of the driven link, from O₄ to B, e.g. 80 mm."],
    ground: Annotated[Size, "Distance d of the pivots O₂ and O₄, e.g. 100 mm."],
    point: Annotated[PartPoint, "The coupler point P from A, along AB and to its left, e.g. 60, 40 mm."],
    branch: Annotated[
        Branch, "Which of two circuits: the branch of a crank that turns fully, else open for the crank above O₂–O₄."
    ] = OPEN,
    straight_within: Annotated[
        Size | None, "Find the longest part that departs from a straight line by no more than this, e.g. 0.1 mm."
    ] = None,
    points: Annotated[Count, "Points of the table."] = 72,
    form: Annotated[Form, "Pieces of a drawing: arcs (with bulges), cubics (splines) or lines."] = ARCS,
    tolerance: Annotated[Size, "Largest deviation of a drawing allowed [m]."] = 1e-5,
) -> CouplerCurve:
    """Curve of a coupler point over the whole motion: length, extremes, cusps, crossings, cognates and a drawing.

    Equation
    --------
    P = A + (p + iq)·(B − A)/b over a parameter in which the motion is analytic; length = ∮|P′|du. Cognates with
    z = (P − A)/(B − A): third pivot O₂ + z(O₄ − O₂), links |z|·(b, a, c, d) and |1 − z|·(b, c, a, d).

    Raises
    ------
    InadmissibleError
        When the links cannot be closed, or the tolerance of the drawing is below rounding.

    Notes
    -----
    Where the crank swings between limits, both branches are one curve. The trapezoid rule over a closed analytic curve
    converges geometrically; it is doubled until two results agree. The drawing's deviation is proved by disc
    arithmetic on cells. Beside a cusp, whose
    curvature has no limit, the drawing has a line.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 5.5; Roberts, On three-bar motion,
    Proceedings of the London Mathematical Society 7 (1875).

    Examples
    --------
    >>> result = coupler(crank=0.04, coupler=0.12, rocker=0.08, ground=0.1, point=(0.06, 0.04))
    >>> round(result.length, 12)
    0.247031601825
    """
    from dynamics_cli.linkage.fourbar.circuit import Circuit
    from dynamics_cli.linkage.fourbar.curve import columns, crossings, cusp_places, cusps, drawn, extremes, measures

    require_links(crank, coupler, rocker, ground)
    require(4 <= points <= MANY, "points: {count}; a curve has 4 to {most}", count=points, most=MANY, code="points")
    lengths = (crank, coupler, rocker, ground)
    kind = kind_of(lengths)
    require(
        not kind.startswith("a straight line"),
        "the longest link equals the other three together: the linkage is a line that cannot move",
        code="cannot-move",
        hint="shorten the longest link",
    )
    circuit = Circuit(frame(*lengths), 1.0 if branch == OPEN else -1.0)
    place = complex(*point)
    length, error, area = measures(circuit, place)
    # samples of an uncertain curve are not drawn
    sampled = drawing()
    straight = None if sampled or straight_within is None else _straight(circuit, place, straight_within)
    sharp = [] if sampled else cusp_places(circuit, place, length)
    outline = None if sampled else drawn(circuit, place, str(form), tolerance, sharp)
    off = outline.deviation if outline else tolerance
    (min_x, max_x), (min_y, max_y) = extremes(circuit, place)
    return CouplerCurve(
        length=length,
        area=abs(area),
        left=min_x,
        right=max_x,
        bottom=min_y,
        top=max_y,
        crank_turns=circuit.turns if circuit.full else 0,
        kind=kind,
        cognates=cognates(lengths, place),
        cusps=cusps(circuit, place, sharp) or None,
        crossings=None if sampled else crossings(circuit, place) or None,
        straight=straight,
        deviation=off,
        pieces=sum(len(getattr(piece, "points", (0, 0))) - 1 for piece in outline.pieces) if outline else 0,
        shape=Drawing((outline,), "coupler curve") if outline else None,
        points=columns(circuit, place, points),
        checks=(Check("deviation is within the tolerance", off <= tolerance, off, tolerance),) if outline else (),
        advice=closeness(lengths, kind) + (NOWHERE if straight == () else ()),
        numerics=Numerics(
            "trapezoid rule doubled until it settles; extremes by bisection; deviation by disc arithmetic",
            (ErrorBound("length", error, relative=False),),
        ),
    )


def _straight(circuit: "Circuit", point: complex, within: float) -> "tuple[Straight, ...]":
    from dynamics_cli.linkage.fourbar.straight import straightest

    part = straightest(circuit, point, within)
    return () if part is None else (part,)


def cognates(lengths: "tuple[float, ...]", point: complex) -> "tuple[Cognate, ...]":
    """The two other four-bars of Roberts and Chebyshev; a link of length zero where the point lies on a pin."""
    a, b, c, d = lengths
    from_a, from_b = point / b, 1.0 - point / b
    third = (from_a.real * d, from_a.imag * d)
    result = []
    for name, scale, links, pivot, arm in (
        ("left, at O₂", from_a, (b, a, c, d), (0.0, 0.0), a),
        ("right, at O₄", from_b, (b, c, a, d), (d, 0.0), c),
    ):
        size = abs(scale)
        place = arm * size / scale if size else complex(arm)
        ground_, crank_, three, four = (size * link for link in links)
        result.append(Cognate(name, ground_, crank_, three, four, pivot, third, (place.real, place.imag)))
    return tuple(result)
