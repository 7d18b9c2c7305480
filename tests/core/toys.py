"""Small tasks, one for each convention of signatures, registered as the family `toy` by the tests."""

import math

from dynamics_cli.core.answering.task import Family, Model, Task
from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import sqrt
from dynamics_cli.outlines import Arc, Cubic, Drawing, Line, Outline, Points, circle
from dynamics_cli.pictures import Arrow, Axis, Band, Mark, Panel, Picture
from dynamics_cli.pictures import Curve as Curve_
from dynamics_cli.quantities import (
    Angle,
    Area,
    Count,
    Distance,
    ExactRatio,
    Friction,
    Inertia,
    InertiaTensor,
    InputFile,
    Length,
    Mass,
    PlanarVelocity,
    Position,
    Ratio,
    RoadSpeed,
    Size,
    Slope,
    Speed,
    Text,
    Torque,
    Volume,
    WholeRange,
)
from dynamics_cli.records import Advice, Check, Choice, Columns, ErrorBound, Numerics, record, tagged


@record
class Radius:
    """A radius given.

    Parameters
    ----------
    radius : Length
        The radius.
    """

    radius: Length


@record
class Chord:
    """A radius from chord and middle ordinate.

    Parameters
    ----------
    chord : Length
        The chord.
    ordinate : Length
        The middle ordinate.
    """

    chord: Length
    ordinate: Length

    @property
    def radius(self) -> float:
        return self.chord * self.chord / (8.0 * self.ordinate) + self.ordinate / 2.0


@record
class One:
    """One length.

    Parameters
    ----------
    value : Length
        A length.
    """

    value: Length


def arc(*, path: Radius | Chord, from_: Angle = 0.0, upto: Angle) -> One:
    """Length of an arc.

    Parameters
    ----------
    from_ : Angle
        Start.
    upto : Angle
        End.
    """
    return One(path.radius * (upto - from_))


@record
class Stretch:
    """A stretch.

    Parameters
    ----------
    distance : Distance
        Its length.
    friction : Friction
        Its friction.
    """

    distance: Distance
    friction: Friction = 0.7


@record
class Row:
    """A row of a table.

    Parameters
    ----------
    distance : Distance
        A distance.
    work : Ratio
        Work per weight and metre.
    """

    distance: Distance
    work: Ratio


@record
class Journey:
    """A total, and a table of few rows.

    Parameters
    ----------
    total : Distance
        The total.
    rows : tuple of Row
        The stretches.
    """

    total: Distance
    rows: tuple[Row, ...]


def journey(*, stretches: Stretch | tuple[Stretch, ...]) -> Journey:
    """Add stretches.

    Parameters
    ----------
    stretches : Stretch
        The stretches.
    """
    parts = stretches if isinstance(stretches, tuple) else (stretches,)
    total = parts[0].distance
    for part in parts[1:]:
        total = total + part.distance
    return Journey(total, tuple(Row(part.distance, part.distance * part.friction) for part in parts))


@record
class Body:
    """A body.

    Parameters
    ----------
    mass : Mass
        Its mass.
    velocity : PlanarVelocity
        Its velocity.
    """

    mass: Mass
    velocity: PlanarVelocity


@record
class Pair:
    """What two bodies have in common.

    Parameters
    ----------
    mass : Mass
        Total mass.
    velocity : PlanarVelocity
        Velocity of the mass centre.
    """

    mass: Mass
    velocity: PlanarVelocity


def pair(*, first: Body, second: Body) -> Pair:
    """Join two bodies.

    Parameters
    ----------
    first : Body
        One.
    second : Body
        Other.
    """
    total = first.mass + second.mass
    require(total > 0.0, "the bodies weigh {0:.3g} kg together", total, code="no-mass")
    momentum = [first.mass * a + second.mass * b for a, b in zip(first.velocity, second.velocity, strict=True)]
    return Pair(total, (momentum[0] / total, momentum[1] / total))


@tagged("shape")
@record
class Cylinder:
    """A cylinder.

    Parameters
    ----------
    radius : Size
        Radius.
    length : Size
        Length.
    """

    radius: Size
    length: Size


@tagged("shape")
@record
class Ball:
    """A ball.

    Parameters
    ----------
    radius : Size
        Radius.
    """

    radius: Size


Shape = Cylinder | Ball


@record
class Part:
    """A part of an assembly, with parts of its own.

    Parameters
    ----------
    shape : Shape
        Its shape.
    position : Position
        Where it is.
    parts : tuple of Part
        Parts within it.
    """

    shape: Shape | None = None
    position: Position = (0.0, 0.0, 0.0)
    parts: "tuple[Part, ...]" = ()


@record
class Bulk:
    """What an assembly comes to.

    Parameters
    ----------
    volume : Volume
        Its volume.
    count : Count
        Number of shapes.
    """

    volume: Volume
    count: Count


def volume(shape: Shape, /) -> Bulk:
    """Give the volume of a shape."""
    return Bulk(_volume(shape), 1)


def assembly(scene: Part, /) -> Bulk:
    """Give the volume of an assembly."""
    volumes = list(_volumes(scene))
    return Bulk(sum(volumes[1:], volumes[0]), len(volumes))


def _volumes(part: Part):
    if part.shape is not None:
        yield _volume(part.shape)
    for inner in part.parts:
        yield from _volumes(inner)


def _volume(shape: Cylinder | Ball) -> float:
    if isinstance(shape, Cylinder):
        return 3.0 * shape.radius * shape.radius * shape.length
    return 4.0 * shape.radius * shape.radius * shape.radius


@record
class Spin:
    """Moment of inertia about an axis.

    Parameters
    ----------
    moment : Inertia
        The moment.
    """

    moment: Inertia


def spin(*, tensor: InertiaTensor, axis: Position) -> Spin:
    """Give the moment about an axis.

    Parameters
    ----------
    tensor : InertiaTensor
        The tensor.
    axis : Position
        The axis.
    """
    moment = 0.0
    square = 0.0
    for i in range(3):
        square = square + axis[i] * axis[i]
        for j in range(3):
            moment = moment + tensor[i][j] * axis[i] * axis[j]
    return Spin(moment / square)


@record
class Point:
    """A point of a curve.

    Parameters
    ----------
    angle : Angle
        Angle.
    lift : Size
        Lift.
    """

    angle: Angle
    lift: Size


@record
class Curve:
    """Many rows as columns.

    Parameters
    ----------
    peak : Size
        The peak.
    points : Columns of Point
        The points.
    """

    peak: Size
    points: Columns[Point]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def curve(*, lift: Size, count: Count = 5) -> Curve:
    """Give a straight rise.

    Parameters
    ----------
    lift : Size
        The lift.
    count : Count
        How many points.
    """
    import numpy as np

    steps = np.linspace(0.0, 1.0, count)
    points = Columns(Point, angle=steps, lift=lift * steps)
    return Curve(
        lift,
        points,
        (Check("ends at the lift", True, 0.0, 0.0),),
        (Advice("steep", "the rise is steep", remedy=worded("raise the span to {span:6}", span=(2.0, Angle))),),
        Numerics("sampling", (ErrorBound("peak", 1e-15),)),
    )


def curve_picture(made: Curve, *, lift: float, count: int = 5) -> Picture:
    """Every item there is, on two panels."""
    points = made.points.arrays
    angle, rise = points["angle"].tolist(), points["lift"].tolist()
    over = Panel(
        Axis("angle", Angle),
        Axis("lift", Size),
        (
            Curve_(angle, rise, "rise"),
            Curve_([0.0, 1.0, 1.0], [0.0, lift, math.nan], "broken", "points"),
            Mark(0.5, 0.5 * lift, "half way"),
            Arrow(0.0, 0.0, 0.5, 0.5 * lift, "up", 1),
            Band(0.2, 0.4, "a stretch"),
            Band(lift, lift, "the top", vertical=False),
        ),
        "a rise",
    )
    plan = Panel(
        Axis("x", Size), Axis("y", Size), (Curve_([0.0, lift, lift], [0.0, 0.0, lift], "", "filled"),), equal=True
    )
    powers = [10.0**i for i in range(count)]
    decades = Panel(Axis("x", logarithmic=True), Axis("y", logarithmic=True), (Curve_(powers, powers, style="steps"),))
    return Picture((over, plan, decades), f"a curve of {count} points", 2)


class Law(Choice):
    """A law."""

    names = ("linear", "modified-sine")
    aliases = {"harmonic": "modified-sine"}  # noqa: RUF012


@record
class Words:
    """What was said.

    Parameters
    ----------
    said : Text
        The words.
    """

    said: Text


def say(
    *,
    law: Law,
    note: Text = "",
    teeth: ExactRatio | None = None,
    times: WholeRange = (1, 1),
    loud: bool = False,
    file: InputFile = "",
) -> Words:
    """Say it.

    Parameters
    ----------
    law : Law
        The law.
    note : Text
        A note.
    teeth : ExactRatio
        A ratio.
    times : WholeRange
        How often, from and to.
    loud : bool
        Loudly.
    file : InputFile
        A file.
    """
    text = f"{law} {note} {teeth} {'' if times == (1, 1) else times} {file.rpartition('/')[2]}".strip()
    return Words(text.upper() if loud else text)


@record
class Fall:
    """A speed.

    Parameters
    ----------
    speed : RoadSpeed
        The speed.
    """

    speed: RoadSpeed


def fall(*, height: Length, speed_before: Speed = 0.0, grade: Slope = 0.0) -> Fall:
    """Fall from a height.

    Parameters
    ----------
    height : Length
        The height.
    speed_before : Speed
        Speed before.
    grade : Slope
        A slope.
    """
    require(height > 0.0, "the height {0:.3g} m is not above zero", height, code="no-height", hint="raise it")
    return Fall(sqrt(2.0 * 9.8 * height + speed_before * speed_before) + 0.0 * grade)


def standing(*, height: Length, speed_before: Speed = 0.0, grade: Slope = 0.0) -> Fall:
    """Fall from rest.

    Parameters
    ----------
    height : Length
        The height.
    speed_before : Speed
        Speed before.
    grade : Slope
        A slope.
    """
    require(height > 0.0, "the height {0:.3g} m is not above zero", height, code="no-height", hint="raise it")
    return Fall(sqrt(19.6 * height))


def from_rest(*, height: float, speed_before: float = 0.0, grade: float = 0.0) -> str | None:
    """Say whether it starts from rest."""
    return "it starts from rest" if speed_before == 0.0 else None


@record
class Turned:
    """A torque.

    Parameters
    ----------
    torque : Torque
        The torque.
    area : Area
        An area.
    """

    torque: Torque
    area: Area


def mean(*, torques: tuple[Torque, ...], side: Size) -> Turned:
    """Give the mean torque.

    Parameters
    ----------
    torques : tuple of Torque
        Torques.
    side : Size
        A side.
    """
    total = torques[0]
    for torque in torques[1:]:
        total = total + torque
    return Turned(total / len(torques), side * side)


@record
class Plate:
    """A plate to be cut.

    Parameters
    ----------
    width : Size
        Its width.
    shape : Drawing
        Its outlines.
    """

    width: Size
    shape: Drawing | None
    advice: tuple[Advice, ...] = ()


def plate(*, width: Size, radius: Size = 0.01, thin: bool = False) -> Plate:
    """Give a plate with a rounded edge, a bore, and an open score of many points.

    Parameters
    ----------
    width : Size
        Its width.
    radius : Size
        The radius of its round.
    thin : bool
        Nothing can be cut.
    """
    if thin:
        return Plate(width, None, (Advice("thin", "it is too thin to cut", result="shape"),))
    a, b, c = (0.0, 0.0), (width, 0.0), (width, 2.0 * radius)
    edge = Outline(
        (Line(a, b), Arc(b, c, 1.0), Cubic(c, (2.0 * width / 3.0, 0.1), (width / 3.0, -0.0), (0.1, 0.03)),
         Points(((0.1, 0.03), (0.05, 1 / 30), (0.0, 0.03))), Line((0.0, 0.03), a)),
        True, 1.25e-9, "edge",
    )  # fmt: skip
    bore = Outline(circle((width / 3.0, 0.01), 0.3 * radius, clockwise=True), True, 0.0, "bore ø")
    score = Outline((Points(tuple((0.001 * i, 0.001 / (1 + i)) for i in range(20))),), False, 2e-7)
    return Plate(width, Drawing((edge, bore, score), "a plate"))


@record
class Disc:
    """A disc.

    Parameters
    ----------
    radius : Size
        Its radius.
    rim : Outline
        Its rim.
    """

    radius: Size
    rim: Outline


def disc(*, radius: Size) -> Disc:
    """Give a disc.

    Parameters
    ----------
    radius : Size
        Its radius.
    """
    return Disc(radius, Outline(circle((0.0, 0.0), radius), True, 0.0, "rim"))


def as_words(disc: Disc) -> str:
    """A writer of the family's own: plain numbers."""
    return f"disc of {disc.radius!r} m\n"


def _task(name: str, *functions: str, **more: object) -> Task:
    models = [
        Model(f"model {function}", f"toys:{function}", source="a test", formula="", suffices=suffices)
        for function, _, suffices in (entry.partition(" ") for entry in functions)
    ]
    return Task(name, f"The toy {name}.", *models, **more)


FAMILIES = {
    "toy": Family(
        "toy",
        "Toys.",
        _task("arc", "arc"),
        _task("journey", "journey", table="rows"),
        _task("pair", "pair"),
        _task("volume", "volume"),
        _task("assembly", "assembly"),
        _task("spin", "spin"),
        _task("curve", "curve", table="points", tracked=False, arrays=False, plot="toys:curve_picture"),
        _task("say", "say", tracked=False, arrays=False),
        _task("fall", "standing toys:from_rest", "fall"),
        _task("mean", "mean"),
        _task("plate", "plate", tracked=False, arrays=False),
        _task("disc", "disc", arrays=False, writers={"words": "toys:as_words"}),
    )
}
