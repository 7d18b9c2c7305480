"""The tasks `equilibrium` and `modes`: where bodies in space stand still, and small motions about that."""

import math

from dynamics_cli.errors import require
from dynamics_cli.multibody.bodies.energy import potential
from dynamics_cli.multibody.bodies.records import Scene, Upward
from dynamics_cli.multibody.bodies.results import effort
from dynamics_cli.multibody.bodies.system import System
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Annotated,
    Count,
    FreeNumber,
    Frequency,
    Gravity,
    Length,
    PotentialEnergy,
    Ratio,
    SpacePosition,
    Text,
    Time,
)
from dynamics_cli.records import Advice, Check, Numerics, Quantity, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.multibody.motions.small import Small

BALANCED, SYMMETRIC = 1e-9, 1e-7


@record
class PlaceRow:
    """A joint where everything balances."""

    name: Annotated[Text, "The speed: the body's name, of several with its axis."]
    coordinate: Annotated[FreeNumber | None, "Its coordinate; null in ball joints."]
    motor: Annotated[FreeNumber, "The effort of its motor."]
    spring: Annotated[FreeNumber, "What the spring in it gives."]


@record
class CentreRow:
    """A body there."""

    body: Annotated[Text, "The body."]
    centre: Annotated[SpacePosition, "Its mass centre, in the ground's frame [m]."]


@record
class Equilibrium:
    """Where a scene stands still."""

    stability: Annotated[Text, "Stable, unstable, neutral, or held by its joints."]
    energy: Annotated[PotentialEnergy, "Potential energy there, of weights above the ground's origin, and springs [J]."]
    joints: Annotated[tuple[PlaceRow, ...], "The joints there."]
    bodies: Annotated[tuple[CentreRow, ...], "The mass centres there."]
    frequencies: Annotated[tuple[Frequency, ...], "Frequencies of small oscillations without dampers [Hz]."]
    numerics: Numerics
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


@record
class Part:
    """What a speed has in a mode."""

    mode: Annotated[Count, "The mode, from the slowest [-]."]
    speed: Annotated[Text, "The speed."]
    share: Annotated[Ratio, "Its part, the largest being 1; lengths in sizes of the scene [-]."]


@record
class Mode:
    """A small motion about a place at rest."""

    number: Annotated[Count, "From the slowest [-]."]
    kind: Annotated[Text, "Whether it oscillates, decays, grows, or stays."]
    frequency: Annotated[Frequency | None, "Its natural frequency [Hz]."]
    damping_ratio: Annotated[Ratio | None, "Its damping ratio [-]."]
    time_constant: Annotated[Time | None, "Time in which it grows or decays e times [s]."]
    mostly: Annotated[Text, "The speed that takes most part."]


@record
class Modes:
    """Small motions about a place at rest."""

    slowest: Annotated[Frequency | None, "Lowest frequency [Hz]."]
    fastest: Annotated[Frequency | None, "Highest frequency [Hz]."]
    modes: Annotated[tuple[Mode, ...], "The small motions."]
    shapes: Annotated[tuple[Part, ...], "What each speed has in them."]
    joints: Annotated[tuple[PlaceRow, ...], "The place at rest."]
    numerics: Numerics
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def equilibrium(
    scene: Annotated[Scene, "The bodies, from a file."],
    /,
    *,
    up: Annotated[Upward, "The axis that points up: x, y, z, or none without gravity."] = Upward("z"),  # noqa: B008
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Equilibrium:
    """Where bodies in space stand still under weight, loads, springs and motors, and whether that is stable.

    Equation
    --------
    F_l(q) = 0 for every way that joints and loops leave free; stable where K = −∂F/∂q is positive.

    Raises
    ------
    InadmissibleError
        When nothing balances what acts, by the joint that is driven.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 14.2 and 18.15.
    """
    small, left = _at_rest(scene, up, gravity)
    system = small.system
    stiffness, skew = small.stiffness()
    roots = _roots(small, stiffness, damped=False)
    return Equilibrium(
        stability=_stability(stiffness),
        energy=potential(system),
        joints=_joints(system),
        bodies=tuple(CentreRow(body.name, system.centre(system.link[body.name])) for body in system.bodies),
        frequencies=tuple(root.imag / (2.0 * math.pi) for root, _ in roots if root.imag > 0.0),
        numerics=Numerics("Newton, downhill; stiffness by five-point differences"),
        checks=_checks(left, skew),
        advice=tuple(system.advice),
    )


def modes(
    scene: Annotated[Scene, "The bodies, from a file."],
    /,
    *,
    up: Annotated[Upward, "The axis that points up: x, y, z, or none without gravity."] = Upward("z"),  # noqa: B008
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Modes:
    """Small motions of bodies in space about the place where they stand still: frequencies, damping, shapes.

    Equation
    --------
    (s²·M + s·D + K)·φ = 0, of the ways that joints and loops leave free.

    Raises
    ------
    InadmissibleError
        When nothing balances what acts, or a way has no inertia.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 13.7 and 18.17.
    """
    small, left = _at_rest(scene, up, gravity)
    system = small.system
    stiffness, skew = small.stiffness()
    rows, shapes = [], []
    for number, (root, way) in enumerate(_roots(small, stiffness, damped=True), 1):
        parts = small.free @ way
        largest = parts[int(abs(parts).argmax())]
        parts = [float((part / largest).real) for part in parts]
        size, swings = abs(root), root.imag > 0.0
        kind = "oscillates" if swings and root.real <= 0.0 else "grows" if root.real > 0.0 else (
            "decays" if size else "stays")  # fmt: skip
        mostly = system.names[max(range(len(parts)), key=[abs(part) for part in parts].__getitem__)]
        rows.append(Mode(
            number, kind, size / (2.0 * math.pi) if swings else None, -root.real / size if swings else None,
            1.0 / abs(root.real) if root.real else None, mostly,
        ))  # fmt: skip
        shapes += [Part(number, name, part) for name, part in zip(system.names, parts, strict=True)]
    swinging = [row.frequency for row in rows if row.frequency is not None]
    return Modes(
        slowest=min(swinging, default=None),
        fastest=max(swinging, default=None),
        modes=tuple(rows),
        shapes=tuple(shapes),
        joints=_joints(system),
        numerics=Numerics("stiffness by five-point differences"),
        checks=_checks(left, skew),
        advice=tuple(system.advice),
    )


def _at_rest(scene: Scene, up: Upward, gravity: float) -> "tuple[Small, float]":
    from dynamics_cli.multibody.motions.small import Small

    system = System(scene, up, gravity)
    loops = None
    if scene.loops:
        from dynamics_cli.multibody.bodies.loops import Loops

        loops = Loops(system)
        loops.close()
        loops.require_regular()
        system.begin()
    small = Small(system, loops)
    left = small.rest()
    forces = small.free @ (small.free.T @ small.driving())
    k = int(abs(forces).argmax()) if len(forces) else 0
    require(left <= BALANCED, "no equilibrium was found: {size} drives {name} on", code="no-equilibrium",
            size=_typed(effort(system.turning[k], float(forces[k] / small.scales[k]))), name=system.names[k],
            hint="add a spring, or the effort of a motor that holds it")  # fmt: skip
    return small, left


def _typed(quantity: Quantity) -> "tuple[Any, Any]":
    return quantity.value, quantity.kind


def _joints(system: System) -> "tuple[PlaceRow, ...]":
    rows = []
    springs = system.spring_efforts()
    for k, (name, turns) in enumerate(zip(system.names, system.turning, strict=True)):
        place = system.springs[k].place
        kind: Any = Angle if turns else Length
        coordinate = None if place is None else Quantity(system.coordinates[place], kind)
        rows.append(PlaceRow(name, coordinate, effort(turns, system.efforts[k]), effort(turns, springs[k])))
    return tuple(rows)


def _stability(stiffness: "Any") -> str:
    import numpy as np

    if not len(stiffness):
        return "held by its joints"
    values = np.linalg.eigvalsh(stiffness)
    least = 1e-8 * float(np.abs(values).max()) or 1e-300
    return "unstable" if values[0] < -least else "neutral" if values[0] < least else "stable"


def _roots(small: "Small", stiffness: "Any", *, damped: bool) -> "list[tuple[complex, Any]]":
    """Roots s with their shapes, of each pair the one with a positive imaginary part, the slowest first."""
    import numpy as np

    if not len(stiffness):
        return []
    masses, dampers = small.masses(), small.dampers()
    weak = np.linalg.eigvalsh(masses)
    require(float(weak[0]) > 1e-13 * float(weak[-1]), "a way that is free has no inertia", code="no-inertia",
            hint="give the bodies that move freely mass or a tensor")  # fmt: skip
    if not damped or not dampers.any():
        from scipy.linalg import eigh

        values, ways = eigh(stiffness, masses)
        least = 1e-9 * float(np.abs(values).max()) or 1e-300
        pairs = [(complex(0.0, x**0.5) if x > least else complex((-x) ** 0.5 if x < -least else 0.0), ways[:, k])
                 for k, x in enumerate(map(float, values))]  # fmt: skip
        return sorted(pairs, key=lambda pair: abs(pair[0]))
    count = len(stiffness)
    inverse = np.linalg.inv(masses)
    companion = np.block([[np.zeros((count, count)), np.eye(count)], [-inverse @ stiffness, -inverse @ dampers]])
    values, vectors = np.linalg.eig(companion)
    size = float(np.abs(values).max())
    pairs = [(complex(0.0 if abs(x) < 1e-9 * size else x), vectors[:count, k]) for k, x in enumerate(values)]
    return sorted((pair for pair in pairs if pair[0].imag >= 0.0), key=lambda pair: abs(pair[0]))


def _checks(left: float, skew: float) -> "tuple[Check, ...]":
    return (
        Check("forces balance", left <= BALANCED, left, BALANCED),
        Check("the stiffness is symmetric", skew <= SYMMETRIC, skew, SYMMETRIC),
    )
