"""A linkage from one pose on over its first driver's range, without a jump to another assembly."""

import numpy as np

from dynamics_cli.linkage.scenes.pose import is_free
from dynamics_cli.numerics.linkages.dyads import refined
from dynamics_cli.numerics.linkages.system import System

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
# Residual of a closed pose, and what Newton may move at a step of next to nothing.
CLOSED, CLOSE = 1e-12, 1e-7
# A smaller share of the largest singular value is that of a change point or a limit.
SINGULAR = 1e-6
MOST_STEPS = 4000


class Continuation:
    """The pose at the driver's position, moved on by `to` in steps each of which keeps to one assembly."""

    def __init__(self, system: System, q: "Any") -> None:
        self.start = system
        self.scale = system.scale if system.scene.drivers[0].point else 1.0
        self.at = 0.0
        self.system, self.q = system, q
        self.step = FIRST
        self.steps = 0
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
        """The pose at the end of a step on the same motion, or nothing where this is not clear.

        Where two assemblies meet the Jacobian is singular and its determinant changes sign from one to the other: a
        step that keeps the sign, and on which Newton moves little from the prediction, has not changed between them.
        """
        q = self._predicted(end, self.q + (end - self.at) * self._slope())
        if q is None:
            return None
        before, after = self.system.jacobian(self.q), self._moved(end).jacobian(q)
        if len(before) != len(self.q):
            # repeated conditions have no determinant: such linkages follow the prediction alone
            return q
        values = np.linalg.svd(after, compute_uv=False)
        clear = values[-1] > SINGULAR * values[0]
        return q if clear and np.linalg.slogdet(before)[0] == np.linalg.slogdet(after)[0] else None

    def _predicted(self, end: float, guess: "Any") -> "Any | None":
        """The pose near a prediction, where Newton moves little from it."""
        q, gap = refined(self._moved(end), guess)
        moved = float(np.linalg.norm(guess - self.q))
        return q if gap <= CLOSED and np.linalg.norm(q - guess) <= SMOOTH * moved + CLOSE else None

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
