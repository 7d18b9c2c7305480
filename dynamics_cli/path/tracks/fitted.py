"""The smooth motion behind a measured track, and warnings about the fit."""

from dynamics_cli.errors import require, worded
from dynamics_cli.path.tracks.file import Track
from dynamics_cli.quantities import Length
from dynamics_cli.records import Advice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.numerics.fitting.smoothing import Smooth

FEWEST = 8
# Residuals this many times the stated deviation say that one of the two is wrong.
TOO_FAR = 1.5
# Freedom above this share of the points means that hardly anything is smoothed.
BUSY = 0.5
# Extent for which a plane tangent to the globe is accurate enough.
FLAT = 20e3


def require_enough(track: Track, sigma: float | None, name: str = "the track") -> None:
    """Refuse a track without enough points for derivatives with their noise."""
    require(
        len(track.times) >= FEWEST,
        "{name} has {count} points: an acceleration with its noise needs at least {fewest}",
        code="few-points",
        hint="give a longer part of the track",
        name=name,
        count=len(track.times),
        fewest=FEWEST,
    )
    require(sigma is None or sigma > 0.0, "the standard deviation is not above zero", code="sigma",
            hint="for example 3 cm, or leave it out")  # fmt: skip


def fitted(track: Track, sigma: float | None) -> "Smooth":
    """The smoothing spline of a track."""
    import numpy as np

    from dynamics_cli.numerics.fitting.smoothing import Smooth

    return Smooth(np.array(track.times), np.array(track.places), sigma)


def advice_of_fit(fit: "Smooth", track: Track, name: str = "the track") -> tuple[Advice, ...]:
    """Scatter that contradicts the standard deviation given, motion too fast for its samples, too large a map."""
    count = len(track.times)
    advice = []
    if fit.sigma_given is not None and not 1.0 / TOO_FAR < fit.measured_sigma / fit.sigma_given < TOO_FAR:
        apart = worded(
            "the positions scatter by {found} about {name} as smoothed, not by the stated {given}",
            found=(fit.measured_sigma, Length),
            name=name,
            given=(fit.sigma_given, Length),
        )
        advice.append(Advice("sigma", apart, remedy="leave out --sigma, or look for outliers in the track"))
    if fit.freedom > BUSY * count or (fit.thinned and fit.freedom > BUSY * len(fit.knots)):
        text = "the motion changes nearly as fast as it was sampled: noise and motion can hardly be separated"
        advice.append(Advice("busy", text, remedy="measure more often, or give a part of the track"))
    if track.origin and max(map(abs, (x for place in track.places for x in place[:2]))) > FLAT:
        advice.append(Advice("far", "the track is too long for a plane map", remedy="give a part of it"))
    return tuple(advice)
