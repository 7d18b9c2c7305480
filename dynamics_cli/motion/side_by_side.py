"""Many chains integrated side by side, for samples of uncertain inputs."""

import numpy as np

from dynamics_cli.errors import DynamicsError, require
from dynamics_cli.motion.chain import Chain, chain, let_go
from dynamics_cli.motion.peaks import peaks
from dynamics_cli.motion.rods import solved
from dynamics_cli.motion.runs import samples_of
from dynamics_cli.progress import going
from dynamics_cli.records import Numerics
from dynamics_cli.sampling import cost, drawing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.motion.rods import Rods

    Array = NDArray[Any]
    Given = dict[str, Any]

# Digits of a sample: far more than its spread leaves.
TOLERANCE = 1e-10
# Seconds of a rate for each rod, of that for each pair of rods of a case, and of setting up a case.
RATE, POSED = (2e-5, 4e-8), 5e-5
# So many numbers of a history at once.
BLOCK = 2_000_000


def chains(cases: "Sequence[Given]") -> "list[Chain | Exception]":
    """The numbers of each chain, or the error that refuses it."""
    made: list[Any] = [None] * len(cases)
    posed: dict[int, tuple[Rods, list[float], float]] = {}
    fastest: float | None = None
    for row, parameters in enumerate(cases):
        given = {**(chain.__kwdefaults__ or {}), **parameters}
        given.pop("steps")
        try:
            posed[row] = *let_go(**given, fastest=fastest), given["duration"]
            fastest = fastest or posed[row][0].fastest()
        except (DynamicsError, ArithmeticError) as error:
            made[row] = error
    for row, result in zip(posed, _together(list(posed.values())) if posed else (), strict=True):
        made[row] = result
    return made


def _count(cases: "list[tuple[Rods, list[float], float]]") -> int:
    """Samples of the history, by the first case: others go much the same way."""
    rods, start, _ = cases[0]
    return samples_of(max(time for _, _, time in cases) * rods.scale(start[: rods.n], start[rods.n :]))


def _together(cases: "list[tuple[Rods, list[float], float]]") -> "list[Chain]":
    from scipy.integrate import solve_ivp

    lanes, count = _Lanes(cases), _count(cases)
    n, state = lanes.n, lanes.start.ravel()
    pieces = -(-count * state.size // BLOCK)
    forces, calls = np.zeros(len(cases)), 0
    with going(1.0, "samples, share of their motion") as progress:

        def rate(share: float, state: "Array") -> "Array":
            progress(share)
            return lanes.rate(share, state)

        for piece in range(pieces):
            shares = np.linspace(piece, piece + 1.0, count // pieces + 1) / pieces
            run: Any = solve_ivp(rate, (shares[0], shares[-1]), state, method="DOP853", rtol=TOLERANCE,
                                 atol=TOLERANCE, t_eval=shares)  # fmt: skip
            require(bool(run.success), "the integration stopped", code="no-convergence")
            state, calls = run.y[:, -1], calls + run.nfev
            forces = np.maximum(forces, peaks(lanes.top_forces(run.y.reshape(2 * n, len(cases), -1))))
    if drawing():
        cost(calls * n * RATE[0], (calls + count) * n * n * RATE[1] + POSED, len(cases))
    ends = state.reshape(2 * n, -1).T.tolist()
    return [_sampled(rods, end, float(force)) for (rods, _, _), end, force in zip(cases, ends, forces, strict=True)]


def _sampled(rods: "Rods", end: "list[float]", force: float) -> Chain:
    x, y = rods.joints(end[: rods.n])
    return Chain(
        verdict="", horizon=None, tenfold=None, difference=0.0, energy_error=0.0, top_force=force, frequencies=(),
        angle=end[rods.n - 1], rate=end[-1], across=x[-1], up=y[-1], rods=None, motion=(), numerics=Numerics("DOP853"),
    )  # fmt: skip


class _Lanes:
    """Chains of as many rods as arrays, lanes last; time runs from 0 to 1 over the duration of each."""

    def __init__(self, cases: "list[tuple[Rods, list[float], float]]") -> None:
        chains = [rods for rods, _, _ in cases]
        self.n = chains[0].n
        self.a: Array = np.array([rods.a for rods in chains]).transpose(1, 2, 0)
        self.b: Array = np.array([rods.b for rods in chains]).T
        self.weights: Array = np.array([[rods.gravity * b for b in rods.b] for rods in chains]).T
        self.weight: Array = np.array([rods.gravity * (sum(rods.masses) + sum(rods.ends)) for rods in chains])
        self.start: Array = np.array([start for _, start, _ in cases]).T
        self.times: Array = np.array([time for _, _, time in cases])

    def turning(self, y: "Array", a: "Array", weights: "Array") -> "Array":
        """Angular accelerations (n, …) of states (2n, …)."""
        n = self.n
        s, c, squares = np.sin(y[:n]), np.cos(y[:n]), y[n:] * y[n:]
        right = -weights * s - (a * (s[:, None] * c - c[:, None] * s) * squares).sum(axis=1)
        matrix = a * (c[:, None] * c + s[:, None] * s)
        return np.array(solved([list(row) for row in matrix], list(right)))

    def rate(self, _: float, state: "Array") -> "Array":
        """Rates of all lanes, by the share of the time passed."""
        y = state.reshape(2 * self.n, -1)
        rates: Array = np.concatenate((y[self.n :], self.turning(y, self.a, self.weights))) * self.times
        return rates.ravel()

    def top_forces(self, states: "Array") -> "Array":
        """The force in the top pin (lanes, times): all masses move by Σ b_i·l of their rods, and have weight."""
        n = self.n
        turning = self.turning(states, self.a[..., None], self.weights[..., None])
        s, c, squares = np.sin(states[:n]), np.cos(states[:n]), states[n:] ** 2
        b = self.b[..., None]
        across = (b * (turning * c - squares * s)).sum(axis=0)
        up = (b * (turning * s + squares * c)).sum(axis=0) + self.weight[:, None]
        forces: Array = np.hypot(across, up)
        return forces
