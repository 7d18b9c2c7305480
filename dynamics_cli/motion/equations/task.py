"""The task `equations`: Kane's and Lagrange's equations of a scene at an instant."""

from dynamics_cli.errors import require
from dynamics_cli.motion.equations.answers import (
    acceleration,
    condition_rows,
    force,
    mass_rows,
    partials,
    share_of,
    speed_rows,
)
from dynamics_cli.motion.equations.constraints import Constrained, by_multipliers
from dynamics_cli.motion.equations.kane import Kane, Load, generalized
from dynamics_cli.motion.equations.lagrange import Lagrange, potential
from dynamics_cli.motion.equations.records import CoordinateEquation, Equations, Scene, Turning, Upward
from dynamics_cli.motion.equations.system import System
from dynamics_cli.motion.rods import solved
from dynamics_cli.numerics.number import over_plain, plain
from dynamics_cli.quantities import STANDARD_GRAVITY, Annotated, Gravity, Text, Time, Variable
from dynamics_cli.records import Check, Numerics

# A pivot below this share of its diagonal is rounding: the coordinate moves nothing that others do not.
DEPENDENT = 1e-13
# Both methods agree within this share of the terms that they sum.
SAME = 1e-12
METHOD = "Kane's method beside Lagrange's"


def equations(
    scene: Annotated[Scene, "The system, from a file."],
    /,
    *,
    terms: Annotated[Text | None, "Show what makes up the equation of this coordinate or speed."] = None,
    time: Annotated[Time, "The instant, t in formulas, e.g. 0.5 s."] = 0.0,
    let: Annotated[tuple[Variable, ...], "Variables of formulas, e.g. L=0.8 m."] = (),
    up: Annotated[Upward, "The axis that points up: x, y, z, or none without gravity."] = Upward("y"),  # noqa: B008
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Equations:
    """Equations of motion of bodies whose places are formulas of generalized coordinates, at an instant.

    Equation
    --------
    F_r + F*_r = 0, F_r = Σ F·v_r + M·ω_r, F*_r = −Σ m·a·v_r + (I·α + ω × I·ω)·ω_r, with v_r and ω_r the partial
    velocities; beside them d/dt ∂T/∂q̇_r − ∂T/∂q_r = Q_r.

    Returns
    -------
    Equations
        Generalized forces and accelerations by both methods, the mass matrix, energies, partial velocities, and what
        each load contributes.

    Raises
    ------
    InadmissibleError
        When a name is unknown or taken, a formula has no value or no slope, or a coordinate moves no mass.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, chapters 11 and 12.

    Examples
    --------
    >>> from dynamics_cli.motion.equations.records import Body
    >>> from dynamics_cli.records import Formula
    >>> at = (Formula("0.5*sin(q)", 1.0, "m"), Formula("-0.5*cos(q)", 1.0, "m"))
    >>> point = Body("point", 2.0, *at)
    >>> made = equations(Scene((Turning("q", 0.3),), (point,)), gravity=10.0)
    >>> round(made.equations[0].acceleration.value, 6)
    -5.910404
    """
    system = System(scene, let, up)
    pull = gravity if system.up is not None else 0.0
    kane = Kane(system, *_instant(scene), time, pull)
    # a second opinion needs no bounds
    doubles = over_plain(scene)
    beside = System(doubles, over_plain(let), up)
    return _answer(kane, Lagrange(beside, *_instant(doubles), plain(time), plain(pull)), terms)


def _instant(scene: Scene) -> "tuple[list[float], list[float]]":
    """Values and rates of the coordinates."""
    turns = [isinstance(one, Turning) for one in scene.coordinates]
    named = list(zip(scene.coordinates, turns, strict=True))
    return (
        [getattr(one, "angle" if turn else "position") for one, turn in named],
        [getattr(one, "rate" if turn else "velocity") for one, turn in named],
    )


def _answer(kane: Kane, lagrange: Lagrange, asked: "str | None") -> Equations:
    system = kane.system
    n = len(system.names)
    at_rest = [kane.inertia_load(name, [0.0] * n) for name in system.bodies]
    active = [generalized(kane.loads, r) for r in range(n)]
    speeds = [generalized(at_rest, r) for r in range(n)]
    masses, right = kane.masses(), [a + b for a, b in zip(active, speeds, strict=True)]
    reduced = Constrained(kane) if system.scene.conditions or system.scene.speeds else None
    rates, seconds, kept, others, multipliers = _solved(kane, lagrange, masses, right, reduced)
    inertia = [kane.inertia_load(name, seconds) for name in system.bodies]
    loads = [*kane.loads, *inertia]
    kinetic = sum(map(kane.kinetic, system.bodies))
    sums = [sum(load.size(r) for load in [*loads, *at_rest]) for r in range(n + 1)]
    power = sums.pop()
    # turning bodies have terms of the size of their energy, which cancel where they are symmetrical
    sums = [size + 2.0 * plain(kinetic) * turns for size, turns in zip(sums, system.angular, strict=True)]
    scales = reduced.scales(lagrange.matrix, sums) if reduced else _scales(lagrange.matrix, sums)
    apart = [abs(plain(a) - b) for a, b in zip(seconds, others, strict=True)]
    difference = max(off / scale if scale else 0.0 for off, scale in zip(apart, scales, strict=True))
    ways = _ways(system, reduced, asked)
    if reduced:
        reduced.extend(loads)
    shares = tuple(share_of(system, load, *way) for way in ways for load in loads if plain(load.share(way[0])) != 0.0)
    rows = [
        CoordinateEquation(
            name=name, active_force=force(turns, active[r]),
            inertia_force=force(turns, generalized(inertia, r)),
            velocity_force=force(turns, speeds[r]), acceleration=acceleration(turns, seconds[r]),
            by_lagrange=acceleration(turns, others[r]), lagrange_force=force(turns, lagrange.forces[r]),
        )
        for r, name, turns in ways[:n]
    ]  # fmt: skip
    return Equations(
        equations=tuple(rows),
        difference=difference,
        kinetic_energy=kinetic,
        potential_energy=potential(system, kane.numbers, kane.gravity),
        drive_power=-sum(load.share(n) for load in loads) if system.timed else None,
        mass_matrix=mass_rows(system, masses),
        speeds=speed_rows(reduced, kane.loads, rates) if reduced else None,
        conditions=condition_rows(system, kept, multipliers) if system.conditions else None,
        terms=tuple(share for share in shares if share.coordinate == asked) if asked else None,
        partials=tuple(partials(kane)),
        shares=shares,
        numerics=Numerics(METHOD),
        checks=tuple(_checks(system, difference, loads, power)),
    )


def _solved(
    kane: Kane, lagrange: Lagrange, masses: "list[list[float]]", right: "list[float]", reduced: "Constrained | None"
) -> "tuple[list[float], ...]":
    """Derivatives of the speeds, accelerations and forces of conditions by Kane; the latter two by Lagrange."""
    if reduced is None:
        others = _accelerations(kane.system, lagrange.matrix, lagrange.right)
        return [], _accelerations(kane.system, masses, right), [], others, []
    kane.system.timed |= any(plain(fixed) for fixed in reduced.conditions.fixed)
    return (
        *reduced.accelerations(masses, right),
        *by_multipliers(reduced.conditions, lagrange.matrix, lagrange.right),
    )


def _ways(system: System, reduced: "Constrained | None", asked: "str | None") -> "list[tuple[int, str, bool]]":
    """What a load may have a share in: place among its partial velocities, name, whether it is angular."""
    ways = [(r, name, system.angular[r]) for r, name in enumerate(system.names)]
    if reduced:
        own = zip(reduced.names, reduced.angular, strict=True)
        ways += [(len(system.names) + 1 + k, *one) for k, one in enumerate(own)]
    require(asked is None or any(asked == name for _, name, _ in ways), "there is no coordinate or speed {name}",
            name=repr(asked), code="unknown-name", hint="there are {known}",
            known=", ".join(name for _, name, _ in ways))  # fmt: skip
    return ways


def _accelerations(system: System, matrix: "list[list[float]]", right: "list[float]") -> "list[float]":
    """M⁻¹ times the right side; refuses a coordinate that moves no mass of its own."""
    rows = [list(row) for row in matrix]
    try:
        out = solved(rows, list(right))
    except ZeroDivisionError:
        out = []
    for name, row, old, r in zip(system.names, rows, matrix, range(len(rows)), strict=True):
        require(plain(old[r]) > 0.0, "{name} moves no mass at this instant", name=name, code="massless",
                hint="give what it moves a mass or an inertia, or leave it out")  # fmt: skip
        require(plain(row[r]) > DEPENDENT * plain(old[r]),
                "{name} moves nothing that other coordinates do not move alike", name=name, code="dependent",
                hint="leave it out, or choose another instant")  # fmt: skip
    return out


def _scales(matrix: "list[list[float]]", sums: "list[float]") -> "list[float]":
    """For each acceleration the size of the terms that it is made of: |M⁻¹| times the sums of sizes."""
    n = len(matrix)
    scales = [0.0] * n
    for s in range(n):
        column = solved([list(row) for row in matrix], [1.0 if r == s else 0.0 for r in range(n)])
        for r in range(n):
            scales[r] += abs(column[r]) * sums[s]
    return scales


def _checks(system: System, difference: float, loads: "list[Load]", size: float) -> "list[Check]":
    checks = [Check("Kane's and Lagrange's accelerations agree", difference < SAME, difference, SAME)]
    if not system.timed:
        n = len(system.names)
        off = abs(sum(plain(load.share(n)) for load in loads)) / size if size else 0.0
        checks.append(Check("energy changes by the power of the loads", off < SAME, off, SAME))
    return checks
