"""Tasks of `dynamics cam`: motion."""

from dynamics_cli.cam.commands.notes import PROGRAM_NOTES, PROGRAM_SCENE
from dynamics_cli.core.answering.task import Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, chapter 16"

LAWS = Task(
    "laws",
    "Rise laws, their peak factors and where they occur, and how smooth they are.",
    Model(
        "normalised rise laws",
        "dynamics_cli.cam.laws.table:laws",
        source=BOOK + ", sections 16.9 and 16.11 to 16.14; laws and names of VDI 2143 as commonly published",
        formula="v = C_v·h/β, a = C_a·h/β², j = C_j·h/β³",
        assumptions=("the rise goes from rest to rest, half rises from rest to full speed",),
    ),
    examples=(
        "dynamics cam laws",
        "dynamics cam laws --law bestehorn",
        'dynamics cam laws --law scca --shares "0.2, 0.5, 0.3"',
        'dynamics cam laws --law polynomial --condition "place=0, lift=0, velocity=0, acceleration=0" '
        '--condition "place=0.5, lift=0.6" --condition "place=1, lift=1, velocity=0, acceleration=0"',
    ),
    headline=("laws: peak factors | law, velocity=C_v, acceleration=C_a, jerk=C_j, continuity, jumps=first jump",),
    table="laws",
    listing=True,
    arrays=False,
    tracked=False,
)

RISE = Task(
    "rise",
    "Lift, velocity, acceleration and jerk of one rise, per radian and in time.",
    Model(
        "rise law",
        "dynamics_cli.cam.laws.rise:rise",
        source=BOOK + ", sections 16.9 and 16.11 to 16.14",
        formula="s = {lift|h}·f(θ/{span|β}), ds/dθ = ({lift|h}/{span|β})·f′, ds/dt = ω·ds/dθ",
        assumptions=("the cam shaft turns at a constant speed",),
    ),
    examples=(
        'dynamics cam rise --law cycloidal --lift "20 mm" --span "90 deg" --at "30 deg"',
        'dynamics cam rise --law modified-sine --lift "0.5 in" --span "120 deg" --shaft-speed "1200 rpm" --units us',
        'dynamics cam rise --law 3-4-5 --lift "8 mm" --span "60 deg" --at "0, 15, 30, 45, 60 deg" --falling',
    ),
    headline=(
        "peak_velocity: peak velocity v",
        "peak_velocity_at: at cam angle θ",
        "peak_acceleration: peak acceleration a",
        "peak_acceleration_at: at cam angle θ",
        "peak_jerk: peak jerk j",
        "peak_jerk_at: at cam angle θ",
        "peak_speed: peak speed ds/dt",
        "peak_acceleration_in_time: peak acceleration d²s/dt²",
        "points: motion | angle=θ, lift=s, velocity=v, acceleration=a, jerk=j",
    ),
    table="points",
    plot="dynamics_cli.cam.program.pictures:one_rise",
    arrays=False,
    tracked=False,
)

LINE = '--program "rise 20 mm in 90 deg; dwell 60 deg; return in 90 deg ms; dwell"'
SWING = '--program "rise 15 deg in 120 deg; dwell 60 deg; return in 120 deg; dwell"'

MOTION = Task(
    "motion",
    "A whole revolution of cam motion: extremes, continuity at every joint, and the table of s, v, a, j.",
    Model(
        "segments joined over one turn",
        "dynamics_cli.cam.program.revolution:motion",
        source=BOOK + ", sections 16.9 to 16.14 (singularity functions: 16.10)",
        formula="s(θ) = s_i + h_i·f_i((θ − θ_i)/β_i)",
        assumptions=("the follower follows", "the cam shaft turns at a constant speed"),
    ),
    examples=(
        f"dynamics cam motion {LINE}",
        'dynamics cam motion --program "rise 20 deg in 120 deg ms; dwell 60 deg; return in 180 deg" --count 7',
        "dynamics cam motion examples/cam.toml --shaft-speed '1000 rpm' --count 13",
        "dynamics cam motion --lifts examples/lifts.csv",
        'dynamics cam motion --program "rise 1 in in 120 deg parabolic; dwell 60 deg; return in 120 deg linear; dwell" '
        "--singularity --units us",
    ),
    headline=(
        "lift.greatest: maximum lift s",
        "velocity.greatest: maximum velocity v",
        "velocity.least: minimum velocity v",
        "acceleration.greatest: maximum acceleration a",
        "acceleration.least: minimum acceleration a",
        "in_time.speed: maximum speed ds/dt",
        "in_time.acceleration: maximum acceleration d²s/dt²",
        "swing.greatest: maximum swing ψ",
        "swing.greatest_velocity: maximum velocity ψ′",
        "swing.least_velocity: minimum velocity ψ′",
        "swing.greatest_acceleration: maximum acceleration ψ″",
        "swing.least_acceleration: minimum acceleration ψ″",
        "swing_in_time.speed: maximum speed dψ/dt",
        "swing_in_time.acceleration: maximum acceleration d²ψ/dt²",
        "continuity",
        "table: motion | angle=θ, lift=s, velocity=v, acceleration=a, jerk=j",
        "swing_table: motion | angle=θ, swing=ψ, velocity=ψ′, acceleration=ψ″, jerk=ψ‴",
    ),
    table="table swing_table",
    plot="dynamics_cli.cam.program.pictures:svaj",
    notes=PROGRAM_NOTES,
    scene=PROGRAM_SCENE,
    arrays=False,
    tracked=False,
)

FORCE = Task(
    "force",
    "Contact force, torque, jump speed, Hertz stress, spring surge and valve durations of a follower on a spring.",
    Model(
        "rigid follower on a spring",
        "dynamics_cli.cam.forces.forces:force",
        source="Newton's law, virtual work, Hertz's line contact; motion: " + BOOK,
        formula=(
            "F = {spring_rate|k}·s + {preload|P} + {load|L} + {mass|m}·{shaft_speed|ω}²·s″, T = F·s′, N = F/cos φ, "
            "ω_jump² = min ({spring_rate|k}·s + {preload|P} + {load|L})/(−{mass|m}·s″)",
            "M = {spring_radius|r}·({spring_rate|k}·{spring_radius|r}·ψ + {preload|P}) + {load_torque|L} + "
            "{inertia|I}·{shaft_speed|ω}²·ψ″, T = M·ψ′, N = M/lever, ω_jump² = min (M at ω = 0)/(−{inertia|I}·ψ″)",
            "M = {torsion_rate|k}·ψ + {preload_torque|P} + {load_torque|L} + {inertia|I}·{shaft_speed|ω}²·ψ″, "
            "T = M·ψ′, N = M/lever, ω_jump² = min ({torsion_rate|k}·ψ + {preload_torque|P} + {load_torque|L})"
            "/(−{inertia|I}·ψ″)",
        ),
        assumptions=(
            "the follower's train is rigid and without friction",
            "the cam shaft turns at a constant speed",
            "a linear spring on an arm acts square to its radius at every swing",
        ),
        method="closed-form motion; extremes from Chebyshev interpolants",
    ),
    examples=(
        f'dynamics cam force {LINE} --shaft-speed "600 rpm" --mass "0.5 kg" --spring-rate "5 N/mm" --preload "60 N"',
        f'dynamics cam force {LINE} --shaft-speed "400 rpm" --mass "1 lb" --spring-rate "30 lbf/in" --preload "20 lbf" '
        '--follower roller --base-radius "40 mm" --roller-radius "10 mm" --contact-width "12 mm" '
        '--spring-mass "0.1 kg"',
        'dynamics cam force --program "rise 9 mm in 65 deg 4-5-6-7; return in 65 deg 4-5-6-7; dwell" '
        '--shaft-speed "3000 rpm" --mass "0.25 kg" --spring-rate "40 N/mm" --preload "300 N" --lash "0.2 mm"',
        f'dynamics cam force {SWING} --shaft-speed "500 rpm" --inertia "0.002 kg*m^2" --torsion-rate "10 N*m/rad" '
        '--preload-torque "2 N*m" --follower oscillating-roller --base-radius "30 mm" --roller-radius "8 mm" '
        '--arm "80 mm" --pivot-distance "100 mm" --contact-width "10 mm"',
        f'dynamics cam force {SWING} --shaft-speed "500 rpm" --inertia "0.002 kg*m^2" --spring-radius "50 mm" '
        '--spring-rate "4 N/mm" --preload "40 N" --follower oscillating-flat --base-radius "40 mm" '
        '--pivot-distance "120 mm" --face-offset "4 mm" --count 13',
    ),
    headline=(
        "greatest_force: maximum axial force F",
        "least_force: minimum axial force F",
        "greatest_arm_torque: maximum arm torque M",
        "least_arm_torque: minimum arm torque M",
        "greatest_contact_force: maximum contact force N",
        "stress: Hertz pressure p_H",
        "greatest_torque: maximum shaft torque T",
        "greatest_power: maximum power P",
        "jump_speed: jump speed n",
        "surge_order: spring surges at harmonic",
    ),
    table="table arm_table",
    plot="dynamics_cli.cam.forces.pictures:forces",
    notes=PROGRAM_NOTES,
    scene={**PROGRAM_SCENE, "shaft_speed": "600 rpm", "mass": "0.5 kg", "spring_rate": "5 N/mm", "preload": "60 N"},
    arrays=False,
    cost=8e-3,
    tracked=False,
)

TASKS: "tuple[Task, ...]" = (LAWS, RISE, MOTION, FORCE)
