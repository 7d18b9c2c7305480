"""A function on parallel lines, cell by cell between points: its quantiles and moments over the mass of the cells."""

import numpy as np

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]

# Cells are sought once for all values within this part of a function's range.
NEAR = 0.004
STEPS = 8


class Cells:
    """A result on lines, cell by cell: both ends, half its bend, the share of cases and half the fall of their density.

    With t the place in a cell from 0 to 1, the result is a + (b − a) t − bend t(1 − t), and the share of the cell's
    cases up to t is t + fall t(1 − t).
    """

    def __init__(self, ends: "tuple[Array, Array]", between: "tuple[Array, Array]", mass: "Array", group: "Array",
                 every: int = 1) -> None:  # fmt: skip
        """Cells (lines, cells) with values at both `ends`, `between` two places on the line; or every few as one."""
        (a, b), (low, high) = ends, between
        sound, other = np.isfinite(a), np.isfinite(b)
        self.whole = bool(sound.all() and other.all())
        if not self.whole:
            # Half a cell is admissible, on average, where only one of its ends is.
            mass = mass * (0.5 * (sound.astype(float) + other))
            a, b = np.where(sound, a, b), np.where(other, b, a)
            lost = ~np.isfinite(a)
            a, b = np.where(lost, 0.0, a), np.where(lost, 0.0, b)
        if every > 1:
            first, last = mass[:, ::every] > 0.0, mass[:, every - 1 :: every] > 0.0
            a, low = (np.where(first, part[:, ::every], part[:, every - 1 :: every]) for part in (a, low))
            b, high = (np.where(last, part[:, every - 1 :: every], part[:, ::every]) for part in (b, high))
            mass = mass.reshape(len(mass), -1, every).sum(axis=2)
        a, b = np.ascontiguousarray(a), np.ascontiguousarray(b)
        self.a, self.b, self.mass, self.group = a, b, mass, group
        self.fall = 0.25 * (low + high) * (high - low)
        self.low, self.high = np.minimum(a, b), np.maximum(a, b)
        self.bend = _bend(b - a, high - low)
        self.admissible = float(mass.sum())
        self.reach = NEAR * float(self.high.max() - self.low.min())
        self._windows: list[Window] = []

    def replicates(self, by_line: "Array") -> "Array":
        """Sums over the lines of each replicate."""
        return np.bincount(self.group, by_line)

    def moments(self) -> "tuple[Array, Array, Array, float]":
        """Mass, mean and mean square of each replicate, both about a value in the midst."""
        centre = float(self.a[len(self.a) // 2, self.a.shape[1] // 2])
        rise, mass = self.b - self.a, self.mass
        middle = self.a + 0.5 * rise - (rise * self.fall + self.bend) / 6.0 - centre
        sums = (
            mass.sum(axis=1),
            np.einsum("ij,ij->i", mass, middle),
            np.einsum("ij,ij,ij->i", mass, middle, middle) + np.einsum("ij,ij,ij->i", mass, rise, rise) / 12.0,
        )
        share, first, second = map(self.replicates, sums)
        return share, first, second, centre

    def below(self, v: float) -> "tuple[Array, float]":
        """The admissible share up to a value in each replicate, and the density there."""
        for window in self._windows:
            if window.low <= v <= window.high:
                return window.below(v)
        self._windows.append(Window(self, v))
        return self._windows[-1].below(v)

    def quantile(self, p: float, start: float, scale: float) -> "tuple[float, Array, float]":
        """The value below which a given share of the admissible cases lies; the shares there, and the density."""
        wanted = p * self.admissible
        low, high = float(self.low.min()), float(self.high.max())
        v = min(max(start, low), high)
        for step in range(60):
            share, dense = self.below(v)
            excess = float(share.sum()) - wanted
            low, high = (low, v) if excess >= 0.0 else (v, high)
            if abs(excess) <= 1e-7:
                break
            if high - low <= 1e-9 * scale:
                v = high  # a jump of the probability: an atom
                share, dense = self.below(v)
                break
            move = -excess / dense if dense > 0.0 else np.inf
            new = v + move
            v = new if step < STEPS and low < new < high else 0.5 * (low + high)
        return v, share, dense

    def first_quantiles(self, p: "Array") -> "Array":
        """Quantiles of a part of the cells, each taken at its middle."""
        every = max(self.mass.size // 8192, 1)
        middle = (0.5 * (self.low + self.high)).ravel()[::every]
        mass = self.mass.ravel()[::every]
        order = np.argsort(middle)
        ranked = np.cumsum(mass[order])
        place = np.searchsorted(ranked, p * ranked[-1])
        return middle[order][np.minimum(place, ranked.size - 1)]  # type: ignore[no-any-return]


class Window:
    """The cells that values within a small range cut, and the cases below all of these."""

    def __init__(self, cells: Cells, v: float) -> None:
        self.low, self.high = v - cells.reach, v + cells.reach
        over = cells.high > self.low
        self.base = cells.replicates(cells.mass.sum(axis=1, where=~over))
        cut = np.flatnonzero(over & (cells.low <= self.high))
        self.group = cells.group[cut // cells.a.shape[1]]
        self.a, b, self.mass, self.bend, self.fall, self.bottom, self.top = (
            part.ravel()[cut] for part in (cells.a, cells.b, cells.mass, cells.bend, cells.fall, cells.low, cells.high)
        )
        self.rise = b - self.a
        self.curved = np.abs(self.bend) < np.abs(self.rise)
        self.groups = self.base.size

    def below(self, v: float) -> "tuple[Array, float]":
        """The admissible share up to a value within the range in each replicate, and the density there."""
        under = self.top <= v
        cut = np.nonzero((self.bottom <= v) & ~under)[0]
        rise, mass = self.rise[cut], self.mass[cut]
        t = (v - self.a[cut]) / rise
        t = np.where(self.curved[cut], t + self.bend[cut] / rise * t * (1.0 - t), t).clip(0.0, 1.0)
        part = t + self.fall[cut] * t * (1.0 - t)
        inside = mass * np.where(rise > 0.0, part, 1.0 - part)
        share = self.base + np.bincount(self.group[cut], inside, minlength=self.groups)
        share += np.bincount(self.group, np.where(under, self.mass, 0.0), minlength=self.groups)
        return share, float((mass / np.abs(rise)).sum())


def _bend(rise: "Array", width: "Array") -> "Array":
    """Half the second difference of each cell: the smaller of those at its ends, none where these turn (kinks)."""
    bend = np.zeros_like(rise)
    width = np.maximum(width, 1e-9)
    slope = rise / width
    half = (slope[:, 1:] - slope[:, :-1]) / (width[:, 1:] + width[:, :-1])
    one, other = half[:, :-1], half[:, 1:]
    inner = bend[:, 1:-1]
    np.maximum(np.minimum(one, other), 0.0, out=inner)
    inner += np.minimum(np.maximum(one, other), 0.0)
    inner *= width[:, 1:-1] ** 2
    return bend
