"""Laws, polynomials and whole motions: folded, exact at joints and both ends, beside one formula in doubles."""

from decimal import Decimal
from math import cos, pi, sin

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
    Sizes = Callable[[Case], Sequence[float]] | None

FILE = "cam_motion.json"
UNIT = 2.0**-53
NAMES = ("lift", "velocity", "acceleration", "jerk")
# The law's powers of x, and its waves a·sin kx and b·cos kx, as textbooks print them.
POWERS: "dict[str, tuple[float, ...]]" = {
    "linear": (0.0, 1.0),
    "cubic": (0.0, 0.0, 3.0, -2.0),
    "3-4-5": (0.0, 0.0, 0.0, 10.0, -15.0, 6.0),
    "4-5-6-7": (0.0, 0.0, 0.0, 0.0, 35.0, -84.0, 70.0, -20.0),
    "5-6-7-8-9": (0.0, 0.0, 0.0, 0.0, 0.0, 126.0, -420.0, 540.0, -315.0, 70.0),
}
WAVES: "dict[str, tuple[tuple[float, ...], tuple[tuple[float, float], ...], tuple[tuple[float, float], ...]]]" = {
    "harmonic": ((0.5,), (), ((-0.5, pi),)),
    "double-harmonic": ((0.375,), (), ((-0.5, pi), (0.125, 2.0 * pi))),
    "cycloidal": ((0.0, 1.0), ((-0.5 / pi, 2.0 * pi),), ()),
    "gutman-1-3": ((0.0, 1.0), ((-15.0 / (32.0 * pi), 2.0 * pi), (-1.0 / (96.0 * pi), 6.0 * pi)), ()),
    "freudenstein-1-3": ((0.0, 1.0), ((-27.0 / (56.0 * pi), 2.0 * pi), (-1.0 / (168.0 * pi), 6.0 * pi)), ()),
    "half-cycloid-start": ((0.0, 1.0), ((-1.0 / pi, pi),), ()),
    "half-cycloid-end": ((0.0, 1.0), ((1.0 / pi, pi),), ()),
    "half-harmonic-start": ((1.0,), (), ((-1.0, 0.5 * pi),)),
    "half-harmonic-end": ((), ((1.0, 0.5 * pi),), ()),
}


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


def expanded(case: "Case") -> "Call":
    """One formula over the whole rise, in powers of x and waves of x; laws of several formulas have none."""
    _, lift, span, at = _given(case)
    name = case.inputs["law"]
    if name not in POWERS and name not in WAVES:
        raise ArithmeticError
    powers, sines, cosines = WAVES.get(name, (POWERS.get(name, ()), (), ()))
    return lambda: _scaled(_one_formula(at / span, powers, sines, cosines), lift, span)


def _one_formula(
    x: float,
    powers: "Sequence[float]",
    sines: "Sequence[tuple[float, float]]",
    cosines: "Sequence[tuple[float, float]]",
) -> "list[float]":
    values = []
    turns: tuple[tuple[Any, Any, float, float], ...] = (
        (sin, cos, 1.0, 1.0), (cos, sin, 1.0, -1.0), (sin, cos, -1.0, -1.0), (cos, sin, -1.0, 1.0),
    )  # fmt: skip
    for order, (first, second, one, two) in enumerate(turns):
        total = 0.0
        for power in range(len(powers) - 1, order - 1, -1):
            factor = powers[power]
            for lower in range(order):
                factor *= power - lower
            total = total * x + factor
        total += sum(one * a * k**order * first(k * x) for a, k in sines)
        total += sum(two * a * k**order * second(k * x) for a, k in cosines)
        values.append(total)
    return values


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
    comparing: "Comparing", task: str, peaks: "Sizes", bounds: "Sizes", *methods: "tuple[str, Any]"
) -> "list[Row]":
    """Rows for methods that give lift and derivatives; errors in shares of their peaks, or relative without."""

    def answer(errors: "Errors", case: "Case", prepare: "Any", _: int) -> "Call":
        call: Call = prepare(case)
        sizes = peaks(case) if peaks else ()
        stated = bounds(case) if bounds and prepare is methods[0][1] else (None,) * 4
        for order, (name, value, bound) in enumerate(zip(NAMES, call(), stated, strict=True)):
            where, text = f"{case.name}: {name}", case.results[name]
            if sizes:
                off = float(DIGITS.subtract(Decimal(value), Decimal(text)).copy_abs())
                errors.note(where, off / sizes[order], None if bound is None else bound / sizes[order])
            elif order < 2:
                errors.add(where, value, text, None)
        return call

    return comparing.rows(methods, comparing.cases(FILE, task=task), answer, most=20)


LAWS = ("folded and factored (chosen)", folded), ("one formula, expanded about zero", expanded)


def compare(comparing: "Comparing") -> "list[Row]":
    """Every method on every law; errors in shares of the law's peak of that derivative."""
    return _compared(comparing, "rise", peaks, folded_bounds, *LAWS)


def compare_relative(comparing: "Comparing") -> "list[Row]":
    """Relative errors of lift and velocity: the digits left of small values at the ends (others vanish in between)."""
    return _compared(comparing, "rise", None, None, *LAWS)


def compare_polynomials(comparing: "Comparing") -> "list[Row]":
    """Free polynomials."""
    return _compared(
        comparing, "polynomial", polynomial_peaks, polynomial_bounds,
        ("exact rationals, about both ends (chosen)", by_rationals),
    )  # fmt: skip


def compare_motions(comparing: "Comparing") -> "list[Row]":
    """Whole motions, in shares of the peaks of the segment."""
    return _compared(
        comparing, "motion", motion_peaks, motion_bounds,
        ("joints exact in degrees (chosen)", by_exact_joints),
    )  # fmt: skip
