"""Forces on a cam: contact force, torque, the speed at which the follower jumps, surge, valve durations."""

from math import inf, pi, sqrt

from dynamics_cli.cam.force_records import Contact, Duration, ForcePoint, Forces, Ramp
from dynamics_cli.cam.motion import Motion
from dynamics_cli.cam.program import Program, motion_of
from dynamics_cli.cam.searching import Found, crossings, greatest, least_and_greatest
from dynamics_cli.cam.stress import Load
from dynamics_cli.cam.stress import stress as hertz
from dynamics_cli.errors import require
from dynamics_cli.quantities import (
    Count,
    Force,
    Mass,
    ShaftSpeed,
    Size,
    Stiffness,
    Text,
)
from dynamics_cli.records import Advice, Check, Columns, ErrorBound, Numerics

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

SURGE_ORDER = 12.0


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
    loads = Load(motion, mass, spring_rate, preload + load, omega)
    low, high = least_and_greatest(motion, lambda s, s1, s2: loads.force(s, s2))
    least_torque, most_torque = least_and_greatest(motion, lambda s, s1, s2: loads.force(s, s2) * s1)
    jump = _jump(loads)
    stress = None if contact is None else hertz(loads, contact)
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


def _jump(loads: Load) -> "Found | None":
    """The shaft speed at which the force first falls to zero; None where no speed does it."""
    worst = greatest(loads.motion, lambda s, s1, s2: _lift_off(loads, s, s2))
    if worst.value <= 0.0:
        return None
    return Found(1.0 / sqrt(worst.value), worst.at)


def _lift_off(loads: Load, s: "Any", s2: "Any") -> "Any":
    """1/ω² at which the force vanishes here; zero where it never does."""
    import numpy as np

    held = loads.rate * s + loads.steady
    pulls = -loads.mass * s2
    with np.errstate(divide="ignore", invalid="ignore"):
        found = np.where(held > 0.0, pulls / held, np.where(pulls > 0.0, inf, 0.0))
    return np.maximum(found, 0.0)


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
    require(lash < top, "the lash {0:.6g} m is not below the lift {1:.6g} m of the durations", lash, top, code="lash")
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


def _table(loads: Load, count: int) -> "Columns[ForcePoint]":
    from dynamics_cli.cam.revolution import MOST_POINTS, angles_of_turn

    require(2 <= count <= MOST_POINTS, "a table has 2 to {0} points, not {1}", MOST_POINTS, count, code="count")
    angles, _ = angles_of_turn(loads.motion, count)
    s, s1, s2 = loads.motion.at(angles, 2)
    axial = loads.force(s, s2)
    return Columns(ForcePoint, angle=angles, lift=s, axial_force=axial, torque=axial * s1)


def _mean_torque(loads: Load) -> Check:
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
                f"the follower jumps at {jump.value * 30.0 / pi:.6g} rpm, "
                f"{jump.value / omega - 1.0:.1%} above this speed",
                "caution",
                "raise the preload or the spring rate",
            )
        )
    if jump is None:
        found.append(Advice("no-jump", "no speed makes the follower jump", "note", result="jump_speed"))
    if order is not None and order < SURGE_ORDER:
        found.append(
            Advice(
                "spring-surge",
                f"the spring surges at {order:.4g} times the shaft's speed: "
                "harmonics of the cam up to the twelfth excite it",
                "caution" if order > 0.7 * SURGE_ORDER else "serious",
                "take a lighter or a stiffer spring",
            )
        )
    return tuple(found)
