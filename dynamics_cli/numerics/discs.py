"""Arithmetic of discs: all values an expression takes when its arguments lie in discs about real numbers, on arrays.

A `Disc` is a real centre and a radius; it represents the complex numbers within the radius of the centre, and hence a
real interval. Every operation gives a disc that contains the exact result for all numbers of its arguments, with its
own rounding inside the radius: with radii zero it bounds the rounding of a computation, on real cells it is interval
arithmetic in midpoint-radius form, and on discs of the complex plane it bounds an analytic function around a piece,
from which the remainder of its Chebyshev interpolant follows.

Centres are rounded to nearest, u = 2⁻⁵³; a radius is computed in at most a dozen such operations on numbers that are
not negative, and multiplied by 1 + 2⁻⁴⁸. Sines, cosines, arc tangents, exponentials and hyperbolic functions of NumPy
are taken to be within four units in the last place; short arrays of sines, cosines and arc tangents use the C library,
which is within one.
"""

import math
from math import inf

import numpy as np

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

# relative error of an operation rounded to nearest
EPS = 2.0**-53
# four units in the last place and a little
LIBRARY = 2.0**-50
# up to this many numbers functions are evaluated one by one, within one unit in the last place
FEW = 64
UP = 1.0 + 2.0**-48
# more than a product or quotient loses to underflow
TINY = 1e-300


class Disc:
    """Complex numbers within `radius` of the real `centre`, both arrays or floats.

    `radius`: radii, not negative; infinite or NaN where nothing is known. The centre is then the value of plain
    arithmetic.

    References
    ----------
    I. Gargantini, P. Henrici, Circular arithmetic and the determination of polynomial zeros, Numer. Math. 18
    (1972) 305; S. M. Rump, Fast and parallel interval arithmetic, BIT 39 (1999) 534.
    """

    __slots__ = ("centre", "radius")
    __array_priority__ = 100.0

    def __init__(self, centre: "Any", radius: "Any" = 0.0) -> None:
        self.centre = centre
        self.radius = radius

    @property
    def size(self) -> "Any":
        """Upper bound of the magnitudes."""
        return (np.abs(self.centre) + self.radius) * UP

    @property
    def least(self) -> "Any":
        """Lower bound of the real parts."""
        low = self.centre - self.radius
        return low - EPS * np.abs(low)

    @property
    def shape(self) -> "tuple[int, ...]":
        """Shape of the centres."""
        return np.shape(self.centre)

    def widened(self, more: "Any") -> "Disc":
        """The disc with its radius increased."""
        return Disc(self.centre, (self.radius + more) * UP)

    def __getitem__(self, key: "Any") -> "Disc":
        radius = np.broadcast_to(self.radius, np.broadcast_shapes(np.shape(self.centre), np.shape(self.radius)))
        return Disc(np.broadcast_to(self.centre, radius.shape)[key], radius[key])

    def __neg__(self) -> "Disc":
        return Disc(-self.centre, self.radius)

    def __add__(self, other: "Any") -> "Disc":
        if isinstance(other, Disc):
            centre = self.centre + other.centre
            return Disc(centre, (self.radius + other.radius + EPS * np.abs(centre)) * UP)
        centre = self.centre + other
        return Disc(centre, (self.radius + EPS * np.abs(centre)) * UP)

    __radd__ = __add__

    def __sub__(self, other: "Any") -> "Disc":
        opposite: Any = -other
        return self.__add__(opposite)

    def __rsub__(self, other: "Any") -> "Disc":
        return self.__neg__().__add__(other)

    def __mul__(self, other: "Any") -> "Disc":
        if isinstance(other, Disc):
            centre = self.centre * other.centre
            wide = np.abs(self.centre) * other.radius + self.radius * (np.abs(other.centre) + other.radius)
            return Disc(centre, (wide + EPS * np.abs(centre)) * UP + TINY)
        if isinstance(other, float) and other in (1.0, -1.0, 0.0):
            return self if other == 1.0 else -self if other else Disc(0.0 * self.centre, 0.0 * self.centre)
        centre = self.centre * other
        return Disc(centre, (self.radius * np.abs(other) + EPS * np.abs(centre)) * UP + TINY)

    __rmul__ = __mul__

    def __truediv__(self, other: "Any") -> "Disc":
        if isinstance(other, Disc):
            return self.__mul__(other.inverse())
        return self.__mul__(Disc(1.0 / other, EPS * abs(1.0 / other)))

    def __rtruediv__(self, other: "Any") -> "Disc":
        return self.inverse().__mul__(other)

    def inverse(self) -> "Disc":
        """The reciprocals; nothing is known where zero is among the numbers."""
        size = np.abs(self.centre)
        apart = size - self.radius
        with np.errstate(all="ignore"):
            centre = 1.0 / self.centre
            wide = (self.radius / (size * apart) + EPS * np.abs(centre)) * UP + TINY
        return Disc(centre, np.where(apart > 0.0, wide, inf))

    def square(self) -> "Disc":
        """The squares."""
        centre = self.centre * self.centre
        wide = self.radius * (2.0 * np.abs(self.centre) + self.radius)
        return Disc(centre, (wide + EPS * centre) * UP + TINY)

    def root(self) -> "Disc":
        """The square roots; nothing is known where zero or a negative number is among the numbers."""
        apart = self.centre - self.radius
        good = apart > 0.0
        with np.errstate(invalid="ignore"):
            centre = np.sqrt(self.centre)
        # |√z − √m| = |z − m|/|√z + √m|, and Re √z ≥ √(m − r)
        wide = self.radius / (np.where(good, centre, 1.0) + np.sqrt(np.where(good, apart, 1.0)))
        return Disc(centre, np.where(good, (wide + EPS * centre) * UP, inf))

    def sine(self) -> "Disc":
        """The sines: |sin z − sin m| ≤ |cos m| sinh r + |sin m| (cosh r − 1)."""
        (sine, library_error), (cosine, _) = _library("sin", self.centre), _library("cos", self.centre)
        return _wave(sine, cosine, self.radius, library_error)

    def cosine(self) -> "Disc":
        """The cosines: |cos z − cos m| ≤ |sin m| sinh r + |cos m| (cosh r − 1)."""
        (cosine, library_error), (sine, _) = _library("cos", self.centre), _library("sin", self.centre)
        return _wave(cosine, sine, self.radius, library_error)

    def exponential(self) -> "Disc":
        """The exponentials."""
        centre = np.exp(self.centre)
        return Disc(centre, centre * (np.expm1(self.radius) * (1.0 + LIBRARY) + LIBRARY) * (UP + LIBRARY) + TINY)

    def logarithm(self) -> "Disc":
        """The logarithms; nothing is known where zero or a negative number is among the numbers."""
        good = self.centre > self.radius
        part = np.where(good, self.radius / np.where(good, self.centre, 1.0) * UP, 0.0)
        with np.errstate(all="ignore"):
            centre = np.log(self.centre)
        wide = -np.log1p(-part * UP) * (1.0 + LIBRARY)
        return Disc(centre, np.where(good & (part * UP < 1.0), (wide + LIBRARY * np.abs(centre)) * UP + TINY, inf))

    def arc_cosine(self) -> "Disc":
        """The arc cosines: 1/|√(1 − z²)| is largest at an end of the real diameter."""
        size = np.abs(self.centre)
        # (1 − z)(1 + z) on the disc, each factor by its least magnitude
        near, other = (1.0 - size) - self.radius, (1.0 + size) - self.radius
        good = near > 0.0
        steep = 1.0 / np.sqrt(np.where(good, near * other, 1.0))
        wide = np.where(good, self.radius * steep * (1.0 + 8.0 * EPS / np.where(good, near, 1.0)), inf)
        centre = np.arccos(np.clip(self.centre, -1.0, 1.0))
        return Disc(centre, (np.where(self.radius == 0.0, 0.0, wide) + LIBRARY * np.abs(centre)) * UP)

    def arc_sine(self) -> "Disc":
        """The arc sines, bounded like the arc cosines."""
        centre = np.arcsin(np.clip(self.centre, -1.0, 1.0))
        return Disc(centre, (self.arc_cosine().radius + LIBRARY * np.abs(centre)) * UP)

    def clipped(self, low: float, high: float) -> "Disc":
        """Numbers clipped to two limits; nothing is known where a limit is among them."""
        within = (self.centre - self.radius > low) & (self.centre + self.radius < high)
        outside = (self.centre + self.radius < low) | (self.centre - self.radius > high)
        return Disc(np.clip(self.centre, low, high), np.where(within, self.radius, np.where(outside, 0.0, inf)))


def arc_tangent(y: "Any", x: "Any") -> Disc:
    """The angles arctan2(y, x), analytic where neither x + iy nor x − iy vanishes; unbounded across the cut.

    2i·arctan2(y, x) = log(x + iy) − log(x − iy), and a logarithm moves by −log(1 − d/ρ) at most when its argument, of
    magnitude ρ, moves by d: by d/ρ, and (d/ρ)²/(2(1 − d/ρ)) at most beyond the first order, which is
    (x dy − y dx)/ρ² of both together.
    """
    y, x = as_disc(y), as_disc(x)
    away = np.hypot(x.centre, y.centre) * (1.0 - LIBRARY)
    part = (x.radius + y.radius) * UP / np.where(away > 0.0, away, 1.0)
    moved = part == 0.0
    clear = ((x.centre > x.radius) | (np.abs(y.centre) > y.radius) | moved) & (part < 1.0) & (away > 0.0)
    centre, library_error = _library("atan2", y.centre, x.centre)
    part = np.where(clear, part, 0.0)
    wide = -np.log1p(-part * UP) * (1.0 + LIBRARY)
    first = (np.abs(x.centre) * y.radius + np.abs(y.centre) * x.radius) / np.where(away > 0.0, away * away, 1.0)
    wide = np.minimum(wide, first * UP + 0.5 * part * part * UP / np.where(part < 0.9, 1.0 - part, TINY))
    # along the axis the angle does not change
    wide = np.where((y.centre == 0.0) & (y.radius == 0.0), 0.0, wide)
    return Disc(centre, np.where(clear, (wide + library_error) * UP + TINY, inf))


def _library(name: str, *arguments: "Any") -> "tuple[Any, Any]":
    """A function of the C library on a few numbers, of NumPy on many, with its error."""
    if np.size(arguments[0]) <= FEW and all(np.isfinite(item).all() for item in arguments):
        broadcast = np.broadcast_arrays(*arguments)
        if broadcast[0].size <= FEW:
            function = getattr(math, name)
            values = [
                function(*numbers) for numbers in zip(*(item.ravel().tolist() for item in broadcast), strict=True)
            ]
            value = np.array(values).reshape(broadcast[0].shape)
            return value, np.spacing(np.abs(value))
    value = {"sin": np.sin, "cos": np.cos, "atan2": np.arctan2}[name](*arguments)
    return value, LIBRARY * np.abs(value)


def _wave(centre: "Any", slope: "Any", radius: "Any", library_error: "Any") -> Disc:
    half = np.sinh(0.5 * radius)
    # cosh r − 1 = 2 sinh²(r/2), sinh r = 2 sinh(r/2) cosh(r/2)
    wide = 2.0 * half * ((np.abs(slope) + LIBRARY) * np.sqrt(1.0 + half * half) + (np.abs(centre) + LIBRARY) * half)
    return Disc(centre, (wide * (1.0 + 4.0 * LIBRARY) + library_error) * UP + TINY)


def as_disc(value: "Any") -> Disc:
    """A number as a disc of radius zero; a disc unchanged."""
    return value if isinstance(value, Disc) else Disc(value, 0.0)


def _stack(parts: "Any", axis: int = 0) -> Disc:
    discs = [as_disc(part) for part in parts]
    centres = np.broadcast_arrays(*(part.centre for part in discs))
    radii = np.broadcast_arrays(*(part.radius for part in discs))
    return Disc(np.stack(centres, axis), np.stack(radii, axis))


def _together(*parts: "Any") -> "tuple[Disc, ...]":
    discs = [as_disc(part) for part in parts]
    shape = np.broadcast_shapes(*(np.shape(part.centre) for part in discs), *(np.shape(part.radius) for part in discs))
    return tuple(Disc(np.broadcast_to(part.centre, shape), np.broadcast_to(part.radius, shape)) for part in discs)


_UFUNCS: "dict[Any, Callable[..., Any]]" = {
    np.add: lambda a, b: as_disc(a) + b,
    np.subtract: lambda a, b: as_disc(a) - b,
    np.multiply: lambda a, b: as_disc(a) * b,
    np.true_divide: lambda a, b: as_disc(a) / b,
    np.negative: lambda a: -a,
    np.square: Disc.square,
    np.sqrt: Disc.root,
    np.sin: Disc.sine,
    np.cos: Disc.cosine,
    np.exp: Disc.exponential,
    np.log: Disc.logarithm,
    np.arccos: Disc.arc_cosine,
    np.arcsin: Disc.arc_sine,
    np.arctan2: arc_tangent,
    np.hypot: lambda a, b: (as_disc(a).square() + as_disc(b).square()).root(),
}
_FUNCTIONS: "dict[Any, Callable[..., Any]]" = {
    np.stack: _stack,
    np.broadcast_arrays: _together,
    np.clip: lambda a, low, high: a.clipped(low, high),
    np.zeros_like: lambda a: Disc(np.zeros_like(a.centre), np.zeros_like(a.centre)),
    np.ones_like: lambda a: Disc(np.ones_like(a.centre), np.zeros_like(a.centre)),
}


def _array_ufunc(self: Disc, ufunc: "Any", method: str, *inputs: "Any", **keywords: "Any") -> "Any":
    """Functions of NumPy on discs: a formula written for arrays is one for discs."""
    if method != "__call__" or keywords or ufunc not in _UFUNCS:
        return NotImplemented
    return _UFUNCS[ufunc](*inputs)


def _array_function(self: Disc, function: "Any", types: "Any", args: "Any", keywords: "Any") -> "Any":
    """The few functions of NumPy beside its ufuncs that formulas use."""
    return _FUNCTIONS[function](*args, **keywords) if function in _FUNCTIONS else NotImplemented


Disc.__array_ufunc__ = _array_ufunc  # type: ignore[attr-defined]
Disc.__array_function__ = _array_function  # type: ignore[attr-defined]
