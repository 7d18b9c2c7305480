"""Search for a ratio among products of independent tooth numbers."""

from bisect import bisect_left, bisect_right
from math import log

from dynamics_cli.errors import require
from dynamics_cli.gear.trains.ratio_limits import (
    HIDDEN,
    MOST_LISTED,
    MOST_LOOKED_AT,
    WANTED_AT_FIRST,
    WIDER,
    Limits,
    beyond,
    by_distance,
    require_between,
    require_found,
)
from dynamics_cli.numerics.exact.rational import lowest, nearest
from dynamics_cli.quantities import Ratio

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator

    from dynamics_cli.gear.trains.ratio_limits import Stage, Train
    from dynamics_cli.numerics.exact.rational import Pair

# Marks are quicker than a set up to here.
_MOST_MARKS = 60_000_000


class Products:
    """All products of driver teeth and of driven teeth, sorted; trains are built from the products near the target."""

    def __init__(self, target: "Pair", drivers: range, driven: range, stages: int, limits: Limits) -> None:
        self.target = target
        self.stages = stages
        self.ranges = (drivers, driven)
        self.limits = limits
        self.bottoms = _products(drivers, stages)
        self.tops = self.bottoms if driven == drivers else _products(driven, stages)

    @property
    def considered(self) -> int:
        """Number of ratios."""
        return len(self.tops) * len(self.bottoms)

    @property
    def account(self) -> str:
        """How that number arises."""
        return (
            f"{len(self.tops)} products of the driven teeth × {len(self.bottoms)} of the drivers: "
            f"every train of {self.stages} pairs"
        )

    def require_reach(self) -> None:
        """Refuse a target outside the smallest and largest ratio."""
        least, most = (self.tops[0], self.bottoms[-1]), (self.tops[-1], self.bottoms[0])
        require_between(self.target, least, most, self.stages)

    def near(self, reach: float) -> "list[Stage]":
        """Every (driven product, driver product) whose relative error is at most `reach`, and a few beyond it."""
        aim = nearest(self.target)
        low, high = aim * (1.0 - reach - HIDDEN), aim * (1.0 + reach + HIDDEN)
        tops, bottoms = self.tops, self.bottoms
        start = bisect_left(bottoms, tops[0] / high)
        stop = bisect_right(bottoms, tops[-1] / low) if low > 0.0 else len(bottoms)
        stages: list[Stage] = []
        place, size = 0, len(tops)
        sentinel = [*tops, float("inf")]
        for driver in bottoms[start:stop]:
            least = driver * low
            while sentinel[place] < least:
                place += 1
            if sentinel[place] <= driver * high:
                other, most = place, driver * high
                while other < size and tops[other] <= most:
                    stages.append((tops[other], driver))
                    other += 1
        return stages

    def best(self, count: int) -> "tuple[list[Train], int]":
        """The trains of the `count` best ratios that keep the limits, and how many nearer ratios keep none."""
        spread = log(self.tops[-1] / self.tops[0]) + log(self.bottoms[-1] / self.bottoms[0]) + 0.1
        reach = (WANTED_AT_FIRST + 4.0 * count) * spread / self.considered
        while True:
            reach = min(reach, 1.0)
            ratios: dict[Pair, list[Stage]] = {}
            for top, bottom in self.near(reach):
                ratios.setdefault(lowest(top, bottom), []).append((top, bottom))
            trains: list[Train] = []
            rejected = 0
            for value in by_distance(ratios, self.target)[:MOST_LOOKED_AT]:
                if reach < 1.0 and beyond(value, self.target, reach):
                    break
                train = self._smallest(ratios[value])
                if train is None:
                    rejected += 1
                else:
                    trains.append(train)
                if len(trains) == count:
                    return trains, rejected
            if reach == 1.0 or len(ratios) > MOST_LOOKED_AT:
                require_found(trains, rejected)
                return trains, rejected
            reach *= WIDER

    def _smallest(self, pairs: "list[Stage]") -> "Train | None":
        """The train of fewest teeth among those of one ratio, or None when none keeps the limits."""
        best: Train | None = None
        least = 0
        drivers, driven = self.ranges
        power = 1.0 / self.stages
        for top, bottom in sorted(pairs):
            # the arithmetic mean of teeth is not below their geometric mean
            if best is not None and self.stages * (top**power + bottom**power) >= least:
                break
            for over in _factorings(top, driven, self.stages):
                for under in _factorings(bottom, drivers, self.stages):
                    teeth = sum(over) + sum(under)
                    if best is not None and teeth >= least:
                        continue
                    train = _paired(over, under, self.limits)
                    if train is not None:
                        best, least = train, teeth
        return best


def _products(teeth: range, stages: int) -> list[int]:
    """Every product of `stages` numbers of teeth, sorted, each once."""
    products = list(teeth)
    for _ in range(stages - 1):
        work = len(products) * len(teeth)
        require(
            work <= MOST_LISTED,
            "{stages} pairs of gears of {first} to {last} teeth have too many products to list ({work:3})",
            stages=stages,
            first=teeth[0],
            last=teeth[-1],
            work=(float(work), Ratio),
            code="too-many",
            hint="take fewer stages, or a narrower range of teeth",
        )
        products = _multiplied(products, teeth)
    return products


def _multiplied(products: list[int], teeth: range) -> list[int]:
    """Every product with every number of teeth, sorted, each once.

    The multiples of a product are evenly spaced, so marking them is one slice.
    """
    most = products[-1] * teeth[-1]
    if most > _MOST_MARKS:
        return sorted({product * count for product in products for count in teeth})
    marks, ones = bytearray(most + 1), b"\x01" * len(teeth)
    for product in products:
        marks[product * teeth[0] : product * teeth[-1] + 1 : product] = ones
    values: list[int] = []
    place = marks.find(1)
    while place >= 0:
        values.append(place)
        place = marks.find(1, place + 1)
    return values


def _factorings(number: int, teeth: range, stages: int, least: int = 0) -> "Iterator[tuple[int, ...]]":
    """Every way to write `number` as a product of that many numbers of teeth, in rising order."""
    if stages == 1:
        if number in teeth and number >= least:
            yield (number,)
        return
    low = max(least, teeth[0], -(-number // teeth[-1] ** (stages - 1)))
    for factor in range(low, teeth[-1] + 1):
        if factor**stages > number:
            return
        if number % factor == 0:
            for rest in _factorings(number // factor, teeth, stages - 1, factor):
                yield (factor, *rest)


def _paired(over: tuple[int, ...], under: tuple[int, ...], limits: Limits) -> "Train | None":
    """Drivers paired with driven gears so that every pair keeps the limits; in order of size if that is enough."""
    if not under:
        return ()
    driven, rest = under[0], under[1:]
    for place, other in enumerate(over):
        if limits.pair(driven, other):
            more = _paired(over[:place] + over[place + 1 :], rest, limits)
            if more is not None:
                return ((driven, other), *more)
    return None
