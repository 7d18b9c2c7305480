"""A rotor on bearings that differ across, damp or drive it, in two planes: modes, stability, response to unbalance.

M·q̈ + (C + Ω·J)·q̇ + (K + Ω·S)·q = Ω²·u·e^{iΩt} for q = (x, y), in the span of the lowest modes of one plane with
bearings alike, and of the deflections under a force at each bearing and unbalance and a moment at each disk.
"""

import math
from dataclasses import dataclass

from dynamics_cli.sampling import drawing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from dynamics_cli.vibration.rotors.beam_elements import Matrices

# Modes of one plane in the span, and of samples of uncertain inputs.
LOWEST, FEW_LOWEST = 16, 8
# A whirl damped beyond this ratio is none that a user would notice.
DAMPED = 0.5
# A place that deflects less than this share of the largest does not count for the sense of a whirl.
SLIGHT = 0.05
# Parts of a shaft have at least this share of the mass that the lowest mode moves.
MASSLESS = 1e-16
# A minor axis below this share of the major one is a line.
THIN = 1e-6
FORWARD, BACKWARD, MIXED, LINE = "forward", "backward", "mixed", "in a line"


@dataclass(frozen=True)
class Support:
    """A bearing at a station: 2 × 2 matrices of stiffness and damping, None where it is rigid; what its film swirls."""

    station: int
    stiffness: "Any"
    damping: "Any"
    swirl: float

    def turning(self) -> "Any":
        """Stiffness per speed: a film that turns at its share of the speed damps motion against itself."""
        import numpy as np

        return self.swirl * self.damping @ np.array([[0.0, 1.0], [-1.0, 0.0]])

    def force(self, speed: float, motion: "Any") -> "Any":
        """On the bearing, for a motion at the speed."""
        return (self.stiffness + speed * (self.turning() + 1j * self.damping)) @ motion


class Rotor:
    """The reduced matrices, and what follows from them."""

    def __init__(
        self, system: "Matrices", supports: "Sequence[Support]", unbalances: "Sequence[tuple[int, complex]]",
        disks: "Sequence[int]",
    ) -> None:  # fmt: skip
        import numpy as np
        from scipy.linalg import eigh

        self.supports, self.full = supports, system
        soft = [support for support in supports if support.stiffness is not None]
        for support in soft:
            system.stiffness[2 * support.station, 2 * support.station] += np.trace(support.stiffness) / 2.0
        system.held = [2 * support.station for support in supports if support.stiffness is None]
        mass, gyroscopic, self.alike, rest = system.free()
        self.rest = rest
        loaded = {*(2 * one.station for one in soft), *(2 * at for at, _ in unbalances), *(2 * at + 1 for at in disks)}
        loaded &= set(map(int, rest))
        unit = np.zeros((len(rest), len(loaded)))
        unit[np.searchsorted(rest, sorted(loaded)), range(len(loaded))] = 1.0
        count = FEW_LOWEST if drawing() else LOWEST
        _, low = eigh(mass, self.alike, subset_by_index=[max(len(rest) - count, 0), len(rest) - 1])
        span = np.hstack([low, np.linalg.solve(self.alike, unit)])
        # of even size, deflections and slopes, and apart from one another
        left, sizes, _ = np.linalg.svd(np.sqrt(self.alike.diagonal())[:, None] * span / np.linalg.norm(span, axis=0))
        kept = left[:, : len(sizes)][:, sizes > 1e-10 * sizes[0]]
        span = kept / np.sqrt(self.alike.diagonal())[:, None]
        # their own modes, of mass 1: the lowest keep their digits beside the highest
        inverse, shapes = eigh(span.T @ mass @ span, span.T @ self.alike @ span)
        rates = np.maximum(inverse, MASSLESS * inverse[-1]) ** -0.5
        span = span @ (shapes * rates)
        self.seen = np.zeros((len(system.mass), len(rates)))
        self.seen[rest] = span
        both = np.eye(2)
        self.rates_alike = np.tile(rates, 2)
        self.stiffness = np.diag(self.rates_alike**2)
        self.gyroscopic = np.kron(np.array([[0.0, 1.0], [-1.0, 0.0]]), span.T @ gyroscopic @ span)
        self.damping, self.swirl = np.zeros_like(self.stiffness), np.zeros_like(self.stiffness)
        # what alone restores: critical speeds without damping are of this
        self.restoring = self.stiffness.copy()
        for support in soft:
            at = self.seen[2 * support.station]
            spot = np.outer(at, at)
            differing = support.stiffness - np.trace(support.stiffness) / 2.0 * both
            self.stiffness += np.kron(differing, spot)
            self.restoring += np.kron(np.diag(differing.diagonal()), spot)
            self.damping += np.kron(support.damping, spot)
            self.swirl += np.kron(support.turning(), spot)
        self.force = np.zeros(len(self.stiffness), complex)
        self.loads = np.zeros(len(system.mass), complex)
        for station, load in unbalances:
            self.loads[2 * station] += load
            self.force += np.kron([load, -1j * load], self.seen[2 * station])

    def criticals(self, count: int) -> "list[tuple[float, str]]":
        """Speeds at which unbalance meets a whirl without damping, with its sense; K·q = Ω²(M − iJ)·q."""
        import numpy as np
        from scipy.linalg import eigh

        inverse, shapes = eigh(np.eye(len(self.stiffness)) - 1j * self.gyroscopic, self.restoring)
        met = [k for k in range(len(inverse) - 1, -1, -1) if inverse[k] > 0.0][:count]
        return [(float(inverse[k]) ** -0.5, self.sense(shapes[:, k])) for k in met]

    def modes(self, speed: float, count: int) -> "list[tuple[complex, str]]":
        """The lowest whirls at a speed, s of e^{st} with the frequency above zero, and their sense."""
        from numpy.linalg import eig

        rates, states = eig(self._state(speed))
        shapes = states[: len(self.stiffness)] / self.rates_alike[:, None]
        return [(complex(rates[k]), self.sense(shapes[:, k])) for k in _whirling(rates)[:count]]

    def rates(self, speed: float) -> "list[complex]":
        """The lowest whirls without their sense."""
        from numpy.linalg import eigvals

        rates = eigvals(self._state(speed))
        return [complex(rates[k]) for k in _whirling(rates)[:LOWEST]]

    def _state(self, speed: float) -> "Any":
        import numpy as np

        # of rates·deflection over velocity
        size, rates = len(self.stiffness), self.rates_alike
        state = np.zeros((2 * size, 2 * size))
        state[:size, size:] = np.diag(rates)
        state[size:, :size] = -(self.stiffness + speed * self.swirl) / rates
        state[size:, size:] = -(self.damping + speed * self.gyroscopic)
        return state

    def response(self, speed: float) -> "Any":
        """The motion under the unbalances, x over y: complex amplitudes beside e^{iΩt}."""
        return self.responses([speed])[0]

    def responses(self, speeds: "Sequence[float]") -> "Any":
        """The motions at several speeds."""
        import numpy as np

        speed = np.array(speeds)[:, None, None]
        whole = self.stiffness + speed * self.swirl + 1j * speed * (self.damping + speed * self.gyroscopic)
        place = np.arange(len(self.force))
        whole[:, place, place] -= speed[:, 0] ** 2
        return np.linalg.solve(whole, speed**2 * self.force[:, None])[:, :, 0]

    def at(self, station: int, motion: "Any") -> "Any":
        """Horizontal and vertical deflection at a station."""
        return motion.reshape(2, -1) @ self.seen[2 * station]

    def reaction(self, support: Support, speed: float, motion: "Any") -> "tuple[complex, complex]":
        """Horizontal and vertical force on a bearing."""
        import numpy as np

        if support.stiffness is not None:
            x, y = support.force(speed, self.at(support.station, motion))
            return complex(x), complex(y)
        # the work on the shape that lifts the shaft from this rigid bearing alone
        full, at = self.full, 2 * support.station
        shape = np.zeros(len(full.mass))
        shape[at] = 1.0
        shape[self.rest] = -np.linalg.solve(self.alike, full.stiffness[self.rest, at])
        x, y = motion.reshape(2, -1) @ self.seen.T
        direct = full.stiffness - speed**2 * full.mass
        across = 1j * speed**2 * full.gyroscopic
        loads = speed**2 * self.loads
        taken = np.array([loads - direct @ x - across @ y, -1j * loads - direct @ y + across @ x]) @ shape
        for other in self.supports:
            if other.stiffness is not None:
                place = 2 * other.station
                alike = np.trace(other.stiffness) / 2.0
                motion_there = np.array([x[place], y[place]])
                taken -= shape[place] * (other.force(speed, motion_there) - alike * motion_there)
        return complex(taken[0]), complex(taken[1])

    def sense(self, motion: "Any") -> str:
        """Which way all places that move go round."""
        x, y = motion.reshape(2, -1) @ self.seen[::2].T
        forward, backward = abs(x + 1j * y), abs(x - 1j * y)
        major, turning = forward + backward, forward - backward
        counts = (major > SLIGHT * max(major)) & (abs(turning) > THIN * major)
        ways = turning[counts] > 0.0
        if not len(ways):
            return LINE
        return FORWARD if all(ways) else MIXED if any(ways) else BACKWARD


def growth(rates: "Sequence[complex]") -> float:
    """Of the whirl that decays least, growth over frequency: above zero, it grows."""
    return max(rate.real / abs(rate) for rate in rates)


def _whirling(rates: "Any") -> "list[int]":
    """Which of the rates whirl, with the frequency above zero, from the lowest."""
    size = abs(rates)
    whirls = (rates.imag > 0.0) & (rates.real > -DAMPED * size)
    return sorted((k for k in range(len(rates)) if whirls[k]), key=lambda k: size[k])


def axes(x: complex, y: complex) -> "tuple[float, float, str]":
    """Half axes of the orbit of x and y beside e^{iΩt}, and which way it is gone round."""
    forward, backward = abs(x + 1j * y) / 2.0, abs(x - 1j * y) / 2.0
    major, minor = forward + backward, abs(forward - backward)
    way = LINE if minor <= THIN * major else FORWARD if forward > backward else BACKWARD
    return major, minor, way


def lag(x: complex) -> float:
    """By how much a motion comes after its force, from 0 to a turn."""
    return -math.atan2(x.imag, x.real) % (2.0 * math.pi)
