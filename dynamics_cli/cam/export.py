"""A cam as a drawing of arcs, cubics or lines with a proved deviation, and as tables for CNC and PLC."""

from dynamics_cli.cam.followers import Flank, Follower, Rotation, require_lift
from dynamics_cli.cam.program import Program, motion_of
from dynamics_cli.errors import require
from dynamics_cli.outlines import Drawing
from dynamics_cli.quantities import Angle, CamAcceleration, CamVelocity, Coordinate, Count, Ratio, Size, Text
from dynamics_cli.records import Check, Choice, Columns, Numerics, record

CCW = Rotation("counter-clockwise")
INNER = Flank("inner")


class Curve(Choice):
    """Which curve is drawn."""

    names = ("cam", "pitch", "cutter")


class Form(Choice):
    """What the curve is made of."""

    names = ("arcs", "cubics", "lines")
    aliases = {"splines": "cubics", "spline": "cubics", "polyline": "lines", "arc": "arcs"}  # noqa: RUF012


CAM = Curve("cam")
ARCS = Form("arcs")


@record
class PolarPoint:
    """One point of the curve in polar coordinates.

    Parameters
    ----------
    cam_angle : Angle
        Angle the cam has turned when this point works [rad].
    polar_angle : Angle
        Polar angle of the point in the cam's frame, from 0 to 360 degrees [rad].
    radius : Size
        Distance of the point from the cam's axis [m].
    x : Coordinate
        The point in the cam's frame [m].
    y : Coordinate
        The same, upwards [m].
    """

    cam_angle: Angle
    polar_angle: Angle
    radius: Size
    x: Coordinate
    y: Coordinate


@record
class LiftPoint:
    """One point of a cam table for a controller, sliding follower.

    Parameters
    ----------
    cam_angle : Angle
        Angle of the master [rad].
    lift : Coordinate
        Lift [m].
    velocity : CamVelocity
        Lift per angle [m/rad].
    acceleration : CamAcceleration
        Lift per angle squared [m/rad^2].
    """

    cam_angle: Angle
    lift: Coordinate
    velocity: CamVelocity
    acceleration: CamAcceleration


@record
class SwingPoint:
    """One point of a cam table for a controller, arm.

    Parameters
    ----------
    cam_angle : Angle
        Angle of the master [rad].
    swing : Angle
        Angle of the arm from where it starts [rad].
    velocity : Ratio
        Swing per angle.
    acceleration : Ratio
        Swing per angle squared, per radian.
    """

    cam_angle: Angle
    swing: Angle
    velocity: Ratio
    acceleration: Ratio


@record
class CamExport:
    """What the drawing is made of and how far it is from the exact curve.

    Parameters
    ----------
    deviation : Size
        Largest distance between drawing and exact curve, either way, as proved [m].
    pieces : Count
        Arcs, cubics or lines of the closed curve.
    tolerance : Size
        What was asked for [m].
    shape : Drawing
        The curve.
    points : Columns[PolarPoint]
        The curve in polar coordinates, equally spaced in cam angle: exact points.
    lifts : Columns[LiftPoint]
        Table for a controller; for sliding followers.
    swings : Columns[SwingPoint]
        Table for a controller; for arms.
    """

    deviation: Size
    pieces: Count
    tolerance: Size
    shape: Drawing
    points: Columns[PolarPoint]
    lifts: Columns[LiftPoint] | None
    swings: Columns[SwingPoint] | None
    checks: tuple[Check, ...] = ()
    numerics: Numerics | None = None


def export(
    scene: Program,
    /,
    *,
    program: Text = "",
    follower: Follower,
    rotation: Rotation = CCW,
    start_angle: Angle = 0.0,
    flank: Flank = INNER,
    curve: Curve = CAM,
    cutter_radius: Size | None = None,
    form: Form = ARCS,
    tolerance: Size = 1e-6,
    points: Count = 360,
) -> CamExport:
    """Cam, pitch or cutter curve as few arcs, cubics or lines within a tolerance that is proved.

    Equation
    --------
    Between nodes of the cam angle a distance w apart, paired with places of the piece Δt apart:
    |e| ≤ max(|e₀|, |e₁|) + w²/8 (max|z″| + max|b″| (Δt/w)²), e the error, z the curve, b the piece.

    Parameters
    ----------
    scene : Program
        The motion of the follower over one turn of the cam, from a file.
    program : Text
        The motion in one line, in place of a file.
    follower : Follower
        The follower and where it stands.
    rotation : Rotation
        Which way the cam turns.
    start_angle : Angle
        Angle by which the cam's drawing is turned on anticlockwise [rad].
    flank : Flank
        The inner surface, that of a disc cam, or the outer flank of a closed track.
    curve : Curve
        The cam itself, the path of the roller's centre, or the path of a cutter.
    cutter_radius : Size
        Radius of the cutter, for its path [m].
    form : Form
        Arcs (with bulges), cubics (splines) or lines.
    tolerance : Size
        Largest deviation allowed [m].
    points : Count
        Points of the tables.

    Returns
    -------
    CamExport
        The drawing with its proved deviation, and tables for CNC and PLC.

    Raises
    ------
    InadmissibleError
        When the curve is undercut, when the follower's velocity jumps, or when the tolerance is below rounding.

    Notes
    -----
    Pieces end at every joint of the laws; they touch the exact curve there with its direction, and the curve closes to
    the bit. max|z″| is enclosed on every cell from the laws' own constants, in disc arithmetic with all roundings
    inside (`cam.enclosures`, `numerics.discs`, `cam.proof`); nothing is inferred from samples. Errors of arcs fall with
    the third power of their number, of cubics with the sixth. `--drawing FILE.dxf`, `.svg` or `.csv` writes the curve;
    `.polar` a table of radii, `.st` a CODESYS cam, `.mc` points for TwinCAT.

    References
    ----------
    Bolton, Biarc curves, Computer-Aided Design 7 (1975); Moore, Kearfott & Cloud, Introduction to Interval Analysis
    (SIAM 2009); Rump, Fast and parallel interval arithmetic, BIT 39 (1999).

    Examples
    --------
    >>> from dynamics_cli.cam.followers import Roller
    >>> made = export(Program(), program="rise 10 mm in 180 deg cycloidal; return in 180 deg cycloidal",
    ...     follower=Roller(0.025, 0.006))
    >>> made.deviation <= 1e-6
    True
    """
    from dynamics_cli.cam.contact import Geometry
    from dynamics_cli.cam.drawing import drawn, tables

    require(points >= 2, "{0} points make no table", points, code="few-points")
    require(points <= 1_000_000, "{0} points are more than a table holds", points, code="many-points")
    require(
        curve != "cutter" or cutter_radius is not None,
        "the path of a cutter needs its radius",
        code="cutter",
        hint="--cutter-radius",
    )
    geometry = Geometry(follower, rotation, flank)
    motion = motion_of(scene, program)
    require_lift(motion, geometry.oscillating)
    away = {"cam": 0.0, "pitch": geometry.side * geometry.roller, "cutter": geometry.side * (cutter_radius or 0.0)}
    outline = drawn(geometry, motion, away[str(curve)], start_angle, str(form), tolerance, str(curve))
    polar, lifts, swings = tables(geometry, motion, away[str(curve)], start_angle, points)
    return CamExport(
        deviation=outline.deviation,
        pieces=sum(len(getattr(piece, "points", (0, 0))) - 1 for piece in outline.pieces),
        tolerance=tolerance,
        shape=Drawing((outline,), f"{curve} curve"),
        points=polar,
        lifts=lifts,
        swings=swings,
        checks=(
            Check("deviation is within the tolerance", outline.deviation <= tolerance, outline.deviation, tolerance),
            Check("the curve closes to the bit", outline.pieces[0].start == outline.pieces[-1].end, 0.0, 0.0),
        ),
        numerics=Numerics("curve and pieces paired on cells, accelerations of every law enclosed by disc arithmetic"),
    )
