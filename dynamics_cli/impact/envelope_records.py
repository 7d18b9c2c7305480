"""What an envelope of ΔV tells: ranges, where they are reached, and a map."""

from dynamics_cli.quantities import AngularSpeed, Count, Energy, Ratio, RoadSpeed, Text
from dynamics_cli.records import Advice, Check, Columns, Numerics, record


@record
class DeltaVRange:
    """Least and greatest ΔV of one body over the region, and where.

    Parameters
    ----------
    least : RoadSpeed
        Least ΔV [m/s].
    greatest : RoadSpeed
        Greatest ΔV [m/s].
    least_restitution : Ratio
        Restitution where it is least [-].
    least_friction : Ratio
        Friction where it is least [-].
    greatest_restitution : Ratio
        Restitution where it is greatest [-].
    greatest_friction : Ratio
        Friction where it is greatest [-].
    """

    least: RoadSpeed
    greatest: RoadSpeed
    least_restitution: Ratio
    least_friction: Ratio
    greatest_restitution: Ratio
    greatest_friction: Ratio


@record
class SpinRange:
    """Least and greatest change of spin of one body over the region.

    Parameters
    ----------
    least : AngularSpeed
        Least change, with its sign [rad/s].
    greatest : AngularSpeed
        Greatest change, with its sign [rad/s].
    """

    least: AngularSpeed
    greatest: AngularSpeed


@record
class EnvelopePoint:
    """One point of the region.

    Parameters
    ----------
    restitution : Ratio
        Restitution [-].
    friction : Ratio
        Friction [-].
    first_delta_v : RoadSpeed
        ΔV of the first body; zero of a fixed one [m/s].
    second_delta_v : RoadSpeed
        ΔV of the second body; zero of a fixed one [m/s].
    impulse_ratio : Ratio
        Tangential over normal impulse [-].
    energy_lost : Energy
        Kinetic energy lost [J].
    """

    restitution: Ratio
    friction: Ratio
    first_delta_v: RoadSpeed
    second_delta_v: RoadSpeed
    impulse_ratio: Ratio
    energy_lost: Energy


@record
class Envelope:
    """ΔV over a region of restitution and friction.

    Parameters
    ----------
    first_delta_v : DeltaVRange
        ΔV of the first body.
    second_delta_v : DeltaVRange
        ΔV of the second body; none of a fixed one.
    first_spin_change : SpinRange
        Change of spin of the first body.
    second_spin_change : SpinRange
        Change of spin of the second body; none of a fixed one.
    least_energy_lost : Energy
        Least energy lost [J].
    greatest_energy_lost : Energy
        Greatest energy lost [J].
    law : Text
        The law.
    points : Count
        Points of the region that were calculated.
    refused : Count
        Points where the law has no answer or gains energy; they are left out.
    slip_share : Ratio
        Share of the points where friction is fully used: slip never stops or the ratio is at its limit [-].
    map : Columns of EnvelopePoint
        A coarse map of the region; refused points are left out.
    """

    first_delta_v: DeltaVRange
    second_delta_v: DeltaVRange | None
    first_spin_change: SpinRange
    second_spin_change: SpinRange | None
    least_energy_lost: Energy
    greatest_energy_lost: Energy
    law: Text
    points: Count
    refused: Count
    slip_share: Ratio
    map: Columns[EnvelopePoint]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None
