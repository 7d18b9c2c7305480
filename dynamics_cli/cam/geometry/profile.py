"""The profile of a radial cam: pitch curve, cam curve, cutter path, pressure angle, curvature, and the plate."""

from math import pi

from dynamics_cli.cam.geometry.followers import Flank, Follower, Rotation, require_lift
from dynamics_cli.cam.program.reading import Program, motion_of
from dynamics_cli.errors import require, worded
from dynamics_cli.quantities import Angle, Annotated, Area, Coordinate, Count, Density, Inertia, Mass, Size, Text
from dynamics_cli.records import Advice, Check, Columns, Numerics, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.cam.geometry.analysis import Analysis
    from dynamics_cli.cam.geometry.contact import Geometry, Touch
    from dynamics_cli.cam.geometry.undercut import Loss

CCW = Rotation("counter-clockwise")
INNER = Flank("inner")
# Beyond this the curve counts as straight: a document cannot hold infinity.
STRAIGHT = 1e12
MANY = 10_000_000
# Results about the plate, by the names that it has them too.
PLATE = ("area", "perimeter", "centroid_x", "centroid_y", "mass", "inertia", "inertia_about_centroid")


@record
class ProfilePoint:
    """One cam angle."""

    cam_angle: Annotated[Angle, "Angle the cam has turned [rad]."]
    x: Annotated[Coordinate, "Point of contact in the cam's frame [m]."]
    y: Annotated[Coordinate, "The same, upwards [m]."]
    radius: Annotated[Size, "Distance of that point from the cam's axis [m]."]
    polar_angle: Annotated[Angle, "Its polar angle in the cam's frame, between -180 and 180 degrees [rad]."]
    pitch_x: Annotated[
        Coordinate, "Centre of the roller in the cam's frame; the point of contact for other followers [m]."
    ]
    pitch_y: Annotated[Coordinate, "The same, upwards [m]."]
    cutter_x: Annotated[
        Coordinate, "Centre of the cutter in the cam's frame; the cam's curve without a cutter radius [m]."
    ]
    cutter_y: Annotated[Coordinate, "The same, upwards [m]."]
    pressure_angle: Annotated[
        Angle, "Angle from the follower's way to the common normal, positive in the sense in which the cam turns [rad]."
    ]
    radius_of_curvature: Annotated[
        Coordinate, "Radius of curvature of the cam, positive where it is convex; ±1e12 m stands for straight [m]."
    ]
    contact_x: Annotated[Coordinate, "Point of contact in the fixed frame, to the right [m]."]
    contact_y: Annotated[Coordinate, "The same, upwards [m]."]


@record
class CamProfile:
    """A cam's shape, its action on the follower, and its plate."""

    largest_pressure_angle: Annotated[Angle, "Largest positive pressure angle [rad]."]
    largest_pressure_angle_at: Annotated[Angle, "Cam angle there [rad]."]
    least_pressure_angle: Annotated[Angle, "Minimum pressure angle, usually in the return [rad]."]
    least_pressure_angle_at: Annotated[Angle, "Cam angle there [rad]."]
    least_convex_radius: Annotated[
        Coordinate | None,
        "Minimum radius of curvature of the cam where the pitch curve is convex; negative means undercut [m].",
    ]
    least_convex_radius_at: Annotated[Angle | None, "Cam angle there [rad]."]
    least_concave_radius: Annotated[
        Size | None, "Minimum radius of curvature of the cam where it is concave; absent if it is concave nowhere [m]."
    ]
    least_concave_radius_at: Annotated[Angle | None, "Cam angle there [rad]."]
    face_low: Annotated[
        Coordinate | None,
        "Lowest place of contact along a flat face, to the right of the slide or away from the pivot [m].",
    ]
    face_high: Annotated[Coordinate | None, "Highest place of contact along a flat face [m]."]
    face_width: Annotated[Size | None, "Length of the flat face that is touched, without margin [m]."]
    start_height: Annotated[
        Coordinate | None,
        "Height of the roller's centre or of the face above the cam's axis at zero lift, translating followers [m].",
    ]
    arm_start_angle: Annotated[Angle | None, "Angle of an arm from the line pivot–axis at zero lift [rad]."]
    smallest_radius: Annotated[Size, "Minimum distance of the table's points from the cam's axis [m]."]
    largest_radius: Annotated[Size, "Largest distance of the table's points from the cam's axis [m]."]
    area: Annotated[
        Area | None, "Area of the plate; of an undercut cam, of the piece that is left about its axis [m^2]."
    ]
    perimeter: Annotated[Size | None, "Length of its edge [m]."]
    centroid_x: Annotated[Coordinate | None, "Centroid of the area in the cam's frame [m]."]
    centroid_y: Annotated[Coordinate | None, "The same, upwards [m]."]
    mass: Annotated[Mass | None, "Mass of the plate; needs thickness and density [kg]."]
    inertia: Annotated[
        Inertia | None, "Moment of inertia of the plate about the cam's axis; needs thickness and density [kg*m^2]."
    ]
    inertia_about_centroid: Annotated[
        Inertia | None, "Moment of inertia of the plate about its centroid; needs thickness and density [kg*m^2]."
    ]
    points: Annotated[Columns[ProfilePoint], "The table."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def profile(
    scene: Annotated[Program, "One turn of the cam in segments, from a file."],
    /,
    *,
    program: Annotated[Text, "Segments in one line, in place of a file."] = "",
    follower: Annotated[Follower, "The follower and where it stands."],
    rotation: Annotated[Rotation, "Which way the cam turns."] = CCW,
    start_angle: Annotated[Angle, "Angle by which the cam's drawing is turned on anticlockwise [rad]."] = 0.0,
    flank: Annotated[Flank, "The inner surface, that of a disc cam, or the outer flank of a closed track."] = INNER,
    cutter_radius: Annotated[Size | None, "Radius of the cutter whose path is wanted, e.g. 10 mm [m]."] = None,
    points: Annotated[Count, "Points of the table, equally spaced in cam angle, the first at zero."] = 360,
    thickness: Annotated[Size | None, "Thickness of the plate, e.g. 10 mm [m]."] = None,
    density: Annotated[Density | None, "Density of the plate [kg/m^3]."] = None,
) -> CamProfile:
    """Shape of a radial cam: its exact envelope, pressure angle, curvature and plate.

    Equation
    --------
    p(θ) centre of the roller, u = p′ − ip, n = iu/|u|: cam = (p − R_r n)e^{−iθ}, κ_p = Im(ū(u′ − iu))/|u|³ (sign
    convex positive), ρ = 1/κ_p − R_r; flat face: (s′, R_b + s)e^{−iθ}, ρ = R_b + s + s″.

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
    extremes come from Chebyshev proxies of every piece of every law, so that none between the points of a table is
    missed. The table follows the whole envelope of an undercut cam; its plate ends where the envelope crosses
    itself, and `cam check` gives the lost lift.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 16.4 to 16.8.

    Examples
    --------
    >>> from dynamics_cli.cam.geometry.followers import FlatFace
    >>> from dynamics_cli.cam.program.reading import program_of
    >>> plate = profile(program_of("rise 10 mm in 180 deg 3-4-5; return in 180 deg 3-4-5"),
    ...     follower=FlatFace(base_radius=0.1))
    >>> round(plate.perimeter, 9) == round(2 * pi * 0.105, 9)
    True
    """
    import numpy as np

    from dynamics_cli.cam.geometry.analysis import analyse, extreme_bounds, extreme_results, runs_forward
    from dynamics_cli.cam.geometry.contact import Geometry
    from dynamics_cli.cam.geometry.plate import weighed
    from dynamics_cli.cam.geometry.undercut import lift_lost
    from dynamics_cli.cam.program.pieces import joint_jumps, sample

    require(
        4 <= points <= MANY,
        "points: {count}; a curve has 4 to {most}",
        count=points, most=MANY, code="few-points" if points < 4 else "many-points",
    )  # fmt: skip
    require(
        (thickness is None) == (density is None),
        "a plate's mass needs both its thickness and its density",
        code="plate",
        hint="give both, or neither",
    )
    geometry = Geometry(follower, rotation, flank)
    motion = motion_of(scene, program)
    require_lift(motion, geometry.oscillating)
    analysis = analyse(geometry, motion)
    loss = lift_lost(geometry, motion, forward=runs_forward(geometry, analysis))
    body = weighed(geometry, motion, start_angle, loss, thickness, density)
    theta = np.arange(points) * (2.0 * pi / points)
    s, s1, s2 = sample(motion, theta, 2)
    touch = geometry.touch(s, s1, s2)
    columns = table(geometry, touch, theta, start_angle, cutter_radius or 0.0)
    along = analysis.along
    return CamProfile(
        **extreme_results(geometry, analysis),
        face_low=None if along is None else along.least,
        face_high=None if along is None else along.greatest,
        face_width=analysis.face_width,
        start_height=None if geometry.oscillating else geometry.start,
        arm_start_angle=geometry.start if geometry.oscillating else None,
        smallest_radius=float(columns.arrays["radius"].min()),
        largest_radius=float(columns.arrays["radius"].max()),
        **{name: getattr(body, name) for name in PLATE},
        points=columns,
        checks=_checks(touch),
        advice=(*_advice(geometry, analysis, loss, joint_jumps(motion)[0]), *body.advice),
        numerics=Numerics(
            "exact envelope; extremes from Chebyshev interpolants; Gauss quadrature on pieces halved until it settles",
            (*body.bounds, *extreme_bounds(geometry, analysis)),
        ),
    )


def table(geometry: "Geometry", touch: "Touch", theta: "Any", start_angle: float, cutter: float) -> "Any":
    """The columns of a profile at some cam angles."""
    import numpy as np

    from dynamics_cli.cam.geometry.contact import turned_back

    # a point and its offset along the normal are rotated by the same sine and cosine
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


def _checks(touch: "Touch") -> tuple[Check, ...]:
    """Check that normals are of unit length, within rounding."""
    import numpy as np

    (nx, ny), size = touch.normal, 8e-16
    worst = float(np.max(np.abs(nx * nx + ny * ny - 1.0)))
    return (Check("normals are of unit length", worst <= size, worst, size),)


def _advice(geometry: "Geometry", analysis: "Analysis", loss: "Loss | None", jumps: int) -> tuple[Advice, ...]:
    advice: list[Advice] = []
    if jumps:
        advice.append(
            Advice(
                "velocity-jump",
                f"the follower's velocity jumps at {jumps} joints: the curve breaks there, and the force is infinite",
                "serious",
                "choose laws whose velocities join, for example 3-4-5 or cycloidal in place of linear",
            )
        )
    if loss is not None:
        from dynamics_cli.cam.geometry.analysis import convex

        least, _ = convex(geometry, analysis)
        message = "the cam is undercut: its curve cuts itself"
        if least is not None and geometry.side > 0.0 and least <= 0.0:
            message = worded(
                "the cam is undercut: its minimum radius of curvature is {least:6}, and its curve cuts itself",
                least=(least, Coordinate),
            )
        remedy = "raise the base radius; `dynamics cam check` gives the lift that is lost"
        advice.append(Advice("undercut", message, "serious", remedy))
    return tuple(advice)
