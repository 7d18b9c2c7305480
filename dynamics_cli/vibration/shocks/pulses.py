"""Pulses of unit height as pieces a + b·t + Re(c·e^{ipt}), and the exact response of an oscillator to a piece."""

import math

import numpy as np

from dynamics_cli.records import Choice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# Below this of ω·t the terms of a constant and a ramp cancel; a power series answers there.
SMALL, TERMS = 0.3, 14
# Rise and fall of a trapezoid, each over its duration.
EDGE = 0.1


class Shape(Choice):
    """How the load goes over time."""

    names = ("step", "ramp", "rectangle", "half-sine", "triangle", "versed-sine", "sawtooth", "trapezoid")
    aliases = {  # noqa: RUF012
        "haversine": "versed-sine",
        "half sine": "half-sine",
        "terminal-peak-sawtooth": "sawtooth",
        "trapezoidal": "trapezoid",
        "square": "rectangle",
    }


class Piece:
    """A stretch of the load from `start` to `end` (without end: infinite)."""

    def __init__(
        self, start: float, end: float, a: "Any" = 0.0, b: "Any" = 0.0, c: complex = 0.0, p: float = 0.0
    ) -> None:
        self.start, self.end = start, end
        self.a, self.b, self.c, self.p = a, b, c, p

    def at(self, t: "Any") -> "Any":
        """The load, `t` from the start of the piece."""
        wave = (self.c * np.exp(1j * self.p * t)).real if self.c else 0.0
        return self.a + self.b * t + wave


def pieces(shape: str, tau: float) -> "list[Piece]":
    """The pieces of a pulse of unit height and duration τ; a last one without end where it leaves a load."""
    if shape == "step":
        return [Piece(0.0, math.inf, a=1.0)]
    if shape == "ramp":
        return [Piece(0.0, tau, b=1.0 / tau), Piece(tau, math.inf, a=1.0)]
    if shape == "rectangle":
        made = [Piece(0.0, tau, a=1.0)]
    elif shape == "half-sine":
        made = [Piece(0.0, tau, c=-1j, p=math.pi / tau)]
    elif shape == "versed-sine":
        made = [Piece(0.0, tau, a=0.5, c=-0.5, p=2.0 * math.pi / tau)]
    elif shape == "sawtooth":
        made = [Piece(0.0, tau, b=1.0 / tau)]
    elif shape == "trapezoid":
        rise = EDGE * tau
        made = [
            Piece(0.0, rise, b=1.0 / rise),
            Piece(rise, tau - rise, a=1.0),
            Piece(tau - rise, tau, a=1.0, b=-1.0 / rise),
        ]
    else:
        made = [Piece(0.0, 0.5 * tau, b=2.0 / tau), Piece(0.5 * tau, tau, a=1.0, b=-2.0 / tau)]
    return [*made, Piece(tau, math.inf)]


def _sinhc(z: "Any") -> "Any":
    """sinh(z)/z of complex numbers."""
    small = abs(z) < 1e-3
    safe = np.where(small, 1.0, z)
    return np.where(small, 1.0 + z * z / 6.0 * (1.0 + z * z / 20.0), np.sinh(safe) / safe)


class Oscillators:
    """Oscillators of one damping ratio, or one each: z̈ + 2ζω·ż + ω²·z = load, state (z, ż)."""

    def __init__(self, omega: "Any", zeta: "Any") -> None:
        self.omega = np.asarray(omega, dtype=float)
        self.zeta = zeta
        self.sigma = zeta * self.omega
        self.damped = self.omega * np.sqrt((1.0 - zeta) * (1.0 + zeta) + 0j)
        # exponents of e^(λt); with heavy damping the slow one would be a difference of almost equal numbers
        self.exponent = -self.sigma + 1j * self.damped
        self.other = -self.sigma - 1j * self.damped
        heavy = self.damped.imag > 0.0
        self.other = np.where(heavy, self.omega * self.omega / np.where(heavy, self.exponent, 1.0), self.other)

    def some(self, which: "Any") -> "Oscillators":
        """Those of an index or a mask."""
        return Oscillators(self.omega[which], self.zeta)

    def kernel(self, t: "Any") -> "tuple[Any, Any]":
        """e^{−σt}·sin(ω_d·t)/ω_d, and e^{−σt}·cos(ω_d·t), for damping of any size."""
        one, other = np.exp(self.exponent * t), np.exp(self.other * t)
        z = 1j * self.damped * t
        near = abs(z) < 1.0
        series = t * np.exp(-self.sigma * t) * _sinhc(np.where(near, z, 0.0))
        with np.errstate(all="ignore"):
            direct = (one - other) / (2j * self.damped)
        return np.where(near, series, direct).real, (0.5 * (one + other)).real

    def after(self, z: "Any", v: "Any", piece: Piece, t: "Any") -> "tuple[Any, Any]":
        """The state after `t` of a piece, from the state at its start."""
        s, c = self.kernel(t)
        square = self.omega * self.omega
        place = z * c + (v + self.sigma * z) * s
        pace = v * c - (self.sigma * v + square * z) * s
        if np.any(piece.a) or np.any(piece.b):
            x, y = self._straight(piece.a, piece.b, t, s, c)
            place, pace = place + x, pace + y
        if piece.c:
            x, y = self._wave(piece.c, piece.p, t, s)
            place, pace = place + x, pace + y
        return place, pace

    def _straight(self, a: "Any", b: "Any", t: "Any", s: "Any", c: "Any") -> "tuple[Any, Any]":
        """From rest under a + b·t: closed form, a power series where ω·t is small."""
        omega, square = self.omega, self.omega * self.omega
        small = omega * t < SMALL
        with np.errstate(all="ignore"):
            settled = a / square - 2.0 * self.zeta * b / (omega * square)
            slope = b / square
            place = settled * (1.0 - c - self.sigma * s) + slope * (t - s)
            pace = settled * square * s + slope * (1.0 - c + self.sigma * s)
        if not np.any(small):
            return place, pace
        terms: list[Any] = [0.0, 0.0]
        for k in range(TERMS):
            load = a if k == 0 else b if k == 1 else 0.0
            rest = load - 2.0 * self.sigma * (k + 1) * terms[k + 1] - square * terms[k]
            terms.append(rest / ((k + 1) * (k + 2)))
        x: Any = 0.0
        y: Any = 0.0
        short = np.where(small, t, 0.0)
        for k in range(TERMS + 1, 0, -1):
            x = x * short + terms[k]
            y = y * short + k * terms[k]
        return np.where(small, x * short, place), np.where(small, y, pace)

    def _wave(self, c: complex, p: float, t: "Any", s: "Any") -> "tuple[Any, Any]":
        """From rest under Re(c·e^{ipt}): divided differences of the exponential, at resonance as well."""
        one, other = self.exponent, self.other
        z = 0.5 * (1j * p - one) * t
        near = abs(z) < 1.0
        series = t * np.exp(0.5 * (1j * p + one) * t) * _sinhc(np.where(near, z, 0.0))
        with np.errstate(all="ignore"):
            first = np.where(near, series, (np.exp(1j * p * t) - np.exp(one * t)) / (1j * p - one))
        place = (first - s) / (1j * p - other)
        return (c * place).real, (c * (other * place + first)).real

    def second(self, z: "Any", v: "Any", load: "Any") -> "Any":
        """z̈."""
        return load - 2.0 * self.sigma * v - self.omega * self.omega * z


def slopes(of: Oscillators, state: "tuple[Any, Any]", piece: Piece, t: "Any", mix: "tuple[Any, Any]") -> "Any":
    """Value, first and second derivative of y = α·z + β·ż, `t` after the start of a piece."""
    z, v = state
    load = piece.at(t)
    wave = (1j * piece.p * piece.c * np.exp(1j * piece.p * t)).real if piece.c else 0.0
    rate = of.second(z, v, load)
    third = piece.b + wave - 2.0 * of.sigma * rate - of.omega * of.omega * v
    alpha, beta = mix
    return alpha * z + beta * v, alpha * v + beta * rate, alpha * rate + beta * third
