"""The task `screw`: torques that raise and lower a load on a screw, self-locking, efficiency."""

from dynamics_cli.errors import require, require_given, worded
from dynamics_cli.numerics.elementary import absolute, atan, cos, pi_beside, sqrt
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Angle, Annotated, Count, Force, Fraction, Friction, Size, Text, Torque
from dynamics_cli.records import Advice, Choice, record

DEGREE = 0.017453292519943295
QUARTER = 1.5707963267948966
# A thread whose friction is less than this above the limit of self-locking is pointed out.
SLIM = 1.25


class Form(Choice):
    """A standard form of thread."""

    names = ("square", "trapezoidal", "acme", "metric")
    aliases = {"tr": "trapezoidal", "iso": "metric", "m": "metric"}  # noqa: RUF012


# The angle of the flank from the plane across the axis.
FLANKS = {"square": 0.0, "trapezoidal": 15.0 * DEGREE, "acme": 14.5 * DEGREE, "metric": 30.0 * DEGREE}


@record
class Standard:
    """A thread by its form."""

    thread: Annotated[Form, "square, trapezoidal (30°), acme (29°) or metric (60°)."]


@record
class Flank:
    """A thread by its flank."""

    flank_angle: Annotated[Angle, "Angle of the loaded flank from the plane across the axis, e.g. 3 deg."]


@record
class Mean:
    """The size by the mean diameter."""

    mean_diameter: Annotated[Size, "Mean (pitch) diameter of the thread, e.g. 30 mm."]


@record
class Nominal:
    """The size by the nominal diameter."""

    diameter: Annotated[Size, "Nominal (major) diameter of the thread, e.g. 32 mm."]


@record
class Screw:
    """Torques of a loaded screw."""

    raising_torque: Annotated[Torque, "Torque that raises the load (or tightens), collar included [N·m]."]
    lowering_torque: Annotated[Torque, "Torque that lowers it (or loosens); negative where it must be held back [N·m]."]
    verdict: Annotated[Text, "Whether the load stays where it is when the torque is let go."]
    efficiency: Annotated[Fraction, "Work on the load over that of the raising torque [-]."]
    lead_angle: Annotated[Angle, "Lead angle λ at the mean diameter [rad]."]
    locking_friction: Annotated[Friction, "Coefficient of friction above which the thread holds by itself [-]."]
    thread_torque: Annotated[Torque, "The thread's part of the raising torque [N·m]."]
    collar_torque: Annotated[Torque | None, "Friction torque of the collar [N·m]."]
    mean_diameter: Annotated[Size, "Mean diameter of the thread [m]."]
    lead: Annotated[Size, "Advance in one turn [m]."]
    advice: tuple[Advice, ...] = ()


def screw(
    *,
    load: Annotated[Force, "Axial load, e.g. 15 kN."],
    form: Annotated[Standard | Flank, "A standard thread, or the angle of its flank."],
    size: Annotated[Nominal | Mean, "The nominal or the mean diameter."],
    pitch: Annotated[Size, "Axial distance of neighbouring threads, e.g. 8 mm."],
    starts: Annotated[Count, "Number of starts."] = 1,
    friction: Annotated[Friction, "Coefficient of friction of the thread, e.g. 0.15."],
    collar_diameter: Annotated[Size | None, "Mean diameter of the collar that takes the load, e.g. 80 mm."] = None,
    collar_friction: Annotated[
        Friction | None, "Coefficient of friction of the collar; without it the same, e.g. 0.12."
    ] = None,
) -> Screw:
    """Torques that raise and lower a load on a square, trapezoidal, Acme or metric screw; self-locking, efficiency.

    Equation
    --------
    T = W·d_m/2·(tan λ + μ′)/(1 − μ′·tan λ) + μ_c·W·d_c/2 with tan λ = l/(π·d_m), μ′ = μ/cos α; lowered with −tan λ;
    efficiency W·l/(2π·T). Mean diameter d − p/2, of a metric thread d − 3√3/8·p.

    Returns
    -------
    Screw
        The torques, whether the load holds by itself, the efficiency.

    Raises
    ------
    InadmissibleError
        When a length or the load is not above zero, when the thread jams, when a flank angle comes with a nominal
        diameter, or when a collar's friction comes without its diameter.

    Notes
    -----
    The flank angle α is measured in a section along the axis. Textbooks take it as that across the thread too, which
    makes friction too high by a factor of 1 + sin² α·sin² λ/2: for a trapezoidal thread 0.1 % at λ = 10°.

    References
    ----------
    The thread unrolled is an inclined plane; chapter 6 of the Scilab Textbook Companion to Bhandari, Design of Machine
    Elements (FOSSEE, IIT Bombay), has its formulas and examples.

    Examples
    --------
    >>> jack = screw(load=15e3, form=Standard(Form("square")), size=Nominal(0.05), pitch=0.008, starts=3, friction=0.15)
    >>> round(jack.raising_torque, 3), jack.verdict
    (111.832, 'runs back by itself')
    """
    for value, name in ((load, "load"), (pitch, "pitch"), (starts, "number of starts")):
        require(plain(value) > 0.0, "the {name} is zero", name=name, code="zero", hint="give a value above zero")
    flank = form.flank_angle if isinstance(form, Flank) else FLANKS[form.thread]
    require(
        plain(absolute(flank)) < QUARTER,
        "the flank angle {angle} is not below 90 degrees",
        angle=(flank, Angle),
        code="angle",
        hint="give the angle of the flank from the plane across the axis",
    )
    diameter = _mean(form, size, pitch)
    lead = pitch * starts
    pi = pi_beside(load, diameter, pitch, friction)
    slope, grip = lead / (pi * diameter), friction / cos(flank)
    require(
        plain(grip * slope) < 1.0,
        "the thread jams: at a lead angle of {angle} with this friction no torque raises the load",
        angle=(atan(slope), Angle),
        code="jams",
        hint="take a smaller lead, or less friction",
    )
    radius = 0.5 * diameter
    thread = load * radius * ((slope + grip) / (1.0 - grip * slope))
    back = load * radius * ((grip - slope) / (1.0 + grip * slope))
    collar = _collar(load, friction, collar_diameter, collar_friction)
    raising, lowering = (thread, back) if collar is None else (thread + collar, back + collar)
    limit = slope * cos(flank)
    held = plain(back) >= 0.0
    return Screw(
        raising_torque=raising,
        lowering_torque=lowering,
        verdict="holds by itself" if held else _without_thread(plain(lowering)),
        efficiency=load * lead / (2.0 * pi * raising),
        lead_angle=atan(slope),
        locking_friction=limit,
        thread_torque=thread,
        collar_torque=collar,
        mean_diameter=diameter,
        lead=lead,
        advice=_advice(plain(friction), plain(limit)) if held else (),
    )


def _mean(form: Standard | Flank, size: Nominal | Mean, pitch: float) -> float:
    if isinstance(size, Mean):
        require(plain(size.mean_diameter) > 0.0, "the mean diameter is zero", code="zero", hint="give one above zero")
        return size.mean_diameter
    require(
        isinstance(form, Standard),
        "the mean diameter of a thread that is given by its flank angle is not known",
        code="mean-diameter",
        hint="give --mean-diameter in place of --diameter",
    )
    metric = isinstance(form, Standard) and form.thread == "metric"
    mean = size.diameter - (0.375 * sqrt(3.0 + 0.0 * pitch) if metric else 0.5) * pitch
    require(
        plain(mean) > 0.5 * plain(size.diameter),
        "a pitch of {pitch} is too large for a diameter of {diameter}",
        pitch=(pitch, Size),
        diameter=(size.diameter, Size),
        code="pitch",
        hint="give the pitch, not the lead: several starts are --starts",
    )
    return mean


def _collar(load: float, friction: float, diameter: float | None, own_friction: float | None) -> float | None:
    require_given(
        diameter is not None or own_friction is None,
        "the friction of a collar needs its diameter",
        ("collar_diameter",),
        code="collar",
    )
    if diameter is None:
        return None
    return 0.5 * load * (friction if own_friction is None else own_friction) * diameter


def _without_thread(lowering: float) -> str:
    return "holds by the friction of its collar alone" if lowering >= 0.0 else "runs back by itself"


def _advice(friction: float, limit: float) -> tuple[Advice, ...]:
    if friction > SLIM * limit:
        return ()
    message = worded(
        "the thread only just holds: its friction is {friction:3}, and below {limit:3} it runs back",
        friction=(friction, Friction), limit=(limit, Friction),
    )  # fmt: skip
    return (Advice("only-just", message, "caution", "take a smaller lead: vibration and oil lower friction"),)
