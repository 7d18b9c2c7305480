"""The task `equations`: Kane's and Lagrange's equations of a scene at an instant."""

from dynamics_cli.errors import require
from dynamics_cli.motion.equations.answers import acceleration, force, mass_rows, partials, share_of
from dynamics_cli.motion.equations.kane import Kane, Load
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
    terms: Annotated[Text | None, "Show what makes up the equation of this coordinate."] = None,
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
    require(terms is None or terms in system.names, "there is no coordinate {name}", name=repr(terms),
            code="unknown-name", hint="there are {known}", known=", ".join(system.names))  # fmt: skip
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
    active = [sum(load.share(r) for load in kane.loads) for r in range(n)]
    speeds = [sum(load.share(r) for load in at_rest) for r in range(n)]
    masses = kane.masses()
    seconds = _accelerations(system, masses, [a + b for a, b in zip(active, speeds, strict=True)])
    others = _accelerations(system, lagrange.matrix, lagrange.right)
    inertia = [kane.inertia_load(name, seconds) for name in system.bodies]
    loads = [*kane.loads, *inertia]
    scales = _scales(lagrange.matrix, [*loads, *at_rest])
    apart = [abs(plain(a) - b) for a, b in zip(seconds, others, strict=True)]
    difference = max(off / scale if scale else 0.0 for off, scale in zip(apart, scales, strict=True))
    shares = tuple(share_of(system, load, r) for r in range(n) for load in loads if plain(load.share(r)) != 0.0)
    rows = [
        CoordinateEquation(
            name=name, active_force=force(system, r, active[r]),
            inertia_force=force(system, r, sum(load.share(r) for load in inertia)),
            velocity_force=force(system, r, speeds[r]), acceleration=acceleration(system, r, seconds[r]),
            by_lagrange=acceleration(system, r, others[r]), lagrange_force=force(system, r, lagrange.forces[r]),
        )
        for r, name in enumerate(system.names)
    ]  # fmt: skip
    return Equations(
        equations=tuple(rows),
        difference=difference,
        kinetic_energy=sum(map(kane.kinetic, system.bodies)),
        potential_energy=potential(system, kane.numbers, kane.gravity),
        drive_power=-sum(load.share(n) for load in loads) if system.timed else None,
        mass_matrix=mass_rows(system, masses),
        terms=tuple(share for share in shares if share.coordinate == asked) if asked else None,
        partials=tuple(partials(kane)),
        shares=shares,
        numerics=Numerics(METHOD),
        checks=tuple(_checks(system, difference, loads)),
    )


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


def _scales(matrix: "list[list[float]]", loads: "list[Load]") -> "list[float]":
    """For each acceleration the size of the terms that it is made of: |M⁻¹| times the sums of sizes."""
    n = len(matrix)
    sums = [sum(load.size(r) for load in loads) for r in range(n)]
    scales = [0.0] * n
    for s in range(n):
        column = solved([list(row) for row in matrix], [1.0 if r == s else 0.0 for r in range(n)])
        for r in range(n):
            scales[r] += abs(column[r]) * sums[s]
    return scales


def _checks(system: System, difference: float, loads: "list[Load]") -> "list[Check]":
    checks = [Check("Kane's and Lagrange's accelerations agree", difference < SAME, difference, SAME)]
    if not system.timed:
        n = len(system.names)
        size = sum(load.size(n) for load in loads)
        off = abs(sum(plain(load.share(n)) for load in loads)) / size if size else 0.0
        checks.append(Check("energy changes by the power of the loads", off < SAME, off, SAME))
    return checks
