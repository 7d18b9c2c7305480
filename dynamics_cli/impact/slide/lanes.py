"""Thousands of slides at once, each with steps of its own, to four or five digits: for searches and for samples.

The equations of `motion`, with the velocities along and across the car, where of a level road they depend on the place
by nothing but its ground. Rolling wheels make them stiff: Rosenbrock steps (RODAS: six stages, fourth order, L-stable),
whose linear systems have the exact derivatives. Instead of an event for a wheel that stands, the direction of a force
is smoothed at slips below a ten-thousandth of the car's speed.
"""

from copy import copy

import numpy as np

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.impact.slide.wheels import Car

    Array = NDArray[Any]

# Hairer and Wanner, Solving Ordinary Differential Equations II, section IV.10: RODAS, in its form without products.
GAMMA = 0.25
TIMES = (0.0, 0.386, 0.21, 0.63, 1.0, 1.0)
SHIFTS = (0.25, -0.1043, 0.1035, -0.0362, 0.0, 0.0)
FIFTH = (1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950)
STAGES = tuple(
    np.array([row])
    for row in (
        (),
        (1.544,),
        (0.9466785280815826, 0.2557011698983284),
        (3.314825187068521, 2.896124015972201, 0.9986419139977817),
        FIFTH,
        (*FIFTH, 1.0),
    )
)
SLOPES = tuple(
    np.array([row])
    for row in (
        (),
        (-5.6688,),
        (-2.430093356833875, -0.2063599157091915),
        (-0.1073529058151375, -9.594562251023355, -20.47028614809616),
        (7.496443313967647, -10.24680431464352, -33.99990352819905, 11.70890893206160),
        (8.083246795921522, -7.981132988064893, -31.52159432874371, 16.31930543123136, -6.058818238834054),
    )
)
FIRST_STEP = 0.02
TINY = 1e-300
MOST_STEPS = 1000
# Where a state holds its parts: velocities of unit size along, across and turning, nose, place, time, path.
NOSE, X, Y, TIME, PATH, PARTS = 3, 4, 5, 6, 7, 8
# What cars differ by, lanes on the last axis; the first two only where their wheels stand differently.
WHEELS = ("rows", "products")
OWN = (*WHEELS, "slopes", "shares", "places", "gyration", "friction", "edges", "nose", "begin")


class Lanes:
    """A car as arrays: rows of its wheels' slips along and across by its velocities, and what grips.

    All its slides begin at one place, with one heading of the nose; `joined`, each lane has a car of its own.
    """

    def __init__(self, car: "Car", begin: "tuple[float, float]" = (0.0, 0.0), nose: float = 0.0) -> None:
        self.begin: Array = np.array([[begin[0]], [begin[1]]])
        self.nose: Array = np.array([nose])
        self.several = False
        wheels = car.wheels
        k = car.gyration
        along = [[w.cosine, w.sine, (w.sine * w.ahead - w.cosine * w.left) / k] for w in wheels]
        across = [[-w.sine, w.cosine, (w.cosine * w.ahead + w.sine * w.left) / k] for w in wheels]
        self.rows = np.array([*along, *across])
        pairs = self.rows.reshape(2, 4, 3)
        # of the derivatives of both forces by both slips, to those of forces and moment by velocities
        self.products = np.einsum("awi,bwj->ijabw", pairs, pairs).reshape(9, 16)
        self.slopes = np.array([[w.slope_squared] for w in wheels])
        self.shares = car.gravity * np.array([[w.load * s] for s_of in ("share", "across") for w in wheels
                                              for s in [getattr(w, s_of)]])  # fmt: skip
        self.places = np.array([[[w.ahead], [w.left]] for w in wheels]).transpose(1, 0, 2)
        self.gyration: Array = np.array([k])
        self.friction: Array = np.array([car.friction])
        self.edges = np.array([[*one.normal, *one.bounds, one.friction] for one in car.verges]).reshape(-1, 7, 1)
        # the square of the slip below which the direction of a force is smoothed
        self.smooth = 0.0

    @staticmethod
    def joined(cars: "Sequence[Lanes]") -> "Lanes":
        """Cars of the same number of grounds side by side, one a lane."""
        whole = copy(cars[0])
        whole.several = True
        alike = all((one.rows == whole.rows).all() for one in cars)
        for name in OWN:
            parts = [getattr(one, name) for one in cars]
            if name not in WHEELS:
                setattr(whole, name, np.concatenate(parts, axis=-1))
            elif not alike:
                setattr(whole, name, np.stack(parts, axis=-1))
        return whole

    def some(self, chosen: "Array") -> "Lanes":
        """Some of the lanes, by index or mask; of one car all are alike."""
        if not self.several:
            return self
        part = copy(self)
        for name in OWN[len(WHEELS) if self.rows.ndim == 2 else 0 :]:
            setattr(part, name, getattr(self, name)[..., chosen])
        return part

    def grip(self, y: "Array", c: "Array", s: "Array") -> "Array":
        """Greatest forces per mass, braking of each wheel and sideways, where the wheels are."""
        if not len(self.edges):
            grip: Array = self.friction * self.shares
            return grip
        ahead, left = self.places
        x, z = y[X] + c * ahead - s * left, y[Y] + s * ahead + c * left
        friction = np.broadcast_to(self.friction, x.shape)
        for a, b, low, high, begin, end, there in self.edges:
            across, along = a * x + b * z, b * x - a * z
            held = (low < across) & (across < high) & (begin <= along) & (along <= end)
            friction = np.where(held, there, friction)
        return np.concatenate([friction, friction]) * self.shares

    def rates(self, y: "Array", squares: "Array", moved: "list[Array] | None" = None) -> "Array":
        """Derivatives by the stretched time; with `moved`, their derivatives by the state and by time into it."""
        q = y[:3]
        c, s = np.cos(y[NOSE]), np.sin(y[NOSE])
        grip = self.grip(y, c, s)
        slip = _times(self.rows, q)
        squared = slip * slip
        size = np.empty_like(slip)
        np.add(squared[:4], squared[4:], out=size[:4])
        np.add(squared[4:], self.slopes * squared[:4], out=size[4:])
        size += self.smooth
        turned = 1.0 / np.sqrt(size)
        push = _times(self.rows.swapaxes(0, 1), -grip * slip * turned)
        shed = -1.0 / (q * push).sum(axis=0)
        pull = 1.0 / (q * q).sum(axis=0)
        way = squares * shed
        turn = way * q[2] / self.gyration
        made = np.empty_like(y)
        made[:3] = push * shed + q * pull
        made[0] += turn * q[1]
        made[1] -= turn * q[0]
        made[NOSE] = turn
        east, north = c * q[0] - s * q[1], s * q[0] + c * q[1]
        made[X], made[Y] = way * east, way * north
        forth = np.sqrt(q[0] * q[0] + q[1] * q[1])
        made[TIME], made[PATH] = np.sqrt(squares) * shed, way * forth
        if moved is not None:
            stiff = grip * turned**3
            both = slip[:4] * slip[4:]
            by_slip = np.concatenate(
                [-stiff[:4] * (squared[4:] + self.smooth), stiff[:4] * both, stiff[4:] * self.slopes * both,
                 -stiff[4:] * (self.slopes * squared[:4] + self.smooth)]
            )  # fmt: skip
            matrix = _times(self.products, by_slip).reshape(3, 3, -1)
            shedding = shed * (push + (q[:, None] * matrix).sum(axis=0))
            moved += self._moved(q, (push, matrix, shedding), (shed, pull, way, turn), (c, s, east, north), made)
        return made

    def _moved(self, q: "Array", forces: "Sequence[Array]", sizes: "Sequence[Array]", ways: "Sequence[Array]",
               made: "Array") -> "list[Array]":  # fmt: skip
        """Derivatives by velocities of velocities and all else; of places by the nose; of all by time."""
        push, matrix, shedding = forces
        shed, pull, way, turn = sizes
        c, s, east, north = ways
        square = shed * (matrix + push[:, None] * shedding) - 2.0 * pull * pull * q[:, None] * q
        for index in range(3):
            square[index, index] += pull
        by_way = way * shedding
        by_turn = turn * shedding
        by_turn[2] += way / self.gyration
        square[0] += q[1] * by_turn
        square[1] -= q[0] * by_turn
        square[0, 1] += turn
        square[1, 0] -= turn
        by_x, by_y = east * by_way, north * by_way
        by_x[0] += way * c
        by_x[1] -= way * s
        by_y[0] += way * s
        by_y[1] += way * c
        by_path = made[PATH] * shedding
        by_path[:2] += way * q[:2] / np.sqrt(q[0] * q[0] + q[1] * q[1] + TINY)
        by_time = -2.0 * made
        by_time[0], by_time[1], by_time[2] = -2.0 * turn * q[1], 2.0 * turn * q[0], 0.0
        by_time[TIME] = -made[TIME]
        return [square, np.array([by_turn, by_x, by_y, made[TIME] * shedding, by_path]), -made[Y], made[X], by_time]

    def ends(
        self,
        velocities: "Array",
        tolerance: float,
        group: int = 1,
        steps: int = MOST_STEPS,
    ) -> "Array":
        """Places and noses at rest, times and paths (5, n), of velocities along the axes and k times spin (3, n).

        Each `group` of neighbours goes in the same steps, so that differences within it are derivatives. Not a number
        where more than so many steps would be needed.
        """
        size = np.sqrt((velocities * velocities).sum(axis=0))
        c, s = np.cos(self.nose), np.sin(self.nose)
        y = np.zeros((PARTS, size.size))
        y[0] = (c * velocities[0] + s * velocities[1]) / size
        y[1] = (c * velocities[1] - s * velocities[0]) / size
        y[2] = velocities[2] / size
        y[NOSE], y[X], y[Y] = self.nose, *self.begin
        squares = size * size
        # what is left of the way is then below the tolerance
        last = 0.5 - 0.5 * np.log(tolerance)
        lanes = copy(self)
        lanes.smooth = tolerance * tolerance
        at, step = np.zeros(size.size), np.full(size.size, FIRST_STEP)
        found = np.full((5, size.size), np.nan)
        index = np.arange(size.size)
        for _ in range(steps):
            step = np.minimum(step, last - at)
            new, error = lanes._stepped(y, at, step, squares)
            off = (np.abs(error) / (tolerance * (1.0 + np.abs(y)))).max(axis=0)
            off[~np.isfinite(off)] = 1e9
            off = np.repeat(off.reshape(-1, group).max(axis=1), group)
            good = off <= 1.0
            new[:3] /= np.sqrt((new[:3] * new[:3]).sum(axis=0))
            y, at = np.where(good, new, y), np.where(good, at + step, at)
            step = step * np.clip(0.9 * np.maximum(off, 1e-10) ** -0.25, 0.15, 5.0)
            done = at >= last
            if done.any():
                rest = y[:, done]
                left = lanes.some(done).rates(rest, squares[done] * np.exp(-2.0 * last))
                left[:TIME] *= 0.5
                left[PATH] *= 0.5
                found[:, index[done]] = (rest + left)[[X, Y, NOSE, TIME, PATH]]
                lanes = lanes.some(~done)
                y, at, step, squares, index = (part[..., ~done] for part in (y, at, step, squares, index))
            if not index.size:
                break
        return found

    def _stepped(self, y: "Array", at: "Array", step: "Array", squares: "Array") -> "tuple[Array, Array]":
        """One step of each lane, and its estimated error."""
        moved: list[Array] = []
        slope = self.rates(y, squares * np.exp(-2.0 * at), moved)
        square, others, x_by_nose, y_by_nose, by_time = moved
        diagonal = 1.0 / (GAMMA * step)
        system = -square
        for index in range(3):
            system[index, index] += diagonal
        solved = _inverse(system)
        parts = np.empty((6, *y.shape))
        flat = parts.reshape(6, -1)
        there = y
        for stage in range(6):
            if stage:
                there = y + (STAGES[stage] @ flat[:stage]).reshape(y.shape)
                slope = self.rates(there, squares * np.exp(-2.0 * (at + TIMES[stage] * step)))
                slope += (SLOPES[stage] @ flat[:stage]).reshape(y.shape) / step
            if SHIFTS[stage]:
                slope = slope + (SHIFTS[stage] * step) * by_time
            part = parts[stage]
            q = part[:3] = (solved * slope[:3]).sum(axis=1)
            part[NOSE:] = (slope[NOSE:] + (others * q).sum(axis=1)) / diagonal
            part[X] += x_by_nose * part[NOSE] / diagonal
            part[Y] += y_by_nose * part[NOSE] / diagonal
        return there + parts[5], parts[5]


def _times(matrix: "Array", x: "Array") -> "Array":
    """The product with each lane, of one matrix for all or of one a lane."""
    made: Array = matrix @ x if matrix.ndim == 2 else np.einsum("ijn,jn->in", matrix, x)
    return made


def _inverse(m: "Array") -> "Array":
    """Inverses of matrices of three rows (3, 3, n), by cofactors."""
    (a, b, c), (d, e, f), (g, h, i) = m
    first, second, third = e * i - f * h, f * g - d * i, d * h - e * g
    found = np.array(
        [[first, c * h - b * i, b * f - c * e], [second, a * i - c * g, c * d - a * f],
         [third, b * g - a * h, a * e - b * d]]
    )  # fmt: skip
    found /= a * first + b * second + c * third
    return found
