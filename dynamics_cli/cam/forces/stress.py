"""Force along the common normal of cam and follower, and the Hertz pressure at the contact."""

from math import pi, sqrt

import numpy as np

from dynamics_cli.cam.forces.survey import Found, Sum, Survey
from dynamics_cli.cam.geometry.analysis import start_slip
from dynamics_cli.cam.geometry.contact import Geometry, check_speed
from dynamics_cli.cam.geometry.followers import FlatFace, OscillatingFlat, OscillatingRoller
from dynamics_cli.cam.program.summary import extreme
from dynamics_cli.errors import require
from dynamics_cli.quantities import Angle, Coordinate, Ratio

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.cam.forces.loads import Load
    from dynamics_cli.cam.forces.records import Contact
    from dynamics_cli.cam.program.motion import Motion

DEGREE = pi / 180.0
UNIT = 2.0**-53


class Touching:
    """A follower's load along the common normal, and the conformity of the contact; also for complex numbers.

    `load`: the force, or an arm's torque, that the cam must supply; `slip`: error of the follower's start, for discs.
    """

    def __init__(self, geometry: Geometry, load: "Load", slip: float = 0.0) -> None:
        self.geometry = geometry
        self.load = load
        self.slip = slip
        self.follower = geometry.follower
        self.turn, self.start = geometry.turn, geometry.start

    def enclosed(self) -> "Touching":
        """The same for discs, including the rounding of the load's constants and of the follower's start."""
        return Touching(self.geometry, self.load.enclosed(), start_slip(self.geometry))

    def gain(self, s: "Any", s1: "Any", s2: "Any") -> "Any":
        """Normal force for each unit of load: 1/cos φ for a slide, 1/(lever of the normal about the pivot) for an arm.

        N/F = w/X = √(1 + (Y/X)²); N/M = w/(L c sin ψ) with a roller, (1 + ψ′)/(c cos ψ) with a flat face.
        """
        f, s1 = self.follower, self.turn * s1
        s = s.widened(self.slip) if self.slip else s
        if isinstance(f, FlatFace):
            return 1.0 + 0.0 * s
        if isinstance(f, OscillatingFlat):
            return (1.0 + s1) / (f.pivot_distance * np.cos(self.start + s))
        if isinstance(f, OscillatingRoller):
            angle, c = self.start + s, f.pivot_distance
            # w² = (g − c)² + 4 g c sin²(ψ/2), g = L(1 + ψ′): nothing cancels near the line of pivot and axis
            apart, half = (f.arm - c) + f.arm * s1, np.sin(0.5 * angle)
            square = apart * apart + 4.0 * (f.arm * (1.0 + s1)) * c * half * half
            return np.sqrt(square) / (f.arm * c * np.sin(angle))
        lean = (s1 - f.offset) / (self.start + s)  # type: ignore[union-attr]
        return np.sqrt(1.0 + lean * lean)

    def normal(self, s: "Any", s1: "Any", s2: "Any") -> "Any":
        """The force along the common normal."""
        return self.load.force(s, s2) * self.gain(s, s1, s2)

    def room(self, s: "Any", s1: "Any", s2: "Any") -> "Any":
        """1 − R κ of a roller on the pitch curve, or the radius of curvature under a flat face: zero at a cusp."""
        f, s1 = self.follower, self.turn * s1
        s = s.widened(self.slip) if self.slip else s
        if isinstance(f, FlatFace):
            return self.start + s + s2
        if isinstance(f, OscillatingFlat):
            angle, speed = self.start + s, 1.0 + s1
            bend = np.sin(angle) * (1.0 + 2.0 * s1) * speed + s2 * np.cos(angle)
            return f.pivot_distance * bend / (speed * speed * speed) - f.face_offset
        _, _, x, y, x1, y1 = self.geometry.pitch(s, s1, s2)[:6]
        square = x * x + y * y
        return 1.0 - self.geometry.roller * (square + y * x1 - x * y1) / (square * np.sqrt(square))


def require_lever(geometry: Geometry, motion: "Motion") -> None:
    """Refuse a follower that the contact force cannot drive all the way, from the stroke.

    Raises InadmissibleError when a slide comes down to the height of the cam's axis, an arm to the line of pivot and
    axis, a flat face to the pivot, or a flat face would have to turn as fast as the cam.
    """
    least, most = (geometry.start + end for end in motion.stroke)
    if isinstance(geometry.follower, FlatFace):
        return
    if not geometry.oscillating:
        require(
            least > 0.0,
            "the follower comes down to {least} above the cam's axis: the pressure angle reaches 90 deg",
            least=(least, Coordinate),
            code="through-axis",
            hint="take a larger base circle, or a smaller offset",
        )
        return
    top = 90.0 if geometry.flat else 180.0
    require(
        least > 0.0 and most < top * DEGREE,
        "the arm swings from {least} to {most} off the line of pivot and cam axis: beyond {zero} and {top} the "
        "contact force has no lever",
        least=(least, Angle), most=(most, Angle), zero=(0.0, Angle), top=(top * DEGREE, Angle),
        code="no-lever",
        hint="take another base circle, arm or pivot distance",
    )  # fmt: skip
    speed = extreme(motion, 1)
    check_speed(geometry, (speed.least, speed.greatest))


def stress(motion: "Motion", touching: Touching, contact: "Contact") -> Found:
    """Give the greatest Hertz pressure over the turn (Hertz's line contact).

    p = √(N E*/(π b ρ)), 1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂, 1/ρ = 1/ρ_cam + 1/R.

    `touching`: the follower on the cam; `contact`: width and materials. Returns the pressure [Pa], where it is [rad],
    and its bound. Raises InadmissibleError when the cam comes to a cusp, the follower is an edge, or the width or a
    modulus is zero.
    """
    geometry = touching.geometry
    give = _compliance(contact)
    require(
        geometry.flat or geometry.roller > 0.0,
        "the follower is an edge: its contact stress is infinite",
        code="edge",
        hint="give a roller radius, or leave the contact out",
    )
    exact = touching.enclosed()
    survey = Survey(motion, exact.normal, exact.room)
    least, _ = survey.extremes(1)
    require(
        least.value > 0.0,
        "the cam is undercut at {at:6}: the follower does not touch it there",
        at=(least.at, Angle),
        code="undercut",
        hint="take a larger base circle or a smaller roller; `dynamics cam size` finds the smallest",
    )
    # N/ρ is the normal force over the room under a flat face, or over the room R(1 − R κ) of a roller
    most = survey.greatest_quotient(Sum((0.0, 0.0, 0.0, 1.0)), Sum((0.0, 0.0, 0.0, 0.0, 1.0)))
    if most.value <= 0.0:
        return Found(0.0, most.at, 0.0)
    pressure = sqrt(most.value / (pi * contact.width * give * (1.0 if geometry.flat else geometry.roller)))
    return Found(pressure, most.at, pressure * (0.5 * most.error / most.value + 8.0 * UNIT))


def _compliance(contact: "Contact") -> float:
    require(contact.width > 0.0, "the contact width is zero; wanted a positive width", code="width")
    require(
        contact.cam_modulus > 0.0 and contact.follower_modulus > 0.0,
        "Young's modulus is zero; wanted a positive modulus",
        code="modulus",
    )
    for ratio in (contact.cam_poisson, contact.follower_poisson):
        require(
            -1.0 < ratio <= 0.5,
            "Poisson's ratio is {ratio}; wanted -1 to 0.5",
            ratio=(ratio, Ratio),
            code="poisson",
        )
    give = (1.0 - contact.cam_poisson * contact.cam_poisson) / contact.cam_modulus
    return give + (1.0 - contact.follower_poisson * contact.follower_poisson) / contact.follower_modulus
