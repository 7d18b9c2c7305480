"""Results at the ends of the inputs' intervals: one input at a time, and all at once."""

import numpy as np

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.core.uncertainty.space import Space

    Array = NDArray[Any]

# More inputs than this have too many corners to visit.
MOST_CORNERS = 10


def add_corners(space: "Space", spreads: "Mapping[str, Any]", coverage: float) -> None:
    """Results at the ends of the inputs' intervals, one at a time (the tornado) and all at once (the worst case)."""
    n = space.size
    ends = np.array([distribution.interval(coverage) for distribution in space.distributions])
    middle = space.inputs_of(np.zeros((n, 1)))
    base = np.array([middle[name][0] for name in space.names])
    cases = np.repeat(base[:, None], 2 * n, axis=1)
    for i in range(n):
        cases[i, 2 * i : 2 * i + 2] = ends[i]
    if n <= MOST_CORNERS:
        bits = (np.arange(1 << n)[None, :] >> np.arange(n)[:, None]) & 1
        corners = np.where(bits == 1, ends[:, 1:], ends[:, :1])
        cases = np.concatenate([cases, corners], axis=1)
    values = space.evaluate_inputs({**space.fixed, **dict(zip(space.names, cases, strict=True))}, cases.shape[1])
    for row, name in enumerate(space.results):
        spread = spreads[name]
        if spread.interval[0] == spread.interval[1]:
            continue
        alone = values[row, : 2 * n].reshape(n, 2)
        spread.tornado = [(float(a), float(b)) for a, b in alone]
        corners = values[row, 2 * n :] if n <= MOST_CORNERS else _steepest_corners(space, row, ends, alone)
        if not np.isnan(corners).all():
            spread.corners = (float(np.nanmin(corners)), float(np.nanmax(corners)))


def _steepest_corners(space: "Space", row: int, ends: "Array", alone: "Array") -> "Array":
    """Too many corners: the two where every input is at the end that, alone, lowers or raises the result."""
    rising = alone[:, 1] >= alone[:, 0]
    high = np.where(rising, ends[:, 1], ends[:, 0])
    low = np.where(rising, ends[:, 0], ends[:, 1])
    cases = np.column_stack([low, high])
    return space.evaluate_inputs({**space.fixed, **dict(zip(space.names, cases, strict=True))}, 2)[row]  # type: ignore[no-any-return]
