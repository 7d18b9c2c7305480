"""Runs of several masses over time: steps, peaks between them, work and losses."""

import math

import numpy as np

from dynamics_cli.errors import require
from dynamics_cli.numerics.expressions.laws import law_of
from dynamics_cli.numerics.fitting.records_file import read_load
from dynamics_cli.quantities import Time
from dynamics_cli.vibration.systems.loads import BaseLaw, ForceLaw, Reach, Recorded, SineBase, SineForce
from dynamics_cli.vibration.systems.modal import Modal

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.vibration.systems.inputs import System

# Steps in a period of the fastest motion, the fewest, the most, and the most numbers of all coordinates.
FINE, FEWEST, MOST, ROOM = 40, 400, 60_000, 30_000_000
# A formula is sampled more and more closely until two step sizes agree to this.
CLOSE = 1e-7
NEWTON = 4


class Run:
    """Modes, velocities and accelerations at every step, and those of the coordinates."""

    def __init__(self, of: Modal, weights: "Any", based: bool) -> None:
        self.of, self.weights, self.based = of, weights, based
        self.rough = 0.0
        self.method = "each mode in closed form from step to step"
        if of.full is not None:
            self.method = "exponential of the state matrix of all modes together"

    def follow(self, times: "Any", steps: "tuple[Any, Any, Any, Any]", fastest: float) -> None:
        """Take the modes, their velocities, the loads and the two slopes of the load in each step."""
        of = self.of
        self.times, (self.q, self.v, self.loads, self.slopes) = times, steps
        step = float(np.diff(times).max())
        self.followed_to = 1.0 / (0.5 * FINE * step)
        self.followed = fastest <= 2.0 * math.pi * self.followed_to
        self.a = of.accelerations(self.weights, self.q, self.v, self.loads)
        self.places, self.speeds = of.shapes.T @ self.q, of.shapes.T @ self.v
        self.relative = of.shapes.T @ self.a
        self.absolute = self.relative + (self.loads if self.based else 0.0)

    def picked(self, count: int) -> "Any":
        """Places of about so many steps, the first and the last among them."""
        return np.unique(np.linspace(0, len(self.times) - 1, count).round().astype(int))

    def energies(self) -> "tuple[float, float, float]":
        """Work of the load, losses, and what is stored at the end, by the trapezoidal rule with its end correction."""
        of, h = self.of, np.diff(self.times)
        powers = (self.weights @ self.v) * self.loads
        rates = (self.weights @ self.a) * self.loads
        into = [rates[:-1] + (self.weights @ self.v[:, :-1]) * self.slopes[0],
                rates[1:] + (self.weights @ self.v[:, 1:]) * self.slopes[1]]  # fmt: skip
        losses, change = of.losses(self.v, self.v), 2.0 * of.losses(self.v, self.a)
        work, lost = (
            float((0.5 * h * (f[:-1] + f[1:]) + h * h / 12.0 * (left - right)).sum())
            for f, left, right in ((powers, *into), (losses, change[:-1], change[1:]))
        )
        held = 0.5 * (self.v**2 + (of.omega[:, None] * self.q) ** 2).sum(axis=0)
        self.largest_energy = max(abs(work), abs(lost), float(held.max()))
        return work, lost, float(held[-1])


def run(those: "System", damping_ratio: "float | None", load: "Any", force_at: str, duration: "float | None") -> Run:
    """The motion from rest under a load."""
    of = Modal(those, damping_ratio)
    based = isinstance(load, SineBase | BaseLaw)
    record: Any = None
    if isinstance(load, Recorded):
        *record, based = read_load(load.file)
        duration = float(record[0][-1]) if duration is None else duration
    require(duration is not None and duration > 0.0, "how long is the motion followed?", code="no-duration",
            hint="give --duration, for example 2 s")  # fmt: skip
    require(based or bool(force_at), "where does the force act?", code="no-place", hint="give --force-at")
    made = Run(of, of.base if based else of.shapes[:, those.moving(force_at)], based)
    end, fastest = float(duration), float(of.omega.max())  # type: ignore[arg-type]
    room = min(MOST, ROOM // len(of.omega))
    if isinstance(load, SineForce | SineBase):
        require(load.frequency > 0.0, "the frequency is zero: nothing vibrates", code="at-rest",
                hint='a constant force is a formula: --force-law "50 N"')  # fmt: skip
        rate = 2.0 * math.pi * load.frequency
        fastest = max(fastest, rate)
        size = load.force if isinstance(load, SineForce) else load.base_acceleration
        times = np.linspace(0.0, end, _count(fastest, end, room) + 1)
        loads, slopes = size * np.cos(rate * times), -size * rate * np.sin(rate * times)
        steps = (*of.under_sine(made.weights, size, rate, times), loads, (slopes[:-1], slopes[1:]))
        made.follow(times, steps, fastest)
    elif record is not None:
        times, loads = _refined(record[0], record[1], end, fastest, room)
        made.follow(times, _lines(made, times, loads), fastest)
    else:
        _sampled(made, load, end, fastest, room)
    require(bool(abs(made.loads).max() > 0.0), "the load is zero: nothing moves", code="no-load")
    return made


def _count(fastest: float, end: float, room: int) -> int:
    return int(min(max(FINE * fastest * end / (2.0 * math.pi), FEWEST), room))


def _lines(made: Run, times: "Any", loads: "Any") -> "tuple[Any, Any, Any, Any]":
    slopes = np.diff(loads) / np.diff(times)
    return (*made.of.under_lines(made.weights, times, loads), loads, (slopes, slopes))


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


def _sampled(made: Run, load: "Any", end: float, fastest: float, room: int) -> None:
    """Under a formula: straight lines between more and more samples, and the limit of two step sizes."""
    law = law_of(load.force_law if isinstance(load, ForceLaw) else load.base_law, (), ("t",))
    count, before = _count(fastest, end, room // 2), None
    while True:
        times = np.linspace(0.0, end, count + 1)
        loads = _values(law, times.tolist())
        steps = _lines(made, times, loads)
        if before is not None:
            finer = [steps[0][:, ::2], steps[1][:, ::2]]
            off = float(abs(finer[0] - before[0]).max() / max(abs(finer[0]).max(), 1e-300))
            if off <= CLOSE or 2 * count > room:
                # errors fall with the square of the step
                q, v = (fine + (fine - coarse) / 3.0 for fine, coarse in zip(finer, before, strict=True))
                made.rough = off
                made.method += f"; a formula by straight lines, two step sizes differ by {off:.1e}"
                slopes = np.gradient(loads, times, edge_order=2)[::2]
                made.follow(times[::2], (q, v, loads[::2], (slopes[:-1], slopes[1:])), fastest)
                return
        before, count = steps[:2], 2 * count


def _values(law: "Any", times: "list[float]") -> "Any":
    """The formula at each time."""
    made = []
    for t in times:
        try:
            made.append(float(law(t=t)))
        except (ArithmeticError, ValueError):
            made.append(math.nan)
        require(math.isfinite(made[-1]), "the formula has no value at {t:4}", t=(t, Time), code="no-value",
                hint="for example sin(9*t)/(t + 1e-9)")  # fmt: skip
    return np.array(made)


def reaches(those: "System", done: Run) -> "tuple[Reach, ...]":
    """How far each coordinate moves, by cubics between the steps."""
    of = done.of
    jerks = [of.shapes.T @ of.accelerations(done.weights, done.v[:, cut], done.a[:, cut], slope)
             for cut, slope in ((slice(-1), done.slopes[0]), (slice(1, None), done.slopes[1]))]  # fmt: skip
    if done.based:
        jerks = [one + slope for one, slope in zip(jerks, done.slopes, strict=True)]
    place, when = _largest(done.times, done.places, done.speeds[:, :-1], done.speeds[:, 1:])
    speed, _ = _largest(done.times, done.speeds, done.relative[:, :-1], done.relative[:, 1:])
    push, _ = _largest(done.times, done.absolute, *jerks)
    rows = zip(*(one.tolist() for one in (place, when, speed, push)), strict=True)
    return tuple(Reach(those.names[kept], *row) for kept, row in zip(those.kept, rows, strict=True))


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
