"""Inputs and results of `cam export`."""

from dynamics_cli.outlines import Drawing
from dynamics_cli.quantities import Angle, Annotated, CamAcceleration, CamVelocity, Coordinate, Count, Ratio, Size
from dynamics_cli.records import Check, Choice, Columns, Numerics, record


class Curve(Choice):
    """Which curve is drawn."""

    names = ("cam", "pitch", "cutter")


class Form(Choice):
    """The kind of pieces of the curve."""

    names = ("arcs", "cubics", "lines")
    aliases = {"splines": "cubics", "spline": "cubics", "polyline": "lines", "arc": "arcs"}  # noqa: RUF012


@record
class PolarPoint:
    """One point of the curve in polar coordinates."""

    cam_angle: Annotated[Angle, "Angle the cam has turned when this point works [rad]."]
    polar_angle: Annotated[Angle, "Polar angle of the point in the cam's frame, from 0 to 360 degrees [rad]."]
    radius: Annotated[Size, "Distance of the point from the cam's axis [m]."]
    x: Annotated[Coordinate, "The point in the cam's frame [m]."]
    y: Annotated[Coordinate, "The same, upwards [m]."]


@record
class LiftPoint:
    """One point of a cam table for a controller, sliding follower."""

    cam_angle: Annotated[Angle, "Angle of the master [rad]."]
    lift: Annotated[Coordinate, "Lift [m]."]
    velocity: Annotated[CamVelocity, "Lift per angle [m/rad]."]
    acceleration: Annotated[CamAcceleration, "Lift per angle squared [m/rad^2]."]


@record
class SwingPoint:
    """One point of a cam table for a controller, arm."""

    cam_angle: Annotated[Angle, "Angle of the master [rad]."]
    swing: Annotated[Angle, "Angle of the arm from where it starts [rad]."]
    velocity: Annotated[Ratio, "Swing per angle."]
    acceleration: Annotated[Ratio, "Swing per angle squared, per radian."]


@record
class CamExport:
    """The pieces of the drawing and its deviation from the exact curve."""

    deviation: Annotated[Size, "Largest distance between drawing and exact curve, either way, as proved [m]."]
    pieces: Annotated[Count, "Arcs, cubics or lines of the closed curve."]
    tolerance: Annotated[Size, "What was asked for [m]."]
    shape: Annotated[Drawing, "The curve."]
    points: Annotated[Columns[PolarPoint], "The curve in polar coordinates, equally spaced in cam angle: exact points."]
    lifts: Annotated[Columns[LiftPoint] | None, "Table for a controller; for sliding followers."]
    swings: Annotated[Columns[SwingPoint] | None, "Table for a controller; for arms."]
    checks: tuple[Check, ...] = ()
    numerics: Numerics | None = None
