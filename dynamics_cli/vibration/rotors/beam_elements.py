"""A stepped shaft with disks on bearings as beam elements, in complex coordinates: M·z̈ − iΩG·ż + K·z = 0."""

import math
from itertools import pairwise

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

# Places nearer than this share of the length are one.
SAME = 1e-9


class Matrices:
    """Mass, gyroscopic and stiffness matrix, of real numbers: a deflection x + iy and its slope at every station."""

    def __init__(self, stations: "list[float]") -> None:
        import numpy as np

        self.stations = stations
        size = 2 * len(stations)
        self.mass, self.gyroscopic, self.stiffness = (np.zeros((size, size)) for _ in range(3))
        self.held: list[int] = []

    def nearest(self, position: float) -> int:
        """The station at a position."""
        return min(range(len(self.stations)), key=lambda k: abs(self.stations[k] - position))

    def add_element(self, number: int, bending: float, shearing: float, line_mass: float, line_inertia: float) -> None:
        """A beam element of Timoshenko from a station to the next, with the rotation of its sections."""
        import numpy as np

        length = self.stations[number + 1] - self.stations[number]
        span = slice(2 * number, 2 * number + 4)
        scale = np.outer([1.0, length, 1.0, length], [1.0, length, 1.0, length])
        # deflection by shear over that by bending
        f = 12.0 * bending / (shearing * length**2)
        self.stiffness[span, span] += bending / (length**3 * (1.0 + f)) * scale * _even(12, 6, -12, 6, 4 + f, 2 - f)
        shift = _even(
            312 + 588 * f + 280 * f * f, 44 + 77 * f + 35 * f * f, 108 + 252 * f + 140 * f * f,
            -(26 + 63 * f + 35 * f * f), 8 + 14 * f + 7 * f * f, -(6 + 14 * f + 7 * f * f),
        )  # fmt: skip
        tilt = _even(36, 3 - 15 * f, -36, 3 - 15 * f, 4 + 5 * f + 10 * f * f, -1 - 5 * f + 5 * f * f)
        tilt = line_inertia / (30.0 * length * (1.0 + f) ** 2) * scale * tilt
        self.mass[span, span] += line_mass * length / (840.0 * (1.0 + f) ** 2) * scale * shift + tilt
        # a round section has twice the moment about its axis
        self.gyroscopic[span, span] += 2.0 * tilt

    def add_disk(self, position: float, mass: float, polar: float, diametral: float) -> None:
        """A rigid disk."""
        at = 2 * self.nearest(position)
        self.mass[at, at] += mass
        self.mass[at + 1, at + 1] += diametral
        self.gyroscopic[at + 1, at + 1] += polar

    def add_bearing(self, position: float, stiffness: "float | None", tilting: float) -> None:
        """A spring in every direction alike; without a stiffness it holds the shaft rigidly."""
        at = 2 * self.nearest(position)
        if stiffness is None:
            self.held.append(at)
        else:
            self.stiffness[at, at] += stiffness
        self.stiffness[at + 1, at + 1] += tilting

    def free(self) -> "tuple[Any, Any, Any, Any]":
        """Mass, gyroscopic and stiffness matrix without the deflections that are held, and the numbers of the rest."""
        import numpy as np

        rest = np.setdiff1d(np.arange(len(self.mass)), self.held)
        pick = np.ix_(rest, rest)
        return self.mass[pick], self.gyroscopic[pick], self.stiffness[pick], rest


def _even(a: float, b: float, c: float, d: float, e: float, f: float) -> "Any":
    """The symmetric matrix of an element that is the same from both ends."""
    import numpy as np

    return np.array([[a, b, c, d], [b, e, -d, f], [c, -d, a, -b], [d, f, -b, e]])


def stations_of(marks: "Sequence[float]", elements: int) -> "list[float]":
    """Stations at all marks, and between them for about so many elements, at least two in each stretch."""
    ends = sorted(marks)
    length = ends[-1] - ends[0]
    kept = [ends[0]]
    for place in ends[1:]:
        if place - kept[-1] > SAME * length:
            kept.append(place)
    stations = kept[:1]
    for low, high in pairwise(kept):
        count = max(2, math.ceil(elements * (high - low) / length))
        stations += [low + (high - low) * k / count for k in range(1, count)] + [high]
    return stations


def whirl_rates(matrices: "Sequence[Any]", speed: float, count: int) -> "tuple[list[float], list[float]]":
    """The lowest backward and forward angular frequencies at a speed.

    λ²M − λΩG − K = 0 with y = λz is λ·diag(M, K) = [[ΩG, K], [K, 0]], symmetric on both sides.
    """
    import numpy as np
    from scipy.linalg import block_diag, eigh

    mass, gyroscopic, stiffness = matrices
    system = np.block([[speed * gyroscopic, stiffness], [stiffness, np.zeros_like(mass)]])
    rates = eigh(system, block_diag(mass, stiffness), eigvals_only=True)
    backward, forward = sorted(-rates[rates < 0.0]), sorted(rates[rates > 0.0])
    return [float(x) for x in backward[:count]], [float(x) for x in forward[:count]]


def critical_rates(matrices: "Sequence[Any]", order: float, way: float, count: int) -> "list[tuple[float, Any]]":
    """The lowest whirls that an order meets, forward (way 1) or backward (way −1), each with its shape.

    λ = ±hΩ turns λ²M − λΩG − K = 0 into K·z = λ²(M ∓ G/h)·z; a disk that stiffens faster than the speed has no meeting.
    """
    from scipy.linalg import eigh

    mass, gyroscopic, stiffness = matrices
    inverse, shapes = eigh(mass - way / order * gyroscopic, stiffness)
    met = [k for k in range(len(inverse) - 1, -1, -1) if inverse[k] > 0.0][:count]
    return [(float(inverse[k]) ** -0.5, shapes[:, k]) for k in met]
