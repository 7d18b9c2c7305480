"""Laws, polynomials and whole motions: folded, exact at joints and both ends."""

from decimal import Decimal

from dynamics_cli.accuracy.measure import DIGITS

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any

    from dynamics_cli.accuracy.cases import Case
    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.measure import Errors
    from dynamics_cli.accuracy.rows import Row
    from dynamics_cli.cam.laws.normalised import Law

    Values = tuple[float, ...]
    Call = Callable[[], Values]
    # Its values at most, which errors are shares of; and what the program states of its own.
    Sizes = Callable[[Case], Sequence[float]]

FILE = "cam_motion.json"
UNIT = 2.0**-53
NAMES = ("lift", "velocity", "acceleration", "jerk")


def _given(case: "Case") -> "tuple[Law, float, float, float]":
    """Law, lift, span and angle."""
    from dynamics_cli.cam.laws.normalised import law_named

    inputs = case.inputs
    shares = tuple(map(float, inputs.get("shares", ()))) or None
    law = law_named(inputs["law"], shares, float(inputs["constant"]) if "constant" in inputs else None)
    return law, float(inputs["lift"]), float(inputs["span"]), float(inputs["at"])


def _scaled(values: "Sequence[float]", lift: float, span: float) -> "Values":
    """Of a law between 0 and 1."""
    return tuple(lift * value / span**order for order, value in enumerate(values))


def folded(case: "Case") -> "Call":
    """The program's own: each half measured from its own end, in factors."""
    from dynamics_cli.cam.laws.rise import _point

    law, lift, span, at = _given(case)
    scales = [lift / span**order for order in range(4)]

    def answer() -> "Values":
        point = _point(law, at, span, lift, scales, "rising", None)
        return point.lift, point.velocity, point.acceleration, point.jerk

    return answer


def folded_bounds(case: "Case") -> "Values":
    """What the program states of these values."""
    from dynamics_cli.cam.laws.rise import _bounds, _point

    law, lift, span, at = _given(case)
    point = _point(law, at, span, lift, [lift / span**order for order in range(4)], "rising", None)
    return tuple(bound.bound for bound in _bounds(law, (point,), span, lift, None, "rising"))


def peaks(case: "Case") -> "tuple[float, ...]":
    """Greatest finite values of lift and derivatives, which errors are shares of."""
    from dynamics_cli.cam.laws.peaks import extremes

    law, lift, span, _ = _given(case)
    return _scaled([max(abs(value) for _, value in extremes(law, order)) or 1.0 for order in range(4)], lift, span)


def _conditions(case: "Case") -> "tuple[list[tuple[float, int, float]], float]":
    conditions = [(float(place), order, float(value)) for place, order, value in case.inputs["conditions"]]
    return conditions, float(case.inputs["at"])


def by_rationals(case: "Case") -> "Call":
    """The program's own: solved in rationals, expanded about both ends."""
    from dynamics_cli.cam.laws.polynomials import polynomial

    conditions, at = _conditions(case)
    return lambda: polynomial(conditions).at(at)


def polynomial_peaks(case: "Case") -> "list[float]":
    """Greatest values of the polynomial."""
    from dynamics_cli.cam.laws.peaks import extremes
    from dynamics_cli.cam.laws.polynomials import polynomial

    law = polynomial(_conditions(case)[0])
    return [max(abs(value) for _, value in extremes(law, order)) or 1.0 for order in range(4)]


def _motion(case: "Case") -> "tuple[Any, float]":
    from dynamics_cli.cam.program.reading import Program, motion_of

    return motion_of(Program(), case.inputs["program"]), float(case.inputs["theta"])


def by_exact_joints(case: "Case") -> "Call":
    """The program's own: joints in exact degrees, the distance from them with the rounding of π put right."""
    motion, theta = _motion(case)
    return lambda: motion.at(theta)


def motion_peaks(case: "Case") -> "list[float]":
    """Greatest values of the segment's law."""
    from dynamics_cli.cam.laws.normalised import law_named
    from dynamics_cli.cam.laws.peaks import extremes

    law, lift, span = law_named(case.inputs["law"]), float(case.inputs["lift"]), float(case.inputs["span"])
    return [lift * max(abs(value) for _, value in extremes(law, k)) / span**k for k in range(4)]


def polynomial_bounds(case: "Case") -> "list[float]":
    """What the program's polynomial may be off there."""
    from dynamics_cli.cam.laws.peaks import errors_of
    from dynamics_cli.cam.laws.polynomials import polynomial

    conditions, at = _conditions(case)
    law = polynomial(conditions)
    worst = [0.0] * 4
    for piece in law.pieces:
        if piece.low <= at <= piece.high:
            t = 1.0 - at if piece.far else at
            errors = errors_of(piece, t, UNIT * t, 3)
            if piece.far:
                errors[0] += UNIT * (abs(law.total) + abs(piece.shape(t, 0)[0]))
            worst = [max(pair) for pair in zip(worst, errors, strict=True)]
    return worst


def motion_bounds(case: "Case") -> "list[float]":
    """What the program's motion may be off at that angle."""
    import numpy as np

    from dynamics_cli.numerics.tracked import Tracked

    motion, theta = _motion(case)
    worst = [0.0] * 4
    for part, _ in motion.by_parts(np.array([motion.wrapped(theta)])):
        t = abs(part.local(theta)) if part.law_piece is not None else 0.0
        errors = [number.error for number in part.bounded(Tracked(t, 5.0 * UNIT * t, ()), 3)]
        worst = [max(pair) for pair in zip(worst, errors, strict=True)]
    return worst


def _compared(
    comparing: "Comparing", task: str, peaks: "Sizes", bounds: "Sizes", method: "tuple[str, Any]"
) -> "list[Row]":
    """Rows for methods that give lift and derivatives; errors in shares of their peaks."""

    def answer(errors: "Errors", case: "Case", prepare: "Any", _: int) -> "Call":
        call: Call = prepare(case)
        stated = bounds(case) if prepare is method[1] else (None,) * 4
        for name, value, size, bound in zip(NAMES, call(), peaks(case), stated, strict=True):
            off = float(DIGITS.subtract(Decimal(value), Decimal(case.results[name])).copy_abs())
            errors.note(f"{case.name}: {name}", off / size, None if bound is None else bound / size)
        return call

    return comparing.rows([method], comparing.cases(FILE, task=task), answer, most=20)


def compare(comparing: "Comparing") -> "list[Row]":
    """Every law; errors in shares of the law's peak of that derivative."""
    return _compared(comparing, "rise", peaks, folded_bounds, ("folded and factored (chosen)", folded))


def compare_polynomials(comparing: "Comparing") -> "list[Row]":
    """Free polynomials."""
    name = "exact rationals, about both ends (chosen)"
    return _compared(comparing, "polynomial", polynomial_peaks, polynomial_bounds, (name, by_rationals))


def compare_motions(comparing: "Comparing") -> "list[Row]":
    """Whole motions, in shares of the peaks of the segment."""
    name = "joints exact in degrees (chosen)"
    return _compared(comparing, "motion", motion_peaks, motion_bounds, (name, by_exact_joints))
