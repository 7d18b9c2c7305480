"""Tasks of `dynamics linkage`: sliders."""

from dynamics_cli.core.answering.task import Model, Task

RIGID = "rigid links in one plane, pins and slides without play"

SLIDER_CRANK = Task(
    "slider-crank",
    "Slider-crank, in line or offset: position, velocity, acceleration, stroke, time ratio, or a table.",
    Model(
        "closed form",
        "dynamics_cli.linkage.sliders.slider_crank:slider_crank",
        formula="{position|x} = {crank|a}·cos{crank_angle|θ} + "
        "√({rod|b}² − ({offset|e} − {crank|a}·sin{crank_angle|θ})²)",
        assumptions=(RIGID, "no friction where torques are given"),
    ),
    headline=(
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
        "top_at: reached at θ",
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
        assumptions=(RIGID,),
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
    ),
    examples=(
        'dynamics linkage quick-return --crank "50 mm" --ground "120 mm" --crank-angle "75 deg" --speed "10 rad/s"',
        'dynamics linkage quick-return --crank "50 mm" --ground "120 mm" --lever "250 mm"',
    ),
    plot="dynamics_cli.linkage.sliders.pictures:quick_return_picture",
)

SCOTCH_YOKE = Task(
    "scotch-yoke",
    "Scotch yoke: harmonic motion of a slotted slide; position, velocity, acceleration, slip, torque.",
    Model(
        "closed form",
        "dynamics_cli.linkage.sliders.double_slider:scotch_yoke",
        formula="{position|x} = {crank|a}·cos({crank_angle|θ} + {slot_angle|β})/cos{slot_angle|β}",
        assumptions=(RIGID, "no friction where torques are given"),
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
        assumptions=(RIGID, "both shafts turn at the same, constant speed"),
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
        assumptions=(RIGID,),
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

TASKS: "tuple[Task, ...]" = (SLIDER_CRANK, QUICK_RETURN, SCOTCH_YOKE, OLDHAM, TRAMMEL)
