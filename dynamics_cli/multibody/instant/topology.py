"""The task `topology`: the lower body array of a tree, its powers, and what follows from them."""

from dynamics_cli.errors import UsageError, require
from dynamics_cli.multibody.bodies.ordering import ordered
from dynamics_cli.multibody.bodies.records import GROUND, Body, Scene
from dynamics_cli.multibody.bodies.system import COUNTS
from dynamics_cli.quantities import Annotated, Count, Text
from dynamics_cli.records import Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence


@record
class BodyRow:
    """A body of the tree."""

    number: Annotated[Count, "Its number, above that of the body that carries it [-]."]
    name: Annotated[Text, "Its name."]
    lower: Annotated[Count, "L(K): number of the adjacent lower body, 0 for the ground [-]."]
    carried_by: Annotated[Text, "The name of that body."]
    sort: Annotated[Text, "End body, branching body, or inner body."]
    joint: Annotated[Text, "The joint towards the ground."]
    speeds: Annotated[Count, "Speeds of that joint [-]."]
    path: Annotated[Text, "Numbers of the bodies from it down to the ground."]


@record
class Power:
    """A power of the lower body array."""

    power: Annotated[Count, "j of Lʲ [-]."]
    array: Annotated[Text, "Lʲ(K) of every body, in the order of K."]


@record
class Topology:
    """How the bodies of a tree hang together."""

    bodies: Annotated[Count, "Number of bodies [-]."]
    freedoms: Annotated[Count, "Degrees of freedom of the tree: speeds of all its joints [-]."]
    loops: Annotated[Count | None, "Loops closed by further joints [-]."]
    constraints: Annotated[Count | None, "Conditions of those, redundant ones among them [-]."]
    least_freedoms: Annotated[
        Count | None, "Degrees of freedom left if all of them count; redundant ones leave more [-]."
    ]
    ends: Annotated[Text, "End bodies, which carry nothing."]
    branching: Annotated[Text, "Bodies that carry more than one."]
    depth: Annotated[Count, "Bodies on the longest path to the ground [-]."]
    tree: Annotated[tuple[BodyRow, ...], "The bodies by number."]
    powers: Annotated[tuple[Power, ...], "The lower body array and its powers."]
    typed: Annotated[Text | None, "Where each body stood as typed, if that is another order."]
    numerics: Numerics


def topology(
    scene: Annotated[Scene, "The bodies, from a file or by --body."],
    /,
    *,
    lower_bodies: Annotated[
        tuple[Count, ...], "Or the lower body array L(K) alone, bodies numbered from 1, 0 the ground, e.g. 0, 1, 1, 3."
    ] = (),
) -> Topology:
    """Lower body array of a multibody system, its powers, paths, branching and end bodies, degrees of freedom.

    Equation
    --------
    L⁰(K) = K, Lʲ = L(Lʲ⁻¹), until all are 0; end bodies are not in L, branching bodies more than once.

    Raises
    ------
    InadmissibleError
        When there are no bodies. UsageError where bodies carry each other in a circle, or one is unknown.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 18.2 and 18.8.

    Examples
    --------
    >>> [power.array for power in topology(Scene(), lower_bodies=(0, 1, 1, 3)).powers]
    ['1 2 3 4', '0 1 1 3', '0 0 0 1', '0 0 0 0']
    """
    bodies = _numbered(lower_bodies) if lower_bodies else scene.bodies
    require(not (lower_bodies and scene.bodies), "bodies and a lower body array are given together", code="exclusive",
            hint="give one of them")  # fmt: skip
    require(bodies, "there are no bodies", code="no-bodies", hint="give a scene, or --lower-bodies 0,1,1,3")
    order = ordered([body.name for body in bodies], [body.parent for body in bodies])
    chain = [bodies[k] for k in order]
    number = {GROUND: 0} | {body.name: n for n, body in enumerate(chain, 1)}
    lower = [number[body.parent] for body in chain]
    powers = _powers(lower)
    freedoms = sum(sum(COUNTS[body.joint]) for body in chain)
    constraints = sum(5 if loop.axis is not None else 3 for loop in scene.loops)
    moved = order != sorted(order)
    rows = tuple(_row(n, body, lower, powers) for n, body in enumerate(chain, 1))
    return Topology(
        bodies=len(chain),
        freedoms=freedoms,
        loops=len(scene.loops) or None,
        constraints=constraints if scene.loops else None,
        least_freedoms=max(freedoms - constraints, 0) if scene.loops else None,
        ends=", ".join(row.name for row in rows if row.sort == "end"),
        branching=", ".join(row.name for row in rows if row.sort == "branching") or "none",
        depth=len(powers) - 1,
        tree=rows,
        powers=tuple(Power(j, " ".join(map(str, power))) for j, power in enumerate(powers)),
        typed=" ".join(str(k + 1) for k in order) if moved else None,
        numerics=Numerics("counting"),
    )


def _numbered(lower: "Sequence[int]") -> "tuple[Body, ...]":
    """Bodies by their numbers."""
    for number, below in enumerate(lower, 1):
        if not 0 <= below <= len(lower):
            raise UsageError(f"body {number} is carried by body {below}, of {len(lower)}", code="unknown-parent",
                             hint=f"0 is the ground, bodies are 1 to {len(lower)}")  # fmt: skip
    return tuple(Body(str(n), str(below) if below else GROUND) for n, below in enumerate(lower, 1))


def _powers(lower: "Sequence[int]") -> "list[list[int]]":
    """L⁰, L¹, … until every body is at the ground."""
    powers = [list(range(1, len(lower) + 1))]
    while any(powers[-1]):
        powers.append([lower[k - 1] if k else 0 for k in powers[-1]])
    return powers


def _row(number: int, body: Body, lower: "Sequence[int]", powers: "Sequence[Sequence[int]]") -> BodyRow:
    carried = lower.count(number)
    path = [power[number - 1] for power in powers]
    return BodyRow(
        number=number, name=body.name, lower=lower[number - 1], carried_by=body.parent,
        sort="end" if not carried else "branching" if carried > 1 else "inner", joint=str(body.joint),
        speeds=sum(COUNTS[body.joint]), path=" ".join(map(str, path[: path.index(0) + 1])),
    )  # fmt: skip
