"""A single muscle that stands for all of a joint: its force, and compression and shear of the joint."""

from dynamics_cli.errors import require
from dynamics_cli.human.bodies.figure import Figure
from dynamics_cli.numerics.elementary import absolute, cos, sin
from dynamics_cli.quantities import Annotated, Force, Length, Size, Text
from dynamics_cli.records import Choice, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# The segment along which the muscle pulls, and which carries the compression.
ALONG = {
    "hip": "trunk", "back": "trunk", "knee": "shank", "ankle": "shank", "elbow": "upper arm", "neck": "head",
    "shoulder": "upper arm", "wrist": "forearm",
}  # fmt: skip


class MuscleJoint(Choice):
    """The joint that a muscle crosses; the back is at the level of the hips."""

    names = tuple(ALONG)


@record
class Muscle:
    """A muscle by its lever about a joint."""

    joint: Annotated[MuscleJoint, "The joint it crosses: back, knee, ankle, elbow, …"]
    lever: Annotated[Size, "Distance of its line from the joint, e.g. 5 cm."]


@record
class MuscleLoad:
    """The force of a single muscle, both sides together, and what the joint carries."""

    joint: Annotated[Text, "The joint."]
    muscles: Annotated[Text, "Which muscles pull."]
    force: Annotated[Force, "Force of the muscle [N]."]
    compression: Annotated[Force, "Force along the segment that presses the joint together [N]."]
    shear: Annotated[Force, "Force across the segment [N]."]
    lever: Annotated[Length, "The lever of the muscle [m]."]


def muscle_loads(muscles: "tuple[Muscle, ...]", figure: Figure, joints: "dict[str, Any]") -> "tuple[MuscleLoad, ...]":
    """F = |M|/b; the net force of the joint along and across the segment beside which the muscle runs.

    Several muscles across one joint are refused: equilibrium has one equation for them.
    """
    crossed: dict[str, int] = {}
    for muscle in muscles:
        joint = "hip" if muscle.joint == "back" else str(muscle.joint)
        crossed[joint] = crossed.get(joint, 0) + 1
    for joint, count in crossed.items():
        require(
            count == 1, "{count} muscles cross the {joint}: {count} unknown forces, one equation of moments",
            count=count, joint=joint, code="undetermined",
            hint="give one equivalent muscle; sharing among several takes a criterion, which mechanics does not have",
        )  # fmt: skip
    return tuple(_load(muscle, figure, joints) for muscle in muscles)


def _load(muscle: Muscle, figure: Figure, joints: "dict[str, Any]") -> MuscleLoad:
    require(
        muscle.lever > 0.0, "the lever of {lever} is not above zero", lever=(muscle.lever, Length), code="lever",
        hint="give the distance of the muscle's line from the joint",
    )  # fmt: skip
    joint = joints["hip" if muscle.joint == "back" else str(muscle.joint)]
    pull = absolute(joint.moment) / muscle.lever
    inclination = figure.inclinations[ALONG[muscle.joint]]
    along, across = cos(inclination), sin(inclination)
    forward, up = joint.force
    return MuscleLoad(
        joint=str(muscle.joint),
        muscles=joint.muscles,
        force=pull,
        compression=pull + (forward * along + up * across),
        shear=up * along - forward * across,
        lever=muscle.lever,
    )
