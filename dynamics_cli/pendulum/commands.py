"""The tasks of `dynamics pendulum`."""

from dynamics_cli.core.answering.task import Family, Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
AGM = "; Borwein & Borwein, Pi and the AGM, Wiley 1987, section 1.1"
NO_FRICTION = "no friction at the pivot, no drag"
PICTURES = "dynamics_cli.pendulum.pictures"

SIMPLE = Task(
    "simple",
    "A point mass on a rod or string, at any amplitude or going round.",
    Model(
        "simple pendulum",
        "dynamics_cli.pendulum.simple:simple",
        source=BOOK + "sections 8.4 and 10.8" + AGM,
        formula="{period|T} = 2π·√({length|L}/{gravity|g})/M(1, cos({amplitude|θ₀}/2))",
        assumptions=("a point mass on a rigid, massless rod", NO_FRICTION),
    ),
    headline=(
        "motion", "period: period T", "small_period: small-amplitude period T₀", "slowdown: ratio T/T₀", "amplitude",
        "bottom_speed: speed at the bottom", "top_speed: speed at the top", "bottom_tension: force at the bottom",
        "end_tension: at the end, or the top", "slack_angle: a string goes slack at", "angle_then: angle then",
        "rate_then: rate then",
    ),
    examples=(
        'dynamics pendulum simple --length "1 m" --amplitude "60 deg" --mass "2 kg"',
        'dynamics pendulum simple --length "3 ft" --bottom-speed "24 ft/s" --time "1 s" --units us',
    ),
    plot=f"{PICTURES}:simple",
    arrays=False,
)  # fmt: skip

FORCES = (
    "rate: angular velocity there", "along_force: pivot, along the body", "across_force: across it",
    "pin_force: together",
)  # fmt: skip
LENGTHS = (
    "equivalent_length: equivalent length, to the centre of percussion",
    "conjugate_distance: conjugate pivot, beyond the centre",
    "quickest_distance: quickest pivot, from the centre", "least_period: its period",
)  # fmt: skip

COMPOUND = Task(
    "compound",
    "A rigid body about a pivot: period, centre of percussion, pivot forces.",
    Model(
        "compound pendulum",
        "dynamics_cli.pendulum.compound:compound",
        source=BOOK + "section 8.9",
        formula="T = 2π·√(I/({mass|m}·{gravity|g}·{distance|d}))/M(1, cos({amplitude|θ₀}/2))",
        assumptions=("a rigid body about a fixed axis", NO_FRICTION),
    ),
    headline=("period: period T", "small_period: small-amplitude period T₀", *LENGTHS, *FORCES),
    examples=(
        'dynamics pendulum compound --mass "2 kg" --distance "0.6 m" --central-inertia "0.24 kg*m^2" '
        '--amplitude "60 deg"',
        'dynamics pendulum compound --mass "9 lb" --distance "14 in" --gyration "5 in" --units us',
    ),
    arrays=False,
)  # fmt: skip

ROD = Task(
    "rod",
    "A uniform rod about its end: period and pivot forces.",
    Model(
        "compound pendulum",
        "dynamics_cli.pendulum.compound:rod",
        source=BOOK + "section 8.9",
        formula="T = 2π·√(2·{length|L}/(3·{gravity|g}))/M(1, cos({amplitude|θ₀}/2))",
        assumptions=("a uniform, slender, rigid rod pinned at its end", NO_FRICTION),
    ),
    headline=("period: period T", "small_period: small-amplitude period T₀", *LENGTHS, *FORCES),
    examples=(
        'dynamics pendulum rod --length "1.2 m" --mass "2 kg" --amplitude "60 deg" --angle "20 deg"',
        'dynamics pendulum rod --length "39 in" --units us',
    ),
    arrays=False,
)  # fmt: skip

CONICAL = Task(
    "conical",
    "A point mass circling on a string: angle, speed, tension, disturbance.",
    Model(
        "conical pendulum",
        "dynamics_cli.pendulum.conical:conical",
        source=BOOK + "section 8.4",
        formula="cos {angle|α} = {gravity|g}/({length|L}·{rotation|Ω}²)",
        assumptions=("a point mass on a massless string", NO_FRICTION),
    ),
    headline=(
        "angle: angle from the vertical α", "rotation: circles at Ω", "period: once in", "speed", "radius", "height",
        "tension", "disturbance: a disturbance oscillates at", "least_rotation: hangs straight below",
    ),
    examples=(
        'dynamics pendulum conical --length "1 m" --rotation "40 rpm" --mass "0.5 kg"',
        'dynamics pendulum conical --length "3 ft" --angle "40 deg" --units us',
    ),
    arrays=False,
)  # fmt: skip

DAMPED = Task(
    "damped",
    "A pendulum that runs down: turning points, losses, swings to an angle.",
    Model(
        "equation of motion, integrated",
        "dynamics_cli.pendulum.damped:damped",
        source=BOOK + "sections 8.4 and 13.4; Hairer, Nørsett & Wanner, Solving ODEs I, Springer 1993, II.10",
        formula="θ̈ + 2·{damping|ζ}·ω₀·θ̇ + {quadratic|β}·|θ̇|·θ̇ + ω₀²·sin θ = 0",
        assumptions=("a point mass on a rigid, massless rod", "drag as the two coefficients say, nothing else"),
        method="DOP853, two tolerances",
    ),
    headline=(
        "first_period: first period", "first_loss: energy lost in the first half swing",
        "swings: full swings to the angle", "time: time to it",
        "peaks: turning points | swing=half swing, time, amplitude, loss=energy lost",
    ),
    examples=(
        'dynamics pendulum damped --length "1 m" --amplitude "60 deg" --damping 0.01 --until "5 deg"',
        'dynamics pendulum damped --length "40 in" --amplitude "30 deg" --quadratic 0.02 --until "10 deg"',
    ),
    table="peaks",
    plot=f"{PICTURES}:damped",
    arrays=False,
    cost=6e-3,
    tracked=False,
)  # fmt: skip

DESIGN = Task(
    "design",
    "The length, or the amplitude, for a wanted period.",
    Model(
        "simple pendulum",
        "dynamics_cli.pendulum.design:design",
        source="Borwein & Borwein, Pi and the AGM, Wiley 1987, section 1.1",
        formula="{length|L} = {gravity|g}·({period|T}·M(1, cos({amplitude|θ₀}/2))/(2π))²",
        assumptions=("a point mass on a rigid, massless rod", NO_FRICTION),
    ),
    headline=(
        "length: length L", "amplitude", "small_period: small-amplitude period T₀", "slowdown: ratio T/T₀",
        "daily_loss: a clock loses in a day", "length_per_second: longer for 1 s a day more",
    ),
    examples=(
        'dynamics pendulum design --period "2 s" --amplitude "3 deg"',
        'dynamics pendulum design --period "2 s" --length "0.99 m"',
    ),
    arrays=False,
    tracked=False,
)  # fmt: skip

FAMILIES = {
    "pendulum": Family(
        "pendulum",
        "Pendulums: periods, forces, turning round, running down.",
        SIMPLE, COMPOUND, ROD, CONICAL, DAMPED, DESIGN,
    )
}  # fmt: skip
