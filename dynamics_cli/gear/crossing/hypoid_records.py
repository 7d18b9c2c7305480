"""Results of a hypoid pair."""

from dynamics_cli.quantities import Angle, Annotated, Coordinate, Curvature, Ratio, ShaftSpeed, Size, Speed
from dynamics_cli.records import Advice, Check, record


@record
class HypoidData:
    """The pitch point of a hypoid pair."""

    ratio: Annotated[Ratio, "Gear ratio u = z₂/z₁."]
    first_pitch_angle: Annotated[Angle, "Pitch angle of the pinion δ₁ [rad]."]
    second_pitch_angle: Annotated[Angle, "Pitch angle of the wheel δ₂ [rad]."]
    first_spiral_angle: Annotated[Angle, "Spiral angle of the pinion β₁ [rad]."]
    second_spiral_angle: Annotated[Angle, "Spiral angle of the wheel β₂ [rad]."]
    axial_offset_angle: Annotated[Angle, "Offset angle in the axial plane of the wheel, η [rad]."]
    pitch_offset_angle: Annotated[Angle, "Offset angle in the pitch plane, ε' = β₁ − β₂ [rad]."]
    first_pitch_radius: Annotated[Size, "Pitch radius of the pinion r₁ [m]."]
    second_pitch_radius: Annotated[Size, "Pitch radius of the wheel r₂ [m]."]
    first_cone_distance: Annotated[Size, "Cone distance of the pinion R₁ [m]."]
    second_cone_distance: Annotated[Size, "Cone distance of the wheel R₂ [m]."]
    offset: Annotated[Coordinate | None, "Hypoid offset E that follows from both spiral angles [m]."]
    enlargement: Annotated[Ratio, "Ratio of the pinion radius to that of a bevel pinion with the same wheel and ratio."]
    normal_module: Annotated[Size, "Mean normal module [m]."]
    first_apex_distance: Annotated[
        Coordinate,
        "From the axes' crossing point to the apex of the pinion, along its axis towards the pitch point [m].",
    ]
    second_apex_distance: Annotated[
        Coordinate,
        "From the axes' crossing point to the apex of the wheel, along its axis away from the pitch point [m].",
    ]
    limit_pressure_angle: Annotated[
        Angle, "Limit pressure angle α_lim, about which the flanks' pressure angles are balanced [rad]."
    ]
    limit_curvature: Annotated[Curvature, "Limit normal curvature of the teeth's lengthwise curve, 1/ρ_lim [1/m]."]
    sliding_ratio: Annotated[Ratio, "Lengthwise sliding over the speed of the wheel's pitch point."]
    sliding_speed: Annotated[Speed | None, "Sliding velocity along the teeth [m/s]."]
    second_speed: Annotated[ShaftSpeed | None, "Speed of the wheel [rad/s]."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
