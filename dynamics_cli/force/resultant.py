"""The task `resultant`: the sum of forces and couples, and its line of action."""

from dynamics_cli.errors import worded
from dynamics_cli.force import ratios
from dynamics_cli.force.supports import Support, left_out
from dynamics_cli.force.system import Couple, Distributed, Load, System
from dynamics_cli.numerics.elementary import atan2
from dynamics_cli.numerics.exact.rational import nearest
from dynamics_cli.quantities import (
    Angle,
    Annotated,
    Force,
    ForceVector,
    Length,
    LoadPoint,
    Position,
    Ratio,
    Text,
    Torque,
    TorqueVector,
    Vector,
)
from dynamics_cli.records import Advice, Check, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.force.ratios import Ratios

METHOD = "exact sums of the numbers as typed, rounded once"
ORIGIN = (0.0, 0.0, 0.0)
NO_FORCE = "a couple has no axis: its moment is the same about every point"


@record
class Resultant:
    """The resultant of a system of forces and couples."""

    system: Annotated[Text, "Zero, couple, single force or wrench."]
    arrangement: Annotated[
        Text | None, "Arrangement of the forces: on one line, concurrent, parallel, in one plane, in space."
    ]
    force: Annotated[ForceVector, "The resultant force [N]."]
    magnitude: Annotated[Force, "Its size [N]."]
    angle: Annotated[Angle | None, "Its angle from x, of a planar system [rad]."]
    moment: Annotated[TorqueVector, "Moment about the point of reference [N·m]."]
    axis_point: Annotated[
        Position | None,
        "The point of the line of action, or of the central axis, that is nearest to the reference [m].",
    ]
    direction: Annotated[Vector | None, "Direction of the line [-]."]
    crosses_x: Annotated[Length | None, "Where the line of action of a planar system crosses the x-axis [m]."]
    crosses_y: Annotated[Length | None, "Where it crosses the y-axis [m]."]
    pitch: Annotated[Length | None, "Moment along the force over the force [m]."]
    wrench_moment: Annotated[Torque | None, "Moment about the central axis, positive along the force [N·m]."]
    cancellation: Annotated[Ratio | None, "Sum of the sizes of the forces, over the size of the resultant [-]."]
    numerics: Numerics
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def resultant(
    *,
    loads: Annotated[Load | tuple[Load, ...] | None, "Forces at points; one may be given by its plain fields."] = None,
    couples: Annotated[Couple | tuple[Couple, ...] | None, "Couples, in the plane one number, in space three."] = None,
    distributed_loads: Annotated[tuple[Distributed, ...] | None, "Loads spread along lines."] = None,
    about: Annotated[LoadPoint, "The point of reference, e.g. 0, 0 m."] = ORIGIN,
    supports: Annotated[tuple[Support, ...] | None, "Left out here: a scene of force equilibrium has them."] = None,
) -> Resultant:
    """Resultant of forces at points and couples: its class, its moment and its line of action or central axis.

    Equation
    --------
    R = Σ F, M_Q = Σ (r − Q) × F + Σ C; pitch p = R·M/R²; the axis passes through Q + R × M_Q/R².

    Returns
    -------
    Resultant
        Force, moment, class, and for a force the axis with its pitch.

    Raises
    ------
    InadmissibleError
        When nothing is given, or a given vector is not a force.

    Notes
    -----
    The class is decided with the decimals as typed: forces of 0.1, 0.2 and −0.3 N add up to zero.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 6.2 to 6.6.

    Examples
    --------
    >>> loads = Load((1.0, 0.0, 0.0), (0.0, 0.0, 0.0)), Load((0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    >>> answer = resultant(loads=loads)
    >>> answer.system, answer.pitch, answer.axis_point
    ('wrench', -0.5, (0.0, 0.0, 0.5))
    """
    system = System(loads, couples, distributed_loads)
    reference = ratios.of_vector(about)
    force, moment = system.force, system.moment_about(reference)
    exists = not ratios.is_zero(force)
    square, power = ratios.dot(force, force), ratios.dot(force, moment)
    if exists:
        name = "wrench" if power[0] else "single force"
    else:
        name = "zero: in equilibrium" if ratios.is_zero(moment) else "couple"
    size = ratios.size(force)
    pitch = ratios.over(power, square) if exists else ratios.ZERO
    foot = ratios.plus(reference, _to_axis(force, moment)) if exists else None
    planar, components = system.planar, ratios.rounded(force)
    return Resultant(
        system=name,
        arrangement=arrangement(system),
        force=components,
        magnitude=size,
        angle=atan2(components[1], components[0]) if planar and exists else None,
        moment=ratios.rounded(moment),
        axis_point=None if foot is None else ratios.rounded(foot),
        direction=tuple(component / size for component in components) if exists else None,
        crosses_x=_crossing(system, 1) if planar and exists else None,
        crosses_y=_crossing(system, 0) if planar and exists else None,
        pitch=nearest(pitch) if name == "wrench" else None,
        wrench_moment=nearest(power) / size if name == "wrench" else None,
        cancellation=system.total_size / size if exists else None,
        numerics=Numerics(METHOD),
        checks=(_along_the_axis(system, foot),) if foot is not None else (),
        advice=(*system.advice(), *_on_couple(name), *left_out(supports)),
    )


def _to_axis(force: "Ratios", moment: "Ratios") -> "Ratios":
    """R × M/R²: from the point of reference at right angles to the axis."""
    square = ratios.dot(force, force)
    return ratios.times((square[1], square[0]), ratios.cross(force, moment))


def _crossing(system: System, component: int) -> "float | None":
    """x·R_y − y·R_x = M_z on the line of action."""
    force = system.force[component]
    if not force[0]:
        return None
    value = ratios.over(system.moment[2], force)
    return nearest(value if component == 1 else (-value[0], value[1]))


def arrangement(system: System) -> "str | None":
    """How the lines of the forces lie to one another, exactly; forces that are zero have none."""
    lines = [(p, f) for p, f in zip(system.points, system.forces, strict=True) if not ratios.is_zero(f)]
    if len(lines) < 2:
        return None
    (p, u), *rest = lines
    if all(ratios.is_zero(ratios.cross(u, f)) for _, f in rest):
        on_one = all(ratios.is_zero(ratios.cross(ratios.minus(q, p), u)) for q, _ in rest)
        return "on one line" if on_one else "parallel"
    if _meet(lines) is not None:
        return "concurrent"
    return "in one plane" if _coplanar(lines) else "in space"


def _meet(lines: "list[tuple[Ratios, Ratios]]") -> "Ratios | None":
    """The point common to all lines."""
    p, u = lines[0]
    q, v = next((q, v) for q, v in lines[1:] if not ratios.is_zero(ratios.cross(u, v)))
    normal = ratios.cross(u, v)
    gap = ratios.minus(q, p)
    if ratios.dot(gap, normal)[0]:
        return None
    share = ratios.over(ratios.dot(ratios.cross(gap, v), normal), ratios.dot(normal, normal))
    point = ratios.plus(p, ratios.times(share, u))
    on_all = all(ratios.is_zero(ratios.cross(ratios.minus(r, point), w)) for r, w in lines)
    return point if on_all else None


def _coplanar(lines: "list[tuple[Ratios, Ratios]]") -> bool:
    p, u = lines[0]
    ways = [v for _, v in lines] + [ratios.minus(q, p) for q, _ in lines]
    normal = next(n for v in ways if not ratios.is_zero(n := ratios.cross(u, v)))
    return not any(ratios.dot(normal, way)[0] for way in ways)


def _along_the_axis(system: System, foot: "Ratios") -> Check:
    off = ratios.size(ratios.cross(system.moment_about(foot), system.force))
    return Check("the moment about the axis is along the force", off == 0.0, off, 0.0)


def _on_couple(name: str) -> "tuple[Advice, ...]":
    if name == "couple":
        return (Advice("couple", worded(NO_FORCE), severity="note", result="axis_point"),)
    return ()
