"""Searches over every train within limits: by products of teeth, or by pairs if their tooth sums are constrained."""

from bisect import bisect_left, bisect_right
from math import prod

from dynamics_cli.errors import require
from dynamics_cli.gear.trains.ratio_limits import (
    HIDDEN,
    MOST_LISTED,
    WANTED_AT_FIRST,
    WIDER,
    Limits,
    beyond,
    by_distance,
    require_between,
    require_found,
)
from dynamics_cli.numerics.exact.rational import lowest, nearest

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator

    from dynamics_cli.gear.trains.ratio_limits import Stage, Train
    from dynamics_cli.numerics.exact.rational import Pair


class Pairs:
    """All pairs of gears with constrained tooth sums, combined stage by stage, meeting in the middle."""

    def __init__(self, target: "Pair", drivers: range, driven: range, stages: int, limits: Limits) -> None:
        self.target = target
        self.stages = stages
        self._groups = []
        for sums in _sum_groups(drivers, driven, limits):
            pairs = [
                (driver, total - driver)
                for total in sums
                for driver in drivers
                if total - driver in driven and limits.pair(driver, total - driver)
            ]
            if pairs:
                self._groups.append(pairs)
        require(self._groups, "no pair of gears keeps the constraints", code="constraints")
        half = stages // 2
        listed = sum(_count(len(pairs), stages - half) for pairs in self._groups)
        require(listed <= MOST_LISTED, "{listed} part trains are too many to list", listed=listed, code="too-many")
        self._halves = [(_part_trains(pairs, half), _part_trains(pairs, stages - half)) for pairs in self._groups]

    @property
    def considered(self) -> int:
        """Number of trains."""
        return sum(_count(len(pairs), self.stages) for pairs in self._groups)

    @property
    def account(self) -> str:
        """How that number comes about."""
        pairs = sum(map(len, self._groups))
        return f"every train of {self.stages} among {pairs} pairs with {len(self._groups)} tooth sums or ranges of them"

    def require_reach(self) -> None:
        """The target lies between the least and the greatest ratio."""
        least, most = None, None
        for pairs in self._groups:
            for driver, driven in pairs:
                if least is None or driven * least[1] < least[0] * driver:
                    least = (driven, driver)
                if most is None or driven * most[1] > most[0] * driver:
                    most = (driven, driver)
        assert least is not None
        assert most is not None
        power = self.stages
        require_between(
            self.target, (least[0] ** power, least[1] ** power), (most[0] ** power, most[1] ** power), power
        )

    def near(self, reach: float) -> "dict[Pair, Train]":
        """Every ratio whose relative error is at most `reach`, with its train of fewest teeth."""
        aim = nearest(self.target)
        low, high = aim * (1.0 - reach - HIDDEN), aim * (1.0 + reach + HIDDEN)
        trains: dict[Pair, Train] = {}
        for short, long in self._halves:
            sizes = [size for size, _ in long]
            for size, train in short:
                for place in range(bisect_left(sizes, low / size), bisect_right(sizes, high / size)):
                    pairs = tuple(sorted(train + long[place][1]))
                    value = lowest(prod(b for _, b in pairs), prod(a for a, _ in pairs))
                    best = trains.get(value)
                    if best is None or (_teeth(pairs), pairs) < (_teeth(best), best):
                        trains[value] = pairs
        return trains

    def best(self, count: int) -> "tuple[list[Train], int]":
        """The trains of the `count` best ratios; pairs that violate a limit are not listed at all."""
        reach = (WANTED_AT_FIRST + 4.0 * count) / self.considered
        while True:
            reach = min(reach, 1.0)
            trains = self.near(reach)
            ranked = [value for value in by_distance(trains, self.target) if not beyond(value, self.target, reach)]
            if len(ranked) >= count or reach == 1.0:
                require_found(ranked, 0)
                return [trains[value] for value in ranked[:count]], 0
            reach *= WIDER


def _sum_groups(drivers: range, driven: range, limits: Limits) -> "Iterator[range]":
    """Possible combinations of the tooth sums of a train's pairs."""
    least, most = drivers[0] + driven[0], drivers[-1] + driven[-1]
    allowed = limits.sums if limits.sums is not None else range(least, most + 1)
    if not limits.coaxial:
        yield allowed
        return
    for total in allowed:
        yield range(total, total + 1)


def _count(pairs: int, stages: int) -> int:
    """Number of multisets of `stages`."""
    count = 1
    for index in range(stages):
        count = count * (pairs + index) // (index + 1)
    return count


def _part_trains(pairs: "list[Stage]", stages: int) -> "list[tuple[float, Train]]":
    """Every combination of that many pairs, regardless of order, with its ratio as a double."""
    trains: list[tuple[Train, int]] = [((), 0)]
    for _ in range(stages):
        trains = [((*train, pairs[place]), place) for train, start in trains for place in range(start, len(pairs))]
    sized = [(prod(b for _, b in train) / prod(a for a, _ in train), train) for train, _ in trains]
    sized.sort()
    return sized


def _teeth(train: "Train") -> int:
    return sum(map(sum, train))
