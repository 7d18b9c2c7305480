"""Tasks of `dynamics impact`: a whole crash, and a slide with spin after one."""

from dynamics_cli.core.answering.task import Model, Task
from dynamics_cli.impact.commands.rigid import SHORT

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 9.5 and 10.10"
POINTS = "point masses slowed uniformly on every surface; slides are straight"
ONE_ROAD = "one surface is one friction, for every vehicle and phase that refers to it"

CRASH = Task(
    "crash",
    "A complete two-car crash from one scene: before, impact and after, as one model.",
    Model(
        "slides, then momentum and energy on one line, then the approach phases",
        "dynamics_cli.impact.crash.solve:crash_with_energy",
        source=BOOK,
        formula="after: u² = u_e² + 2·g·Σ f·d; impact: u² = w² + 2·E/m_r; before: v₀² = v² + 2·g·f·d",
        assumptions=(POINTS, SHORT, ONE_ROAD),
        suffices="dynamics_cli.impact.crash.solve:energy_suffices",
    ),
    Model(
        "slides, then momentum, then the approach phases",
        "dynamics_cli.impact.crash.solve:crash",
        source=BOOK,
        formula="after: u² = u_e² + 2·g·Σ f·d; impact: m₁·v₁ + m₂·v₂ = m₁·u₁ + m₂·u₂; before: v₀² = v² + 2·g·f·d",
        assumptions=(POINTS, SHORT, ONE_ROAD),
    ),
    scene={
        "axes": "compass",
        "first.mass": "1500 kg",
        "first.approach_heading": "90 deg",
        "first.exit_heading": "48 deg",
        "first.name": "Ford",
        "first.before[0].distance": "12.4 m",
        "first.before[0].surface": "road",
        "first.after[0].distance": "10.7 m",
        "first.after[0].surface": "road",
        "second.mass": "1150 kg",
        "second.approach_heading": "0 deg",
        "second.exit_heading": "53 deg",
        "second.name": "Opel",
        "second.after[0].distance": "11.6 m",
        "second.after[0].surface": "road",
        "surfaces[0].name": "road",
        "surfaces[0].friction": "0.72",
    },
    examples=("dynamics impact crash examples/crash_scene/crash.toml",),
    table="courses links agreements",
    plot="dynamics_cli.impact.crash.pictures:crash",
    writers=dict.fromkeys(("dxf", "svg", "pdf"), "dynamics_cli.impact.crash.pictures:plan"),
    limited={
        "scene.speed_limit": (
            "first.start.speed first.approach_speed",
            "second.start.speed second.approach_speed",
        )
    },
    unspread=("first.per_degree", "second.per_degree"),
    findings=(
        "first.start.speed: {first}'s speed at its start",
        "first.approach_speed: {first}'s speed into the impact",
        "first.delta_v.magnitude: {first}'s ΔV",
        "second.start.speed: {second}'s speed at its start",
        "second.approach_speed: {second}'s speed into the impact",
        "second.delta_v.magnitude: {second}'s ΔV",
    ),
    headline=(
        "first.start.speed: first start speed v₀",
        "first.approach_speed: first impact speed v",
        "first.per_degree: first v error per degree",
        "first.delta_v.magnitude: first ΔV",
        "second.start.speed: second start speed v₀",
        "second.approach_speed: second impact speed v",
        "second.per_degree: second v error per degree",
        "second.delta_v.magnitude: second ΔV",
        "weakest: weakest link",
    ),
)

SLIDE = Task(
    "slide",
    "From the separation to rest with spin, on wheels locked or rolling; or back from rest.",
    Model(
        "four wheels",
        "dynamics_cli.impact.slide.task:slide",
        source="Newton–Euler in the plane",
        formula="m·dV/dt = Σ F, m·k²·dω/dt = Σ r × F; F_x = −s·μN·l_x/|l|, "
        "F_y = −√(1 − s²)·μN·l_y/√(l_y² + (τ·l_x)²), locked (s = 1): −μN·l/|l|",
        assumptions=(
            "static wheel loads: the transfer of load between the wheels is left out",
            "a rolling wheel is saturated beyond its grip slope; the law of the wheel is a choice of this program",
            "a level road; nothing but the tyres touches it",
        ),
        method="stretched time, variable order and step",
        together="dynamics_cli.impact.slide.many:slides",
    ),
    examples=(
        'dynamics impact slide --speed "12 m/s" --course "30 deg" --spin "3 rad/s" --front-axle "1.2 m" '
        '--rear-axle "1.4 m" --track "1.5 m" --radius-of-gyration "1.35 m" --friction 0.7 --braking 100%',
        'dynamics impact slide --rest "9.6, 5.6 m" --rest-nose "192 deg" --front-axle "1.2 m" --rear-axle "1.4 m" '
        '--track "1.5 m" --radius-of-gyration "1.35 m" --friction 0.7 --braking 2% --left-front 100%',
    ),
    arrays=False,
    tracked=False,
    table="wheels path roots",
    plot="dynamics_cli.impact.slide.pictures:slide",
    writers=dict.fromkeys(("dxf", "svg", "pdf"), "dynamics_cli.impact.slide.pictures:plan"),
    headline=(
        "speed: speed at the separation v",
        "course: course there",
        "spin: yaw rate there ω",
        "rest_position: rest position",
        "rest_heading: nose at rest",
        "time: time to rest",
        "wheels: wheels | wheel, braking, energy_share=energy, mark",
    ),
    notes="Wheels: 100 % is locked or jammed, about 2 % rolls freely. The nose at rest counts whole turns: 380 deg for "
    "a turn and 20 deg. A --ground is all to the left of a straight edge, seen from its first point to its second; "
    "with a width only a strip along it; with patch=yes too it ends at both points.",
)

TASKS = (CRASH, SLIDE)
