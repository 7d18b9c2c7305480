"""Forces on a cam: contact force, torque, the speed at which the follower jumps, Hertz stress, surge, valve durations."""

from math import inf, pi, sqrt

from dynamics_cli.cam.motion import Motion
from dynamics_cli.cam.program import Program, motion_of
from dynamics_cli.cam.searching import Found, crossings, least_and_greatest
from dynamics_cli.errors import require
from dynamics_cli.quantities import (
    Angle,
    Coordinate,
    Count,
    Force,
    Frequency,
    Mass,
    Power,
    Pressure,
    Ratio,
    ShaftSpeed,
    Size,
    Speed,
    Stiffness,
    Text,
    Torque,
)
from dynamics_cli.records import Advice, Check, Columns, ErrorBound, Numerics, record

SURGE_ORDER = 12.0
STEEL = 206e9
STEEL_RATIO = 0.3


@record
class Contact:
    """What touches the cam: a roller, or a flat face when no roller radius is given.

    Parameters
    ----------
    base_radius : Size
        Radius of the base circle [m].
    width : Size
        Width of the contact [m].
    roller_radius : Size
        Radius of the roller [m].
    offset : Coordinate
        Offset of a roller follower [m].
    cam_modulus : Pressure
        Young's modulus of the cam [Pa].
    follower_modulus : Pressure
        Young's modulus of the follower [Pa].
    cam_poisson : Ratio
        Poisson's ratio of the cam.
    follower_poisson : Ratio
        Poisson's ratio of the follower.
    """

    base_radius: Size
    width: Size
    roller_radius: Size | None = None
    offset: Coordinate = 0.0
    cam_modulus: Pressure = STEEL
    follower_modulus: Pressure = STEEL
    cam_poisson: Ratio = STEEL_RATIO
    follower_poisson: Ratio = STEEL_RATIO


@record
class Duration:
    """How long the follower is above a lift.

    Parameters
    ----------
    lift : Coordinate
        The lift, above the lowest of the turn [m].
    opens : Angle
        Cam angle at which it is passed upwards [rad].
    closes : Angle
        Cam angle at which it is passed downwards [rad].
    duration : Angle
        Cam angle between [rad].
    crank_duration : Angle
        The same in angle of a four-stroke engine's crank, twice the cam's [rad].
    opening_speed : Speed
        Speed of the follower when it passes upwards [m/s].
    closing_speed : Speed
        Speed when it passes downwards, where a valve would seat [m/s].
    """

    lift: Coordinate
    opens: Angle
    closes: Angle
    duration: Angle
    crank_duration: Angle
    opening_speed: Speed
    closing_speed: Speed


@record
class Ramp:
    """A ramp: cam angle from one lift to another.

    Parameters
    ----------
    side : Text
        Opening or closing.
    from_lift : Coordinate
        The lower lift [m].
    to_lift : Coordinate
        The higher lift [m].
    angle : Angle
        Cam angle between them [rad].
    mean_speed : Speed
        Mean speed of the follower on it [m/s].
    """

    side: Text
    from_lift: Coordinate
    to_lift: Coordinate
    angle: Angle
    mean_speed: Speed


@record
class ForcePoint:
    """Forces at one cam angle.

    Parameters
    ----------
    angle : Angle
        Cam angle [rad].
    lift : Coordinate
        Lift [m].
    axial_force : Force
        Force between cam and follower along the follower's way [N].
    torque : Torque
        Torque the shaft has to give [N*m].
    """

    angle: Angle
    lift: Coordinate
    axial_force: Force
    torque: Torque


@record
class Forces:
    """Forces on a cam over one turn.

    Parameters
    ----------
    least_force : Force
        Least force between cam and follower; negative, the follower leaves the cam [N].
    least_force_at : Angle
        Where [rad].
    greatest_force : Force
        Greatest [N].
    greatest_force_at : Angle
        Where [rad].
    greatest_torque : Torque
        Greatest torque the shaft has to give [N*m].
    greatest_torque_at : Angle
        Where [rad].
    least_torque : Torque
        Least; negative, the follower drives the shaft [N*m].
    least_torque_at : Angle
        Where [rad].
    greatest_power : Power
        Greatest power of the shaft [W].
    jump_speed : ShaftSpeed
        Speed of the shaft above which the follower leaves the cam [rad/s].
    jump_at : Angle
        Where it leaves first [rad].
    preload_needed : Force
        Least preload that keeps contact at this speed [N].
    stress : Pressure
        Greatest Hertz pressure [Pa].
    stress_at : Angle
        Where [rad].
    surge_frequency : Frequency
        Lowest natural frequency of the spring itself [Hz].
    surge_order : Ratio
        That frequency over the shaft's turns per second: the harmonic of the cam that meets it.
    durations : tuple of Duration
        How long the follower is above given lifts.
    ramps : tuple of Ramp
        Cam angle from the lash to the first of those lifts.
    table : Columns of ForcePoint
        Forces over the turn.
    """

    least_force: Force
    least_force_at: Angle
    greatest_force: Force
    greatest_force_at: Angle
    greatest_torque: Torque
    greatest_torque_at: Angle
    least_torque: Torque
    least_torque_at: Angle
    greatest_power: Power
    jump_speed: ShaftSpeed | None
    jump_at: Angle | None
    preload_needed: Force
    stress: Pressure | None
    stress_at: Angle | None
    surge_frequency: Frequency | None
    surge_order: Ratio | None
    durations: tuple[Duration, ...]
    ramps: tuple[Ramp, ...] | None
    table: Columns[ForcePoint]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


class _Load:
    """Force along the follower's way, F = k s + P + m ω² s″, with P the preload and the external load together."""

    def __init__(self, motion: Motion, mass: float, rate: float, steady: float, omega: float) -> None:
        self.motion = motion
        self.rate = rate
        self.steady = steady
        self.inertia = mass * omega * omega
        self.mass = mass

    def force(self, s: "object", s2: "object") -> "object":
        return self.rate * s + self.steady + self.inertia * s2  # type: ignore[operator]


def force(
    scene: Program,
    /,
    *,
    program: Text = "",
    shaft_speed: ShaftSpeed,
    mass: Mass,
    spring_rate: Stiffness = 0.0,
    preload: Force = 0.0,
    load: Force = 0.0,
    spring_mass: Mass | None = None,
    contact: Contact | None = None,
    at_lifts: tuple[Size, ...] = (0.00127, 0.001),
    lash: Size | None = None,
    count: Count = 37,
) -> Forces:
    """Contact force, torque and power of a spring-loaded follower, the jump speed, Hertz stress and valve durations.

    Equation
    --------
    F = k s + P + m ω² d²s/dθ², T = F ds/dθ; ω_jump² = min (k s + P)/(−m d²s/dθ²) where d²s/dθ² < 0;
    p = √(N E*/(π b ρ)), 1/ρ = 1/ρ_cam + 1/R_r, N = F/cos φ.

    Parameters
    ----------
    scene : Program
        Segments from a file.
    program : Text
        Segments in one line.
    shaft_speed : ShaftSpeed
        Speed of the cam shaft [rad/s].
    mass : Mass
        Mass that moves with the follower, a third of the spring's included [kg].
    spring_rate : Stiffness
        Rate of the spring [N/m].
    preload : Force
        Force of the spring at no lift [N].
    load : Force
        Steady external force that presses the follower on the cam; negative lifts it [N].
    spring_mass : Mass
        Mass of the spring's active coils, for its surge [kg].
    contact : Contact
        Base radius, width and roller for the Hertz stress.
    at_lifts : tuple of Size
        Lifts above the lowest at which durations are wanted; 0.050 in and 1 mm when not given [m].
    lash : Size
        Lash of a valve gear; ramps are counted from it [m].
    count : Count
        Points of the table.

    Returns
    -------
    Forces
        Extremes with their places, the speed at which the follower jumps, and the table.

    Raises
    ------
    InadmissibleError
        When the program moves an arm, the mass is zero, or the contact would be undercut.

    Notes
    -----
    A rigid train without friction. Extremes are searched on 64 points of each zone and refined to rounding. The torque
    does no work over a turn; its mean is checked.

    References
    ----------
    Newton's law along the follower's way; Hertz's line contact; the surge of a spring held at both ends as
    ½√(k/m_spring), with the usual rule that it should be above the twelfth harmonic of the cam.

    Examples
    --------
    >>> line = "rise 20 mm in 90 deg cycloidal; dwell 60 deg; return in 90 deg 3-4-5; dwell"
    >>> found = force(Program(), program=line, shaft_speed=50.0, mass=0.5, spring_rate=5000.0, preload=60.0)
    >>> round(found.jump_speed, 3)
    76.742
    """
    motion = motion_of(scene, program)
    require(
        not motion.swing,
        "this program swings an arm: forces are computed for sliding followers",
        code="swing",
        hint="write the lifts as lengths",
    )
    require(mass > 0.0, "a mass of {0:.6g} kg has no inertia", mass, code="mass")
    require(
        preload >= 0.0, "a preload of {0:.6g} N pulls: a spring presses", preload, code="preload", hint="use the load"
    )
    omega = abs(shaft_speed)
    loads = _Load(motion, mass, spring_rate, preload + load, omega)
    low, high = least_and_greatest(motion, lambda s, s1, s2: loads.force(s, s2))
    least_torque, most_torque = least_and_greatest(motion, lambda s, s1, s2: loads.force(s, s2) * s1)
    jump = _jump(loads)
    stress = None if contact is None else _stress(loads, contact)
    surge = None if spring_mass is None else _surge(spring_rate, spring_mass)
    turns = omega / (2.0 * pi)
    order = surge / turns if surge is not None and turns else None
    durations, missed = _durations(motion, at_lifts, shaft_speed)
    return Forces(
        low.value, low.at,
        high.value, high.at,
        most_torque.value, most_torque.at,
        least_torque.value, least_torque.at,
        max(abs(most_torque.value), abs(least_torque.value)) * omega,
        None if jump is None else jump.value,
        None if jump is None else jump.at,
        max(0.0, preload - low.value),
        None if stress is None else stress.value,
        None if stress is None else stress.at,
        surge,
        order,
        durations,
        _ramps(motion, lash, at_lifts, shaft_speed),
        _table(loads, count),
        checks=(_mean_torque(loads),),
        advice=(*_advice(jump, low, omega, preload, order), *missed),
        numerics=Numerics(
            "closed-form motion; extremes refined on each zone",
            (ErrorBound("greatest_force", 1e-12), *((ErrorBound("jump_speed", 1e-12),) if jump else ())),
        ),
    )  # fmt: skip


def _jump(loads: _Load) -> "Found | None":
    """The shaft speed at which the force first falls to zero; None where no speed does it."""
    _, worst = least_and_greatest(loads.motion, lambda s, s1, s2: _lift_off(loads, s, s2))
    if worst.value <= 0.0:
        return None
    return Found(1.0 / sqrt(worst.value), worst.at)


def _lift_off(loads: _Load, s: "object", s2: "object") -> "object":
    """1/ω² at which the force vanishes here; zero where it never does."""
    import numpy as np

    held = loads.rate * s + loads.steady  # type: ignore[operator]
    pulls = -loads.mass * s2  # type: ignore[operator]
    with np.errstate(divide="ignore", invalid="ignore"):
        found = np.where(held > 0.0, pulls / held, np.where(pulls > 0.0, inf, 0.0))
    return np.maximum(found, 0.0)


def _stress(loads: _Load, contact: Contact) -> Found:
    require(contact.width > 0.0, "a contact of no width bears nothing", code="width")
    require(contact.base_radius > 0.0, "a base circle of radius {0:.6g} m", contact.base_radius, code="base-radius")
    require(
        contact.cam_modulus > 0.0 and contact.follower_modulus > 0.0, "Young's modulus is above zero", code="modulus"
    )
    give = (1.0 - contact.cam_poisson * contact.cam_poisson) / contact.cam_modulus
    give += (1.0 - contact.follower_poisson * contact.follower_poisson) / contact.follower_modulus
    curved = _relative_curvature(contact)

    def squared(s: "object", s1: "object", s2: "object") -> "object":
        import numpy as np

        curvature, lean = curved(s, s1, s2)  # type: ignore[operator]
        normal = np.maximum(loads.force(s, s2), 0.0) * lean
        return normal * curvature / (pi * contact.width * give)

    _, found = least_and_greatest(loads.motion, squared)
    return Found(sqrt(found.value), found.at)


def _relative_curvature(contact: Contact) -> "object":
    """Sum of the curvatures of cam and follower, and 1/cos φ, as a function of s and its derivatives."""
    import numpy as np

    base, roller, offset = contact.base_radius, contact.roller_radius, contact.offset

    def flat(s: "object", s1: "object", s2: "object") -> "tuple[object, object]":
        radius = base + s + s2  # type: ignore[operator]
        _require_convex(radius)
        return 1.0 / radius, 1.0

    def rolling(s: "object", s1: "object", s2: "object") -> "tuple[object, object]":
        prime = base + roller  # type: ignore[operator]
        require(abs(offset) < prime, "the offset {0:.6g} m passes the cam", offset, code="offset")
        x = sqrt((prime - offset) * (prime + offset)) + s
        y = s1 - offset  # type: ignore[operator]
        w = np.hypot(x, y)
        # Curvature of the pitch curve; the cam's is κ/(1 − R κ), so that 1/ρ_cam + 1/R = 1/(R (1 − R κ)).
        pitch = (w * w + y * s1 - x * s2) / (w * w * w)
        left = 1.0 - roller * pitch
        _require_convex(left)
        return 1.0 / (roller * left), w / x  # type: ignore[operator]

    if roller is None:
        require(
            offset == 0.0, "a flat face has no offset", code="offset", hint="give a roller radius, or leave the offset out"
        )
        return flat
    require(roller > 0.0, "a roller of radius {0:.6g} m is a knife edge: its stress is infinite", roller, code="roller")
    return rolling


def _require_convex(radius: "object") -> None:
    worst = float(getattr(radius, "min", lambda: radius)())
    require(
        worst > 0.0,
        "the cam would be undercut: no contact to carry a stress",
        code="undercut",
        hint="take a larger base circle or a smaller roller; `dynamics cam size` finds the least",
    )


def _surge(rate: float, mass: float) -> float:
    require(mass > 0.0, "a spring of no mass has no surge", code="spring-mass", hint="leave the spring mass out")
    require(rate > 0.0, "a spring mass without a spring rate", code="spring-rate")
    return 0.5 * sqrt(rate / mass)


def _durations(
    motion: Motion, lifts: "tuple[float, ...]", omega: float
) -> "tuple[tuple[Duration, ...], tuple[Advice, ...]]":
    found = []
    missed = []
    least = motion.stroke[0]
    for lift in lifts:
        ways = crossings(motion, least + lift)
        ups = [angle for angle, up in ways if up]
        downs = [angle for angle, up in ways if not up]
        if not ups:
            missed.append(
                Advice("duration", f"the follower never passes a lift of {lift:.6g} m: it has no duration", "note")
            )
        for opens in ups:
            closes = min((angle if angle > opens else angle + 2.0 * pi) for angle in downs)
            span = closes - opens
            speeds = [motion.at(angle, 1)[1] * omega for angle in (opens, closes)]
            found.append(Duration(lift, opens, closes, span, 2.0 * span, *speeds))
    return tuple(found), tuple(missed)


def _ramps(motion: Motion, lash: float | None, lifts: "tuple[float, ...]", omega: float) -> "tuple[Ramp, ...] | None":
    if lash is None or not lifts:
        return None
    top = max(lifts)
    require(
        lash < top, "the lash {0:.6g} m is not below the lift {1:.6g} m of the durations", lash, top, code="lash"
    )
    least = motion.stroke[0]
    low, high = crossings(motion, least + lash), crossings(motion, least + top)
    found = []
    for angle, up in high:
        side = [other for other, way in low if way == up]
        if side:
            span = min((angle - other if up else other - angle) % (2.0 * pi) for other in side)
            mean = (top - lash) / span * abs(omega) * (1.0 if up else -1.0)
            found.append(Ramp("opening" if up else "closing", lash, top, span, mean))
    return tuple(found)


def _table(loads: _Load, count: int) -> "Columns[ForcePoint]":
    from dynamics_cli.cam.revolution import MOST_POINTS, angles_of_turn

    require(2 <= count <= MOST_POINTS, "a table has 2 to {0} points, not {1}", MOST_POINTS, count, code="count")
    angles, _ = angles_of_turn(loads.motion, count)
    s, s1, s2 = loads.motion.at(angles, 2)
    axial = loads.force(s, s2)
    return Columns(ForcePoint, angle=angles, lift=s, axial_force=axial, torque=axial * s1)  # type: ignore[operator]


def _mean_torque(loads: _Load) -> Check:
    """The torque does no work over a turn: spring and inertia give back what they take."""
    from dynamics_cli.cam.searching import integral

    mean, size = integral(loads.motion, lambda s, s1, s2: loads.force(s, s2) * s1)
    left = abs(mean) / size if size else 0.0
    return Check("work over a turn is zero", left <= 1e-12, left, 1e-12)


def _advice(
    jump: "Found | None", low: Found, omega: float, preload: float, order: float | None
) -> "tuple[Advice, ...]":
    found = []
    if low.value < 0.0:
        found.append(
            Advice(
                "follower-leaves",
                f"the force falls to {low.value:.6g} N at {low.at * 180.0 / pi:.6g} deg: the follower leaves the cam",
                "serious",
                f"raise the preload to {preload - low.value:.6g} N"
                + (f", or stay below {jump.value * 30.0 / pi:.6g} rpm" if jump and jump.value else ""),
            )
        )
    elif jump is not None and jump.value < 1.2 * omega:
        found.append(
            Advice(
                "near-jump",
                f"the follower jumps at {jump.value * 30.0 / pi:.6g} rpm, {jump.value / omega - 1.0:.1%} above this speed",
                "caution",
                "raise the preload or the spring rate",
            )
        )
    if jump is None:
        found.append(
            Advice("no-jump", "no speed makes the follower jump", "note", result="jump_speed")
        )
    if order is not None and order < SURGE_ORDER:
        found.append(
            Advice(
                "spring-surge",
                f"the spring surges at {order:.4g} times the shaft's speed: harmonics of the cam up to the twelfth excite it",
                "caution" if order > 0.7 * SURGE_ORDER else "serious",
                "take a lighter or a stiffer spring",
            )
        )
    return tuple(found)
