"""Results of an envelope: ranges of ΔV, where they are reached, and a map."""

from dynamics_cli.quantities import AngularSpeed, Annotated, Count, Energy, Ratio, RoadSpeed, Text
from dynamics_cli.records import Advice, Check, Columns, Numerics, record


@record
class DeltaVRange:
    """Least and greatest ΔV of one body over the region, and where."""

    least: Annotated[RoadSpeed, "Least ΔV [m/s]."]
    greatest: Annotated[RoadSpeed, "Greatest ΔV [m/s]."]
    least_restitution: Annotated[Ratio, "Restitution where it is lowest [-]."]
    least_friction: Annotated[Ratio, "Friction where it is lowest [-]."]
    greatest_restitution: Annotated[Ratio, "Restitution where it is highest [-]."]
    greatest_friction: Annotated[Ratio, "Friction where it is highest [-]."]


@record
class SpinRange:
    """Least and greatest change of spin of one body over the region."""

    least: Annotated[AngularSpeed, "Least change, with its sign [rad/s]."]
    greatest: Annotated[AngularSpeed, "Greatest change, with its sign [rad/s]."]


@record
class EnvelopePoint:
    """One point of the region."""

    restitution: Annotated[Ratio, "Restitution [-]."]
    friction: Annotated[Ratio, "Friction [-]."]
    first_delta_v: Annotated[RoadSpeed, "ΔV of the first body; zero of a fixed one [m/s]."]
    second_delta_v: Annotated[RoadSpeed, "ΔV of the second body; zero of a fixed one [m/s]."]
    impulse_ratio: Annotated[Ratio, "Tangential over normal impulse [-]."]
    energy_lost: Annotated[Energy, "Kinetic energy lost [J]."]


@record
class Envelope:
    """ΔV over a region of restitution and friction."""

    first_delta_v: Annotated[DeltaVRange, "ΔV of the first body."]
    second_delta_v: Annotated[DeltaVRange | None, "ΔV of the second body; absent for a fixed one."]
    first_spin_change: Annotated[SpinRange, "Change of spin of the first body."]
    second_spin_change: Annotated[SpinRange | None, "Change of spin of the second body; absent for a fixed one."]
    least_energy_lost: Annotated[Energy, "Least energy lost [J]."]
    greatest_energy_lost: Annotated[Energy, "Greatest energy lost [J]."]
    law: Annotated[Text, "The law."]
    points: Annotated[Count, "Points of the region that were calculated."]
    refused: Annotated[Count, "Points where the law has no answer or gains energy; they are left out."]
    slip_share: Annotated[
        Ratio, "Share of the points where friction is fully used: slip never stops or the ratio is at its limit [-]."
    ]
    map: Annotated[Columns[EnvelopePoint], "A coarse map of the region; refused points are left out."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None
