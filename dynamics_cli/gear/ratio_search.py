"""Searches over every train within limits: by products of teeth, or by pairs where their tooth sums are bound."""

from bisect import bisect_left, bisect_right
from math import gcd, log, prod

from dynamics_cli.errors import require
from dynamics_cli.numerics.rational import lowest, nearest

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import TypeAlias

    from dynamics_cli.numerics.rational import Pair

    Stage: TypeAlias = tuple[int, int]
    Train: TypeAlias = tuple[Stage, ...]

# Lists longer than this would take minutes and gigabytes.
MOST_LISTED = 12_000_000
# Ratios held against the constraints, best first, before they are said to be out of reach.
MOST_LOOKED_AT = 60_000
# Marks are quicker than a set up to here.
_MOST_MARKS = 60_000_000
_WANTED_AT_FIRST = 60.0
_WIDER = 12.0
# Doubles order products; what they may hide is added to every reach.
_HIDDEN = 1e-14


class Limits:
    """What every pair of a train must keep."""

    def __init__(self, coprime: bool, coaxial: bool, sums: range | None, largest: float | None) -> None:
        self.coprime = coprime
        self.coaxial = coaxial
        self.sums = sums
        self.largest = largest

    def pair(self, driver: int, driven: int) -> bool:
        """Whether one pair may be."""
        if self.coprime and gcd(driver, driven) != 1:
            return False
        if self.sums is not None and driver + driven not in self.sums:
            return False
        return self.largest is None or max(driver, driven) <= self.largest * min(driver, driven)


class Products:
    """All products of driver teeth and of driven teeth, sorted; trains are made of the products near the target."""

    def __init__(self, target: "Pair", drivers: range, driven: range, stages: int, limits: Limits) -> None:
        self.target = target
        self.stages = stages
        self.ranges = (drivers, driven)
        self.limits = limits
        self.bottoms = _products(drivers, stages)
        self.tops = self.bottoms if driven == drivers else _products(driven, stages)

    @property
    def considered(self) -> int:
        """How many ratios there are."""
        return len(self.tops) * len(self.bottoms)

    @property
    def account(self) -> str:
        """How that number comes about."""
        return (
            f"{len(self.tops)} products of the driven teeth × {len(self.bottoms)} of the drivers: "
            f"every train of {self.stages} pairs"
        )

    def require_reach(self) -> None:
        """The target lies between the least and the greatest ratio."""
        least, most = (self.tops[0], self.bottoms[-1]), (self.tops[-1], self.bottoms[0])
        _require_between(self.target, least, most, self.stages)

    def near(self, reach: float) -> "list[Stage]":
        """Every (driven product, driver product) whose relative error is at most `reach`, and a few beyond it."""
        aim = nearest(self.target)
        low, high = aim * (1.0 - reach - _HIDDEN), aim * (1.0 + reach + _HIDDEN)
        tops, bottoms = self.tops, self.bottoms
        start = bisect_left(bottoms, tops[0] / high)
        stop = bisect_right(bottoms, tops[-1] / low) if low > 0.0 else len(bottoms)
        found: list[Stage] = []
        place, size = 0, len(tops)
        sentinel = [*tops, float("inf")]
        for own in bottoms[start:stop]:
            least = own * low
            while sentinel[place] < least:
                place += 1
            if sentinel[place] <= own * high:
                other, most = place, own * high
                while other < size and tops[other] <= most:
                    found.append((tops[other], own))
                    other += 1
        return found

    def best(self, count: int) -> "tuple[list[Train], int]":
        """The trains of the `count` best ratios that keep the limits, and how many nearer ratios keep none."""
        spread = log(self.tops[-1] / self.tops[0]) + log(self.bottoms[-1] / self.bottoms[0]) + 0.1
        reach = (_WANTED_AT_FIRST + 4.0 * count) * spread / self.considered
        while True:
            reach = min(reach, 1.0)
            ratios: dict[Pair, list[Stage]] = {}
            for top, bottom in self.near(reach):
                ratios.setdefault(lowest(top, bottom), []).append((top, bottom))
            found: list[Train] = []
            rejected = 0
            for value in _ranked(ratios, self.target)[:MOST_LOOKED_AT]:
                if reach < 1.0 and _beyond(value, self.target, reach):
                    break
                train = self._smallest(ratios[value])
                if train is None:
                    rejected += 1
                else:
                    found.append(train)
                if len(found) == count:
                    return found, rejected
            if reach == 1.0 or len(ratios) > MOST_LOOKED_AT:
                _require_found(found, rejected)
                return found, rejected
            reach *= _WIDER

    def _smallest(self, pairs: "list[Stage]") -> "Train | None":
        """The train of fewest teeth among those of one ratio, or None when none keeps the limits."""
        best: Train | None = None
        least = 0
        drivers, driven = self.ranges
        power = 1.0 / self.stages
        for top, bottom in sorted(pairs):
            # the mean of teeth is not below their geometric mean
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


class Pairs:
    """All pairs of gears whose tooth sums are bound, taken together stage by stage and met in the middle."""

    def __init__(self, target: "Pair", drivers: range, driven: range, stages: int, limits: Limits) -> None:
        self.target = target
        self.stages = stages
        self._groups = []
        for sums in _sum_groups(drivers, driven, limits):
            pairs = [
                (own, total - own)
                for total in sums
                for own in drivers
                if total - own in driven and limits.pair(own, total - own)
            ]
            if pairs:
                self._groups.append(pairs)
        require(self._groups, "no pair of gears keeps the constraints", code="constraints")
        half = stages // 2
        listed = sum(_count(len(pairs), stages - half) for pairs in self._groups)
        require(listed <= MOST_LISTED, "{0} part trains are too many to list", listed, code="too-many")
        self._halves = [(_part_trains(pairs, half), _part_trains(pairs, stages - half)) for pairs in self._groups]

    @property
    def considered(self) -> int:
        """How many trains there are."""
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
        _require_between(
            self.target, (least[0] ** power, least[1] ** power), (most[0] ** power, most[1] ** power), power
        )

    def near(self, reach: float) -> "dict[Pair, Train]":
        """Every ratio whose relative error is at most `reach`, with its train of fewest teeth."""
        aim = nearest(self.target)
        low, high = aim * (1.0 - reach - _HIDDEN), aim * (1.0 + reach + _HIDDEN)
        found: dict[Pair, Train] = {}
        for short, long in self._halves:
            sizes = [size for size, _ in long]
            for size, train in short:
                for place in range(bisect_left(sizes, low / size), bisect_right(sizes, high / size)):
                    whole = tuple(sorted(train + long[place][1]))
                    value = lowest(prod(b for _, b in whole), prod(a for a, _ in whole))
                    known = found.get(value)
                    if known is None or (_teeth(whole), whole) < (_teeth(known), known):
                        found[value] = whole
        return found

    def best(self, count: int) -> "tuple[list[Train], int]":
        """The trains of the `count` best ratios; pairs that break a limit are not listed in the first place."""
        reach = (_WANTED_AT_FIRST + 4.0 * count) / self.considered
        while True:
            reach = min(reach, 1.0)
            trains = self.near(reach)
            ranked = [value for value in _ranked(trains, self.target) if not _beyond(value, self.target, reach)]
            if len(ranked) >= count or reach == 1.0:
                _require_found(ranked, 0)
                return [trains[value] for value in ranked[:count]], 0
            reach *= _WIDER


def _require_between(target: "Pair", least: "Pair", most: "Pair", stages: int) -> None:
    inside = least[0] * target[1] <= target[0] * least[1] and target[0] * most[1] <= most[0] * target[1]
    require(
        inside,
        "{0:.6g} is out of reach: {1} pairs give {2:.6g} to {3:.6g}",
        nearest(target),
        stages,
        nearest(least),
        nearest(most),
        code="out-of-reach",
        hint="take more stages, or a wider range of teeth",
    )


def _require_found(found: object, rejected: int) -> None:
    require(
        bool(found),
        "none of the {0} nearest ratios can be made within the constraints",
        rejected,
        code="constraints",
        hint="loosen a constraint, or widen the range of teeth",
    )


def _products(teeth: range, stages: int) -> list[int]:
    """Every product of `stages` numbers of teeth, sorted, each once."""
    found = list(teeth)
    for _ in range(stages - 1):
        work = len(found) * len(teeth)
        require(
            work <= MOST_LISTED,
            "{0} pairs of gears of {1} to {2} teeth have too many products to list ({3:.3g})",
            stages,
            teeth[0],
            teeth[-1],
            float(work),
            code="too-many",
            hint="take fewer stages, or a narrower range of teeth",
        )
        found = _multiplied(found, teeth)
    return found


def _multiplied(products: list[int], teeth: range) -> list[int]:
    """Every product with every number of teeth, sorted, each once.

    The multiples of a product are evenly spaced, so marking them is one slice.
    """
    most = products[-1] * teeth[-1]
    if most > _MOST_MARKS:
        return sorted({own * other for own in products for other in teeth})
    marks, ones = bytearray(most + 1), b"\x01" * len(teeth)
    for own in products:
        marks[own * teeth[0] : own * teeth[-1] + 1 : own] = ones
    found: list[int] = []
    place = marks.find(1)
    while place >= 0:
        found.append(place)
        place = marks.find(1, place + 1)
    return found


def _ranked(values: "object", target: "Pair") -> "list[Pair]":
    """Ratios by their exact error, then by size."""
    top, bottom = target
    pairs: list[Pair] = list(values)  # type: ignore[call-overload]
    if not pairs:
        return []
    # fine enough that two different errors never become one whole number
    unit = 4 * max(q for _, q in pairs) ** 2 * bottom * top
    return sorted(pairs, key=lambda pair: (abs(pair[0] * bottom - pair[1] * top) * unit // (pair[1] * top), pair))


def _beyond(value: "Pair", target: "Pair", reach: float) -> bool:
    """Whether a ratio is farther off than all ratios are known to."""
    top, bottom = value[0] * target[1], value[1] * target[0]
    return abs(top - bottom) / bottom > reach


def _factorings(number: int, teeth: range, stages: int, least: int = 0) -> "Iterator[tuple[int, ...]]":
    """Every way to write `number` as a product of that many numbers of teeth, in rising order."""
    if stages == 1:
        if number in teeth and number >= least:
            yield (number,)
        return
    low = max(least, teeth[0], -(-number // teeth[-1] ** (stages - 1)))
    for own in range(low, teeth[-1] + 1):
        if own**stages > number:
            return
        if number % own == 0:
            for rest in _factorings(number // own, teeth, stages - 1, own):
                yield (own, *rest)


def _paired(over: tuple[int, ...], under: tuple[int, ...], limits: Limits) -> "Train | None":
    """Drivers paired with driven gears so that every pair keeps the limits; in order of size where that does."""
    if not under:
        return ()
    own, rest = under[0], under[1:]
    for place, other in enumerate(over):
        if limits.pair(own, other):
            more = _paired(over[:place] + over[place + 1 :], rest, limits)
            if more is not None:
                return ((own, other), *more)
    return None


def _sum_groups(drivers: range, driven: range, limits: Limits) -> "Iterator[range]":
    """Tooth sums that pairs of one train may have together."""
    least, most = drivers[0] + driven[0], drivers[-1] + driven[-1]
    allowed = limits.sums if limits.sums is not None else range(least, most + 1)
    if not limits.coaxial:
        yield allowed
        return
    for total in allowed:
        yield range(total, total + 1)


def _count(pairs: int, stages: int) -> int:
    """How many multisets of `stages` there are."""
    count = 1
    for index in range(stages):
        count = count * (pairs + index) // (index + 1)
    return count


def _part_trains(pairs: "list[Stage]", stages: int) -> "list[tuple[float, Train]]":
    """Every choice of that many pairs, order apart, by its ratio as a double."""
    trains: list[tuple[Train, int]] = [((), 0)]
    for _ in range(stages):
        trains = [((*train, pairs[place]), place) for train, start in trains for place in range(start, len(pairs))]
    sized = [(prod(b for _, b in train) / prod(a for a, _ in train), train) for train, _ in trains]
    sized.sort()
    return sized


def _teeth(train: "Train") -> int:
    return sum(map(sum, train))
