"""Further ways beside those of `alternatives/cam/laws`."""

from dynamics_cli.accuracy.alternatives.cam.laws import _given, _scaled
from dynamics_cli.accuracy.cases import Case

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    Values = tuple[float, ...]
    Answer = tuple[str, Callable[[Case], Callable[[], Any]]]


def differences(case: Case) -> "Callable[[], Values]":
    """Central differences of the lift, each with the step that balances rounding and truncation, within the rise."""
    law, lift, span, at = _given(case)

    def f(x: float) -> float:
        return law.at(x, 0)[0]  # type: ignore[no-any-return]

    def answer() -> "Values":
        x = at / span
        # one-sided at the ends by moving the place in
        a, b, c = (min(max(x, step), 1.0 - step) for step in (6e-6, 1.2e-4, 1.4e-3))
        first = (f(a + 6e-6) - f(a - 6e-6)) / 1.2e-5
        second = (f(b + 1.2e-4) - 2.0 * f(b) + f(b - 1.2e-4)) / 1.44e-8
        half = 0.5 * 1.4e-3
        third = (f(c + 2 * half) - 2.0 * f(c + half) + 2.0 * f(c - half) - f(c - 2 * half)) / (2.0 * half**3)
        return _scaled((f(x), first, second, third), lift, span)

    return answer


def by_mechanism(case: Case) -> "Callable[[], Values]":
    """PyPI's `mechanism`, a rise and a fall over one turn: harmonic and cycloidal laws alone."""
    from math import degrees

    from mechanism.cams import Cam  # type: ignore[import-not-found]

    _, lift, span, at = _given(case)
    name = case.inputs["law"]
    # a hundredth of a radian is as fine a step as is worth a table of the whole turn
    if name not in ("harmonic", "cycloidal") or at < 0.01:
        raise ArithmeticError
    moves = [("Rise", lift, degrees(span)), ("Fall", lift, 360.0 - degrees(span))]

    def answer() -> "Values":
        # its angles are multiples of a step: the second of them is the one that is wanted
        found = getattr(Cam(motion=moves, degrees=True, omega=1.0, h=at), name)
        return tuple(float(values[1]) for values in (found.S, found.V, found.A, found.J))

    return answer
