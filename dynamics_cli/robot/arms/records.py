"""An arm as users write it: a table of Denavit–Hartenberg parameters, lengths of a planar arm, or a published arm."""

from dynamics_cli.quantities import (
    Angle,
    Annotated,
    Coordinate,
    Inertia,
    InertiaTensor,
    Mass,
    PartPosition,
    Ratio,
    Size,
    Text,
    Torque,
    TorsionDamping,
)
from dynamics_cli.records import Choice, record


class Convention(Choice):
    """Order of the four motions of a row of the table."""

    names = ("standard", "modified")
    aliases = {"craig": "modified", "mdh": "modified", "dh": "standard", "paul": "standard", "classic": "standard"}  # noqa: RUF012


class JointType(Choice):
    """What a joint does."""

    names = ("revolute", "prismatic")
    aliases = {"pin": "revolute", "r": "revolute", "hinge": "revolute", "slide": "prismatic", "p": "prismatic"}  # noqa: RUF012


ORIGIN = (0.0, 0.0, 0.0)
POINT = (ORIGIN, ORIGIN, ORIGIN)
# Descriptions of parameters that several tasks have.
ANGLES = "Angles of the revolute joints in order, e.g. 20, 40, -30, 0, 60, 0 deg."
SLIDES = "Travels of the prismatic joints in order, e.g. 120 mm."
REVOLUTE, PRISMATIC = JointType("revolute"), JointType("prismatic")
STANDARD = Convention("standard")


@record
class Joint:
    """One row of the table: a joint with the link after it."""

    a: Annotated[Coordinate, "Length of the link along x, e.g. 431.8 mm."] = 0.0
    alpha: Annotated[Angle, "Twist of the link about x, e.g. 90 deg."] = 0.0
    d: Annotated[Coordinate, "Offset along the joint's axis z, e.g. 150 mm."] = 0.0
    theta: Annotated[Angle, "Angle about z; a revolute joint turns on from it, e.g. -90 deg."] = 0.0
    type: Annotated[JointType, "revolute, or prismatic: then the joint's travel adds to d."] = REVOLUTE
    lower: Annotated[Angle | None, "Lower limit of a revolute joint, e.g. -160 deg."] = None
    upper: Annotated[Angle | None, "Its upper limit, e.g. 160 deg."] = None
    lower_travel: Annotated[Coordinate | None, "Lower limit of a prismatic joint, e.g. 0 mm."] = None
    upper_travel: Annotated[Coordinate | None, "Its upper limit, e.g. 300 mm."] = None
    name: Annotated[Text, "Its name, e.g. shoulder."] = ""
    mass: Annotated[Mass, "Mass of the link after it, for `torque`, e.g. 4.8 kg."] = 0.0
    centroid: Annotated[PartPosition, "The link's mass centre in the axes of its frame, e.g. -200, 0, 0 mm."] = ORIGIN
    tensor: Annotated[
        InertiaTensor | None, "The link's inertia about its mass centre in these axes; nothing: all mass is there."
    ] = None
    rotor_inertia: Annotated[Inertia, "Moment of inertia of the motor's rotor, e.g. 2e-4 kg*m^2."] = 0.0
    gear_ratio: Annotated[Ratio, "Turns of the motor per turn of the joint, e.g. 62.6."] = 1.0
    viscous: Annotated[TorsionDamping, "Viscous friction at the joint, e.g. 5 N*m*s/rad."] = 0.0
    coulomb: Annotated[Torque, "Dry friction at the joint, e.g. 8 N*m."] = 0.0
    coulomb_back: Annotated[Torque | None, "The same where the joint moves back, unless it is equal."] = None


@record
class Arm:
    """A serial arm, from its base to its hand."""

    robot: Annotated[Text, "A published arm: puma-560."] = ""
    lengths: Annotated[tuple[Size, ...], "Links of a planar arm of revolute joints, e.g. 500, 400, 200 mm."] = ()
    masses: Annotated[tuple[Mass, ...], "Their masses, of uniform rods, for `torque`, e.g. 6, 4, 1 kg."] = ()
    lower: Annotated[tuple[Angle, ...], "Lower limits of its joints, e.g. -90, -150, -120 deg."] = ()
    upper: Annotated[tuple[Angle, ...], "Their upper limits, e.g. 90, 150, 120 deg."] = ()
    convention: Annotated[
        Convention | None,
        "Of the table of joints: standard turns θ and shifts d, then shifts a and turns α; modified (Craig) turns α "
        "and shifts a first. There is no default: the same table gives another arm.",
    ] = None
    joints: Annotated[tuple[Joint, ...], "Rows of the table of Denavit–Hartenberg parameters, from the base on."] = ()
    tool: Annotated[PartPosition, "The tool's tip in the axes of the last link, e.g. 0, 0, 120 mm."] = (0.0, 0.0, 0.0)
