"""Motion of several masses over time, from rest, under a force or on a moving base: sine, formula, record."""

from dynamics_cli.errors import worded
from dynamics_cli.quantities import (
    Acceleration,
    Annotated,
    Coordinate,
    DampingRatio,
    Frequency,
    PotentialEnergy,
    Ratio,
    Size,
    Text,
    Time,
    VibrationSpeed,
)
from dynamics_cli.records import Advice, Check, Columns, Numerics, record
from dynamics_cli.vibration.systems.inputs import Bodies, Line, Matrices, MatrixFiles, System
from dynamics_cli.vibration.systems.loads import (
    BaseLaw,
    ForceLaw,
    MotionLaw,
    Reach,
    Recorded,
    SineBase,
    SineForce,
    SineMotion,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.vibration.systems.runs import Run

# Two step sizes of a formula that differ by more are reported.
AGREE = 1e-6
BALANCE = 1e-4
# A spline that runs past the samples of a displacement by more, as a share of their range, is reported.
COARSE = 0.02
# Steps that the table holds at most.
ROWS = 2000


@record
class Moment:
    """The state of one coordinate at a time."""

    time: Annotated[Time, "Time [s]."]
    displacement: Annotated[Coordinate, "Displacement, against the base where that shakes [m]."]
    velocity: Annotated[VibrationSpeed, "Velocity, likewise [m/s]."]
    acceleration: Annotated[Acceleration, "Absolute acceleration [m/s^2]."]
    absolute_displacement: Annotated[Coordinate, "Displacement in space [m]."]
    absolute_velocity: Annotated[VibrationSpeed, "Velocity in space [m/s]."]
    base_displacement: Annotated[Coordinate, "Displacement of the base in space; 0 under a force [m]."]


@record
class History:
    """The motion over time."""

    peak: Annotated[Size, "Size of the largest displacement of the coordinate read; its side is in `peaks` [m]."]
    peak_time: Annotated[Time, "When [s]."]
    read: Annotated[Text, "The coordinate of the history."]
    work: Annotated[PotentialEnergy, "Work that the load did [J]."]
    lost: Annotated[PotentialEnergy, "What the dampers took of it [J]."]
    stored: Annotated[PotentialEnergy, "What is left at the end, in motion and springs [J]."]
    peaks: Annotated[tuple[Reach, ...], "How far each coordinate moves."]
    history: Annotated[Columns[Moment], "The motion of the coordinate read."]
    numerics: Numerics | None = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def history(
    *,
    system: Annotated[Line | Bodies | Matrices | MatrixFiles, "The system."],
    damping_ratio: Annotated[DampingRatio | None, "Damping ratio of every mode, instead of dampers, e.g. 0.02."] = None,
    load: Annotated[SineForce | ForceLaw | SineBase | BaseLaw | SineMotion | MotionLaw | Recorded, "What moves it."],
    force_at: Annotated[Text, "The coordinate that a force acts on: a name, or a number from 1."] = "",
    read_at: Annotated[Text, "The coordinate of the history; the one that moves most unless given."] = "",
    duration: Annotated[Time | None, "How long it is followed, e.g. 2 s; a record to its end."] = None,
) -> History:
    """Motion of several masses from rest under a force or on a shaking base, exact at every step.

    Equation
    --------
    q̈ + C·q̇ + Ω²·q = φᵀ·F(t) (or −φᵀ·M·1·a of the base): each mode in closed form, or, where dampers couple modes, the
    exponential of the state matrix; x = φ·q. A base that is moved by y(t) counts with a = ÿ; the masses are at
    rest until its first jump or velocity.

    Returns
    -------
    History
        Peaks of every coordinate, work and losses, and the motion of one coordinate over time.

    Raises
    ------
    InadmissibleError
        When the duration, or the coordinate of a force, is missing, the file is no record, or there are too many steps.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 13.6 to 13.8.

    Examples
    --------
    >>> made = history(system=Line((1.0,), (1.0,)), load=SineForce(1.0, 0.25), force_at="1", duration=6.0)
    >>> round(made.peak, 6)
    1.335811
    """
    from dynamics_cli.vibration.systems.runs import reaches, run

    model = System(system)
    motion = run(model, damping_ratio, load, force_at, duration)
    peaks = reaches(model, motion)
    place = model.moving(read_at) if read_at else max(range(len(peaks)), key=lambda i: abs(peaks[i].displacement))
    pick = motion.picked(ROWS)
    work, lost, stored = motion.energies()
    off = abs(work - lost - stored) / max(motion.largest_energy, 1e-300)
    checks = (Check("work is what was lost and stored", off <= BALANCE, off, BALANCE),) if motion.followed else ()
    return History(
        peak=abs(peaks[place].displacement),
        peak_time=peaks[place].time,
        read=peaks[place].name,
        work=work,
        lost=lost,
        stored=stored,
        peaks=peaks,
        history=Columns(
            Moment,
            time=motion.times[pick],
            displacement=motion.places[place, pick],
            velocity=motion.speeds[place, pick],
            acceleration=motion.absolute[place, pick],
            absolute_displacement=motion.places[place, pick] + motion.base_place[pick],
            absolute_velocity=motion.speeds[place, pick] + motion.base_speed[pick],
            base_displacement=motion.base_place[pick],
        ),
        numerics=Numerics(motion.method),
        checks=checks,
        advice=(*model.advice, *_advice(model, motion)),
    )  # fmt: skip


def _advice(model: System, motion: "Run") -> "tuple[Advice, ...]":
    from dynamics_cli.vibration.systems.runs import joined

    notes = []
    if motion.based and not joined(model):
        text = "nothing joins the masses to the base: it moves without them"
        remedy = "as many --stiffnesses as masses begin at the base; of bodies, couple one to the ground"
        notes.append(Advice("no-base", text, remedy=remedy))
    if not motion.followed:
        text = "modes above {f:3} move faster than the steps: their peaks may be missed, and the energy is not checked"
        notes.append(
            Advice("steps", worded(text, f=(motion.followed_to, Frequency)), remedy="give a shorter --duration")
        )
    if motion.overshoot > COARSE:
        text = "the record is coarse: the smooth curve through its samples runs past them by {share:2} of their range"
        remedy = "give closer samples, or a formula (--base-motion)"
        notes.append(Advice("coarse", worded(text, share=(motion.overshoot, Ratio)), remedy=remedy))
    if motion.rough > AGREE:
        text = "two step sizes of the formula differ by {rough:2} of the largest displacement"
        notes.append(Advice("tolerance", worded(text, rough=(motion.rough, Ratio))))
    return tuple(notes)
