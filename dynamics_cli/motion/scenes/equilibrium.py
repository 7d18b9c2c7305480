"""The task `equilibrium`: where a planar scene stands still, and what small motions about that do."""

import math

from dynamics_cli.errors import require
from dynamics_cli.motion.bodies.records import Scene
from dynamics_cli.motion.scenes.states import (
    JointForce,
    LinkState,
    PointState,
    SpringState,
    forces_by,
    joint_rows,
    links_of,
    points_of,
    springs_of,
)
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Annotated,
    Count,
    Force,
    Frequency,
    Gravity,
    PotentialEnergy,
    Ratio,
    Text,
    Time,
    Torque,
)
from dynamics_cli.records import Advice, Check, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.motion.bodies.start import Start
    from dynamics_cli.motion.scenes.rest import Rest

BALANCED = 1e-9


@record
class Place:
    """One place where it stands still."""

    number: Annotated[Count, "Its number; 1 is reached from the start [-]."]
    stability: Annotated[Text, "Stable, unstable, neutral, or held by drivers."]
    lowest: Annotated[Frequency | None, "Lowest frequency of small oscillations [Hz]."]
    energy: Annotated[PotentialEnergy, "Potential energy above the lowest place found [J]."]
    angles: Annotated[tuple[Angle, ...], "Angles of the links, in the scene's order [rad]."]


@record
class SmallMotion:
    """A small motion about it."""

    number: Annotated[Count, "From the slowest [-]."]
    kind: Annotated[Text, "Whether it oscillates, decays, grows, or stays as it is."]
    frequency: Annotated[Frequency | None, "Natural frequency of an oscillation [Hz]."]
    damping_ratio: Annotated[Ratio | None, "Its damping ratio [-]."]
    time_constant: Annotated[Time | None, "Time in which it grows or decays e times [s]."]
    mostly: Annotated[Text, "The link that moves most."]


@record
class SceneEquilibrium:
    """Where a scene stands still."""

    stability: Annotated[Text, "That of the place shown."]
    count: Annotated[Count, "Places found [-]."]
    places: Annotated[tuple[Place, ...], "All places found."]
    links: Annotated[tuple[LinkState, ...], "The links in the place shown."]
    points: Annotated[tuple[PointState, ...], "The points there."]
    reactions: Annotated[tuple[JointForce, ...], "Forces in the joints and of drivers there."]
    springs: Annotated[tuple[SpringState, ...] | None, "Springs between points there."]
    modes: Annotated[tuple[SmallMotion, ...] | None, "Small motions about it; null without masses."]
    numerics: Numerics
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def equilibrium(
    scene: Annotated[Scene, "The bodies, from a file."],
    /,
    *,
    place: Annotated[Count, "The place to show: 1 is the one reached from the start, e.g. 2."] = 1,
    gravity: Annotated[Gravity, "Acceleration of gravity, along −y [m/s^2]."] = STANDARD_GRAVITY,
) -> SceneEquilibrium:
    """Static equilibrium of planar bodies with pins, slides, springs and loads: places, stability, small motions.

    Equation
    --------
    Q(q) − Jᵀ·λ = 0 on the joints; stable where ZᵀKZ > 0, K = −∂(Q − Jᵀ·λ)/∂q, Z the motions left free;
    (s²·ZᵀMZ + s·ZᵀDZ + ZᵀKZ)·φ = 0.

    Returns
    -------
    SceneEquilibrium
        The places found, and links, joint forces and small motions in one of them.

    Raises
    ------
    InadmissibleError
        As of `scene`; and when nothing balances the forces, by the link that they drive.

    Notes
    -----
    Drivers hold their position at the start, loads are those at t = 0. Other places are looked for along the scene's
    own motions: there may be more.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 13.7 and 14.2
    (Lagrange–Dirichlet).
    """
    from dynamics_cli.motion.bodies.start import Start
    from dynamics_cli.motion.scenes.rest import rests

    start = Start(scene, gravity, static=True)
    found = rests(start)
    if not found:
        _refuse(start)
    require(1 <= place <= len(found), "there is no place {place}: {count} were found", place=str(place),
            count=str(len(found)), code="place", hint="1 to {count}")  # fmt: skip
    shown, system = found[place - 1], start.system
    lowest = min(one.energy() for one in found)
    left = _left(start, shown)
    forces = _forces(start, shown)
    return SceneEquilibrium(
        stability=shown.stability if shown.stability != "held" else "held by its drivers or joints",
        count=len(found),
        places=tuple(_place(one, number, lowest) for number, one in enumerate(found, 1)),
        links=links_of(system, shown.state, moving=False),
        points=points_of(system, shown.state, moving=False),
        reactions=joint_rows(system, forces, None),
        springs=springs_of(system, shown.state),
        modes=_modes(start, shown),
        numerics=Numerics("Newton; stiffness by five-point differences"),
        checks=(Check("forces balance", left <= BALANCED, left, BALANCED),),
        advice=tuple(start.advice),
    )


def _place(one: "Rest", number: int, lowest: float) -> Place:
    swings = [abs(root) for root in one.roots if root.imag > 0.0]
    angles = tuple(math.remainder(float(x), 2.0 * math.pi) for x in one.q[2::3])
    return Place(
        number, one.stability, min(swings) / (2.0 * math.pi) if swings else None, one.energy() - lowest, angles
    )


def _left(start: "Start", one: "Rest") -> float:
    """Forces left, over those that act."""
    from dynamics_cli.motion.scenes.rest import strained
    from dynamics_cli.motion.scenes.small import unbalanced

    system = start.system
    rest = 0.0 * one.q
    left = abs(unbalanced(system, 0.0, one.q, rest, one.multipliers)).max()
    acting = abs(unbalanced(system, 0.0, one.q, rest, 0.0 * one.multipliers)).max()
    return float(left / max(acting, strained(system, system.frame_of(one.state)), *map(abs, system.weights), 1e-300))


def _forces(start: "Start", one: "Rest") -> "list[tuple[float, float, float]]":
    system = start.system
    every = [float(one.multipliers[system.place[row]]) if row in system.place else 0.0 for row in range(system.rows)]
    return forces_by(system, system.frame_of(one.state), every)


def _modes(start: "Start", one: "Rest") -> "tuple[SmallMotion, ...] | None":
    if not one.roots:
        return None
    rows = []
    for number, (root, way) in enumerate(zip(one.roots, one.ways, strict=True), 1):
        size = abs(root)
        swings = root.imag > 0.0
        kind = "oscillates" if swings and root.real <= 0.0 else "grows" if root.real > 0.0 else "decays" if size else (
            "stays")  # fmt: skip
        link = start.system.bodies[int(abs(way).argmax()) // 3].name
        rows.append(SmallMotion(
            number, kind, size / (2.0 * math.pi) if swings else None, -root.real / size if swings else None,
            1.0 / abs(root.real) if root.real else None, link,
        ))  # fmt: skip
    return tuple(rows)


def _refuse(start: "Start") -> None:
    """Say which link is driven on, by what."""
    import numpy as np

    from dynamics_cli.motion.scenes.small import unbalanced

    system = start.system
    forces: Any = unbalanced(system, 0.0, start.q, 0.0 * start.q, np.zeros(system.m))
    jacobian = system.jacobian(0.0, system.frame_of(start.state))
    left = forces - jacobian.T @ np.linalg.lstsq(jacobian.T, forces, rcond=1e-12)[0]
    k = int(np.abs(left).argmax())
    turning = k % 3 == 2
    size = abs(float(left[k])) * (system.torque if turning else system.force)
    acting = (size, Torque if turning else Force)
    require(False, "no equilibrium was found: nothing balances {size} on {name}", size=acting,
            name=system.bodies[k // 3].name, code="no-equilibrium",
            hint="add a spring, a support or a driver that holds it")  # fmt: skip
