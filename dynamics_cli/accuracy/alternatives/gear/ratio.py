"""Tooth numbers for a ratio: every product of teeth, beside continued fractions whose terms are factored."""

from fractions import Fraction

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from typing import Any

    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.measure import Errors
    from dynamics_cli.accuracy.rows import Row

    # A ratio wanted, of so many stages, within limits of teeth, and whether it is hard.
    Wanted = tuple[str, tuple[int, int], int, tuple[int, int], bool]

WANTED: "tuple[Wanted, ...]" = (
    ("19.2 in two stages", (96, 5), 2, (15, 90), False),
    ("6.3 in one stage", (63, 10), 1, (17, 130), False),
    ("inch thread on a metric screw", (127, 50), 1, (20, 130), False),
    ("a hundredth, three stages", (1, 100), 3, (12, 80), False),
    ("days of a sidereal month: no small fraction near it", (3652422, 273217), 2, (12, 120), True),
    ("π in two stages", (314159265358979, 10**14), 2, (12, 120), True),
    ("golden section: convergents come slowest", (1618033988749895, 10**15), 2, (20, 100), True),
    ("1 + 1e-6: fine steps about one", (1000001, 1000000), 2, (12, 120), True),
    ("a ratio of primes beyond the teeth", (10007, 9973), 2, (12, 120), True),
    ("√2 in three stages", (14142135623730951, 10**16), 3, (20, 60), True),
)


def every_train(target: "tuple[int, int]", stages: int, teeth: "tuple[int, int]") -> Fraction:
    """The program's own: all products of tooth numbers."""
    from dynamics_cli.gear.trains.ratio import ratio

    return Fraction(ratio(target=target, stages=stages, teeth=teeth, count=1).best[0].ratio)


def convergents(target: Fraction) -> "Iterator[Fraction]":
    """The convergents of a continued fraction, the target itself last."""
    before, now, below, under = 1, target.numerator // target.denominator, 0, 1
    yield Fraction(now, under)
    rest = target - now
    while rest:
        whole = int(1 / rest)
        rest = 1 / rest - whole
        before, now = now, whole * now + before
        below, under = under, whole * under + below
        yield Fraction(now, under)


def makes(number: int, teeth: "tuple[int, int]", stages: int) -> bool:
    """Whether a number is a product of that many numbers of teeth."""
    low, high = teeth
    if stages == 1:
        return low <= number <= high
    return any(number % gear == 0 and makes(number // gear, teeth, stages - 1) for gear in range(low, high + 1))


def continued_fraction(target: "tuple[int, int]", stages: int, teeth: "tuple[int, int]") -> Fraction:
    """The last convergent that gears can make, its terms multiplied by any number up to the most teeth."""
    best = None
    for ratio in convergents(Fraction(*target)):
        if max(ratio.numerator, ratio.denominator) > teeth[1] ** stages:
            break
        if ratio and any(
            makes(by * ratio.numerator, teeth, stages) and makes(by * ratio.denominator, teeth, stages)
            for by in range(1, teeth[1] ** (1 if stages < 3 else 2) + 1)
        ):
            best = ratio
    if best is None:
        raise ArithmeticError
    return best


METHODS = (
    ("every product of teeth (chosen)", every_train),
    ("continued fraction, its terms factored", continued_fraction),
)


def compare(comparing: "Comparing") -> "list[Row]":
    """Every method for every ratio; errors are those of the trains, in exact fractions."""

    def answer(errors: "Errors", wanted: "Wanted", function: "Any", _: int) -> "Callable[[], Any]":
        name, target, stages, teeth, _hard = wanted
        errors.note(name, float(abs(function(target, stages, teeth) / Fraction(*target) - 1)), None)
        return lambda: function(target, stages, teeth)

    cases = [wanted for wanted in WANTED if wanted[-1] or not comparing.hard]
    return comparing.rows(METHODS, cases, answer, repeats=3)
