"""Two motions as functions of time: with constant acceleration, by formulas, or measured."""

from math import hypot

from dynamics_cli.errors import require
from dynamics_cli.numerics.number import plain
from dynamics_cli.numerics.vectors import Vector, add, dot, scale, subtract
from dynamics_cli.path.relative.closest import place_at
from dynamics_cli.quantities import (
    AccelerationVector,
    Annotated,
    InputFile,
    LengthFormula,
    Noise,
    Position,
    Time,
    Velocity,
)
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.path.tracks.file import Track
    from dynamics_cli.records import Advice

    State = tuple[Vector, Vector, Vector]

ZERO = (0.0, 0.0, 0.0)


@record
class Mover:
    """A point with constant acceleration, with formulas of the time for coordinates, or with a measured track."""

    position: Annotated[Position, "Position at time 0, e.g. 0, 0, 0 m."] = ZERO
    velocity: Annotated[Velocity, "Velocity at time 0, e.g. 15, 0, 0 m/s."] = ZERO
    acceleration: Annotated[AccelerationVector, "Constant acceleration, e.g. 0, 0, -9.81 m/s^2."] = ZERO
    x: Annotated[LengthFormula | None, "Instead, x over the time t [s], e.g. 20*t m."] = None
    y: Annotated[LengthFormula | None, "And y over t, e.g. 3*sin(t) m."] = None
    z: Annotated[LengthFormula | None, "And z over t, e.g. exp(-t) m."] = None
    track: Annotated[
        InputFile, "Or a measured track: CSV with t[s] and x[m], y[m], z[m], or lat[deg], lon[deg]; e.g. car.csv."
    ] = ""
    sigma: Annotated[Noise | None, "Standard deviation of its coordinates; estimated if left out, e.g. 3 cm."] = None

    @property
    def curved(self) -> bool:
        """Whether it moves by formulas."""
        return any(formula is not None for formula in (self.x, self.y, self.z))

    @property
    def simple(self) -> bool:
        """Whether its acceleration is constant."""
        return not (self.curved or self.track)


class Steady:
    """A motion with constant acceleration, in doubles."""

    def __init__(self, mover: Mover) -> None:
        vectors = mover.position, mover.velocity, mover.acceleration
        self.parts: Any = [tuple(map(plain, vector)) for vector in vectors]

    def at(self, time: float) -> "State":
        """Position, velocity and acceleration at a time."""
        r, v, a = self.parts
        return place_at(r, v, a, time), add(v, scale(time, a)), a


class Formulas:
    """A motion by formulas."""

    def __init__(self, mover: Mover, let: "Any") -> None:
        from dynamics_cli.path.curves.moving_point import MovingPoint

        self.point = MovingPoint({"x": mover.x, "y": mover.y, "z": mover.z}, None, None, let).plainly()

    def at(self, time: float) -> "State":
        """Position, velocity and acceleration at a time."""
        state = self.point.state(time)
        return state.position, state.velocity, state.acceleration


class Measured:
    """A smoothed track, with the noise of its position and velocity."""

    def __init__(self, track: "Track", sigma: float | None, name: str) -> None:
        from dynamics_cli.path.tracks.fitted import advice_of_fit, fitted, require_enough

        require_enough(track, sigma, name)
        self.track = track
        self.start, self.end = track.times[0], track.times[-1]
        self.fit = fitted(track, sigma)
        self.advice: tuple[Advice, ...] = advice_of_fit(self.fit, track, name)
        self._curves = [self.fit.curve(order) for order in range(3)]

    def at(self, time: float) -> "State":
        """Position, velocity and acceleration at a time."""
        r, v, a = ((*map(float, curve(time)), 0.0, 0.0)[:3] for curve in self._curves)
        return r, v, a  # type: ignore[return-value]

    def noise(self, times: "Any") -> "tuple[Any, Any]":
        """Standard deviations of a coordinate and of a velocity at some times."""
        return self.fit.at(times, 0)[1], self.fit.at(times, 1)[1]


class Pair:
    """Two motions in doubles, and the second as seen from the first."""

    def __init__(self, first: Mover, second: Mover, let: "Any") -> None:
        movers = {"the first track": first, "the second track": second}
        tracks = _tracks(movers)
        self.motions: list[Any] = []
        for name, mover in movers.items():
            if name in tracks:
                sigma = None if mover.sigma is None else plain(mover.sigma)
                self.motions.append(Measured(tracks[name], sigma, name))
            else:
                self.motions.append(Formulas(mover, let) if mover.curved else Steady(mover))
        self.measured = [motion for motion in self.motions if isinstance(motion, Measured)]
        self.start = max((motion.start for motion in self.measured), default=0.0)

    def end(self, requested_end: float | None) -> float:
        """Until when there are both, and until when is asked for."""
        ends = [motion.end for motion in self.measured]
        require(bool(ends) or requested_end is not None, "the closest approach of formulas needs an end of its search",
                code="missing", hint="--end '60 s'")  # fmt: skip
        last = min(ends, default=requested_end or 0.0)
        require(
            not ends or self.start < last,
            "the tracks have no time in common: one ends at {last}, the other begins {gap} later, at {start}",
            code="times",
            hint="count the times of both on one clock",
            last=(last, Time),
            gap=(self.start - last, Time),
            start=(self.start, Time),
        )
        return last if requested_end is None else min(last, requested_end)

    def check(self, last: float) -> None:
        """Refuse formulas with a pole, a corner or a gap in the range of times."""
        for motion in self.motions:
            if isinstance(motion, Formulas):
                motion.point.check(self.start, last)

    def seen(self, time: float) -> "State":
        """Relative position, velocity and acceleration."""
        (r, v, a), (place, velocity, acceleration) = (motion.at(time) for motion in self.motions)
        return subtract(place, r), subtract(velocity, v), subtract(acceleration, a)

    def rate(self, time: float) -> float:
        """r·v, which vanishes where they are closest."""
        r, v, _ = self.seen(time)
        return dot(r, v)

    def noise(self, times: "Any") -> "tuple[Any, Any]":
        """Standard deviations of the relative position along any direction, and of the relative velocity."""
        each = [motion.noise(times) for motion in self.measured]
        return tuple(sum(pair[order] ** 2 for pair in each) ** 0.5 for order in (0, 1))


def noise_of_rates(state: "State", noise: "tuple[float, float]") -> "tuple[float, float | None]":
    """Standard deviations of the closing speed, and of the time at which r·v would vanish there.

    To first order: of −r·v/|r| by δv along r and δr across it; of t by (δr·v + δr·r)/(v² + r·a).
    """
    r, v, a = state
    apart, speed = hypot(*r), hypot(*v)
    along = dot(r, v) / apart if apart else 0.0
    across = max(speed * speed - along * along, 0.0) ** 0.5
    closing = hypot(noise[1], across * noise[0] / apart) if apart else noise[1]
    curvature = speed * speed + dot(r, a)
    return closing, hypot(speed * noise[0], apart * noise[1]) / curvature if curvature > 0.0 else None


def require_one_sort(mover: Mover) -> None:
    """Refuse a motion that is given in two ways."""
    constant = (mover.position, mover.velocity, mover.acceleration) != (ZERO, ZERO, ZERO)
    require(
        constant + mover.curved + bool(mover.track) <= 1,
        "a point moves by a track, by formulas, or from a position with velocity and acceleration: two of these are "
        "given",
        code="exclusive",
        hint="leave one out",
    )
    require(mover.sigma is None or bool(mover.track), "a standard deviation is given without a track", code="sigma",
            hint="add the track, or leave the deviation out")  # fmt: skip


def _tracks(movers: "dict[str, Mover]") -> "dict[str, Track]":
    """The tracks by their names, in one set of axes."""
    if not any(mover.track for mover in movers.values()):
        return {}
    from dynamics_cli.path.tracks.file import read_track

    tracks: dict[str, Track] = {}
    origin = None
    for name, mover in movers.items():
        if mover.track:
            tracks[name] = read_track(mover.track, origin)
            origin = tracks[name].origin
    axes = [", ".join(["latitude", "longitude", *track.names[2:]] if track.origin else track.names)
            for track in tracks.values()]  # fmt: skip
    require(
        len(set(axes)) == 1,
        "the first track has {first}, the second {second}: their positions have no common origin and axes",
        code="axes",
        hint="write both tracks with the same columns",
        first=axes[0],
        second=axes[-1],
    )
    clocks = [track.clock for track in tracks.values() if track.clock is not None]
    require(
        len(clocks) in (0, len(tracks)),
        "the times of one track are dates, those of the other are not",
        code="times",
        hint="count the times of both on one clock",
    )
    for track, clock in zip(tracks.values(), clocks, strict=False):
        track.times = [time + (clock - clocks[0]) for time in track.times]
    require(
        origin is None or len(tracks) == 2,
        "positions of a track of latitudes and longitudes count from its first point: the other motion has no place "
        "beside it",
        code="axes",
        hint="give both as tracks of latitudes and longitudes, or both in lengths",
    )
    return tracks
