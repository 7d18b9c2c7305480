"""The task `accelerations`: forward dynamics, how a tree of bodies moves under what acts on it."""

from dynamics_cli.multibody.energy import checks, kinetic, potential
from dynamics_cli.multibody.records import Scene, Upward
from dynamics_cli.multibody.results import Reaction, effort, rate, reaction_rows, second
from dynamics_cli.multibody.system import System
from dynamics_cli.numerics.number import over_plain, plain
from dynamics_cli.numerics.trees.articulated import forward
from dynamics_cli.numerics.trees.newton_euler import inverse, sweep
from dynamics_cli.numerics.vectors import times
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    AngularAccelerationVector,
    Annotated,
    FreeNumber,
    Gravity,
    PotentialEnergy,
    Text,
)
from dynamics_cli.records import Advice, Check, Numerics, record


@record
class AccelerationRow:
    """The rate of one speed."""

    name: Annotated[Text, "The speed: the body's name, of several with its axis."]
    acceleration: Annotated[FreeNumber, "Its rate."]
    effort: Annotated[FreeNumber, "The effort of the joint's motor."]
    springs: Annotated[FreeNumber, "What springs and dampers in the joint add."]
    speed: Annotated[FreeNumber, "The speed's value."]


@record
class TurningRow:
    """How a body turns."""

    body: Annotated[Text, "The body."]
    angular_acceleration: Annotated[AngularAccelerationVector, "Its angular acceleration, in ground axes [rad/s^2]."]


@record
class Accelerations:
    """How bodies move under what acts on them."""

    accelerations: Annotated[tuple[AccelerationRow, ...], "The rate of every speed."]
    turning: Annotated[tuple[TurningRow, ...], "Angular accelerations of the bodies."]
    reactions: Annotated[tuple[Reaction, ...], "Forces and moments that every joint transmits."]
    kinetic_energy: Annotated[PotentialEnergy, "Kinetic energy [J]."]
    potential_energy: Annotated[PotentialEnergy, "Of weights above the ground's origin, and of springs [J]."]
    numerics: Numerics
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def accelerations(
    scene: Annotated[Scene, "The bodies, from a file."],
    /,
    *,
    up: Annotated[Upward, "The axis that points up: x, y, z, or none without gravity."] = Upward("z"),  # noqa: B008
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Accelerations:
    """Accelerations of a tree of bodies under weight, loads, springs and motors, and what its joints transmit.

    Equation
    --------
    Σ_p a_lp·ẏ_p = F_l − h_l, by articulated bodies: inertia as felt through the joints, from the end bodies inwards.

    Raises
    ------
    InadmissibleError
        When nothing resists a joint: the bodies beyond it have no inertia about its axis.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 18.15 to 18.17;
    Featherstone, Rigid Body Dynamics Algorithms, Springer 2008, chapter 7.

    Examples
    --------
    >>> from dynamics_cli.multibody.records import Body
    >>> arm = Body("arm", axis=(0.0, 1.0, 0.0), mass=2.0, rod=(1.0, 0.0, 0.0))
    >>> accelerations(Scene((arm,)), gravity=10.0).accelerations[0].acceleration.value
    15.0
    """
    system = System(scene, up, gravity)
    system.require_open()
    tree, frames, speeds = system.tree, system.frames, system.speeds
    springs = system.spring_efforts()
    driven = [motor + spring for motor, spring in zip(system.efforts, springs, strict=True)]
    rates = forward(tree, frames, speeds, driven, ground=system.base, loads=system.loads)
    _, wrenches = inverse(tree, frames, speeds, rates, ground=system.base, loads=system.loads)
    motions = sweep(tree, frames, speeds, rates)
    rows = zip(system.names, system.turning, rates, system.efforts, springs, speeds, strict=True)
    turning = ((body.name, system.link[body.name]) for body in system.bodies)
    doubles = System(over_plain(scene), up, plain(gravity))
    return Accelerations(
        accelerations=tuple(
            AccelerationRow(name, second(turns, a), effort(turns, motor), effort(turns, spring), rate(turns, speed))
            for name, turns, a, motor, spring, speed in rows
        ),
        turning=tuple(TurningRow(name, times(system.ground[k][0], motions[k][1])) for name, k in turning),
        reactions=reaction_rows(system, wrenches),
        kinetic_energy=kinetic(system, motions),
        potential_energy=potential(system),
        numerics=Numerics("articulated bodies"),
        checks=checks(doubles, [plain(one) for one in rates], [plain(one) for one in driven]),
        advice=tuple(system.advice),
    )
