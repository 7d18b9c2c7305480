"""The task `accelerations`: forward dynamics, how a tree of bodies moves under what acts on it."""

from dynamics_cli.errors import worded
from dynamics_cli.multibody.bodies.energy import checks, kinetic, potential
from dynamics_cli.multibody.bodies.records import Scene, Upward
from dynamics_cli.multibody.bodies.results import Reaction, effort, rate, reaction_rows, second
from dynamics_cli.multibody.bodies.system import System
from dynamics_cli.numerics.trees.articulated import forward
from dynamics_cli.numerics.trees.newton_euler import inverse, sweep
from dynamics_cli.numerics.vectors import times
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    AngularAccelerationVector,
    Annotated,
    FreeNumber,
    Gravity,
    PotentialEnergy,
    Text,
    TurnRate,
)
from dynamics_cli.records import Advice, Check, Numerics, record

# Moves of joints in rad or sizes of the scene, and changes of speeds, that are more than rounding.
WORTH_A_WORD = 1e-9


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

    acceleration: Annotated[FreeNumber | None, "The rate of the speed asked for."]
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
    of: Annotated[Text | None, "A speed whose rate is shown alone, with its spread if inputs are uncertain."] = None,
    up: Annotated[Upward, "The axis that points up: x, y, z, or none without gravity."] = Upward("z"),  # noqa: B008
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Accelerations:
    """Accelerations of a tree of bodies under weight, loads, springs and motors, and what its joints transmit.

    Equation
    --------
    Σ_p a_lp·ẏ_p = F_l − h_l, by articulated bodies: inertia as felt through the joints, from the end bodies inwards.
    With loops B·ẏ = g: (CᵀM·C)·ż = Cᵀ(F − h − M·ẏ_p), B·C = 0, ẏ = ẏ_p + C·ż.

    Raises
    ------
    InadmissibleError
        When nothing resists a joint: the bodies beyond it have no inertia about its axis. When loops do not close, or
        are at a change point.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 18.15 to 18.17, 19.17 and 19.18;
    Featherstone, Rigid Body Dynamics Algorithms, Springer 2008, chapter 7.

    Examples
    --------
    >>> from dynamics_cli.multibody.bodies.records import Body
    >>> arm = Body("arm", axis=(0.0, 1.0, 0.0), mass=2.0, rod=(1.0, 0.0, 0.0))
    >>> accelerations(Scene((arm,)), gravity=10.0).accelerations[0].acceleration.value
    15.0
    """
    system = System(scene, up, gravity)
    if scene.loops:
        return _in_loops(system, of)
    springs = system.spring_efforts()
    driven = [motor + spring for motor, spring in zip(system.efforts, springs, strict=True)]
    rates = forward(system.tree, system.frames, system.speeds, driven, ground=system.base, loads=system.loads)
    _, wrenches = inverse(system.tree, system.frames, system.speeds, rates, ground=system.base, loads=system.loads)
    return _answer(system, of, rates, reaction_rows(system, wrenches), checks(system, rates, driven))


def _in_loops(system: System, of: "str | None") -> Accelerations:
    """The same where loops are closed, by the ways that they leave free."""
    from dynamics_cli.multibody.bodies.loops import Loops

    loops = Loops(system)
    moved, changed = loops.close(), loops.settle()
    loops.require_regular()
    system.begin()
    springs = system.spring_efforts()
    driven = [motor + spring for motor, spring in zip(system.efforts, springs, strict=True)]
    found, multipliers, nothing = loops.accelerations(driven)
    rates = [float(rate) for rate in found]
    system.loads = loops.with_loads(multipliers)
    _, wrenches = inverse(system.tree, system.frames, system.speeds, rates, ground=system.base, loads=system.loads)
    rows = loops.reactions(multipliers, nothing, wrenches)
    _advise(system, moved, changed, any(row.undetermined for row in rows))
    return _answer(system, of, rates, rows, checks(system, rates, driven), "ways that the loops leave free")


def _advise(system: System, moved: float, changed: float, undetermined: bool) -> None:
    if moved > WORTH_A_WORD:
        message = "joints were moved so that the loops close, at most by {moved} (or that share of the scene's size)"
        system.advice.append(Advice("moved", worded(message, moved=(moved, Angle)), severity="note"))
    if changed > WORTH_A_WORD:
        message = "the speeds given contradict the loops; they are changed by up to {changed}"
        system.advice.append(Advice("speeds", worded(message, changed=(changed, TurnRate))))
    if undetermined:
        message = "loops leave components of joint forces open; those named are the smallest that balance"
        system.advice.append(Advice("undetermined", message, severity="note"))


def _answer(
    system: System,
    of: "str | None",
    rates: "list[float]",
    reactions: "tuple[Reaction, ...]",
    balance: "tuple[Check, ...]",
    method: str = "",
) -> Accelerations:
    springs, speeds = system.spring_efforts(), system.speeds
    motions = sweep(system.tree, system.frames, speeds, rates)
    rows = zip(system.names, system.turning, rates, system.efforts, springs, speeds, strict=True)
    turning = ((body.name, system.link[body.name]) for body in system.bodies)
    place = None if of is None else system.speed(of)
    return Accelerations(
        acceleration=None if place is None else second(system.turning[place], rates[place]),
        accelerations=tuple(
            AccelerationRow(name, second(turns, a), effort(turns, motor), effort(turns, spring), rate(turns, speed))
            for name, turns, a, motor, spring, speed in rows
        ),
        turning=tuple(TurningRow(name, times(system.ground[k][0], motions[k][1])) for name, k in turning),
        reactions=reactions,
        kinetic_energy=kinetic(system, motions),
        potential_energy=potential(system),
        numerics=Numerics(method or "articulated bodies"),
        checks=balance,
        advice=tuple(system.advice),
    )
