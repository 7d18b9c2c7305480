"""Tasks of `dynamics linkage`: four-bars and sliders."""

from dynamics_cli.core.answering.task import Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
RIGID = "rigid links in one plane, pins without play"
SLIDING = "rigid links in one plane, pins and slides without play"
ARM = '--crank "40 mm" --coupler "120 mm" --rocker "80 mm" --ground "100 mm"'

FOUR_BAR = Task(
    "four-bar",
    "Position, velocity and acceleration of a four-bar on both branches, or its table over the crank angle.",
    Model(
        "two circles",
        "dynamics_cli.linkage.fourbar.four_bar:four_bar",
        formula="f² = ({crank|a} − {ground|d})² + 4·{crank|a}·{ground|d}·sin²({crank_angle|θ₂}/2); "
        "D₁ = ({coupler|b} + {rocker|c})² − f², D₂ = f² − ({coupler|b} − {rocker|c})²; "
        "{transmission_angle|μ} = 2·atan2(√D₂, √D₁)",
        assumptions=(RIGID, "no friction where torques are given"),
    ),
    headline=(
        "rocker_angle: rocker angle θ₄",
        "coupler_angle: coupler angle θ₃",
        "transmission_angle: transmission angle μ",
        "rocker_ratio: speed ratio ω₄/ω₂",
        "rocker_speed: rocker speed ω₄",
        "coupler_speed: coupler speed ω₃",
        "rocker_acceleration: rocker acceleration α₄",
        "coupler_acceleration: coupler acceleration α₃",
        "crank_torque: crank torque T₂",
        "position: coupler point P",
        "velocity: velocity of P",
        "acceleration: acceleration of P",
        "other_rocker_angle: θ₄ on the other branch",
        "kind: class",
        "side: this assembly",
        "swing: rocker swings through",
        "rocker_least: rocker angle θ₄ from",
        "rocker_greatest: rocker angle θ₄ to",
        "table: crank turn | crank_angle=θ₂, rocker_angle=θ₄, rocker_ratio=ω₄/ω₂, rocker_change=α₄/ω₂², "
        "rocker_speed=ω₄, rocker_acceleration=α₄, transmission_angle=μ, coupler_angle=θ₃",
    ),
    examples=(
        f'dynamics linkage four-bar {ARM} --crank-angle "40 deg" --speed "10 rad/s"',
        f'dynamics linkage four-bar {ARM} --crank-angle "40 deg" --speed "95 rpm" --load-torque "12 N*m" '
        '--point "60, 40 mm"',
        f"dynamics linkage four-bar {ARM} --steps 12",
    ),
    table="table",
    plot="dynamics_cli.linkage.fourbar.pictures:four_bar_picture",
    writers={"svg": "dynamics_cli.linkage.fourbar.pictures:moving_four_bar"},
)

CLASS = Task(
    "class",
    "Grashof class of a four-bar on the decimals as typed: limits, swing, time ratio, change points.",
    Model(
        "Grashof's rule",
        "dynamics_cli.linkage.fourbar.grashof:classify",
        formula="s + l < p + q; cos φ at O₂ = (({crank|a} ± {coupler|b})² + {ground|d}² − {rocker|c}²)/"
        "(2·({crank|a} ± {coupler|b})·{ground|d})",
        assumptions=(RIGID,),
    ),
    headline=(
        "kind: class",
        "margin: margin p + q − s − l",
        "rotates: turns fully",
        "outer_limit: crank stays within ±",
        "inner_limit: crank stays beyond ±",
        "swing: rocker swings through",
        "rocker_least: smallest rocker angle",
        "rocker_greatest: largest rocker angle",
        "time_ratio: time ratio",
        "least_transmission_angle: smallest transmission angle μ",
        "greatest_transmission_angle: largest transmission angle μ",
        "change_points: change point | crank_angle=θ₂, first_rocker_ratio=ω₄/ω₂, second_rocker_ratio=or ω₄/ω₂, "
        "coupler_angle=θ₃, rocker_angle=θ₄",
    ),
    examples=(
        f"dynamics linkage class {ARM}",
        'dynamics linkage class --crank "2 in" --coupler "5 in" --rocker "4 in" --ground "3 in" --units us',
    ),
    arrays=False,
    plot="dynamics_cli.linkage.fourbar.pictures:class_picture",
)

COUPLER = Task(
    "coupler",
    "Curve of a coupler point: length, cusps, crossings, cognates; DXF, SVG or CSV with a proved deviation.",
    Model(
        "analytic closed motion",
        "dynamics_cli.linkage.fourbar.coupler:coupler",
        source=BOOK + "section 5.5; Roberts 1875 for the cognates",
        formula="P = A + (p + i·q)·(B − A)/{coupler|b}; {length|L} = ∮|P′|du; z = (p + i·q)/{coupler|b}, third pivot "
        "z·{ground|d}",
        assumptions=(RIGID,),
        method="trapezoid rule on an analytic closed curve",
    ),
    headline=(
        "length: length of the curve",
        "area: area inside",
        "left: x from",
        "right: x to",
        "bottom: y from",
        "top: y to",
        "kind: class",
        "deviation: proved deviation",
        "straight: straight part | crank_angle=from θ₂, last_crank_angle=to θ₂, length, deviation, direction",
        "cusps: cusp | crank_angle=θ₂, x, y",
        "crossings: crossing | crank_angle=θ₂, second_crank_angle=and θ₂, x, y",
        "cognates: cognate | name, crank, coupler, rocker, ground",
    ),
    examples=(
        f'dynamics linkage coupler {ARM} --point "60, 40 mm"',
        'dynamics linkage coupler --crank "1 in" --coupler "2.5 in" --rocker "2.5 in" --ground "2 in" '
        '--point "5, 0 in" --units us',
        'dynamics linkage coupler --crank "10 mm" --coupler "25 mm" --rocker "25 mm" --ground "20 mm" '
        '--point "50, 0 mm" --straight-within "0.05 mm"',
    ),
    table="points",
    arrays=False,
    cost=6e-3,
    tracked=False,
    plot="dynamics_cli.linkage.fourbar.pictures:coupler_picture",
)

SYNTHESIZE = Task(
    "synthesize",
    "Four-bar for three angle pairs, three coupler poses, or a swing with a time ratio; with its defects.",
    Model(
        "prescribed positions",
        "dynamics_cli.linkage.fourbar.synthesis:synthesize",
        source="Freudenstein, Transactions of the ASME 77, 1955",
        formula="R₁·cos θ₄ − R₂·cos θ₂ + R₃ = cos(θ₂ − θ₄); R₁ = {ground|d}/{crank|a}, R₂ = {ground|d}/{rocker|c}",
        assumptions=(RIGID,),
        method="closed form; for a swing, the best of a family by golden section",
    ),
    headline=(
        "crank: crank a",
        "coupler: coupler b",
        "rocker: rocker c",
        "ground: ground d",
        "crank_pivot: pivot O₂",
        "rocker_pivot: pivot O₄",
        "first_pin: pin A on the body",
        "second_pin: pin B on the body",
        "kind: class",
        "defects: defects",
        "least_transmission_angle: smallest transmission angle μ",
        "met: met at | crank_angle=θ₂, rocker_angle=θ₄, transmission_angle=μ, branch",
    ),
    scene={
        "ground": "100 mm",
        "pairs[0].crank_angle": "30 deg",
        "pairs[0].rocker_angle": "60 deg",
        "pairs[1].crank_angle": "60 deg",
        "pairs[1].rocker_angle": "75 deg",
        "pairs[2].crank_angle": "90 deg",
        "pairs[2].rocker_angle": "95 deg",
    },
    examples=(
        'dynamics linkage synthesize --pair "crank_angle=30 deg, rocker_angle=60 deg" '
        '--pair "crank_angle=60 deg, rocker_angle=75 deg" --pair "crank_angle=90 deg, rocker_angle=95 deg" '
        '--ground "100 mm"',
        'dynamics linkage synthesize --swing "60 deg" --time-ratio 1.2 --rocker "80 mm"',
        'dynamics linkage synthesize --pose "x=0 mm, y=0 mm, angle=0 deg" --pose "x=50 mm, y=30 mm, angle=20 deg" '
        '--pose "x=80 mm, y=70 mm, angle=60 deg" --crank-pivot "-40, 60 mm" --rocker-pivot "40, 60 mm"',
    ),
    arrays=False,
    tracked=False,
    plot="dynamics_cli.linkage.fourbar.pictures:synthesis_picture",
)

SLIDER_CRANK = Task(
    "slider-crank",
    "Slider-crank, in line or offset: position, velocity, acceleration, stroke, time ratio, or a table.",
    Model(
        "closed form",
        "dynamics_cli.linkage.sliders.slider_crank:slider_crank",
        formula="{position|x} = {crank|a}·cos{crank_angle|θ} + "
        "√({rod|b}² − ({offset|e} − {crank|a}·sin{crank_angle|θ})²)",
        assumptions=(SLIDING, "no friction where torques are given"),
    ),
    headline=(
        "crank_angle: crank angle θ",
        "crank_speed: crank speed ω",
        "crank_acceleration: crank acceleration α",
        "position: slider position x",
        "travel: from outer dead centre",
        "velocity: slider velocity v",
        "acceleration: slider acceleration a",
        "rod_angle: rod to slide (pressure angle)",
        "rod_speed: rod speed ω₃",
        "rod_acceleration: rod acceleration α₃",
        "crank_torque: crank torque T",
        "stroke: stroke s",
        "top_speed: largest speed in a turn",
        "top_at: largest speed at θ",
        "time_ratio: time ratio",
        "outer_at: outer dead centre at θ",
        "inner_at: inner dead centre at θ",
        "table: crank turn | crank_angle=θ, position=x, velocity=v, acceleration=a, slope=v/ω, bend=a/ω², "
        "rod_angle=rod",
    ),
    examples=(
        'dynamics linkage slider-crank --crank "50 mm" --rod "150 mm" --offset "20 mm" --crank-angle "60 deg" '
        '--speed "100 rad/s"',
        'dynamics linkage slider-crank --crank "50 mm" --rod "175 mm" --steps 12',
        'dynamics linkage slider-crank --crank "50 mm" --rod "150 mm" --slider-position "170 mm" '
        '--slider-velocity "0.5 m/s" --load-force "2 kN"',
    ),
    table="table",
    plot="dynamics_cli.linkage.sliders.pictures:slider_picture",
    writers={"svg": "dynamics_cli.linkage.sliders.pictures:moving_slider"},
)

QUICK_RETURN = Task(
    "quick-return",
    "Crank and slotted lever, oscillating or Whitworth's: lever angle, speed, acceleration, time ratio.",
    Model(
        "closed form",
        "dynamics_cli.linkage.sliders.quick_return:quick_return",
        formula="r⃗ = a⃗ − d⃗; ω₄ = ω₂·a⃗·r⃗/r²; {time_ratio|Q} = (π + 2γ)/(π − 2γ), sin γ = {crank|a}/{ground|d} or its "
        "inverse",
        assumptions=(SLIDING,),
    ),
    headline=(
        "lever_angle: lever angle θ₄",
        "lever_ratio: speed ratio ω₄/ω₂",
        "lever_speed: lever speed ω₄",
        "lever_acceleration: lever acceleration α₄",
        "slip: slip of the pin",
        "coriolis: Coriolis acceleration",
        "tip: tip of the lever",
        "tip_velocity: velocity of the tip",
        "time_ratio: time ratio",
        "swing: lever swings through",
        "stroke: stroke of the tip",
        "kind: kind",
        "table: crank turn | crank_angle=θ₂, lever_angle=θ₄, lever_ratio=ω₄/ω₂, lever_speed=ω₄, "
        "lever_acceleration=α₄, slip",
    ),
    examples=(
        'dynamics linkage quick-return --crank "50 mm" --ground "120 mm" --crank-angle "75 deg" --speed "10 rad/s"',
        'dynamics linkage quick-return --crank "50 mm" --ground "120 mm" --lever "250 mm" --speed "60 rpm"',
    ),
    table="table",
    plot="dynamics_cli.linkage.sliders.pictures:quick_return_picture",
)

SCOTCH_YOKE = Task(
    "scotch-yoke",
    "Scotch yoke: harmonic motion of a slotted slide; position, velocity, acceleration, slip, torque.",
    Model(
        "closed form",
        "dynamics_cli.linkage.sliders.double_slider:scotch_yoke",
        formula="{position|x} = {crank|a}·cos({crank_angle|θ} + {slot_angle|β})/cos{slot_angle|β}",
        assumptions=(SLIDING, "no friction where torques are given"),
    ),
    headline=(
        "position: position of the yoke x",
        "velocity: velocity v",
        "acceleration: acceleration a",
        "slip: slip of the pin in the slot",
        "crank_torque: crank torque T",
        "stroke: stroke s",
        "top_speed: largest speed",
        "top_acceleration: largest acceleration",
    ),
    examples=(
        'dynamics linkage scotch-yoke --crank "40 mm" --crank-angle "30 deg" --speed "300 rpm"',
        'dynamics linkage scotch-yoke --crank "40 mm" --crank-angle "30 deg" --slot-angle "20 deg" '
        '--load-force "500 N"',
    ),
    plot="dynamics_cli.linkage.sliders.double_pictures:yoke_picture",
)

OLDHAM = Task(
    "oldham",
    "Oldham coupling of parallel shafts: sliding of the disc, motion of its centre, shaking force.",
    Model(
        "closed form",
        "dynamics_cli.linkage.sliders.double_slider:oldham",
        formula="slip = {offset|e}·{speed|ω}; {centre_acceleration|a} = 2·{offset|e}·{speed|ω}²",
        assumptions=(SLIDING, "both shafts turn at the same, constant speed"),
    ),
    headline=(
        "largest_slip: largest sliding speed",
        "slide: travel in each slot",
        "first_slip: sliding in the first slot here",
        "second_slip: sliding in the second",
        "centre: centre of the disc",
        "centre_speed: its speed",
        "centre_acceleration: its acceleration",
        "shaking_force: shaking force, twice a turn",
    ),
    examples=(
        'dynamics linkage oldham --offset "3 mm" --speed "1500 rpm" --mass "0.2 kg"',
        'dynamics linkage oldham --offset "0.1 in" --speed "900 rpm" --shaft-angle "30 deg"',
    ),
    plot="dynamics_cli.linkage.sliders.double_pictures:oldham_picture",
)

TRAMMEL = Task(
    "trammel",
    "Bar whose ends slide on two square lines: elliptic trammel, ladder on a wall.",
    Model(
        "closed form",
        "dynamics_cli.linkage.sliders.double_slider:trammel",
        formula="P = (({bar|L} − {point|p})·cos{angle|φ}, {point|p}·sin{angle|φ})",
        assumptions=(SLIDING,),
    ),
    headline=(
        "position: point P",
        "velocity: its velocity",
        "acceleration: its acceleration",
        "bar_speed: rate of the angle φ",
        "bar_acceleration: its second rate",
        "foot_velocity: velocity of A along x",
        "top_velocity: velocity of B along y",
        "centre: instant centre",
        "along_x: half axis of the ellipse, x",
        "along_y: half axis, y",
    ),
    examples=(
        'dynamics linkage trammel --bar "5 m" --angle "60 deg" --point "2.5 m" --pull "0.5 m/s"',
        'dynamics linkage trammel --bar "200 mm" --angle "35 deg" --point "-80 mm" --speed "4 rad/s"',
    ),
    plot="dynamics_cli.linkage.sliders.double_pictures:trammel_picture",
)

TASKS: "tuple[Task, ...]" = (
    FOUR_BAR, CLASS, COUPLER, SYNTHESIZE, SLIDER_CRANK, QUICK_RETURN, SCOTCH_YOKE, OLDHAM, TRAMMEL,
)  # fmt: skip
