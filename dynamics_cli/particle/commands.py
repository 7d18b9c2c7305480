"""The tasks of `dynamics particle`."""

from dynamics_cli.core.answering.task import Family, Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
PICTURES = "dynamics_cli.particle.pictures"
FLAT = "flat ground, gravity the same everywhere"

PROJECTILE = Task(
    "projectile",
    "Flight of a projectile: range, target, best angle, with drag and wind.",
    Model(
        "parabola",
        "dynamics_cli.particle.projectile:projectile",
        source=BOOK + "section 8.7",
        formula="t = (v_y + √(v_y² + 2·{gravity|g}·{height|h}))/{gravity|g}",
        assumptions=("no drag", FLAT),
        suffices="dynamics_cli.particle.projectile:no_drag",
    ),
    Model(
        "linear drag",
        "dynamics_cli.particle.projectile:with_drag",
        source=BOOK + "section 8.7",
        formula="x = v_x·τ·(1 − e^(−t/τ)), y = v_y·τ·(1 − e^(−t/τ)) − {gravity|g}·τ²·(t/τ − 1 + e^(−t/τ))",
        assumptions=("drag in proportion to the speed through the air", "a steady wind along the ground", FLAT),
        suffices="dynamics_cli.particle.projectile:linear_drag",
    ),
    Model(
        "quadratic drag",
        "dynamics_cli.particle.projectile:with_drag",
        source=BOOK + "section 8.7; Bernoulli's hodograph (1719)",
        formula="1/v_x² = 1/v_x0² + (G(p₀) − G(p))/v_t², G(p) = p·√(1 + p²) + arsinh p",
        assumptions=(
            "drag by the square of the speed through the air, its coefficient the same all the way",
            "air of one density, a steady wind along the ground", FLAT,
        ),
        method="quadrature of the hodograph",
    ),
    headline=(
        "launch_speed: launch speed", "elevation: launch angle", "other_elevation: or, steeper", "range", "time",
        "apex_height: greatest height",
        "impact_speed: arrives with", "impact_angle: falling at", "best_elevation: best angle",
        "greatest_range: its range",
        "least_speed: least speed to the target", "path: path | time, distance, height, speed",
    ),
    examples=(
        'dynamics particle projectile --speed "30 m/s" --elevation "45 deg" --height "2 m"',
        'dynamics particle projectile --speed "30 m/s" --target "80, 5 m"',
        'dynamics particle projectile --elevation "40 deg" --target "80, 5 m"',
        'dynamics particle projectile --speed "95 mph" --elevation "32 deg" --height "3 ft" --mass "5.1 oz" '
        '--area "6.6 in^2" --drag-coefficient 0.35 --wind "-8 mph" --units us',
    ),
    table="path",
    plot=f"{PICTURES}:projectile",
    arrays=False,
)  # fmt: skip

FALL = Task(
    "fall",
    "A fall from rest, with drag and the deflection by the turning earth.",
    Model(
        "fall",
        "dynamics_cli.particle.fall:fall",
        source=BOOK + "section 10.7",
        formula=(
            "{speed|v} = v_t·√(1 − e^(−2·{gravity|g}·{height|h}/{terminal_speed|v_t}²))",
            "{speed|v} = √(2·{gravity|g}·{height|h})",
        ),
        assumptions=("a fall from rest", "drag by the square of the speed where a terminal speed is given",
                     "the deflection is that without drag, to first order in the earth's rate"),
    ),
    headline=(
        "time", "speed", "vacuum_time: time without drag", "vacuum_speed: speed without drag",
        "steady_share: of the terminal speed", "deflection: deflection to the east",
    ),
    examples=(
        'dynamics particle fall --height "100 m" --latitude "45 deg"',
        'dynamics particle fall --height "1500 ft" --terminal-speed "120 mph" --units us',
    ),
    arrays=False,
)  # fmt: skip

TUBE = Task(
    "tube",
    "A particle in a straight tube that turns, with or without a spring.",
    Model(
        "turning tube",
        "dynamics_cli.particle.tube:tube",
        source=BOOK + "sections 8.5 and 11.7",
        formula="r̈ + (k/{mass|m} − {rotation|Ω}²)·r = k·ℓ₀/{mass|m} − g·sin {rotation|Ω}t",
        assumptions=("a smooth tube that turns at a constant rate",
        "gravity acts along the tube in the vertical plane only"),
    ),
    headline=(
        "position", "speed: speed along the tube", "total_speed: speed through space", "wall_force: force of the wall",
        "motion", "rest: at rest at", "path: motion | time, position, speed",
    ),
    examples=(
        'dynamics particle tube --rotation "60 rpm" --start "0.1 m" --time "0.4 s" --mass "0.5 kg"',
        'dynamics particle tube --rotation "60 rpm" --start "0.2 m" --time "2 s" --mass "0.5 kg" '
        '--spring-stiffness "40 N/m" --spring-free-length "0.2 m"',
    ),
    table="path",
    plot=f"{PICTURES}:tube",
    arrays=False,
)  # fmt: skip

HOOP = Task(
    "hoop",
    "A bead on a turning hoop: critical rotation, equilibria, frequencies.",
    Model(
        "bead on a hoop",
        "dynamics_cli.particle.tube:hoop",
        source=BOOK + "sections 8.5 and 14.3",
        formula="cos {angle|θ} = {gravity|g}/({radius|a}·{rotation|Ω}²)",
        assumptions=("a smooth circular tube about its vertical diameter, turned at a constant rate",),
    ),
    headline=(
        "critical_rotation: critical rotation", "bottom: the bottom is", "bottom_frequency: frequency there",
        "bottom_growth: it leaves it at", "angle: tilted equilibrium", "frequency: frequency there", "height", "force",
    ),
    examples=(
        'dynamics particle hoop --radius "0.25 m" --rotation "8 rad/s"',
        'dynamics particle hoop --radius "10 in" --rotation "50 rpm" --units us',
    ),
    arrays=False,
)  # fmt: skip

INCLINE = Task(
    "incline",
    "A block on an incline with friction: does it slide, and how fast.",
    Model(
        "Coulomb friction",
        "dynamics_cli.particle.incline:incline",
        source=BOOK + "sections 6.4 and 8.3",
        formula="{normal_force|N} = {mass|m}·{gravity|g}·cos {angle|α}",
        assumptions=("Coulomb friction",),
    ),
    headline=(
        "motion", "acceleration", "normal_force: normal force", "friction_force: friction",
        "needed_friction: friction needed to rest", "repose: rests by itself up to",
        "holding_force: force that holds it", "moving_force: force that moves it up", "time", "speed",
        "stop_distance: stops after", "stop_time: in", "after: and", "return_speed: comes back with",
    ),
    examples=(
        'dynamics particle incline --mass "20 kg" --angle "30 deg" --friction 0.3 --distance "3 m"',
        'dynamics particle incline --mass "50 lb" --angle "20 deg" --friction 0.3 --kinetic 0.25 --force "45 lbf" '
        '--force-angle "-20 deg" --units us',
        'dynamics particle incline --mass "20 kg" --angle "30 deg" --friction 0.3 --start-speed "6 m/s"',
    ),
    arrays=False,
)  # fmt: skip

CIRCLE = Task(
    "circle",
    "A body on a banked bend: speeds at which it slides, friction it needs.",
    Model(
        "banked bend",
        "dynamics_cli.particle.incline:circle",
        source=BOOK + "sections 3.7 and 8.3",
        formula="v² = {gravity|g}·{radius|R}·(sin {bank|β} ± {friction|μ}·cos {bank|β})/"
        "(cos {bank|β} ∓ {friction|μ}·sin {bank|β})",
        assumptions=("a particle: it slides before it tips", "Coulomb friction in every direction"),
    ),
    headline=(
        "greatest_speed: slides outwards above", "least_speed: slides inwards below",
        "free_speed: no friction needed at", "slides: at the speed it", "needed_friction: friction needed",
        "acceleration", "normal_force: normal force",
    ),
    examples=(
        'dynamics particle circle --radius "60 m" --friction 0.6 --bank "5 deg" --speed "70 km/h"',
        'dynamics particle circle --radius "300 ft" --friction 0.1 --bank "20 deg" --units us',
    ),
    arrays=False,
)  # fmt: skip

ROTATING_FRAME = Task(
    "rotating-frame",
    "What acts on a particle in a turning frame: Coriolis, centrifugal; the earth.",
    Model(
        "apparent accelerations",
        "dynamics_cli.particle.rotating_frame:rotating_frame",
        source=BOOK + "section 4.10",
        formula="a = −2·ω×v − ω×(ω×r) − α×r",
        assumptions=("the frame's origin is at rest, or its acceleration counts as gravity",
                     "on the ground the centrifugal part belongs to gravity"),
    ),
    headline=(
        "coriolis: Coriolis −2ω×v", "coriolis_size: its magnitude", "centrifugal: centrifugal −ω×(ω×r)",
        "euler: Euler −α×r", "apparent: together", "force_size: apparent force", "true_velocity: true velocity",
        "inertial_radius: level motion circles at", "inertial_time: once in",
        "foucault_rate: Foucault's pendulum turns", "foucault_time: once round in",
    ),
    examples=(
        'dynamics particle rotating-frame --angular-velocity "0, 0, 2 rad/s" --position "1.5, 0, 0 m" '
        '--velocity "0, 1, 0 m/s" --mass "70 kg"',
        'dynamics particle rotating-frame --latitude "52 deg" --velocity "0, 250, 0 m/s"',
    ),
    arrays=False,
)  # fmt: skip

FAMILIES = {
    "particle": Family(
        "particle",
        "A particle: flights, falls, tubes, inclines, bends.",
        PROJECTILE,
        FALL,
        TUBE,
        HOOP,
        ROTATING_FRAME,
        INCLINE,
        CIRCLE,
    )
}
