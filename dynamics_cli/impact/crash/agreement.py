"""Quantities that two links of a crash both give, and the gap between them in standard deviations."""

from dynamics_cli.errors import require, worded
from dynamics_cli.impact.crash.results import Agreement, CrashCourse
from dynamics_cli.impact.crash.scene import CrashScene
from dynamics_cli.numerics.elementary import hypot
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.quantities import Length, Ratio, RoadSpeed
from dynamics_cli.records import Advice
from dynamics_cli.sampling import deviation

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# Beyond this many standard deviations of their gap, two links contradict each other.
MOST_DEVIATIONS = 3.0


class Gap:
    """An agreement, and the data for its refusal; `field` of the scene was measured."""

    def __init__(self, agreement: Agreement, kind: "Any", field: str, one: float, other: float) -> None:
        self.agreement = agreement
        self.kind = kind
        self.field = field
        self.one = one
        self.other = other


def agreements(scene: CrashScene, names: "list[str]", courses: "list[CrashCourse]") -> "list[Gap]":
    """Every quantity that was measured and also follows from another link."""
    gaps: list[Gap] = []
    for name, side, course in zip(names, ("first", "second"), courses, strict=True):
        given = getattr(scene, side)
        if given.slide is None and given.rest is not None and course.rest_position is not None:
            gaps.append(_place(name, f"{side}.rest", course.rest_position, given.rest))
        for what, field, value, recorded in (
            ("speed into the impact", "recorded_speed", course.approach_speed, given.recorded_speed),
            ("ΔV", "recorded_delta_v", course.delta_v.magnitude, given.recorded_delta_v),
        ):
            if recorded is not None:
                gap = value - recorded
                entry = Agreement(f"{what} of {name}", "momentum", "record", gap, None, _normalised(gap))
                gaps.append(Gap(entry, RoadSpeed, f"{side}.{field}", value, recorded))
    return gaps


def _place(name: str, field: str, slid: "tuple[float, float]", measured: "tuple[float, float]") -> Gap:
    """The end of a slide beside the rest position, along the line between them."""
    across = measured[0] - slid[0], measured[1] - slid[1]
    apart = hypot(*across)
    entry = Agreement(
        f"rest position of {name}", "slide along the exit heading", "rest as measured", None, apart, _normalised(apart)
    )
    return Gap(entry, Length, field, apart, 0.0 * apart)


def _normalised(gap: "Any") -> float | None:
    """A gap over its standard deviation; None if that is unknown, or for arrays."""
    if not single(gap):
        return None
    spread = deviation(gap)
    return None if not spread else abs(plain(gap)) / spread


def require_agreement(gaps: "list[Gap]") -> None:
    """Refuse two links that contradict each other, by the worst gap."""
    known = [gap for gap in gaps if gap.agreement.normalised is not None]
    if not known:
        return
    worst = max(known, key=lambda gap: gap.agreement.normalised or 0.0)
    entry = worst.agreement
    numbers = "they are {one:3} apart" if worst.kind is Length else "{one:3} and {other:3}"
    require(
        (entry.normalised or 0.0) <= MOST_DEVIATIONS,
        "{first} and {second} contradict each other on the {quantity}: " + numbers + ", {gap:2} standard deviations",
        code="contradiction",
        hint="one of the measurements behind them is wrong, or less certain than stated; without {field} the rest is "
        "answered",
        field=worst.field,
        first=entry.one,
        second=entry.other,
        quantity=entry.quantity,
        one=(worst.one, worst.kind),
        other=(worst.other, worst.kind),
        gap=(entry.normalised, Ratio),
    )


def gap_advice(gaps: "list[Gap]") -> "tuple[Advice, ...]":
    """Advice on gaps without known uncertainty, and on gaps beyond two standard deviations."""
    notes: list[Advice] = []
    for gap in gaps:
        entry = gap.agreement
        apart = entry.normalised
        if apart is None and not _judged_by_eye(gap):
            continue
        if apart is not None and apart <= 2.0:
            continue
        numbers = "they are {one:3} apart" if gap.kind is Length else "{one:3} and {other:3}"
        numbers += "" if apart is None else ", {gap:2} standard deviations"
        notes.append(
            Advice(
                "links-differ",
                worded(
                    "{first} and {second} differ on the {quantity}: " + numbers,
                    first=entry.one, second=entry.other, quantity=entry.quantity,
                    one=(gap.one, gap.kind), other=(gap.other, gap.kind), gap=(apart, Ratio),
                ),
                remedy="give the uncertainties of the measurements: they decide whether the two contradict each other"
                if apart is None
                else "look for a wrong measurement, or one less certain than stated: above 3 they are a contradiction",
            )
        )  # fmt: skip
    return tuple(notes)


def _judged_by_eye(gap: Gap) -> bool:
    """Whether a gap between exact inputs deserves advice: a tenth of a speed, a metre of a position."""
    if not single(gap.one, gap.other):
        return False
    if gap.kind is Length:
        return plain(gap.one) > 1.0
    return abs(plain(gap.one) - plain(gap.other)) > 0.1 * plain(gap.other)
