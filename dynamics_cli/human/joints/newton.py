"""Newton–Euler along a limb in a plane: forces and moments of its joints, from the far end to the body."""

from dynamics_cli.human.bodies.tables import plain_name
from dynamics_cli.records import record

JOINTS = {
    "foot": "ankle", "shank": "knee", "thigh": "hip", "hand": "wrist", "forearm": "elbow", "upper arm": "shoulder",
    "leg": "knee", "lower leg": "knee", "upper leg": "hip", "head": "neck",
}  # fmt: skip
# The muscles that turn the segment beyond the joint anticlockwise, forward to the right, and the others.
MUSCLES = {
    "ankle": ("dorsiflexors", "plantar flexors"), "knee": ("extensors", "flexors"), "hip": ("flexors", "extensors"),
    "wrist": ("flexors", "extensors"), "elbow": ("flexors", "extensors"), "shoulder": ("flexors", "extensors"),
    "neck": ("extensors", "flexors"),
}  # fmt: skip

Pair = tuple[float, float]


@record
class Link:
    """A segment at an instant: mass, inertia about its centre, centre, upper joint, accelerations."""

    mass: float
    inertia: float
    centre: Pair
    joint: Pair
    acceleration: Pair
    rotation: float


def joint_of(segment: str) -> str:
    """The joint at the upper end of a segment."""
    name = plain_name(segment)
    bare = name.removeprefix("left ").removeprefix("right ")
    return JOINTS.get(bare, f"upper end of the {segment}")


def muscles_of(joint: str, moment: float) -> str:
    """Which muscles give this moment on the segment beyond a joint."""
    turning, opposite = MUSCLES.get(joint, ("anticlockwise", "clockwise"))
    return turning if moment > 0.0 else opposite


def up_the_limb(links: "list[Link]", force: Pair, at: Pair, gravity: float) -> "list[tuple[Pair, float]]":
    """Force and moment of the upper joint on each segment; `force` acts on the first one at a point."""
    actions = []
    push, lift = force
    x, y = at
    couple = 0.0
    for link in links:
        (cx, cy), (jx, jy) = link.centre, link.joint
        forward = link.mass * link.acceleration[0] - push
        up = link.mass * (link.acceleration[1] + gravity) - lift
        moment = (
            link.inertia * link.rotation
            - ((jx - cx) * up - (jy - cy) * forward)
            - ((x - cx) * lift - (y - cy) * push)
            - couple
        )
        actions.append(((forward, up), moment))
        push, lift, couple = 0.0 - forward, 0.0 - up, 0.0 - moment
        x, y = jx, jy
    return actions
