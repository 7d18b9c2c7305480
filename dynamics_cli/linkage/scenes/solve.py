"""A linkage from a scene: every assembly, and position, velocity and acceleration of the chosen one, with proof."""

from dynamics_cli.errors import require
from dynamics_cli.linkage.scenes.following import Followed, followed
from dynamics_cli.linkage.scenes.records import GROUND, Scene
from dynamics_cli.quantities import (
    Angle,
    AngularAcceleration,
    Annotated,
    Count,
    PartAcceleration,
    PartPoint,
    PartVelocity,
    Ratio,
    Size,
    Text,
    TurnRate,
)
from dynamics_cli.records import Advice, Check, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.linkage.scenes.dyads import Assembly
    from dynamics_cli.linkage.scenes.system import System

# Below this the smallest singular value over the largest means a pose that can move without its drivers.
SINGULAR = 1e-9
LISTED = 8
CLOSES = 1e-12


@record
class LinkMotion:
    """One link."""

    name: Annotated[Text, "The link."]
    angle: Annotated[Angle, "Angle of its own axes [rad]."]
    speed: Annotated[TurnRate | None, "Angular velocity [rad/s]."]
    acceleration: Annotated[AngularAcceleration | None, "Angular acceleration [rad/s^2]."]


@record
class PinMotion:
    """One pin."""

    name: Annotated[Text, "The pin."]
    position: Annotated[PartPoint, "Where it is [m]."]
    velocity: Annotated[PartVelocity | None, "Its velocity [m/s]."]
    acceleration: Annotated[PartAcceleration | None, "Its acceleration [m/s^2]."]


@record
class AssemblyPin:
    """Where one pin is in one assembly."""

    number: Annotated[Count, "The assembly."]
    sides: Annotated[Text, "Its sides, as a scene states them."]
    pin: Annotated[Text, "The pin."]
    position: Annotated[PartPoint, "Where it is [m]."]


@record
class Solution:
    """The linkage in one pose."""

    links: Annotated[tuple[LinkMotion, ...], "The moving links."]
    pins: Annotated[tuple[PinMotion, ...], "The pins."]
    assembly: Annotated[Text, "The assembly solved."]
    assemblies: Annotated[Count, "Number of assemblies at this position of the drivers."]
    solved_by: Annotated[Text, "Method of the solution."]
    pin_error: Annotated[Size | None, "All pins together are within this of the true ones, as proved [m]."] = None
    nearest_other: Annotated[
        Size | None, "No other assembly is nearer than this, all pins together, as proved [m]."
    ] = None
    kantorovich: Annotated[Ratio | None, "Kantorovich's h: at most one half proves the pose."] = None
    motion: Annotated[tuple[Followed, ...] | None, "The link or pin followed over a turn of the first driver."] = None
    every_assembly: Annotated[tuple[AssemblyPin, ...] | None, "All assemblies, if requested."] = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def solve(
    scene: Annotated[Scene, "The linkage, from a file."],
    /,
    *,
    assemblies: Annotated[bool, "List every assembly."] = False,
    follow: Annotated[Text, "A link or pin to follow over a turn of the first driver, e.g. six."] = "",
    steps: Annotated[Count, "Steps of that turn."] = 24,
) -> Solution:
    """Position, velocity and acceleration of a planar linkage from a scene of links, pins, slides and drivers.

    Equation
    --------
    Φ(q) = 0: lengths ½(|P − Q|² − L²), slides (R − P)×(Q − P), drivers; J·q̇ = −Φ_t, J·q̈ = −q̇·H·q̇ − …; Kantorovich
    h = ‖J⁻¹‖·√Σ‖H‖²·‖J⁻¹Φ‖ ≤ ½ proves one solution within 2η/(1 + √(1 − 2h)).

    Returns
    -------
    Solution
        Links and pins, and the certificate of the pose.

    Raises
    ------
    InadmissibleError
        When names do not fit, a length is zero, drivers are too few or too many, the links cannot be joined at this
        position of the drivers (the gap), or several assemblies are possible and the scene does not say which.

    Notes
    -----
    Dyads (two links and a pin or slide between what is placed) are solved in closed form, others by Newton's method
    from 240 starts: their list of assemblies may be incomplete, and the scene selects one by `near`.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 5.2 and 5.6; Ortega & Rheinboldt,
    Iterative Solution of Nonlinear Equations in Several Variables, 1970, section 12.6.
    """
    from dynamics_cli.linkage.scenes.system import System

    system = System(scene)
    require_driven(system)
    possible, newton = assembled(system)
    choice = chosen(system, possible, assemblies)
    motion = followed(scene, follow, steps, solve) if follow else None
    return solution(system, choice, possible, newton, assemblies, motion)


def require_driven(system: "System") -> None:
    """Refuse scenes with too few drivers for their pins."""
    missing = system.size - len(system.rows)
    require(
        missing <= 0,
        "the linkage still has {count} degrees of freedom with its drivers held: give {count} more drivers",
        count=missing,
        code="under-driven",
        hint="add [[drivers]], or links and pins that are missing",
    )


def assembled(system: "System") -> "tuple[list[Assembly], bool]":
    """All assemblies, and whether Newton's method was needed; a refusal with the gap where there is none."""
    from dynamics_cli.linkage.scenes.dyads import Assembler

    walk = Assembler(system)
    possible = walk.all()
    surplus = len(system.rows) - system.size
    gap, what = walk.gap
    require(
        bool(possible) or gap != float("inf"),
        "the linkage cannot be placed: its links depend on each other in a way that leaves no solution",
        code="no-assembly",
    )
    require(
        bool(possible),
        "the linkage cannot be closed at this position of its drivers: {what} miss by {gap}"
        + (", with {surplus} more conditions than it can keep" if surplus > 0 else ""),
        what=what,
        gap=(gap * system.scale, Size),
        surplus=surplus,
        code="cannot-be-closed",
        hint="change a length by that much there, or move the driver",
    )
    return possible, walk.newton


def chosen(system: "System", possible: "list[Assembly]", listed: bool) -> "Assembly":
    """The assembly chosen by the scene; a refusal with the list if it does not choose."""
    wanted = {side.pin: str(side.side) for side in system.scene.sides}
    decided = {pin for one in possible for pin, _ in one.words}
    for pin in wanted:
        require(
            pin in decided or pin in system.place or pin in system.shapes,
            "sides name {pin}, which the scene does not have",
            pin=repr(pin),
            code="side",
        )
    fits = [one for one in possible if all(wanted.get(pin, word) == word for pin, word in one.words)]
    require(
        bool(fits),
        "no assembly has those sides; there is: {list}",
        list="; ".join(one.text for one in possible[:LISTED]),
        code="no-assembly",
    )
    near = {one.pin: complex(*one.at) / system.scale for one in system.scene.near}
    if near and len(fits) > 1:
        fits = [min(fits, key=lambda one: sum(abs(one.at[pin] - at) for pin, at in near.items() if pin in one.at))]
    named = all(one.words for one in fits) and len({one.words for one in fits}) == len(fits)
    require(
        len(fits) == 1 or listed,
        "{count} assemblies are possible and the scene does not say which: {list}",
        count=len(fits),
        list="; ".join(one.text for one in fits[:LISTED]) if named else "see --assemblies",
        code="which-assembly",
        hint="add [[sides]] with pin and side to the scene, or [[near]] with a pin and roughly where it is",
    )
    return fits[0]


def solution(
    system: "System",
    choice: "Assembly",
    possible: "list[Assembly]",
    newton: bool,
    listed: bool,
    motion: "tuple[Followed, ...] | None",
) -> Solution:
    """The record of one assembly."""
    import numpy as np

    from dynamics_cli.linkage.scenes.dyads import refined
    from dynamics_cli.linkage.scenes.system import Certificate

    q = refined(system, system.vector(choice.at))[0]
    jacobian = system.jacobian(q)
    values = np.linalg.svd(jacobian, compute_uv=False)
    free = bool(values.min(initial=1.0) <= SINGULAR * values.max(initial=1.0)) or len(values) < system.size
    proof = None if free or len(system.rows) != system.size else Certificate(system, q, jacobian)
    sure = proof if proof and proof.proved else None
    velocity, acceleration = (None, None) if free else system.rates(q, jacobian)
    moving, bending, at = _spread(system, velocity), _spread(system, acceleration), system.positions(q)
    gap = float(np.abs(system.residuals(q)).max(initial=0.0))
    return Solution(
        links=tuple(
            _link(shape, at, moving, bending, system.scene.drivers)
            for shape in system.shapes.values()
            if shape.name != GROUND
        ),
        pins=tuple(PinMotion(pin, *(_pair(part, pin, system.scale) for part in (at, moving, bending))) for pin in at),
        assembly=choice.text,
        assemblies=len(possible),
        solved_by=_method(choice.dyads, newton),
        pin_error=sure.error if sure else None,
        nearest_other=sure.apart if sure else None,
        kantorovich=proof.share if proof else None,
        motion=motion,
        every_assembly=_listed(system, possible) if listed else None,
        checks=(
            Check("links keep their lengths", gap <= CLOSES, gap, CLOSES),
            *((Check("the pose is proved (Kantorovich)", proof.proved, proof.share, 0.5),) if proof else ()),
        ),
        advice=_singular() if free else (),
        numerics=Numerics("dyads in closed form, then Newton's method with Kantorovich's certificate"),
    )


def _singular() -> "tuple[Advice, ...]":
    return (
        Advice(
            "singular",
            "at this pose the linkage can move with its drivers held (a toggle or change point): velocities are "
            "not determined",
            severity="serious",
            remedy="move the driver a little",
        ),
    )


def _method(dyads: int, newton: bool) -> str:
    words = f"{dyads} dyad{'' if dyads == 1 else 's'} in closed form"
    return f"{words}, the rest by Newton" if newton else words


def _spread(system: "System", vector: "Any") -> "dict[str, complex] | None":
    """Rates of every pin; fixed ones have none."""
    if vector is None:
        return None
    half = len(system.unknown)
    return dict.fromkeys(system.known, 0j) | {
        pin: complex(vector[i], vector[half + i]) for pin, i in system.place.items()
    }


def _link(shape: "Any", at: "Any", moving: "Any", bending: "Any", drivers: "Any") -> LinkMotion:
    from cmath import phase

    base = at[shape.last] - at[shape.first]
    square = abs(base) ** 2
    angle = phase(base / shape.base) + 0.0
    if moving is None or bending is None:
        return LinkMotion(shape.name, angle, None, None)
    for driver in drivers:
        if driver.link == shape.name and driver.against == GROUND:
            # given sides are reported as given
            return LinkMotion(shape.name, angle, driver.speed, driver.angular_acceleration)
    turn = (base.conjugate() * (moving[shape.last] - moving[shape.first])).imag / square
    bend = (base.conjugate() * (bending[shape.last] - bending[shape.first])).imag / square
    return LinkMotion(shape.name, angle, turn, bend)


def _pair(values: "Any", pin: str, scale: float) -> "Any":
    return None if values is None else (float(values[pin].real) * scale, float(values[pin].imag) * scale)


def _listed(system: "System", possible: "list[Assembly]") -> "tuple[AssemblyPin, ...]":
    return tuple(
        AssemblyPin(number, one.text, pin, _pair(one.at, pin, system.scale))
        for number, one in enumerate(possible, 1)
        for pin in system.unknown
    )
