"""Runs of several masses over time: steps, peaks between them, work and losses."""

import math

import numpy as np

from dynamics_cli.errors import require
from dynamics_cli.numerics.expressions.jets import Jet
from dynamics_cli.numerics.expressions.laws import law_of
from dynamics_cli.numerics.fitting.records_file import ACCELERATIONS, FORCES, LENGTHS, read_record
from dynamics_cli.quantities import Time
from dynamics_cli.sampling import cost, drawing, kept
from dynamics_cli.vibration.shocks.extremes import states_of_record
from dynamics_cli.vibration.shocks.pulses import Oscillators
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
from dynamics_cli.vibration.systems.modal import Modal

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.vibration.systems.inputs import System

# Steps in a period of the fastest motion, the fewest, the most, and the most numbers of all coordinates.
FINE, FEWEST, MOST, ROOM = 40, 400, 60_000, 30_000_000
# A formula is sampled more and more closely until the limits of two pairs of step sizes agree to this.
CLOSE = 1e-8
# The same of samples of uncertain inputs, and seconds of a sample: at least, and a step of a coordinate.
SAMPLED, ONCE, EACH = 1e-5, 3e-3, 6e-7
NEWTON = 4
# Elements of a row that sum to less than this beside the largest element sum to zero.
ROUNDED = 1e-12


class Run:
    """Modes, velocities and accelerations at every step, and those of the coordinates; against the base, and in space.

    `begin` is the displacement and velocity to which the base jumps at time 0, while the masses are still at rest.
    """

    def __init__(self, modal: Modal, weights: "Any", based: bool) -> None:
        self.modal, self.weights, self.based = modal, weights, based
        self.moved = False
        self.begin = (0.0, 0.0)
        self.rough = self.overshoot = 0.0
        self.method = "each mode in closed form from step to step"
        if modal.full is not None:
            self.method = "exponential of the state matrix of all modes together"

    def start(self) -> "tuple[Any, Any]":
        """Modes and their velocities against the base after its jump, whose dampers hit the masses."""
        place = self.weights * self.begin[0]
        return place, self.weights * self.begin[1] - self.modal.damped(place)

    def follow(self, times: "Any", steps: "tuple[Any, Any, Any, Any]", base: "tuple[Any, Any]", fastest: float) -> None:
        """Take the modes, their velocities, the loads, the slopes of the load in each step, the motion of the base."""
        modal = self.modal
        self.times, (self.q, self.v, self.loads, self.slopes) = times, steps
        step = float(np.diff(times).max())
        self.followed_to = 1.0 / (0.5 * FINE * step)
        self.followed = fastest <= 2.0 * math.pi * self.followed_to
        self.a = modal.accelerations(self.weights, self.q, self.v, self.loads)
        self.places, self.speeds = modal.shapes.T @ self.q, modal.shapes.T @ self.v
        self.relative = modal.shapes.T @ self.a
        self.base_place, self.base_speed = base
        self.base_pull = self.loads if self.based else np.zeros(len(times))
        self.absolute = self.relative + self.base_pull

    def picked(self, count: int) -> "Any":
        """Places of about so many steps, the first and the last among them."""
        return np.unique(np.linspace(0, len(self.times) - 1, count).round().astype(int))

    def energies(self) -> "tuple[float, float, float]":
        """Work of the load, losses, and what is stored at the end, by the trapezoidal rule with its end correction.

        What a jump of the base puts in at time 0 counts as work.
        """
        modal, h = self.modal, np.diff(self.times)
        powers = (self.weights @ self.v) * self.loads
        rates = (self.weights @ self.a) * self.loads
        into = [rates[:-1] + (self.weights @ self.v[:, :-1]) * self.slopes[0],
                rates[1:] + (self.weights @ self.v[:, 1:]) * self.slopes[1]]  # fmt: skip
        losses, change = modal.losses(self.v, self.v), 2.0 * modal.losses(self.v, self.a)
        work, lost = (
            float((0.5 * h * (f[:-1] + f[1:]) + h * h / 12.0 * (left - right)).sum())
            for f, left, right in ((powers, *into), (losses, change[:-1], change[1:]))
        )
        held = 0.5 * (self.v**2 + (modal.omega[:, None] * self.q) ** 2).sum(axis=0)
        self.largest_energy = max(abs(work), abs(lost), float(held.max()))
        return work + float(held[0]), lost, float(held[-1])


def run(model: "System", damping_ratio: "float | None", load: "Any", force_at: str, duration: "float | None") -> Run:
    """The motion from rest under a load."""
    modal = Modal(model, damping_ratio)
    based = isinstance(load, SineBase | BaseLaw | SineMotion | MotionLaw)
    record: Any = None
    moved = isinstance(load, SineMotion | MotionLaw)
    if isinstance(load, Recorded):
        times, values, unit = read_record(load.file, FORCES | ACCELERATIONS | LENGTHS)
        record, moved, based = (np.array(times) - times[0], np.array(values)), unit in LENGTHS, unit not in FORCES
        duration = float(record[0][-1]) if duration is None else duration
    require(duration is not None and duration > 0.0, "no duration is given", code="no-duration",
            hint="give --duration, for example 2 s")  # fmt: skip
    require(
        based or bool(force_at),
        "the coordinate that the force acts on is not given",
        code="no-place",
        hint="give --force-at",
    )
    motion = Run(modal, modal.base if based else modal.shapes[:, model.moving(force_at)], based)
    motion.moved = moved or (based and record is None)
    end, fastest = float(duration), float(modal.omega.max())  # type: ignore[arg-type]
    room = min(MOST, ROOM // len(modal.omega))
    if isinstance(load, SineForce | SineBase | SineMotion):
        _under_sine(motion, load, end, fastest, room)
    elif record is not None:
        pulls = _smooth(motion, record[0], record[1], end) if moved else record[1]
        times, loads = _refined(record[0], pulls, end, fastest, room)
        motion.follow(times, _lines(motion, times, loads), _base(motion, times, loads), fastest)
    else:
        _sampled(motion, load, end, fastest, room)
    require(bool(abs(motion.loads).max() > 0.0) or any(motion.begin), "the load is zero: nothing moves", code="no-load")
    if drawing():
        cost(0.0, ONCE + EACH * motion.q.size, 1)
    return motion


def joined(model: "System") -> bool:
    """Whether a motion of all masses together strains a spring or a damper."""
    _, *matrices = model.matrices()
    parts = (np.array(matrix) for matrix in matrices if matrix is not None)
    return any(abs(part.sum(axis=1)).max() > ROUNDED * abs(part).max() for part in parts if part.any())


def _under_sine(motion: Run, load: "Any", end: float, fastest: float, room: int) -> None:
    """A force or an acceleration of the base by a cosine, or a displacement of the base by a sine."""
    require(load.frequency > 0.0, "the frequency is zero: nothing vibrates", code="at-rest",
            hint='a constant force is a formula: --force-law "50 N"')  # fmt: skip
    rate = 2.0 * math.pi * load.frequency
    fastest = max(fastest, rate)
    times = np.linspace(0.0, end, _count(fastest, end, room) + 1)
    turn = np.exp(1j * rate * times)
    if isinstance(load, SineMotion):
        size = 1j * load.base_amplitude * rate * rate
        motion.begin = (0.0, load.base_amplitude * rate)
        base = (load.base_amplitude * turn.imag, load.base_amplitude * rate * turn.real)
    else:
        size = complex(load.force if isinstance(load, SineForce) else load.base_acceleration)
        # 1 − cos ωt
        base = (2.0 * size.real * np.sin(0.5 * rate * times) ** 2 / rate**2, size.real * turn.imag / rate)
    loads, slopes = (size * turn).real, (1j * rate * size * turn).real
    steps = (
        *motion.modal.under_sine(motion.weights, size, rate, times, motion.start()),
        loads,
        (slopes[:-1], slopes[1:]),
    )
    motion.follow(times, steps, base, fastest)


def _smooth(motion: Run, times: "Any", values: "Any", end: float) -> "Any":
    """The accelerations of a recorded displacement of the base, a cubic spline: they run straight between samples."""
    from scipy.interpolate import CubicSpline

    require(end <= times[-1] * (1.0 + 1e-12), "the record of the base's displacement ends at {end:6}",
            end=(float(times[-1]), Time), code="length", hint="give a shorter --duration")  # fmt: skip
    spline = CubicSpline(times, values - values[0])
    motion.begin = (0.0, float(spline(0.0, 1)))
    between = spline(0.5 * (times[1:] + times[:-1]))
    low, high = spline.c[3].min(), spline.c[3].max()
    low, high = min(low, values[-1] - values[0]), max(high, values[-1] - values[0])
    motion.overshoot = float(max(between.max() - high, low - between.min(), 0.0) / max(high - low, 1e-300))
    return spline(times, 2)


def _base(motion: Run, times: "Any", pulls: "Any") -> "tuple[Any, Any]":
    """Displacement and velocity of the base, whose acceleration runs straight from sample to sample."""
    if not motion.based:
        return np.zeros(len(times)), np.zeros(len(times))
    (place,), (speed,) = states_of_record(Oscillators(np.zeros(1), 0.0), times, pulls)
    return motion.begin[0] + motion.begin[1] * times + place, motion.begin[1] + speed


def _count(fastest: float, end: float, room: int) -> int:
    return int(min(max(FINE * fastest * end / (2.0 * math.pi), FEWEST), room))


def _lines(motion: Run, times: "Any", loads: "Any") -> "tuple[Any, Any, Any, Any]":
    slopes = np.diff(loads) / np.diff(times)
    return (*motion.modal.under_lines(motion.weights, times, loads, motion.start()), loads, (slopes, slopes))


def _refined(times: "Any", loads: "Any", end: float, fastest: float, room: int) -> "tuple[Any, Any]":
    """A record up to `end`, at rest after its own, with steps between its samples that the fastest mode needs."""
    inside = times < end
    whole = np.append(times[inside], end)
    require(len(whole) <= room, "the record has too many samples for so many masses", code="length",
            hint="give a shorter --duration")  # fmt: skip
    wanted = end / _count(fastest, end, room - len(whole) + 1)
    parts = [np.linspace(a, b, max(math.ceil((b - a) / wanted), 1), endpoint=False)
             for a, b in zip(whole[:-1].tolist(), whole[1:].tolist(), strict=True)]  # fmt: skip
    fine = np.append(np.concatenate(parts), end)
    return fine, np.interp(fine, times, loads, right=0.0)


def _sampled(motion: Run, load: "Any", end: float, fastest: float, room: int) -> None:
    """Under a formula: straight lines between more and more samples, and the limit of two step sizes."""
    moving = isinstance(load, MotionLaw)
    formula = load.base_motion if moving else load.force_law if isinstance(load, ForceLaw) else load.base_law
    law = law_of(formula, (), ("t",))
    count, before, limit = _count(fastest, end, room // 2), None, None
    close, known = CLOSE, {}
    if drawing():
        # samples meet at the same times
        count, close, known = 1 << (count.bit_length() - 1), SAMPLED, kept()
    while True:
        times = np.linspace(0.0, end, count + 1)
        if (count, end) not in known:
            known[count, end] = _values(law, times.tolist(), 2 if moving else 0)
        values = known[count, end]
        loads = values[-1]
        if moving:
            motion.begin = (float(values[0, 0]), float(values[1, 0]))
        steps = (*_lines(motion, times, loads)[:2], *(() if moving else _base(motion, times, loads)))
        if before is not None:
            # errors fall with the square of the step
            finer = [part[..., ::2] for part in steps]
            better = [fine + (fine - coarse) / 3.0 for fine, coarse in zip(finer, before, strict=True)]
            other = finer[0] - better[0] if limit is None else better[0][:, ::2] - limit[0]
            off = float(abs(other).max() / max(abs(better[0]).max(), 1e-300))
            if off <= close or 2 * count > room:
                break
            limit = better
        before, count = steps, 2 * count
    motion.rough = off
    motion.method += f"; a formula by straight lines, the limits of two step sizes differ by {off:.1e}"
    slopes = np.gradient(loads, times, edge_order=2)[::2]
    base = tuple(values[:2, ::2]) if moving else tuple(better[2:])
    steps = (better[0], better[1], loads[::2], (slopes[:-1], slopes[1:]))
    motion.follow(times[::2], steps, base, fastest)


def _values(law: "Any", times: "list[float]", order: int) -> "Any":
    """The formula and its derivatives up to an order, one in each row, at each time."""
    rows = np.zeros((order + 1, len(times)))
    for nth, t in enumerate(times):
        try:
            value = law(t=Jet.variable(t, order)) if order else law(t=t)
            parts = [value.derivative(k) for k in range(order + 1)] if isinstance(value, Jet) else [value]
            rows[: len(parts), nth] = parts
        except (ArithmeticError, ValueError):
            rows[0, nth] = math.nan
        require(bool(np.isfinite(rows[:, nth]).all()), "the formula has no value{or_slope} at {t:4}", t=(t, Time),
                or_slope=", or no acceleration," if order else "", code="no-value",
                hint="for example sin(9*t)/(t + 1e-9)")  # fmt: skip
    return rows


def reaches(model: "System", motion: Run) -> "tuple[Reach, ...]":
    """How far each coordinate moves, by cubics between the steps."""
    modal, times = motion.modal, motion.times
    jerks = [modal.shapes.T @ modal.accelerations(motion.weights, motion.v[:, cut], motion.a[:, cut], slope)
             for cut, slope in ((slice(-1), motion.slopes[0]), (slice(1, None), motion.slopes[1]))]  # fmt: skip
    if motion.based:
        jerks = [jerk + slope for jerk, slope in zip(jerks, motion.slopes, strict=True)]
    place, when = _largest(times, motion.places, motion.speeds[:, :-1], motion.speeds[:, 1:])
    speed, _ = _largest(times, motion.speeds, motion.relative[:, :-1], motion.relative[:, 1:])
    push, _ = _largest(times, motion.absolute, *jerks)
    columns = [part.tolist() for part in (place, when, speed, push)]
    in_space: list[Any] = [None] * len(place)
    if motion.moved:
        speeds = motion.speeds + motion.base_speed
        in_space = _largest(times, motion.places + motion.base_place, speeds[:, :-1], speeds[:, 1:])[0].tolist()
    rows = zip(*columns, in_space, strict=True)
    return tuple(Reach(model.names[kept], *row) for kept, row in zip(model.kept, rows, strict=True))


def _largest(times: "Any", values: "Any", left: "Any", right: "Any") -> "tuple[Any, Any]":
    """Largest value in size of each row, and when, by the cubic through both ends of each step with their slopes."""
    each, at = np.arange(len(values)), abs(values).argmax(axis=1)
    best, when = values[each, at], times[at]
    row, step = np.nonzero(left * right < 0.0)
    h = (times[1:] - times[:-1])[step]
    start, a, b = values[row, step], left[row, step] * h, right[row, step] * h
    rise = values[row, step + 1] - start
    square, cube = 3.0 * rise - 2.0 * a - b, a + b - 2.0 * rise
    s = a / (a - b)
    for _ in range(NEWTON):
        bend = 2.0 * square + 6.0 * cube * s
        s = np.clip(s - (a + s * (2.0 * square + 3.0 * cube * s)) / np.where(bend == 0.0, np.inf, bend), 0.0, 1.0)
    tops = start + s * (a + s * (square + cube * s))
    order = np.argsort(abs(tops), kind="stable")
    # the last of each row stays: its largest
    high, moment = np.zeros(len(values)), np.zeros(len(values))
    high[row[order]], moment[row[order]] = tops[order], (times[step] + s * h)[order]
    larger = abs(high) > abs(best)
    return np.where(larger, high, best), np.where(larger, moment, when)
