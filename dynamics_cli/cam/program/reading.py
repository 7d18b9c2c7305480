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
    """The motion of a program, from records or from one line of text.

    `scene`: records, without segments if a line is given; `program`: segments separated by semicolons, as in `rise 20
    mm in 90 deg cycloidal; dwell 60 deg; return in 90 deg 3-4-5; dwell`. The motion is closed over one turn. Raises
    InadmissibleError when there is no program or more than one, when a clause cannot be read, when the spans do not add
    up to one turn, when the follower does not return to its start, or when a law lacks an input.

    Spans are exact numbers of degrees. Those of records arrive in radians and are converted back to the shortest
    decimal that gives the same double.

    Examples
    --------
    >>> motion_of(Program(), "rise 20 mm in 90 deg; dwell 60 deg; return in 90 deg; dwell").joints[-1]
    6.283185307179586
    """
    given = bool(scene.segments) + bool(program.strip()) + bool(scene.lifts)
    require(given <= 1, "of segments, --program and --lifts one is wanted", code="program", hint="leave the others out")
    require(
        given == 1,
        "no program is given",
        code="program",
        hint='give a file or --program "rise 20 mm in 90 deg cycloidal; dwell 60 deg; return in 90 deg; dwell"',
    )
    if scene.lifts:
        from dynamics_cli.cam.program.lift_table import motion_of_table

        return motion_of_table(scene.lifts)
    start = exact_degrees(scene.start)
    if scene.segments:
        steps = [Step(item, None if item.span is None else exact_degrees(item.span)) for item in scene.segments]
    else:
        from dynamics_cli.cam.program.text import read_program

        steps, written_start = read_program(program)
        start = written_start or start
    return _motion(steps, start)


def program_of(line: str) -> Program:
    """The records of a program written in one line, with spans in radians.

    Raises UsageError when a clause cannot be read.

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
    """The degrees behind an angle in radians: the shortest decimal that gives the same double."""
    degrees = angle * (180.0 / pi)
    for parts in (1, 60, 3600):
        for digits in (6, 10, 15):
            top, bottom = _decimal(f"{degrees * parts:.{digits}g}")
            error = abs(radians((top, bottom * parts))[0] - angle)
            # With up to ten digits one rounding of an earlier conversion is tolerated.
            if error == 0.0 or (digits <= 10 and error <= 2.0**-52 * abs(angle)):
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
    """The span of every segment; a segment without one takes the remainder of the turn."""
    total: Exact = (0, 1)
    for number, step in enumerate(steps, 1):
        if step.span is not None:
            width = step.span[0] / step.span[1]
            require(
                width >= SHORTEST * 360.0,
                "segment {number}: the span of {width} is too small; the minimum is {least:2}",
                number=number,
                width=(width * DEGREE, Angle),
                least=(SHORTEST * 2.0 * pi, Angle),
                code="span",
            )
            total = _plus(total, step.span)
    unspanned = [i for i, step in enumerate(steps) if step.span is None]
    remainder = _plus(FULL, total, -1)
    remaining = remainder[0] / remainder[1]
    require(
        len(unspanned) <= 1,
        "segments {numbers} have no span; only one segment can take the remainder of the turn",
        numbers=", ".join(str(i + 1) for i in unspanned),
        code="span",
    )
    spans = [step.span or remainder for step in steps]
    if unspanned:
        require(
            remaining > CLOSED_WITHIN,
            "the spans add up to {sum:10}: no angle remains for segment {number}",
            sum=((360.0 - remaining) * DEGREE, Angle),
            number=unspanned[0] + 1,
            code="turn",
            hint="leave it out" if abs(remaining) <= CLOSED_WITHIN else "shorten the others by {over:6}",
            over=((SHORTEST * 360.0 - remaining) * DEGREE, Angle),
        )
        return spans
    require(
        abs(remaining) <= CLOSED_WITHIN,
        "the spans add up to {sum:10}, {difference:6} {side} one turn",
        sum=((360.0 - remaining) * DEGREE, Angle),
        difference=(abs(remaining) * DEGREE, Angle),
        side="short of" if remaining > 0.0 else "over",
        code="turn",
        hint="add a dwell of {difference:6}" if remaining > 0.0 else "shorten the segments by {difference:6}",
    )
    spans[-1] = _plus(spans[-1], remainder)
    return spans


def _motion(steps: "Sequence[Step]", start: "Exact") -> Motion:
    require(bool(steps), "the program has no segments", code="program")
    swing = _swings(steps)
    spans = _spans(steps)
    levels = _levels(steps, swing)
    errors = _level_errors(steps, levels, swing)
    ends = [start]
    for span in spans:
        ends.append(_plus(ends[-1], span))
    laws = [_law(step.segment, number) for number, step in enumerate(steps, 1)]
    program = []
    for i, step in enumerate(steps):
        law, scale = laws[i], None
        segment = step.segment
        if segment.move != "dwell" and law is None:
            from dynamics_cli.cam.program.fitting import fitted

            width = radians(spans[i])[0]
            law, scale = fitted(i, steps, levels, [radians(span)[0] for span in spans], laws, width)
        level_errors = (errors[i], errors[i + 1])
        program.append(
            Span(ends[i], ends[i + 1], levels[i], levels[i + 1], law, str(segment.move), scale, level_errors)
        )
    return Motion(program, swing=swing)


def _swings(steps: "Sequence[Step]") -> bool:
    swings = [step.segment.swing is not None for step in steps]
    lifts = [step.segment.lift is not None for step in steps]
    require(
        not (any(swings) and any(lifts)),
        "the program has both lifts and swings: a follower either slides or oscillates",
        code="swing",
        hint="write all of them as lengths, or all as angles; `in` goes before the angle turned: return in 90 deg",
    )
    return any(swings)


def _levels(steps: "Sequence[Step]", swing: bool) -> "list[float]":
    levels = [0.0]
    for number, step in enumerate(steps, 1):
        segment = step.segment
        amount = segment.swing if swing else segment.lift
        level = levels[-1]
        if segment.move == "dwell":
            require(
                amount is None and step.level is None,
                "segment {number} is a dwell, which has no lift",
                number=number,
                code="dwell",
                hint="leave the lift out, or make it a rise",
            )
            levels.append(level)
            continue
        require(
            amount is not None or step.level is not None or segment.move == "return",
            "segment {number}: the rise has no lift",
            number=number,
            code="lift",
            hint="give the lift, for example rise 20 mm",
        )
        require(
            amount is None or amount > 0.0,
            "segment {number}: the lift of the {move} is {amount}; it must be positive",
            number=number,
            move=segment.move,
            amount=_level(amount or 0.0, swing),
            code="lift",
        )
        levels.append(_next_level(level, step, amount, number, swing))
    _require_closed(levels, swing)
    levels[-1] = 0.0
    return levels


def _next_level(level: float, step: Step, amount: float | None, number: int, swing: bool) -> float:
    rising = step.segment.move == "rise"
    if amount is not None:
        end = level + amount if rising else level - amount
        # 20 mm up, 5 mm and 15 mm down must end at the start although the doubles do not sum to zero.
        return 0.0 if abs(end) <= 1e-12 * max(level, amount) else end
    end = 0.0 if step.level is None else step.level
    require(
        end > level if rising else end < level,
        "segment {number}: a {move} cannot go from {start:6} to {end:6}",
        number=number,
        move=step.segment.move,
        start=_level(level, swing),
        end=_level(end, swing),
        code="lift",
        hint="a rise goes up, a return goes down, a dwell stays",
    )
    return end


def _level_errors(steps: "Sequence[Step]", levels: "list[float]", swing: bool) -> "list[float]":
    """Rounding errors of the levels, against exact sums of the given lifts."""
    errors, lifts = [0.0], [0.0]
    for step, level in zip(steps, levels[1:], strict=True):
        amount = step.segment.swing if swing else step.segment.lift
        if amount is None:
            # a dwell stays; any other move sets a level, and a return without one goes to zero
            lifts = [level] if step.segment.move != "dwell" else lifts
        else:
            lifts.append(amount if step.segment.move == "rise" else -amount)
        errors.append(abs(fsum((*lifts, -level))) * (1.0 + 2.0**-50))
    return errors


def _level(level: float, swing: bool) -> "tuple[float, Any]":
    """A level with its kind, for messages."""
    return level, Angle if swing else Coordinate


def _require_closed(levels: "list[float]", swing: bool) -> None:
    highest = max(abs(level) for level in levels)
    require(
        highest == 0.0 or SMALLEST < highest < LARGEST,
        "the lift of {lift} is outside the range of {least} to {most}",
        lift=_level(highest, swing),
        least=_level(SMALLEST, swing),
        most=_level(LARGEST, swing),
        code="range",
    )
    require(
        abs(levels[-1]) <= 1e-12 * highest,
        "the program ends {gap:6} from its start: the cam would have a step",
        gap=_level(levels[-1], swing),
        code="not-closed",
        hint="add a return" if levels[-1] > 0.0 else "add a rise",
    )


def _law(segment: Segment, number: int) -> "Law | None":
    """The law of a segment, or None if it depends on the neighbouring segments."""
    if segment.move == "dwell":
        require(
            segment.law is None,
            "segment {number} is a dwell, which has no law",
            number=number,
            code="dwell",
            hint="leave the law out",
        )
        return None
    name = segment.law or "3-4-5"
    fitted = name in ("polynomial", "spline")
    states = (segment.start_velocity, segment.end_velocity, segment.start_acceleration, segment.end_acceleration)
    require(
        fitted or all(state is None for state in states),
        "segment {number}: the {name} law has fixed velocities and accelerations at its ends",
        number=number,
        name=name,
        code="law",
        hint="use the polynomial law",
    )
    require(
        name == "spline" or not segment.points,
        "segment {number}: the {name} law does not take points",
        number=number,
        name=name,
        code="law",
        hint="use the spline law",
    )
    require(
        name == "polynomial" or segment.degree is None,
        "segment {number}: the {name} law has no degree",
        number=number,
        name=name,
        code="law",
        hint="use the polynomial law",
    )
    return None if fitted else law_named(name, segment.shares or None, segment.constant)
