"""The best tooth numbers for a ratio: exhaustive over every train within the limits, in integers."""

from math import prod

from dynamics_cli.errors import require, require_given, worded
from dynamics_cli.gear.trains.ratio_limits import Limits
from dynamics_cli.gear.trains.ratio_products import Products
from dynamics_cli.gear.trains.ratio_search import Pairs
from dynamics_cli.numerics.exact.rational import lowest, nearest, written
from dynamics_cli.quantities import (
    Annotated,
    Coordinate,
    Count,
    ExactRatio,
    Module,
    Positive,
    Ratio,
    Size,
    Text,
    WholeRange,
)
from dynamics_cli.records import Advice, Check, ErrorBound, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.gear.trains.ratio_limits import Train
    from dynamics_cli.numerics.exact.rational import Pair


# Gears have fewer teeth; more would take minutes.
MOST_TEETH = 100_000


@record
class TrainFound:
    """One train."""

    stages: Annotated[Text, "Driver and driven teeth of each stage, as `gear train` takes them."]
    ratio: Annotated[Text, "The ratio it gives, exact."]
    ratio_value: Annotated[Ratio, "The same as a decimal number."]
    error: Annotated[Text, "ratio/target − 1, exact."]
    error_value: Annotated[Ratio, "The same as a decimal number."]
    teeth: Annotated[int, "Sum of all teeth."]


@record
class RatioFound:
    """The best trains for a ratio."""

    best: Annotated[tuple[TrainFound, ...], "The trains, best first."]
    considered: Annotated[Count, "Number of ratios within the limits; none of them is nearer than the best one shown."]
    ratios: Annotated[Text, "How that number arises."]
    rejected: Annotated[Count, "Ratios nearer than the last one shown that no train within the constraints gives."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def ratio(
    *,
    target: Annotated[
        ExactRatio, "The wanted ratio, driver speed over driven speed: `365.2422/27.3217`, `3.14159`, `22/7`."
    ],
    stages: Annotated[Count, "Number of gear pairs, 1 to 4."] = 2,
    teeth: Annotated[WholeRange, "Minimum and maximum number of teeth."] = (12, 120),
    driven_teeth: Annotated[WholeRange | None, "The same for the driven gears, where it differs."] = None,
    count: Annotated[Count, "Number of trains to show."] = 5,
    coprime: Annotated[bool, "Whether the two gears of each pair must have no common factor (hunting teeth)."] = False,
    coaxial: Annotated[
        bool, "Whether all pairs must have one centre distance, the module being the same (reverted train)."
    ] = False,
    tooth_sum: Annotated[Count | None, "Sum of the teeth that each pair must have, e.g. 90."] = None,
    centre_distance: Annotated[
        Size | None, "Centre distance that each pair must have, with the module, e.g. 90 mm [m]."
    ] = None,
    module: Annotated[Module | None, "Module (transverse) of all gears, for the centre distance [m]."] = None,
    distance_tolerance: Annotated[
        Coordinate | None, "How far the centre distance without profile shift may be off, e.g. 0.5 mm [m]."
    ] = None,
    largest_stage: Annotated[Positive | None, "The largest ratio (or its inverse) of any pair, e.g. 6."] = None,
) -> RatioFound:
    """Best tooth numbers of a train for a wanted ratio; exhaustive, with the exact error.

    Equation
    --------
    i = Π z_driven/Π z_driver; all products of the driven teeth are compared with all products of the driver teeth.

    Returns
    -------
    RatioFound
        The best trains, the number of ratios considered, and the number of nearer ones that the constraints exclude.

    Raises
    ------
    InadmissibleError
        When no train within the limits comes near, or constraints cannot be met.

    Notes
    -----
    Products are compared in doubles to pick candidates and ranked as exact fractions; equal errors are ordered by
    fewest teeth.

    References
    ----------
    The search by sorted products is common practice; the sidereal target is that of orrery builders.

    Examples
    --------
    >>> ratio(target=(355, 113), stages=1, teeth=(100, 400)).best[0].stages
    '113:355'
    """
    drivers, driven = _range(teeth), _range(driven_teeth or teeth)
    top, bottom = target
    require(
        top * bottom > 0, "no tooth numbers give a ratio of {target:6}", target=(nearest(target), Ratio), code="ratio"
    )
    require(1 <= stages <= 4, "a train has 1 to 4 stages here, not {stages}", stages=stages, code="stages")
    require(count > 0, "the number of trains to show is zero", code="count")
    reach = drivers[0] + driven[0], drivers[-1] + driven[-1]
    sums = _sums(tooth_sum, centre_distance, module, distance_tolerance, reach)
    limits = Limits(coprime, coaxial, sums, largest_stage)
    exact_ratio = lowest(top, bottom)
    search: Products | Pairs
    if sums is None and not coaxial:
        search = Products(exact_ratio, drivers, driven, stages, limits)
    else:
        search = Pairs(exact_ratio, drivers, driven, stages, limits)
    search.require_reach()
    trains, rejected = search.best(count)
    best = [_shown(train, exact_ratio) for train in trains]
    return RatioFound(
        best=tuple(best),
        considered=search.considered,
        ratios=search.account,
        rejected=rejected,
        checks=_checks(best, exact_ratio),
        advice=_advice(best, count),
        numerics=Numerics(
            "exhaustive: sorted products, exact ranking",
            tuple(
                ErrorBound(f"best[{index}].{name}", 2.0**-53)
                for index in range(len(best))
                for name in ("ratio_value", "error_value")
            ),
        ),
    )


def _range(teeth: tuple[int, int]) -> range:
    low, high = teeth
    require(0 < low <= high, "{low}..{high} holds no tooth number", low=low, high=high, code="teeth")
    require(
        high - low < MOST_TEETH,
        "{low}..{high} holds more than {most} tooth numbers",
        low=low,
        high=high,
        most=MOST_TEETH,
        code="too-many",
        hint="give a narrower range",
    )
    return range(low, high + 1)


def _sums(
    tooth_sum: int | None, distance: float | None, module: float | None, tolerance: float | None, reach: tuple[int, int]
) -> range | None:
    """The tooth sums a pair may have."""
    if distance is None:
        require(tolerance is None, "the distance tolerance needs the centre distance", code="centre-distance")
        return None if tooth_sum is None else range(tooth_sum, tooth_sum + 1)
    require(tooth_sum is None, "give the tooth sum or the centre distance, not both", code="tooth-sum")
    require_given(module is not None, "a centre distance needs the module", ("module",), code="module")
    assert module is not None
    sum_wanted = 2.0 * distance / module
    tolerated = 2.0 * abs(tolerance or 0.0) / module + 1e-9 * sum_wanted
    low, high = int(-((tolerated - sum_wanted) // 1)), int(sum_wanted + tolerated)
    require(
        low <= high,
        "2a/m = {sum_wanted:9} is not a whole sum of teeth",
        sum_wanted=(sum_wanted, Ratio),
        nearest=(0.5 * module * round(sum_wanted), Size),
        code="centre-distance",
        hint="the nearest is {nearest:6}; or allow --distance-tolerance",
    )
    require(
        low <= reach[1] and high >= reach[0],
        "2a/m = {sum:9} teeth: a pair within the limits has from {least} to {most}",
        sum=(sum_wanted, Ratio),
        least=reach[0],
        most=reach[1],
        code="centre-distance",
        hint="change the centre distance, the module or the range of teeth",
    )
    return range(max(low, reach[0]), min(high, reach[1]) + 1)


def _shown(train: "Train", target: "Pair") -> TrainFound:
    top = prod(driven for _, driven in train)
    bottom = prod(driver for driver, _ in train)
    error = lowest(top * target[1] - bottom * target[0], bottom * target[0])
    return TrainFound(
        stages=", ".join(f"{driver}:{driven}" for driver, driven in train),
        ratio=written((top, bottom)),
        ratio_value=nearest((top, bottom)),
        error=written(error),
        error_value=nearest(error),
        teeth=sum(map(sum, train)),
    )


def _checks(best: list[TrainFound], target: "Pair") -> tuple[Check, ...]:
    """Check the trains by multiplying out the tooth numbers shown."""
    passed = True
    for train in best:
        pairs = [tuple(map(int, pair.split(":"))) for pair in train.stages.split(", ")]
        top, bottom = prod(driven for _, driven in pairs), prod(driver for driver, _ in pairs)
        passed = passed and written((top, bottom)) == train.ratio
        passed = passed and written((top * target[1] - bottom * target[0], bottom * target[0])) == train.error
    errors = [abs(train.error_value) for train in best]
    return (
        Check("the trains shown multiply out to their ratios and errors", passed),
        Check("errors rise", errors == sorted(errors)),
    )


def _advice(best: list[TrainFound], count: int) -> tuple[Advice, ...]:
    advice = []
    if len(best) < count:
        advice.append(
            Advice(
                "few-trains", worded("only {count} different ratios exist within the limits", count=len(best)), "note"
            )
        )
    if best[0].error_value == 0.0:
        advice.append(Advice("exact", "the first train gives the ratio exactly", "note"))
    return tuple(advice)
