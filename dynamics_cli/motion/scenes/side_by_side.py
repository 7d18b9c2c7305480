"""Many scenes of one build integrated side by side, for samples of uncertain inputs."""

import numpy as np

from dynamics_cli.errors import DynamicsError
from dynamics_cli.motion.bodies.lanes import Lanes
from dynamics_cli.motion.bodies.start import Start
from dynamics_cli.motion.peaks import peaks
from dynamics_cli.motion.runs import samples_of
from dynamics_cli.motion.scenes.runs import SAMPLED, Runs, runs_of
from dynamics_cli.motion.scenes.scene import SceneMotion, sampled, scene
from dynamics_cli.motion.scenes.states import moment_of
from dynamics_cli.progress import going
from dynamics_cli.sampling import cost, kept, missed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    Given = dict[str, Any]

# Fewer are faster one by one.
FEWEST = 12
# Gaps of joints, in sizes of the scene, that are put right after a step.
DRIFT = 1e-11
# A tolerance that is enough for most samples; what it may put their results off by, in their deviations; and the share
# of a number below which its deviation is rounding.
ROUGH, ENOUGH, STEADY = 1e-6, 1e-2, 1e-10
# Seconds that a rate takes for each number of a state and condition, and for that of each case; that a case takes for
# its start, and for a rate where it goes alone.
RATE, STARTED, ALONE = (4e-5, 1e-7), 1e-3, 6e-5


def scenes(cases: "Sequence[Given]") -> "list[SceneMotion | Exception]":
    """The numbers of each scene, or the error that refuses it."""
    made: list[Any] = [None] * len(cases)
    started: dict[int, tuple[Start, Given]] = {}
    for row, parameters in enumerate(cases):
        given = {**(scene.__kwdefaults__ or {}), **parameters}
        try:
            started[row] = Start(given["scene"], given["gravity"]), given
        except (DynamicsError, ArithmeticError) as error:
            made[row] = error
    _solve(started, made)
    return made


def _solve(cases: "dict[int, tuple[Start, Given]]", made: "list[Any]") -> None:
    """All side by side, or halves of them where one cannot go on; few, and those not alike, one by one."""
    rows = list(cases)
    if len(rows) >= FEWEST:
        try:
            for row, result in zip(rows, _together(list(cases.values())), strict=True):
                made[row] = result
        except (DynamicsError, ArithmeticError):
            half = len(rows) // 2
            for part in (rows[:half], rows[half:]):
                _solve({row: cases[row] for row in part}, made)
        return
    for row in rows:
        given = dict(cases[row][1])
        try:
            made[row] = scene(given.pop("scene"), **given)
            system = runs_of(cases[row][1]["scene"], given["gravity"], given["duration"]).system
            cost(0.0, system.calls * ALONE, 1)
        except (DynamicsError, ArithmeticError) as error:
            made[row] = error


def _together(cases: "list[tuple[Start, Given]]") -> "list[SceneMotion]":
    starts, given = [start for start, _ in cases], [given for _, given in cases]
    lanes = Lanes([start.system for start in starts])
    times = np.array([each["duration"] for each in given])
    shown = np.array([each["duration"] if each["at"] is None else each["at"] for each in given]) / times
    first = Runs(starts[0], times[0], begun=False)
    if first.stiff or (shown != shown[0]).any():
        raise ArithmeticError
    march = _March(lanes, np.array([start.state for start in starts]).T, times)
    count = samples_of(2.0 * times[0] * first.fast)
    ends, then, histories = march.sampled(count, float(shown[0]))
    size = lanes.one.end + lanes.one.m
    cost(march.calls * size * RATE[0], march.calls * size * RATE[1] + STARTED, len(cases))
    largest = [peaks(history) for history in histories]
    out = []
    for k, (start, each) in enumerate(zip(starts, given, strict=True)):
        follow, t = each["follow"], float(shown[k] * times[k])
        there = moment_of(start.system, t, then[:, k], follow) if follow else None
        out.append(sampled(start.system, ends[-3:, k], [(float(line[k]), 0.0, 0.0) for line in largest], there))
    return out


class _March:
    """Lanes integrated with common steps, every step put back onto the joints."""

    def __init__(self, lanes: Lanes, state: "Any", times: "Any") -> None:
        self.lanes, self.state, self.times, self.calls = lanes, state, times, 0

    def _rate(self, share: float, flat: "Any") -> "Any":
        self.calls += 1
        return (self.lanes.rate(share * self.times, flat.reshape(self.state.shape)) * self.times).ravel()

    def sampled(self, count: int, shown: float) -> "tuple[Any, Any, list[Any]]":
        """As `run`, at the tolerance that the first sample of a calculation shows to be enough."""
        keep = kept()
        if ROUGH in keep:
            return self.run(count, shown, keep[ROUGH])
        fine = self.run(count, shown, SAMPLED)
        calls, self.calls = self.calls, 0
        off = self._off(fine, self.run(count, shown, ROUGH))
        keep[ROUGH] = ROUGH if off < ENOUGH else SAMPLED
        if off < ENOUGH:
            missed(off)
        else:
            self.calls = calls
        return fine

    def _off(self, fine: "tuple[Any, Any, list[Any]]", rough: "tuple[Any, Any, list[Any]]") -> float:
        """The largest error of a rough run, in deviations of what varies."""
        end = self.lanes.one.end
        numbers = [(fine[1][: 2 * end], rough[1][: 2 * end]), (fine[0][-3:], rough[0][-3:])]
        numbers += [(one.max(axis=1)[None], other.max(axis=1)[None])
                    for one, other in zip(fine[2], rough[2], strict=True)]  # fmt: skip
        worst = 0.0
        for one, other in numbers:
            spread = one.std(axis=1)
            varies = spread > STEADY * np.maximum(1.0, np.abs(one).max(axis=1))
            errors = np.abs(one - other).max(axis=1)
            worst = max(worst, float((errors[varies] / spread[varies]).max(initial=0.0)))
        return worst

    def run(self, count: int, shown: float, tolerance: float) -> "tuple[Any, Any, list[Any]]":
        """States at the end and at a share of the time, and the forces of every joint over time (lanes, times)."""
        from scipy.integrate import DOP853

        shape, start = self.state.shape, self.state
        solver = DOP853(self._rate, 0.0, start.ravel(), 1.0, rtol=tolerance, atol=tolerance)
        then, states, shares = start, [start[None]], np.linspace(0.0, 1.0, count + 1)
        with np.errstate(all="ignore"), going(1.0, "samples, share of their motion") as progress:
            while solver.status == "running":
                before = solver.t
                solver.step()
                if solver.status == "failed":
                    raise ArithmeticError
                progress(solver.t)
                dense = solver.dense_output()
                passed = shares[(shares > before) & (shares <= solver.t)]
                if len(passed):
                    states.append(dense(passed).T.reshape(-1, *shape))
                if before < shown <= solver.t:
                    then = dense(shown).reshape(shape)
                y = solver.y.reshape(shape)
                if self.lanes.put_back(solver.t * self.times, y) > DRIFT:
                    solver.f = self._rate(solver.t, solver.y)
            forces = self.lanes.forces_over(shares[:, None] * self.times, np.concatenate(states))
        return solver.y.reshape(shape), then, forces
