"""Figures from measured joint centres, each side on its own, anywhere in space."""

from dynamics_cli.errors import UsageError, require
from dynamics_cli.human.bodies.figure import SPANS, Figure, Part
from dynamics_cli.human.bodies.person import de_leva
from dynamics_cli.human.bodies.tables import plain_name
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.vectors import Vector, length, subtract
from dynamics_cli.quantities import Annotated, Length, SpacePosition, Text
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.human.bodies.tables import Segment, Sex

SIDES = ("left", "right")
MIDDLE = ("vertex", "neck")
SIDED = ("shoulder", "elbow", "wrist", "knuckle", "hip", "knee", "ankle", "heel", "toe")
ALSO = {"cervicale": "neck", "c7": "neck", "head": "vertex", "top of head": "vertex", "hand": "knuckle"}
# Shorter or longer, no segment of a person is [m].
SHORTEST, LONGEST = 0.02, 1.2


@record
class JointCentre:
    """A joint centre, or an end of a segment."""

    name: Annotated[Text, "vertex, neck; left or right shoulder, elbow, wrist, knuckle, hip, knee, ankle, heel, toe."]
    at: Annotated[SpacePosition, "Where it is: forward, left, up, e.g. 0.1, 0.09, 0.5 m."]


def from_centres(mass: float, sex: "Sex | None", centres: "tuple[JointCentre, ...]") -> Figure:
    """The figure with these joint centres; the hips' middle is the trunk's lower end."""
    joints: dict[str, Vector] = {}
    for centre in centres:
        joints[_known(centre.name)] = centre.at
    missing = [name for name in _all() if name not in joints]
    if missing:
        raise UsageError(
            f"joint centres are missing: {', '.join(missing)}", code="missing", parameter="centres",
            hint="give each as name and place, e.g. a file with name,at_x[m],at_y[m],at_z[m]",
        )  # fmt: skip
    rows = {row.name: row for row in de_leva(sex, {}, {}, joined=True)}
    parts = []
    middle = _middle(joints["left hip"], joints["right hip"])
    for name, (first, second) in SPANS.items():
        if name in ("head", "trunk"):
            parts.append(_part(name, rows, mass, joints[first], middle if second == "hip" else joints[second]))
            continue
        parts += [
            _part(name, rows, mass, joints[f"{side} {first}"], joints[f"{side} {second}"], side) for side in SIDES
        ]
    return Figure({**joints, "hip": middle}, parts)


def _part(name: str, rows: "dict[str, Segment]", mass: float, first: Vector, second: Vector, side: str = "") -> Part:
    span = length(subtract(second, first))
    require(
        (plain(span) > SHORTEST) & (plain(span) < LONGEST), "the {name} would be {span} long",
        name=f"{side} {name}".strip(), span=(span, Length), code="length",
        hint="check the joint centres and their unit",
    )  # fmt: skip
    part = Part(rows[name], mass, first, second, both=False)
    part.name = f"{side} {name}".strip()
    return part


def _all() -> "list[str]":
    return [*MIDDLE, *(f"{side} {name}" for name in SIDED for side in SIDES)]


def _known(text: str) -> str:
    name = plain_name(text)
    name = ALSO.get(name, name)
    if name.startswith(("l ", "r ")):
        name = {"l": "left", "r": "right"}[name[0]] + name[1:]
    if name not in _all():
        raise UsageError(
            f"there is no joint centre {text!r}", code="joint", parameter="centres",
            hint="name one of " + ", ".join(_all()),
        )  # fmt: skip
    return name


def _middle(one: Vector, other: Vector) -> Vector:
    return tuple(0.5 * (a + b) for a, b in zip(one, other, strict=True))  # type: ignore[return-value]
