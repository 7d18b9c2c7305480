"""Tasks of `dynamics linkage`: sliders."""

from dynamics_cli.core.answering.task import Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 5.3"
RIGID = "rigid links in one plane, pins and slides without play"

SLIDER_CRANK = Task(
    "slider-crank",
    "Slider-crank, in line or offset: position, velocity, acceleration, stroke, time ratio, or a table.",
    Model(
        "closed form",
        "dynamics_cli.linkage.sliders.slider_crank:slider_crank",
        source=BOOK,
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
        "time_ratio: time ratio",
        "outer_at: outer dead centre at θ",
        "inner_at: inner dead centre at θ",
        "table: crank turn | crank_angle=θ, position=x, slope=v/ω, bend=a/ω², rod_angle=rod",
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
        source=BOOK,
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

TASKS: "tuple[Task, ...]" = (SLIDER_CRANK, QUICK_RETURN)
