"""Tooth numbers for a ratio: every product looked at, beside continued fractions and a greedy choice stage by stage."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from fractions import Fraction
    from typing import Any

    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.measure import Errors
    from dynamics_cli.accuracy.rows import Row


class Wanted:
    """A ratio wanted of so many stages within limits of teeth."""

    def __init__(self, name: str, target: "tuple[int, int]", stages: int, teeth: "tuple[int, int]", hard: bool) -> None:
        self.name = name
        self.target = target
        self.stages = stages
        self.teeth = teeth
        self.hard = hard


WANTED = (
    Wanted("19.2 in two stages", (96, 5), 2, (15, 90), False),
    Wanted("6.3 in one stage", (63, 10), 1, (17, 130), False),
    Wanted("inch thread on a metric screw", (127, 50), 1, (20, 130), False),
    Wanted("a hundredth, three stages", (1, 100), 3, (12, 80), False),
    Wanted("days of a sidereal month: no small fraction near it", (3652422, 273217), 2, (12, 120), True),
    Wanted("π in two stages", (314159265358979, 10**14), 2, (12, 120), True),
    Wanted("golden section: convergents come slowest", (1618033988749895, 10**15), 2, (20, 100), True),
    Wanted("1 + 1e-6: fine steps about one", (1000001, 1000000), 2, (12, 120), True),
    Wanted("a ratio of primes beyond the teeth", (10007, 9973), 2, (12, 120), True),
    Wanted("√2 in three stages", (14142135623730951, 10**16), 3, (20, 60), True),
)


def every_train(wanted: Wanted) -> "Fraction":
    """The program's own: all products of tooth numbers."""
    from fractions import Fraction

    from dynamics_cli.gear.trains.ratio import ratio

    return Fraction(ratio(target=wanted.target, stages=wanted.stages, teeth=wanted.teeth, count=1).best[0].ratio)


def convergents(target: "Fraction") -> "Iterator[Fraction]":
    """The convergents of a continued fraction, the target itself last."""
    from fractions import Fraction

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
    return any(number % own == 0 and makes(number // own, teeth, stages - 1) for own in range(low, high + 1))


def continued_fraction(wanted: Wanted) -> "Fraction":
    """The last convergent that gears can make, its terms multiplied by any number up to the most teeth."""
    from fractions import Fraction

    found = None
    most = wanted.teeth[1] ** wanted.stages
    for one in convergents(Fraction(*wanted.target)):
        if max(one.numerator, one.denominator) > most:
            break
        if one and any(
            makes(by * one.numerator, wanted.teeth, wanted.stages)
            and makes(by * one.denominator, wanted.teeth, wanted.stages)
            for by in range(1, wanted.teeth[1] ** (1 if wanted.stages < 3 else 2) + 1)
        ):
            found = one
    if found is None:
        raise ArithmeticError
    return found


METHODS = (
    ("every product of teeth (chosen)", every_train),
    ("continued fraction, its terms factored", continued_fraction),
)


def compare(comparing: "Comparing") -> "list[Row]":
    """Every method for every ratio; errors are those of the trains found, in exact fractions."""
    from fractions import Fraction

    def answer(errors: "Errors", wanted: "Any", function: "Callable[[Any], Any]", _: int) -> "Callable[[], Any]":
        errors.note(wanted.name, float(abs(function(wanted) / Fraction(*wanted.target) - 1)), None)
        return lambda: function(wanted)

    cases = [wanted for wanted in WANTED if wanted.hard or not comparing.hard]
    return comparing.rows(METHODS, cases, answer, repeats=3)
