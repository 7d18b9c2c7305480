"""A linkage from a scene: every assembly, and position, velocity and acceleration of the chosen one, with proof."""

from dynamics_cli.linkage.scenes.following import Followed, followed
from dynamics_cli.linkage.scenes.pose import LinkMotion, PinMotion, is_free, pair, posed
from dynamics_cli.numerics.linkages.records import Scene
from dynamics_cli.quantities import Angle, Annotated, Coordinate, Count, PartPoint, Ratio, Size, Text
from dynamics_cli.records import Advice, Check, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.numerics.linkages.dyads import Assembly
    from dynamics_cli.numerics.linkages.system import System

CLOSES = 1e-12


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

    links: Annotated[tuple[LinkMotion, ...] | None, "The links that move; left out where a motion is followed."]
    pins: Annotated[tuple[PinMotion, ...] | None, "The pins; left out where a motion is followed."]
    assembly: Annotated[Text, "The assembly solved."]
    assemblies: Annotated[Count, "Number of assemblies at this position of the drivers."]
    solved_by: Annotated[Text, "Method of the solution."]
    pin_error: Annotated[Size | None, "All pins together are within this of the true ones, as proved [m]."] = None
    nearest_other: Annotated[Size | None, "No other assembly is nearer, as proved [m]."] = None
    kantorovich: Annotated[Ratio | None, "Kantorovich's h: at most one half proves the pose."] = None
    driver_from: Annotated[Angle | None, "Where the range of a driver that turns begins [rad]."] = None
    driver_to: Annotated[Angle | None, "Where it ends [rad]."] = None
    followed_by: Annotated[Text | None, "How the poses of the motion are joined to each other."] = None
    motion: Annotated[tuple[Followed, ...] | None, "What was followed over the first driver's range."] = None
    every_assembly: Annotated[tuple[AssemblyPin, ...] | None, "All assemblies, if requested."] = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def solve(
    scene: Annotated[Scene, "The linkage, from a file."],
    /,
    *,
    assemblies: Annotated[bool, "List every assembly."] = False,
    follow: Annotated[Text, "A link or pin to follow over the first driver's range, e.g. six."] = "",
    steps: Annotated[Count, "Steps of that range."] = 24,
    turn: Annotated[Angle | None, "How far the driver turns, e.g. -90 deg; else to its limits."] = None,
    travel: Annotated[Coordinate | None, "How far a pushed pin goes from its position on, e.g. 80 mm."] = None,
) -> Solution:
    """Position, velocity and acceleration of a planar linkage from a scene of links, pins, slides and drivers.

    Equation
    --------
    Φ(q) = 0: lengths ½(|P − Q|² − L²), slides (R − P)×(Q − P), drivers; J·q̇ = −Φ_t, J·q̈ = −q̇·H·q̇ − …; Kantorovich
    h = ‖J⁻¹‖·√Σ‖H‖²·‖J⁻¹Φ‖ ≤ ½ proves one solution within 2η/(1 + √(1 − 2h)).

    Raises
    ------
    InadmissibleError
        When names do not fit, a length is zero, drivers are too few or too many, the links cannot be joined at this
        position of the drivers (the gap), or several assemblies are possible and the scene does not say which.

    Notes
    -----
    Dyads (two links and a pin or slide between what is placed) are solved in closed form, others by Newton's method
    from 240 starts: their list of assemblies may be incomplete, and the scene selects one by `near`.

    A motion is followed from pose to pose, in steps on which Newton moves little from the prediction and the
    determinant of the Jacobian keeps its sign, so that the linkage cannot change its assembly unnoticed.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 5.2 and 5.6; Ortega & Rheinboldt,
    Iterative Solution of Nonlinear Equations in Several Variables, 1970, section 12.6.
    """
    from dynamics_cli.numerics.linkages.assemblies import assembled, chosen, require_driven
    from dynamics_cli.numerics.linkages.system import System

    system = System(scene)
    require_driven(system)
    possible, newton = assembled(system)
    choice = chosen(system, possible, assemblies)
    return solution(system, choice, possible, newton, assemblies, (follow, steps, turn, travel))


def solution(
    system: "System",
    choice: "Assembly",
    possible: "list[Assembly]",
    newton: bool,
    listed: bool,
    wanted: "tuple[str, int, float | None, float | None]",
) -> Solution:
    """The record of one assembly, followed over its driver's range where a name is wanted."""
    import numpy as np

    from dynamics_cli.numerics.linkages.dyads import refined
    from dynamics_cli.numerics.linkages.system import Certificate

    q = refined(system, system.vector(choice.at))[0]
    jacobian = system.jacobian(q)
    free = is_free(system, jacobian)
    proof = None if free or len(system.rows) != system.size else Certificate(system, q, jacobian)
    sure = proof if proof and proof.proved else None
    links, pins = posed(system, q, jacobian, free)
    motion = followed(system, q, *wanted) if wanted[0] else {}
    advice = (_singular() if free else ()) + motion.pop("advice", ())
    gap = float(np.abs(system.residuals(q)).max(initial=0.0))
    return Solution(
        links=None if motion else links,
        pins=None if motion else pins,
        assembly=choice.text,
        assemblies=len(possible),
        solved_by=f"{choice.dyads} dyad{'s' * (choice.dyads != 1)} in closed form{', the rest by Newton' * newton}",
        pin_error=sure.error if sure else None,
        nearest_other=sure.apart if sure else None,
        kantorovich=proof.share if proof else None,
        **motion,
        every_assembly=_listed(system, possible) if listed else None,
        checks=(
            Check("links keep their lengths", gap <= CLOSES, gap, CLOSES),
            *((Check("the pose is proved (Kantorovich)", proof.proved, proof.share, 0.5),) if proof else ()),
        ),
        advice=advice,
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


def _listed(system: "System", possible: "list[Assembly]") -> "tuple[AssemblyPin, ...]":
    return tuple(
        AssemblyPin(number, a.text, pin, pair(a.at, pin, system.scale))
        for number, a in enumerate(possible, 1)
        for pin in system.unknown
    )
