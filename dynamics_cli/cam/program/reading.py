"""Programs of cam motion, from records in a file or from one line of text, converted to a `Motion`.

Conventions: a task's first parameter is `scene: Program, /`, and `program: Text = ""` is one of its options;
`motion_of(scene, program)` reads whichever of the two is given.
"""

from math import fsum, pi

from dynamics_cli.cam.laws.normalised import Law, law_named
from dynamics_cli.cam.program.motion import Motion
from dynamics_cli.cam.program.parts import Exact, Span, from_radians, radians
from dynamics_cli.cam.program.segments import LARGEST, SMALLEST, Move, Point, Program, Segment, Step
from dynamics_cli.errors import require
from dynamics_cli.quantities import Angle, Coordinate

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

DEGREE = pi / 180.0
FULL: Exact = (360, 1)
# Spans in radians, or with many digits, cannot sum to a turn exactly; within this tolerance the last one is adjusted.
CLOSED_WITHIN = 1e-9
SHORTEST = 1e-9

__all__ = ["Move", "Point", "Program", "Segment", "exact_degrees", "motion_of", "program_of"]


def motion_of(scene: Program, program: str = "") -> Motion:
    """Give the motion of a program, from records or from one line of text.

    `scene`: records, without segments if a line is given; `program`: segments separated by semicolons: `rise 20 mm in
    90 deg cycloidal; dwell 60 deg; return in 90 deg 3-4-5; dwell`. Returns the motion, closed over one turn. Raises
    InadmissibleError when no program or two are given, its words are not understood, its spans do not make one turn, it
    does not return to its start, or a law lacks an input.

    Spans are kept as exact numbers of degrees: those of records are converted back from radians to the shortest decimal
    that gives the same double.

    Examples
    --------
    >>> motion_of(Program(), "rise 20 mm in 90 deg; dwell 60 deg; return in 90 deg; dwell").joints[-1]
    6.283185307179586
    """
    require(
        bool(scene.segments) != bool(program.strip()),
        "two programs are given, segments and --program" if scene.segments else "no program is given",
        code="program",
        hint='give a file or --program "rise 20 mm in 90 deg cycloidal; dwell 60 deg; return in 90 deg; dwell"',
    )
    start = exact_degrees(scene.start)
    if scene.segments:
        steps = [Step(item, None if item.span is None else exact_degrees(item.span)) for item in scene.segments]
    else:
        from dynamics_cli.cam.program.text import read_program

        steps, written_start = read_program(program)
        start = written_start or start
    return _joined(steps, start)


def program_of(line: str) -> Program:
    """Give the records of a program written in one line.

    Returns its segments, with spans in radians. Raises UsageError where a clause is not understood.

    Examples
    --------
    >>> len(program_of("rise 20 mm in 90 deg; dwell 60 deg; return in 90 deg; dwell").segments)
    4
    """
    from dynamics_cli.cam.program.text import read_program

    steps, start = read_program(line)
    swing = _swings(steps)
    levels = _levels(steps, swing)
    segments = []
    for i, step in enumerate(steps):
        fields = {name: getattr(step.segment, name) for name in Segment.fields}  # type: ignore[attr-defined]
        fields["span"] = None if step.span is None else radians(step.span)[0]
        if step.level is not None:
            fields["swing" if swing else "lift"] = abs(levels[i + 1] - levels[i])
        segments.append(Segment(**fields))
    return Program(tuple(segments), 0.0 if start is None else radians(start)[0])


def exact_degrees(angle: float) -> "Exact":
    """The degrees that a user wrote for this double in radians: the shortest decimal that gives it."""
    degrees = angle * (180.0 / pi)
    for parts in (1, 60, 3600):
        for digits in (6, 10, 15):
            top, bottom = _decimal(f"{degrees * parts:.{digits}g}")
            off = abs(radians((top, bottom * parts))[0] - angle)
            # With up to ten digits one rounding of an earlier conversion is tolerated.
            if off == 0.0 or (digits <= 10 and off <= 2.0**-52 * abs(angle)):
                return top, bottom * parts
    top, bottom = angle.as_integer_ratio()
    return from_radians((top, bottom))


def _decimal(text: str) -> "Exact":
    mantissa, _, exponent = text.partition("e")
    integer, _, tail = mantissa.partition(".")
    power = int(exponent or 0) - len(tail)
    top = int(integer + tail)
    return (top * 10**power, 1) if power >= 0 else (top, 10**-power)


def _plus(a: "Exact", b: "Exact", sign: int = 1) -> "Exact":
    from math import gcd

    top, bottom = a[0] * b[1] + sign * b[0] * a[1], a[1] * b[1]
    common = gcd(top, bottom)
    return top // common, bottom // common


def _spans(steps: "Sequence[Step]") -> "list[Exact]":
    """Every segment's span; the segment without one gets the rest of the turn."""
    total: Exact = (0, 1)
    for number, step in enumerate(steps, 1):
        if step.span is not None:
            width = step.span[0] / step.span[1]
            require(
                width >= SHORTEST * 360.0,
                "segment {number} spans {width}; wanted a positive span of at least {least:2}",
                number=number,
                width=(width * DEGREE, Angle),
                least=(SHORTEST * 2.0 * pi, Angle),
                code="span",
            )
            total = _plus(total, step.span)
    open_ = [i for i, step in enumerate(steps) if step.span is None]
    remainder = _plus(FULL, total, -1)
    rest = remainder[0] / remainder[1]
    require(
        len(open_) <= 1,
        "segments {numbers} give no span; only one segment can take the rest of the turn",
        numbers=", ".join(str(i + 1) for i in open_),
        code="span",
    )
    spans = [step.span or remainder for step in steps]
    if open_:
        require(
            rest > CLOSED_WITHIN,
            "the spans sum to {sum:10}: no angle remains for segment {number}",
            sum=((360.0 - rest) * DEGREE, Angle),
            number=open_[0] + 1,
            code="turn",
            hint="leave it out" if abs(rest) <= CLOSED_WITHIN else "shorten the others by {over:6}",
            over=((SHORTEST * 360.0 - rest) * DEGREE, Angle),
        )
        return spans
    require(
        abs(rest) <= CLOSED_WITHIN,
        "the spans sum to {sum:10}, {off:6} {side} a turn",
        sum=((360.0 - rest) * DEGREE, Angle),
        off=(abs(rest) * DEGREE, Angle),
        side="short of" if rest > 0.0 else "over",
        code="turn",
        hint="add a dwell of {off:6}" if rest > 0.0 else "shorten the segments by {off:6}",
    )
    spans[-1] = _plus(spans[-1], remainder)
    return spans


def _joined(steps: "Sequence[Step]", start: "Exact") -> Motion:
    require(bool(steps), "the program has no segments", code="program")
    swing = _swings(steps)
    spans = _spans(steps)
    levels = _levels(steps, swing)
    offs = _offs(steps, levels, swing)
    ends = [start]
    for span in spans:
        ends.append(_plus(ends[-1], span))
    laws = [_law(step.segment, number) for number, step in enumerate(steps, 1)]
    joined = []
    for i, step in enumerate(steps):
        law, scale = laws[i], None
        segment = step.segment
        if segment.move != "dwell" and law is None:
            from dynamics_cli.cam.program.fitting import fitted

            width = radians(spans[i])[0]
            law, scale = fitted(i, steps, levels, [radians(span)[0] for span in spans], laws, width)
        off = (offs[i], offs[i + 1])
        joined.append(Span(ends[i], ends[i + 1], levels[i], levels[i + 1], law, str(segment.move), scale, off))
    return Motion(joined, swing=swing)


def _swings(steps: "Sequence[Step]") -> bool:
    swings = [step.segment.swing is not None for step in steps]
    lifts = [step.segment.lift is not None for step in steps]
    require(
        not (any(swings) and any(lifts)),
        "the program has lifts and swings: a follower slides or oscillates, not both",
        code="swing",
        hint="write all as lengths, or all as angles",
    )
    return any(swings)


def _levels(steps: "Sequence[Step]", swing: bool) -> "list[float]":
    levels = [0.0]
    for number, step in enumerate(steps, 1):
        segment = step.segment
        amount = segment.swing if swing else segment.lift
        now = levels[-1]
        if segment.move == "dwell":
            require(
                amount is None and step.level is None,
                "segment {number} is a dwell and has a lift",
                number=number,
                code="dwell",
                hint="leave the lift out, or make it a rise",
            )
            levels.append(now)
            continue
        require(
            amount is not None or step.level is not None or segment.move == "return",
            "segment {number} is a rise without a lift",
            number=number,
            code="lift",
            hint="give its lift, for example rise 20 mm",
        )
        require(
            amount is None or amount > 0.0,
            "segment {number}: the {move} has a lift of {amount}; wanted a positive lift",
            number=number,
            move=segment.move,
            amount=_level(amount or 0.0, swing),
            code="lift",
        )
        levels.append(_next_level(now, step, amount, number, swing))
    _require_closed(levels, swing)
    levels[-1] = 0.0
    return levels


def _next_level(now: float, step: Step, amount: float | None, number: int, swing: bool) -> float:
    rising = step.segment.move == "rise"
    if amount is not None:
        then = now + amount if rising else now - amount
        # 20 mm up, 5 mm and 15 mm down must end at the start although the doubles do not sum to zero.
        return 0.0 if abs(then) <= 1e-12 * max(now, amount) else then
    then = 0.0 if step.level is None else step.level
    require(
        then > now if rising else then < now,
        "segment {number} is a {move} from {now:6} to {then:6}",
        number=number,
        move=step.segment.move,
        now=_level(now, swing),
        then=_level(then, swing),
        code="lift",
        hint="a dwell stays, a rise goes up and a return goes down",
    )
    return then


def _offs(steps: "Sequence[Step]", levels: "list[float]", swing: bool) -> "list[float]":
    """Errors of levels against the sums of the given lifts, which are doubles, and of lifts against the levels."""
    offs, lifts = [0.0], [0.0]
    for step, level in zip(steps, levels[1:], strict=True):
        amount = step.segment.swing if swing else step.segment.lift
        if amount is None:
            # the previous level, or a given one: zero for a return without one
            lifts = [level] if step.segment.move != "dwell" else lifts
        else:
            lifts.append(amount if step.segment.move == "rise" else -amount)
        offs.append(abs(fsum((*lifts, -level))) * (1.0 + 2.0**-50))
    return offs


def _level(level: float, swing: bool) -> "tuple[float, Any]":
    """A level with its kind, for messages."""
    return level, Angle if swing else Coordinate


def _require_closed(levels: "list[float]", swing: bool) -> None:
    most = max(abs(level) for level in levels)
    require(most == 0.0 or SMALLEST < most < LARGEST, "a lift is outside the range of any cam", code="range")
    require(
        abs(levels[-1]) <= 1e-12 * most,
        "the program ends {gap:6} from where it began: the cam would have a step",
        gap=_level(levels[-1], swing),
        code="not-closed",
        hint="add a return" if levels[-1] > 0.0 else "add a rise",
    )


def _law(segment: Segment, number: int) -> "Law | None":
    """The law by its name, or None if it depends on the neighbours."""
    if segment.move == "dwell":
        require(segment.law is None, "segment {number} is a dwell and has a law", number=number, code="dwell")
        return None
    name = segment.law or "3-4-5"
    fits = name in ("polynomial", "spline")
    states = (segment.start_velocity, segment.end_velocity, segment.start_acceleration, segment.end_acceleration)
    require(
        fits or all(state is None for state in states),
        "segment {number}: the law {name} has fixed velocities and accelerations at its ends",
        number=number,
        name=name,
        code="law",
        hint="take the law polynomial",
    )
    require(
        name == "spline" or not segment.points,
        "segment {number}: the law {name} takes no points",
        number=number,
        name=name,
        code="law",
    )
    require(
        name == "polynomial" or segment.degree is None,
        "segment {number}: the law {name} has no degree",
        number=number,
        name=name,
        code="law",
    )
    return None if fits else law_named(name, segment.shares or None, segment.constant)
