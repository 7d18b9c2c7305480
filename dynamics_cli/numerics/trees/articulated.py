"""Accelerations of a tree from its efforts, by articulated bodies: the cost grows with the number of links."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.trees.blocks import block_of, joined, less, moved_block, symmetric
from dynamics_cli.numerics.trees.newton_euler import along, back
from dynamics_cli.numerics.trees.tree import PRISMATIC, ZERO
from dynamics_cli.numerics.vectors import add, cross, dot, times

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from dynamics_cli.numerics.trees.blocks import Block
    from dynamics_cli.numerics.trees.newton_euler import Wrench
    from dynamics_cli.numerics.trees.tree import Link, Pose, Tree
    from dynamics_cli.numerics.vectors import Vector

# A joint moves nothing where its inertia is below this share of the inertia in all directions.
NOTHING = 1e-14


class Stage:
    """What the sweep inwards leaves for the sweep outwards, of one column of a joint."""

    __slots__ = ("inertia", "left", "u_force", "u_moment")

    def __init__(self, inertia: float, left: float, u_moment: "Vector", u_force: "Vector") -> None:
        self.inertia, self.left = inertia, left
        self.u_moment, self.u_force = u_moment, u_force


def forward(
    tree: "Tree",
    frames: "Sequence[Pose]",
    speeds: "Sequence[float]",
    efforts: "Sequence[float]",
    *,
    ground: "Vector" = ZERO,
    loads: "Sequence[Wrench | None] | None" = None,
) -> "list[float]":
    """The rates of all speeds for efforts and loads (those as of `inverse`).

    Equation
    --------
    U = A·e, D = e·U + rotor inertia, u = effort − e·p; A − U·Uᵀ/D and p + A·c + U·u/D join the parent; then
    outwards ẏ = (u − U·a)/D.

    Raises
    ------
    InadmissibleError
        When nothing resists a joint: the link beyond it has no inertia along or about its axis.

    References
    ----------
    Featherstone, Rigid Body Dynamics Algorithms, Springer 2008, chapter 7.
    """
    count = len(tree.links)
    blocks: list[Any] = [block_of(link) for link in tree.links]
    drifts, biases = _outwards(tree, frames, speeds, loads)
    stages: list[list[Stage]] = [[]] * count
    for k in range(count - 1, -1, -1):
        link = tree.links[k]
        block, force, moment = blocks[k], *biases[k]
        block, force, moment, stages[k] = _released(link, block, force, moment, efforts)
        if link.parent < 0:
            continue
        rotation, position = frames[k]
        (alpha, acceleration), (inertia, mixed, mass) = drifts[k], block
        moment = add(moment, add(symmetric(inertia, alpha), times(mixed, acceleration)))
        force = add(force, add(back(mixed, alpha), symmetric(mass, acceleration)))
        force, moment = times(rotation, force), times(rotation, moment)
        there = biases[link.parent]
        biases[link.parent] = (add(there[0], force), add(add(there[1], moment), cross(position, force)))
        blocks[link.parent] = joined(blocks[link.parent], moved_block(block, rotation, position))
    return _accelerations(tree, frames, drifts, stages, ground)


def _outwards(
    tree: "Tree", frames: "Sequence[Pose]", speeds: "Sequence[float]", loads: "Sequence[Wrench | None] | None"
) -> "tuple[list[tuple[Vector, Vector]], list[Wrench]]":
    """What each joint's speed alone adds to α and a of its link, and the forces that keep each link turning."""
    omegas: list[Vector] = []
    drifts, biases = [], []
    for k, link in enumerate(tree.links):
        rotation, position = frames[k]
        omega = omegas[link.parent] if link.parent >= 0 else ZERO
        acceleration = back(rotation, cross(omega, cross(omega, position)))
        omega, alpha = back(rotation, omega), ZERO
        if link.columns:
            rate = along(link, speeds)
            x, y, z = cross(omega, rate)
            if link.joint == PRISMATIC:
                acceleration = add(acceleration, (2.0 * x, 2.0 * y, 2.0 * z))
            else:
                omega, alpha = add(omega, rate), (x, y, z)
        omegas.append(omega)
        drifts.append((alpha, acceleration))
        inward, mass = cross(omega, cross(omega, link.centroid)), link.mass
        force = (mass * inward[0], mass * inward[1], mass * inward[2])
        moment = add(cross(omega, times(link.tensor, omega)), cross(link.centroid, force))
        load = loads[k] if loads is not None else None
        if load is not None:
            (a, b, c), (d, e, f) = load
            force = (force[0] - a, force[1] - b, force[2] - c)
            moment = (moment[0] - d, moment[1] - e, moment[2] - f)
        biases.append((force, moment))
    return drifts, biases


def _released(
    link: "Link", block: "Block", force: "Vector", moment: "Vector", efforts: "Sequence[float]"
) -> "tuple[Block, Vector, Vector, list[Stage]]":
    """The block and bias of a link as its joint lets the parent feel them, the last column first."""
    stages: list[Stage] = []
    sliding = link.joint == PRISMATIC
    for column in range(len(link.columns) - 1, -1, -1):
        axis = link.columns[column]
        inertia, mixed, mass = block
        if sliding:
            u_moment, u_force = times(mixed, axis), symmetric(mass, axis)
            resistance, felt, every = dot(axis, u_force), dot(axis, force), mass[0] + mass[1] + mass[2]
        else:
            u_moment, u_force = symmetric(inertia, axis), back(mixed, axis)
            resistance, felt, every = dot(axis, u_moment), dot(axis, moment), inertia[0] + inertia[1] + inertia[2]
        resistance = resistance + link.rotor
        require(
            resistance > NOTHING * (every + link.rotor),
            "nothing resists the joint of {link}: what it carries has no inertia {way} its axis",
            code="no-inertia",
            hint="give the bodies beyond it mass, or this joint a rotor inertia; axes that have come into line lose a "
            "freedom too: a ball joint has none that can",
            link=link.name,
            way="along" if sliding else "about",
        )
        left = efforts[link.first + column] - felt
        stages.append(Stage(resistance, left, u_moment, u_force))
        ratio = left / resistance
        block = less(block, u_moment, u_force, 1.0 / resistance)
        moment = add(moment, (ratio * u_moment[0], ratio * u_moment[1], ratio * u_moment[2]))
        force = add(force, (ratio * u_force[0], ratio * u_force[1], ratio * u_force[2]))
    stages.reverse()
    return block, force, moment, stages


def _accelerations(
    tree: "Tree",
    frames: "Sequence[Pose]",
    drifts: "list[tuple[Vector, Vector]]",
    stages: "list[list[Stage]]",
    ground: "Vector",
) -> "list[float]":
    rates = [0.0] * tree.speeds
    motions: list[tuple[Vector, Vector]] = []
    for k, link in enumerate(tree.links):
        rotation, position = frames[k]
        alpha, acceleration = motions[link.parent] if link.parent >= 0 else (ZERO, ground)
        acceleration = back(rotation, add(acceleration, cross(alpha, position)))
        alpha, acceleration = add(back(rotation, alpha), drifts[k][0]), add(acceleration, drifts[k][1])
        for column, stage in enumerate(stages[k]):
            felt = dot(stage.u_moment, alpha) + dot(stage.u_force, acceleration)
            rate = rates[link.first + column] = (stage.left - felt) / stage.inertia
            x, y, z = link.columns[column]
            change = (rate * x, rate * y, rate * z)
            if link.joint == PRISMATIC:
                acceleration = add(acceleration, change)
            else:
                alpha = add(alpha, change)
        motions.append((alpha, acceleration))
    return rates
