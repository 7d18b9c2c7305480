"""Largest and smallest value of a response over a pulse or a record: found between the samples, not at them."""

import math

import numpy as np

from dynamics_cli.errors import require
from dynamics_cli.quantities import Ratio
from dynamics_cli.vibration.shocks.pulses import Oscillators, Piece, slopes
from dynamics_cli.vibration.shocks.recursion import EVEN, even, followed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# Looks at each cycle of the oscillator or of the load.
LOOKS = 16
NEWTON = 6
MOST_CYCLES = 1e5
# Samples of a record that are handled at once.
BLOCK = 2048
# Of more oscillators than these, a pass for each step costs less than passes over all steps.
FEW = 32


class Extremes:
    """Maxima and minima with their times, oscillator by oscillator, of y = α·z + β·ż."""

    def __init__(self, count: int) -> None:
        self.high, self.low = np.zeros(count), np.zeros(count)
        self.high_time, self.low_time = np.zeros(count), np.zeros(count)

    def take(self, rows: "Any", values: "Any", times: "Any") -> None:
        """Values at times, of the oscillators `rows`."""
        for row, value, time in zip(np.ravel(rows), np.ravel(values), np.ravel(times), strict=True):
            if value > self.high[row]:
                self.high[row], self.high_time[row] = value, time
            elif value < self.low[row]:
                self.low[row], self.low_time[row] = value, time


def over_piece(
    of: Oscillators, start: "tuple[Any, Any]", piece: Piece, length: float, mix: "Any", into: Extremes
) -> None:
    """Extremes over a piece: sign changes of the derivative at close looks, each refined by Newton's method."""
    times = _looks(of, piece, length)
    column = Oscillators(of.omega[:, None], of.zeta)
    z0, v0 = start[0][:, None], start[1][:, None]
    alpha, beta = np.broadcast_to(mix[0], of.omega.shape), np.broadcast_to(mix[1], of.omega.shape)
    y, dy, _ = slopes(column, column.after(z0, v0, piece, times), piece, times, (alpha[:, None], beta[:, None]))
    rows = np.arange(len(of.omega))
    into.take(rows, y[:, 0], np.full(len(rows), piece.start))
    into.take(rows, y[:, -1], np.full(len(rows), piece.start + length))
    row, cell = np.nonzero(dy[:, :-1] * dy[:, 1:] < 0.0)
    if not len(row):
        return
    low, high = times[cell], times[cell + 1]
    t = low + (high - low) * dy[row, cell] / (dy[row, cell] - dy[row, cell + 1])
    at = _settled(of.some(row), (start[0][row], start[1][row]), piece, t, (low, high), (alpha[row], beta[row]))
    into.take(row, at[1], piece.start + at[0])


def _looks(of: Oscillators, piece: Piece, length: float) -> "Any":
    """Times at which a piece is looked at: even ones; close together at first where heavy damping creeps."""
    fastest = float(np.max(of.omega))
    cycles = max(fastest if of.zeta <= 1.0 else 0.0, piece.p) * length / (2.0 * math.pi)
    require(
        cycles <= MOST_CYCLES,
        "the load lasts {count} periods of the oscillator",
        count=(float(cycles), Ratio),
        code="slow-load",
        hint="so slow a load acts like one at rest: the displacement is force over stiffness",
    )
    even = np.linspace(0.0, length, max(int(LOOKS * cycles) + 1, LOOKS) + 1)
    if of.zeta <= 1.0:
        return even
    early = np.geomspace(min(1.0 / (of.zeta * fastest * LOOKS), 0.5 * length), length, LOOKS * LOOKS)
    return np.union1d(even, early[:-1])


def _settled(
    of: Oscillators, start: "tuple[Any, Any]", piece: Piece, t: "Any", ends: "tuple[Any, Any]", mix: "Any"
) -> "tuple[Any, Any]":
    """Times of extremes between `ends` by Newton's method, and the values there."""
    for _ in range(NEWTON):
        _, first, second = slopes(of, of.after(*start, piece, t), piece, t, mix)
        with np.errstate(all="ignore"):
            t = np.clip(t - np.where(second != 0.0, first / second, 0.0), *ends)
    return t, slopes(of, of.after(*start, piece, t), piece, t, mix)[0]


def over_rest(of: Oscillators, start: "tuple[Any, Any]", at: float, mix: "Any", into: Extremes) -> None:
    """Extremes of the free vibration that follows: the first of each sign are the largest."""
    y, dy, _ = slopes(of, start, Piece(at, math.inf), 0.0, mix)
    damped = of.damped.real
    first = np.arctan2(damped * dy, of.sigma * dy + of.omega * of.omega * y)
    first = np.where(first <= 0.0, first + math.pi, first)
    rows = np.arange(len(of.omega))
    into.take(rows, y, np.full(len(rows), at))
    for half in (0.0, 1.0):
        t = (first + half * math.pi) / damped
        s, c = of.kernel(t)
        into.take(rows, y * c + (dy + of.sigma * y) * s, at + t)


def over_record(of: Oscillators, times: "Any", loads: "Any", mix: "Any", into: Extremes) -> "tuple[Any, Any]":
    """Extremes over a record of straight lines between samples, and the state at its end."""
    state = np.zeros((2, len(of.omega)))
    mixed = tuple(np.broadcast_to(part, of.omega.shape) for part in mix)
    for begin in range(0, len(times) - 1, BLOCK):
        block = slice(begin, begin + BLOCK + 1)
        states = _stepped(of, times[block], loads[block], state)
        state = states[-1]
        _within(of, times[block], loads[block], states.transpose(1, 0, 2), mixed, into)
    return state[0], state[1]


def _factors(of: Oscillators, step: float) -> "tuple[Any, ...]":
    """What state and load at the start of a step give at its end."""
    zero, one = np.zeros_like(of.omega), np.ones_like(of.omega)
    nothing = Piece(0.0, step)
    cases = (
        (one, zero, nothing), (zero, one, nothing), (zero, zero, Piece(0.0, step, a=1.0)),
        (zero, zero, Piece(0.0, step, b=1.0)),
    )  # fmt: skip
    return tuple(np.array(of.after(*case, step)) for case in cases)


def _within(of: Oscillators, times: "Any", loads: "Any", states: "Any", mix: "Any", into: Extremes) -> None:
    """Extremes at and between the samples of a block."""
    alpha, beta = mix
    z, v = states
    rate = of.second(z, v, loads[:, None])
    y, dy = alpha * z + beta * v, alpha * v + beta * rate
    rows = np.arange(len(of.omega))
    for pick in (y.argmax(axis=0), y.argmin(axis=0)):
        into.take(rows, y[pick, rows], times[pick])
    cell, row = np.nonzero(dy[:-1] * dy[1:] < 0.0)
    # only cells beside a sample that comes near to an extreme can hold a larger one
    reach = np.maximum(abs(y[cell, row]), abs(y[cell + 1, row]))
    steps = times[cell + 1] - times[cell]
    room = 0.5 * np.maximum(abs(dy[cell, row]), abs(dy[cell + 1, row])) * steps
    worth = reach + room > np.minimum(into.high[row], -into.low[row])
    cell, row, steps = cell[worth], row[worth], steps[worth]
    if not len(row):
        return
    piece = Piece(0.0, math.inf, a=loads[cell], b=(loads[cell + 1] - loads[cell]) / steps)
    t = steps * dy[cell, row] / (dy[cell, row] - dy[cell + 1, row])
    at = _settled(of.some(row), (z[cell, row], v[cell, row]), piece, t, (0.0, steps), (alpha[row], beta[row]))
    into.take(row, at[1], times[cell] + at[0])


def states_of_record(of: Oscillators, times: "Any", loads: "Any") -> "tuple[Any, Any]":
    """Displacements and velocities at every sample of a record of straight lines, an oscillator in each row."""
    made = _stepped(of, times, loads, np.zeros((2, len(of.omega))))
    return made[:, 0].T, made[:, 1].T


def _stepped(of: Oscillators, times: "Any", loads: "Any", state: "Any") -> "Any":
    """The states (samples, 2, oscillators) at every sample, from that at the first one."""
    steps = np.diff(times)
    slopes_of_load = np.diff(loads) / steps
    if len(of.omega) <= FEW and even(steps):
        of_z, of_v, of_load, of_slope = _factors(of, float(times[-1] - times[0]) / len(steps))
        states = np.empty((len(of.omega), len(times), 2))
        states[:, 0] = state.T
        states[:, 1:] = of_load.T[:, None] * loads[:-1, None] + of_slope.T[:, None] * slopes_of_load[:, None]
        return followed(states, np.stack([of_z.T, of_v.T], axis=-1)).transpose(1, 2, 0)
    made = np.empty((len(times), *state.shape))
    made[0] = state
    last_step = -1.0
    factors: tuple[Any, ...] = ()
    for i, step in enumerate(steps.tolist()):
        if abs(step - last_step) > EVEN * step:
            last_step, factors = step, _factors(of, step)
        of_z, of_v, of_load, of_slope = factors
        made[i + 1] = of_z * made[i, 0] + of_v * made[i, 1] + (of_load * loads[i] + of_slope * slopes_of_load[i])
    return made
