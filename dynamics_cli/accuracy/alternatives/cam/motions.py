"""Free polynomials and whole motions: exact rationals and exact joints, beside doubles for both."""

from dynamics_cli.accuracy.alternatives.cam.laws import compared

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.accuracy.alternatives.cam.laws import Answer
    from dynamics_cli.accuracy.cases import Case
    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.rows import Row


def _conditions(case: "Case") -> "tuple[list[tuple[float, int, float]], float]":
    found = [(float(place), order, float(value)) for place, order, value in case.inputs["conditions"]]
    return found, float(case.inputs["at"])


def by_rationals(case: "Case") -> "Callable[[], Any]":
    """The program's own: solved in rationals, expanded about both ends."""
    from dynamics_cli.cam.laws.polynomials import polynomial

    conditions, at = _conditions(case)
    return lambda: polynomial(conditions).at(at)


def by_doubles(case: "Case") -> "Callable[[], Any]":
    """The system of powers of x solved in doubles, and the polynomial about zero."""
    import numpy as np

    conditions, at = _conditions(case)

    def answer() -> "Any":
        count = len(conditions)
        rows = np.array([[_power(x, i, order) for i in range(count)] for x, order, _ in conditions])
        coefficients = np.linalg.solve(rows, np.array([value for _, _, value in conditions]))
        return tuple(float(sum(coefficients[i] * _power(at, i, order) for i in range(count))) for order in range(4))

    return answer


def by_bernstein(case: "Case") -> "Callable[[], Any]":
    """Bernstein's basis on the whole rise, its system solved in doubles."""
    from math import comb

    import numpy as np

    conditions, at = _conditions(case)
    degree = len(conditions) - 1

    def value(x: float, order: int) -> "Any":
        # derivatives of the basis are differences of the basis of a lower degree
        low = degree - order
        row = np.array([comb(low, k) * x**k * (1.0 - x) ** (low - k) for k in range(low + 1)])
        for step in range(order):
            row = (low + step + 1) * (np.append(0.0, row) - np.append(row, 0.0))
        return row

    def answer() -> "Any":
        rows = np.array([value(x, order) for x, order, _ in conditions])
        coefficients = np.linalg.solve(rows, np.array([wanted for _, _, wanted in conditions]))
        return tuple(float(value(at, order) @ coefficients) if order <= degree else 0.0 for order in range(4))

    return answer


def _power(x: float, power: int, order: int) -> float:
    if power < order:
        return 0.0
    factor = 1.0
    for lower in range(order):
        factor *= power - lower
    return factor * x ** (power - order)


def polynomial_peaks(case: "Case") -> "list[float]":
    """Greatest values of the polynomial."""
    from dynamics_cli.cam.laws.peaks import extremes
    from dynamics_cli.cam.laws.polynomials import polynomial

    law = polynomial(_conditions(case)[0])
    return [max(abs(value) for _, value in extremes(law, order)) or 1.0 for order in range(4)]


def _motion(case: "Case") -> "tuple[Any, float]":
    from dynamics_cli.cam.program.reading import Program, motion_of

    return motion_of(Program(), case.inputs["program"]), float(case.inputs["theta"])


def by_exact_joints(case: "Case") -> "Callable[[], Any]":
    """The program's own: joints in exact degrees, the distance from them with the rounding of π put right."""
    motion, theta = _motion(case)
    return lambda: motion.at(theta)


def by_rounded_joints(case: "Case") -> "Callable[[], Any]":
    """Joints as doubles in radians: what their rounding does beside a joint."""
    motion, theta = _motion(case)

    def answer() -> "Any":
        joints = motion.joints
        index = max(i for i in range(len(motion.segments)) if joints[i] <= theta)
        segment, width = motion.segments[index], joints[index + 1] - joints[index]
        scale = segment.high - segment.low
        values = segment.law.at((theta - joints[index]) / width)
        return (segment.low + scale * values[0], *(scale * values[k] / width**k for k in (1, 2, 3)))

    return answer


def motion_peaks(case: "Case") -> "list[float]":
    """Greatest values of the segment's law."""
    from dynamics_cli.cam.laws.normalised import law_named
    from dynamics_cli.cam.laws.peaks import extremes

    law, lift, span = law_named(case.inputs["law"]), float(case.inputs["lift"]), float(case.inputs["span"])
    return [lift * max(abs(value) for _, value in extremes(law, k)) / span**k for k in range(4)]


def polynomial_bounds(case: "Case") -> "list[float]":
    """What the program's polynomial may be off there."""
    from dynamics_cli.cam.laws.polynomials import polynomial
    from dynamics_cli.cam.proof.law_rounding import of_law

    conditions, at = _conditions(case)
    return of_law(polynomial(conditions), at)


def motion_bounds(case: "Case") -> "list[float]":
    """What the program's motion may be off at that angle."""
    import numpy as np

    from dynamics_cli.cam.proof.law_rounding import of_part

    motion, theta = _motion(case)
    worst = [0.0] * 4
    for part, _ in motion.by_parts(np.array([motion.wrapped(theta)])):
        place = np.array([theta])
        own = of_part(part, np.abs(part.local(place)) if part.law_piece is not None else np.zeros(1))
        worst = [max(one, float(other[0])) for one, other in zip(worst, own, strict=True)]
    return worst


POLYNOMIALS: "tuple[Answer, ...]" = (
    ("exact rationals, about both ends (chosen)", by_rationals),
    ("powers of x, solved in doubles", by_doubles),
    ("Bernstein's basis, solved in doubles", by_bernstein),
)
MOTIONS: "tuple[Answer, ...]" = (
    ("joints exact in degrees (chosen)", by_exact_joints),
    ("joints rounded in radians", by_rounded_joints),
)


def compare_polynomials(comparing: "Comparing") -> "list[Row]":
    """Free polynomials; errors in shares of their peaks."""
    return compared(comparing, "polynomial", POLYNOMIALS, polynomial_peaks, polynomial_bounds)


def compare_motions(comparing: "Comparing") -> "list[Row]":
    """Whole motions; errors in shares of the peaks of the segment."""
    return compared(comparing, "motion", MOTIONS, motion_peaks, motion_bounds)
