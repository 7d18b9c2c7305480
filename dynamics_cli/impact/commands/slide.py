"""The task of a slide with spin."""

from dynamics_cli.core.answering.task import Model, Task

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

TASKS: "tuple[Task, ...]" = (SLIDE,)
