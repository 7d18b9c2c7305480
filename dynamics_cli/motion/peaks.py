"""The peak of a history that is sampled at equal steps."""

import numpy as np

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]

# Samples about a peak through which a polynomial goes, and the places at which it is looked up.
REACH = 3
PLACES = np.linspace(-REACH, REACH, 60 * REACH + 1)
INVERSE = np.linalg.inv(np.vander(np.arange(-REACH, REACH + 1.0)))
POWERS = np.vander(PLACES, 2 * REACH + 1)


def peaks(history: "Array") -> "Array":
    """The maximum of each row of evenly spaced values: a polynomial through those about the highest arc's top."""
    rows, last = np.arange(len(history)), history.shape[1] - 1
    before, middle, after = history[:, :-2], history[:, 1:-1], history[:, 2:]
    with np.errstate(all="ignore"):
        tops = middle + (after - before) ** 2 / (8.0 * (2.0 * middle - before - after))
    tops = np.where((middle >= before) & (middle >= after) & np.isfinite(tops), tops, middle)
    best = np.concatenate((history[:, :1], tops, history[:, -1:]), axis=1).argmax(axis=1)
    at = np.clip(best, REACH, last - REACH)
    window = history[rows[:, None], at[:, None] + np.arange(-REACH, REACH + 1)]
    between = (window @ INVERSE.T) @ POWERS.T
    between[np.abs(PLACES - (best - at)[:, None]) > 1.0] = -np.inf
    top = np.clip(between.argmax(axis=1), 1, len(PLACES) - 2)
    low, middle, high = (between[rows, top + k] for k in (-1, 0, 1))
    with np.errstate(all="ignore"):
        arc = middle + (high - low) ** 2 / (8.0 * (2.0 * middle - low - high))
    # beside the first or last value there may be no top: a parabola through a straight line has its own far away
    there = np.isfinite(arc) & (middle >= low) & (middle >= high)
    highest: Array = np.maximum(between.max(axis=1), history.max(axis=1))
    return np.where(there, np.fmax(arc, highest), highest)
