"""The task `equilibrium`: reactions of named supports, or why there are none."""

from dynamics_cli.errors import require, worded
from dynamics_cli.force import ratios
from dynamics_cli.force.balance import Balance, described
from dynamics_cli.force.supports import ALONG_ONE_LINE, Read, Support, lie_in_a_plane
from dynamics_cli.force.system import Couple, Load, System
from dynamics_cli.numerics.elementary import atan2
from dynamics_cli.numerics.exact.rational import nearest
from dynamics_cli.quantities import Angle, Annotated, Force, ForceVector, Length, Position, Ratio, Text, TorqueVector
from dynamics_cli.records import Advice, Check, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from dynamics_cli.force.ratios import Ratios

METHOD = "exact elimination in the numbers as typed, rounded once"
NEARLY = 1e-6
EXAMPLE = '--support "type=pin, at=0, 0 m" --support "type=roller, at=5, 0 m"'


@record
class Reaction:
    """What one support does to the body."""

    name: Annotated[Text, "The support."]
    type: Annotated[Text, "What it is."]
    force: Annotated[ForceVector, "Its force on the body [N]."]
    size: Annotated[Force, "The size of the force [N]."]
    angle: Annotated[Angle | None, "Its angle from x, in the plane [rad]."]
    moment: Annotated[TorqueVector | None, "Its couple on the body [N·m]."]
    sense: Annotated[Text | None, "Tension or compression; whether it pushes or pulls."]
    at: Annotated[Position, "Where it holds [m]."]


@record
class Equilibrium:
    """Reactions of the supports of one rigid body."""

    verdict: Annotated[Text, "Determinate, or held for these loads alone."]
    reactions: Annotated[tuple[Reaction, ...], "The reactions, on the body."]
    load: Annotated[ForceVector, "Sum of the forces given [N]."]
    margin: Annotated[Length | None, "Supports moved by about this may no longer hold the body [m]."]
    numerics: Numerics
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def equilibrium(
    *,
    loads: Annotated[Load | tuple[Load, ...] | None, "Forces at points; one may be given by its plain fields."] = None,
    couples: Annotated[Couple | tuple[Couple, ...] | None, "Couples, in the plane one number, in space three."] = None,
    supports: Annotated[tuple[Support, ...], "What holds the body."],
) -> Equilibrium:
    """Reactions of the supports of a rigid body under forces and couples.

    Equation
    --------
    Σ F = 0, Σ M = 0: in the plane three equations, in space six.

    Returns
    -------
    Equilibrium
        The reactions on the body, whether cables and contacts can bear them, and how near the supports are to failing.

    Raises
    ------
    InadmissibleError
        When the supports leave a motion free that the loads drive, or there are more unknowns than equilibrium tells.

    Notes
    -----
    Whether the body is held is decided on the decimals as typed. A roller or smooth surface pushes along its direction,
    a cable pulls along its direction, a link is in tension where it pulls along its direction.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 6.5.

    Examples
    --------
    >>> supports = Support("pin", (0.0, 0.0, 0.0)), Support("roller", (5.0, 0.0, 0.0))
    >>> made = equilibrium(loads=Load((0.0, -1000.0, 0.0), (2.0, 0.0, 0.0)), supports=supports)
    >>> [reaction.force[1] for reaction in made.reactions]
    [600.0, 400.0]
    """
    system = System(loads, couples, needed=False)
    require(len(supports) > 0, "no support is given", code="missing", hint=f"such as {EXAMPLE}")
    planar = system.planar and lie_in_a_plane(supports)
    held = [Read(one, index, planar=planar) for index, one in enumerate(supports)]
    balance = Balance([u for one in held for u in one.unknowns], system.force, system.moment, planar=planar)
    _require_an_answer(balance, planar=planar)
    assert balance.values is not None
    parts = [ratios.times(value, unknown.way) for value, unknown in zip(balance.values, balance.unknowns, strict=True)]
    reactions = [_reaction(one, index, balance, parts, planar=planar) for index, one in enumerate(held)]
    spread = _spread([one.at for one in held] + system.points)
    stretch = balance.smallest_stretch(spread)
    free = bool(balance.motions)
    return Equilibrium(
        verdict="held for these loads alone" if free else "statically determinate",
        reactions=tuple(reactions),
        load=ratios.rounded(system.force),
        margin=None if free else stretch * spread,
        numerics=Numerics(METHOD),
        checks=(_put_back(system, balance),),
        advice=(*_on_loads(system), *_on_supports(balance, stretch, spread, planar=planar), *_on_senses(held, balance)),
    )


def _require_an_answer(balance: Balance, *, planar: bool) -> None:
    """Refuse mechanisms, improper and indeterminate supports."""
    count, equations = len(balance.unknowns), balance.equations
    motion = described(balance.motions[0], planar=planar) if balance.motions else ""
    require(
        balance.consistent,
        "{why}: {motion}",
        why="a mechanism" if count < equations else "improper supports, whose reactions leave a motion free",
        motion=motion,
        code="mechanism",
        hint="add a support against this motion" if count < equations else "turn or move a support to stop this motion",
    )
    excess = balance.excess
    require(
        excess == 0,
        "statically indeterminate: {excess} more unknown{s} than equilibrium tells{free}",
        excess=str(excess),
        s="" if excess == 1 else "s",
        free=f", and yet {motion}" if motion else "",
        code="indeterminate",
        hint=f"take away {excess} of {count} unknowns, or find them from stiffnesses",
    )


def _reaction(one: Read, index: int, balance: Balance, parts: "Sequence[Ratios]", *, planar: bool) -> Reaction:
    mine = [(unknown, part) for unknown, part in zip(balance.unknowns, parts, strict=True) if unknown.support == index]
    force = ratios.plus(*(part for unknown, part in mine if not unknown.couple))
    couples = [part for unknown, part in mine if unknown.couple]
    x, y, _ = level = ratios.rounded(force)
    size = ratios.size(force)
    return Reaction(
        name=one.name,
        type=one.type,
        force=level,
        size=size,
        angle=atan2(y, x) if planar and size else None,
        moment=ratios.rounded(ratios.plus(*couples)) if couples else None,
        sense=_sense(one, force),
        at=ratios.rounded(one.at),
    )


def _sense(one: Read, force: "Ratios") -> "str | None":
    if one.type not in ALONG_ONE_LINE or one.way is None:
        return None
    along = ratios.dot(force, one.way)[0]
    if along == 0:
        return "no force"
    if one.type in ("link", "cable"):
        return "tension" if along > 0 else "compression"
    return "pushes" if along > 0 else "pulls"


def _on_loads(system: System) -> "tuple[Advice, ...]":
    if system.forces or system.couples:
        return ()
    message = worded("no force and no couple is given: there is nothing to hold")
    return (Advice("no-load", message, remedy='add such as --load "force=0, -500 N, at=2, 0 m"'),)


def _on_senses(held: "Sequence[Read]", balance: Balance) -> "list[Advice]":
    """Cables that push and contacts that pull."""
    said = []
    assert balance.values is not None
    for value, unknown in zip(balance.values, balance.unknowns, strict=True):
        one = held[unknown.support]
        if value[0] >= 0 or one.type not in ("cable", "smooth", "roller"):
            continue
        pull = nearest(value) * -ratios.size(unknown.way)
        if one.type == "cable":
            message = worded(
                "cable {name} would be in compression, {pull}: it goes slack", name=one.name, pull=(pull, Force)
            )
            said.append(Advice("slack", message, severity="serious", remedy="solve again without this cable"))
        else:
            message = worded("{type} {name} would pull, {pull}: it lifts off unless it is held down",
                             type=one.type, name=one.name, pull=(pull, Force))  # fmt: skip
            said.append(
                Advice(
                    "lifts-off",
                    message,
                    severity="serious" if one.type == "smooth" else "caution",
                    remedy="solve again without this support",
                )
            )
    return said


def _on_supports(balance: Balance, stretch: float, spread: float, *, planar: bool) -> "list[Advice]":
    if balance.motions:
        motion = described(balance.motions[0], planar=planar)
        message = worded("the body is a mechanism that these loads leave at rest: {motion}", motion=motion)
        return [Advice("partial", message, remedy="add a support against this motion")]
    if stretch > NEARLY:
        return []
    message = worded(
        "nearly improper supports: moved by about {margin} they leave a motion free; condition about {condition:2}",
        margin=(stretch * spread, Length), condition=(1.0 / stretch, Ratio),
    )  # fmt: skip
    return [Advice("nearly-improper", message, remedy="turn or move a support")]


def _spread(points: "Sequence[Ratios]") -> float:
    """The largest distance of a point from the first; one where there is none."""
    return max(ratios.size(ratios.minus(point, points[0])) for point in points) or 1.0


def _put_back(system: System, balance: Balance) -> Check:
    """With the reactions, force and moment are zero."""
    assert balance.values is not None
    force, moment = system.force, system.moment
    for value, unknown in zip(balance.values, balance.unknowns, strict=True):
        force = ratios.plus(force, ratios.times(value, unknown.force))
        moment = ratios.plus(moment, ratios.times(value, unknown.turning))
    off = ratios.size(force) + ratios.size(moment)
    return Check("reactions put back give zero", off == 0.0, off, 0.0)
