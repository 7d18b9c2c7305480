"""The task `equivalent`: the same system as a force and a couple elsewhere, as a wrench, or as two forces."""

from dynamics_cli.errors import require
from dynamics_cli.force import ratios
from dynamics_cli.force.supports import Support, left_out
from dynamics_cli.force.system import Couple, Distributed, Load, System
from dynamics_cli.numerics.exact.rational import nearest
from dynamics_cli.quantities import Annotated, ForceVector, Length, LoadPoint, Position, Text, Torque, TorqueVector
from dynamics_cli.records import Advice, Check, Choice, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.force.ratios import Ratios

METHOD = "exact sums of the numbers as typed, rounded once"
ORIGIN = (0.0, 0.0, 0.0)


class Form(Choice):
    """The form of the equivalent system."""

    names = ("force-couple", "wrench", "two-forces")


@record
class Equivalent:
    """A system with the same effect on a rigid body."""

    form: Annotated[Text, "What it consists of."]
    force: Annotated[ForceVector, "The force; of two, the one at the given point [N]."]
    at: Annotated[Position, "Where it acts [m]."]
    couple: Annotated[TorqueVector | None, "The couple with it [N·m]."]
    second_force: Annotated[ForceVector | None, "The second of two forces [N]."]
    second_at: Annotated[Position | None, "Where the second force acts [m]."]
    pitch: Annotated[Length | None, "Moment along the force over the force [m]."]
    wrench_moment: Annotated[Torque | None, "Moment about the central axis, positive along the force [N·m]."]
    numerics: Numerics
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def equivalent(
    *,
    loads: Annotated[Load | tuple[Load, ...] | None, "Forces at points; one may be given by its plain fields."] = None,
    couples: Annotated[Couple | tuple[Couple, ...] | None, "Couples, in the plane one number, in space three."] = None,
    distributed_loads: Annotated[tuple[Distributed, ...] | None, "Loads spread along lines."] = None,
    about: Annotated[LoadPoint, "The new point, e.g. 1, 0 m."] = ORIGIN,
    supports: Annotated[tuple[Support, ...] | None, "Left out here: a scene of force equilibrium has them."] = None,
    form: Annotated[Form, "force-couple, wrench or two-forces."] = Form("force-couple"),  # noqa: B008
) -> Equivalent:
    """The same system as one force with a couple at another point, as a wrench, or as two forces.

    Equation
    --------
    R = Σ F, M_Q = M_O − Q × R; two forces: F₂ = M_Q × d/d² at Q + d and R − F₂ at Q, with d square to M_Q.

    Returns
    -------
    Equivalent
        The new system.

    Raises
    ------
    InadmissibleError
        When nothing is given, or when the wrench of a couple is asked for.

    Notes
    -----
    The first of two forces acts at the given point, the second a metre away, at right angles to the moment.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 6.5 and 6.6.

    Examples
    --------
    >>> equivalent(loads=Load((0.0, -500.0, 0.0), (2.0, 0.0, 0.0))).couple
    (0.0, 0.0, -1000.0)
    """
    system = System(loads, couples, distributed_loads)
    point = ratios.of_vector(about)
    forces, couple = _moved(system, point, form)
    pitch = wrench_moment = None
    square = ratios.dot(system.force, system.force)
    if form == "wrench":
        power = ratios.dot(system.force, couple)
        pitch, wrench_moment = nearest(ratios.over(power, square)), nearest(power) / ratios.size(system.force)
    (force, at), *second = forces
    return Equivalent(
        form={"force-couple": "force and couple", "wrench": "wrench", "two-forces": "two forces"}[form],
        force=ratios.rounded(force),
        at=ratios.rounded(at),
        couple=None if form == "two-forces" else ratios.rounded(couple),
        second_force=ratios.rounded(second[0][0]) if second else None,
        second_at=ratios.rounded(second[0][1]) if second else None,
        pitch=pitch,
        wrench_moment=wrench_moment,
        numerics=Numerics(METHOD),
        checks=(_same(system, forces, couple),),
        advice=(*system.advice(), *left_out(supports)),
    )


def _moved(system: System, point: "Ratios", form: str) -> "tuple[list[tuple[Ratios, Ratios]], Ratios]":
    """Forces with their points, and the remaining couple."""
    force, moment = system.force, system.moment_about(point)
    if form == "force-couple":
        return [(force, point)], moment
    if form == "wrench":
        require(
            not ratios.is_zero(force),
            "the forces add up to zero: {what} has no axis",
            what="a system in equilibrium" if ratios.is_zero(moment) else "a couple",
            code="couple",
            hint="use --form force-couple",
        )
        top, bottom = ratios.dot(force, force)
        foot = ratios.plus(point, ratios.times((bottom, top), ratios.cross(force, moment)))
        return [(force, foot)], system.moment_about(foot)
    arm = _square_to(moment)
    second = ratios.cross(moment, arm)  # the arm has length one, up to the last bit of a root: divided by its square
    top, bottom = ratios.dot(arm, arm)
    second = ratios.times((bottom, top), second)
    return [(ratios.minus(force, second), point), (second, ratios.plus(point, arm))], ratios.NONE


def _square_to(moment: "Ratios") -> "Ratios":
    """A vector of about a metre, exactly at right angles to the moment; along an axis where possible."""
    axis = min((0, 1, 2), key=lambda i: (abs(nearest(moment[i])), i))
    if not moment[axis][0]:
        return ratios.AXES[axis]
    arm = ratios.cross(moment, ratios.AXES[axis])
    whole = ratios.of_number(ratios.size(arm))
    return ratios.times((whole[1], whole[0]), arm)


def _same(system: System, forces: "list[tuple[Ratios, Ratios]]", couple: "Ratios") -> Check:
    """Both systems have the same force, and the same moment about three points that are not on a line."""
    worst = ratios.size(ratios.minus(ratios.plus(*(force for force, _ in forces)), system.force))
    for point in (ratios.NONE, *ratios.AXES[:2]):
        moments = [ratios.cross(ratios.minus(at, point), force) for force, at in forces]
        worst = max(worst, ratios.size(ratios.minus(ratios.plus(couple, *moments), system.moment_about(point))))
    return Check("equivalent about three points", worst == 0.0, worst, 0.0)
