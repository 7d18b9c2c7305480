"""Forces on a cam: contact force, torque, the speed at which the follower jumps, surge, valve durations."""

from math import pi

from dynamics_cli.cam.forces.loads import Load, load_of, surge
from dynamics_cli.cam.forces.records import (
    ArmOnTorsionSpring,
    ArmPoint,
    Contact,
    ContactPoint,
    DrivenFollower,
    ForcePoint,
    Forces,
    Train,
)
from dynamics_cli.cam.geometry.followers import Rotation, require_lift
from dynamics_cli.cam.program.motion import Motion
from dynamics_cli.cam.program.reading import Program, motion_of
from dynamics_cli.errors import UsageError, require
from dynamics_cli.quantities import Annotated, Count, ShaftSpeed, Size, Text
from dynamics_cli.records import Check, Columns, ErrorBound, Numerics

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.cam.forces.survey import Found, Survey
    from dynamics_cli.cam.geometry.contact import Geometry

CCW = Rotation("counter-clockwise")
BALANCE = 1e-12


def force(
    scene: Annotated[Program, "One turn of the cam in segments, from a file."],
    /,
    *,
    program: Annotated[Text, "Segments in one line, in place of a file."] = "",
    shaft_speed: Annotated[ShaftSpeed, "Speed of the cam shaft [rad/s]."],
    train: Annotated[
        Train,
        "Mass and forces of a slide, or moment of inertia and torques of an arm.",
    ],
    follower: Annotated[
        DrivenFollower | None, "The follower and where it stands, for the force along the common normal."
    ] = None,
    rotation: Annotated[Rotation, "Which way the cam turns."] = CCW,
    contact: Annotated[Contact | None, "Width and materials of the contact, for the Hertz pressure."] = None,
    at_lifts: Annotated[
        tuple[Size, ...] | None,
        "Lifts of a slide above the lowest at which durations are wanted; 0.050 in and 1 mm when not given [m].",
    ] = None,
    lash: Annotated[Size | None, "Lash of a valve gear; ramps are counted from it, e.g. 0.2 mm [m]."] = None,
    count: Annotated[Count, "Points of the table."] = 37,
) -> Forces:
    """Contact force, torque and power of a follower held by a spring, the jump speed, Hertz stress and durations.

    Equation
    --------
    Slide: F = k s + P + L + m ω² d²s/dθ², T = F ds/dθ, N = F/cos φ. Arm: M = k ψ + P + L + I ω² d²ψ/dθ²,
    T = M dψ/dθ, N = M/(lever of the common normal about the pivot). ω_jump² = min (k s + P + L)/(−m d²s/dθ²) where
    d²s/dθ² < 0, for an arm likewise; p = √(N E*/(π b ρ)), 1/ρ = 1/ρ_cam + 1/R_r.

    Returns
    -------
    Forces
        Extremes with their places, the speed at which the follower jumps, and tables.

    Raises
    ------
    UsageError
        When the program moves an arm and the parts given are a slide's, or the reverse.
    InadmissibleError
        When nothing has inertia, the follower cannot stand or be driven as the program requires, or a stress is
        requested where the cam is undercut.

    Notes
    -----
    A rigid train without friction. The extremes are those of Chebyshev interpolants of every piece of every law,
    evaluated by the formulas there; each bound has the rounding of motion and arithmetic. Least forces and torques
    pass through zero and are bounded absolutely. Next to a cusp the stress is as ill conditioned as its bound says. The
    torque does no work over a turn; its mean is checked, and so is that it is the moment of the contact force about the
    cam's axis. A spring on an arm is taken to act square to its radius at every swing. Form-closed followers (tracks,
    conjugate cams) need no spring and share the load between two contacts: they are out of scope.

    References
    ----------
    Newton's law along the follower's way, virtual work for the torque; Hertz's line contact; the surge of a spring held
    at both ends as ½√(k/m_spring), with the usual rule that it should be above the twelfth harmonic of the cam.

    Examples
    --------
    >>> from dynamics_cli.cam.forces.records import Slide
    >>> line = "rise 20 mm in 90 deg cycloidal; dwell 60 deg; return in 90 deg 3-4-5; dwell"
    >>> result = force(Program(), program=line, shaft_speed=50.0, train=Slide(0.5, 5000.0, 60.0))
    >>> round(result.jump_speed, 3)
    76.742
    """
    from dynamics_cli.cam.forces.advice import advice_of, impacts
    from dynamics_cli.cam.forces.durations import QUOTED, durations, ramps
    from dynamics_cli.cam.forces.jump import jump as jump_of
    from dynamics_cli.cam.forces.survey import Survey

    motion = motion_of(scene, program)
    omega = abs(shaft_speed)
    load = load_of(train, motion, omega)
    geometry = _geometry(motion, follower, rotation, contact)
    _require_slide(motion, at_lifts, lash)
    lifts = () if motion.swing else QUOTED if at_lifts is None else at_lifts
    timed, missed = durations(motion, lifts, shaft_speed)
    exact = load.enclosed()
    survey = Survey(motion, lambda s, s1, s2: exact.force(s, s2), lambda s, s1, s2: exact.force(s, s2) * s1)
    (low, high), (back, most) = (survey.extremes(which) for which in range(2))
    leaves = jump_of(motion, load, survey)
    normal = stress = None
    if geometry is not None:
        normal, stress = _contact(motion, geometry, load, contact)
    frequency = surge(load)
    order = frequency * 2.0 * pi / omega if frequency is not None and omega else None
    power = max(abs(most.value), abs(back.value)) * omega
    needed = max(0.0, load.preload - low.value)
    arm = motion.swing
    torsion = isinstance(train, ArmOnTorsionSpring)
    tables, statics = _tables(motion, geometry, load, count)
    return Forces(
        *_ends(None if arm else (low, high)),
        *_ends((low, high) if arm else None),
        *_ends(normal),
        most.value, most.at,
        back.value, back.at,
        power,
        *_fields(leaves),
        None if torsion else needed / load.spring_radius,
        needed if torsion else None,
        *_fields(stress),
        frequency,
        order,
        None if arm else timed,
        ramps(motion, lash, lifts, shaft_speed),
        *tables,
        checks=(_mean_torque(motion, load, survey), *statics),
        advice=(*advice_of(load, train, omega, low, leaves, order), *impacts(motion), *missed),
        numerics=Numerics(
            "closed-form motion; extremes from Chebyshev interpolants of every piece",
            _bounds(arm, (low, high), normal, (back, most), leaves, stress, omega),
        ),
    )  # fmt: skip


def _geometry(motion: Motion, follower: "Any", rotation: Rotation, contact: Contact | None) -> "Geometry | None":
    if follower is None:
        if contact is not None:
            raise UsageError(
                "follower is missing: the contact stress depends on its shape",
                parameter="follower", code="missing",
                hint='for example --follower roller --base-radius "40 mm" --roller-radius "10 mm"',
            )  # fmt: skip
        return None
    from dynamics_cli.cam.forces.stress import require_lever
    from dynamics_cli.cam.geometry.contact import Geometry

    geometry = Geometry(follower, rotation)
    require_lift(motion, geometry.oscillating)
    require_lever(geometry, motion)
    return geometry


def _require_slide(motion: Motion, lifts: "tuple[float, ...] | None", lash: float | None) -> None:
    name = "at_lifts" if lifts is not None else "lash"
    if motion.swing and (lifts is not None or lash is not None):
        raise UsageError(
            f"{name}: durations and ramps are counted at lifts, and this program swings an arm",
            parameter=name, code="lift-kind", hint="leave it out",
        )  # fmt: skip


def _contact(
    motion: Motion, geometry: "Geometry", load: Load, contact: Contact | None
) -> "tuple[tuple[Found, Found], Found | None]":
    """Extremes of the force along the common normal, and the maximum pressure if a contact is given."""
    from dynamics_cli.cam.forces.stress import Touching, stress
    from dynamics_cli.cam.forces.survey import Survey

    touching = Touching(geometry, load)
    pressed = None if contact is None else stress(motion, touching, contact)
    return Survey(motion, touching.enclosed().normal).extremes(0), pressed


def _ends(pair: "tuple[Found, Found] | None") -> "tuple[float | None, float | None, float | None, float | None]":
    return (None, None, None, None) if pair is None else (*_fields(pair[0]), *_fields(pair[1]))


def _fields(extreme: "Found | None") -> "tuple[float | None, float | None]":
    return (None, None) if extreme is None else (extreme.value, extreme.at)


def _bounds(
    arm: bool, force_: "tuple[Found, Found]", normal: "tuple[Found, Found] | None", torque: "tuple[Found, Found]",
    leaves: "Found | None", stress: "Found | None", omega: float,
) -> "tuple[ErrorBound, ...]":  # fmt: skip
    name = "arm_torque" if arm else "force"
    # power is torque times speed, with one more rounding
    power = max(abs(extreme.value) for extreme in torque) * omega
    error = max(extreme.error for extreme in torque) * omega + 2.0**-52 * power
    bounds = [
        *_both(name, force_),
        *(() if normal is None else _both("contact_force", normal)),
        *_both("torque", torque),
        *_bound("greatest_power", power, error, relative=True),
    ]
    for title, extreme in (("jump_speed", leaves), ("stress", stress)):
        if extreme is not None:
            bounds += _bound(title, extreme.value, extreme.error, relative=True)
    return tuple(bounds)


def _both(name: str, pair: "tuple[Found, Found]") -> "list[ErrorBound]":
    low, high = pair
    return [
        *_bound(f"least_{name}", low.value, low.error, relative=False),
        *_bound(f"greatest_{name}", high.value, high.error, relative=high.value > 1e-3 * abs(low.value)),
    ]


def _bound(name: str, value: float, error: float, *, relative: bool) -> "list[ErrorBound]":
    relative_bound = relative and value != 0.0
    return [ErrorBound(name, error / abs(value) if relative_bound else error, relative_bound)]


def _tables(
    motion: Motion, geometry: "Geometry | None", load: Load, count: int
) -> "tuple[tuple[Any, Any, Any], tuple[Check, ...]]":
    """Forces over the turn, and where a follower is given the contact, with a check of statics."""
    from dynamics_cli.cam.program.revolution import MOST_POINTS, angles_of_turn

    require(
        2 <= count <= MOST_POINTS,
        "count: {count} points; a table has 2 to {most}",
        count=count, most=MOST_POINTS, code="count",
    )  # fmt: skip
    angles, _ = angles_of_turn(motion, count)
    s, s1, s2 = (column.copy() for column in motion.at(angles, 2))
    s[-1], s1[-1], s2[-1] = motion.at(float(angles[-1]), 2, -1)
    pressing = load.force(s, s2)
    # avoids minus zero
    lift, torque = s + 0.0, pressing * s1 + 0.0
    first: tuple[Any, Any]
    if motion.swing:
        first = None, Columns(ArmPoint, angle=angles, swing=lift, arm_torque=pressing + 0.0, torque=torque)
    else:
        first = Columns(ForcePoint, angle=angles, lift=lift, axial_force=pressing + 0.0, torque=torque), None
    if geometry is None:
        return (*first, None), ()
    return (*first, _contacts(geometry, load, angles, (s, s1, s2))), (_statics(motion, geometry, load),)


def _contacts(geometry: "Geometry", load: Load, angles: "Any", state: "tuple[Any, Any, Any]") -> "Any":
    import numpy as np

    from dynamics_cli.cam.forces.stress import Touching

    lean = np.broadcast_to(geometry.touch(*state).pressure_angle, angles.shape)
    normal = np.broadcast_to(Touching(geometry, load).normal(*state), angles.shape)
    return Columns(ContactPoint, angle=angles, pressure_angle=lean + 0.0, contact_force=normal + 0.0)


def _mean_torque(motion: Motion, load: Load, survey: "Survey") -> Check:
    """Spring and inertia return over a turn what they absorb; at velocity jumps the impact accounts for the rest."""
    work, size = survey.integral(1)
    count = len(motion.zones)
    ends = [(motion.in_zone(i, 0.0, 1)[1], motion.in_zone(i, 1.0, 1)[1]) for i in range(count)]
    steps = [ends[i][0] * ends[i][0] - ends[i - 1][1] * ends[i - 1][1] for i in range(count)]
    impacts = 0.5 * load.inertial * sum(steps)
    size += 0.5 * load.inertial * sum(map(abs, steps))
    imbalance = abs(work + impacts) / size if size else 0.0
    return Check("work over a turn is zero", imbalance <= BALANCE, imbalance, BALANCE)


def _statics(motion: Motion, geometry: "Geometry", load: Load) -> Check:
    """The torque by virtual work is the moment of the contact force about the cam's axis, N r × n."""
    import numpy as np

    from dynamics_cli.cam.forces.stress import Touching
    from dynamics_cli.cam.forces.survey import states

    s, s1, s2 = states(motion)
    touch = geometry.touch(s, s1, s2)
    normal = Touching(geometry, load).normal(s, s1, s2)
    (x, y), (nx, ny) = touch.point, touch.normal
    moment = geometry.turn * normal * (x * ny - y * nx)
    gap = float(np.max(np.abs(moment - load.force(s, s2) * s1)))
    size = float(np.max(np.abs(normal) * (np.abs(x) + np.abs(y))))
    imbalance = gap / size if size else 0.0
    return Check("torque is the moment of the contact force", imbalance <= BALANCE, imbalance, BALANCE)
