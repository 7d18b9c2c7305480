"""Grashof's rule on the decimals as typed: class, limits, swing, time ratio, change points."""

from dynamics_cli.linkage.fourbar.closure import Frame, frame
from dynamics_cli.linkage.fourbar.lengths import LINKS, margin, require_links
from dynamics_cli.numerics.elementary import absolute, atan2, maximum, pi_beside, sqrt
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Angle, Annotated, Coordinate, Ratio, Size, Text
from dynamics_cli.records import Advice, Check, record

# A margin below this share of the perimeter is nearly a change point: play decides the motion.
NEARLY = 1e-3
# Transmission angles nearer than this to 0 or 180 degrees are poor in a machine (the usual 40 degrees).
POOR = 0.6981317007977318
TURNS = {"crank": "crank-rocker", "coupler": "double rocker", "rocker": "rocker-crank", "ground": "double crank"}


@record
class ChangePoint:
    """A pose with all four links in line, where the motion can continue in two ways."""

    crank_angle: Annotated[Angle, "Crank angle there, 0 or 180 degrees [rad]."]
    coupler_angle: Annotated[Angle, "Coupler angle there [rad]."]
    rocker_angle: Annotated[Angle, "Rocker angle there [rad]."]
    first_coupler_ratio: Annotated[Ratio | None, "ω₃/ω₂ of one continuation."]
    first_rocker_ratio: Annotated[Ratio | None, "ω₄/ω₂ of it."]
    second_coupler_ratio: Annotated[Ratio | None, "ω₃/ω₂ of the other continuation."]
    second_rocker_ratio: Annotated[Ratio | None, "ω₄/ω₂ of it."]


@record
class Class:
    """The class of a four-bar and its limits."""

    kind: Annotated[Text, "The class by Grashof's rule, on the decimals as typed."]
    margin: Annotated[Coordinate, "Longest and shortest link together fall short of the other two by this [m]."]
    rotates: Annotated[Text, "Which links turn fully."]
    outer_limit: Annotated[Angle | None, "The crank stays within ± this angle, or passes [rad]."]
    inner_limit: Annotated[Angle | None, "The crank stays beyond ± this angle, or passes [rad]."]
    swing: Annotated[Angle | None, "Angle through which the rocker swings; none if it turns fully [rad]."]
    rocker_least: Annotated[Angle | None, "Smallest rocker angle, of the half above the ground link [rad]."]
    rocker_greatest: Annotated[Angle | None, "Largest rocker angle there [rad]."]
    extended_at: Annotated[Angle | None, "Crank angle with crank and coupler stretched, open branch [rad]."]
    folded_at: Annotated[Angle | None, "Crank angle with crank and coupler folded, open branch [rad]."]
    time_ratio: Annotated[Ratio | None, "Time of the slow stroke over that of the quick one, crank at uniform speed."]
    least_transmission_angle: Annotated[Angle, "Smallest transmission angle μ [rad]."]
    greatest_transmission_angle: Annotated[Angle, "Largest transmission angle μ [rad]."]
    change_points: Annotated[
        tuple[ChangePoint, ...] | None, "Poses with all links in line; most linkages have none."
    ] = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def kind_of(lengths: "tuple[float, ...]") -> str:
    """The class by Grashof's rule, decided on the decimals as typed."""
    a, b, c, d = lengths = tuple(map(plain, lengths))
    order = _by_length(lengths)
    if margin((-1, -1, -1, 1), [lengths[i] for i in order]) == 0.0:
        return "a straight line that cannot move"
    spare = _margin(lengths)
    if spare > 0.0:
        return TURNS[LINKS[order[0]]]
    if spare < 0.0:
        return f"triple rocker, longest link the {LINKS[order[3]]}"
    if a == b == c == d:
        return "change point, rhombus"
    if a == c and b == d:
        return "change point, parallelogram"
    if (a == b and c == d) or (b == c and a == d):
        return "change point, kite"
    return f"change point, shortest link the {LINKS[order[0]]}"


def limits(links: Frame) -> "tuple[float | None, float | None]":
    """Crank angles of the outer and the inner limit, where there are any."""
    a, b, c, d = links.lengths
    outer = inner = None
    if links.outer < 0.0:
        near = (b + c - links.apart) * (b + c + links.apart)
        outer = 2.0 * atan2(sqrt(near), sqrt(-links.outer * (a + b + c + d)))
    if links.inner < 0.0:
        gap = absolute(links.slim)
        inner = 2.0 * atan2(sqrt(-links.inner * (gap + links.apart)), sqrt((a + d - gap) * (a + d + gap)))
    return outer, inner


def classify(
    *,
    crank: Annotated[Size, "Length a of the driving link, from O₂ to A, e.g. 40 mm."],
    coupler: Annotated[Size, "Length b of the link between the pins A and B, e.g. 120 mm."],
    rocker: Annotated[Size, "Length c of the driven link, from O₄ to B, e.g. 80 mm."],
    ground: Annotated[Size, "Distance d of the pivots O₂ and O₄, e.g. 100 mm."],
) -> Class:
    """Class of a four-bar by Grashof's rule, its limits, swing, time ratio, transmission angles and change points.

    Equation
    --------
    s + l < p + q: the shortest link s turns fully; =: change point; >: none turns. Limits where b + c or |b − c| is the
    distance A–O₄; time ratio (φ_f − φ_e)/(2π − (φ_f − φ_e)) from the crank angles of the rocker's ends. At a change
    point of signed lengths a + b = d + c: ω₃/ω₂ = (ab ± √(abcd))/(b(c − b)), ω₄/ω₂ = (a + b·ω₃/ω₂)/c.

    Raises
    ------
    InadmissibleError
        When a length is not above zero or one is longer than the other three together.

    Notes
    -----
    Equality is decided on the decimals as typed: 0.1, 0.5, 0.3 and 0.7 m are a change point, though
    the sums of their doubles differ. Uncertain lengths are judged at their nominal values.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 5.5; Grashof, Theoretische Maschinenlehre,
    1883.

    Examples
    --------
    >>> classify(crank=0.1, coupler=0.5, rocker=0.3, ground=0.7).kind
    'change point, shortest link the crank'
    """
    require_links(crank, coupler, rocker, ground)
    lengths = (crank, coupler, rocker, ground)
    links, kind = frame(*lengths), kind_of(lengths)
    outer, inner = limits(links)
    least_angle, greatest_angle, swing = rocking(lengths)
    ends = _ends(lengths, kind)
    time_ratio = None
    if ends is not None:
        forward = absolute(ends[1] - ends[0])
        back = 2.0 * pi_beside(forward) - forward
        time_ratio = forward / back if forward >= back else back / forward
    least, greatest = transmission(links)
    return Class(
        kind=kind,
        margin=_margin(lengths),
        rotates=_rotates(kind),
        outer_limit=outer,
        inner_limit=inner,
        swing=swing,
        rocker_least=least_angle,
        rocker_greatest=greatest_angle,
        extended_at=ends and ends[0],
        folded_at=ends and ends[1],
        time_ratio=time_ratio,
        least_transmission_angle=least,
        greatest_transmission_angle=greatest,
        change_points=tuple(change_points(lengths)) or None,
        advice=closeness(lengths, kind),
    )


def _margin(lengths: "tuple[float, ...]") -> float:
    return margin((-1, 1, 1, -1), [lengths[i] for i in _by_length(lengths)])


def _by_length(lengths: "tuple[float, ...]") -> "list[int]":
    """The links from the shortest to the longest."""
    return sorted(range(4), key=lambda i: plain(lengths[i]))


def _rotates(kind: str) -> str:
    if kind == "double crank":
        return "crank, coupler and rocker"
    if kind in TURNS.values():
        return {"crank-rocker": "crank", "double rocker": "coupler", "rocker-crank": "rocker"}[kind]
    return "all that pass the change points" if kind.startswith("change") else "none"


def rocking(lengths: "tuple[float, ...]") -> "tuple[float | None, float | None, float | None]":
    """Rocker angles at its limits above the ground link, and the swing: the same limits with the roles changed."""
    a, b, c, d = lengths
    links = frame(c, b, a, d)
    outer, inner = limits(links)
    pi = pi_beside(a, b, c, d)
    least = None if outer is None else pi - outer
    greatest = None if inner is None else pi - inner
    if least is not None and greatest is not None:
        return least, greatest, greatest - least
    if least is not None and outer is not None:
        return least, None, 2.0 * outer
    return None, greatest, None if greatest is None else 2.0 * greatest


def _ends(lengths: "tuple[float, ...]", kind: str) -> "tuple[float, float] | None":
    """Crank angles at the ends of the rocker's swing, of a crank that turns fully, on the open branch."""
    if kind != "crank-rocker":
        return None
    return _flat_triangle((1, 1, 1, 1), lengths), pi_beside(*lengths) + _flat_triangle((-1, 1, 1, 1), lengths)


def _flat_triangle(signs: "tuple[int, ...]", lengths: "tuple[float, ...]") -> float:
    """Angle opposite the rocker where crank and coupler are in line, the crank's sign first; by margins as typed.

    Beside a change point doubles would take a flat triangle for one that cannot close.
    """
    a, b, _, d = signs

    def of(crank: int, coupler: int, rocker: int, ground: int) -> float:
        return margin((crank, coupler, rocker, ground), lengths)

    near = of(-a, -b, 1, d) * of(a, b, 1, -d)
    far = of(a, b, -1, d) * of(a, b, 1, d)
    return 2.0 * atan2(sqrt(near), sqrt(far))


def transmission(links: Frame) -> "tuple[float, float]":
    """Smallest and largest transmission angle over all crank angles that can be reached."""
    a, b, c, d = links.lengths
    pi = pi_beside(a, b, c, d)
    gap = absolute(links.slim)
    least, greatest = 0.0 * a, pi + 0.0 * a
    inner, outer = _not_below_zero(links.inner), _not_below_zero(links.outer)
    if inner is not None:
        second, first = inner * (links.apart + gap), (b + c - links.apart) * (b + c + links.apart)
        least = 2.0 * atan2(sqrt(second), sqrt(first))
    if outer is not None:
        first, second = outer * (a + b + c + d), (a + d - gap) * (a + d + gap)
        greatest = 2.0 * atan2(sqrt(second), sqrt(first))
    return least, greatest


def _not_below_zero(number: float) -> float | None:
    """A margin that is zero or more, or may be by its own bound; None where it is below."""
    reach = getattr(number, "error", 0.0)
    return maximum(number, 0.0) if number + reach >= 0.0 else None


def change_points(lengths: "tuple[float, ...]") -> "list[ChangePoint]":
    """Every pose in one line, with both continuations; with none where the pose cannot move."""
    a, b, c, d = lengths
    pi = pi_beside(a, b, c, d)
    points = []
    for i in (1, -1):
        for j in (1, -1):
            for k in (1, -1):
                if (i, j, k) == (-1, -1, 1) or margin((i, j, -k, -1), lengths) != 0.0:
                    continue
                first_link, second_link, third_link = i * a, j * b, k * c
                first, second = _continuations(first_link, second_link, third_link, d)
                angles = [0.0 if sign > 0 else pi for sign in (i, j, k)]
                points.append(ChangePoint(*angles, *(first or (None, None)), *(second or (None, None))))
    return points


def _continuations(
    a: float, b: float, c: float, d: float
) -> "tuple[tuple[float, float] | None, tuple[float, float] | None]":
    """Speed ratios of both continuations at a pose of signed lengths a + b = d + c."""
    discriminant = a * b * (c * d)
    if discriminant < 0.0:
        return None, None
    apart = c - b
    if apart == 0.0:
        # one continuation alone drives the crank; in the other the crank stays while B turns about A and O₄
        coupler = (c - a) / (2.0 * b)
        return (coupler, (a + b * coupler) / c), None
    root = sqrt(discriminant)
    motions = []
    for sign in (1.0, -1.0):
        coupler = (a * b + sign * root) / (b * apart)
        motions.append((coupler, (a + b * coupler) / c))
    return motions[0], motions[1]


def closeness(lengths: "tuple[float, ...]", kind: str) -> "tuple[Advice, ...]":
    """Advice on a linkage at, or near, a change point."""
    if kind.startswith("change"):
        return (
            Advice(
                "change-point",
                "at a change point the linkage can slip into its other motion: answers follow the smooth one",
                remedy="give it a second driver there, for example a flywheel or a parallel crank",
            ),
        )
    short = _margin(lengths)
    if absolute(short) < NEARLY * (lengths[0] + lengths[1] + lengths[2] + lengths[3]):
        return (
            Advice(
                "near-change-point",
                "longest and shortest link nearly equal the other two: play in the pins can change the motion",
                remedy="change a length by more than the play",
            ),
        )
    return ()


def poor(where: str, remedy: str) -> Advice:
    """Remark on a transmission angle far from a right angle."""
    message = f"the transmission angle {where}: friction may lock the linkage"
    return Advice("poor-transmission", message, severity="note", remedy=remedy)
