"""Motion of a leg from joint centres over time: zero-lag low-pass filter, derivatives, joint moments and powers."""

from dynamics_cli.errors import require
from dynamics_cli.human.joints.newton import Link, up_the_limb
from dynamics_cli.numerics.elementary import atan2, tan
from dynamics_cli.numerics.fitting.records_file import FORCES, LENGTHS, interval_of, read_columns
from dynamics_cli.quantities import Frequency
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    Series = list[float]
    Path = tuple[Series, Series]

# Two passes of a Butterworth filter of second order have their common corner at the frequency asked for when each has
# it where tan(π·f·step) is that of this frequency over (√2 − 1)^(1/4).
TWO_PASSES = 0.8022432629231502
# So many periods of the corner are mirrored at each end.
PERIODS = 2.0
ROOT_TWO = 1.4142135623730951
MARKERS = ("hip", "knee", "ankle", "heel", "toe")
FEWEST = 5


@record
class Table:
    """What a leg needs of the table: mass, centroid from the upper end, radius of gyration, by segment."""

    mass: float
    centroid: float
    radius: float


def smooth(values: "Sequence[float]", step: float, cutoff: float) -> "Series":
    """Values without what is faster than the cutoff, forwards and backwards, so that nothing lags.

    What is filtered is the series beside the straight line between its ends, so that a steady motion stays as it is;
    beyond the ends it goes on as its own mirror image, turned about the end.
    """
    turn = tan(3.141592653589793 * cutoff * step) / TWO_PASSES
    k1, k2 = ROOT_TWO * turn, turn * turn
    a0 = k2 / (1.0 + k1 + k2)
    b1 = 2.0 * a0 * (1.0 / k2 - 1.0)
    b2 = 1.0 - 4.0 * a0 - b1
    more = min(int(PERIODS / (cutoff * step)) + 1, len(values) - 1)
    slope = (values[-1] - values[0]) / (len(values) - 1)
    trend = [values[0] + slope * k for k in range(len(values))]
    beside = [value - straight for value, straight in zip(values, trend, strict=True)]
    line = [
        *(-beside[k] for k in range(more, 0, -1)),
        *beside,
        *(-beside[-1 - k] for k in range(1, more + 1)),
    ]
    for _ in range(2):
        out = line[:2]
        for k in range(2, len(line)):
            out.append(a0 * (line[k] + 2.0 * line[k - 1] + line[k - 2]) + b1 * out[k - 1] + b2 * out[k - 2])
        line = out[::-1]
    return [value + straight for value, straight in zip(line[more:], trend, strict=False)]


def slopes(values: "Sequence[float]", step: float) -> "Series":
    """Central differences; there is none at the ends."""
    return [(values[k + 1] - values[k - 1]) / (2.0 * step) for k in range(1, len(values) - 1)]


def bends(values: "Sequence[float]", step: float) -> "Series":
    """Central second differences; there is none at the ends."""
    return [(values[k + 1] - 2.0 * values[k] + values[k - 1]) / (step * step) for k in range(1, len(values) - 1)]


class Bone:
    """One segment over time: its centre, angle and their derivatives, without the first and last instant."""

    __slots__ = ("acceleration", "centre", "inertia", "joint", "mass", "rate", "rotation", "spread")

    def __init__(self, upper: "Path", lower: "Path", angles: "Series", step: float, table: Table) -> None:
        spans = [
            ((x1 - x0) * (x1 - x0) + (y1 - y0) * (y1 - y0)) ** 0.5
            for x0, y0, x1, y1 in zip(*upper, *lower, strict=True)
        ]
        mean = sum(spans) / len(spans)
        self.spread = (max(spans) - min(spans)) / mean
        self.mass = table.mass
        self.inertia = table.mass * (table.radius * mean) * (table.radius * mean)
        path = [[a + table.centroid * (b - a) for a, b in zip(upper[i], lower[i], strict=True)] for i in (0, 1)]
        self.centre = [line[1:-1] for line in path]
        self.acceleration = [bends(line, step) for line in path]
        self.rate, self.rotation = slopes(angles, step), bends(angles, step)
        self.joint = [line[1:-1] for line in upper]

    def link(self, k: int, joint: "tuple[float, float] | None" = None) -> Link:
        """The segment at an instant."""
        return Link(
            self.mass, self.inertia, (self.centre[0][k], self.centre[1][k]),
            joint or (self.joint[0][k], self.joint[1][k]), (self.acceleration[0][k], self.acceleration[1][k]),
            self.rotation[k],
        )  # fmt: skip


def unwrapped(angles: "Sequence[float]") -> "Series":
    """Angles without jumps by a turn."""
    turn = 6.283185307179586
    out = [angles[0]]
    for angle in angles[1:]:
        out.append(angle + turn * round((out[-1] - angle) / turn))
    return out


def joint_actions(
    bones: "Sequence[Bone]", ankles: "Path", forces: "Path", places: "Series", gravity: float
) -> "list[list[tuple[tuple[float, float], float]]]":
    """Force and moment of ankle, knee and hip on the segment below, at each instant but the first and last."""
    answers = []
    for k in range(len(bones[0].rate)):
        ankle = ankles[0][k + 1], ankles[1][k + 1]
        links = [bones[0].link(k, ankle), bones[1].link(k), bones[2].link(k)]
        force = forces[0][k + 1], forces[1][k + 1]
        answers.append(up_the_limb(links, force, (places[k + 1], 0.0), gravity))
    return answers


class Stride:
    """A record: times, joint centres, the force of the ground and where it acts."""

    __slots__ = ("forces", "paths", "places", "step", "times")

    def __init__(
        self, times: "Series", step: float, paths: "dict[str, Path]", forces: "Path", places: "Series"
    ) -> None:
        self.times = times
        self.step = step
        self.paths = paths
        self.forces = forces
        self.places = places

    def angles(self, upper: str, lower: str) -> "Series":
        """The angle of the line from one joint to another, over time."""
        ends = (*self.paths[upper], *self.paths[lower])
        return unwrapped([atan2(y1 - y0, x1 - x0) for x0, y0, x1, y1 in zip(*ends, strict=True)])


def read_stride(file: str, cutoff: "float | None") -> Stride:
    """A record from a file, filtered where a cutoff is given; refuses what is missing or uneven."""
    columns = {f"{name}_{axis}": LENGTHS for name in (*MARKERS, "shoulder") for axis in "xy"}
    times, values = read_columns(file, {**columns, "force_x": FORCES, "force_y": FORCES, "at": LENGTHS})
    needed = [f"{name}_{axis}" for name in MARKERS for axis in "xy"] + ["force_x", "force_y", "at"]
    missing = [name for name in needed if name not in values]
    require(not missing, "the file has no columns {missing}", missing=", ".join(missing), code="header",
            hint="joint centres as hip_x[m], hip_y[m] and so on; force_x[N], force_y[N], at[m]")  # fmt: skip
    require(len(times) >= FEWEST, "the record has {count} samples; at least {fewest} are needed", count=len(times),
            fewest=FEWEST, code="length")  # fmt: skip
    step = interval_of(times)
    if cutoff is not None:
        require((cutoff > 0.0) & (cutoff < 0.4 / step), "the cutoff of {cutoff} is not below {most}, 0.4 of the "
                "rate", cutoff=(cutoff, Frequency), most=(0.4 / step, Frequency), code="cutoff")  # fmt: skip
        for name in (*MARKERS, "shoulder"):
            for key in (f"{name}_x", f"{name}_y"):
                if key in values:
                    values[key] = smooth(values[key], step, cutoff)
    paths = {
        name: (list(values[f"{name}_x"]), list(values[f"{name}_y"]))
        for name in (*MARKERS, "shoulder") if f"{name}_x" in values and f"{name}_y" in values
    }  # fmt: skip
    return Stride(list(times), step, paths, (list(values["force_x"]), list(values["force_y"])), list(values["at"]))
