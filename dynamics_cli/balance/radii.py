"""The radius of a trial weight, and of the correction that takes its place."""

from dynamics_cli.errors import require

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.balance.phasors import Phasor


def require_radii(radius: "Any", other: "Any") -> None:
    """Refuse radii of zero, and that of a correction without that of the trial weight."""
    require(all(r is None or r > 0.0 for r in (radius, other)), "a weight at the axis balances nothing", code="radius")
    require(
        other is None or radius is not None,
        "the radius of the correction is given, but not that of the trial weight",
        code="radius",
        hint="give the radius of the trial weight too",
    )


def at_radius(mass: "Any", radius: "Any", other: "Any") -> "Any":
    """A mass at the radius of the trial weight, moved to the radius of the correction."""
    return mass if other is None else mass * radius / other


def corrected(mass: "Phasor", trial: "Any", scale: float) -> "tuple[Any, Any, Any]":
    """Mass, angle and unbalance of a correction found at the radius of its trial weight."""
    unbalance = None if trial.radius is None else mass.size * trial.radius
    return at_radius(mass.size, trial.radius, trial.correction_radius), mass.angle_beside(scale), unbalance
