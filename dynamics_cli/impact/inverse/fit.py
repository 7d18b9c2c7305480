"""Least squares of approach velocities and impulse to the motion after the impact."""

import math

from dynamics_cli.errors import require
from dynamics_cli.quantities import Ratio
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

Pair = tuple[float, float]
MOST_STEPS = 60
# A change of all unknowns by fewer standard deviations of the measurements than this is convergence.
SETTLED = 1e-11
# Directions of the scaled unknowns with smaller singular values are not determined by the measurements.
BLIND = 1e-9


@record
class Side:
    """A vehicle in the fit: its measurements with their standard deviations, and the known part of its approach.

    `way` and `turn` are the unit vector of the approach heading and its derivative; None where the heading is unknown.
    `sense` is 1 for the vehicle on which the impulse acts, -1 for the other. `spins` are inertia, lever, and spins
    before and after; None without levers or spins.
    """

    name: str
    sense: float
    mass: float
    velocity: Pair
    way: "Pair | None"
    turn: "Pair | None"
    spins: "tuple[float, Pair, float, float] | None"
    velocity_sigma: float
    spin_sigma: float
    heading_sigma: float

    @property
    def bends(self) -> bool:
        """Whether the approach heading is one of the measurements."""
        return self.way is not None and self.heading_sigma > 0.0


class Fit:
    """The fitted state V₁, V₂, p with its covariance, residuals in standard deviations, and the last step's size."""

    def __init__(self, state: "Any", covariance: "Any", residuals: "list[tuple[str, float]]", unknowns: int) -> None:
        self.state = state
        self.covariance = covariance
        self.residuals = residuals
        self.freedom = len(residuals) - unknowns
        self.chi_squared = float(sum(value * value for _, value in residuals))
        self.steps = 0
        self.gradient = 0.0

    def speed(self, side: int) -> float:
        """Size of an approach velocity."""
        return math.hypot(self.state[2 * side], self.state[2 * side + 1])

    def sigma(self, row: "Sequence[float]") -> float:
        """Standard deviation of a linear combination of the state."""
        import numpy as np

        weights = np.array(row)
        return float(max(weights @ self.covariance @ weights, 0.0) ** 0.5)


def solve(sides: "tuple[Side, Side]") -> Fit:
    """Gauss–Newton by QR of the scaled matrix, from the linear fit at the headings as given.

    Unknowns of each vehicle: its speed; its speed and the error of its heading; or, if the heading is unknown,
    both components of its velocity. The impulse is unknown too. Refuses measurements that do not determine them.
    """
    import numpy as np

    free = [column for side, start in zip(sides, _starts(sides)[:2], strict=True) for column in _free(side, start)]
    size = _starts(sides)[2] + 2
    linear = [column for column in range(size) if column not in free]
    unknowns = np.zeros(size)
    _, residuals, matrix, _ = _rows(sides, unknowns)
    unknowns[linear] -= stepped(matrix[:, linear], residuals)[0]
    steps = 1
    while True:
        names, residuals, matrix, jacobian = _rows(sides, unknowns)
        step, inverse, moved = stepped(matrix, residuals)
        if moved <= SETTLED * (1.0 + float(np.linalg.norm(residuals))) or steps == MOST_STEPS:
            break
        unknowns = unknowns - step
        steps += 1
    require(
        moved <= 1e-6 * (1.0 + float(np.linalg.norm(residuals))),
        "no approach fits these measurements best: after {steps} steps the fit still moves by {moved:2} standard "
        "deviations",
        steps=steps,
        moved=(moved, Ratio),
        code="undetermined",
        hint="look for headings or spins that are wrong, or give their standard deviations larger",
    )
    half = jacobian @ inverse
    fit = Fit(_state(sides, unknowns), half @ half.T, list(zip(names, map(float, residuals), strict=True)), size)
    fit.steps, fit.gradient = steps, moved
    return fit


def _starts(sides: "tuple[Side, Side]") -> "tuple[int, int, int]":
    """First columns of each vehicle and of the impulse."""
    widths = [1 if side.way is not None and not side.bends else 2 for side in sides]
    return 0, widths[0], widths[0] + widths[1]


def _free(side: Side, start: int) -> "list[int]":
    return [start + 1] if side.bends else []


def _velocity(side: Side, entries: "Any") -> "tuple[Pair, list[Pair]]":
    """Approach velocity of the unknowns of a vehicle, and its derivatives by them."""
    if side.way is None or side.turn is None:
        return (entries[0], entries[1]), [(1.0, 0.0), (0.0, 1.0)]
    if not side.bends:
        return (entries[0] * side.way[0], entries[0] * side.way[1]), [side.way]
    cosine, sine = math.cos(entries[1]), math.sin(entries[1])
    travel = cosine * side.way[0] + sine * side.turn[0], cosine * side.way[1] + sine * side.turn[1]
    turn = cosine * side.turn[0] - sine * side.way[0], cosine * side.turn[1] - sine * side.way[1]
    return (entries[0] * travel[0], entries[0] * travel[1]), [travel, (entries[0] * turn[0], entries[0] * turn[1])]


def _state(sides: "tuple[Side, Side]", unknowns: "Any") -> "Any":
    import numpy as np

    start2, start3, last = _starts(sides)
    first, second = _velocity(sides[0], unknowns[start2:start3])[0], _velocity(sides[1], unknowns[start3:last])[0]
    return np.array([*first, *second, *unknowns[last:]])


def _rows(sides: "tuple[Side, Side]", unknowns: "Any") -> "tuple[list[str], Any, Any, Any]":
    """Names, residuals and rows of all measurements in standard deviations; derivatives of the state."""
    import numpy as np

    starts = _starts(sides)
    impulse = unknowns[starts[2] :]
    names: list[str] = []
    residuals: list[float] = []
    rows: list[Any] = []
    jacobian = np.zeros((6, len(unknowns)))
    jacobian[4, -2] = jacobian[5, -1] = 1.0

    def measured(name: str, residual: float, row: "Any", sigma: float) -> None:
        names.append(name)
        residuals.append(residual / sigma)
        rows.append(row / sigma)

    for index, side in enumerate(sides):
        entries = unknowns[starts[index] : starts[index + 1]]
        velocity, slopes = _velocity(side, entries)
        push = side.sense / side.mass
        for axis, letter in enumerate("xy"):
            jacobian[2 * index + axis, starts[index] : starts[index + 1]] = [slope[axis] for slope in slopes]
            row = jacobian[2 * index + axis].copy()
            row[axis - 2] = push
            gap = velocity[axis] + push * impulse[axis] - side.velocity[axis]
            measured(f"{side.name} exit velocity along {letter}", gap, row, side.velocity_sigma)
        if side.spins is not None:
            inertia, lever, before, after = side.spins
            row = np.zeros(len(unknowns))
            row[-2:] = -side.sense * lever[1] / inertia, side.sense * lever[0] / inertia
            measured(f"{side.name} exit spin", before + float(row[-2:] @ impulse) - after, row, side.spin_sigma)
        if side.bends:
            row = np.zeros(len(unknowns))
            row[starts[index] + 1] = 1.0
            measured(f"{side.name} approach heading", float(entries[1]), row, side.heading_sigma)
    return names, np.array(residuals), np.array(rows), jacobian


def stepped(matrix: "Any", residuals: "Any") -> "tuple[Any, Any, float]":
    """Solution of the linear problem, the inverse of R in units of the unknowns, the solution's size in deviations."""
    import numpy as np

    scales = np.linalg.norm(matrix, axis=0)
    scales[scales == 0.0] = 1.0
    q, r = np.linalg.qr(matrix / scales)
    singular = np.linalg.svd(r, compute_uv=False)
    require(
        len(matrix) >= len(scales) and singular[-1] > BLIND * singular[0],
        "these measurements do not determine the approach: one combination of speeds and impulse changes none of "
        "them (singular value {seen:2} of the scaled problem)",
        seen=(singular[-1], Ratio),
        code="undetermined",
        hint="give approach headings that cross, or exit spins with spins before, inertias and levers",
    )
    inverse = np.linalg.inv(r)
    moved = q.T @ residuals
    return (inverse @ moved) / scales, inverse / scales[:, None], float(np.linalg.norm(moved))
