"""A planar scene as users write it: links with masses and points, slides, welds, springs, drivers and loads.

Words are those of `dynamics linkage solve`: points of one name are one pin, the fixed link is called ground.
"""

from dynamics_cli.numerics.linkages.records import GROUND, Near, Pin, Side
from dynamics_cli.quantities import (
    Acceleration,
    Angle,
    AngleFormula,
    AngularAcceleration,
    Annotated,
    Coordinate,
    Damping,
    ForceFormula,
    Inertia,
    InputFile,
    LengthFormula,
    Mass,
    PartPoint,
    PartVelocity,
    Size,
    Speed,
    Stiffness,
    Text,
    TorqueFormula,
    TorsionDamping,
    TorsionStiffness,
    TurnRate,
    TurnRateFormula,
)
from dynamics_cli.records import record


@record
class Link:
    """A rigid body."""

    name: Annotated[Text, "Its name; the fixed link is called ground."]
    points: Annotated[tuple[Pin, ...], "Its points."] = ()
    mass: Annotated[Mass, "Its mass; without one it is massless, e.g. 2 kg."] = 0.0
    centroid: Annotated[PartPoint, "Its mass centre in its own axes, e.g. 150, 0 mm."] = (0.0, 0.0)
    moment: Annotated[Inertia, "Moment of inertia about its mass centre; zero for a point mass."] = 0.0
    rod: Annotated[bool, "True for a slender uniform rod between its first two points."] = False
    angle: Annotated[Angle | None, "Angle of its own axes at the start, e.g. 30 deg."] = None
    position: Annotated[PartPoint | None, "Where its own origin is at the start, e.g. 0, 0 m."] = None
    speed: Annotated[TurnRate | None, "Its angular velocity at the start, e.g. 2 rad/s."] = None
    velocity: Annotated[PartVelocity | None, "Velocity of its own origin at the start, e.g. 1, 0 m/s."] = None


@record
class Slide:
    """A pin that slides along a line of a link."""

    point: Annotated[Text, "The pin that slides."]
    link: Annotated[Text, "The link with the line."]
    start: Annotated[Text, "A point of that link on the line."]
    end: Annotated[Text, "Another; positions along the line count from the first to this."]
    slider: Annotated[Text, "A link with that pin which does not turn on the line: a prismatic joint."] = ""


@record
class Weld:
    """Two links joined rigidly."""

    link: Annotated[Text, "The link that is welded on."]
    to: Annotated[Text, "The link that it is welded to."]
    at: Annotated[PartPoint, "Where its own origin is in the axes of the other, e.g. 100, 0 mm."] = (0.0, 0.0)
    angle: Annotated[Angle, "Its angle against the other."] = 0.0


@record
class Spring:
    """A spring with a damper between two points."""

    from_: Annotated[Text, "The point at one end."]
    to: Annotated[Text, "The point at the other end."]
    stiffness: Annotated[Stiffness, "Its stiffness, e.g. 2 N/mm."] = 0.0
    free_length: Annotated[Size | None, "Its free length; that at the start if left out, e.g. 300 mm."] = None
    damping: Annotated[Damping, "Force per speed of a damper beside it, e.g. 50 N*s/m."] = 0.0


@record
class Torsion:
    """A torsion spring with a damper between two links."""

    link: Annotated[Text, "The link that it turns."]
    against: Annotated[Text, "The link at its other end."] = GROUND
    stiffness: Annotated[TorsionStiffness, "Its stiffness, e.g. 5 N*m/rad."] = 0.0
    free_angle: Annotated[Angle | None, "Angle between the links where it is free; that at the start if left out."] = (
        None
    )
    damping: Annotated[TorsionDamping, "Torque per angular velocity of a damper beside it."] = 0.0


@record
class Driver:
    """A prescribed motion: the angle of a link, or the position of a pin along its slide."""

    link: Annotated[Text, "The link that is turned."] = ""
    against: Annotated[Text, "The link against which its angle is measured."] = GROUND
    angle: Annotated[Angle | None, "The angle at the start; that of the scene if left out, e.g. 40 deg."] = None
    speed: Annotated[TurnRate, "Its rate at the start, e.g. 10 rad/s."] = 0.0
    angular_acceleration: Annotated[AngularAcceleration, "Its second derivative, which stays, e.g. 5 rad/s^2."] = 0.0
    angle_law: Annotated[AngleFormula | None, "Or the angle over time t in s, e.g. 90*sin(t) deg."] = None
    speed_law: Annotated[TurnRateFormula | None, "Or its rate over time, e.g. 300*t rpm."] = None
    point: Annotated[Text, "Or the pin that is pushed along its slide."] = ""
    position: Annotated[Coordinate | None, "Its position from the start of the line, e.g. 120 mm."] = None
    velocity: Annotated[Speed, "Its velocity along the line at the start, e.g. 0.2 m/s."] = 0.0
    acceleration: Annotated[Acceleration, "Its acceleration, which stays, e.g. 1 m/s^2."] = 0.0
    position_law: Annotated[LengthFormula | None, "Or its position over time t in s, e.g. 20*sin(3*t) mm."] = None
    table: Annotated[InputFile, "Or a CSV of times t[s] with angle[deg], speed[rad/s] or position[mm]."] = ""


@record
class Load:
    """A force at a point, or a torque on a link."""

    point: Annotated[Text, "The point where a force acts."] = ""
    link: Annotated[Text, "The link on which a torque acts, or the one whose axes a force follows."] = ""
    force_x: Annotated[ForceFormula | None, "Force along x, of t, x, y, vx, vy, e.g. 20 N*sin(5 rad/s*t)."] = None
    force_y: Annotated[ForceFormula | None, "Force along y, e.g. -50 N."] = None
    torque: Annotated[TorqueFormula | None, "Torque, of t, angle and speed, e.g. 2 N*m - 0.01 N*m*s*speed."] = None
    table: Annotated[InputFile, "Or a CSV of times t[s] with force_x[N], force_y[N] or torque[N*m]."] = ""


@record
class Scene:
    """A planar system of bodies."""

    links: Annotated[tuple[Link, ...], "The links, ground among them."]
    slides: Annotated[tuple[Slide, ...], "Pins that slide along lines."] = ()
    welds: Annotated[tuple[Weld, ...], "Links joined rigidly."] = ()
    springs: Annotated[tuple[Spring, ...], "Springs and dampers between points."] = ()
    torsions: Annotated[tuple[Torsion, ...], "Torsion springs and dampers between links."] = ()
    drivers: Annotated[tuple[Driver, ...], "Prescribed motions."] = ()
    loads: Annotated[tuple[Load, ...], "Forces and torques."] = ()
    sides: Annotated[tuple[Side, ...], "How it is put together at the start, pin by pin."] = ()
    near: Annotated[tuple[Near, ...], "Roughly where pins are at the start."] = ()
    horizontal: Annotated[bool, "True for a horizontal plane: nothing has weight."] = False
