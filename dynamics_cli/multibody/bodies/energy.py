"""Energy and momentum of a scene, and the checks that they make."""

from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.trees.matrix import mass_matrix
from dynamics_cli.numerics.trees.newton_euler import at_point, inertia_wrench, inverse, kinetic_energy, sweep
from dynamics_cli.numerics.trees.tree import ZERO
from dynamics_cli.numerics.vectors import add, cross, dot, length, scale, subtract, times
from dynamics_cli.records import Check

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from dynamics_cli.multibody.bodies.system import System
    from dynamics_cli.numerics.trees.newton_euler import Motion
    from dynamics_cli.numerics.vectors import Vector

# Two ways agree within this share of the terms that they sum.
SAME = 1e-10


def kinetic(system: "System", motions: "Sequence[Motion]") -> float:
    """Kinetic energy, that of rotors among it."""
    return kinetic_energy(system.tree, motions, system.speeds)


def potential(system: "System") -> float:
    """Potential energy of weights, above the ground's origin, and of springs."""
    total = 0.0
    for k, link in enumerate(system.tree.links):
        if plain(link.mass):
            total = total + link.mass * dot(system.base, system.centre(k))
    for spring in system.springs:
        total = total + spring.energy(system.coordinates)
    for between in system.between:
        total = total + between.energy(system.ground)
    return total


def momentum(system: "System", motions: "Sequence[Motion]", about: "Vector" = ZERO) -> "tuple[Vector, Vector]":
    """Linear momentum, and angular momentum about a point, in ground axes."""
    linear, angular = ZERO, ZERO
    for k, (link, motion) in enumerate(zip(system.tree.links, motions, strict=True)):
        rotation = system.ground[k][0]
        carried = scale(link.mass, times(rotation, at_point(motion, link.centroid)[0]))
        spun = times(rotation, times(link.tensor, motion[0]))
        linear = add(linear, carried)
        angular = add(angular, add(spun, cross(subtract(system.centre(k), about), carried)))
    return linear, angular


def checks(system: "System", accelerations: "Sequence[float]", efforts: "Sequence[float]") -> "tuple[Check, ...]":
    """Kane's equations with the mass matrix, and the power of what acts against the rate of the energy.

    The efforts are those of motors and springs together.
    """
    tree, frames, speeds = system.tree, system.frames, system.speeds
    matrix = mass_matrix(tree, frames)
    bias, _ = inverse(tree, frames, speeds, ground=system.base, loads=system.loads)
    off = 0.0
    for row, extra, given in zip(matrix, bias, efforts, strict=True):
        terms = [a * x for a, x in zip(row, accelerations, strict=True)]
        size = sum(map(abs, terms)) + abs(extra) + abs(given)
        off = max(off, abs(sum(terms) + extra - given) / size if size else 0.0)
    power, size = _power(system, accelerations, efforts)
    share = abs(power) / size if size else 0.0
    return (
        Check("Kane's equations with the mass matrix hold", off <= SAME, off, SAME),
        Check("energy changes by the power of what acts", share <= SAME, share, SAME),
    )


def _power(system: "System", accelerations: "Sequence[float]", efforts: "Sequence[float]") -> "tuple[float, float]":
    """Rate of the energy of motion and place less the power of efforts and loads, and the size of the terms."""
    motions = sweep(system.tree, system.frames, system.speeds, accelerations, system.base)
    pull = length(system.base)
    power = size = 0.0
    for k, (link, motion) in enumerate(zip(system.tree.links, motions, strict=True)):
        omega, alpha, velocity, acceleration = motion
        force, moment = inertia_wrench(link, motion)
        load = system.loads[k] or (ZERO, ZERO)
        power += dot(subtract(force, load[0]), velocity) + dot(subtract(moment, load[1]), omega)
        # the same with sizes only: a joint that nothing drives has no power, of terms that cancel
        turning, far = length(omega), length(link.centroid)
        quick = length(velocity) + far * turning
        trace = link.tensor[0][0] + link.tensor[1][1] + link.tensor[2][2]
        swift = length(alpha) + turning * turning
        size += link.mass * (length(acceleration) + pull + far * swift) * quick + trace * swift * turning
        size += length(load[0]) * length(velocity) + length(load[1]) * turning
        for column in range(len(link.columns)):
            place = link.first + column
            drive = (link.rotor * accelerations[place] - efforts[place]) * system.speeds[place]
            power += drive
            size += abs(drive)
    return power, size
