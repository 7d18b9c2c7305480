"""What a person is given by: lengths of segments, or a height with proportions; a table of one's own."""

from dynamics_cli.errors import UsageError, require
from dynamics_cli.human.bodies.tables import DE_LEVA, SAMPLES, SOURCES, Segment, Sex, plain_name
from dynamics_cli.quantities import Annotated, Count, Fraction, Length, Ratio, Text
from dynamics_cli.records import Choice, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable


class HeadEnds(Choice):
    """Between which points the head's length is measured."""

    names = ("vertex-cervicale", "vertex-gonion")
    aliases = {"cervicale": "vertex-cervicale", "gonion": "vertex-gonion"}  # noqa: RUF012


class TrunkEnds(Choice):
    """Between which points the trunk's length is measured."""

    names = ("cervicale-hip", "suprasternale-hip", "shoulder-hip", "parts")
    aliases = {  # noqa: RUF012
        "cervicale": "cervicale-hip", "suprasternale": "suprasternale-hip", "shoulder": "shoulder-hip",
        "three-parts": "parts", "three": "parts",
    }  # fmt: skip


class HandEnds(Choice):
    """Between which points the hand's length is measured."""

    names = ("wrist-knuckle", "wrist-fingertip")
    aliases = {  # noqa: RUF012
        "knuckle": "wrist-knuckle", "metacarpale": "wrist-knuckle", "wrist-metacarpale": "wrist-knuckle",
        "fingertip": "wrist-fingertip", "dactylion": "wrist-fingertip", "wrist-dactylion": "wrist-fingertip",
    }  # fmt: skip


NAMES = (
    "head", "trunk", "shoulder", "upper arm", "forearm", "hand", "thigh", "shank", "foot", "upper trunk",
    "middle trunk", "lower trunk",
)  # fmt: skip
ENDS = {"head": HeadEnds, "trunk": TrunkEnds, "hand": HandEnds}


@record
class Lengths:
    """A person by the lengths of segments."""

    head: Annotated[Length | None, "Vertex to cervicale (the neck's lowest vertebra) or to gonion, e.g. 24 cm."] = None
    trunk: Annotated[Length | None, "Cervicale, or the point of --trunk-ends, to the hips, e.g. 60 cm."] = None
    shoulder: Annotated[Length | None, "Shoulder joints above the hips, along the trunk, e.g. 50 cm."] = None
    upper_arm: Annotated[Length | None, "Shoulder to elbow, e.g. 28 cm."] = None
    forearm: Annotated[Length | None, "Elbow to wrist, e.g. 27 cm."] = None
    hand: Annotated[Length | None, "Wrist to the middle knuckle or the fingertip, e.g. 8.5 cm."] = None
    thigh: Annotated[Length | None, "Hip to knee, e.g. 42 cm."] = None
    shank: Annotated[Length | None, "Knee to ankle, e.g. 43 cm."] = None
    foot: Annotated[Length | None, "Heel to the tip of the toes, e.g. 26 cm."] = None
    upper_trunk: Annotated[Length | None, "Suprasternale to xiphion, of a trunk in parts, e.g. 17 cm."] = None
    middle_trunk: Annotated[Length | None, "Xiphion to omphalion (navel), e.g. 21 cm."] = None
    lower_trunk: Annotated[Length | None, "Omphalion to the hips, e.g. 15 cm."] = None
    head_ends: Annotated[HeadEnds | None, "The head's length is from vertex to cervicale, or to gonion."] = None
    trunk_ends: Annotated[TrunkEnds | None, "The trunk's is from there to the hips; or it comes in parts."] = None
    hand_ends: Annotated[HandEnds | None, "The hand's is from wrist to knuckle, or to fingertip."] = None

    @property
    def by_name(self) -> "dict[str, float]":
        """The lengths given, by segment."""
        lengths = {name: getattr(self, name.replace(" ", "_")) for name in NAMES}
        for name, length in lengths.items():
            if length is not None:
                require(length > 0.0, "the length of the {name}, {length}, is not above zero", name=name,
                        length=(length, Length), code="length")  # fmt: skip
        return {name: length for name, length in lengths.items() if length is not None}


@record
class Proportion:
    """The length of a segment as a share of the height."""

    segment: Annotated[Text, "Its name, e.g. thigh."]
    share: Annotated[Fraction, "Its length over the height, from a source of yours, e.g. 24.5 %."]


@record
class Height:
    """A person by the height, with lengths as shares of it."""

    height: Annotated[Length, "Standing height, e.g. 1.75 m."]
    proportions: Annotated[tuple[Proportion, ...] | None, "Lengths over height, from a source of yours."] = None
    head_ends: Annotated[HeadEnds | None, "The head's length is from vertex to cervicale, or to gonion."] = None
    trunk_ends: Annotated[TrunkEnds | None, "The trunk's is from there to the hips; or it comes in parts."] = None
    hand_ends: Annotated[HandEnds | None, "The hand's is from wrist to knuckle, or to fingertip."] = None

    @property
    def by_name(self) -> "dict[str, float]":
        """The lengths that the proportions give, by segment."""
        require(self.height > 0.0, "the height of {height} is not above zero", height=(self.height, Length))
        lengths = {}
        for proportion in self.proportions or ():
            name = plain_name(proportion.segment)
            if name not in NAMES:
                raise UsageError(
                    f"there is no segment {proportion.segment!r}", code="segment", parameter="proportions",
                    hint="name one of " + ", ".join(NAMES),
                )  # fmt: skip
            lengths[name] = proportion.share * self.height
        return lengths


def ends_of(size: "Lengths | Height") -> "dict[str, Choice | None]":
    """Between which points the lengths of head, trunk and hand are measured."""
    return {"head": size.head_ends, "trunk": size.trunk_ends, "hand": size.hand_ends}


@record
class CustomSegment:
    """One row of a table of one's own."""

    name: Annotated[Text, "The segment, e.g. thigh."]
    share: Annotated[Fraction, "Its mass over the body's, one of a pair, e.g. 14.16 %."]
    count: Annotated[Count, "How many of it a body has."] = 1
    centroid: Annotated[Fraction | None, "Mass centre from the first end over the length, e.g. 40.95 %."] = None
    front_back: Annotated[Ratio | None, "Radius of gyration about the front-back axis over the length."] = None
    left_right: Annotated[Ratio | None, "Radius of gyration about the left-right axis over the length."] = None
    lengthwise: Annotated[Ratio | None, "Radius of gyration about the long axis over the length."] = None


def de_leva(
    sex: "Sex | None", lengths: "dict[str, float]", ends: "dict[str, Choice | None]", *, joined: bool = False
) -> "list[Segment]":
    """The segments of de Leva's table between the ends that the lengths are measured between.

    `joined` is for a figure, in which head and trunk meet at the cervicale and the hand ends at the knuckle.
    """
    if sex is None:
        raise UsageError(
            "the table of de Leva has a part for men and one for women", code="missing", parameter="sex",
            hint="give --sex male or --sex female",
        )  # fmt: skip
    chosen = {}
    for name, choice in ENDS.items():
        end = ends.get(name)
        if end is None and name in lengths and not joined:
            rows = [row for row in DE_LEVA[sex] if row.name == name]
            shares = ", ".join(f"{100.0 * (row.centroid or 0.0):.2f} % for {row.ends}" for row in rows)
            raise UsageError(
                f"the length of the {name} does not say between which points: its mass centre is at {shares}",
                code="ends", parameter=name, hint=f"give --{name}-ends " + " or ".join(row.ends for row in rows),
            )  # fmt: skip
        chosen[name] = end or choice.names[0]
        if joined and chosen[name] != choice.names[0]:
            raise UsageError(
                f"a posture needs the length of the {name} from {choice.names[0].replace('-', ' to ')}, "
                f"not {chosen[name].replace('-', ' to ')}: the segments must meet",
                code="ends", parameter=f"{name}_ends", hint=f"measure it so, and leave out --{name}-ends",
            )  # fmt: skip
    parts = chosen["trunk"] == "parts"
    return [
        row for row in DE_LEVA[sex]
        if (parts if row.name.endswith(" trunk") else row.name not in chosen or row.ends == chosen[row.name])
    ]  # fmt: skip


def total(rows: "Iterable[Segment]") -> float:
    """What the shares of a body's segments add up to."""
    return sum(row.count * row.share for row in rows)


def provenance(table: str, sex: "Sex | None") -> str:
    """Where a table comes from and whom it stands for."""
    sample = SAMPLES[table].get(sex or "") or SAMPLES[table][""]
    return f"{SOURCES[table].format(sex=sex)}; sample: {sample}"


def body_mass_index(mass: float, height: float) -> float:
    """Mass over height squared."""
    return mass / (height * height)
