"""Probabilities on lines along which the model may turn, jump, stay flat or be inadmissible: scan, split, bracket.

Each line is scanned in steps of half a standard deviation from −8.3 to 8.3. Where admissibility changes, its boundary
is bisected; where the values turn, the extremum is located; so every remaining piece is monotone with known ends.
P(result ≤ v) is then the measure of the pieces below v and of the parts of those that straddle it.
"""

import numpy as np

from dynamics_cli.numerics.distributions.normal_arrays import density, tail

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.core.uncertainty.methods.lines import Lines

    Array = NDArray[Any]
    Index = NDArray[Any]

REACH = 8.3
POINTS = 33
_BISECTIONS = 44
_GOLDEN = 0.3819660112501051
_GAUSS = (np.array([0.1127016653792583, 0.5, 0.8872983346207417]), np.array([5.0, 8.0, 5.0]) / 18.0)
_GAUSS_OF_TWO = (np.array([0.21132486540518713, 0.7886751345948129]), np.array([0.5, 0.5]))


class Pieces:
    """Monotone, admissible pieces of lines: ends a < b in s, and the values there.

    `edge` is −1 or 1 where a or b is the boundary of admissibility: slopes may be without bound there.
    """

    def __init__(
        self, line: "Index", a: "Array", b: "Array", fa: "Array", fb: "Array", edge: "Array | None" = None
    ) -> None:
        self.line = line
        self.edge = np.zeros(line.size) if edge is None else edge
        self.a = a
        self.b = b
        self.fa = fa
        self.fb = fb


class Scan:
    """The scanned lines; probabilities are given that the model is admissible.

    `offsets`, shares of a step from −½ to ½, shift each line's scan: kinks then lie anywhere between two points,
    and the one-sided error of a fixed scan averages out.
    """

    def __init__(self, lines: "Lines", offsets: "Array | None" = None, points: int = POINTS) -> None:
        self.lines = lines
        grid = np.linspace(-REACH, REACH, points)
        self.step = float(grid[1] - grid[0])
        shift = np.zeros(lines.weights.size) if offsets is None else offsets * self.step
        self.s = grid + shift[:, None]
        self.values = lines.values(self.s)
        # moments are taken about a value in the midst of the others
        sound = self.values[~np.isnan(self.values)]
        self.centre = float(sound[sound.size // 2]) if sound.size else 0.0
        self.pieces = self._split()
        self.measures = measure(self.pieces.a, self.pieces.b)
        self.low = np.minimum(self.pieces.fa, self.pieces.fb)
        self.high = np.maximum(self.pieces.fa, self.pieces.fb)
        self.broken = np.isnan(self.values).any(axis=1)
        self.admissible = float(lines.weights[self.pieces.line] @ self.measures) if self.pieces.line.size else 0.0

    def _split(self) -> Pieces:
        values, s = self.values, self.s
        sound = ~np.isnan(values)
        line, cell = np.nonzero(sound[:, :-1] & sound[:, 1:])
        pieces = Pieces(line, s[line, cell], s[line, cell + 1], values[line, cell], values[line, cell + 1])
        pieces = self._with_turns(pieces, cell, sound)
        edges = self._edges(sound)
        return _joined(pieces, edges) if edges is not None else pieces

    def _edges(self, sound: "NDArray[Any]") -> Pieces | None:
        """The part of a cell between an admissible end and the boundary of admissibility, which is bisected."""
        line, cell = np.nonzero(sound[:, :-1] != sound[:, 1:])
        if not line.size:
            return None
        inner = np.where(sound[line, cell], self.s[line, cell], self.s[line, cell + 1])
        outer = np.where(sound[line, cell], self.s[line, cell + 1], self.s[line, cell])
        start, f_start = inner, np.where(sound[line, cell], self.values[line, cell], self.values[line, cell + 1])
        value = f_start
        for _ in range(_BISECTIONS):
            middle = 0.5 * (inner + outer)
            at_middle = self.lines.at(line, middle)
            good = ~np.isnan(at_middle)
            inner, outer = np.where(good, middle, inner), np.where(good, outer, middle)
            value = np.where(good, at_middle, value)
        forward = start <= inner
        return Pieces(
            line,
            np.where(forward, start, inner),
            np.where(forward, inner, start),
            np.where(forward, f_start, value),
            np.where(forward, value, f_start),
            np.where(forward, 1.0, -1.0),
        )

    def _with_turns(self, pieces: Pieces, cells: "Index", sound: "NDArray[Any]") -> Pieces:
        """Cut the two cells beside a local extremum at the extremum."""
        values, s = self.values, self.s
        rise = np.diff(values, axis=1)
        # Steps of rounding size are not turns.
        with np.errstate(invalid="ignore"):
            rise[np.abs(rise) <= 1e-13 * np.abs(values[:, 1:])] = 0.0
            turns = rise[:, :-1] * rise[:, 1:] < 0.0
        line, left = np.nonzero(turns & sound[:, :-2] & sound[:, 1:-1] & sound[:, 2:])
        if not line.size:
            return pieces
        sign = np.where(rise[line, left] > 0.0, 1.0, -1.0)
        at, value = self._extremum(line, s[line, left], s[line, left + 2], sign)
        cell = np.where(at < s[line, left + 1], left, left + 1)
        taken = np.zeros(rise.shape, dtype=bool)
        taken[line, cell] = True
        keep = ~taken[pieces.line, cells]
        kept = Pieces(*(part[keep] for part in (pieces.line, pieces.a, pieces.b, pieces.fa, pieces.fb, pieces.edge)))
        before = Pieces(line, s[line, cell], at, values[line, cell], value)
        after = Pieces(line, at, s[line, cell + 1], value, values[line, cell + 1])
        return _joined(kept, before, after)

    def _extremum(self, line: "Index", a: "Array", b: "Array", sign: "Array") -> "tuple[Array, Array]":
        """The largest of sign·value between a and b by golden sections, vectorised over the lines."""
        x1, x2 = a + _GOLDEN * (b - a), b - _GOLDEN * (b - a)
        f1, f2 = sign * self.lines.at(line, x1), sign * self.lines.at(line, x2)
        for _ in range(_BISECTIONS):
            left = ~(f1 < f2)
            a, b = np.where(left, a, x1), np.where(left, x2, b)
            fresh = np.where(left, a + _GOLDEN * (b - a), b - _GOLDEN * (b - a))
            value = sign * self.lines.at(line, fresh)
            x1, x2 = np.where(left, fresh, x2), np.where(left, x1, fresh)
            f1, f2 = np.where(left, value, f2), np.where(left, f1, value)
        best = f1 >= f2
        return np.where(best, x1, x2), sign * np.where(best, f1, f2)

    def below(self, v: "Array", tolerance: float) -> "tuple[Array, Array]":
        """P(result ≤ v and admissible) on every line, (lines, k), and the density of the result at v, (k)."""
        weights = self.lines.weights
        shares = np.empty((weights.size, v.size))
        slopes = np.empty(v.size)
        found = [np.nonzero((self.low <= value) & (self.high > value))[0] for value in v]
        index = np.concatenate(found)
        level = np.repeat(v, [part.size for part in found])
        roots, steep = self._cross(index, level, tolerance) if index.size else (np.empty(0), np.empty(0))
        start = 0
        for k, value in enumerate(v):
            part = found[k]
            own, slope = roots[start : start + part.size], steep[start : start + part.size]
            start += part.size
            pieces = self.pieces
            rising = pieces.fa[part] <= value
            inside = np.where(rising, measure(pieces.a[part], own), measure(own, pieces.b[part]))
            whole = self.high <= value
            line = np.concatenate([pieces.line[whole], pieces.line[part]])
            share = np.concatenate([self.measures[whole], inside])
            shares[:, k] = np.bincount(line, share, minlength=weights.size)
            slopes[k] = (weights[pieces.line[part]] * density(own) / slope).sum()
        return shares, slopes

    def _cross(self, index: "Index", level: "Array", tolerance: float) -> "tuple[Array, Array]":
        """Where pieces cross a level: bracketed secant steps (Illinois), a bisection every third; and the slopes there.

        The test is value ≤ level, not a change of sign, so that jumps and flat stretches are bisected to their edge.
        """
        pieces = self.pieces
        line = pieces.line[index]
        a, b = pieces.a[index].copy(), pieces.b[index].copy()
        fa, fb = pieces.fa[index] - level, pieces.fb[index] - level
        under = fa <= 0.0
        steep = np.abs((fb - fa) / (b - a))
        ga, gb = fa.copy(), fb.copy()
        open_ = np.arange(index.size)
        root = 0.5 * (a + b)
        for step in range(60):
            la, lb, pa, pb = a[open_], b[open_], ga[open_], gb[open_]
            with np.errstate(all="ignore"):
                x = la - pa * (lb - la) / (pb - pa)
            width = lb - la
            middle = 0.5 * (la + lb)
            x = np.where((x > la) & (x < lb) & (step % 3 < 2), x, middle)
            root[open_] = x
            f = self.lines.at(line[open_], x) - level[open_]
            f = np.where(np.isnan(f), np.inf, f)
            first = (f <= 0.0) == under[open_]
            # The chord to the nearer end is the slope. One end may be at a pole, its chord far too steep: the flatter
            # of the two says how near the root is.
            with np.errstate(all="ignore"):
                ahead, behind = np.abs((fb[open_] - f) / (lb - x)), np.abs((f - fa[open_]) / (x - la))
                chord = np.where(lb - x < x - la, ahead, behind)
                flat = np.fmin(ahead, behind)
            steep[open_] = np.where(np.isfinite(chord) & (chord > 0.0), chord, steep[open_])
            # The end that stays loses half its weight (Illinois), so that it is not kept for ever.
            ga[open_] = np.where(first, f, 0.5 * pa)
            gb[open_] = np.where(first, 0.5 * pb, f)
            fa[open_], fb[open_] = np.where(first, f, fa[open_]), np.where(first, fb[open_], f)
            a[open_], b[open_] = np.where(first, x, la), np.where(first, lb, x)
            with np.errstate(all="ignore"):
                near = np.abs(f) <= 0.1 * tolerance * flat
            done = (width < tolerance) | near
            open_ = open_[~done]
            if not open_.size:
                break
        with np.errstate(divide="ignore"):
            return root, np.maximum(steep, 1e-300)

    def quantiles(self, p: "Array", tolerance: float) -> "tuple[Array, Array, Array]":
        """Quantiles given admissibility, P ≤ quantile on every line, and the density there: safeguarded Newton."""
        weights = self.lines.weights
        wanted = p * self.admissible
        low, high = np.full(p.size, self.low.min()), np.full(p.size, self.high.max())
        v = self._first(p)
        share, slope = np.empty((weights.size, p.size)), np.empty(p.size)
        active = np.arange(p.size)
        scale = max(float(np.ptp(v)), 1e-300) if p.size > 1 else max(float(high[0] - low[0]), 1e-300)
        for step in range(80):
            own, density_ = self.below(v[active], tolerance)
            share[:, active], slope[active] = own, density_
            excess = weights @ own - wanted[active]
            above = excess >= 0.0
            high[active] = np.where(above, np.minimum(high[active], v[active]), high[active])
            low[active] = np.where(above, low[active], np.maximum(low[active], v[active]))
            with np.errstate(all="ignore"):
                move = -excess / density_
            target = v[active] + move
            bad = ~((target > low[active]) & (target < high[active])) | (step > 12)
            settled = (np.abs(excess) <= 0.02 * tolerance) | (~bad & (np.abs(move) <= 0.1 * tolerance * scale))
            settled |= high[active] - low[active] <= 1e-14 * np.abs(v[active]) + 1e-300
            target = np.where(bad, 0.5 * (low[active] + high[active]), target)
            closed = high[active] - low[active] <= 4e-16 * np.abs(high[active])
            v[active] = np.where(settled & ~closed, v[active], np.where(closed, high[active], target))
            active = active[~(settled | closed)]
            if not active.size:
                break
        return v, share, slope

    def _first(self, p: "Array") -> "Array":
        """Quantiles of the scanned values themselves, each with the weight of its step."""
        mass = (self.lines.weights[:, None] * density(self.s) * self.step).ravel()
        flat = self.values.ravel()
        sound = ~np.isnan(flat) & (mass > 1e-12 / self.lines.weights.size)
        order = np.argsort(flat[sound])
        ranked = np.cumsum(mass[sound][order])
        place = np.searchsorted(ranked, p * ranked[-1])
        return flat[sound][order][np.minimum(place, ranked.size - 1)].copy()  # type: ignore[no-any-return]

    def moments(self, every: int = 1, start: int = 0) -> "tuple[Array, Array]":
        """First and second moment on every line (of admissible parts), (lines,), about the centre.

        The trapezoid rule on the scan is exact to rounding where a line is smooth and all admissible; elsewhere every
        piece is integrated by Gauss's three-point rule. With `every` = 2 only every second point is used, from `start`
        on: a test.
        """
        values, s = self.values[:, start::every] - self.centre, self.s[:, start::every]
        mass = density(s) * (self.step * every)
        with np.errstate(invalid="ignore"):
            first, second = (values * mass).sum(axis=1), (values * values * mass).sum(axis=1)
        rough = np.nonzero(self.broken)[0]
        if rough.size:
            first[rough], second[rough] = self._piecewise(rough)
        return first, second

    def beyond(self) -> "tuple[Array, Array]":
        """Estimate of both moments beyond the ends, (lines,): the decay is extrapolated."""
        mass = density(self.s) * self.step
        parts = []
        values = self.values - self.centre
        for part in (np.abs(values) * mass, values * values * mass):
            total = np.zeros(len(part))
            for last, before in ((part[:, 0], part[:, 1]), (part[:, -1], part[:, -2])):
                with np.errstate(all="ignore"):
                    share = last / before
                    total += np.where(last > 0.0, last * share / np.maximum(1.0 - share, self.step), 0.0)
            parts.append(np.where(np.isfinite(total), total, 0.0))
        return parts[0], parts[1]

    def broken_error(self) -> "tuple[float, float]":
        """How far both moments of the lines that are partly admissible move with a rule of two points for three."""
        rough = np.nonzero(self.broken)[0]
        if not rough.size:
            return 0.0, 0.0
        three, two = self._piecewise(rough), self._piecewise(rough, _GAUSS_OF_TWO)
        weights = self.lines.weights[rough]
        first, second = (float(weights @ (one - other)) for one, other in zip(three, two, strict=True))
        return abs(first), abs(second)

    def _piecewise(self, rough: "Index", rule: "tuple[Array, Array]" = _GAUSS) -> "tuple[Array, Array]":
        count = self.lines.weights.size
        chosen = np.isin(self.pieces.line, rough)
        line, a, b, edge = (getattr(self.pieces, name)[chosen] for name in ("line", "a", "b", "edge"))
        first, second = np.zeros(count), np.zeros(count)
        for node, weight in zip(*rule, strict=True):
            # towards an edge points crowd by the square of the way: a root's slope there is then none
            s = a + np.where(edge < 0.0, node * node, np.where(edge > 0.0, node * (2.0 - node), node)) * (b - a)
            along = np.where(edge < 0.0, 2.0 * node, np.where(edge > 0.0, 2.0 - 2.0 * node, 1.0))
            value = self.lines.at(line, s) - self.centre
            mass = np.where(np.isnan(value), 0.0, weight * along * (b - a) * density(s))
            value = np.where(np.isnan(value), 0.0, value)
            first += np.bincount(line, mass * value, minlength=count)
            second += np.bincount(line, mass * value * value, minlength=count)
        return first[rough], second[rough]


def measure(a: "Array", b: "Array") -> "Array":
    """P(a ≤ Z ≤ b), by the tails on whichever side both ends are."""
    ta, tb = tail(np.abs(a)), tail(np.abs(b))
    same = np.abs(ta - tb)
    return np.where((a < 0.0) & (b > 0.0), 1.0 - ta - tb, same)


def _joined(*parts: Pieces) -> Pieces:
    return Pieces(
        np.concatenate([p.line for p in parts]),
        *(np.concatenate([getattr(p, name) for p in parts]) for name in ("a", "b", "fa", "fb", "edge")),
    )
