"""A linkage from one pose on over its first driver's range, without a jump to another assembly."""

from math import inf, sin, sqrt

import numpy as np

from dynamics_cli.linkage.scenes.pose import is_free
from dynamics_cli.numerics.linkages.dyads import SAME, refined
from dynamics_cli.numerics.linkages.records import GROUND
from dynamics_cli.numerics.linkages.system import Certificate, System

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# Steps in radians, or shares of the scene's size where a pin is pushed.
FIRST, LARGEST, SMALLEST = 0.1, 0.5, 1e-9
GROWTH = 1.8
# Ways over a change point, tried from the smallest on.
LEAPS = (1e-5, 1e-4, 1e-3, 1e-2)
# A prediction over a smooth piece misses by less than this fraction of the distance; a larger miss is a jump.
SMOOTH = 0.2
MOST_STEPS = 4000


class Continuation:
    """The pose at the driver's position, moved on by `to` in steps each of which is proved to be without a jump."""

    def __init__(self, system: System, q: "Any") -> None:
        self.start = system
        self.scale = system.scale if system.scene.drivers[0].point else 1.0
        self.at = 0.0
        self.system, self.q = system, q
        self.step = FIRST
        self.steps = 0
        # repeated conditions allow no proof: such linkages are followed by prediction alone
        self.proves = len(system.rows) == system.size
        self.crossed: list[float] = []
        self.before: list[tuple[float, Any]] = []

    def to(self, target: float) -> bool:
        """Move the driver on to a shift from its first position; False where the linkage cannot follow."""
        target = target / self.scale
        sense = 1.0 if target > self.at else -1.0
        while self.at != target:
            remaining = abs(target - self.at)
            size = min(self.step, remaining)
            end = target if size == remaining else self.at + sense * size
            q = self._joined(end) if self.steps < MOST_STEPS else None
            if q is not None:
                self._accept(end, q)
                if size == self.step:
                    self.step = min(GROWTH * self.step, LARGEST)
                continue
            self.step = 0.5 * size
            if self.step < SMALLEST:
                if not self._leap(sense, target):
                    return False
                self.step = FIRST
        return True

    @property
    def shift(self) -> float:
        """How far the driver is from its first position."""
        return self.at * self.scale

    def _accept(self, end: float, q: "Any") -> None:
        if not self.before or abs(self.at - self.before[-1][0]) > 1e-4:
            self.before = [*self.before[-2:], (self.at, self.q)]
        self.at, self.q, self.system = end, q, self._moved(end)
        self.steps += 1

    def _moved(self, at: float) -> System:
        return self.start.moved(at * self.scale)

    def _slope(self) -> "Any":
        """Change of the pins for a change of the driver's position."""
        residuals = self.system.residuals(self.q)
        h = 1e-7
        change = (self._moved(self.at + h).residuals(self.q) - residuals) / h
        return np.linalg.lstsq(self.system.jacobian(self.q), -change)[0]

    def _joined(self, end: float) -> "Any | None":
        """The pose at the end of a step that is on the same motion, or nothing where this is not shown."""
        slope = self._slope()
        if not self.proves:
            return self._predicted(end, self.q + (end - self.at) * slope)
        middle = self._moved(0.5 * (self.at + end))
        centre, gap = refined(middle, self.q + 0.5 * (end - self.at) * slope)
        if gap > SAME:
            return None
        reach = self._reach(middle, centre, 0.5 * abs(end - self.at))
        if not np.linalg.norm(self.q - centre) < reach:
            return None
        q, gap = refined(self._moved(end), 2.0 * centre - self.q)
        return q if gap <= SAME and np.linalg.norm(q - centre) < reach else None

    def _reach(self, middle: System, centre: "Any", half: float) -> float:
        """Radius about the middle pose within which every position of the step has one solution; 0 if not shown."""
        jacobian = middle.jacobian(centre)
        if is_free(middle, jacobian):
            return 0.0
        inverse = np.linalg.inv(jacobian)
        proof = Certificate(middle, centre, jacobian)
        beta = float(np.linalg.norm(inverse, 2))
        moved, bent = self._drift(middle, centre, inverse, half), 0.0
        first = middle.scene.drivers[0]
        if not first.point and first.against != GROUND:
            row, pins = next(row for row in middle.rows if first in row), middle.positions(centre)
            bent = (
                beta
                * 2.0
                * sin(0.5 * half)
                * sqrt(2.0)
                * (abs(pins[row[2]] - pins[row[1]]) + abs(pins[row[4]] - pins[row[3]]))
            )
        if bent >= 1.0:
            return 0.0
        beta, step = beta / (1.0 - bent), (proof.step + moved) / (1.0 - bent)
        contraction = beta * proof.curve * step
        if contraction > 0.5:
            return 0.0
        return (1.0 + sqrt(1.0 - 2.0 * contraction)) / (beta * proof.curve) if proof.curve else inf

    @staticmethod
    def _drift(middle: System, centre: "Any", inverse: "Any", half: float) -> float:
        """How far Newton's first step goes at most, as the driver moves by half a step either way."""
        rows = [(index, row) for index, row in enumerate(middle.rows) if middle.scene.drivers[0] in row]
        columns = inverse[:, [index for index, _ in rows]]
        row = rows[0][1]
        if row[0] == "push":
            return float(np.linalg.norm(columns, 2) * abs(row[4]) * half)
        if row[0] == "turn":
            size, parts = abs(row[3]), [(1j * r[3]).imag if r[4] else (1j * r[3]).real for _, r in rows]
        else:
            pins = middle.positions(centre)
            turned = (pins[row[2]] - pins[row[1]]) * (pins[row[4]] - pins[row[3]]).conjugate() * np.exp(-1j * row[5])
            size, parts = abs(turned), [turned.real]
        # along the driver's own direction the linkage moves no faster than it does, also next to a change point
        along = float(np.linalg.norm(columns @ np.array(parts))) * sin(half)
        return float(along + np.linalg.norm(columns, 2) * size * 2.0 * sin(0.5 * half) ** 2)

    def _predicted(self, end: float, guess: "Any") -> "Any | None":
        """The pose near a prediction, where Newton moves little from it."""
        q, gap = refined(self._moved(end), guess)
        moved = float(np.linalg.norm(guess - self.q))
        return q if gap <= SAME and np.linalg.norm(q - guess) <= SMOOTH * moved + SAME else None

    def _leap(self, sense: float, target: float) -> bool:
        """Over a change point, along the smooth continuation of the last poses; False at a true limit."""
        if len(self.before) < 2:
            return False
        (_, past), (last_shift, last) = self.before[-2:]
        for leap in LEAPS:
            end = self.at + sense * leap
            if abs(end - self.at) > abs(target - self.at):
                end = target
            # a parabola through three poses
            times = (self.before[-2][0], last_shift, self.at)
            guess = sum(
                pose * np.prod([(end - t) / (times[i] - t) for j, t in enumerate(times) if j != i])
                for i, pose in enumerate((past, last, self.q))
            )
            q = self._predicted(end, guess)
            if q is not None and not is_free(self._moved(end), self._moved(end).jacobian(q)):
                self.crossed.append(self.shift + 0.5 * sense * leap * self.scale)
                self._accept(end, q)
                return True
        return False
