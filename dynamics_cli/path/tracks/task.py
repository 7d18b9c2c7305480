"""The task `table`: velocity and acceleration of a measured track, with their noise."""

import math

from dynamics_cli.errors import require
from dynamics_cli.path.tracks.file import read_track, third_differences
from dynamics_cli.path.tracks.fitted import advice_of_fit, fitted, require_enough
from dynamics_cli.quantities import (
    Acceleration,
    Annotated,
    Curvature,
    Distance,
    InputFile,
    Length,
    Noise,
    Ratio,
    Speed,
    Time,
)
from dynamics_cli.records import Advice, Choice, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.numerics.fitting.smoothing import Smooth


class Smoothing(Choice):
    """How the noise is kept out of the derivatives."""

    names = ("spline", "none")
    aliases = {"raw": "none"}  # noqa: RUF012


SPLINE = Smoothing("spline")


@record
class TrackPoint:
    """One measured time."""

    time: Annotated[Time, "Time [s]."]
    x: Annotated[Length, "Along x, or east, smoothed [m]."]
    y: Annotated[Length | None, "Along y, or north, smoothed [m]."]
    z: Annotated[Length | None, "Along z, smoothed [m]."]
    speed: Annotated[Speed, "Speed [m/s]."]
    speed_noise: Annotated[Speed, "Its standard deviation [m/s]."]
    tangential: Annotated[Acceleration, "Tangential acceleration a_t [m/s^2]."]
    normal: Annotated[Acceleration, "Normal acceleration a_n [m/s^2]."]
    acceleration_noise: Annotated[Acceleration, "Standard deviation of each [m/s^2]."]
    curvature: Annotated[Curvature | None, "Curvature of the path; none where it stands [1/m]."]
    curvature_noise: Annotated[Curvature | None, "Its standard deviation [1/m]."]


@record
class TrackMotion:
    """The motion behind a measured track."""

    top_speed: Annotated[Speed, "Highest speed [m/s]."]
    top_speed_time: Annotated[Time, "When [s]."]
    hardest_braking: Annotated[Acceleration | None, "Largest deceleration along the path [m/s^2]."]
    hardest_braking_time: Annotated[Time | None, "When [s]."]
    strongest_acceleration: Annotated[Acceleration | None, "Largest acceleration along the path [m/s^2]."]
    strongest_lateral: Annotated[Acceleration | None, "Largest acceleration across the path [m/s^2]."]
    strongest_lateral_time: Annotated[Time | None, "When [s]."]
    length: Annotated[Distance, "Length of the smoothed path [m]."]
    speed_noise: Annotated[Speed, "Standard deviation of the speed, median over the track [m/s]."]
    acceleration_noise: Annotated[Acceleration, "Standard deviation of the acceleration, median [m/s^2]."]
    position_noise: Annotated[Length, "Standard deviation of a measured coordinate: given or estimated [m]."]
    measured_noise: Annotated[Length, "Standard deviation as the residuals have it [m]."]
    raw_noise: Annotated[Acceleration, "What raw second differences would have had [m/s^2]."]
    freedom: Annotated[Ratio, "Equivalent number of parameters of the smoothed track [-]."]
    resolution: Annotated[Time, "What happens in less time is smoothed away [s]."]
    chosen_by: Annotated[str, "How the smoothing was chosen."]
    points: Annotated[tuple[TrackPoint, ...], "The motion at the measured times."]
    numerics: Numerics | None = None
    advice: tuple[Advice, ...] = ()


def table(
    file: Annotated[InputFile, "CSV with t[s] and x[m], y[m], z[m], or lat[deg], lon[deg]."],
    /,
    *,
    sigma: Annotated[Noise | None, "Standard deviation of a coordinate; estimated if left out, e.g. 3 cm."] = None,
    smoothing: Annotated[Smoothing, "spline; none is refused, and the message gives the noise it would have."] = SPLINE,
) -> TrackMotion:
    """Speed, acceleration and curvature from measured positions, by a smoothing spline, with the noise of each.

    Equation
    --------
    The quintic spline that minimises Σ(y − f)² + λ∫f‴²dt; λ by generalised cross-validation, or by the unbiased risk
    for a known σ. Raw second differences at equal steps h would have the noise σ√6/h².

    Raises
    ------
    InadmissibleError
        When the file is damaged, times do not increase, there are fewer than 8 points, or no smoothing is asked for.

    References
    ----------
    Craven & Wahba, Smoothing noisy data with spline functions, Numer. Math. 31 (1979); Wahba, J. R. Statist. Soc. B 45
    (1983); Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 3.2.

    Examples
    --------
    >>> table("track.csv", sigma=0.03).top_speed  # doctest: +SKIP
    13.9
    """
    import numpy as np

    track = read_track(file)
    require_enough(track, sigma)
    times, places = np.array(track.times), np.array(track.places)
    step = float(np.median(np.diff(times)))
    raw = third_differences(places) if sigma is None else sigma
    require(
        smoothing != "none",
        "raw second differences of this track have a noise of {noise} (σ = {sigma}, one point every {step})",
        code="raw",
        hint="leave out --smoothing: a spline removes most noise, and states what remains",
        noise=(raw * math.sqrt(6.0) / step**2, Acceleration),
        sigma=(raw, Length),
        step=(step, Time),
    )
    fit = fitted(track, sigma)
    motion = _Motion(fit, times)
    return TrackMotion(
        **motion.extremes(),
        length=motion.length(),
        speed_noise=float(np.median(motion.speed_noise)),
        acceleration_noise=float(np.median(motion.rate_noise)),
        position_noise=fit.sigma,
        measured_noise=fit.measured_sigma,
        raw_noise=fit.sigma * math.sqrt(6.0) / step**2,
        freedom=fit.freedom,
        resolution=fit.span / max(fit.freedom - 1.0, 1.0),
        chosen_by="generalised cross-validation (no σ given)" if sigma is None else "the unbiased risk for the σ given",
        points=motion.rows(),
        numerics=Numerics("quintic smoothing spline; noise is the standard deviation of each number"),
        advice=advice_of_fit(fit, track),
    )


class _Motion:
    """Derivatives of the smoothed track at the measured times."""

    def __init__(self, fit: "Smooth", times: "Any") -> None:
        import numpy as np

        self.fit, self.times = fit, times
        self.place, _ = fit.at(times, 0)
        self.velocity, self.speed_noise = fit.at(times, 1)
        self.rate, self.rate_noise = fit.at(times, 2)
        self.speed = np.sqrt((self.velocity**2).sum(axis=1))
        # standing within its noise it has no direction
        self.moves = self.speed > 3.0 * self.speed_noise
        direction = self.velocity / np.where(self.moves, self.speed, 1.0)[:, None]
        self.tangential = np.where(self.moves, (direction * self.rate).sum(axis=1), np.sqrt((self.rate**2).sum(axis=1)))
        across = self.rate - self.tangential[:, None] * direction
        self.normal = np.where(self.moves, np.sqrt((across**2).sum(axis=1)), 0.0)

    def extremes(self) -> "dict[str, Any]":
        """The largest of each, and when; where it moves."""
        import numpy as np

        top = int(self.speed.argmax())
        extremes: dict[str, Any] = {"top_speed": float(self.speed[top]), "top_speed_time": float(self.times[top])}
        along = np.where(self.moves, self.tangential, 0.0)
        low, high, side = int(along.argmin()), int(along.argmax()), int(self.normal.argmax())
        braked = along[low] < 0.0
        extremes["hardest_braking"] = -float(along[low]) if braked else None
        extremes["hardest_braking_time"] = float(self.times[low]) if braked else None
        extremes["strongest_acceleration"] = float(along[high]) if along[high] > 0.0 else None
        planar = self.place.shape[1] > 1
        extremes["strongest_lateral"] = float(self.normal[side]) if planar else None
        extremes["strongest_lateral_time"] = float(self.times[side]) if planar else None
        return extremes

    def rows(self) -> tuple[TrackPoint, ...]:
        """The table."""
        out = []
        width = self.place.shape[1]
        for i, time in enumerate(self.times.tolist()):
            x, y, z = (float(self.place[i, k]) if k < width else None for k in range(3))
            speed, noise, rate_noise = (float(a[i]) for a in (self.speed, self.speed_noise, self.rate_noise))
            curvature = spread = None
            if self.moves[i] and width > 1:
                curvature = float(self.normal[i]) / speed / speed
                spread = math.hypot(rate_noise / speed / speed, 2.0 * curvature * noise / speed)
            parts = float(self.tangential[i]), float(self.normal[i]), rate_noise
            out.append(TrackPoint(time, x or 0.0, y, z, speed, noise, *parts, curvature, spread))
        return tuple(out)

    def length(self) -> float:
        """Length of the smoothed path."""
        import numpy as np

        edges = np.unique(self.fit.knots) * self.fit.span + self.fit.start
        nodes, weights = np.polynomial.legendre.leggauss(6)
        half = 0.5 * np.diff(edges)
        times = (0.5 * (edges[1:] + edges[:-1]))[:, None] + half[:, None] * nodes
        velocity, _ = self.fit.at(times.ravel(), 1)
        return float((np.sqrt((velocity**2).sum(axis=1)) * (half[:, None] * weights).ravel()).sum())
