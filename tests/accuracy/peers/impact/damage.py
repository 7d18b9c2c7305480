"""Crush as it is reckoned in haste."""

from types import SimpleNamespace

from dynamics_cli.accuracy.alternatives.impact.reconstruction import crush

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def _even(vehicle: "Any") -> "Any":
    """The same vehicle, crushed by its mean depth everywhere."""
    profile = getattr(vehicle, "profile", None)
    if not hasattr(profile, "stations"):
        return vehicle
    first, *inner, last = profile.stations
    depth = (0.5 * (first + last) + sum(inner)) / (len(inner) + 1)
    return SimpleNamespace(**{**vars(vehicle), "profile": SimpleNamespace(mean_crush=depth, width=profile.width)})


def crush_by_mean(*, first: "Any", second: "Any" = None, **given: "Any") -> "dict[str, float]":
    """The mean depth over all the width: the square of the mean for the mean of squares."""
    return crush(first=_even(first), second=_even(second), **given)
