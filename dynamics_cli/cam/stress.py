"""Force along the follower's way, and the Hertz pressure it makes where cam and follower touch."""

from math import pi, sqrt

from dynamics_cli.cam.force_records import Contact
from dynamics_cli.cam.motion import Motion
from dynamics_cli.cam.searching import Found, greatest
from dynamics_cli.errors import require

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class Load:
    """Force along the follower's way, F = k s + P + m ω² s″, with P the preload and the external load together."""

    def __init__(self, motion: Motion, mass: float, rate: float, steady: float, omega: float) -> None:
        self.motion = motion
        self.rate = rate
        self.steady = steady
        self.inertia = mass * omega * omega
        self.mass = mass

    def force(self, s: "Any", s2: "Any") -> "Any":
        """The force, from lift and second derivative."""
        return self.rate * s + self.steady + self.inertia * s2


def stress(loads: Load, contact: Contact) -> Found:
    """Give the greatest Hertz pressure over the turn.

    Equation
    --------
    p = √(N E*/(π b ρ)), 1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂, 1/ρ = 1/ρ_cam + 1/R_r, N = F/cos φ.

    Parameters
    ----------
    loads : Load
        Forces along the follower's way.
    contact : Contact
        What touches.

    Returns
    -------
    Found
        The pressure [Pa] and where it is [rad].

    Raises
    ------
    InadmissibleError
        When the cam would be undercut, or a size or modulus is zero.
    """
    require(contact.width > 0.0, "a contact of no width bears nothing", code="width")
    require(contact.base_radius > 0.0, "a base circle of radius {0:.6g} m", contact.base_radius, code="base-radius")
    require(
        contact.cam_modulus > 0.0 and contact.follower_modulus > 0.0, "Young's modulus is above zero", code="modulus"
    )
    give = (1.0 - contact.cam_poisson * contact.cam_poisson) / contact.cam_modulus
    give += (1.0 - contact.follower_poisson * contact.follower_poisson) / contact.follower_modulus
    curved = _relative_curvature(contact)

    def squared(s: "Any", s1: "Any", s2: "Any") -> "Any":
        import numpy as np

        curvature, lean = curved(s, s1, s2)
        normal = np.maximum(loads.force(s, s2), 0.0) * lean
        return normal * curvature / (pi * contact.width * give)

    found = greatest(loads.motion, squared)
    return Found(sqrt(found.value), found.at)


def _relative_curvature(contact: Contact) -> "Any":
    """Sum of the curvatures of cam and follower, and 1/cos φ, as a function of s and its derivatives."""
    import numpy as np

    base, roller, offset = contact.base_radius, contact.roller_radius, contact.offset

    def flat(s: "Any", s1: "Any", s2: "Any") -> "tuple[Any, Any]":
        radius = base + s + s2
        _require_convex(radius)
        return 1.0 / radius, 1.0

    def rolling(s: "Any", s1: "Any", s2: "Any") -> "tuple[Any, Any]":
        assert roller is not None
        prime = base + roller
        require(abs(offset) < prime, "the offset {0:.6g} m passes the cam", offset, code="offset")
        x = sqrt((prime - offset) * (prime + offset)) + s
        y = s1 - offset
        w = np.hypot(x, y)
        # Curvature of the pitch curve; the cam's is κ/(1 − R κ), so that 1/ρ_cam + 1/R = 1/(R (1 − R κ)).
        pitch = (w * w + y * s1 - x * s2) / (w * w * w)
        left = 1.0 - roller * pitch
        _require_convex(left)
        return 1.0 / (roller * left), w / x

    if roller is None:
        require(
            offset == 0.0,
            "a flat face has no offset",
            code="offset",
            hint="give a roller radius, or leave the offset out",
        )
        return flat
    require(roller > 0.0, "a roller of radius {0:.6g} m is a knife edge: its stress is infinite", roller, code="roller")
    return rolling


def _require_convex(radius: "Any") -> None:
    worst = float(getattr(radius, "min", lambda: radius)())
    require(
        worst > 0.0,
        "the cam would be undercut: no contact to carry a stress",
        code="undercut",
        hint="take a larger base circle or a smaller roller; `dynamics cam size` finds the least",
    )
