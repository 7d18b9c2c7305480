"""An open chain of links, each pinned to the one before: joints, velocities, accelerations, partial velocities."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.turns import turned
from dynamics_cli.quantities import (
    Angle,
    AngularAcceleration,
    Annotated,
    Count,
    PartAcceleration,
    PartPoint,
    PartVelocity,
    Size,
    TurnRate,
)
from dynamics_cli.records import Choice, record


class Angles(Choice):
    """Reference of the angles."""

    names = ("absolute", "relative")
    aliases = {"fixed": "absolute", "joint": "relative"}  # noqa: RUF012


ABSOLUTE = Angles("absolute")


@record
class ChainLink:
    """One link of the chain."""

    length: Annotated[Size, "Length of the link, e.g. 300 mm."]
    angle: Annotated[Angle, "Its angle, from the x axis or from the link before it, e.g. 30 deg."]
    speed: Annotated[TurnRate, "Rate of that angle, e.g. 2 rad/s."] = 0.0
    acceleration: Annotated[AngularAcceleration, "Second rate of that angle, e.g. 3 rad/s^2."] = 0.0


@record
class JointMotion:
    """The far end of one link."""

    link: Annotated[Count, "The link, from the fixed end on."]
    angle: Annotated[Angle, "Angle of the link to the x axis [rad]."]
    speed: Annotated[TurnRate, "Its angular velocity [rad/s]."]
    position: Annotated[PartPoint, "Its far end [m]."]
    velocity: Annotated[PartVelocity, "Velocity of the far end [m/s]."]
    acceleration: Annotated[PartAcceleration, "Acceleration of the far end [m/s^2]."]
    partial_velocity: Annotated[PartPoint, "Change of the tip's position per radian of this link's given angle [m]."]


@record
class Chain:
    """The tip of an open chain, and every joint."""

    position: Annotated[PartPoint, "The tip [m]."]
    velocity: Annotated[PartVelocity, "Its velocity [m/s]."]
    acceleration: Annotated[PartAcceleration, "Its acceleration [m/s^2]."]
    angular_velocity: Annotated[TurnRate, "Angular velocity of the last link [rad/s]."]
    angular_acceleration: Annotated[AngularAcceleration, "Angular acceleration of the last link [rad/s^2]."]
    joints: Annotated[tuple[JointMotion, ...], "The joints from the fixed end on."]


def chain(
    *,
    links: Annotated[ChainLink | tuple[ChainLink, ...], "The links from the fixed end on."],
    angles: Annotated[Angles, "Whether angles are from the x axis, or each from the link before it."] = ABSOLUTE,
) -> Chain:
    """Positions, velocities and accelerations of the joints of an open chain of links, and its partial velocities.

    Equation
    --------
    r = Σ l_k e^{iθ_k}, v = Σ iω_k l_k e^{iθ_k}, a = Σ (iα_k − ω_k²) l_k e^{iθ_k}; partial velocity ∂r/∂θ_k: i l_k
    e^{iθ_k} of absolute angles, i (r − r_{k−1}) of relative ones.

    Raises
    ------
    InadmissibleError
        When no link is given, or a length is not above zero.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 5.6.

    Examples
    --------
    >>> chain(links=(ChainLink(0.3, 0.0, 2.0), ChainLink(0.2, 1.5707963267948966, 0.0))).velocity[1]
    0.6
    """
    group = links if isinstance(links, tuple) else (links,)
    require(len(group) > 0, "a chain needs at least one link", code="no-links")
    angle = speed = bend = 0.0
    x = y = vx = vy = ax = ay = 0.0
    bars, ends = [], []
    for number, link in enumerate(group, 1):
        require(
            link.length > 0.0,
            "link {number} has a length of {length}; a link needs more than zero",
            number=number,
            length=(link.length, Size),
            code="no-length",
        )
        if angles == ABSOLUTE:
            angle, speed, bend = link.angle, link.speed, link.acceleration
        else:
            angle, speed, bend = angle + link.angle, speed + link.speed, bend + link.acceleration
        turn = turned(angle)
        ex, ey = link.length * turn[0], link.length * turn[1]
        x, y = x + ex, y + ey
        vx, vy = vx - speed * ey, vy + speed * ex
        square = speed * speed
        ax, ay = ax - bend * ey - square * ex, ay + bend * ex - square * ey
        bars.append((ex, ey))
        ends.append((angle, speed, (x, y), (vx, vy), (ax, ay)))
    joints = []
    before = (0.0, 0.0)
    for number, (bar, end) in enumerate(zip(bars, ends, strict=True), 1):
        arm = bar if angles == ABSOLUTE else (x - before[0], y - before[1])
        joints.append(JointMotion(number, *end, partial_velocity=(-arm[1], arm[0])))
        before = end[2]
    return Chain((x, y), (vx, vy), (ax, ay), speed, bend, tuple(joints))
