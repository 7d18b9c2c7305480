"""Tasks of `dynamics skid` about marks, drag and stopping."""

from dynamics_cli.core.answering.task import Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 10.10"
RANGES = "Published ranges with their sources: dynamics skid values friction"
SLIDES = "every braked wheel slides the whole way"
POINT = "the vehicle is a point mass; air drag and wheel inertia are neglected"

# Where ranges of friction are, with the surfaces that they are of.
MEASURED = {"friction": "ranges: dynamics skid values friction --surface asphalt (concrete, gravel, snow, ice, grass)"}

SPEED = Task(
    "speed",
    "Speed at the start of skid marks over one or several surfaces.",
    Model(
        "work–energy",
        "dynamics_cli.skid.braking:speed",
        source=BOOK,
        formula="{speed|v} = √({end_speed|vₑ}² + 2·{gravity|g}·Σ {surfaces.drag_factor|f}·{surfaces.distance|d}), "
        "f = ({braking|η}·{friction|μ} + {grade|G})/√(1 + {grade|G}²)",
        assumptions=(SLIDES, "friction is constant on each surface", POINT),
    ),
    headline=("speed", "time", "total_distance"),
    examples=(
        'dynamics skid speed --distance "60 ft" --friction 0.7',
        'dynamics skid speed --segment "distance=60 ft, friction=0.7, grade=-3 %, braking=80 %" '
        '--segment "distance=20 ft, friction=0.35" --end-speed "10 mph" --units us',
    ),
    plot="dynamics_cli.skid.pictures:speed",
    notes=RANGES,
    pointers=MEASURED,
)

DISTANCE = Task(
    "distance",
    "Distance and time in which a braked vehicle slows from one speed to another.",
    Model(
        "work–energy",
        "dynamics_cli.skid.braking:distance",
        source=BOOK,
        formula="{distance|d} = ({speed|v} − {end_speed|vₑ})·({speed|v} + {end_speed|vₑ})"
        "/(2·{gravity|g}·{drag_factor|f})",
        assumptions=(SLIDES, POINT),
    ),
    headline=("distance", "time", "deceleration", "drag_factor: drag factor f"),
    examples=('dynamics skid distance --speed "50 mph" --friction 0.7 --grade "-3 %"',),
    plot="dynamics_cli.skid.pictures:distance",
    notes=RANGES,
    pointers=MEASURED,
)

FRICTION = Task(
    "friction",
    "Coefficient of friction from one or several test skids.",
    Model(
        "work–energy",
        "dynamics_cli.skid.friction:friction",
        source=BOOK,
        formula="{friction|μ} = ({tests.drag_factor|f}·√(1 + {grade|G}²) − {grade|G})/{braking|η}, "
        "f = {inputs.speed|v}²/(2·{gravity|g}·{inputs.distance|d})",
        assumptions=("each test skid ends at rest", POINT),
    ),
    headline=("friction: friction μ", "standard_deviation", "standard_error", "lowest", "highest"),
    examples=(
        'dynamics skid friction --speed "30 mph" --distance "43 ft"',
        'dynamics skid friction --test-skid "speed=30 mph, distance=43 ft" '
        '--test-skid "speed=30 mph, distance=41.5 ft" '
        '--test-skid "speed=30 mph, distance=44 ft"',
    ),
    plot="dynamics_cli.skid.pictures:friction",
)

DRAG_FACTOR = Task(
    "drag-factor",
    "Drag factor from a surface, from unequally braked axles or from a drag sled.",
    Model(
        "statics of the braking vehicle",
        "dynamics_cli.skid.drag:drag_factor",
        source="statics, with the weight transfer of the deceleration itself; work–energy form: " + BOOK,
        formula=(
            "{drag_factor|f} = ({braking|η}·{friction|μ} + {grade|G})/√(1 + {grade|G}²)",
            "{effective_friction|m} = ({front_friction|μf}·{front_braking|ηf}·({wheelbase|L} − {cm_position|a}) + "
            "{rear_friction|μr}·{rear_braking|ηr}·{cm_position|a})/({wheelbase|L} + "
            "{cm_height|h}·({rear_friction|μr}·{rear_braking|ηr} − {front_friction|μf}·{front_braking|ηf})); "
            "{drag_factor|f} = ({effective_friction|m} + {grade|G})/√(1 + {grade|G}²)",
            "{drag_factor|f} = {pull|P}·(cos{pull_angle|α} − {grade|G}·sin{pull_angle|α})"
            "/({weight|W} − {pull|P}·sin{pull_angle|α}·√(1 + {grade|G}²))",
        ),
        assumptions=("the deceleration is steady", "both axles stay on the road"),
    ),
    plot="dynamics_cli.skid.pictures:drag_factor",
    headline=(
        "drag_factor: drag factor f",
        "deceleration",
        "effective_friction: effective friction μ",
        "front_share: load on the front axle",
        "rear_share: load on the rear axle",
        "weight_transfer",
    ),
    examples=(
        'dynamics skid drag-factor --friction 0.7 --grade "-4 %" --braking "85 %"',
        "dynamics skid drag-factor --front-friction 0.75 --rear-friction 0.75 --rear-braking 0.4 "
        '--wheelbase "2.7 m" --cm-position "1.2 m" --cm-height "0.55 m"',
        'dynamics skid drag-factor --pull "28 lbf" --weight "40 lbf"',
    ),
)

STOP = Task(
    "stop",
    "Reaction, brake build-up and braking of a whole stop, as a time–distance table.",
    Model(
        "uniform deceleration after a linear build-up",
        "dynamics_cli.skid.stop:stop",
        source=BOOK,
        formula=(
            "{stopping_distance|s} = {reaction_distance|s_r} + {build_up_distance|s_b} + {braking_distance|s_a}",
            "{stopping_distance|s} = {reaction_distance|s_r} + {braking_distance|s_a}",
        ),
        assumptions=("constant speed during the reaction", "deceleration rises linearly during the build-up", POINT),
    ),
    headline=(
        "stopping_distance",
        "stopping_time",
        "reaction_distance",
        "build_up_distance: build-up distance",
        "braking_distance",
        "braking_speed: speed at full braking",
        "timeline",
    ),
    examples=('dynamics skid stop --speed "50 km/h" --friction 0.75 --reaction-time "1.0 s" --build-up-time "0.2 s"',),
    table="timeline",
    plot="dynamics_cli.skid.pictures:stop",
    notes=RANGES,
    pointers=MEASURED,
)

YAW = Task(
    "yaw",
    "Critical speed of a curved path, from a yaw mark.",
    Model(
        "circular motion at the limit of side friction",
        "dynamics_cli.skid.yaw:yaw",
        source="Newton's second law on a banked curve; as commonly published for yaw marks",
        formula=(
            "{speed|v} = √({gravity|g}·{path_radius|R}·(f + {superelevation|e})/(1 − f·{superelevation|e}))"
            "/(1 + {test_error|ε}), f = √({friction|μ}² − {braking_drag|b}²)",
            "{speed|v} = √({gravity|g}·{path_radius|R}·(f + {superelevation|e})/(1 − f·{superelevation|e})), "
            "f = √({friction|μ}² − {braking_drag|b}²)",
            "{speed|v} = √({gravity|g}·{path_radius|R}·({friction|f} + {superelevation|e})"
            "/(1 − {friction|f}·{superelevation|e}))/(1 + {test_error|ε})",
            "{speed|v} = √({gravity|g}·{path_radius|R}·({friction|f} + {superelevation|e})"
            "/(1 − {friction|f}·{superelevation|e}))",
        ),
        assumptions=("the mark is the path of a vehicle sliding sideways at its limit", POINT),
    ),
    headline=(
        "speed: critical speed",
        "speed_deviation: σ of the speed by the points",
        "path_radius: path radius R",
        "mark_radius",
        "radius_deviation: σ of the radius by the points",
        "point_scatter: scatter of the points",
        "first_half_radius: radius of the first half",
        "second_half_radius: radius of the second half",
        "lateral_acceleration",
    ),
    examples=(
        'dynamics skid yaw --chord "100 ft" --middle-ordinate "3.5 ft" --friction 0.72 --superelevation "2 %" '
        '--track-width "5 ft" --units us',
        'dynamics skid yaw --points "0, 0, 10, 4.30, 20, 7.53, 30, 9.65, 40, 10.70 m" --point-deviation "3 cm" '
        '--friction 0.72 --track-width "1.5 m"',
    ),
    unspread=(
        *("speed_deviation", "radius_deviation", "point_scatter", "sagitta", "centre"),
        *("first_half_radius", "second_half_radius"),
    ),
    plot="dynamics_cli.skid.pictures:yaw",
    notes=RANGES,
    pointers=MEASURED,
)

VAULT = Task(
    "vault",
    "Take-off speed of an airborne vehicle, for a known angle or the minimum over all angles.",
    Model(
        "least speed over all angles",
        "dynamics_cli.skid.vault:vault_least_speed",
        source="projectile motion; Josephs & Huston, chapter 8",
        formula="{speed|v} = √({gravity|g}·({rise|y} + √({distance|x}² + {rise|y}²)))",
        assumptions=("a point mass without air drag", "any take-off angle is possible: the speed is a lower bound"),
        suffices="dynamics_cli.skid.vault:least_speed_suffices",
    ),
    Model(
        "known take-off angle",
        "dynamics_cli.skid.vault:vault_known_angle",
        source="projectile motion; Josephs & Huston, chapter 8",
        formula="{speed|v} = {distance|x}·√({gravity|g}/(2·cos{take_off|α}·({distance|x}·sin{take_off|α} − "
        "{rise|y}·cos{take_off|α})))",
        assumptions=("a point mass without air drag",),
    ),
    headline=("speed: take-off speed", "launch_angle: take-off angle", "flight_time", "landing_speed", "landing_angle"),
    examples=(
        'dynamics skid vault --distance "18 m" --rise "-3 m" --take-off "6 deg"',
        'dynamics skid vault --distance "18 m" --rise "-3 m"',
    ),
    plot="dynamics_cli.skid.pictures:vault",
)

SEARLE = "Searle & Searle (SAE 831622, 1983) and Searle (1993), as commonly published"

THROW = Task(
    "throw",
    "Speed from the throw of a pedestrian or rider: bounds, a known launch, the vehicle.",
    Model(
        "Searle's throw",
        "dynamics_cli.skid.pedestrian:pedestrian",
        source=SEARLE + "; launch height derived",
        formula=(
            "{speed|v} = √(2·{friction|μ}·{gravity|g}·({throw_distance|s} − {friction|μ}·{launch_height|H}))"
            "/(cos{launch_angle|α} + {friction|μ}·sin{launch_angle|α}); for s ≤ μ·H: "
            "v = s·√(g/(2·cos α·(H·cos α + s·sin α)))",
            "{least_speed|v₁} = √(2·{friction|μ}·{gravity|g}·({throw_distance|s} − {friction|μ}·{launch_height|H})"
            "/(1 + {friction|μ}²)); {greatest_speed|v₂} = √(2·{friction|μ}·{gravity|g}·({throw_distance|s} − "
            "{friction|μ}·{launch_height|H})); for s ≤ μ·H: v₁ = s·√(g/(√(s² + H²) + H)), v₂ = s·√(g/(2·H))",
        ),
        assumptions=(
            "level ground",
            "friction acts on the landing as on the slide",
            "the upper bound holds to greatest_angle",
        ),
        suffices="dynamics_cli.skid.throw:level_suffices",
    ),
    Model(
        "Searle's throw on a grade",
        "dynamics_cli.skid.throw:on_grade",
        source=SEARLE + "; grade and launch height derived",
        formula="{speed|v} = √(2·{gravity|g}·({friction|μ}·cosφ + sinφ)·({throw_distance|s}/cosφ − "
        "{launch_height|h}·(sinφ + {friction|μ}·cosφ)))/(cosα + {friction|μ}·sinα), tanφ = {grade|G}, "
        "α = {launch_angle|launch} − φ",
        assumptions=("one grade along the whole throw", "friction acts on the landing as on the slide"),
    ),
    headline=(
        "speed: projection speed",
        "least_speed: lower bound of speed",
        "greatest_speed: upper bound of speed",
        "flight_distance",
        "slide_distance",
        "vehicle_speed: speed of the vehicle",
        "least_vehicle_speed: lower bound of the vehicle's",
    ),
    examples=(
        'dynamics skid throw --throw-distance "25 m" --friction 0.66',
        'dynamics skid throw --throw-distance "25 m" --friction 0.66 '
        '--launch-angle "12 deg" --launch-height "1 m" --grade "-4 %" --efficiency "80 %"',
    ),
    plot="dynamics_cli.skid.pictures:throw",
    notes="Published ranges with their sources: dynamics skid values slide",
    also=("pedestrian",),
)

AVOID = Task(
    "avoid",
    "Could the driver have stopped, at the speed travelled and at the limit, and what speed would have sufficed.",
    Model(
        "reaction at constant speed, then uniform braking",
        "dynamics_cli.skid.avoid:avoid",
        source=BOOK,
        formula="{sufficient_speed|v_s} = 2·{sight_distance|S}/({reaction_time|t} + "
        "√({reaction_time|t}² + 2·{sight_distance|S}/a)), a = {gravity|g}·{drag_factor|f}",
        assumptions=("the hazard stays where it is", "uniform braking after the reaction", POINT),
    ),
    headline=(
        "avoidable",
        "impact_speed",
        "margin: margin before the hazard",
        "stopping_distance",
        "sufficient_speed",
        "avoidable_at_limit",
        "impact_speed_at_limit",
        "margin_at_limit",
    ),
    examples=(
        'dynamics skid avoid --speed "62 km/h" --speed-limit "50 km/h" --sight-distance "32 m" --reaction-time "1.2 s" '
        "--friction 0.75",
    ),
    table="approaches",
    findings=(
        "avoidable: the driver {could|could not} have stopped before the hazard",
        "impact_speed: the speed at the hazard",
        "sufficient_speed: the driver would have stopped from {} or less",
        "avoidable_at_limit: at the speed limit the driver {could|could not} have stopped",
    ),
    chances={"avoidable": "margin", "avoidable_at_limit": "margin_at_limit"},
    plot="dynamics_cli.skid.pictures:avoid",
    notes=RANGES,
    pointers=MEASURED,
)

SPIN = Task(
    "spin",
    "Speed lost by a vehicle that rotates after an impact, by the partial drag of its tyres.",
    Model(
        "mean sine of the slip angle",
        "dynamics_cli.skid.spin:spin",
        source="work–energy, section 10.10 of the book; the partial drag of a rotating vehicle as commonly used",
        formula="{speed|v} = √({end_speed|vₑ}² + 2·{gravity|g}·{drag_factor|f}·{distance|d}), "
        "f = ({mean_share|k}·{friction|μ} + {grade|G})/√(1 + {grade|G}²)",
        assumptions=("the vehicle turns uniformly along its path", "a quarter turn or more", POINT),
    ),
    plot="dynamics_cli.skid.pictures:spin",
    notes=RANGES,
    headline=(
        "speed",
        "speed_lost",
        "drag_factor: drag factor f",
        "mean_share: mean share of friction",
        "time",
        "mean_yaw_rate",
    ),
    examples=(
        'dynamics skid spin --rotation "210 deg" --rolling-drag "10 %" --distance "18 m" --friction 0.65',
        'dynamics skid spin --drag-share "60 %" --distance "18 m" --friction 0.65 --end-speed "5 km/h"',
    ),
    pointers=MEASURED,
)


TASKS = (SPEED, DISTANCE, FRICTION, DRAG_FACTOR, STOP, YAW, VAULT, THROW, AVOID, SPIN)
