"""The task `efforts`: inverse dynamics, what each joint's motor must supply for a motion."""

from dynamics_cli.multibody.bodies.energy import checks, kinetic
from dynamics_cli.multibody.bodies.records import Scene, Upward
from dynamics_cli.multibody.bodies.results import Reaction, effort, rate, reaction_rows, second
from dynamics_cli.multibody.bodies.system import System
from dynamics_cli.numerics.number import over_plain, plain
from dynamics_cli.numerics.trees.newton_euler import inverse, sweep
from dynamics_cli.quantities import STANDARD_GRAVITY, Annotated, FreeNumber, Gravity, PotentialEnergy, Power, Text
from dynamics_cli.records import Advice, Check, Numerics, record


@record
class EffortRow:
    """The effort of one speed, and what it is made of."""

    name: Annotated[Text, "The speed: the body's name, of several with its axis."]
    effort: Annotated[FreeNumber, "What the joint's motor must supply."]
    weight: Annotated[FreeNumber, "Of it, what holds the weights."]
    inertia: Annotated[FreeNumber, "What the accelerations take."]
    velocity: Annotated[FreeNumber, "What the speeds alone take: centrifugal, Coriolis, gyroscopic."]
    loads: Annotated[FreeNumber, "What holds the loads."]
    springs: Annotated[FreeNumber, "What springs and dampers in the joint take."]
    speed: Annotated[FreeNumber, "The speed's value."]
    acceleration: Annotated[FreeNumber, "Its rate."]


@record
class Efforts:
    """What the joints must supply."""

    effort: Annotated[FreeNumber | None, "The effort of the speed asked for."]
    efforts: Annotated[tuple[EffortRow, ...], "The effort of every speed, with its parts."]
    reactions: Annotated[tuple[Reaction, ...], "Forces and moments that every joint transmits."]
    power: Annotated[Power, "Power of all motors together [W]."]
    kinetic_energy: Annotated[PotentialEnergy, "Kinetic energy [J]."]
    numerics: Numerics
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def efforts(
    scene: Annotated[Scene, "The bodies, from a file."],
    /,
    *,
    of: Annotated[Text | None, "A speed whose effort is shown alone, with its spread if inputs are uncertain."] = None,
    up: Annotated[Upward, "The axis that points up: x, y, z, or none without gravity."] = Upward("z"),  # noqa: B008
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Efforts:
    """Joint torques and forces that a tree of bodies needs for a given motion, split into parts, and joint reactions.

    Equation
    --------
    f = m·a_C, n = I·α + ω × I·ω + c × f less the loads, from the end bodies inwards; effort = axis·n, or axis·f.

    Raises
    ------
    InadmissibleError
        When a joint has too many numbers, or no body has the tensor given.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 18.15 to 18.17.

    Examples
    --------
    >>> from dynamics_cli.multibody.bodies.records import Body
    >>> arm = Body("arm", axis=(0.0, 1.0, 0.0), mass=2.0, rod=(1.0, 0.0, 0.0), angular_acceleration=(3.0,))
    >>> row = efforts(Scene((arm,)), gravity=10.0).efforts[0]
    >>> row.weight.value, row.inertia.value
    (-10.0, 2.0)
    """
    system = System(scene, up, gravity)
    system.require_open()
    tree, frames, speeds, rates = system.tree, system.frames, system.speeds, system.accelerations
    total, wrenches = inverse(tree, frames, speeds, rates, ground=system.base, loads=system.loads)
    held = system.spring_efforts()
    still = [0.0] * tree.speeds
    weight, _ = inverse(tree, frames, still, ground=system.base)
    inertia, _ = inverse(tree, frames, still, rates)
    velocity, _ = inverse(tree, frames, speeds)
    loads, _ = inverse(tree, frames, still, loads=system.loads)
    rows = []
    power = 0.0
    for k, (name, turning) in enumerate(zip(system.names, system.turning, strict=True)):
        needed = total[k] - held[k]
        power = power + needed * speeds[k]
        needs = [
            effort(turning, part) for part in (needed, weight[k], inertia[k], velocity[k], loads[k], 0.0 - held[k])
        ]
        rows.append(EffortRow(name, *needs, rate(turning, speeds[k]), second(turning, rates[k])))  # type: ignore[call-arg]
    doubles = System(over_plain(scene), up, plain(gravity))
    return Efforts(
        effort=None if of is None else rows[system.speed(of)].effort,
        efforts=tuple(rows),
        reactions=reaction_rows(system, wrenches),
        power=power,
        kinetic_energy=kinetic(system, sweep(tree, frames, speeds)),
        numerics=Numerics("recursive Newton–Euler"),
        checks=checks(doubles, doubles.accelerations, [plain(one) for one in total]),
        advice=tuple(system.advice),
    )
