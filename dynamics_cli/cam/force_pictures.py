"""Pictures of the forces on a cam: what the cam gives its follower, the contact force and the torque over the turn."""

from dynamics_cli.cam.followers import Rotation
from dynamics_cli.cam.force_records import Forces, Train
from dynamics_cli.cam.loads import load_of
from dynamics_cli.cam.motion_pictures import bands, sampled
from dynamics_cli.cam.program import Program, motion_of
from dynamics_cli.pictures import Axis, Band, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import Angle, Coordinate, Force, Torque

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def forces(
    result: Forces,
    scene: Program,
    program: str = "",
    *,
    shaft_speed: float,
    train: Train,
    follower: "Any" = None,
    rotation: str = Rotation.names[0],
    **given: "Any",
) -> Picture:
    """Draw lift, force (or an arm's torque), contact force and shaft torque over the turn; below zero it leaves.

    Parameters
    ----------
    result : Forces
        What `cam force` found.
    scene : Program
        The program from a file.
    program : str
        The program in one line.
    shaft_speed : float
        Speed of the cam shaft [rad/s].
    train : Train
        What moves and what presses it.
    follower : DrivenFollower
        The follower, where there is one.
    rotation : str
        Which way the cam turns.
    **given
        The task's other parameters.

    Returns
    -------
    Picture
        Three panels over the cam angle, or four with a follower, with the extremes and the line of no force.
    """
    del given
    motion = motion_of(scene, program)
    load = load_of(train, motion, abs(shaft_speed))
    angles, (s, s1, s2, _) = sampled(motion)
    pressing = [load.force(a, c) for a, c in zip(s, s2, strict=True)]
    turning = [f * v for f, v in zip(pressing, s1, strict=True)]
    if motion.swing:
        rows = [("swing", Angle, s, ()), ("torque on the arm", Torque, pressing, _ends(result, "arm_torque"))]
    else:
        rows = [("lift", Coordinate, s, ()), ("force on the cam", Force, pressing, _ends(result, "force"))]
    if follower is not None:
        rows.append(
            ("contact force", Force, _normal(follower, rotation, load, s, s1, s2), _ends(result, "contact_force"))
        )
    rows.append(("torque of the shaft", Torque, turning, _ends(result, "torque")))
    panels = []
    for index, (name, kind, values, marks) in enumerate(rows):
        # below this line the follower has left the cam
        limit = (Band(0.0, 0.0, "", False),) if index else ()
        items = (*bands(motion, index), Curve(angles, values), *limit, *marks)
        panels.append(Panel(Axis("cam angle", Angle), Axis(name, kind), items))
    return Picture(tuple(panels), "forces on the cam")


def _ends(result: Forces, name: str) -> "tuple[Mark, ...]":
    return tuple(
        Mark(getattr(result, f"{end}_{name}_at"), getattr(result, f"{end}_{name}")) for end in ("least", "greatest")
    )


def _normal(follower: "Any", rotation: str, load: "Any", *state: "list[float]") -> "list[float]":
    import numpy as np

    from dynamics_cli.cam.contact import Geometry
    from dynamics_cli.cam.stress import Touching

    touching = Touching(Geometry(follower, rotation), load)
    values: list[float] = touching.normal(*(np.array(column) for column in state)).tolist()
    return values
