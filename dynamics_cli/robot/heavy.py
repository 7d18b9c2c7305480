"""An arm as a tree of heavy links, and the checks of its torques by one calculation of the whole."""

from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.orientation.rotations import about_axis, product, transposed
from dynamics_cli.numerics.trees.newton_euler import back, inverse, kinetic_energy, sweep
from dynamics_cli.numerics.trees.tree import FIXED, PRISMATIC, REVOLUTE, Link, Tree, placed, poses
from dynamics_cli.numerics.vectors import add, cross, dot, scale, times
from dynamics_cli.records import Advice, Check
from dynamics_cli.robot.arms.chain import Chain
from dynamics_cli.robot.arms.records import ORIGIN, POINT
from dynamics_cli.robot.velocities import columns_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

# Step in time of the difference quotient of the energy, and what it leaves as a share of the powers.
STEP, AGREES = 1e-5, 1e-6
SAME = 1e-12
# A moment this much above the sum of the other two is not rounding.
IMPOSSIBLE = 1e-9


def links_of(chain: Chain, *, masses: bool = True) -> "list[Link]":
    """The links as a tree: each frame at its joint, turning with its link, where a table's frame is at the far end."""
    links: list[Link] = []
    rotation, position = about_axis(2, 0.0), ORIGIN
    for number, joint in enumerate(chain.joints):
        turn, twist = about_axis(2, joint.theta), about_axis(0, joint.alpha)
        far = (joint.a, 0.0, joint.d)
        if chain.standard:
            start, place = product(rotation, turn), position
            centroid, tensor = add(far, times(twist, joint.centroid)), _turned(twist, joint.tensor or POINT)
            rotation, position = twist, far
        else:
            start, place = product(twist, turn), add((joint.a, 0.0, 0.0), times(twist, (0.0, 0.0, joint.d)))
            centroid, tensor = joint.centroid, joint.tensor or POINT
        links.append(
            Link(
                chain.names[number], number - 1, REVOLUTE if chain.turning[number] else PRISMATIC,
                position=place, rotation=start,
                mass=joint.mass if masses else 0.0,
                centroid=centroid,
                tensor=tensor if masses else POINT,
            )
        )  # fmt: skip
    return links


def _turned(rotation: "Any", tensor: "Any") -> "Any":
    return product(product(rotation, tensor), transposed(rotation))


def payload_of(chain: Chain, mass: float) -> "list[Link]":
    """The payload, fixed to the last link at the tip of the tool."""
    last = chain.joints[-1]
    tip = chain.tool
    if chain.standard:
        tip = add((last.a, 0.0, last.d), times(about_axis(0, last.alpha), tip))
    return [Link("payload", len(chain.joints) - 1, FIXED, mass=mass, centroid=tip)]


class Loaded:
    """The arm with its payload and the force of its hand in one calculation, with which the parts are compared."""

    def __init__(
        self, chain: Chain, q: "Sequence[float]", v: "Sequence[float]", a: "Sequence[float]", load: "tuple[Any, ...]"
    ) -> None:
        payload, self.lift, force, moment = load
        self.tree = Tree(links_of(chain) + payload_of(chain, payload))
        self.q, self.v, self.a = q, v, a
        frames = poses(self.tree, q)
        ground = placed(self.tree, frames)
        loads: list[Any] = [None] * len(self.tree.links)
        if force is not None or moment is not None:
            # what the hand pushes with pushes back on it
            turn, at = ground[-1]
            arm = chain.hand(chain.links(q)).position
            lever = (arm[0] - at[0], arm[1] - at[1], arm[2] - at[2])
            pull = scale(-1.0, force or ORIGIN)
            twist = add(scale(-1.0, moment or ORIGIN), cross(lever, pull))
            loads[-1] = (back(turn, pull), back(turn, twist))
        self.efforts, wrenches = inverse(self.tree, frames, v, a, ground=self.lift, loads=loads)
        turn, at = ground[0]
        self.force = times(turn, wrenches[0][0])
        self.moment = add(times(turn, wrenches[0][1]), cross(at, self.force))
        self.hand = force, moment
        self.chain = chain
        self.kinetic = self.kinetic_at(q, v)

    def kinetic_at(self, q: "Sequence[float]", v: "Sequence[float]") -> float:
        """Kinetic energy in a state."""
        return kinetic_energy(self.tree, sweep(self.tree, poses(self.tree, q), v), v)

    def energy_at(self, time: float) -> float:
        """Kinetic and potential energy a little before or after, on the motion with these accelerations."""
        q = [x + time * (s + 0.5 * time * t) for x, s, t in zip(self.q, self.v, self.a, strict=True)]
        v = [s + time * t for s, t in zip(self.v, self.a, strict=True)]
        height: float = 0.0
        for link, (turn, at) in zip(self.tree.links, placed(self.tree, poses(self.tree, q)), strict=True):
            height = height + link.mass * dot(self.lift, add(at, times(turn, link.centroid)))
        return self.kinetic_at(q, v) + height


def checks_of(whole: Loaded, total: "Sequence[float]") -> "tuple[Check, ...]":
    """The parts beside one calculation of all, and the power beside the rate of the energy."""
    efforts = whole.efforts
    scale_ = max(1e-300, *map(abs, efforts))
    off = max(abs(plain(t) - effort) for t, effort in zip(total, efforts, strict=True)) / scale_
    checks = [Check("parts add to the torques", off <= SAME, off, SAME)]
    if any(whole.v):
        rate = (whole.energy_at(STEP) - whole.energy_at(-STEP)) / (2.0 * STEP)
        force, moment = whole.hand
        columns = columns_of(whole.chain, whole.q)
        pushed = [dot(x, force or ORIGIN) + dot(w, moment or ORIGIN) for x, w in columns]
        shares = [effort * rate_ for effort, rate_ in zip(efforts, whole.v, strict=True)]
        power = sum(shares) - sum(push * rate_ for push, rate_ in zip(pushed, whole.v, strict=True))
        size = max(1e-12, *map(abs, shares))
        gap = abs(power - rate) / size
        checks.append(Check("power is the rate of the energy", gap <= AGREES, gap, AGREES))
    return tuple(checks)


def impossible(chain: Chain) -> "tuple[Advice, ...]":
    """Links whose moments of inertia no body has; a table may lump moments about one axis alone."""
    names = []
    for name, joint in zip(chain.names, chain.joints, strict=True):
        x, y, z = (plain((joint.tensor or POINT)[k][k]) for k in range(3))
        if max(x, y, z) * (2.0 - IMPOSSIBLE) > x + y + z:
            names.append(name)
    if not names:
        return ()
    message = f"no body has the tensor of {', '.join(names)}: a moment exceeds the others' sum"
    return (Advice("impossible-body", message, severity="note"),)
