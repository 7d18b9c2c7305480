"""The task `moment`: the moment of a force about a point and about a line."""

from dynamics_cli.errors import worded
from dynamics_cli.force import ratios
from dynamics_cli.force.system import direction, vector
from dynamics_cli.numerics.exact.rational import nearest
from dynamics_cli.quantities import (
    Annotated,
    Distance,
    Force,
    FreeVector,
    LoadPoint,
    Position,
    Torque,
    TorqueVector,
)
from dynamics_cli.records import Advice, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.force.ratios import Ratios
    from dynamics_cli.numerics.exact.rational import Pair

METHOD = "exact products of the numbers as typed, rounded once"
ORIGIN = (0.0, 0.0, 0.0)


@record
class Moment:
    """Moment of a force about a point, and about a line through it."""

    moment: Annotated[TorqueVector, "Moment about the point [N·m]."]
    magnitude: Annotated[Torque, "Its size [N·m]."]
    lever: Annotated[Distance | None, "Distance from the point to the line of action [m]."]
    foot: Annotated[Position | None, "The point of the line of action that is nearest to it [m]."]
    about_line: Annotated[Torque | None, "Moment about the line, by the right-hand rule [N·m]."]
    line_lever: Annotated[Distance | None, "Shortest distance between the two lines [m]."]
    numerics: Numerics
    advice: tuple[Advice, ...] = ()


def moment(
    *,
    force: Annotated[FreeVector, "The force, e.g. 200 N @ 30 deg."],
    at: Annotated[LoadPoint, "A point on its line of action, e.g. 0.3, 0.1 m."],
    about: Annotated[LoadPoint, "The point of reference, or a point on the line, e.g. 0, 0 m."] = ORIGIN,
    axis: Annotated[FreeVector | None, "Direction of a line through that point, e.g. 0, 0, 1."] = None,
) -> Moment:
    """Moment of a force about a point, with its lever, and about a line.

    Equation
    --------
    M = (r − Q) × F, lever |M|/|F|; about a line along n: M·n/|n|.

    Returns
    -------
    Moment
        The moment, the lever and, with an axis, the moment about it.

    Raises
    ------
    InadmissibleError
        When the vector is not a force, or the axis has no direction.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 6.3.

    Examples
    --------
    >>> moment(force=(0.0, -200.0, 0.0), at=(0.3, 0.1, 0.0)).moment
    (0.0, 0.0, -60.0)
    """
    components = vector(force, Force, "the force", "'3, 4 N' or '20 N @ 30 deg'")
    point = ratios.of_vector(about)
    arm = ratios.minus(ratios.of_vector(at), point)
    moment_vector = ratios.cross(arm, components)
    size, strength = ratios.size(moment_vector), ratios.size(components)
    foot = None
    if strength:
        foot = ratios.plus(point, ratios.times(_inverse_square(components), ratios.cross(components, moment_vector)))
    about_line = line_lever = None
    advice: tuple[Advice, ...] = ()
    if axis is not None:
        line = direction(axis, "the axis")
        about_line = nearest(ratios.dot(moment_vector, line)) / ratios.size(line)
        across = ratios.size(ratios.cross(components, line))
        line_lever = abs(nearest(ratios.dot(moment_vector, line))) / across if across else None
        if not across and strength:
            advice = (Advice("parallel", worded("the force is parallel to the axis: it has no moment about it"),
                             severity="note"),)  # fmt: skip
    return Moment(
        moment=ratios.rounded(moment_vector),
        magnitude=size,
        lever=size / strength if strength else None,
        foot=None if foot is None else ratios.rounded(foot),
        about_line=about_line,
        line_lever=line_lever,
        numerics=Numerics(METHOD),
        advice=advice,
    )


def _inverse_square(a: "Ratios") -> "Pair":
    top, bottom = ratios.dot(a, a)
    return bottom, top
