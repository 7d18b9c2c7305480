"""Rise laws: folded about the middle and factored, as one formula about zero, and differentiated in numbers."""

from decimal import Decimal
from math import cos, pi, sin

from dynamics_cli.accuracy.cases import Case
from dynamics_cli.accuracy.measure import DIGITS, Errors

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any

    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.rows import Row
    from dynamics_cli.cam.laws.normalised import Law

    Values = tuple[float, ...]
    Answer = tuple[str, Callable[[Case], Callable[[], Any]]]

FILE = "cam_motion.json"
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


def _given(case: Case) -> "tuple[Law, float, float, float]":
    """Law, lift, span and angle."""
    from dynamics_cli.cam.laws.normalised import law_named

    inputs = case.inputs
    shares = tuple(map(float, inputs.get("shares", ()))) or None
    law = law_named(inputs["law"], shares, float(inputs["constant"]) if "constant" in inputs else None)
    return law, float(inputs["lift"]), float(inputs["span"]), float(inputs["at"])


def _scaled(values: "Sequence[float]", lift: float, span: float) -> "Values":
    return tuple(lift * value / span**order for order, value in enumerate(values))


def folded(case: Case) -> "Callable[[], Values]":
    """The program's own: each half measured from its own end, in factors."""
    from dynamics_cli.cam.laws.rise import _point

    law, lift, span, at = _given(case)
    scales = [lift / span**order for order in range(4)]

    def answer() -> "Values":
        point = _point(law, at, span, lift, scales, "rising", None)
        return point.lift, point.velocity, point.acceleration, point.jerk

    return answer


def expanded(case: Case) -> "Callable[[], Values]":
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


def peaks(case: Case) -> "tuple[float, ...]":
    """Greatest finite values of lift and derivatives, which errors are shares of."""
    from dynamics_cli.cam.laws.peaks import extremes

    law, lift, span, _ = _given(case)
    return _scaled([max(abs(value) for _, value in extremes(law, order)) or 1.0 for order in range(4)], lift, span)


def folded_bounds(case: Case) -> "Values":
    """What the program states of these values."""
    from dynamics_cli.cam.laws.rise import _bounds, _point

    law, lift, span, at = _given(case)
    point = _point(law, at, span, lift, [lift / span**order for order in range(4)], "rising", None)
    return tuple(bound.bound for bound in _bounds(law, (point,), span, lift, None, "rising"))


METHODS: "tuple[Answer, ...]" = (
    ("folded and factored (chosen)", folded),
    ("one formula, expanded about zero", expanded),
)


def compare(comparing: "Comparing") -> "list[Row]":
    """Every method on every law; errors in shares of the law's peak of that derivative."""
    return compared(comparing, "rise", METHODS, peaks, folded_bounds)


def compare_relative(comparing: "Comparing") -> "list[Row]":
    """Relative errors of lift and velocity: the digits left of small values at the ends (others vanish in between)."""
    return compared(comparing, "rise", METHODS, None, None)


def compared(
    comparing: "Comparing", task: str, methods: "Sequence[Answer]", scales: "Callable[[Case], Sequence[float]] | None",
    bounds: "Callable[[Case], Sequence[float]] | None",
) -> "list[Row]":  # fmt: skip
    """Rows for methods that give lift and derivatives; errors in shares of `scales`, or relative without.

    `bounds` are what the program states of its own, the first method's.
    """

    def answer(errors: Errors, case: Case, prepare: "Any", _: int) -> "Callable[[], Values]":
        call = prepare(case)
        stated = bounds(case) if bounds and prepare is methods[0][1] else ()
        _count(errors, case, call(), scales(case) if scales else (), stated)
        return call  # type: ignore[no-any-return]

    return comparing.rows(methods, comparing.cases(FILE, task=task), answer, most=20)


def _count(errors: Errors, case: Case, values: "Values", scales: "Sequence[float]", stated: "Sequence[float]") -> None:
    for order, (address, value) in enumerate(zip(NAMES, values, strict=True)):
        text = case.results[address]
        where = f"{case.name}: {address}"
        if scales:
            error = DIGITS.subtract(Decimal(value), Decimal(text)).copy_abs()
            errors.note(where, float(error) / scales[order], stated[order] / scales[order] if stated else None)
        elif order < 2:
            errors.add(where, value, text, None)
