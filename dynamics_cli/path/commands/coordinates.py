"""Tasks of a point on a circle, in systems of coordinates, in frames and beside another."""

from dynamics_cli.core.answering.task import Model, Task

RIGHT_HANDED = "right-handed axes; angles counter-clockwise about z from x"

CIRCLE = Task(
    "circle",
    "Speed and acceleration on a circle, now or after a time, an angle or an arc.",
    Model(
        "circular motion",
        "dynamics_cli.path.circle:circle",
        formula="{normal|a_n} = {speed|v}²/{radius|r}; {tangential|a_t} = {radius|r}·{angular_acceleration|α}; "
        "{acceleration|a} = √({tangential|a_t}² + {normal|a_n}²)",
        assumptions=("the angular acceleration is constant", "counter-clockwise is positive"),
    ),
    arrays=False,
    headline=(
        "speed",
        "angular_velocity: angular velocity ω",
        "tangential: tangential a_t",
        "normal: normal a_n",
        "acceleration: acceleration a",
        "inclination: from the inward radius",
        "time",
        "angle: angle turned",
        "turns",
        "arc",
    ),
    examples=(
        'dynamics path circle --radius "0.5 m" --angular-velocity "1500 rpm" --angular-acceleration "-20 rad/s^2"',
        'dynamics path circle --radius "80 m" --speed "15 m/s" --speed-rate "1.2 m/s^2" --arc "60 m"',
    ),
    plot="dynamics_cli.path.pictures:circle",
)

PARTS = (
    "speed",
    "radial_velocity: radial v_r",
    "transverse_velocity: transverse v_θ",
    "axial_velocity: axial v_z",
    "acceleration",
    "radial_acceleration: radial a_r",
    "transverse_acceleration: transverse a_θ",
    "axial_acceleration: axial a_z",
    "coriolis: Coriolis 2·ṙ·θ̇",
    "tangential: along the path a_t",
    "normal: across the path a_n",
    "radius_of_curvature: radius of curvature ρ",
)
POLAR = Task(
    "polar",
    "Velocity and acceleration in polar coordinates, term by term.",
    Model(
        "polar coordinates",
        "dynamics_cli.path.coordinates:polar",
        formula="{radial_acceleration|a_r} = {radial_speed_rate|r̈} − {radius|r}·{angular_velocity|θ̇}²; "
        "{transverse_acceleration|a_θ} = {radius|r}·{angular_acceleration|θ̈} + "
        "2·{radial_speed|ṙ}·{angular_velocity|θ̇}",
        assumptions=(RIGHT_HANDED,),
    ),
    arrays=False,
    headline=PARTS,
    examples=(
        'dynamics path polar --radius "0.3 m" --radial-speed "0.8 m/s" --angular-velocity "5 rad/s" '
        '--angular-acceleration "2 rad/s^2"',
    ),
    plot="dynamics_cli.path.pictures:around",
)

CYLINDRICAL = Task(
    "cylindrical",
    "Velocity and acceleration in cylindrical coordinates, term by term.",
    Model(
        "cylindrical coordinates",
        "dynamics_cli.path.coordinates:cylindrical",
        formula="{radial_acceleration|a_r} = {radial_speed_rate|r̈} − {radius|r}·{angular_velocity|θ̇}²; "
        "{transverse_acceleration|a_θ} = {radius|r}·{angular_acceleration|θ̈} + 2·{radial_speed|ṙ}·"
        "{angular_velocity|θ̇}; {axial_acceleration|a_z} = {axial_speed_rate|z̈}",
        assumptions=(RIGHT_HANDED,),
    ),
    arrays=False,
    headline=PARTS,
    examples=(
        'dynamics path cylindrical --radius "3 m" --angular-velocity "1 rad/s" --axial-speed "4 m/s"',
        'dynamics path cylindrical --radius "1.2 m" --angle "30 deg" --radial-speed "0.5 m/s" '
        '--angular-velocity "20 rpm" --axial-speed-rate "-2 m/s^2"',
    ),
    plot="dynamics_cli.path.pictures:around",
)

SPHERICAL = Task(
    "spherical",
    "Velocity and acceleration in spherical coordinates: φ from the Z-axis, θ the azimuth.",
    Model(
        "spherical coordinates",
        "dynamics_cli.path.coordinates:spherical",
        formula="{radial_acceleration|a_ρ} = ρ̈ − ρ·φ̇² − ρ·θ̇²·sin²φ; "
        "{polar_acceleration|a_φ} = ρ·φ̈ + 2·ρ̇·φ̇ − ρ·θ̇²·sin φ·cos φ; "
        "{azimuth_acceleration|a_θ} = (ρ·θ̈ + 2·ρ̇·θ̇)·sin φ + 2·ρ·φ̇·θ̇·cos φ",
        assumptions=(RIGHT_HANDED, "φ is measured from the Z-axis"),
    ),
    arrays=False,
    headline=(
        "speed",
        "radial_velocity: v_ρ",
        "polar_velocity: v_φ",
        "azimuth_velocity: v_θ",
        "acceleration",
        "radial_acceleration: a_ρ",
        "polar_acceleration: a_φ",
        "azimuth_acceleration: a_θ",
        "tangential: along the path a_t",
        "normal: across the path a_n",
        "radius_of_curvature: radius of curvature",
    ),
    examples=(
        'dynamics path spherical --radius "2 m" --polar-angle "50 deg" --azimuth "20 deg" --radial-speed "0.3 m/s" '
        '--polar-rate "0.4 rad/s" --azimuth-rate "-0.7 rad/s"',
    ),
    plot="dynamics_cli.path.pictures:in_space",
)

COMPONENTS = Task(
    "components",
    "Velocity and acceleration in every system of coordinates, and along and across the path.",
    Model(
        "components",
        "dynamics_cli.path.components:components",
        formula="{tangential|a_t} = v·a/{speed|v}; {normal|a_n} = ‖v×a‖/{speed|v}; "
        "{radius_of_curvature|ρ} = {speed|v}²/{normal|a_n}",
        assumptions=(RIGHT_HANDED, "T, N and B are the tangent, the normal and their cross product"),
    ),
    arrays=False,
    headline=(
        "speed",
        "acceleration_size: acceleration",
        "tangential: tangential a_t",
        "normal: normal a_n",
        "radius_of_curvature: radius of curvature ρ",
        "torsion: torsion τ",
        "tangent: direction T",
        "normal_direction: direction N",
        "centre: centre of curvature",
    ),
    examples=(
        'dynamics path components --velocity "20, 5, 0 m/s" --acceleration "-2, 3, 0 m/s^2"',
        'dynamics path components --position "3, 4, 1 m" --velocity "2, 1, 0.5 m/s" --acceleration "0, 3, 1 m/s^2" '
        '--jerk "1, 0, 2 m/s^3" --axes cylindrical',
    ),
    plot="dynamics_cli.path.pictures:in_space",
)

RELATIVE = Task(
    "relative",
    "Relative motion of two points or recorded tracks, and their closest approach.",
    Model(
        "two motions",
        "dynamics_cli.path.relative.task:relative",
        formula="{closest_time|t} = −Δr·Δv/‖Δv‖²; {closest_distance|d} = ‖Δr×Δv‖/‖Δv‖ (without relative acceleration)",
        assumptions=(
            "accelerations are constant, positions formulas of t, or smoothed tracks whose times count on one clock",
            "seen from the first point, in axes that do not turn",
        ),
    ),
    arrays=False,
    headline=(
        "closest_distance: closest approach",
        "closest_distance_noise: its noise",
        "closest_time: closest after",
        "closest_speed: relative speed there",
        "distance: distance at {shown_time}",
        "closing_speed: closing speed at {shown_time}",
    ),
    table="points",
    examples=(
        'dynamics path relative --first-velocity "15, 0, 0 m/s" --second-position "120, -80, 0 m" '
        '--second-velocity "0, 11, 0 m/s"',
        "dynamics path relative --first-track examples/near_miss/car.csv --second-track examples/near_miss/van.csv",
        'dynamics path relative --first-x "4*cos(0.5*t) m" --first-y "4*sin(0.5*t) m" --second-position "0, 9, 0 m" '
        '--second-velocity "0.8, -1, 0 m/s" --end "12 s"',
    ),
    plot="dynamics_cli.path.pictures:relative",
)

MOVING_FRAME = Task(
    "moving-frame",
    "A point in a moving, turning frame: the five terms of its acceleration, including Coriolis.",
    Model(
        "moving frame",
        "dynamics_cli.numerics.orientation.moving_frame:moving_frame",
        formula="{velocity|v} = {origin_velocity|v_O} + ω×r + {relative_velocity|v_rel}; "
        "{acceleration|a} = {origin_part|a_O} + {angular_part|α×r} + {centripetal|ω×(ω×r)} + {coriolis|2ω×v_rel} + "
        "{relative_part|a_rel}",
        assumptions=("all vectors are in the axes of the frame", "the orientation turns them into fixed ones"),
    ),
    headline=(
        "speed",
        "acceleration_size: acceleration",
        "velocity: velocity",
        "acceleration: acceleration, in the frame",
        "origin_part: of the origin a_O",
        "angular_part: α×r",
        "centripetal: centripetal ω×(ω×r)",
        "coriolis: Coriolis 2ω×v_rel",
        "relative_part: relative a_rel",
        "fixed_velocity: velocity, fixed axes",
        "fixed_acceleration: acceleration, fixed axes",
    ),
    examples=(
        'dynamics path moving-frame --position "0.3, 0, 0 m" --angular-velocity "0, 0, 5 rad/s" '
        '--angular-acceleration "0, 0, 2 rad/s^2" --relative-velocity "0.8, 0, 0 m/s"',
    ),
    plot="dynamics_cli.path.pictures:moving_frame",
)
