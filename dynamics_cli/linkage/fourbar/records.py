"""Results of `linkage four-bar`, and points of coupler curves."""

from dynamics_cli.quantities import (
    Angle,
    AngularAcceleration,
    Annotated,
    Coordinate,
    PartAcceleration,
    PartPoint,
    PartVelocity,
    Ratio,
    Size,
    Text,
    Torque,
    TurnRate,
)
from dynamics_cli.records import Advice, Check, record


@record
class Step:
    """One crank angle of the table."""

    crank_angle: Annotated[Angle, "Crank angle θ₂ from the line O₂–O₄, counter-clockwise [rad]."]
    coupler_angle: Annotated[Angle | None, "Coupler angle θ₃ [rad]."]
    rocker_angle: Annotated[Angle | None, "Rocker angle θ₄; left out where it turns freely [rad]."]
    coupler_ratio: Annotated[Ratio | None, "ω₃/ω₂; left out at a toggle."]
    rocker_ratio: Annotated[Ratio | None, "ω₄/ω₂; left out at a toggle."]
    rocker_change: Annotated[Ratio | None, "dω₄/dθ₂ over ω₂: α₄/ω₂² of a crank at uniform speed."]
    rocker_speed: Annotated[TurnRate | None, "ω₄ at the speed given; the ratios are where none is given [rad/s]."]
    rocker_acceleration: Annotated[AngularAcceleration | None, "α₄ there [rad/s^2]."]
    transmission_angle: Annotated[Angle, "Angle μ between coupler and rocker [rad]."]


@record
class FourBar:
    """A four-bar in one pose, or its table over the crank angles that it can reach."""

    rocker_angle: Annotated[Angle | None, "Rocker angle θ₄, at O₄ from the line O₂–O₄ on [rad]."] = None
    coupler_angle: Annotated[Angle | None, "Coupler angle θ₃, of the ray from the crank's pin A to B [rad]."] = None
    transmission_angle: Annotated[Angle | None, "Angle μ at B, best at 90 degrees [rad]."] = None
    rocker_ratio: Annotated[Ratio | None, "ω₄/ω₂, the speed of the rocker over that of the crank."] = None
    coupler_ratio: Annotated[Ratio | None, "ω₃/ω₂."] = None
    rocker_speed: Annotated[TurnRate | None, "ω₄ [rad/s]."] = None
    coupler_speed: Annotated[TurnRate | None, "ω₃ [rad/s]."] = None
    rocker_acceleration: Annotated[AngularAcceleration | None, "α₄ [rad/s^2]."] = None
    coupler_acceleration: Annotated[AngularAcceleration | None, "α₃ [rad/s^2]."] = None
    crank_torque: Annotated[Torque | None, "Torque at the crank that balances the load, without friction [N*m]."] = None
    other_rocker_angle: Annotated[Angle | None, "θ₄ on the other branch, at the same crank angle [rad]."] = None
    other_coupler_angle: Annotated[Angle | None, "θ₃ on the other branch [rad]."] = None
    other_rocker_ratio: Annotated[Ratio | None, "ω₄/ω₂ on the other branch."] = None
    crank_pin: Annotated[PartPoint | None, "Pin A of crank and coupler, from O₂ [m]."] = None
    rocker_pin: Annotated[PartPoint | None, "Pin B of coupler and rocker [m]."] = None
    position: Annotated[PartPoint | None, "The coupler point P [m]."] = None
    velocity: Annotated[PartVelocity | None, "Its velocity [m/s]."] = None
    acceleration: Annotated[PartAcceleration | None, "Its acceleration [m/s^2]."] = None
    kind: Annotated[Text | None, "Class of the linkage by Grashof's rule, on the decimals as typed."] = None
    side: Annotated[Text | None, "Which assembly this is."] = None
    swing: Annotated[Angle | None, "Angle through which the rocker swings [rad]."] = None
    rocker_least: Annotated[Angle | None, "Rocker angle at one end of a crank-rocker's swing [rad]."] = None
    rocker_greatest: Annotated[Angle | None, "Rocker angle at the other end [rad]."] = None
    table: Annotated[tuple[Step, ...] | None, "The crank angles that can be reached, where none was given."] = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


@record
class CurvePoint:
    """One point of the curve."""

    crank_angle: Annotated[Angle, "Crank angle θ₂ [rad]."]
    x: Annotated[Coordinate, "The point, from O₂ along O₂–O₄ [m]."]
    y: Annotated[Coordinate, "The point, perpendicular to that line [m]."]
    tangent_angle: Annotated[Angle, "Direction of travel; at a cusp the one in which it leaves [rad]."]


@record
class Special:
    """A cusp, or a point that the curve passes twice."""

    crank_angle: Annotated[Angle, "Crank angle there [rad]."]
    second_crank_angle: Annotated[Angle | None, "Crank angle of the second passage; none of a cusp [rad]."]
    x: Annotated[Coordinate, "The point [m]."]
    y: Annotated[Coordinate, "The point, upwards [m]."]


@record
class Straight:
    """A part of a coupler curve that is straight within a deviation."""

    length: Annotated[Size, "Distance of its ends [m]."]
    crank_angle: Annotated[Angle, "Crank angle at its start [rad]."]
    last_crank_angle: Annotated[Angle, "Crank angle at its end [rad]."]
    deviation: Annotated[Size, "Largest distance from the line [m]."]
    direction: Annotated[Angle, "Direction of the line, from x [rad]."]
    start: Annotated[PartPoint, "The start of the line [m]."]
    end: Annotated[PartPoint, "Its end [m]."]
