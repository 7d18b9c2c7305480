"""The grid of an envelope, in blocks: where the extremes lie in doubles, and which points may lie beyond them."""

from dynamics_cli.impact.planar.laws import ON_THE_PATH

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.impact.planar.envelope_bounds import ExactContact, Extreme

    Array = NDArray[Any]

# Number of points indistinguishable from an extreme in doubles that are calculated in 60 digits.
MOST_NEAR = 40


class Region:
    """The grid, scanned in blocks; keeps only the places of extremes."""

    def __init__(self, exact: "ExactContact", law: str, e: "Array", mu: "Array") -> None:
        self.exact = exact
        self.meeting = exact.rounded()
        self.turns = exact.rounded_turns()
        self.law = str(law)
        self.e = e
        self.mu = mu
        self.rows = max(1, 16384 // e.size)
        self.good = 0
        self.full = 0
        self.least: dict[str, tuple[float, int, int]] = {}
        self.greatest: dict[str, tuple[float, int, int]] = {}
        # the extremes of every block of the grid, by quantity and end
        self.blocks: dict[tuple[str, bool], list[tuple[int, float]]] = {}

    def answer(self, mu: "Array", e: "Array") -> "tuple[Array, Array, Array]":
        """p_n, p_t and energy lost; NaN where the law has no answer."""
        import numpy as np

        from dynamics_cli.impact.planar.path_arrays import impulses, ratio_impulses

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
        import numpy as np

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
        import numpy as np

        pn, pt, lost = self.answer(np.array([mu]), np.array([e]))
        if pn[0] != pn[0]:
            return {}
        values_there = {name: float(values[0]) for name, values in self.quantities(pn, pt, lost).items()}
        return {**values_there, "size": values_there["size"] ** 0.5}

    def extremes(self) -> "dict[str, tuple[Extreme, Extreme]]":
        """Least and greatest of every quantity, with their bounds."""
        from dynamics_cli.impact.planar.envelope_bounds import Extremes

        extremes = Extremes(self.exact, self.law, self.at)
        places = {(row, column) for store in (self.least, self.greatest) for _, row, column in store.values()}
        corners = {(row, column) for row in (0, self.mu.size - 1) for column in (0, self.e.size - 1)}
        extremes.learn(self._point(*place) for place in places | corners if self.at(*self._point(*place)))
        missed = extremes.missed()
        unresolved = {}
        for name, margin in missed.items():
            for greatest in (False, True):
                near = self._near(name, greatest, extremes.end(name, greatest=greatest, missed=0.0).value, margin)
                unresolved[name, greatest] = margin if near is None else 0.0
                extremes.learn(near or ())
        return {
            name: (
                extremes.end(name, greatest=False, missed=unresolved[name, False]),
                extremes.end(name, greatest=True, missed=unresolved[name, True]),
            )
            for name in missed
        }

    def _point(self, row: int, column: int) -> tuple[float, float]:
        return float(self.mu[row]), float(self.e[column])

    def _near(self, name: str, greatest: bool, value: float, margin: float) -> "list[tuple[float, float]] | None":
        """The points that may be beyond the extreme within the error of doubles; None if they are many."""
        import numpy as np

        sense = 1.0 if greatest else -1.0
        # the impulse is kept as its square
        limit = sense * value - 2.0 * margin
        bar = limit if name != "size" else sense * (sense * limit) ** 2 if sense * limit > 0.0 else -np.inf
        points: list[tuple[float, float]] = []
        for start, best in self.blocks[name, greatest]:
            if sense * best < bar:
                continue
            mu = self.mu[start : start + self.rows, None]
            pn, pt, lost = self.answer(mu, self.e)
            values = np.where(pn == pn, self.quantities(pn, pt, lost)[name], np.nan)
            with np.errstate(invalid="ignore"):
                rows, columns = np.nonzero(sense * values >= bar)
            if len(points) + rows.size > MOST_NEAR:
                return None
            points += [
                self._point(start + row, column) for row, column in zip(rows.tolist(), columns.tolist(), strict=True)
            ]
        return points

    def _keep(self, name: str, values: "Array", start: int) -> None:
        import numpy as np

        for store, find, better in ((self.least, np.nanargmin, -1.0), (self.greatest, np.nanargmax, 1.0)):
            index = int(find(values))
            value = float(values.flat[index])
            self.blocks.setdefault((name, better > 0.0), []).append((start, value))
            if name not in store or better * value > better * store[name][0]:
                row, column = divmod(index, self.e.size)
                store[name] = value, start + row, column
