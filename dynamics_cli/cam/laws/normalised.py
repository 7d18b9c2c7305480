"""Normalised rise laws f(x), 0 ≤ x ≤ 1, f(0) = 0, f(1) = 1, with exact derivatives.

`law_named("cycloidal").at(x)` gives (f, f', f'', f''') for a float or an array; `side=-1` takes the left value where a
derivative jumps. A law is a few pieces, each measured from the end of the rise it is nearest to, so that f and 1 − f
both keep their digits; `breaks` are the inner places where some derivative jumps.
"""

from bisect import bisect_left, bisect_right
from math import fsum, pi

from dynamics_cli.cam.laws.components import Beta, EndOfDoubleHarmonic, FourthPowerOfSine, Mixed
from dynamics_cli.cam.laws.names import LawName
from dynamics_cli.cam.laws.share_constants import constants_of
from dynamics_cli.errors import require
from dynamics_cli.numerics.number import is_array
from dynamics_cli.quantities import Ratio

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any


SMALLEST_SHARE = 1e-12
# Error of amplitudes and frequencies in half units in the last place: of one wave, of several, of shares.
ONE_WAVE, SEVERAL, ROUNDED = (1.4, 0.4), (3.4, 1.4), (1.0, 1.0)


class Piece:
    """A law from `low` to `high`; `far` pieces give 1 − f of 1 − x. `ends`: ends in the shape's own coordinate."""

    __slots__ = ("ends", "far", "high", "low", "shape")

    def __init__(
        self,
        low: float,
        high: float,
        far: bool,
        shape: "Callable[[Any, int], list[Any]]",
        ends: "tuple[float, float] | None" = None,
    ) -> None:
        self.low = low
        self.high = high
        self.far = far
        self.shape = shape
        self.ends = ends or ((1.0 - high, 1.0 - low) if far else (low, high))


class Law:
    """A rise law: its pieces in order, inner places where a derivative jumps, whether its ends rest, and f(1)."""

    __slots__ = ("breaks", "edges", "known", "monotone", "name", "pieces", "rests", "steps", "total")

    def __init__(
        self,
        name: str,
        pieces: "Sequence[Piece]",
        breaks: "Sequence[float]" = (),
        *,
        monotone: bool = True,
        rests: tuple[bool, bool] = (True, True),
        total: float = 1.0,
        steps: "tuple[float, float] | None" = None,
    ) -> None:
        self.name = name
        self.pieces = tuple(pieces)
        self.breaks = tuple(breaks)
        self.monotone = monotone
        self.rests = rests
        self.total = total
        # decimal steps that places and lifts of the points are multiples of, where the law goes through points
        self.steps = steps
        # cached results about the law: extremes by order, peaks, bounds, areas
        self.known: dict[Any, Any] = {}
        self.edges = [piece.high for piece in self.pieces[:-1]]

    def at(self, x: "Any", derivatives: int = 3, side: int = 1) -> "tuple[Any, ...]":
        """F and its derivatives at x, a float or an array within 0 and 1; `side` chooses where one jumps."""
        if is_array(x):
            return self._over_array(x, derivatives, side)
        find = bisect_right if side > 0 else bisect_left
        piece = self.pieces[find(self.edges, x)]
        return tuple(self.upright(piece, (1.0 - x) if piece.far else x, derivatives))

    def _over_array(self, x: "Any", derivatives: int, side: int) -> "tuple[Any, ...]":
        import numpy as np

        orders = np.empty((derivatives + 1, *x.shape))
        which = np.searchsorted(self.edges, x, side="right" if side > 0 else "left")
        for index, piece in enumerate(self.pieces):
            inside = which == index
            if inside.any():
                t = 1.0 - x[inside] if piece.far else x[inside]
                for order, values in enumerate(self.upright(piece, t, derivatives)):
                    orders[order][inside] = values
        return tuple(orders)

    def upright(self, piece: Piece, t: "Any", derivatives: int) -> "list[Any]":
        """F and its derivatives from one piece, t measured from the end that the piece is measured from."""
        orders = piece.shape(t, derivatives)
        if piece.far:
            orders = [self.total - orders[0]] + [-g if order % 2 else g for order, g in enumerate(orders[1:])]
        return orders


def symmetric(name: str, shapes: "Sequence[tuple[float, Any]]", *, smooth: bool = True) -> Law:
    """Make a law of f(x) = 1 − f(1 − x) from (upper edge, shape) pairs of its first half, `smooth` across."""
    pieces = []
    low = 0.0
    for high, shape in shapes:
        if high > low:
            pieces.append(Piece(low, high, False, shape))
            low = high
    pieces += [
        Piece(1.0 - piece.high, 1.0 - piece.low, True, piece.shape, (piece.low, piece.high))
        for piece in reversed(pieces)
    ]
    breaks = [piece.high for piece in pieces[:-1] if not (smooth and piece.high == 0.5)]
    return Law(name, pieces, breaks)


def _fourier(name: str, *terms: tuple[int, float]) -> Law:
    """Σ c/(2πk)·(2πkx − sin 2πkx), Σ c = 1."""
    waves = [(weight / (2.0 * pi * k), 2.0 * pi * k, 0) for k, weight in terms]
    return symmetric(name, [(0.5, Mixed(waves=waves, near=ONE_WAVE if len(terms) == 1 else SEVERAL))])


def scca(b: float, c: float, d: float, constant: float = 0.0, name: str = "") -> Law:
    """Sine, constant, cosine acceleration in shares b, c, d of each half, with constant velocity in between.

    `b`, `c`, `d`: shares of the sine, the constant and the cosine; their sum is 1; `constant`: share of the rise at
    constant velocity; `name`: name of the law. Raises InadmissibleError when a share is negative, the shares do not sum
    to 1, or they leave no share for the acceleration.

    (0, 1, 0) is parabolic, (¼, ½, ¼) the modified trapezoid, (0, 0, 1) simple harmonic, (¼, 0, ¾) the modified sine,
    (½, 0, ½) cycloidal. b = 0 or d = 0 makes the acceleration jump.

    Equation
    --------
    Of the first half, a = C_a sin(πx/2r) to r, C_a to r + k, then C_a cos(π(x − r − k)/2g) to q = r + k + g, then none
    to ½; r = b q, k = c q, g = d q, q = (1 − constant)/2. C_a follows from f(½) = ½.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 16.9 and 16.11 to 16.14; laws of VDI 2143
    as commonly published.

    Examples
    --------
    >>> round(max(scca(0.25, 0.5, 0.25).at(x / 100)[2] for x in range(51)), 4)
    4.8881
    """
    shares: Any = {"b": (b, Ratio), "c": (c, Ratio), "d": (d, Ratio)}
    require(min(b, c, d) >= 0.0, "the shares are {b:6}, {c:6} and {d:6}; none may be negative", code="shares", **shares)
    require(
        abs(b + c + d - 1.0) <= 4e-16,
        "the shares {b:6}, {c:6} and {d:6} sum to {sum:17}; wanted 1",
        code="shares",
        hint="a third share of {rest:6} fits the first two",
        sum=(b + c + d, Ratio),
        rest=(1.0 - b - c, Ratio),
        **shares,
    )
    require(
        all(share == 0.0 or share >= SMALLEST_SHARE for share in (b, c, d)),
        "the shares are {b:6}, {c:6} and {d:6}; a share is zero or at least {least}",
        code="shares",
        hint="give 0 for the smaller share",
        least=(SMALLEST_SHARE, Ratio),
        **shares,
    )
    require(
        0.0 <= constant < 1.0,
        "with a share of {constant:6} at constant velocity no angle remains for acceleration",
        code="constant",
        constant=(constant, Ratio),
    )
    q = 0.5 * (1.0 - constant)
    r, k, g = b * q, c * q, d * q
    still = 0.5 * constant
    top, speed, first, reached, gained, last, rates = constants_of(b, c, d, constant)
    # doubles that should sum to 1 do so within rounding; which of them is in error is unknown
    off = abs(fsum((b, c, d, -1.0)))
    shapes: list[tuple[float, Any]] = []
    if r:
        shapes.append((r, Mixed(waves=[(first[0], rates[0], 0)], off=off, near=ROUNDED)))
    if k:
        shapes.append((r + k, Mixed((first[1], first[2], 0.5 * top), origin=r, off=off, near=ROUNDED)))
    if g:
        wave = (last, rates[1], 1)
        shapes.append((q, Mixed((reached, gained) if r or k else (), [wave], origin=r + k, off=off, near=ROUNDED)))
    if still:
        shapes.append((0.5, Mixed((0.5, -speed), origin=0.5, backwards=True, off=off, near=ROUNDED)))
    return symmetric(name or "scca", shapes, smooth=g > 0.0 or still > 0.0)


def _trapezoid() -> Law:
    slope = 128.0 / 3.0
    first = Mixed((0.0, 0.0, 0.0, slope / 6.0))
    flat = Mixed((slope / 3072.0, slope / 128.0, slope / 16.0), origin=0.125)
    last = Mixed((0.5, -2.0, 0.0, slope / 6.0), origin=0.5, backwards=True)
    return symmetric("trapezoid", [(0.125, first), (0.375, flat), (0.5, last)])


def _two_ended(name: str, start: "Any", end: "Any", rests: tuple[bool, bool] = (True, True)) -> Law:
    return Law(name, (Piece(0.0, 0.5, False, start), Piece(0.5, 1.0, True, end)), rests=rests)


def _half(name: str, slow: Mixed, fast: Mixed) -> Law:
    """One end is at rest, the other moves at full speed."""
    if name.endswith("start"):
        return _two_ended(name, slow, fast, (True, False))
    return _two_ended(name, fast, slow, (False, True))


def _half_cycloid(name: str) -> Law:
    slow = Mixed(waves=[(1.0 / pi, pi, 0)], near=ONE_WAVE)
    return _half(name, slow, Mixed((0.0, 2.0), [(-1.0 / pi, pi, 0)], near=ONE_WAVE))


def _half_harmonic(name: str) -> Law:
    slow, fast = (Mixed(waves=[(1.0, 0.5 * pi, start)], near=ONE_WAVE) for start in (1, 2))
    return _half(name, slow, fast)


def _linear() -> Law:
    shape = Mixed((0.0, 1.0))
    return _two_ended("linear", shape, shape)


_MAKERS: "dict[str, Callable[[], Law]]" = {
    "linear": _linear,
    "parabolic": lambda: symmetric("parabolic", [(0.5, Mixed((0.0, 0.0, 2.0)))], smooth=False),
    "cubic": lambda: symmetric("cubic", [(0.5, Beta(1))]),
    "harmonic": lambda: symmetric("harmonic", [(0.5, Mixed(waves=[(0.5, pi, 1)], near=ONE_WAVE))]),
    "double-harmonic": lambda: _two_ended("double-harmonic", FourthPowerOfSine(), EndOfDoubleHarmonic()),
    "cycloidal": lambda: _fourier("cycloidal", (1, 1.0)),
    "modified-trapezoid": lambda: scca(0.25, 0.5, 0.25, name="modified-trapezoid"),
    "modified-sine": lambda: scca(0.25, 0.0, 0.75, name="modified-sine"),
    "trapezoid": _trapezoid,
    "3-4-5": lambda: symmetric("3-4-5", [(0.5, Beta(2))]),
    "4-5-6-7": lambda: symmetric("4-5-6-7", [(0.5, Beta(3))]),
    "5-6-7-8-9": lambda: symmetric("5-6-7-8-9", [(0.5, Beta(4))]),
    "gutman-1-3": lambda: _fourier("gutman-1-3", (1, 15.0 / 16.0), (3, 1.0 / 16.0)),
    "freudenstein-1-3": lambda: _fourier("freudenstein-1-3", (1, 27.0 / 28.0), (3, 1.0 / 28.0)),
    "freudenstein-1-3-5": lambda: _fourier(
        "freudenstein-1-3-5", (1, 1125.0 / 1192.0), (3, 62.5 / 1192.0), (5, 4.5 / 1192.0)
    ),
    "half-cycloid-start": lambda: _half_cycloid("half-cycloid-start"),
    "half-cycloid-end": lambda: _half_cycloid("half-cycloid-end"),
    "half-harmonic-start": lambda: _half_harmonic("half-harmonic-start"),
    "half-harmonic-end": lambda: _half_harmonic("half-harmonic-end"),
}

CONSTANT_SHARE = 0.5
MOST_REMEMBERED = 256
_known_laws: "dict[str | tuple[str, float, float, float, float], Law]" = {}


def _remembered(name: str, b: float, c: float, d: float, constant: float) -> Law:
    """The law of these shares, cached with its results while there are few of them."""
    key = (name, b, c, d, constant)
    if key not in _known_laws:
        law = scca(b, c, d, constant, name)
        if len(_known_laws) >= MOST_REMEMBERED:
            return law
        _known_laws[key] = law
    return _known_laws[key]


def law_named(name: str, shares: "tuple[float, ...] | None" = None, constant: float | None = None) -> Law:
    """Give the law of that name; `shares` (b, c, d) belong to scca, `constant` to modified constant velocity.

    `name`: a name or alias of `LawName`; `shares`: shares b, c, d of sine, constant and cosine acceleration;
    `constant`: share of the rise at constant velocity, one half when not given. Raises InadmissibleError when shares
    are missing, or given to a law that has none.

    Examples
    --------
    >>> law_named("bestehorn").at(0.5)[:2]
    (0.5, 2.0)
    """
    name = LawName(name)
    require(
        shares is None or name == "scca",
        "the law {name} has no shares",
        name=name,
        code="shares",
        hint="leave them out, or take scca",
    )
    require(
        constant is None or name in ("scca", "modified-constant-velocity"),
        "the law {name} has no share at constant velocity",
        name=name,
        code="constant",
        hint="leave it out, or take modified-constant-velocity",
    )
    if name == "scca":
        require(
            shares is not None and len(shares) == 3,
            "scca needs its shares b, c, d",
            code="shares",
            hint="for example 0.25, 0.5, 0.25",
        )
        b, c, d = shares or ()
        return _remembered(str(name), b, c, d, constant or 0.0)
    if name == "modified-constant-velocity":
        return _remembered(str(name), 0.25, 0.0, 0.75, CONSTANT_SHARE if constant is None else constant)
    require(
        name in _MAKERS,
        "the law {name} needs {what}",
        name=name,
        what="points" if name == "spline" else "conditions at its ends",
        code="law-needs-more",
    )
    if name not in _known_laws:
        _known_laws[name] = _MAKERS[name]()
    return _known_laws[name]
