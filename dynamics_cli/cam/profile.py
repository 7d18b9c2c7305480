"""The profile of a radial cam: pitch curve, cam curve, cutter path, pressure angle, curvature, and the plate."""

from math import hypot, inf, pi

from dynamics_cli.cam.followers import Flank, Follower, Rotation, require_lift
from dynamics_cli.cam.program import Program, motion_of
from dynamics_cli.errors import require
from dynamics_cli.quantities import Angle, Area, Coordinate, Count, Density, Inertia, Mass, Size, Text
from dynamics_cli.records import Advice, Check, Columns, ErrorBound, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.cam.analysis import Analysis, Plate
    from dynamics_cli.cam.contact import Geometry, Touch

CCW = Rotation("counter-clockwise")
INNER = Flank("inner")
# Beyond this the curve is straight for every purpose, and a document holds no infinity.
STRAIGHT = 1e12
MANY = 10_000_000
UNIT = 2.0**-53


@record
class ProfilePoint:
    """One cam angle.

    Parameters
    ----------
    cam_angle : Angle
        Angle the cam has turned [rad].
    x : Coordinate
        Point of contact in the cam's frame [m].
    y : Coordinate
        The same, upwards [m].
    radius : Size
        Distance of that point from the cam's axis [m].
    polar_angle : Angle
        Its polar angle in the cam's frame, between -180 and 180 degrees [rad].
    pitch_x : Coordinate
        Centre of the roller in the cam's frame; the point of contact for other followers [m].
    pitch_y : Coordinate
        The same, upwards [m].
    cutter_x : Coordinate
        Centre of the cutter in the cam's frame; the cam's curve without a cutter radius [m].
    cutter_y : Coordinate
        The same, upwards [m].
    pressure_angle : Angle
        Angle from the follower's way to the common normal, positive in the sense in which the cam turns [rad].
    radius_of_curvature : Coordinate
        Radius of curvature of the cam, positive where it is convex; ±1e12 m stands for straight [m].
    contact_x : Coordinate
        Point of contact in the fixed frame, to the right [m].
    contact_y : Coordinate
        The same, upwards [m].
    """

    cam_angle: Angle
    x: Coordinate
    y: Coordinate
    radius: Size
    polar_angle: Angle
    pitch_x: Coordinate
    pitch_y: Coordinate
    cutter_x: Coordinate
    cutter_y: Coordinate
    pressure_angle: Angle
    radius_of_curvature: Coordinate
    contact_x: Coordinate
    contact_y: Coordinate


@record
class CamProfile:
    """A cam's shape, what it does to its follower, and its plate.

    Parameters
    ----------
    largest_pressure_angle : Angle
        Largest positive pressure angle [rad].
    largest_pressure_angle_at : Angle
        Cam angle there [rad].
    least_pressure_angle : Angle
        Lowest pressure angle, usually that of the return [rad].
    least_pressure_angle_at : Angle
        Cam angle there [rad].
    least_convex_radius : Coordinate
        Least radius of curvature of the cam where the pitch curve is convex; negative means undercut [m].
    least_convex_radius_at : Angle
        Cam angle there [rad].
    least_concave_radius : Size
        Least radius of curvature of the cam where it is concave; left out where it is nowhere [m].
    least_concave_radius_at : Angle
        Cam angle there [rad].
    face_low : Coordinate
        Lowest place of contact along a flat face, to the right of the slide or away from the pivot [m].
    face_high : Coordinate
        Highest place of contact along a flat face [m].
    face_width : Size
        Length of the flat face that is touched, without margin [m].
    start_height : Size
        Height of the roller's centre or of the face above the cam's axis at zero lift, translating followers [m].
    arm_start_angle : Angle
        Angle of an arm from the line pivot–axis at zero lift [rad].
    smallest_radius : Size
        Least distance of the table's points from the cam's axis [m].
    largest_radius : Size
        Largest distance of the table's points from the cam's axis [m].
    area : Area
        Area that the curve encloses [m^2].
    perimeter : Size
        Length of the curve [m].
    centroid_x : Coordinate
        Centroid of the area in the cam's frame [m].
    centroid_y : Coordinate
        The same, upwards [m].
    mass : Mass
        Mass of the plate; needs thickness and density [kg].
    inertia : Inertia
        Moment of inertia of the plate about the cam's axis; needs thickness and density [kg*m^2].
    inertia_about_centroid : Inertia
        Moment of inertia of the plate about its centroid; needs thickness and density [kg*m^2].
    points : Columns[ProfilePoint]
        The table.
    """

    largest_pressure_angle: Angle
    largest_pressure_angle_at: Angle
    least_pressure_angle: Angle
    least_pressure_angle_at: Angle
    least_convex_radius: Coordinate | None
    least_convex_radius_at: Angle | None
    least_concave_radius: Size | None
    least_concave_radius_at: Angle | None
    face_low: Coordinate | None
    face_high: Coordinate | None
    face_width: Size | None
    start_height: Coordinate | None
    arm_start_angle: Angle | None
    smallest_radius: Size
    largest_radius: Size
    area: Area
    perimeter: Size
    centroid_x: Coordinate
    centroid_y: Coordinate
    mass: Mass | None
    inertia: Inertia | None
    inertia_about_centroid: Inertia | None
    points: Columns[ProfilePoint]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def profile(
    scene: Program,
    /,
    *,
    program: Text = "",
    follower: Follower,
    rotation: Rotation = CCW,
    start_angle: Angle = 0.0,
    flank: Flank = INNER,
    cutter_radius: Size | None = None,
    points: Count = 360,
    thickness: Size | None = None,
    density: Density | None = None,
) -> CamProfile:
    """Shape of a radial cam: its exact envelope, pressure angle, curvature and plate.

    Equation
    --------
    p(θ) centre of the roller, u = p′ − ip, n = iu/|u|: cam = (p − R_r n)e^{−iθ}, κ_p = Im(ū(u′ − iu))/|u|³ (sign
    convex positive), ρ = 1/κ_p − R_r; flat face: (s′, R_b + s)e^{−iθ}, ρ = R_b + s + s″.

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
    cutter_radius : Size
        Radius of the cutter whose path is wanted [m].
    points : Count
        Points of the table, equally spaced in cam angle, the first at zero.
    thickness : Size
        Thickness of the plate [m].
    density : Density
        Density of the plate [kg/m^3].

    Returns
    -------
    CamProfile
        Extremes with their places, the plate's area, perimeter, centroid and inertia, and the table.

    Raises
    ------
    InadmissibleError
        When the follower cannot stand on its base circle, when the roller's centre passes through the cam's axis, or
        when a flat rocker would have to turn as fast as the cam.

    Notes
    -----
    Radial cams only: barrel (cylindrical) cams are out of scope. Points are the exact envelope, not the radius R_b + s
    of knife-edge textbooks. Errors are a few roundings of the size: the square root of an offset is factored, and
    extremes come from Chebyshev proxies of every piece of every law, none missed between the points of a table. The
    area counts loops of an undercut curve twice; `cam check` says what an undercut costs.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 16.4 to 16.8.

    Examples
    --------
    >>> from dynamics_cli.cam.followers import FlatFace
    >>> from dynamics_cli.cam.program import program_of
    >>> plate = profile(program_of("rise 10 mm in 180 deg 3-4-5; return in 180 deg 3-4-5"),
    ...     follower=FlatFace(base_radius=0.1))
    >>> round(plate.perimeter, 9) == round(2 * pi * 0.105, 9)
    True
    """
    import numpy as np

    from dynamics_cli.cam.analysis import analyse, plate, pressure_bounds, runs_forward
    from dynamics_cli.cam.contact import Geometry
    from dynamics_cli.cam.pieces import joint_jumps, sample

    require(points >= 4, "{0} points make no curve", points, code="few-points", hint="at least 4")
    require(points <= MANY, "{0} points are more than a document holds", points, code="many-points")
    require(
        (thickness is None) == (density is None),
        "a plate's mass needs both its thickness and its density",
        code="plate",
        hint="give both, or neither",
    )
    geometry = Geometry(follower, rotation, flank)
    motion = motion_of(scene, program)
    require_lift(motion, geometry.oscillating)
    found = analyse(geometry, motion)
    body = plate(geometry, motion, start_angle)
    theta = np.arange(points) * (2.0 * pi / points)
    s, s1, s2 = sample(motion, theta, 2)
    touch = geometry.touch(s, s1, s2)
    columns = table(geometry, touch, theta, start_angle, cutter_radius or 0.0)
    weight = None if thickness is None or density is None else thickness * density
    away = body.x * body.x + body.y * body.y
    face = None if found.along is None else (found.along.smallest()[0], found.along.largest()[0])
    return CamProfile(
        *found.pressure.largest(),
        *found.pressure.smallest(),
        *convex(geometry, found),
        *concave(geometry, found),
        face_low=None if face is None else face[0],
        face_high=None if face is None else face[1],
        face_width=None if face is None else face[1] - face[0],
        start_height=None if geometry.oscillating else geometry.start,
        arm_start_angle=geometry.start if geometry.oscillating else None,
        smallest_radius=float(columns.arrays["radius"].min()),
        largest_radius=float(columns.arrays["radius"].max()),
        area=body.area,
        perimeter=body.perimeter,
        centroid_x=_settled(body.x, body.perimeter),
        centroid_y=_settled(body.y, body.perimeter),
        mass=None if weight is None else weight * body.area,
        inertia=None if weight is None else weight * body.polar,
        inertia_about_centroid=None if weight is None else weight * (body.polar - body.area * away),
        points=columns,
        checks=_checks(geometry, touch),
        advice=_advice(geometry, found, joint_jumps(motion)[0]),
        numerics=Numerics(
            "exact envelope; certified extremes; Gauss quadrature on pieces halved until it stands",
            (
                *_plate_bounds(body, runs_forward(geometry, found), weight),
                *pressure_bounds(found),
                *radius_bounds(geometry, found),
            ),
        ),
    )


def _plate_bounds(body: "Plate", forward: bool, weight: "float | None") -> tuple[ErrorBound, ...]:
    """Bounds of the quadrature; where the curve turns back, its length has kinks that Gauss's rule does not see."""
    made = [ErrorBound("area", body.area_error)]
    if forward:
        made.append(ErrorBound("perimeter", body.perimeter_error))
    off = body.centroid_error
    made += [ErrorBound(name, off, relative=False) for name in ("centroid_x", "centroid_y")]
    if weight is not None:
        away = hypot(body.x, body.y)
        about = body.polar_error * body.polar + abs(body.area) * away * (away * body.area_error + 3.0 * off)
        made.append(ErrorBound("mass", body.area_error + UNIT))
        made.append(ErrorBound("inertia", body.polar_error + UNIT))
        made.append(ErrorBound("inertia_about_centroid", weight * (about + 4.0 * UNIT * body.polar), relative=False))
    return tuple(made)


def table(geometry: "Geometry", touch: "Touch", theta: "Any", start_angle: float, cutter: float) -> "Any":
    """The columns of a profile at some cam angles."""
    import numpy as np

    from dynamics_cli.cam.contact import turned_back

    # a point and what lies along the normal are turned by the same sine and cosine
    cos, sin = turned_back(theta.size, start_angle, geometry.turn)
    (cx, cy), (nx, ny) = touch.point, touch.normal
    # minus zero is zero
    x, y = cx * cos + cy * sin + 0.0, cy * cos - cx * sin + 0.0
    mx, my = nx * cos + ny * sin, ny * cos - nx * sin
    reach, tool = geometry.side * geometry.roller, geometry.side * cutter
    with np.errstate(divide="ignore"):
        radius = 1.0 / touch.curvature - reach if touch.radius is None else touch.radius
    return Columns(
        ProfilePoint,
        cam_angle=theta,
        x=x,
        y=y,
        radius=np.sqrt(x * x + y * y),
        polar_angle=np.arctan2(y, x),
        pitch_x=x + reach * mx,
        pitch_y=y + reach * my,
        cutter_x=x + tool * mx,
        cutter_y=y + tool * my,
        pressure_angle=np.broadcast_to(touch.pressure_angle, theta.shape),
        radius_of_curvature=np.clip(radius, -STRAIGHT, STRAIGHT),
        contact_x=np.broadcast_to(cx, theta.shape),
        contact_y=np.broadcast_to(cy, theta.shape),
    )


def _settled(value: float, size: float) -> float:
    """Zero where a centroid is less than its own rounding."""
    return value if abs(value) > 1e-15 * size else 0.0


def convex(geometry: "Geometry", found: "Analysis") -> "tuple[float | None, float | None]":
    """Least radius of curvature of the cam where the pitch curve is convex, and where."""
    if geometry.flat:
        return found.curvature.smallest()
    value, place = found.curvature.largest()
    return (1.0 / value - geometry.side * geometry.roller, place) if value > 0.0 else (None, None)


def concave(geometry: "Geometry", found: "Analysis") -> "tuple[float | None, float | None]":
    """Least radius of curvature of the cam where the pitch curve is concave, and where."""
    if geometry.flat:
        return None, None
    value, place = found.curvature.smallest()
    return (geometry.side * geometry.roller - 1.0 / value, place) if value < -1e-12 else (None, None)


def radius_bounds(geometry: "Geometry", found: "Analysis") -> tuple[ErrorBound, ...]:
    """Proved bounds of the least radii of curvature: what 1/κ is off where κ is, and two roundings."""
    bend = found.curvature
    made = []
    for name, radius, value, error in (
        ("least_convex_radius", convex(geometry, found)[0], bend.greatest, bend.greatest_error),
        ("least_concave_radius", concave(geometry, found)[0], bend.least, bend.least_error),
    ):
        if radius is None:
            continue
        off = bend.least_error
        if not geometry.flat:
            left = abs(value) - error
            off = error / (abs(value) * left) + 2.0 * UNIT / abs(value) if left > 0.0 else inf
        if off < inf:
            made.append(ErrorBound(name, (off + UNIT * abs(radius)) * (1.0 + 2.0**-40), relative=False))
    return tuple(made)


def _checks(geometry: "Geometry", touch: "Touch") -> tuple[Check, ...]:
    """The roller's centre is where the slide or the arm has it, to rounding."""
    import numpy as np

    (nx, ny), size = touch.normal, 8e-16
    worst = float(np.max(np.abs(nx * nx + ny * ny - 1.0)))
    return (Check("normals are of unit length", worst <= size, worst, size),)


def _advice(geometry: "Geometry", found: "Analysis", jumps: int) -> tuple[Advice, ...]:
    least, _ = convex(geometry, found)
    advice: list[Advice] = []
    if jumps:
        advice.append(
            Advice(
                "velocity-jump",
                f"the follower's velocity jumps at {jumps} joints: the curve breaks there, and the force is infinite",
                "serious",
                "choose laws whose velocities join, e.g. 3-4-5 or cycloidal in place of linear",
            )
        )
    if least is not None and geometry.side > 0.0 and least <= 0.0:
        advice.append(
            Advice(
                "undercut",
                f"the cam is undercut: its least radius of curvature comes to {least:.6g} m, and the curve cuts itself",
                "serious",
                "raise the base radius, or see `cam check` for the lift that is lost",
            )
        )
    return tuple(advice)
