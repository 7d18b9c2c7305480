"""Tooth forces, bearing loads, and losses by sliding."""

from dynamics_cli.errors import require
from dynamics_cli.gear.pair.engagement import Engagement, Path
from dynamics_cli.numerics.elementary import absolute, cos, pi_beside, sqrt, tan
from dynamics_cli.quantities import Annotated, Coordinate, Force, Size, Text
from dynamics_cli.records import record


@record
class Bearings:
    """Positions of a shaft's bearings, measured from the middle of its gear."""

    left: Annotated[
        Coordinate,
        "Distance to the bearing on the side that the axial coordinate leaves (negative beyond the gear), e.g. 50 "
        "mm [m].",
    ]
    right: Annotated[
        Coordinate, "Distance to the bearing on the other side (negative: the gear overhangs), e.g. 50 mm [m]."
    ]


@record
class ToothForces:
    """Components of the tooth force on the first gear; on the second they are opposite."""

    tangential: Annotated[
        Force, "Tangential force F_t at the working pitch circle, against the rotation of the first gear [N]."
    ]
    radial: Annotated[
        Force, "Radial force F_r, towards the centre of the first gear (of an internal one: away from it) [N]."
    ]
    axial: Annotated[
        Force, "Axial force F_x on the first gear, positive to the right seen with its nearer side turning upwards [N]."
    ]
    normal: Annotated[Force, "Force F_bn along the normal of the flank [N]."]


@record
class BearingLoad:
    """The load of one bearing."""

    shaft: Annotated[Text, "Whose shaft."]
    bearing: Annotated[Text, "Left or right of the gear."]
    tangential: Annotated[Force, "Component along the tangential force, as a reaction [N]."]
    radial: Annotated[Force, "Component along the radial force, as a reaction [N]."]
    total: Annotated[Force, "Radial load of the bearing [N]."]
    axial: Annotated[Force, "Axial load of the shaft, which one of its bearings takes [N]."]


def tooth_forces(mesh: Engagement, torque: float, hand: str) -> ToothForces:
    """F_t = 2T/d_w1, F_r = F_t tan α_wt, F_x = F_t tan β_w, F_bn = F_t/(cos α_wt cos β_b) (ISO 21771)."""
    first = mesh.first
    working = mesh.working_diameter(first)
    tangential = 2.0 * torque / working
    lean = tan(first.helix_angle) * working / first.reference_diameter
    axial = tangential * lean
    normal = tangential / (cos(mesh.angle) * cos(first.base_helix_angle))
    return ToothForces(tangential, tangential * tan(mesh.angle), axial if hand == "right" else -axial, normal)


def bearing_loads(name: str, forces: ToothForces, radius: float, bearings: Bearings) -> tuple[BearingLoad, ...]:
    """Reactions of two bearings: the axial force acts at the working pitch radius and tilts the shaft."""
    span = bearings.left + bearings.right
    require(
        span > 0.0,
        "the bearings of the {name} shaft are {span:6} apart",
        name=name,
        span=(span, Size),
        code="bearings",
        hint="the distances to left and right must add up to more than zero",
    )
    tilt = forces.axial * radius
    loads = []
    for side, far, moment in (("left", bearings.right, -tilt), ("right", bearings.left, tilt)):
        tangential = forces.tangential * far / span
        radial = (forces.radial * far + moment) / span
        total = sqrt(tangential * tangential + radial * radial)
        loads.append(BearingLoad(name, side, tangential, radial, total, absolute(forces.axial)))
    return tuple(loads)


def loss_factor(mesh: Engagement, path: Path) -> float:
    """H_v = π(1/z₁ + 1/z₂)(1 − ε_α + ε₁² + ε₂²)/cos β_b: friction losses over friction and power (Ohlendorf 1958)."""
    pitch = mesh.first.base_pitch
    recess = (path.end - mesh.pitch_curvature) / pitch
    approach = (mesh.pitch_curvature - path.start) / pitch
    reciprocal_sum = (mesh.first.teeth + mesh.second.teeth) / (mesh.first.teeth * mesh.second.teeth)
    shape = 1.0 - (recess + approach) + recess * recess + approach * approach
    return pi_beside(reciprocal_sum, shape) * reciprocal_sum * shape / cos(mesh.first.base_helix_angle)
