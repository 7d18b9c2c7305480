"""The task `equilibrium`: reactions of supports, or why they cannot be determined."""

from dynamics_cli.errors import require, worded
from dynamics_cli.force import ratios
from dynamics_cli.force.balance import Balance, described
from dynamics_cli.force.supports import ALONG_ONE_LINE, ExactSupport, Support, lie_in_a_plane
from dynamics_cli.force.system import Couple, Distributed, Load, System
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
    """The reaction of one support on the body."""

    name: Annotated[Text, "The support."]
    type: Annotated[Text, "Its type."]
    force: Annotated[ForceVector, "Its force on the body [N]."]
    size: Annotated[Force, "The size of the force [N]."]
    angle: Annotated[Angle | None, "Its angle from x, in the plane [rad]."]
    moment: Annotated[TorqueVector | None, "Its couple on the body [N·m]."]
    sense: Annotated[Text | None, "Tension or compression; whether it pushes or pulls."]
    at: Annotated[Position, "Where it acts [m]."]


@record
class Equilibrium:
    """Reactions of the supports of one rigid body."""

    verdict: Annotated[Text, "Statically determinate, or held under these loads only."]
    reactions: Annotated[tuple[Reaction, ...], "The reactions, on the body."]
    largest: Annotated[Force, "Size of the largest reaction [N]."]
    load: Annotated[ForceVector, "Sum of the forces given [N]."]
    margin: Annotated[Length | None, "Displacement of a support, about, that could leave a motion free [m]."]
    numerics: Numerics
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def equilibrium(
    *,
    loads: Annotated[Load | tuple[Load, ...] | None, "Forces at points; one may be given by its plain fields."] = None,
    couples: Annotated[Couple | tuple[Couple, ...] | None, "Couples, in the plane one number, in space three."] = None,
    distributed_loads: Annotated[tuple[Distributed, ...] | None, "Loads spread along lines."] = None,
    supports: Annotated[tuple[Support, ...], "What holds the body."],
) -> Equilibrium:
    """Reactions of the supports of a rigid body under forces and couples.

    Equation
    --------
    Σ F = 0, Σ M = 0: in the plane three equations, in space six.

    Returns
    -------
    Equilibrium
        The reactions, whether cables and contacts can carry them, and how close the supports are to failing.

    Raises
    ------
    InadmissibleError
        When the loads drive a motion that the supports leave free, or equilibrium does not determine all unknowns.

    Notes
    -----
    Whether the body is held is decided with the decimals as typed. A roller or a smooth surface pushes along its
    direction, a cable pulls along it, a link that pulls along it is in tension.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 6.5.

    Examples
    --------
    >>> supports = Support("pin", (0.0, 0.0, 0.0)), Support("roller", (5.0, 0.0, 0.0))
    >>> answer = equilibrium(loads=Load((0.0, -1000.0, 0.0), (2.0, 0.0, 0.0)), supports=supports)
    >>> [reaction.force[1] for reaction in answer.reactions]
    [600.0, 400.0]
    """
    system = System(loads, couples, distributed_loads, needed=False)
    require(len(supports) > 0, "no support is given", code="missing", hint=f"for example {EXAMPLE}")
    planar = system.planar and lie_in_a_plane(supports)
    exact = [ExactSupport(support, index, planar=planar) for index, support in enumerate(supports)]
    balance = Balance([u for support in exact for u in support.unknowns], system.force, system.moment, planar=planar)
    _require_solution(balance, planar=planar)
    assert balance.values is not None
    vectors = [
        ratios.times(value, unknown.axis) for value, unknown in zip(balance.values, balance.unknowns, strict=True)
    ]
    reactions = [_reaction(support, index, balance, vectors, planar=planar) for index, support in enumerate(exact)]
    spread = _spread([support.at for support in exact] + system.points)
    singular_value = balance.least_singular_value(spread)
    free = bool(balance.motions)
    return Equilibrium(
        verdict="held for these loads alone" if free else "statically determinate",
        reactions=tuple(reactions),
        largest=max(reaction.size for reaction in reactions),
        load=ratios.rounded(system.force),
        margin=None if free else singular_value * spread,
        numerics=Numerics(METHOD),
        checks=(_put_back(system, balance),),
        advice=(
            *_on_loads(system),
            *_on_supports(balance, singular_value, spread, planar=planar),
            *_on_senses(exact, balance),
        ),
    )


def _require_solution(balance: Balance, *, planar: bool) -> None:
    """Refuse mechanisms, improper supports and indeterminate ones."""
    count, equations = len(balance.unknowns), balance.equations
    motion = described(balance.motions[0], planar=planar) if balance.motions else ""
    require(
        balance.consistent,
        "{why}: {motion}",
        why="a mechanism" if count < equations else "improper supports, which leave a motion free",
        motion=motion,
        code="mechanism",
        hint="add a support against this motion" if count < equations else "turn or move a support to stop this motion",
    )
    excess = balance.excess
    require(
        excess == 0,
        "statically indeterminate: {excess} more unknown{s} than equilibrium determines{free}",
        excess=str(excess),
        s="" if excess == 1 else "s",
        free=f", and still {motion}" if motion else "",
        code="indeterminate",
        hint=f"remove {excess} of {count} unknowns, or calculate them from stiffnesses",
    )


def _reaction(
    support: ExactSupport, index: int, balance: Balance, vectors: "Sequence[Ratios]", *, planar: bool
) -> Reaction:
    pairs = [(u, vector) for u, vector in zip(balance.unknowns, vectors, strict=True) if u.support == index]
    force = ratios.plus(*(vector for unknown, vector in pairs if not unknown.couple))
    couples = [vector for unknown, vector in pairs if unknown.couple]
    x, y, _ = components = ratios.rounded(force)
    size = ratios.size(force)
    return Reaction(
        name=support.name,
        type=support.type,
        force=components,
        size=size,
        angle=atan2(y, x) if planar and size else None,
        moment=ratios.rounded(ratios.plus(*couples)) if couples else None,
        sense=_sense(support, force),
        at=ratios.rounded(support.at),
    )


def _sense(support: ExactSupport, force: "Ratios") -> "str | None":
    if support.type not in ALONG_ONE_LINE or support.direction is None:
        return None
    along = ratios.dot(force, support.direction)[0]
    if along == 0:
        return "no force"
    if support.type in ("link", "cable"):
        return "tension" if along > 0 else "compression"
    return "pushes" if along > 0 else "pulls"


def _on_loads(system: System) -> "tuple[Advice, ...]":
    if system.forces or system.couples:
        return ()
    message = worded("there is no force and no couple: all reactions are zero")
    return (Advice("no-load", message, remedy='add for example --load "force=0, -500 N, at=2, 0 m"'),)


def _on_senses(supports: "Sequence[ExactSupport]", balance: Balance) -> "list[Advice]":
    """Advice on cables that push and contacts that pull."""
    advice = []
    assert balance.values is not None
    for value, unknown in zip(balance.values, balance.unknowns, strict=True):
        support = supports[unknown.support]
        if value[0] >= 0 or support.type not in ("cable", "smooth", "roller"):
            continue
        pull = nearest(value) * -ratios.size(unknown.axis)
        if support.type == "cable":
            message = worded(
                "cable {name} would be in compression, {pull}: it goes slack", name=support.name, pull=(pull, Force)
            )
            advice.append(Advice("slack", message, severity="serious", remedy="solve again without this cable"))
        else:
            message = worded("{type} {name} would pull, {pull}: it lifts off unless it is held down",
                             type=support.type, name=support.name, pull=(pull, Force))  # fmt: skip
            advice.append(
                Advice(
                    "lifts-off",
                    message,
                    severity="serious" if support.type == "smooth" else "caution",
                    remedy="solve again without this support",
                )
            )
    return advice


def _on_supports(balance: Balance, singular_value: float, spread: float, *, planar: bool) -> "list[Advice]":
    if balance.motions:
        motion = described(balance.motions[0], planar=planar)
        message = worded("the supports leave a motion free, which these loads do not drive: {motion}", motion=motion)
        return [Advice("partial", message, remedy="add a support against this motion")]
    if singular_value > NEARLY:
        return []
    message = worded(
        "nearly improper supports: moved by about {margin:2} they leave a motion free; condition about {condition:2}",
        margin=(singular_value * spread, Length), condition=(1.0 / singular_value, Ratio),
    )  # fmt: skip
    return [Advice("nearly-improper", message, remedy="turn or move a support")]


def _spread(points: "Sequence[Ratios]") -> float:
    """The largest distance of a point from the first; 1 m where all are one point."""
    return max(ratios.size(ratios.minus(point, points[0])) for point in points) or 1.0


def _put_back(system: System, balance: Balance) -> Check:
    """Check that force and moment are zero with the reactions."""
    assert balance.values is not None
    force, moment = system.force, system.moment
    for value, unknown in zip(balance.values, balance.unknowns, strict=True):
        force = ratios.plus(force, ratios.times(value, unknown.force))
        moment = ratios.plus(moment, ratios.times(value, unknown.moment))
    residual = ratios.size(force) + ratios.size(moment)
    return Check("reactions put back give zero", residual == 0.0, residual, 0.0)
