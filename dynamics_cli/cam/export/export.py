"""A cam as a drawing of arcs, cubics or lines with a proved deviation, and as tables for CNC and PLC."""

from dynamics_cli.cam.export.records import CamExport, Curve, Form
from dynamics_cli.cam.geometry.followers import Flank, Follower, Rotation, require_lift
from dynamics_cli.cam.program.reading import Program, motion_of
from dynamics_cli.errors import require, require_given
from dynamics_cli.outlines import Drawing
from dynamics_cli.quantities import Angle, Annotated, Count, Size, Text
from dynamics_cli.records import Check, Numerics
from dynamics_cli.sampling import drawing

CCW = Rotation("counter-clockwise")
INNER = Flank("inner")


CAM = Curve("cam")
ARCS = Form("arcs")


def export(
    scene: Annotated[Program, "One turn of the cam in segments, from a file."],
    /,
    *,
    program: Annotated[Text, "Segments in one line, in place of a file."] = "",
    follower: Annotated[Follower, "The follower and where it stands."],
    rotation: Annotated[Rotation, "Sense of rotation of the cam."] = CCW,
    start_angle: Annotated[Angle, "Angle by which the cam's drawing is turned on anticlockwise [rad]."] = 0.0,
    flank: Annotated[Flank, "The inner surface, that of a disc cam, or the outer flank of a closed track."] = INNER,
    curve: Annotated[Curve, "The cam itself, the path of the roller's centre, or the path of a cutter."] = CAM,
    cutter_radius: Annotated[Size | None, "Radius of the cutter, for its path, e.g. 10 mm [m]."] = None,
    form: Annotated[Form, "Arcs (with bulges), cubics (splines) or lines."] = ARCS,
    tolerance: Annotated[Size, "Largest deviation allowed [m]."] = 1e-6,
    points: Annotated[Count, "Points of the tables."] = 360,
) -> CamExport:
    """Cam, pitch or cutter curve in few arcs, cubics or lines within a proved tolerance.

    Equation
    --------
    Between nodes of the cam angle a distance w apart, paired with parameters of the piece Δt apart:
    |e| ≤ max(|e₀|, |e₁|) + w²/8 (max|z″| + max|b″| (Δt/w)²), e the error, z the curve, b the piece.

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
    the bit. max|z″| is enclosed on every cell from the laws' own constants, in disc arithmetic including all
    roundings (`numerics.discs`); nothing is inferred from samples. Errors of arcs fall with the third
    power of their number, of cubics with the sixth. `--drawing FILE.dxf`, `.svg` or `.csv` writes the curve; `.polar` a
    table of radii, `.st` a CODESYS cam, `.mc` points for TwinCAT.

    References
    ----------
    Bolton, Biarc curves, Computer-Aided Design 7 (1975); Moore, Kearfott & Cloud, Introduction to Interval Analysis
    (SIAM 2009); Rump, Fast and parallel interval arithmetic, BIT 39 (1999).

    Examples
    --------
    >>> from dynamics_cli.cam.geometry.followers import Roller
    >>> result = export(Program(), program="rise 10 mm in 180 deg cycloidal; return in 180 deg cycloidal",
    ...     follower=Roller(0.025, 0.006))
    >>> result.deviation <= 1e-6
    True
    """
    from dynamics_cli.cam.export.drawing import drawn, tables
    from dynamics_cli.cam.geometry.contact import Geometry

    require(points >= 2, "points: {count}; a table has at least 2", count=points, code="few-points")
    require(points <= 1_000_000, "points: {count}; a table has at most 1000000", count=points, code="many-points")
    require_given(
        curve != "cutter" or cutter_radius is not None,
        "the path of a cutter needs its radius",
        ("cutter_radius",),
        code="cutter",
    )
    geometry = Geometry(follower, rotation, flank)
    motion = motion_of(scene, program)
    require_lift(motion, geometry.oscillating)
    away = {"cam": 0.0, "pitch": geometry.side * geometry.roller, "cutter": geometry.side * (cutter_radius or 0.0)}
    if drawing():  # a sample has no curve of its own
        return CamExport(tolerance, 0, tolerance, None, (), None, None)  # type: ignore[arg-type]
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
