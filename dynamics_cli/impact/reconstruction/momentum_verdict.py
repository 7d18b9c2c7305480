"""How well momentum determines a reconstructed speed: the error of a heading that would change it by a tenth."""

from dynamics_cli.errors import (
    judge,
    worded,
)
from dynamics_cli.impact.reconstruction.momentum_terms import Term
from dynamics_cli.numerics.elementary import absolute, cos, maximum, minimum, sin, where
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.quantities import (
    Angle,
    Annotated,
    Fraction,
    Ratio,
    RoadSpeed,
    Text,
)
from dynamics_cli.records import Advice, record
from dynamics_cli.sampling import drawing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

DEGREE = 0.017453292519943295
HALF_TURN = 180.0 * DEGREE
# Headings from marks and rest positions are accurate to some degrees.
GOOD, CAUTION = 3.0 * DEGREE, 1.0 * DEGREE
# Angle conditions: paths close to one line are the cause, and paths so close that they are refused.
NEAR_ONE_LINE, ON_ONE_LINE = 4.0, 12.0
CROSSING = "give the crush energies or equivalent speeds of both vehicles: the energy decides"
LIGHT = "its momentum is small beside the other's: use the damage, the other vehicle's spin or an event data recorder"
LEVELS = ("undetermined", "caution", "good")
# Energies of deformation are known to some tens of per cent.
GOOD_SHARE, CAUTION_SHARE = 0.15, 0.05
ENERGY = "energy of deformation"
MEASURE = "determine the energies of deformation and the speeds after in a second way, or use an event data recorder"


@record
class SpeedVerdict:
    """How well the headings, or the energy and the speeds after, determine a reconstructed speed."""

    verdict: Annotated[
        Text, "good from 3 degrees (or 15 %) of tolerance, caution from 1 degree (or 5 %), undetermined below."
    ]
    heading_tolerance: Annotated[
        Angle | None, "Error of one heading that changes the speed by a tenth of itself, at most half a turn [rad]."
    ]
    worst_heading: Annotated[Text | None, "Parameter name of the heading."]
    tolerance: Annotated[
        Fraction | None,
        "By energy: error of one quantity, as a share of it, that changes the speed by a tenth of itself (of a quarter "
        "of the closing speed, where that is more), at most all.",
    ] = None
    worst_quantity: Annotated[Text | None, "The quantity."] = None
    per_degree: Annotated[RoadSpeed | None, "What one degree of the worst heading changes the speed by [m/s]."] = None


class Unknowns:
    """The unknown quantities, recorded before the equation fills them in."""

    def __init__(self, terms: "Sequence[Term]") -> None:
        self.terms = list(terms)
        self.sizes = [term for term in terms if term.speed is None]
        self.turns = [term for term in terms if term.heading is None]

    def verdicts(self) -> "list[tuple[Term, SpeedVerdict]]":
        """The verdict of every speed that was not given, from derivatives of the solved equation."""
        return [(term, _verdict(term, *self._slopes(term))) for term in self.sizes]

    def heading_in_words(self, address: str) -> str:
        """A heading, known by its parameter name, as people call it."""
        for term in self.terms:
            if term.heading_name == address:
                word = "exit" if term.after else "approach"
                return f"the {word} heading of {term.vehicle}"
        return address

    def _slopes(self, term: Term) -> "tuple[float, list[tuple[str, float]]]":
        """Derivatives of a speed by every heading given, times a common factor; the factor."""
        other = next((item for item in self.sizes if item is not term), None)
        with_heading = [item for item in self.terms if item not in self.turns]
        if other is not None:
            factor = term.mass * sin(other.heading - term.heading)  # type: ignore[operator]
            return factor, [(t.heading_name, t.amount * cos(other.heading - t.heading)) for t in with_heading]  # type: ignore[operator]
        turned = self.turns[0] if self.turns else term
        factor = term.mass * cos(turned.heading - term.heading)  # type: ignore[operator]
        # across its own heading a single unknown speed leaves the closing error
        rest = with_heading if self.turns else [item for item in with_heading if item is not term]
        slopes = [(item.heading_name, item.amount * sin(turned.heading - item.heading)) for item in rest]  # type: ignore[operator]
        if not self.turns:
            slopes.append((term.heading_name, sum((slope for _, slope in slopes[1:]), slopes[0][1])))
        return factor, slopes


def _verdict(term: Term, factor: float, slopes: "list[tuple[str, float]]") -> SpeedVerdict:
    worst, steepest = slopes[0][0], absolute(slopes[0][1])
    for name, slope in slopes[1:]:
        steeper = absolute(slope) > steepest
        if not drawing():
            worst = where(steeper, name, worst)  # type: ignore[arg-type,assignment]
        steepest = where(steeper, absolute(slope), steepest)
    tenth = 0.1 * absolute(term.speed * factor)  # type: ignore[operator]
    moves = steepest > 0.0
    tolerance = where(moves, minimum(tenth / where(moves, steepest, 1.0), HALF_TURN), HALF_TURN)
    plainly = plain(tolerance)
    level = _level(plainly, GOOD, CAUTION)
    whole = absolute(factor)
    per_degree = where(whole > 0.0, DEGREE * steepest / where(whole > 0.0, whole, 1.0), 0.0)
    return SpeedVerdict(level, tolerance, worst, per_degree=per_degree)


def _level(tolerance: float, good: float, fair: float) -> str:
    """The verdict in a word; of samples nobody asks, and texts are slow."""
    if drawing():
        return LEVELS[2]
    return where(tolerance >= good, LEVELS[2], where(tolerance >= fair, LEVELS[1], LEVELS[0]))  # type: ignore[arg-type,return-value]


def worse(least: SpeedVerdict, *others: SpeedVerdict) -> SpeedVerdict:
    """The verdict of the least determined speed."""
    for other in others:
        lower = least.heading_tolerance <= other.heading_tolerance  # type: ignore[operator]
        least = SpeedVerdict(
            least.verdict if drawing() else where(lower, least.verdict, other.verdict),  # type: ignore[arg-type]
            where(lower, least.heading_tolerance, other.heading_tolerance),  # type: ignore[arg-type]
            least.worst_heading if drawing() else where(lower, least.worst_heading, other.worst_heading),  # type: ignore[arg-type]
            per_degree=where(lower, least.per_degree, other.per_degree),  # type: ignore[arg-type]
        )
    return least


def judge_crossing(verdicts: "Sequence[tuple[Term, SpeedVerdict]]", condition: float) -> None:
    """Refuse two speeds along nearly collinear paths, unless momentum still determines one of them."""
    (first_term, first), (second_term, second) = verdicts
    judge(
        (condition <= ON_ONE_LINE) | (first.heading_tolerance >= CAUTION) | (second.heading_tolerance >= CAUTION),  # type: ignore[operator]
        "the directions of {one} and {other} are too close to one line: their angle condition is {kappa}, above "
        "12, and heading errors of {first:3} and {second:3} change the speeds by a tenth",
        one=first_term.called,
        other=second_term.called,
        kappa=(condition, Ratio),
        first=(first.heading_tolerance, Angle),
        second=(second.heading_tolerance, Angle),
        hint=CROSSING,
        results=(first_term.speed_name, second_term.speed_name),
    )


def verdict_advice(
    unknown: Unknowns, verdicts: "Sequence[tuple[Term, SpeedVerdict]]", condition: float | None
) -> tuple[Advice, ...]:
    """A caution for every speed that a few degrees change by a tenth, with the cause."""
    cautions: list[Advice] = []
    for term, verdict in verdicts:
        tolerance = plain(verdict.heading_tolerance)
        if not single(tolerance) or tolerance >= GOOD:
            continue
        bounded = tolerance > 0.0
        undetermined = verdict.verdict == LEVELS[0]
        near = condition is not None and plain(condition) > NEAR_ONE_LINE
        cautions.append(
            Advice(
                code="undetermined-speed" if undetermined else "sensitive-speed",
                message=worded(
                    ("momentum does not determine the speed of" if undetermined else "headings decide the speed of")
                    + " {name}: one degree of {heading} changes it "
                    + ("by {change:3}" if bounded else "without bound")
                    + ("; the paths are close to one line (angle condition {condition:3})" if near else ""),
                    name=term.called,
                    heading=unknown.heading_in_words(str(verdict.worst_heading)),
                    change=(plain(verdict.per_degree), RoadSpeed),
                    condition=(condition, Ratio),
                ),
                severity="serious" if undetermined else "caution",
                remedy=CROSSING if near else LIGHT,
            )
        )
    return tuple(cautions)


def energy_verdict(speed: float, closing: float, effects: "Sequence[tuple[str, float]]") -> SpeedVerdict:
    """The verdict of a speed, from the effect of relative errors of the quantities behind it.

    For a vehicle that hardly moved, the tenth refers to a quarter of the closing speed.
    """
    worst, steepest = effects[0][0], absolute(effects[0][1])
    for name, effect in effects[1:]:
        steeper = absolute(effect) > steepest
        if not drawing():
            worst = where(steeper, name, worst)  # type: ignore[arg-type,assignment]
        steepest = where(steeper, absolute(effect), steepest)
    tenth, moves = 0.1 * maximum(absolute(speed), 0.25 * closing), steepest > 0.0
    tolerance = where(moves, minimum(tenth / where(moves, steepest, 1.0), 1.0), 1.0)
    plainly = plain(tolerance)
    level = _level(plainly, GOOD_SHARE, CAUTION_SHARE)
    return SpeedVerdict(level, None, None, tolerance, worst)


def energy_advice(verdicts: "Sequence[tuple[str, float, SpeedVerdict]]") -> tuple[Advice, ...]:
    """A caution for every speed that some per cent of a quantity change by a tenth, with the greatest effect of one."""
    cautions: list[Advice] = []
    for name, effect, verdict in verdicts:
        tolerance = plain(verdict.tolerance)
        if tolerance is None or not single(tolerance) or tolerance >= GOOD_SHARE:
            continue
        change = 0.1 * effect
        undetermined = verdict.verdict == LEVELS[0]
        cautions.append(
            Advice(
                code="undetermined-speed" if undetermined else "sensitive-speed",
                message=worded(
                    ("the {quantity} does not determine" if undetermined else "the {quantity} decides")
                    + " the speed of {name}: a tenth of it changes that by {change:3}",
                    quantity=str(verdict.worst_quantity).replace(".", " ").replace("_", " "),
                    name=name,
                    change=(change, RoadSpeed),
                ),
                remedy=MEASURE,
            )
        )
    return tuple(cautions)
