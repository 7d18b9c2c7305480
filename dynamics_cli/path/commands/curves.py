"""Tasks of straight motion, of curves and of measured tracks."""

from dynamics_cli.core.answering.task import Model, Task

RECTILINEAR = Task(
    "rectilinear",
    "Straight motion: any three of two speeds, acceleration, distance and time; or a law of the acceleration.",
    Model(
        "constant acceleration",
        "dynamics_cli.path.straight.task:rectilinear",
        formula="{end_speed|v} = {start_speed|u} + {acceleration|a}·{time|t}; "
        "{distance|s} = {time|t}·({start_speed|u} + {end_speed|v})/2",
        assumptions=("a straight line", "constant acceleration in each phase"),
        suffices="dynamics_cli.path.straight.task:constant_suffices",
    ),
    Model(
        "law of acceleration",
        "dynamics_cli.path.straight.task:rectilinear_law",
        formula="d{end_speed|v}/dt = a(t, x, v); d{distance|x}/dt = {end_speed|v}",
        assumptions=("a straight line", "t, x and v in the law are in s, m and m/s, counted from time and place zero"),
        method="Taylor series",
    ),
    arrays=False,
    headline=(
        "time",
        "distance",
        "start_speed",
        "end_speed",
        "acceleration",
        "stop_time: comes to rest after",
        "stop_distance: comes to rest at",
        "motion",
    ),
    table="motion",
    scene={"phases[0].start_speed": "20 m/s", "phases[0].acceleration": "-4 m/s^2", "phases[0].distance": "48 m"},
    examples=(
        'dynamics path rectilinear --start-speed "20 m/s" --acceleration "-4 m/s^2" --distance "48 m"',
        'dynamics path rectilinear --law "9.80665 - 0.004*v^2 m/s^2" --start-speed "0 m/s" --time "3 s"',
        'dynamics path rectilinear --phase "start_speed=0 m/s, end_speed=20 m/s, acceleration=1.2 m/s^2" '
        '--phase "acceleration=0 m/s^2, time=40 s" --phase "end_speed=0 m/s, acceleration=-0.9 m/s^2"',
    ),
    plot="dynamics_cli.path.pictures:rectilinear",
    notes="A law is a formula of t, x and v in s, m and m/s: -0.05*v, 3 - t^2, -40*x, with + - * / ^, sin, sqrt, …",
)

CURVE = Task(
    "curve",
    "Motion along formulas x(t), y(t), z(t) or a named curve: v, a, curvature, torsion, arc length, cusps.",
    Model(
        "Taylor jets",
        "dynamics_cli.path.curves.task:curve",
        formula="{tangential|a_t} = v·a/‖v‖; {normal|a_n} = ‖v×a‖/‖v‖; {curvature|κ} = ‖v×a‖/‖v‖³; "
        "{torsion|τ} = (v×a)·(da/dt)/‖v×a‖²",
        assumptions=("formulas are in s, m and rad", "derivatives are exact, not differences"),
        method="Taylor jets (exact derivatives)",
    ),
    arrays=False,
    headline=(
        "time",
        "position",
        "velocity",
        "acceleration",
        "speed",
        "radius: distance r",
        "angle: angle θ",
        "radial_velocity: radial v_r",
        "transverse_velocity: transverse v_θ",
        "radial_acceleration: radial a_r",
        "transverse_acceleration: transverse a_θ",
        "coriolis: Coriolis 2·ṙ·θ̇",
        "tangential: tangential a_t",
        "normal: normal a_n",
        "radius_of_curvature: radius of curvature ρ",
        "torsion: torsion τ",
        "arc_length: length of the path",
        "events: events | event, time, speed, curvature",
    ),
    table="points",
    examples=(
        'dynamics path curve --x "t^2 m" --y "sin(3*t) m" --z "exp(-t) m" --end "0.8 s"',
        'dynamics path curve --curve cycloid --radius "0.3 m" --angle-law "20*t rad" --end "0.35 s"',
        'dynamics path curve --x "a*cos(w*t) m" --y "b*sin(w*t) m" --let "a=3 m, b=2 m, w=90 deg/s" --end "4 s" '
        '--at "0.5 s"',
        'dynamics path curve --radius-law "0.2 + 0.1*t^2 m" --angle-law "3*t rad" --at "1 s"',
    ),
    plot="dynamics_cli.path.pictures:curve",
    notes="Formulas have numbers, t, pi, + - * / ^, brackets, sin cos tan asin acos atan sinh cosh tanh exp log sqrt "
    "abs, the variables of --let, and the unit last.",
)

TABLE = Task(
    "table",
    "Speed, acceleration and curvature of a measured track (CSV), with the noise of each.",
    Model(
        "smoothing spline",
        "dynamics_cli.path.tracks.task:table",
        source="Craven & Wahba, Numer. Math. 31 (1979); Wahba, J. R. Statist. Soc. B 45 (1983)",
        formula="minimum of Σ(y − f)² + λ·∫f‴²dt over quintic splines f",
        assumptions=(
            "every coordinate has the same, independent noise",
            "noise is one standard deviation, including what smoothing removes",
        ),
        method="quintic smoothing spline",
    ),
    arrays=False,
    tracked=False,
    headline=(
        "top_speed",
        "top_speed_time: reached at",
        "hardest_braking",
        "hardest_braking_time: at",
        "strongest_lateral: strongest lateral",
        "strongest_lateral_time: at",
        "speed_noise: noise of the speed",
        "acceleration_noise: noise of accelerations",
        "position_noise: noise of positions",
        "resolution: shortest event resolved",
        "chosen_by: smoothing chosen by",
        "points: points | time, speed, tangential, normal, acceleration_noise=noise, curvature",
    ),
    table="points",
    examples=(
        "dynamics path table examples/gps_track/track.csv",
        'dynamics path table examples/gps_track/track.csv --sigma "3 cm" --table points --format csv',
    ),
    plot="dynamics_cli.path.pictures:table",
)
