"""The task `speed`: work and energy of a body that moves, or rolls."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import sqrt
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Annotated,
    Distance,
    Force,
    Gravity,
    Inertia,
    Length,
    Mass,
    PotentialEnergy,
    Size,
    Speed,
)
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


@record
class Rolling:
    """What turns with the body as it moves: wheels, drums, gears."""

    inertia: Annotated[Inertia, "Moment of inertia of its rolling or rotating parts, e.g. 2 kg*m^2."]
    radius: Annotated[Size, "Radius at which it rolls or the rope runs, e.g. 300 mm."]


@record
class Balance:
    """The energies before and after."""

    end_speed: Annotated[Speed, "Speed at the end [m/s]."]
    change: Annotated[Speed, "Change of the speed [m/s]."]
    distance: Annotated[Distance | None, "The way [m]."]
    force: Annotated[Force | None, "Force along the way [N]."]
    work: Annotated[PotentialEnergy, "Work other than that of gravity [J]."]
    gravity_work: Annotated[PotentialEnergy | None, "Work of gravity; with the drop [J]."]
    start_energy: Annotated[PotentialEnergy, "Kinetic energy at the start [J]."]
    end_energy: Annotated[PotentialEnergy, "Kinetic energy at the end [J]."]
    effective_mass: Annotated[Mass | None, "Effective mass, rotating parts included; needs their inertia [kg]."]


def speed(
    *,
    mass: Annotated[Mass, "Mass of the body, e.g. 1500 kg."],
    start_speed: Annotated[Speed, "Speed at the start, e.g. 25 m/s."] = 0.0,
    work: Annotated[PotentialEnergy | None, "Work done on the body, negative when it resists, e.g. -2 kJ."] = None,
    force: Annotated[Force | None, "Force along the way, negative when it resists, e.g. -800 N."] = None,
    distance: Annotated[Distance | None, "The way along which the force acts, e.g. 40 m."] = None,
    drop: Annotated[Length, "How far the body falls meanwhile, negative when it rises, e.g. 3 m."] = 0.0,
    end_speed: Annotated[Speed | None, "Speed wanted at the end, for the work, force or distance, e.g. 0 m/s."] = None,
    rolling: Annotated[Rolling | None, "What turns with the body."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Balance:
    """Speed after work, or the work, force or distance that a speed takes.

    Equation
    --------
    ½·M·(v₂² − v₁²) = W + F·s + m·g·h with M = m + I/r²; Δv = (2·W/M)/(v₁ + √(v₁² + 2·W/M)).

    Returns
    -------
    Balance
        Speeds, energies, and what was asked for.

    Raises
    ------
    InadmissibleError
        When the energy does not suffice for the way: how much lacks, and where it stops. When a force cannot give the
        speed wanted, or work, force and distance leave nothing to calculate, or too much.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 10.5 to 10.9.

    Examples
    --------
    >>> speed(mass=1500.0, start_speed=33.3, work=1e-6).change
    2.0020020020014e-11
    """
    require(mass > 0.0, "the mass of {mass} is not above zero", mass=(mass, Mass))
    require(start_speed >= 0.0 and (end_speed is None or end_speed >= 0.0), "a speed below zero", code="speed",
            hint="give sizes of speeds; turn the force's sign instead")  # fmt: skip
    effective = mass
    if rolling is not None:
        require(rolling.radius > 0.0, "the radius is zero", code="radius", hint="give that at which it rolls")
        effective = mass + rolling.inertia / (rolling.radius * rolling.radius)
    falling = mass * gravity * drop
    start_energy = 0.5 * effective * start_speed * start_speed
    if end_speed is None:
        done = _done(work, force, distance, drop)
        _require_enough(start_energy, done + falling, work, force, distance, drop, falling)
        gain = 2.0 * (done + falling) / effective
        end = sqrt(_never_below_zero(start_speed * start_speed + gain))
        change = gain / (start_speed + end) if plain(start_speed + end) > 0.0 else 0.0 * gain
        end_energy = start_energy + done + falling
    else:
        end, change = end_speed, end_speed - start_speed
        end_energy = 0.5 * effective * end * end
        needed = 0.5 * effective * change * (end + start_speed) - falling
        done, force, distance = _wanted(needed, work, force, distance)
    return Balance(
        end_speed=end,
        change=change,
        distance=distance,
        force=force,
        work=done,
        gravity_work=falling if plain(drop) else None,
        start_energy=start_energy,
        end_energy=end_energy,
        effective_mass=None if rolling is None else effective,
    )


def _done(work: "Any", force: "Any", distance: "Any", drop: "Any") -> "Any":
    """Work beside gravity's, as given."""
    if force is None:
        require(work is not None or bool(plain(drop)), "there is no work to change the speed", code="nothing",
                hint="give --work, --force with --distance, --drop, or the --end-speed wanted")  # fmt: skip
        return 0.0 if work is None else work
    require(distance is not None, "a force without its way does no work", code="distance",
            hint="give --distance, or the --end-speed wanted")  # fmt: skip
    return force * distance if work is None else work + force * distance


def _require_enough(
    start: "Any", gain: "Any", work: "Any", force: "Any", distance: "Any", drop: "Any", falling: "Any"
) -> None:
    left = plain(start) + plain(gain)
    if left >= 0.0:
        return
    # where gravity and the force act along one even way, the energy falls in proportion to it
    stops = distance is not None and not plain(work or 0.0)
    where = plain(distance) * plain(start) / -plain(gain) if stops else 0.0
    require(False, "the energy lacks {lack}: it stops after {where}" if stops else "the energy lacks {lack}",
            lack=(-left, PotentialEnergy), where=(where, Length), code="stops",
            hint="give a smaller resistance, a higher start speed or a shorter way")  # fmt: skip


def _wanted(needed: "Any", work: "Any", force: "Any", distance: "Any") -> "tuple[Any, Any, Any]":
    """Work, force and distance for the energy needed, with the one that was left out."""
    if work is not None:
        require(force is None or distance is None, "with --end-speed one of work, force and distance is unknown",
                code="nothing-unknown", hint="leave one of them out")  # fmt: skip
        needed, rest = needed - work, work
    else:
        rest = 0.0
    if force is not None:
        require(distance is None, "with --end-speed one of work, force and distance is unknown",
                code="nothing-unknown", hint="leave one of them out")  # fmt: skip
        require(plain(force) != 0.0 and plain(needed) * plain(force) >= 0.0,
                "a force of {force} never does the {needed} that this speed takes", force=(force, Force),
                needed=(needed, PotentialEnergy), code="wrong-way",
                hint="turn its sign, or give another speed")  # fmt: skip
        return needed + rest, force, needed / force
    if distance is not None:
        require(plain(distance) > 0.0, "no force does work along no way", code="distance", hint="give a --distance")
        return needed + rest, needed / distance, distance
    require(work is None, "with --end-speed the work is the result and cannot be given", code="nothing-unknown",
            hint="leave out --work, or give --force or --distance too")  # fmt: skip
    return needed, None, None


def _never_below_zero(square: "Any") -> "Any":
    """A square that rounding may have taken below zero, where everything is used up."""
    return square if plain(square) > 0.0 else 0.0 * square
