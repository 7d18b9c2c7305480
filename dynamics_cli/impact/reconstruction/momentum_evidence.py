"""Verdicts, physical refusals, checks and advice of a momentum reconstruction."""

from dynamics_cli.errors import (
    require,
    worded,
)
from dynamics_cli.impact.diagnostics import balance, not_above
from dynamics_cli.impact.reconstruction.momentum_records import MomentumResult, Reconstructed
from dynamics_cli.impact.reconstruction.momentum_terms import Term
from dynamics_cli.impact.reconstruction.momentum_verdict import (
    ENERGY,
    SpeedVerdict,
    energy_advice,
    energy_verdict,
    worse,
)
from dynamics_cli.numerics.elementary import absolute, cos, sin, where
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.numerics.road.drag import speed_advice
from dynamics_cli.quantities import Energy, Fraction, Ratio, RoadSpeed
from dynamics_cli.records import Advice, Check

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def with_verdicts(
    answer: MomentumResult, terms: list[Term], verdicts: list[tuple[Term, SpeedVerdict]], condition: float | None
) -> MomentumResult:
    """The answer with the verdict of every vehicle's reconstructed speed, and the worse of the two."""
    sides: dict[str, object] = {}
    for side, own_terms in (("first", terms[::2]), ("second", terms[1::2])):
        cautions = [item for term, item in verdicts if term in own_terms]
        if cautions:
            body = getattr(answer, side)
            sides[side] = Reconstructed(**{**body.__dict__, "determined": worse(*cautions)})
    overall = worse(*(item for _, item in verdicts)).verdict if verdicts else None
    return MomentumResult(**{**answer.__dict__, **sides, "angle_condition": condition, "verdict": overall})


def with_energy_verdicts(
    answer: MomentumResult, terms: list[Term], after: tuple[float, float], energy: float, side: float
) -> MomentumResult:
    """The answer with the verdict of both speeds, from the energy and the speeds after.

    Speeds `after` are along the line; `side` is 1 where the first vehicle closed in on the second, else −1.
    """
    closing, apart = answer.closing_along_impulse, after[1] - after[0]
    total = terms[0].mass + terms[1].mass
    sides: dict[str, Any] = {}
    verdicts = []
    for name, term, other, sense in (("first", terms[0], terms[1], side), ("second", terms[1], terms[0], -side)):
        # by the speeds after, which shift the common speed and the closing one
        turned = sense * (other.mass / total) * (apart / closing)
        steep = terms[0].mass / total - turned, terms[1].mass / total + turned
        effects = [(ENERGY, sense * energy / (term.mass * closing))]
        effects += [
            (first.speed_name, slope * speed) for first, slope, speed in zip(terms[2:], steep, after, strict=True)
        ]
        verdict = energy_verdict(term.speed, closing, effects)  # type: ignore[arg-type]
        most = max(abs(plain(effect)) for _, effect in effects) if single(closing) else 0.0
        verdicts.append((term.called, most, verdict))
        sides[name] = Reconstructed(**{**getattr(answer, name).__dict__, "determined": verdict})
    (_, _, first), (_, _, second) = verdicts
    worst = where(first.tolerance <= second.tolerance, first.verdict, second.verdict)  # type: ignore[operator,arg-type]
    advice = energy_advice(verdicts) + answer.advice
    return MomentumResult(**{**answer.__dict__, **sides, "verdict": worst, "advice": advice})


def certified(answer: MomentumResult, terms: list[Term], *, check: bool, along: float | None = None) -> MomentumResult:
    """The answer with its checks and advice; refused when the impulse pulls or energy would be gained."""
    size = sum((absolute(t.amount) for t in terms[1:]), absolute(terms[0].amount))
    work = answer.impulse * answer.closing_speed + absolute(answer.energy_lost)
    if check or along is not None:
        require(
            answer.closing_along_impulse >= -1e-9 * answer.closing_speed,
            "the vehicles would part along the impulse, at {speed}, before they meet: the impulse would pull",
            speed=(0.0 - answer.closing_along_impulse, RoadSpeed),
            code="pull",
            hint="check that headings are directions of travel",
        )
        require(
            answer.energy_lost >= -1e-9 * work,
            "the impact would have given {energy} to the vehicles",
            energy=(0.0 - answer.energy_lost, Energy),
            code="energy-gained",
            hint="check the speeds after and the headings",
        )
    checks: tuple[Check, ...] = ()
    if check and single(size):
        for name, turn in (("momentum along heading zero", cos), ("momentum across heading zero", sin)):
            sides = [t.mass * t.speed * turn(t.heading) for t in terms]  # type: ignore[operator,arg-type]
            checks += balance(name, sides[0] + sides[1], sides[2] + sides[3], size)
    # the second path may bend from the line by a few degrees, which is neglected
    straight = check if along is None else _straight(terms)
    if along is not None and straight:
        sides = [t.mass * t.speed * cos(t.heading - along) for t in terms]  # type: ignore[operator]
        checks += balance("momentum along the line", sides[0] + sides[1], sides[2] + sides[3], size)
    if straight:
        changes = answer.first.energy_change + answer.second.energy_change
        # the lost energy is a difference of these
        kinetic = [0.5 * absolute(t.amount) * t.speed for t in terms]  # type: ignore[operator]
        checks += balance(
            "energy", changes, -answer.energy_lost, work + kinetic[0] + kinetic[1] + kinetic[2] + kinetic[3]
        )
    checks += not_above("no energy is gained", -answer.energy_lost, 0.0, work) if check else ()
    return MomentumResult(
        **{**answer.__dict__, "checks": checks, "advice": _beyond_roads(answer, terms) + _advice(answer, size)}
    )


def _beyond_roads(answer: MomentumResult, terms: list[Term]) -> tuple[Advice, ...]:
    """A caution for a speed that no vehicle has on a road."""
    cautions: tuple[Advice, ...] = ()
    for body, term in zip((answer.first, answer.second), terms, strict=False):
        cautions += speed_advice(
            body.approach_speed, f"a speed of {term.called}", "check the masses, the speeds after and their units"
        )
    return cautions


def _straight(terms: list[Term]) -> bool:
    """Whether all four vectors lie on one line; False for arrays."""
    bends = [absolute(sin(t.heading - terms[0].heading)) for t in terms[1:]]  # type: ignore[operator]
    return single(*bends) and all(plain(bend) <= 1e-9 for bend in bends)


def _advice(answer: MomentumResult, size: float) -> tuple[Advice, ...]:
    if not single(size, answer.impulse):
        return ()
    cautions: list[Advice] = []
    if answer.closure is not None and plain(answer.closure) > 0.01 * plain(size):
        relative = plain(answer.closure) / plain(size)
        cautions.append(
            Advice(
                code="momentum-not-closed",
                message=worded("momentum does not close: {share:3} of all momenta remain", share=(relative, Fraction)),
                severity="serious" if relative > 0.05 else "caution",
                remedy="leave out the least certain quantity and let momentum give it",
            )
        )
    bounce = plain(answer.restitution)
    if bounce > 0.6 or bounce < -0.05:
        word = "high for vehicles" if bounce > 0.6 else "negative: their mass centres pass each other (a sideswipe?)"
        text = worded("restitution along the impulse is {bounce:3}, {word}", bounce=(bounce, Ratio), word=word)
        cautions.append(Advice(code="odd-restitution", message=text))
    return tuple(cautions)
