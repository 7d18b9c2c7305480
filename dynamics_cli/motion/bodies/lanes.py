"""Systems of one build and many numbers, side by side: what a scene has as numbers are arrays here, lanes last."""

from copy import copy

import numpy as np

from dynamics_cli.errors import require
from dynamics_cli.motion.bodies.forces import PointLoad, SpringForce, TorqueLoad
from dynamics_cli.motion.bodies.frame import Frame
from dynamics_cli.motion.rods import solved

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from dynamics_cli.motion.bodies.system import System

# Lanes and times of one block of forces: larger arrays leave the processor's cache.
BLOCK = 8192
# Numbers of conditions and forces that may differ from lane to lane.
NUMBERS = ("way", "angle", "k", "free", "d", "sizes", "size")


class Lanes:
    """Systems whose names, joints and loads are those of the first; times are those of each lane."""

    def __init__(self, systems: "Sequence[System]") -> None:
        self.one = one = systems[0]
        alike = all(each.kept == one.kept and len(each.forces) == len(one.forces) for each in systems)
        columns: dict[int, set[int]] = {}
        for row, column in [place for part in one.parts for place in (*part.places(), *(x[:2] for x in part.fixed()))]:
            columns.setdefault(row, set()).add(column)
        held = [column for row in one.kept if len(columns[row]) == 1 for column in columns[row]]
        self.masses = np.array([each.masses for each in systems]).T
        # the moment of a slider that cannot turn does not count
        self.masses[held] = np.where(self.masses[held] > 0.0, self.masses[held], 1.0)
        require(alike and bool((self.masses > 0.0).all()), "not alike", code="lanes")
        self.easiness = 1.0 / self.masses
        self.common = [[columns[row] & columns[other] for other in one.kept[: k + 1]] for k, row in enumerate(one.kept)]
        self.weights = np.array([each.weights for each in systems]).T
        self.sizes = np.array([each.size for each in systems])
        self.units = np.array([(each.force, each.force, each.torque) for each in systems]).T
        self.spots = [
            (spots[0][0], np.array([x for _, x, _ in spots]), np.array([y for _, _, y in spots]))
            for spots in zip(*(each.spots for each in systems), strict=True)
        ]
        self.forces = [_stacked(forces) for forces in zip(*(each.forces for each in systems), strict=True)]
        parts = [_stacked(parts) for parts in zip(*(each.parts for each in systems), strict=True)]
        self.joints = [copy(joint) for joint in one.joints]
        for joint in self.joints:
            joint.parts = [parts[one.parts.index(part)] for part in joint.parts]
        self.parts, self.driven = parts, [part for part in parts if getattr(part, "motion", None) is not None]
        self.fixed = [place for part in parts for place in part.fixed()]
        self.places = [place for part in parts for place in part.places()]

    def frame(self, y: "Any") -> Frame:
        """The bodies in states (numbers, lanes)."""
        return Frame(self.one.n, self.spots, list(y), np.cos, np.sin)

    def _conditions(self, t: "Any", f: Frame) -> "tuple[list[dict[int, Any]], list[Any]]":
        """Derivatives of the conditions that are kept, by row and column, and what J·a must be."""
        values: list[Any] = []
        right: list[Any] = []
        for part in self.parts:
            part.add(t, f, values, right)
        rows: list[dict[int, Any]] = [{} for _ in right]
        for row, column, value in self.fixed:
            rows[row][column] = value
        for (row, column), value in zip(self.places, values, strict=True):
            rows[row][column] = value
        return [rows[row] for row in self.one.kept], [right[row] for row in self.one.kept]

    def _multipliers(self, rows: "list[dict[int, Any]]", right: "list[Any]") -> "list[Any]":
        """λ of J·M⁻¹·Jᵀ·λ = right."""
        light = [{c: value * self.easiness[c] for c, value in row.items()} for row in rows]
        matrix = [
            [sum([row[c] * other[c] for c in shared]) for other, shared in zip(rows, line, strict=False)]
            for row, line in zip(light, self.common, strict=True)
        ]
        return solved(matrix, right)

    def solved(self, t: "Any", f: Frame) -> "tuple[list[Any], list[Any], list[Any]]":
        """Accelerations, multipliers, and the powers of loads and dampers."""
        rows, right = self._conditions(t, f)
        none = np.zeros_like(f.q[0])
        out, power = [weight + none for weight in self.weights], [none.copy() for _ in range(2)]
        for force in self.forces:
            force.add(t, f, out, power)
        wanted = [sum(value * out[c] * self.easiness[c] for c, value in row.items()) - must
                  for row, must in zip(rows, right, strict=True)]  # fmt: skip
        multipliers = self._multipliers(rows, wanted)
        for row, size in zip(rows, multipliers, strict=True):
            for column, value in row.items():
                out[column] = out[column] - value * size
        return [push * easy for push, easy in zip(out, self.easiness, strict=True)], multipliers, power

    def rate(self, t: "Any", y: "Any") -> "Any":
        """Rates of states (numbers, lanes)."""
        end, one, out = self.one.end, self.one, np.empty_like(y)
        out[:end] = y[end : 2 * end]
        out[end : 2 * end], multipliers, out[-2:] = self.solved(t, self.frame(y))
        out[-3] = 0.0
        for part in self.driven:
            speed = part.motion.law(t)[1]
            if part.motion.of_rate:
                out[2 * end + part.phase] = speed
            if part.row in one.place:
                out[-3] -= multipliers[one.place[part.row]] * speed
        return out

    def put_back(self, t: "Any", y: "Any") -> float:
        """Move states onto their conditions, in place, by one step; the largest gap there was."""
        if not self.one.m:
            return 0.0
        f, end = self.frame(y), self.one.end
        gaps = [gap for part in self.parts for gap in part.gap(t, f)]
        speeds = [rate for part in self.parts for rate in part.drive(t)]
        rows, _ = self._conditions(t, f)
        missed = [gaps[row] for row in self.one.kept]
        slipped = [sum(value * y[end + c] for c, value in row.items()) - speeds[k]
                   for k, row in zip(self.one.kept, rows, strict=True)]  # fmt: skip
        for start, off in ((0, missed), (end, slipped)):
            for row, size in zip(rows, self._multipliers(rows, off), strict=True):
                for column, value in row.items():
                    y[start + column] -= value * size * self.easiness[column]
        return float(np.abs(missed).max())

    def joint_forces(self, t: "Any", y: "Any") -> "list[Any]":
        """Sizes of the forces of every joint, in N."""
        f = self.frame(y)
        found = self.solved(t, f)[1]
        none = np.zeros_like(f.q[0])
        every = [found[self.one.place[row]] if row in self.one.place else none for row in range(self.one.rows)]
        return [np.hypot(*joint.force(f, every)[:2]) * self.units[0] + none for joint in self.joints]

    def forces_over(self, times: "Any", states: "Any") -> "list[Any]":
        """Sizes of the forces of every joint (lanes, times), for states (times, numbers, lanes)."""
        step = max(1, BLOCK // times.shape[1])
        parts = [
            self.joint_forces(times[k : k + step], states[k : k + step].swapaxes(0, 1))
            for k in range(0, len(times), step)
        ]
        return [np.concatenate(force).T for force in zip(*parts, strict=True)]


class _Spring(SpringForce):
    """Springs of many lanes; one without length pulls nowhere."""

    def length(self, f: Frame) -> "Any":
        """Distance between the ends of each spring."""
        return np.hypot(f.x[self.b] - f.x[self.a], f.y[self.b] - f.y[self.a])

    def share(self, f: Frame, power: "list[Any]") -> "Any":
        """Pull over length of each spring; the power of the dampers is added to `power`."""
        a, b, length = self.a, self.b, np.maximum(self.length(f), 1e-300)
        along = (f.x[b] - f.x[a]) * (f.vx[b] - f.vx[a]) + (f.y[b] - f.y[a]) * (f.vy[b] - f.vy[a])
        opening = along / length
        power[1] += self.d * opening * opening
        return self.k + (self.d * opening - self.k * self.free) / length


class _Law:
    """The prescribed motions of lanes."""

    def __init__(self, motions: "Sequence[Any]") -> None:
        self.motions, self.of_rate, self.knots = motions, motions[0].of_rate, ()

    def law(self, t: "Any") -> "Any":
        """Value, rate and second derivative of each at its time, or at many (times, lanes)."""
        if t.ndim > 1:
            return np.array([self.law(row) for row in t]).swapaxes(0, 1)
        return np.array([one.law(when) for one, when in zip(self.motions, t.tolist(), strict=True)]).T


def _stacked(parts: "Sequence[Any]") -> "Any":
    """One condition or force of all lanes."""
    made = copy(parts[0])
    if isinstance(made, SpringForce):
        made.__class__ = _Spring
    for name in NUMBERS:
        if hasattr(made, name):
            values = np.array([getattr(part, name) for part in parts])
            setattr(made, name, values.T)
    if getattr(made, "motion", None) is not None:
        made.motion = _Law([part.motion for part in parts])
    for name in {PointLoad: ("x", "y"), TorqueLoad: ("torque",)}.get(type(made), ()):
        if getattr(made, name):
            setattr(made, name, _each([getattr(part, name) for part in parts]))
    return made


def _each(laws: "Sequence[Any]") -> "Any":
    """Forces given by formulas or tables: one formula for all lanes, or each lane by its own."""
    formula = getattr(laws[0], "formula", None)
    if formula is not None and all(getattr(law, "formula", None) == formula for law in laws):
        return laws[0]

    def at(given: "dict[str, Any]") -> "Any":
        if given["t"].ndim > 1:
            return np.array([at({name: values[k] for name, values in given.items()}) for k in range(len(given["t"]))])
        columns = {name: values.tolist() for name, values in given.items()}
        return np.array([law({name: values[k] for name, values in columns.items()}) for k, law in enumerate(laws)])

    return at
