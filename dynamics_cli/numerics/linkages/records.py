"""A linkage as users write it: links with points, slides, drivers, and the choice of assembly."""

from dynamics_cli.quantities import (
    Acceleration,
    Angle,
    AngularAcceleration,
    Annotated,
    Coordinate,
    Inertia,
    Mass,
    PartPoint,
    Speed,
    Text,
    TurnRate,
)
from dynamics_cli.records import Choice, record

GROUND = "ground"


class Way(Choice):
    """Which of two positions a pin takes."""

    names = ("left", "right", "ahead", "behind")
    aliases = {"+": "left", "-": "right"}  # noqa: RUF012


@record
class Pin:
    """A point of a link; points of one name are one pin."""

    name: Annotated[Text, "Its name; links that share it are pinned together there."]
    at: Annotated[PartPoint, "Where it is in the link's own axes, e.g. 40, 0 mm."]


@record
class Link:
    """A rigid link."""

    name: Annotated[Text, "Its name; the fixed link is called ground."]
    points: Annotated[tuple[Pin, ...], "Its points, two at least."]
    mass: Annotated[Mass, "Its mass, which `motion scene` needs of the same file, e.g. 2 kg."] = 0.0
    centroid: Annotated[PartPoint, "Its mass centre in its own axes, likewise, e.g. 150, 0 mm."] = (0.0, 0.0)
    moment: Annotated[Inertia, "Moment of inertia about its mass centre, likewise."] = 0.0
    rod: Annotated[bool, "True for a slender uniform rod between its first two points, likewise."] = False


@record
class Slide:
    """A pin that slides along a line of a link."""

    point: Annotated[Text, "The pin that slides."]
    link: Annotated[Text, "The link with the line."]
    start: Annotated[Text, "A point of that link on the line."]
    end: Annotated[Text, "Another; positions along the line count from the first to this."]


@record
class Driver:
    """A driver of the linkage: the angle of a link, or the position of a pin along its slide."""

    link: Annotated[Text, "The link that is turned; its angle is that of its own axes."] = ""
    against: Annotated[Text, "The link against which the angle is measured."] = GROUND
    angle: Annotated[Angle, "The angle, e.g. 40 deg."] = 0.0
    speed: Annotated[TurnRate, "Its rate, e.g. 10 rad/s."] = 0.0
    angular_acceleration: Annotated[AngularAcceleration, "Its second derivative, e.g. 5 rad/s^2."] = 0.0
    point: Annotated[Text, "Or the pin that is pushed along its slide."] = ""
    position: Annotated[Coordinate, "Its position from the start of the line, e.g. 120 mm."] = 0.0
    velocity: Annotated[Speed, "Its velocity along the line, e.g. 0.2 m/s."] = 0.0
    acceleration: Annotated[Acceleration, "Its acceleration along the line, e.g. 1 m/s^2."] = 0.0


@record
class Side:
    """One decision of the assembly."""

    pin: Annotated[Text, "The pin (or the slotted link) that has two places."]
    side: Annotated[
        Way, "left or right of the line from the first link's pin to the second's; ahead or behind along a slide."
    ]


@record
class Near:
    """Approximate position of a pin, for linkages that are not chains of dyads."""

    pin: Annotated[Text, "The pin."]
    at: Annotated[PartPoint, "Its approximate position, e.g. 120, 60 mm."]


@record
class Scene:
    """A planar linkage."""

    links: Annotated[tuple[Link, ...], "The links, ground among them."]
    drivers: Annotated[tuple[Driver, ...], "What drives it."]
    slides: Annotated[tuple[Slide, ...], "Pins that slide along lines."] = ()
    sides: Annotated[tuple[Side, ...], "The assembly, pin by pin."] = ()
    near: Annotated[tuple[Near, ...], "Approximate positions of pins."] = ()
