"""Conventions shared by all impacts: axes and headings, mass and velocity of a body, ΔV, and the zero of PDOF.

Everything here takes single numbers, arrays and tracked numbers. Every result names its conventions.
"""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import atan2, hypot, multiply_add, where
from dynamics_cli.numerics.turns import turned
from dynamics_cli.quantities import (
    Angle,
    Annotated,
    Heading,
    Mass,
    PlanarVelocity,
    Positive,
    Ratio,
    Remark,
    Restitution,
    RoadSpeed,
    RoadVelocity,
    Text,
    Weight,
)
from dynamics_cli.records import Choice, record

PI = 3.141592653589793
# Adding and subtracting this rounds a number below 2^50 to the nearest integer.
ROUNDER = 6755399441055744.0


class Axes(Choice):
    """Axes of the plane, from which headings and spins are measured; the default is mathematical.

    mathematical: x right (east), y up (north), headings counterclockwise from x.
    compass: x east, y north, headings clockwise from north, spins counterclockwise.
    sae: x ahead, y right, z down, headings and spins clockwise seen from above.
    iso: x ahead, y left, z up, headings and spins counterclockwise seen from above.
    """

    names = ("mathematical", "compass", "sae", "iso")
    aliases = {"math": "mathematical", "north": "compass", "sae-j670": "sae", "iso-8855": "iso"}  # noqa: RUF012


class PdofZero(Choice):
    """Direction from which a force has PDOF zero; PDOF grows clockwise seen from above, to ±180 degrees.

    heading: straight ahead of the vehicle's nose (12 o'clock). travel: the direction of travel before the impact.
    scene: the direction of heading zero of the scene's axes. The default is heading.
    """

    names = ("heading", "travel", "scene")
    aliases = {"nose": "heading", "front": "heading", "velocity": "travel", "north": "scene"}  # noqa: RUF012


AXES = Axes("mathematical")
PDOF_ZERO = PdofZero("heading")

_AXES_WORDS = {
    "mathematical": (
        "mathematical: x right (east), y up (north)",
        "counterclockwise from x; spins counterclockwise",
    ),
    "compass": ("compass: x east, y north", "clockwise from north; spins counterclockwise"),
    "sae": ("SAE: x ahead, y right, z down", "clockwise from x seen from above; spins clockwise"),
    "iso": ("ISO: x ahead, y left, z up", "counterclockwise from x seen from above; spins counterclockwise"),
}
_ZERO_WORDS = {
    "heading": "0 is a force from straight ahead of the nose (12 o'clock), clockwise positive seen from above",
    "travel": "0 is a force from the direction of travel before the impact, clockwise positive seen from above",
    "scene": "0 is a force from the direction of heading zero of the scene, clockwise positive seen from above",
}


@record
class Conventions:
    """The conventions a result is written in."""

    axes: Annotated[Remark, "The axes of vectors."]
    headings: Annotated[Remark, "How headings and spins are measured."]
    pdof: Annotated[Remark | None, "The zero and the sense of PDOF."] = None


def conventions(axes: Axes = AXES, pdof_zero: PdofZero | None = PDOF_ZERO) -> Conventions:
    """Name the conventions in words; PDOF only where a result has one."""
    named, headings = _AXES_WORDS[axes]
    return Conventions(named, headings, None if pdof_zero is None else _ZERO_WORDS[pdof_zero])


BodyName = Annotated[Text | None, "Name of the body for labels of answers, e.g. Ford."]


@record
class ByMass:
    """A body by its mass."""

    mass: Annotated[Mass, "Mass of the body [kg]."]


@record
class ByWeight:
    """A body by its weight."""

    weight: Annotated[Weight, "Weight of the body, its mass times gravity [N]."]


@record
class Fixed:
    """A fixed, rigid body: a wall, a floor, a barrier."""

    fixed: Annotated[bool, "The body is fixed: a wall, a floor, a barrier; it keeps its velocity whatever strikes it."]


def side_of(name: str) -> str:
    """The address of a body that messages call "the first body"."""
    return "second" if "second" in name else "first"


def mass_of(bulk: ByMass | ByWeight, gravity: float, name: str = "the body") -> float:
    """Mass as given or from the weight; refuses a mass of zero."""
    if isinstance(bulk, ByWeight):
        return bulk.weight / gravity
    require(bulk.mass > 0.0, "the mass of {name} must be above zero", name=name, code="no-mass")
    return bulk.mass


@record
class ByVelocity:
    """A velocity by its components (`3, 1 m/s`), or by size and mathematical angle (`30 mph @ 45 deg`)."""

    velocity: Annotated[
        PlanarVelocity,
        "Velocity along the axes x, y; an angle after @ is counted from x towards y, whatever the axes [m/s].",
    ]


@record
class BySpeed:
    """A velocity by speed and heading."""

    speed: Annotated[RoadSpeed, "Size of the velocity [m/s]."]
    heading: Annotated[
        Heading,
        "Direction of travel, counted as the axes say: clockwise from north on a compass, else from x towards y [rad].",
    ] = 0.0


def direction_of(heading: float, axes: Axes = AXES) -> tuple[float, float]:
    """Unit vector of a heading."""
    cosine, sine = turned(heading)
    return (sine, cosine) if axes == "compass" else (cosine, sine)


def travel_of(velocity: tuple[float, float], axes: Axes) -> tuple[float, float]:
    """Unit vector of travel, of a body at rest the direction of heading zero."""
    speed = hypot(velocity[0], velocity[1])
    moves = speed > 0.0
    safe = where(moves, speed, 1.0)
    zero = direction_of(0.0, axes)
    return where(moves, velocity[0] / safe, zero[0]), where(moves, velocity[1] / safe, zero[1])


def heading_of(x: float, y: float, axes: Axes = AXES) -> float:
    """Heading of a vector, in (−π, π]; minus zero is zero, which an arc tangent would turn to −π."""
    x, y = x + 0.0, y + 0.0
    return atan2(x, y) if axes == "compass" else atan2(y, x)


def velocity_of(motion: ByVelocity | BySpeed, axes: Axes = AXES) -> tuple[float, float]:
    """Components of a velocity along x and y."""
    if isinstance(motion, ByVelocity):
        return motion.velocity
    along, across = direction_of(motion.heading, axes)
    return motion.speed * along, motion.speed * across


@record
class DeltaV:
    """Change of velocity of one body, from its impulse over its mass, and where the force came from."""

    vector: Annotated[PlanarVelocity, "Change of velocity along the scene's axes [m/s]."]
    magnitude: Annotated[RoadSpeed, "Size of the change of velocity [m/s]."]
    longitudinal: Annotated[RoadVelocity, "Its part along the nose of the body, ahead positive [m/s]."]
    lateral: Annotated[RoadVelocity, "Its lateral component: positive to the left, in SAE axes to the right [m/s]."]
    pdof: Annotated[
        Angle, "Principal direction of force: where the force came from, clockwise from the zero that is named [rad]."
    ]
    clock: Annotated[Ratio, "The same as the nearest hour on a clock whose 12 is straight ahead of the nose [h]."]


def delta_v(
    impulse: tuple[float, float],
    mass: float,
    nose: tuple[float, float],
    *,
    axes: Axes = AXES,
    pdof_zero: PdofZero = PDOF_ZERO,
    travel: tuple[float, float] = (1.0, 0.0),
    size: float = 1.0,
) -> DeltaV:
    """ΔV = J/m of a body whose nose points along the unit vector `nose`, travelling along `travel` before.

    The impulse, not a difference of velocities: no digits cancel. It may be given as a direction and its `size`.
    """
    change = size / mass
    x, y = impulse[0] * change, impulse[1] * change
    longitudinal = change * multiply_add(impulse[0], nose[0], impulse[1] * nose[1])
    lateral = change * multiply_add(impulse[1], nose[0], -(impulse[0] * nose[1]))
    zero = {"heading": nose, "travel": travel, "scene": direction_of(0.0, axes)}[pdof_zero]
    angle = pdof(impulse, zero, axes)
    hours = angle if pdof_zero == "heading" else pdof(impulse, nose, axes)
    return DeltaV((x, y), hypot(x, y), longitudinal, lateral, angle, clock(hours))


def pdof(impulse: tuple[float, float], zero: tuple[float, float], axes: Axes = AXES) -> float:
    """Angle from `zero`, clockwise seen from above, to where the force came from: against the impulse; in (−π, π]."""
    x, y = 0.0 - impulse[0], 0.0 - impulse[1]
    across = multiply_add(x, zero[1], -(y * zero[0]))
    # seen from above, x turns towards y counterclockwise unless z points down
    angle = atan2(0.0 - across if axes == "sae" else across, x * zero[0] + y * zero[1])
    return where(angle <= -PI, angle + 2.0 * PI, angle)


def clock(angle: float) -> float:
    """Nearest hour, 1 to 12, of a PDOF measured from the nose."""
    hours = getattr(angle, "value", angle) * (6.0 / PI)
    hour = (hours + ROUNDER) - ROUNDER
    return where(hour <= 0.0, hour + 12.0, hour)


@record
class Restituted:
    """A contact by its coefficient of restitution."""

    restitution: Annotated[Restitution, "Coefficient of restitution, separation speed over closing speed [-]."]


@record
class Energetic:
    """A contact that may add energy: an explosive, a released spring, a bumper under pressure."""

    energetic_contact: Annotated[
        Positive, "Separation speed over closing speed; above 1 the contact adds energy, e.g. 1.2 [-]."
    ]

    @property
    def restitution(self) -> float:
        """The ratio as a coefficient of restitution."""
        return self.energetic_contact
