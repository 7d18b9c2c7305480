"""The best tooth numbers for a wanted ratio: every train within the limits is looked at, in whole numbers."""

from math import prod

from dynamics_cli.errors import require
from dynamics_cli.gear.ratio_search import Limits, Pairs, Products
from dynamics_cli.numerics.rational import lowest, nearest, written
from dynamics_cli.quantities import Coordinate, Count, ExactRatio, Module, Positive, Ratio, Size, Text, WholeRange
from dynamics_cli.records import Advice, Check, ErrorBound, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.gear.ratio_search import Train
    from dynamics_cli.numerics.rational import Pair


# Gears have fewer; more would take minutes.
MOST_TEETH = 100_000


@record
class TrainFound:
    """One train.

    Parameters
    ----------
    stages : Text
        Driver and driven teeth of each stage, as `gear train` takes them.
    ratio : Text
        The ratio it gives, exact.
    ratio_value : Ratio
        The same as a number.
    error : Text
        ratio/target − 1, exact.
    error_value : Ratio
        The same as a number.
    teeth : int
        All teeth together.
    """

    stages: Text
    ratio: Text
    ratio_value: Ratio
    error: Text
    error_value: Ratio
    teeth: int


@record
class RatioFound:
    """The best trains for a ratio.

    Parameters
    ----------
    best : tuple of TrainFound
        The trains, best first.
    considered : Count
        How many ratios there are within the limits; none of them is nearer than the best shown.
    ratios : Text
        How that number comes about.
    rejected : Count
        Ratios nearer than the last one shown that no train within the constraints gives.
    """

    best: tuple[TrainFound, ...]
    considered: Count
    ratios: Text
    rejected: Count
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def ratio(
    *,
    target: ExactRatio,
    stages: Count = 2,
    teeth: WholeRange = (12, 120),
    driven_teeth: WholeRange | None = None,
    count: Count = 5,
    coprime: bool = False,
    coaxial: bool = False,
    tooth_sum: Count | None = None,
    centre_distance: Size | None = None,
    module: Module | None = None,
    distance_tolerance: Coordinate | None = None,
    largest_stage: Positive | None = None,
) -> RatioFound:
    """Best tooth numbers of a train for a wanted ratio; exhaustive, with the exact error.

    Equation
    --------
    i = Π z_driven/Π z_driver; all products of the driven teeth are held against all products of the driver teeth.

    Parameters
    ----------
    target : ExactRatio
        The wanted ratio, driver speed over driven speed: `365.2422/27.3217`, `3.14159`, `22/7`.
    stages : Count
        Number of gear pairs, 1 to 4.
    teeth : WholeRange
        Least and greatest number of teeth.
    driven_teeth : WholeRange
        The same for the driven gears, where it differs.
    count : Count
        How many trains to show.
    coprime : bool
        Whether the two gears of each pair must have no common factor (hunting teeth).
    coaxial : bool
        Whether all pairs must have one centre distance, the module being the same (reverted train).
    tooth_sum : Count
        Sum of the teeth that each pair must have.
    centre_distance : Size
        Centre distance that each pair must have, with the module [m].
    module : Module
        Module (transverse) of all gears, for the centre distance [m].
    distance_tolerance : Coordinate
        How far the centre distance without profile shift may be off [m].
    largest_stage : Positive
        The greatest ratio (or its inverse) of any pair.

    Returns
    -------
    RatioFound
        The best trains, how many ratios were considered, and how many nearer ones the constraints rule out.

    Raises
    ------
    InadmissibleError
        When no train within the limits comes near, or constraints cannot be met.

    Notes
    -----
    Products are compared in doubles to pick candidates and ranked as exact fractions; equal errors by fewest teeth.

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
    require(top * bottom > 0, "a ratio of {0:.6g} is none of tooth numbers", nearest(target), code="ratio")
    require(1 <= stages <= 4, "a search over {0} stages is not offered: 1 to 4", stages, code="stages")
    require(count > 0, "no train is asked for", code="count")
    sums = _sums(tooth_sum, centre_distance, module, distance_tolerance)
    limits = Limits(coprime, coaxial, sums, largest_stage)
    wanted = lowest(top, bottom)
    search: Products | Pairs
    if sums is None and not coaxial:
        search = Products(wanted, drivers, driven, stages, limits)
    else:
        search = Pairs(wanted, drivers, driven, stages, limits)
    search.require_reach()
    found, rejected = search.best(count)
    best = [_shown(train, wanted) for train in found]
    return RatioFound(
        best=tuple(best),
        considered=search.considered,
        ratios=search.account,
        rejected=rejected,
        checks=_checks(best, wanted),
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
    require(0 < low <= high, "{0}..{1} holds no tooth number", low, high, code="teeth")
    require(
        high - low < MOST_TEETH,
        "{0}..{1} holds more than {2} tooth numbers",
        low,
        high,
        MOST_TEETH,
        code="too-many",
        hint="give a narrower range",
    )
    return range(low, high + 1)


def _sums(tooth_sum: int | None, distance: float | None, module: float | None, tolerance: float | None) -> range | None:
    """The tooth sums a pair may have."""
    if distance is None:
        require(tolerance is None, "a tolerance without a centre distance", code="centre-distance")
        return None if tooth_sum is None else range(tooth_sum, tooth_sum + 1)
    require(tooth_sum is None, "give the tooth sum or the centre distance, not both", code="tooth-sum")
    require(module is not None, "a centre distance needs the module", code="module", hint='--module "2 mm"')
    assert module is not None
    sum_wanted = 2.0 * distance / module
    room = 2.0 * abs(tolerance or 0.0) / module + 1e-9 * sum_wanted
    low, high = int(-((room - sum_wanted) // 1)), int(sum_wanted + room)
    require(
        low <= high,
        "2a/m = {0:.9g} is not a whole sum of teeth",
        sum_wanted,
        code="centre-distance",
        hint=f"the nearest is {0.5e3 * module * round(sum_wanted):.6g} mm; or allow --distance-tolerance",
    )
    return range(low, high + 1)


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
    """The trains multiplied out again from the words that are shown."""
    passed = True
    for one in best:
        pairs = [tuple(map(int, pair.split(":"))) for pair in one.stages.split(", ")]
        top, bottom = prod(driven for _, driven in pairs), prod(driver for driver, _ in pairs)
        passed = passed and written((top, bottom)) == one.ratio
        passed = passed and written((top * target[1] - bottom * target[0], bottom * target[0])) == one.error
    errors = [abs(one.error_value) for one in best]
    return (
        Check("the trains shown multiply out to their ratios and errors", passed),
        Check("errors rise", errors == sorted(errors)),
    )


def _advice(best: list[TrainFound], count: int) -> tuple[Advice, ...]:
    found = []
    if len(best) < count:
        found.append(Advice("few-trains", f"only {len(best)} different ratios exist within the limits", "note"))
    if best[0].error_value == 0.0:
        found.append(Advice("exact", "the first train gives the ratio exactly", "note"))
    return tuple(found)
