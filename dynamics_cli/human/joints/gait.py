"""The task `gait`: joint moments and powers of a leg over a stride, from joint centres and a force plate."""

from dynamics_cli.errors import require, worded
from dynamics_cli.human.bodies.person import de_leva, provenance
from dynamics_cli.human.bodies.tables import Sex
from dynamics_cli.human.joints.walking import Bone, Table, joint_actions, read_stride, slopes
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Annotated,
    Force,
    Frequency,
    Gravity,
    InputFile,
    Mass,
    MusclePower,
    PotentialEnergy,
    Ratio,
    Text,
    Time,
    Torque,
)
from dynamics_cli.records import Advice, Columns, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

STRETCHED = 0.08
# Below this share of the weight the foot hardly touches: its friction says nothing.
LOADED = 0.1
# Moments of the muscles that extend hip and knee and press the toes down are positive.
SIGNS = {"ankle": -1.0, "knee": 1.0, "hip": -1.0}


@record
class JointPeaks:
    """The extremes of one joint."""

    name: Annotated[Text, "The joint."]
    largest: Annotated[Torque, "Largest moment of its extensors (ankle: plantar flexors) [N·m]."]
    largest_time: Annotated[Time, "When [s]."]
    smallest: Annotated[Torque, "Largest moment of its flexors, negative [N·m]."]
    smallest_time: Annotated[Time, "When [s]."]
    force: Annotated[Force, "Largest net force [N]."]
    generated: Annotated[MusclePower | None, "Largest power generated [W]."]
    absorbed: Annotated[MusclePower | None, "Largest power absorbed, negative [W]."]
    work: Annotated[PotentialEnergy | None, "Work over the record [J]."]


@record
class Instant:
    """The leg at a time."""

    time: Annotated[Time, "Time [s]."]
    ankle_moment: Annotated[Torque, "Plantar flexors positive [N·m]."]
    knee_moment: Annotated[Torque, "Extensors positive [N·m]."]
    hip_moment: Annotated[Torque, "Extensors positive [N·m]."]
    ankle_power: Annotated[MusclePower, "Generated positive [W]."]
    knee_power: Annotated[MusclePower, "Generated positive [W]."]
    hip_power: Annotated[MusclePower, "Generated positive; of the thigh against a trunk that does not turn unless its "
                         "shoulder is given [W]."]  # fmt: skip
    hip_force_x: Annotated[Force, "Force of the hip on the thigh, forward [N]."]
    hip_force_y: Annotated[Force, "The same, up [N]."]
    ground_force_x: Annotated[Force, "Force of the ground, forward [N]."]
    ground_force_y: Annotated[Force, "The same, up [N]."]


@record
class Gait:
    """Joint moments and powers of a leg over a stride."""

    support: Annotated[Torque, "Largest support moment: extensors of ankle, knee and hip together [N·m]."]
    support_time: Annotated[Time, "When [s]."]
    peaks: Annotated[tuple[JointPeaks, ...], "The extremes of each joint."]
    braking_friction: Annotated[Ratio | None, "Friction needed while the ground pushes backward [-]."]
    push_friction: Annotated[Ratio | None, "Friction needed while it pushes forward [-]."]
    rate: Annotated[Frequency, "Samples per second [Hz]."]
    stretch: Annotated[Ratio, "How much the most stretched segment changes its length [-]."]
    history: Annotated[Columns[Instant], "Moments and powers over time."]
    table: Annotated[Text, "Where the table of segments comes from."]
    numerics: Numerics | None = None
    advice: tuple[Advice, ...] = ()


def gait(
    file: Annotated[
        InputFile, "CSV: time[s], hip_x[m], hip_y, knee_, ankle_, heel_, toe_; force_x[N], force_y, at[m]."
    ],
    /,
    *,
    mass: Annotated[Mass, "Mass of the body, e.g. 75 kg."],
    sex: Annotated[Sex | None, "Male or female: which part of the table."] = None,
    cutoff: Annotated[Frequency | None, "Low-pass filter of the joint centres, e.g. 6 Hz; none if left out."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Gait:
    """Joint moments and powers of one leg over a stride, from the ground up.

    Equation
    --------
    Newton and Euler for foot, shank and thigh at each instant, with accelerations by central differences; power is the
    moment times the difference of the angular velocities beyond and before the joint.

    Returns
    -------
    Gait
        Extremes, work and the history of moments and powers, friction needed.

    Raises
    ------
    InadmissibleError
        When columns are missing, times are uneven, or the cutoff is above half the rate of samples.

    Notes
    -----
    Axes: x forward, y up from the floor. Moments are positive where they extend hip and knee and press the toes down.
    The first and last sample have no acceleration and are left out. Differences raise noise: give a cutoff for
    measured joint centres.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 20.7 to 20.9; de Leva 1996, table 4.

    Examples
    --------
    `dynamics human gait stride.csv --mass "75 kg" --sex male --cutoff "6 Hz"`
    """
    require(mass > 0.0, "the mass of {mass} is not above zero", mass=(mass, Mass), code="mass")
    stride = read_stride(file, cutoff)
    rows = {row.name: row for row in de_leva(sex, {}, {}, joined=True)}
    bones = []
    for name, upper, lower in (("foot", "heel", "toe"), ("shank", "knee", "ankle"), ("thigh", "hip", "knee")):
        row = rows[name]
        table = Table(row.share * mass, row.centroid or 0.0, row.left_right or 0.0)
        ends = stride.paths[upper], stride.paths[lower]
        bones.append(Bone(*ends, stride.angles(upper, lower), stride.step, table))
    actions = joint_actions(bones, stride.paths["ankle"], stride.forces, stride.places, gravity)
    trunk = [0.0] * len(actions)
    if "shoulder" in stride.paths:
        trunk = slopes(stride.angles("hip", "shoulder"), stride.step)
    rates = [bone.rate for bone in bones] + [trunk]
    moments = {
        name: [SIGNS[name] * moments[k][1] for moments in actions] for k, name in enumerate(SIGNS)
    }  # fmt: skip
    powers = {
        name: [
            action[k][1] * (below - above) for action, below, above in zip(actions, rates[k], rates[k + 1], strict=True)
        ]
        for k, name in enumerate(SIGNS)
    }  # fmt: skip
    times = stride.times[1:-1]
    together = [sum(values) for values in zip(*moments.values(), strict=True)]
    most = max(range(len(times)), key=together.__getitem__)
    stretch = max(bone.spread for bone in bones)
    import numpy as np

    columns = {f"{name}_moment": moments[name] for name in SIGNS} | {f"{name}_power": powers[name] for name in SIGNS}
    columns["hip_force_x"] = [action[2][0][0] for action in actions]
    columns["hip_force_y"] = [action[2][0][1] for action in actions]
    columns["ground_force_x"], columns["ground_force_y"] = (line[1:-1] for line in stride.forces)
    braking, push = _friction(columns["ground_force_x"], columns["ground_force_y"], LOADED * mass * gravity)
    return Gait(
        support=together[most],
        support_time=times[most],
        peaks=tuple(
            _peaks(name, times, moments[name], powers[name], [action[k][0] for action in actions], stride.step)
            for k, name in enumerate(SIGNS)
        ),
        braking_friction=braking,
        push_friction=push,
        rate=1.0 / stride.step,
        stretch=stretch,
        history=Columns(Instant, time=np.array(times), **{name: np.array(line) for name, line in columns.items()}),
        table=provenance("de-leva", sex),
        numerics=Numerics("central differences" + (", Butterworth filter forwards and backwards" if cutoff else "")),
        advice=_advice(stretch, filtered=cutoff is not None, trunk="shoulder" in stride.paths),
    )


def _peaks(
    name: str, times: "Sequence[float]", moments: "Sequence[float]", powers: "Sequence[float]",
    forces: "Sequence[tuple[float, float]]", step: float,
) -> JointPeaks:  # fmt: skip
    high = max(range(len(times)), key=moments.__getitem__)
    low = min(range(len(times)), key=moments.__getitem__)
    return JointPeaks(
        name=name,
        largest=moments[high],
        largest_time=times[high],
        smallest=moments[low],
        smallest_time=times[low],
        force=max((x * x + y * y) ** 0.5 for x, y in forces),
        generated=max(powers),
        absorbed=min(powers),
        work=step * (sum(powers) - 0.5 * (powers[0] + powers[-1])),
    )


def _friction(forward: "Sequence[float]", up: "Sequence[float]", least: float) -> "tuple[float | None, float | None]":
    """Friction needed while the foot is loaded: braking, and pushing off."""
    ratios = [x / y for x, y in zip(forward, up, strict=True) if y > least]
    braking, push = max((-ratio for ratio in ratios), default=0.0), max(ratios, default=0.0)
    return (braking if braking > 0.0 else None), (push if push > 0.0 else None)


def _advice(stretch: float, *, filtered: bool, trunk: bool) -> "tuple[Advice, ...]":
    advice = []
    if stretch > STRETCHED:
        words = worded("a segment changes its length by {share:3} of it: the joint centres slip or are noisy",
                       share=(stretch, Ratio))  # fmt: skip
        advice.append(Advice("stretch", words, remedy="check the joint centres and their unit"))
    if not filtered:
        advice.append(Advice("noise", "the joint centres are not filtered: differences raise their noise",
                             severity="note", remedy="--cutoff, about 6 Hz for walking"))  # fmt: skip
    if not trunk:
        advice.append(Advice("trunk", "power of the hip: the trunk is taken not to turn", severity="note",
                             remedy="give columns shoulder_x and shoulder_y"))  # fmt: skip
    return tuple(advice)
