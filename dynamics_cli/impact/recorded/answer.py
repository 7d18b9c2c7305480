"""The result of a recorded crash, with its checks against the record itself."""

from dynamics_cli.errors import require, worded
from dynamics_cli.impact.conventions import DeltaV, conventions, delta_v, direction_of, heading_of
from dynamics_cli.impact.diagnostics import balance
from dynamics_cli.impact.recorded.records import OtherVehicle, RecordedVehicle, RecordResult
from dynamics_cli.impact.recorded.scene import Crash, Pair, float_like, plus
from dynamics_cli.numerics.elementary import absolute, hypot, maximum, where
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.numerics.vectors import planar_cross as cross
from dynamics_cli.numerics.vectors import planar_dot as dot
from dynamics_cli.quantities import AngularSpeed, Energy, Ratio, RoadSpeed, Speed
from dynamics_cli.records import Advice, Check, record

# Three degrees of tolerance are good, as for momentum.
GOOD, CAUTION = 0.05235987755982989, 0.017453292519943295
# The rule's resolution of ΔV: 1 km/h.
RESOLUTION = 0.2777777777777778
# Relative to the slip before: below this the contact points reach a common velocity.
COMMON = 0.05
SPINS_DIFFER = 0.2


@record
class Found:
    """Results of a model: the inward normal, restitution, closing speed and the other's velocity, with limits."""

    inward: "Pair | None"
    restitution: "float | None"
    closing: "float | None"
    speeds: "tuple[float, float] | None"
    velocity: "Pair | None"
    other: "tuple[float, float, float] | None"
    in_line: bool = False
    bearing: "float | None" = None
    worst: "str | None" = None
    per_degree: "float | None" = None
    bend: bool = False


class Contact:
    """Slip before and after, ratio of impulses and energy lost."""

    def __init__(self, crash: Crash, values: Found) -> None:
        self.before: float | None = None
        self.after: float | None = None
        self.ratio: float | None = None
        self.lost: float | None = None
        p, gained = crash.impulse, crash.gained()
        if values.inward is None:
            return
        across = 0.0 - values.inward[1], values.inward[0]
        if crash.before is None or values.velocity is None:
            # in line, the impulse has no transverse component
            closing, e = float_like(values.closing), float_like(values.restitution)
            self.lost = 0.5 * crash.size * closing * (1.0 - e)
            return
        relative = plus(crash.contact(crash.one, crash.before), crash.contact(crash.two, values.velocity), -1.0)
        leaving = plus(relative, gained)
        self.before = dot(relative, across)
        self.after = dot(leaving, across)
        self.ratio = dot(p, across) / dot(p, values.inward)
        lost = -0.5 * (dot(p, relative) + dot(p, leaving))
        self.lost = lost
        require(
            lost >= -1e-12 * (absolute(dot(p, relative)) + absolute(dot(p, leaving))),
            "no crash can give this record: the impact would have given {energy:3} to the vehicles",
            energy=(0.0 - lost, Energy),
            code="energy-gained",
            hint="check signs of ΔV, the normal, the nose and the headings",
        )


def answer(crash: Crash, values: Found) -> RecordResult:
    """The complete answer from record and model."""
    require(
        crash.tolerance < 1.0,
        "a tolerance of the record of 100 % or more: it contains no information",
        code="tolerance",
    )
    contact = Contact(crash, values)
    first = _first(crash)
    verdict = None
    if values.bearing is not None:
        angle = plain(values.bearing)
        verdict = where(angle >= GOOD, "good", where(angle >= CAUTION, "caution", "undetermined"))  # type: ignore[arg-type]
    low, high = values.speeds or (None, None)
    return RecordResult(
        first=first,
        second=_second(crash, values),
        closing_speed=values.closing,
        closing_speed_low=low,
        closing_speed_high=high,
        restitution=values.restitution,
        impulse=crash.size,
        impulse_heading=heading_of(*crash.impulse, crash.axes),
        impulse_ratio=contact.ratio,
        slip_before=contact.before,
        slip_after=contact.after,
        energy_lost=contact.lost,
        heading_tolerance=values.bearing,
        worst_heading=values.worst,
        per_degree=values.per_degree,
        verdict=verdict,  # type: ignore[arg-type]
        conventions=conventions(crash.axes, crash.zero),
        checks=_energy(crash, values, contact),
        advice=_advice(crash, values, contact, first),
    )


def _change(crash: Crash, mass: float, sense: float, nose: Pair, travel: Pair) -> DeltaV:
    push = sense * crash.impulse[0], sense * crash.impulse[1]
    return delta_v(push, mass, nose, axes=crash.axes, pdof_zero=crash.zero, travel=travel)


def _first(crash: Crash) -> RecordedVehicle:
    nose = direction_of(crash.given.nose, crash.axes)
    change = _change(crash, float_like(crash.one.mass), 1.0, nose, crash.travel)
    speed = heading = None
    if crash.before is not None:
        leaving = plus(crash.before, crash.change)
        speed, heading = hypot(*leaving), heading_of(*leaving, crash.axes)
    return RecordedVehicle(
        delta_v=change,
        delta_v_low=(1.0 - crash.tolerance) * change.magnitude,
        delta_v_high=(1.0 + crash.tolerance) * change.magnitude,
        spin_change=crash.spin_change(crash.one, 1.0),
        exit_speed=speed,
        exit_heading=heading,
    )


def _second(crash: Crash, values: Found) -> OtherVehicle:
    other = crash.other
    heading = other.approach_heading
    if heading is None:
        # in line the other faces the force, unless its nose is given
        heading = heading_of(*crash.impulse, crash.axes)
    travel = direction_of(heading, crash.axes)
    nose = travel if other.nose is None else direction_of(other.nose, crash.axes)
    speed, low, high = values.other or (None, None, None)
    after = exit_heading = None
    if values.velocity is not None:
        leaving = plus(values.velocity, crash.second_change)
        after, exit_heading = hypot(*leaving), heading_of(*leaving, crash.axes)
    shown_heading: float | None = None if speed is None else heading
    if values.in_line and speed is not None:
        back = heading_of(0.0 - crash.impulse[0], 0.0 - crash.impulse[1], crash.axes)
        towards = speed >= 0.0
        ends = where(towards, low, 0.0 - high), where(towards, high, 0.0 - low)  # type: ignore[operator,arg-type]
        low, high = maximum(ends[0], 0.0), ends[1]
        shown_heading, speed = where(towards, heading, back), absolute(speed)
    return OtherVehicle(
        delta_v=_change(crash, float_like(crash.two.mass), -1.0, nose, travel),
        approach_speed=speed,
        approach_speed_low=low,
        approach_speed_high=high,
        approach_heading=shown_heading,
        exit_speed=after,
        exit_heading=exit_heading,
        spin_change=crash.spin_change(crash.two, -1.0),
    )


def _energy(crash: Crash, values: Found, contact: Contact) -> "tuple[Check, ...]":
    """The energy lost in the contact against the kinetic energies of both vehicles."""
    if crash.before is None or values.velocity is None or contact.lost is None:
        return ()
    change = size = 0.0
    for body, velocity, sense in ((crash.one, crash.before, 1.0), (crash.two, values.velocity, -1.0)):
        push = sense * crash.impulse[0], sense * crash.impulse[1]
        work = dot(push, velocity), 0.5 * dot(push, push) / float_like(body.mass)
        change, size = change + work[0] + work[1], size + absolute(work[0]) + work[1]
        if body.inertia is not None:
            moment = cross(body.lever, push)
            turning = moment * body.spin, 0.5 * moment * moment / body.inertia
            change, size = change + turning[0] + turning[1], size + absolute(turning[0]) + turning[1]
    return balance("energy", change, 0.0 - contact.lost, size)


def _advice(crash: Crash, values: Found, contact: Contact, first: RecordedVehicle) -> "tuple[Advice, ...]":
    if not single(crash.size):
        return ()
    cautions: list[Advice] = []
    if crash.final_change is not None and plain(crash.final_change) > RESOLUTION:
        text = worded(
            "ΔV is a lower bound: over its last 20 ms it still changed by {change:2}, more than the resolution of "
            "1 km/h",
            change=(crash.final_change, RoadSpeed),
        )
        remedy = "take the speeds as minimum values; a longer record, or the other vehicle's, closes the gap"
        cautions.append(Advice(code="lower-bound", message=text, severity="serious", remedy=remedy))
    recorded, implied = crash.given.spin_change, first.spin_change
    if recorded is not None and implied is not None:
        gap = abs(plain(recorded) - plain(implied))
        if gap > SPINS_DIFFER * max(abs(plain(recorded)), abs(plain(implied))):
            # one unit: the recorded as it was typed, the other as so many times it
            share = abs(plain(implied) / plain(recorded)) if plain(recorded) else 0.0
            against = ", the other way round" if plain(implied) * plain(recorded) < 0.0 else ""
            text = worded(
                "the impulse at this lever gives a change of spin of {implied:3}; none was recorded"
                if not share
                else "the impulse at this lever gives {share:2} times the recorded spin change, {recorded:3}{against}",
                implied=(implied, AngularSpeed),
                recorded=(recorded, AngularSpeed),
                share=(share, Ratio),
                against=against,
            )
            cautions.append(Advice(code="spin-differs", message=text, remedy="check the lever, the inertia and signs"))
    cautions += _contact_advice(crash, values, contact)
    if crash.one.inertia is None or crash.two.inertia is None:
        text = worded("levers and inertias of both are not given: turning is neglected")
        remedy = "give them if the force does not pass through a mass centre: the closing speed becomes larger"
        cautions.append(Advice(code="no-turning", message=text, severity="note", remedy=remedy))
    return tuple(cautions)


def _contact_advice(crash: Crash, values: Found, contact: Contact) -> "list[Advice]":
    cautions: list[Advice] = []
    if contact.before is not None and contact.after is not None:
        before, after = plain(contact.before), plain(contact.after)
        if before * after < 0.0 and abs(after) > COMMON * abs(before):
            text = worded(
                "the tangential impulse is more than friction gives: the slip would turn from {before:3} to {after:3}",
                before=(before, Speed),
                after=(after, Speed),
            )
            cautions.append(Advice(code="slip-reversed", message=text, remedy="check normal, nose and headings"))
    bounce = values.restitution
    if values.bend and bounce is not None:
        value = plain(bounce)
        low, high = (0.0, 1.0) if None in crash.restitutions else (plain(end) for end in crash.restitutions)
        if not low <= value <= high:
            text = worded(
                "the headings imply a restitution of {e:3}, outside {low:2} to {high:2}",
                e=(value, Ratio),
                low=(low, Ratio),
                high=(high, Ratio),
            )
            remedy = "headings and restitution contradict each other: check the normal and the exit heading"
            cautions.append(Advice(code="restitution-differs", message=text, remedy=remedy))
    return cautions
