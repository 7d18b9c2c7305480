"""The grid of an envelope, in blocks that stay in the cache: where the extremes lie in doubles.

Its impulses follow the closed form of `path` on whole arrays, with plain sums where that rounds as if in twice the
precision.
"""

import numpy as np

from dynamics_cli.impact.planar.laws import ON_THE_PATH

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.impact.planar.envelope_bounds import ExactContact, Extreme

    Array = NDArray[Any]

INFINITY = float("inf")


class Region:
    """The grid, scanned in blocks; keeps only the places of extremes."""

    def __init__(self, exact: "ExactContact", law: str, e: "Array", mu: "Array") -> None:
        self.exact = exact
        self.meeting, self.turns = exact.rounded()
        self.law = str(law)
        self.e = e
        self.mu = mu
        self.rows = max(1, 16384 // e.size)
        self.good = 0
        self.full = 0
        self.least: dict[str, tuple[float, int, int]] = {}
        self.greatest: dict[str, tuple[float, int, int]] = {}

    def answer(self, mu: "Array", e: "Array") -> "tuple[Array, Array, Array]":
        """p_n, p_t and energy lost; NaN where the law has no answer."""
        m, k = self.meeting, self.meeting.mobility
        function = impulses if self.law in ON_THE_PATH else ratio_impulses
        pn, pt = function(k.tangential, k.coupling, k.normal, k.determinant, m.slip, m.approach, mu, e, law=self.law)
        kx = k.coupling
        # beside points with an answer there may be points of any size without one
        with np.errstate(all="ignore"):
            lost = -pn * (m.approach + 0.5 * k.normal * pn + kx * pt) - pt * (m.slip + 0.5 * k.tangential * pt)
        if self.law != "stronge":
            gains = lost < -1e-12 * (np.abs(pn * m.approach) + np.abs(pt * m.slip))
            pn = np.where(gains, np.nan, pn)
        return pn, pt, lost

    def quantities(self, pn: "Array", pt: "Array", lost: "Array") -> "dict[str, Array]":
        """The quantities whose extremes are sought; the squared impulse in place of its magnitude."""
        quantities = {"size": pn * pn + pt * pt, "lost": lost}
        for name, turn in zip(("first", "second"), self.turns, strict=True):
            if turn is not None:
                quantities[name] = turn[0] * pn + turn[1] * pt
        return quantities

    def scan(self) -> None:
        """Go through all points."""
        for start in range(0, self.mu.size, self.rows):
            mu = self.mu[start : start + self.rows, None]
            pn, pt, lost = self.answer(mu, self.e)
            good = pn == pn
            count = int(np.count_nonzero(good))
            if not count:
                continue
            self.good += count
            self.full += int(np.count_nonzero(np.abs(pt) >= (1.0 - 1e-14) * (mu * pn)))
            for name, values in self.quantities(pn, pt, lost).items():
                self._keep(name, values if count == good.size else np.where(good, values, np.nan), start)

    def at(self, mu: float, e: float) -> dict[str, float]:
        """The same in doubles at one point; empty where the law has no answer."""
        pn, pt, lost = self.answer(np.array([mu]), np.array([e]))
        if pn[0] != pn[0]:
            return {}
        values_there = {name: float(values[0]) for name, values in self.quantities(pn, pt, lost).items()}
        return {**values_there, "size": values_there["size"] ** 0.5}

    def extremes(self) -> "dict[str, tuple[Extreme, Extreme]]":
        """Least and greatest of every quantity, with their bounds."""
        from dynamics_cli.impact.planar.envelope_bounds import extremes

        places = {(row, column) for store in (self.least, self.greatest) for _, row, column in store.values()}
        corners = {(row, column) for row in (0, self.mu.size - 1) for column in (0, self.e.size - 1)}
        points = [(float(self.mu[row]), float(self.e[column])) for row, column in places | corners]
        return extremes(self.exact, self.law, [point for point in points if self.at(*point)], self.at)

    def _keep(self, name: str, values: "Array", start: int) -> None:
        for store, find, better in ((self.least, np.nanargmin, -1.0), (self.greatest, np.nanargmax, 1.0)):
            index = int(find(values))
            value = float(values.flat[index])
            if name not in store or better * value > better * store[name][0]:
                row, column = divmod(index, self.e.size)
                store[name] = value, start + row, column


def impulses(
    kt: "Any", kx: "Any", kn: "Any", det: "Any", ut: "Any", un: "Any", mu: "Any", e: "Any", *, law: str
) -> "tuple[Array, Array]":
    """p_n and p_t of one block; arrays may broadcast, so that quantities of friction alone are calculated once."""
    with np.errstate(all="ignore"):
        ratio = -mu * np.sign(ut)
        slope = kn + kx * ratio
        first = -ut / (kx + kt * ratio)
        # never stops: infinite; and where nothing slips or would slip, both phases are the same
        first = np.where(first >= 0.0, first, INFINITY)
        size = np.abs(kx)
        later = (det + size * np.maximum(size - mu * kt, 0.0)) / kt
        late_ratio = -np.clip(kx / kt, -mu, mu)
        turned = un + slope * first
        inside = turned >= 0.0
        straight = -un / slope
        total = (1.0 + e) * straight
        ended = inside & (total <= first)
        bent = first - turned / later
        if law == "newton":
            beyond = (-e * un - turned) / later
        elif law == "poisson":
            beyond = np.where(inside, total, (1.0 + e) * bent) - first
        else:
            final = e * un
            square_left = (final - turned) * (final + turned) / slope
            crossing = square_left / (turned + np.sqrt(turned * turned + later * square_left))
            work = turned * (turned / later) - (un + turned) * first
            beyond = np.where(inside, crossing, e * np.sqrt(work / later) - turned / later)
        along = np.where(ended, total, first)
        beyond = np.where(ended, 0.0, np.maximum(beyond, 0.0))
        across = np.where(un < 0.0, along + beyond, np.nan)
        return across, ratio * along + late_ratio * beyond


def ratio_impulses(
    kt: "Any", kx: "Any", kn: "Any", det: "Any", ut: "Any", un: "Any", mu: "Any", e: "Any", *, law: str
) -> "tuple[Array, Array]":
    """p_n and p_t by Brach's impulse ratio (without moment) or by Kudlich and Slibar; NaN where p_n pulls."""
    with np.errstate(all="ignore"):
        grown = 1.0 + e
        rise = -(grown if law == "brach" else 1.0) * un
        along = kn * -ut - kx * rise
        across = kt * rise + kx * ut
        holds = np.abs(along) <= mu * across
        ratio = mu * np.where(along < 0.0, -1.0, 1.0) * np.where(across < 0.0, -1.0, 1.0)
        slid = rise / (kn + kx * ratio)
        pn = np.where(holds, across / det, slid)
        pt = np.where(holds, along / det, ratio * slid)
        if law != "brach":
            pn, pt = grown * pn, grown * pt
        return np.where((pn > 0.0) & (un < 0.0), pn, np.nan), pt
