"""Pictures of the forces on a cam: the force on the follower, the contact force and the torque over the turn."""

from dynamics_cli.cam.forces.loads import load_of
from dynamics_cli.cam.forces.records import Forces, Train
from dynamics_cli.cam.geometry.followers import Rotation
from dynamics_cli.cam.program.pictures import ABOVE, BELOW, bands, extreme_mark, named_program, sampled, turn_axis
from dynamics_cli.cam.program.reading import Program, motion_of
from dynamics_cli.errors import worded
from dynamics_cli.pictures import Axis, Band, Curve, Mark, Panel, Picture
from dynamics_cli.quantities import Angle, Coordinate, Force, ShaftSpeed, Torque

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
    **inputs: "Any",
) -> Picture:
    """Draw lift, force (or an arm's torque), contact force and shaft torque over the turn; below zero it leaves.

    `train`: the moving parts and their spring; `follower`: the follower, where there is one; `rotation`: sense of
    rotation of the cam. Returns three panels over the cam angle, or four with a follower, with the extremes and the
    line of no force.
    """
    del inputs
    motion = motion_of(scene, program)
    load = load_of(train, motion, abs(shaft_speed))
    angles, (s, s1, s2, _) = sampled(motion)
    pressing = [load.force(a, c) for a, c in zip(s, s2, strict=True)]
    turning = [f * v for f, v in zip(pressing, s1, strict=True)]
    if motion.swing:
        rows = [("swing ψ", Angle, s, ""), ("arm torque M", Torque, pressing, "arm_torque")]
    else:
        rows = [("lift s", Coordinate, s, ""), ("axial force F", Force, pressing, "force")]
    if follower is not None:
        rows.append(("contact force N", Force, _normal(follower, rotation, load, s, s1, s2), "contact_force"))
    rows.append(("shaft torque T", Torque, turning, "torque"))
    panels = []
    for index, (name, kind, values, extremes) in enumerate(rows):
        # below this line the follower has left the cam
        limit = (Band(0.0, 0.0, "", False),) if index else ()
        items = (*bands(motion, index), Curve(angles, values), *limit, *_ends(result, extremes, kind))
        panels.append(Panel(turn_axis(motion), Axis(name, kind), items))
    title = worded(
        "Forces on the cam at {speed}\n{program}",
        speed=(abs(shaft_speed), ShaftSpeed),
        program=named_program(scene, program),
    )
    return Picture(tuple(panels), title)


def _ends(result: Forces, name: str, kind: "Any") -> "tuple[Mark, ...]":
    if not name:
        return ()
    low, low_at, high, high_at = (
        getattr(result, f"{end}_{name}{suffix}") for end in ("least", "greatest") for suffix in ("", "_at")
    )
    return (*extreme_mark(high_at, high, kind, ABOVE), *extreme_mark(low_at, low, kind, BELOW))


def _normal(follower: "Any", rotation: str, load: "Any", *state: "list[float]") -> "list[float]":
    import numpy as np

    from dynamics_cli.cam.forces.stress import Touching
    from dynamics_cli.cam.geometry.contact import Geometry

    touching = Touching(Geometry(follower, rotation), load)
    values: list[float] = touching.normal(*(np.array(column) for column in state)).tolist()
    return values
