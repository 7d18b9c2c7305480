"""The figure of a body in a posture: where its joints are, and mass, centre and inertia of its segments there.

Axes: x forward, y to the left, z up. In the plane of the side view, inclinations are from forward, positive upwards.
"""

from dynamics_cli.errors import UsageError, require
from dynamics_cli.human.bodies.person import Height, Lengths, de_leva, ends_of
from dynamics_cli.human.bodies.tables import Segment, Sex
from dynamics_cli.numerics.elementary import cos, pi_beside, sin
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.trees.tree import ZERO
from dynamics_cli.numerics.vectors import Vector, add, cross, length, moved, scale, subtract
from dynamics_cli.quantities import Angle, Annotated, Mass
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.numerics.vectors import Tensor

HALF_TURN = 3.141592653589793
# From where to where each segment goes, in the order in which a standing figure is built.
SPANS = {
    "foot": ("heel", "toe"), "shank": ("knee", "ankle"), "thigh": ("hip", "knee"), "trunk": ("neck", "hip"),
    "head": ("vertex", "neck"), "upper arm": ("shoulder", "elbow"), "forearm": ("elbow", "wrist"),
    "hand": ("wrist", "knuckle"),
}  # fmt: skip
# Wider than healthy people move [deg]: beyond it, a sign or a unit is wrong.
RANGES = {
    "ankle_flexion": (-70, 50), "knee_flexion": (-15, 165), "hip_flexion": (-45, 145), "neck_flexion": (-90, 90),
    "shoulder_flexion": (-80, 190), "elbow_flexion": (-15, 165), "wrist_flexion": (-95, 95),
}  # fmt: skip


@record
class Flexions:
    """A posture by joint angles, zero when standing straight with the arms hanging, flexion positive."""

    ankle_flexion: Annotated[Angle, "Ankle: the shank forward over the foot (dorsiflexion), e.g. 10 deg."] = 0.0
    knee_flexion: Annotated[Angle, "Knee, e.g. 40 deg."] = 0.0
    hip_flexion: Annotated[Angle, "Hip: trunk against thigh, e.g. 80 deg."] = 0.0
    neck_flexion: Annotated[Angle, "Neck: head against trunk, negative when it looks up, e.g. -10 deg."] = 0.0
    shoulder_flexion: Annotated[Angle, "Shoulder: upper arm forward of the trunk, e.g. 50 deg."] = 0.0
    elbow_flexion: Annotated[Angle, "Elbow, e.g. 10 deg."] = 0.0
    wrist_flexion: Annotated[Angle, "Wrist, e.g. 0 deg."] = 0.0

    def inclinations(self, pi: float) -> "dict[str, float]":
        """Inclinations of the segments; arms hang downwards."""
        shank = 0.5 * pi - self.ankle_flexion
        thigh = shank + self.knee_flexion
        trunk = thigh - self.hip_flexion
        upper_arm = trunk - pi + self.shoulder_flexion
        forearm = upper_arm + self.elbow_flexion
        return {
            "shank": shank, "thigh": thigh, "trunk": trunk, "head": trunk - self.neck_flexion, "upper arm": upper_arm,
            "forearm": forearm, "hand": forearm + self.wrist_flexion,
        }  # fmt: skip


@record
class Inclinations:
    """A posture by the inclinations of the segments from forward, 90 degrees upright, -90 degrees hanging."""

    shank_inclination: Annotated[Angle, "Shank, from ankle to knee, e.g. 80 deg."]
    thigh_inclination: Annotated[Angle, "Thigh, from knee to hip, e.g. 120 deg."]
    trunk_inclination: Annotated[Angle, "Trunk, from the hips upwards, e.g. 40 deg."]
    head_inclination: Annotated[Angle | None, "Head; as the trunk if left out, e.g. 50 deg."] = None
    upper_arm_inclination: Annotated[Angle | None, "Upper arm, from the shoulder; hanging if left out."] = None
    forearm_inclination: Annotated[Angle | None, "Forearm; as the upper arm if left out, e.g. -80 deg."] = None
    hand_inclination: Annotated[Angle | None, "Hand; as the forearm if left out, e.g. -80 deg."] = None

    def inclinations(self, pi: float) -> "dict[str, float]":
        """Inclinations of the segments."""
        upper_arm = -0.5 * pi if self.upper_arm_inclination is None else self.upper_arm_inclination
        forearm = upper_arm if self.forearm_inclination is None else self.forearm_inclination
        return {
            "shank": self.shank_inclination, "thigh": self.thigh_inclination, "trunk": self.trunk_inclination,
            "head": self.trunk_inclination if self.head_inclination is None else self.head_inclination,
            "upper arm": upper_arm, "forearm": forearm,
            "hand": forearm if self.hand_inclination is None else self.hand_inclination,
        }  # fmt: skip


class Part:
    """One segment of a figure in its place; in a side view both of a pair together."""

    __slots__ = ("along", "centre", "ends", "mass", "moments", "name")

    def __init__(self, row: Segment, mass: float, first: Vector, second: Vector, *, both: bool) -> None:
        way = subtract(second, first)
        span = length(way)
        self.name = row.name
        self.ends = first, second
        self.mass = mass * row.share * (row.count if both else 1)
        self.centre = add(first, scale(row.centroid or 0.0, way))
        self.along = scale(1.0 / span, way)
        radii = row.front_back or 0.0, row.left_right or 0.0, row.lengthwise or 0.0
        self.moments = tuple(self.mass * ((radius * span) * (radius * span)) for radius in radii)

    def split(self, width: float) -> "list[Part]":
        """The two of a pair, so far apart; what lies in the middle as it is."""
        if self.name in ("head", "trunk"):
            return [self]
        halves = []
        for side in (0.5, -0.5):
            half = object.__new__(Part)
            half.name, half.ends, half.along = self.name, self.ends, self.along
            half.mass, half.moments = 0.5 * self.mass, tuple(0.5 * moment for moment in self.moments)
            half.centre = self.centre[0], side * width, self.centre[2]
            halves.append(half)
        return halves

    def tensor(self) -> "Tensor":
        """Inertia tensor about its own centre: its left-right axis lies as level as the segment allows."""
        u = self.along
        side = subtract((0.0, 1.0, 0.0), scale(u[1], u))
        if float(plain(length(side))) < 1e-6:  # an arm held straight sideways
            side = subtract((1.0, 0.0, 0.0), scale(u[0], u))
        side = scale(1.0 / length(side), side)
        front = cross(side, u)
        axes = tuple(zip(self.moments, (front, side, u), strict=True))
        return tuple(  # type: ignore[return-value]
            tuple(sum(moment * (axis[i] * axis[j]) for moment, axis in axes) for j in range(3)) for i in range(3)
        )


class Figure:
    """The joints and segments of a body."""

    __slots__ = ("inclinations", "joints", "parts")

    def __init__(
        self, joints: "dict[str, Vector]", parts: "list[Part]", inclinations: "dict[str, float] | None" = None
    ) -> None:
        self.joints = joints
        self.parts = parts
        self.inclinations = inclinations or {}

    def part(self, name: str) -> Part:
        """The segment of a name."""
        return next(part for part in self.parts if part.name == name)

    @property
    def mass(self) -> float:
        """Mass of all segments."""
        return sum(part.mass for part in self.parts)

    @property
    def centre(self) -> Vector:
        """The mass centre of all segments."""
        return centre_of([(part.mass, part.centre) for part in self.parts])

    def tensor(self) -> "Tensor":
        """Inertia tensor about the mass centre."""
        centre = self.centre
        rows = (ZERO, ZERO, ZERO)
        for part in self.parts:
            about = moved(part.tensor(), part.mass, subtract(part.centre, centre))
            rows = add(rows[0], about[0]), add(rows[1], about[1]), add(rows[2], about[2])
        return rows


def centre_of(masses: "list[tuple[float, Vector]]") -> Vector:
    """The mass centre of masses at points."""
    whole = sum(mass for mass, _ in masses)
    return tuple(sum(mass * at[k] for mass, at in masses) / whole for k in range(3))  # type: ignore[return-value]


def needed_lengths(size: "Lengths | Height", names: "tuple[str, ...]") -> "dict[str, float]":
    """The lengths of these segments; what is missing is named."""
    lengths = size.by_name
    missing = [name for name in names if name not in lengths]
    if missing:
        options = " ".join(f"--{name.replace(' ', '-')}" for name in missing)
        hint = f"give {options}, or --input with a file of them"
        if isinstance(size, Height):
            hint = 'a height alone does not give lengths: add --proportion "segment=…, share=…" for each'
        raise UsageError(
            "lengths are missing: " + ", ".join(missing), code="missing", parameter=missing[0].replace(" ", "_"),
            hint=hint,
        )  # fmt: skip
    return lengths


def side_view(
    mass: float, sex: "Sex | None", size: "Lengths | Height", pose: "Flexions | Inclinations", ankle_height: float,
    heel: float, foot_inclination: float, *, any_posture: bool,
) -> Figure:  # fmt: skip
    """The figure in the plane of the side view, left and right alike, both of each pair together.

    The origin is on the floor below the ankle; the lower of heel and toe touches the floor.
    """
    require(mass > 0.0, "the mass of {mass} is not above zero", mass=(mass, Mass), code="mass")
    lengths = needed_lengths(size, (*SPANS, "shoulder"))
    rows = {row.name: row for row in de_leva(sex, lengths, ends_of(size), joined=True)}
    if isinstance(pose, Flexions) and not any_posture:
        _refuse_the_impossible(pose)
    pi = pi_beside(mass, ankle_height, *lengths.values())
    angles = {"foot": foot_inclination, **pose.inclinations(pi)}

    def step(name: str, span: float) -> Vector:
        return span * cos(angles[name]), 0.0, span * sin(angles[name])

    # the ankle is above the sole and ahead of the heel, in axes of the foot
    c, s = cos(foot_inclination), sin(foot_inclination)
    to_heel = -heel * c + ankle_height * s, 0.0, -heel * s - ankle_height * c
    ankle = (0.0, 0.0, 0.0)
    heel_at = add(ankle, to_heel)
    toe = add(heel_at, step("foot", lengths["foot"]))
    lowest = heel_at[2] if float(plain(foot_inclination)) >= 0.0 else toe[2]
    knee = add(ankle, step("shank", lengths["shank"]))
    hip = add(knee, step("thigh", lengths["thigh"]))
    neck = add(hip, step("trunk", lengths["trunk"]))
    shoulder = add(hip, step("trunk", lengths["shoulder"]))
    elbow = add(shoulder, step("upper arm", lengths["upper arm"]))
    wrist = add(elbow, step("forearm", lengths["forearm"]))
    joints = {
        "heel": heel_at, "toe": toe, "ankle": ankle, "knee": knee, "hip": hip, "neck": neck,
        "vertex": add(neck, step("head", lengths["head"])), "shoulder": shoulder, "elbow": elbow, "wrist": wrist,
        "knuckle": add(wrist, step("hand", lengths["hand"])),
    }  # fmt: skip
    joints = {name: (at[0], at[1], at[2] - lowest) for name, at in joints.items()}
    parts = [
        Part(rows[name], mass, joints[first], joints[second], both=True) for name, (first, second) in SPANS.items()
    ]
    return Figure(joints, parts, angles)


def _refuse_the_impossible(pose: Flexions) -> None:
    for name, (low, high) in RANGES.items():
        angle = getattr(pose, name)
        require(
            (angle >= low * HALF_TURN / 180.0) & (angle <= high * HALF_TURN / 180.0),
            "the {joint} does not reach {angle}: people move it between {low} and {high}",
            joint=name.replace("_", " "), angle=(angle, Angle), low=(low * HALF_TURN / 180.0, Angle),
            high=(high * HALF_TURN / 180.0, Angle), code="range",
            hint="flexion is positive, from standing straight with hanging arms; --any-posture takes any angle",
        )  # fmt: skip
