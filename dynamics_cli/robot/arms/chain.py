"""The frames of an arm's links: from a table of parameters and joint positions to places and axes."""

from dynamics_cli.errors import MissingError, require
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.orientation.rotations import IDENTITY, Matrix, product
from dynamics_cli.numerics.turns import turned
from dynamics_cli.numerics.vectors import Vector, add, times
from dynamics_cli.quantities import Angle, Coordinate
from dynamics_cli.records import record
from dynamics_cli.robot.arms.presets import NAMES, preset
from dynamics_cli.robot.arms.records import ORIGIN, REVOLUTE, STANDARD, Arm, Joint

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

INFINITE = float("inf")


@record
class Frame:
    """A place and the axes there; the columns of the matrix are the axes, in those of the base."""

    rotation: Matrix
    position: Vector

    def point(self, local: Vector) -> Vector:
        """A point of these axes, in those of the base."""
        return add(self.position, times(self.rotation, local))

    @property
    def z(self) -> Vector:
        """The third axis."""
        return self.rotation[0][2], self.rotation[1][2], self.rotation[2][2]


BASE = Frame(IDENTITY, ORIGIN)


@record
class Chain:
    """An arm ready for calculation."""

    joints: tuple[Joint, ...]
    names: tuple[str, ...]
    standard: bool
    tool: Vector

    @property
    def turning(self) -> "tuple[bool, ...]":
        """Of each joint whether it turns."""
        return tuple(joint.type == REVOLUTE for joint in self.joints)

    def links(self, coordinates: "Sequence[float]") -> "list[Frame]":
        """The frame of each link, from the first on."""
        frame, frames = BASE, []
        for joint, coordinate in zip(self.joints, coordinates, strict=True):
            frame = _after(frame, joint, coordinate, self.standard)
            frames.append(frame)
        return frames

    def axes(self, links: "Sequence[Frame]") -> "list[Frame]":
        """The frame whose third axis each joint turns about, or slides along."""
        return [BASE, *links[:-1]] if self.standard else list(links)

    def hand(self, links: "Sequence[Frame]") -> Frame:
        """The tip of the tool with the axes of the last link."""
        return Frame(links[-1].rotation, links[-1].point(self.tool))

    @property
    def reach(self) -> float:
        """A length that the hand is never farther from the base than, slides at zero."""
        parts = [abs(plain(x)) for joint in self.joints for x in (joint.a, joint.d)]
        return sum(parts) + sum(abs(plain(x)) for x in self.tool)


def _after(frame: Frame, joint: Joint, coordinate: float, standard: bool) -> Frame:
    """The frame of a link from that of the link before it.

    References
    ----------
    Standard: J. Denavit, R. S. Hartenberg, J. Appl. Mech. 22 (1955) 215; modified: J. J. Craig, Introduction to
    Robotics.
    """
    turns = joint.type == REVOLUTE
    ct, st = turned(joint.theta + coordinate if turns else joint.theta)
    ca, sa = turned(joint.alpha)
    d = joint.d if turns else joint.d + coordinate
    if standard:
        rotation: Matrix = ((ct, -st * ca, st * sa), (st, ct * ca, -ct * sa), (0.0, sa, ca))
        step = (joint.a * ct, joint.a * st, d)
    else:
        rotation = ((ct, -st, 0.0), (st * ca, ct * ca, -sa), (st * sa, ct * sa, ca))
        step = (joint.a, -d * sa, d * ca)
    return Frame(product(frame.rotation, rotation), frame.point(step))


def chain_of(arm: Arm) -> Chain:
    """The arm that is described, in one of three ways."""
    ways = [name for name in ("robot", "lengths", "joints") if getattr(arm, name)]
    if not ways:
        raise MissingError("the arm is missing", (("robot",), ("lengths",), ("convention", "joints")), code="no-arm")
    require(
        len(ways) == 1, "the arm is given twice, as {first} and as {second}",
        first=ways[0], second=ways[-1], code="two-arms",
    )  # fmt: skip
    if arm.robot:
        known = preset(arm.robot)
        require(known is not None, "there is no arm {name}", name=repr(arm.robot), code="unknown-arm",
                hint=f"published arms are {', '.join(NAMES)}; any other by its table of joints")  # fmt: skip
        assert known is not None
        joints, standard = known.joints, known.convention == STANDARD
    elif arm.lengths:
        joints, standard = _limited(_rods(arm.lengths, arm.masses), arm), True
    else:
        if arm.convention is None:
            raise MissingError("the table of joints does not say its convention", (("convention",),), code="convention")
        joints, standard = arm.joints, arm.convention == STANDARD
    require(
        bool(arm.lengths) or not (arm.lower or arm.upper),
        "limits {words} are of an arm by its lengths",
        words="--lower and --upper", code="limit", hint="in a table of joints each row has its lower and upper",
    )  # fmt: skip
    names = tuple(joint.name or str(number) for number, joint in enumerate(joints, 1))
    for name, joint in zip(names, joints, strict=True):
        _check_limits(name, joint)
    return Chain(joints=joints, names=names, standard=standard, tool=arm.tool)


def _rods(lengths: "Sequence[float]", masses: "Sequence[float]") -> "tuple[Joint, ...]":
    """Links of a planar arm; with masses, uniform rods."""
    require(
        len(masses) in (0, len(lengths)), "read {masses} masses of {lengths} links",
        masses=len(masses), lengths=len(lengths), code="masses", hint="one mass for each length",
    )  # fmt: skip
    if not masses:
        return tuple(Joint(a=length) for length in lengths)
    joints = []
    for length, mass in zip(lengths, masses, strict=True):
        across = mass * length * length / 12.0
        tensor = (ORIGIN, (0.0, across, 0.0), (0.0, 0.0, across))
        joints.append(Joint(a=length, mass=mass, centroid=(-0.5 * length, 0.0, 0.0), tensor=tensor))
    return tuple(joints)


def _limited(joints: "tuple[Joint, ...]", arm: Arm) -> "tuple[Joint, ...]":
    """The joints of a planar arm with their limits."""
    for word, values in (("lower", arm.lower), ("upper", arm.upper)):
        require(
            len(values) in (0, len(joints)), "read {values} {word} limits of {joints} joints",
            values=len(values), word=word, joints=len(joints), code="limit", hint="one for each length",
        )  # fmt: skip
        if values:
            joints = tuple(
                Joint(**{**joint.__dict__, word: value}) for joint, value in zip(joints, values, strict=True)
            )
    return joints


def _check_limits(name: str, joint: Joint) -> None:
    turns = joint.type == REVOLUTE
    other = (joint.lower_travel, joint.upper_travel) if turns else (joint.lower, joint.upper)
    require(
        other == (None, None),
        "joint {name} is {type}: its limits are {wanted}",
        name=name, type=joint.type, code="limit",
        wanted="lower and upper" if turns else "lower travel and upper travel",
    )  # fmt: skip
    low, high = limits(joint)
    kind = Angle if turns else Coordinate
    require(low <= high, "joint {name} has its lower limit of {low} above its upper one of {high}",
            name=name, low=(low, kind), high=(high, kind), code="limit")  # fmt: skip


def limits(joint: Joint) -> "tuple[float, float]":
    """Both limits of a joint; infinite where it has none."""
    low, high = joint.lower, joint.upper
    if joint.type != REVOLUTE:
        low, high = joint.lower_travel, joint.upper_travel
    return -INFINITE if low is None else plain(low), INFINITE if high is None else plain(high)


def coordinates_of(
    chain: Chain, angles: "Sequence[float]", slides: "Sequence[float]", words: "tuple[str, str]" = ("angles", "slides")
) -> "list[float]":
    """Joint positions in the order of the joints: `angles` of those that turn, `slides` of those that slide."""
    turning = chain.turning
    for values, count, word, sort in (
        (angles, turning.count(True), words[0], "revolute"),
        (slides, turning.count(False), words[1], "prismatic"),
    ):
        require(
            len(values) == count,
            "read {read} {word}, and the arm has {count} {sort} joint{s}",
            read=len(values), word=word, count=count, sort=sort, s="s" * (count != 1), code="joint-count",
            hint=f"--{word} in the order of the joints",
        )  # fmt: skip
    turns, travels = iter(angles), iter(slides)
    return [next(turns if turns_ else travels) for turns_ in turning]


def beyond_limits(chain: Chain, coordinates: "Sequence[float]") -> "list[tuple[str, float, bool]]":
    """Joints beyond a limit: the name, by how much, and whether it turns."""
    out = []
    for name, joint, coordinate in zip(chain.names, chain.joints, coordinates, strict=True):
        low, high = limits(joint)
        value = plain(coordinate)
        excess = max(low - value, value - high)
        if excess > 1e-12 * max(1.0, abs(value)):
            out.append((name, excess, joint.type == REVOLUTE))
    return out
