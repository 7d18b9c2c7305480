"""Recursive Newton–Euler: motion from the ground outwards, forces from the ends inwards."""

from dynamics_cli.numerics.trees.tree import PRISMATIC, ZERO
from dynamics_cli.numerics.vectors import add, cross, dot, times

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from dynamics_cli.numerics.trees.tree import Link, Pose, Tree
    from dynamics_cli.numerics.vectors import Tensor, Vector

    # Angular velocity, angular acceleration, velocity and acceleration of the origin.
    Motion = tuple[Vector, Vector, Vector, Vector]
    Wrench = tuple[Vector, Vector]


def back(rotation: "Tensor", v: "Vector") -> "Vector":
    """A vector in the axes that the rotation starts from: Rᵀ·v."""
    (a, b, c), (d, e, f), (g, h, i) = rotation
    x, y, z = v
    return a * x + d * y + g * z, b * x + e * y + h * z, c * x + f * y + i * z


def sweep(
    tree: "Tree",
    frames: "Sequence[Pose]",
    speeds: "Sequence[float]",
    accelerations: "Sequence[float] | None" = None,
    ground: "Vector" = ZERO,
) -> "list[Motion]":
    """Of every link ω, α, and velocity and acceleration of its origin, in its own axes; `ground` is added throughout.

    Without accelerations those of the speeds are zero.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 18.9 to 18.14.
    """
    motions: list[Motion] = []
    still = (ZERO, ZERO, ZERO, ground)
    for link, (rotation, position) in zip(tree.links, frames, strict=True):
        carrier = motions[link.parent] if link.parent >= 0 else still
        motions.append(_carried(link, rotation, position, carrier, speeds, accelerations))
    return motions


def _carried(
    link: "Link",
    rotation: "Tensor",
    position: "Vector",
    carrier: "Motion",
    speeds: "Sequence[float]",
    accelerations: "Sequence[float] | None",
) -> "Motion":
    omega, alpha, velocity, acceleration = carrier
    if position is not ZERO:
        spun = cross(omega, position)
        velocity = add(velocity, spun)
        p, q = cross(alpha, position), cross(omega, spun)
        acceleration = acceleration[0] + p[0] + q[0], acceleration[1] + p[1] + q[1], acceleration[2] + p[2] + q[2]
    omega, alpha = back(rotation, omega), back(rotation, alpha)
    velocity, acceleration = back(rotation, velocity), back(rotation, acceleration)
    if not link.columns:
        return omega, alpha, velocity, acceleration
    rate = along(link, speeds)
    second = along(link, accelerations) if accelerations is not None else ZERO
    x, y, z = cross(omega, rate)
    if link.joint == PRISMATIC:
        acceleration = (
            acceleration[0] + 2.0 * x + second[0],
            acceleration[1] + 2.0 * y + second[1],
            acceleration[2] + 2.0 * z + second[2],
        )
        return omega, alpha, add(velocity, rate), acceleration
    alpha = alpha[0] + x + second[0], alpha[1] + y + second[1], alpha[2] + z + second[2]
    return add(omega, rate), alpha, velocity, acceleration


def at_point(motion: "Motion", point: "Vector") -> "tuple[Vector, Vector]":
    """Velocity and acceleration of a point of a link, in the link's axes."""
    omega, alpha, velocity, acceleration = motion
    spun = cross(omega, point)
    return add(velocity, spun), add(add(acceleration, cross(alpha, point)), cross(omega, spun))


def kinetic_energy(tree: "Tree", motions: "Sequence[Motion]", speeds: "Sequence[float]") -> float:
    """Kinetic energy of all links, that of rotors among it."""
    total = 0.0
    for link, motion in zip(tree.links, motions, strict=True):
        omega, centre = motion[0], at_point(motion, link.centroid)[0]
        total = total + 0.5 * (link.mass * dot(centre, centre) + dot(omega, times(link.tensor, omega)))
        for column in range(len(link.columns)):
            speed = speeds[link.first + column]
            total = total + 0.5 * link.rotor * speed * speed
    return total


def along(link: "Link", numbers: "Sequence[float]") -> "Vector":
    """The vector that the numbers of a joint's speeds make, in the link's axes."""
    first = link.first
    if len(link.columns) == 3:
        return numbers[first], numbers[first + 1], numbers[first + 2]
    x, y, z = link.axis
    size = numbers[first]
    return x * size, y * size, z * size


def inertia_wrench(link: "Link", motion: "Motion") -> "Wrench":
    """The force and the moment about the link's origin that give a link its motion."""
    omega, alpha, _, acceleration = motion
    centroid, mass = link.centroid, link.mass
    turning = add(times(link.tensor, alpha), cross(omega, times(link.tensor, omega)))
    p, q = cross(alpha, centroid), cross(omega, cross(omega, centroid))
    force = (
        mass * (acceleration[0] + p[0] + q[0]),
        mass * (acceleration[1] + p[1] + q[1]),
        mass * (acceleration[2] + p[2] + q[2]),
    )
    return force, add(turning, cross(centroid, force))


def inverse(
    tree: "Tree",
    frames: "Sequence[Pose]",
    speeds: "Sequence[float]",
    accelerations: "Sequence[float] | None" = None,
    *,
    ground: "Vector" = ZERO,
    loads: "Sequence[Wrench | None] | None" = None,
) -> "tuple[list[float], list[Wrench]]":
    """The efforts of all speeds, and what every joint transmits to its link: force, and moment about its origin.

    Equation
    --------
    f = m·a_C, n = I·α + ω × I·ω + c × f less the loads, summed from the ends inwards; effort = axis·n or axis·f.

    Parameters
    ----------
    tree, frames
        The links, and their frames by `poses`.
    speeds, accelerations
        The generalized speeds, and their rates; without those, zero: the efforts are then the bias of the equations.
    ground
        Minus the acceleration of gravity, in ground axes.
    loads
        For each link the force and the moment about its origin that act on it, in its own axes, or None.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 18.15 to 18.17;
    Featherstone, Rigid Body Dynamics Algorithms, Springer 2008, chapter 5.
    """
    motions = sweep(tree, frames, speeds, accelerations, ground)
    wrenches = [inertia_wrench(link, motion) for link, motion in zip(tree.links, motions, strict=True)]
    if loads is not None:
        for k, load in enumerate(loads):
            if load is not None:
                (force, moment), (f, n) = wrenches[k], load
                wrenches[k] = (
                    (force[0] - f[0], force[1] - f[1], force[2] - f[2]),
                    (moment[0] - n[0], moment[1] - n[1], moment[2] - n[2]),
                )
    efforts = [0.0] * tree.speeds
    for k in range(len(wrenches) - 1, -1, -1):
        link = tree.links[k]
        force, moment = wrenches[k]
        side = force if link.joint == PRISMATIC else moment
        for column, axis in enumerate(link.columns):
            effort = dot(axis, side)
            if accelerations is not None and link.rotor is not None:
                effort = effort + link.rotor * accelerations[link.first + column]
            efforts[link.first + column] = effort
        if link.parent >= 0:
            rotation, position = frames[k]
            force, moment = times(rotation, force), times(rotation, moment)
            there = wrenches[link.parent]
            wrenches[link.parent] = (add(there[0], force), add(add(there[1], moment), cross(position, force)))
    return efforts, wrenches
