"""The tasks of `dynamics stability`."""

from dynamics_cli.core.answering.task import Family, Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
TYPED = "coefficients are exact as typed"
SECONDS = "time is in seconds: roots are in 1/s and rad/s"
PICTURES = "dynamics_cli.stability.pictures"
ROOTS = "roots: roots, one of each pair | real, imaginary, multiplicity=times, natural=ω₀, damping=ζ"

ROUTH = Task(
    "routh",
    "Stability from a characteristic polynomial: exact root counts.",
    Model(
        "Routh–Hurwitz",
        "dynamics_cli.stability.routh:routh",
        source=BOOK + "section 14.7; Gantmacher, Theory of Matrices II (1959) XV",
        formula="{left|n₋} + {right|n₊} + {axis|n₀} = degree",
        assumptions=("a linear system with constant coefficients", TYPED, SECONDS),
        method="exact counts",
    ),
    headline=(
        "verdict", "left: roots on the left", "right: on the right", "axis: on the axis",
        "repeated: largest multiplicity there", ROOTS,
    ),
    examples=(
        'dynamics stability routh "s^4 + 10s^3 + 35s^2 + 50s + 24"',
        'dynamics stability routh "1, 1, 3, 3, 3, 2, 1"',
    ),
    table="roots",
    arrays=False,
    tracked=False,
    plot=f"{PICTURES}:routh",
)  # fmt: skip

GAIN = Task(
    "gain",
    "Gains for which a closed loop is stable, exactly.",
    Model(
        "zeros of the Hurwitz determinant",
        "dynamics_cli.stability.gain:gain",
        source=BOOK + "section 14.7; Gantmacher, Theory of Matrices II (1959) XV",
        formula="Δₙ₋₁(K)·a₀(K)·aₙ(K) = 0 at the ends",
        assumptions=("a linear system with constant coefficients", TYPED, SECONDS),
        method="exact counts",
    ),
    headline=(
        "stable: stable for", "verdict: at the gain given", ROOTS,
        "designs: at the damping ratio given | gain=K, natural=ω₀, real, imaginary, verdict=there",
        "critical: critical gains | gain=K, frequency=ω, crossing=there",
    ),
    examples=(
        'dynamics stability gain "s(s+1)(s+2) + K"',
        'dynamics stability gain "s(s+4)(s+6)(s^2+1.4s+1) + K(s^2+2s+4)" --gain 20',
        'dynamics stability gain "K(s+1.5)/(s(s+1)(s+10))" --damping-ratio 0.8',
    ),
    table="critical",
    arrays=False,
    tracked=False,
    plot=f"{PICTURES}:gain",
)  # fmt: skip

INTERVAL = Task(
    "interval",
    "Robust stability where coefficients lie within ranges.",
    Model(
        "Kharitonov's four polynomials",
        "dynamics_cli.stability.interval:interval",
        source="Kharitonov, Differential Equations 14 (1979) 1483",
        formula="four polynomials of low and high ends decide",
        assumptions=("coefficients vary independently of one another, and slowly", TYPED),
        method="exact counts",
    ),
    headline=(
        "verdict", "failing: first that fails", "corners: four polynomials | coefficients, verdict, left, right, axis",
    ),
    examples=('dynamics stability interval "1, 2..3, 3..4, 1..5"', 'dynamics stability interval "1, 2..3, 3..4, 1..7"'),
    table="corners",
    arrays=False,
    tracked=False,
    plot=f"{PICTURES}:interval",
)  # fmt: skip

DELAY = Task(
    "delay",
    "Delays for which a loop p(s) + q(s)·exp(−sτ) is stable.",
    Model(
        "crossing frequencies",
        "dynamics_cli.stability.delay:delay",
        source="Cooke & van den Driessche, Funkcialaj Ekvacioj 29 (1986) 77",
        formula="|p(iω)|² = |q(iω)|²",
        assumptions=("a linear system with constant coefficients and one constant delay", TYPED, SECONDS),
        method="exact counts",
    ),
    headline=(
        "stable: stable for", "first_unstable: unstable from", "verdict: at the delay given",
        "crossings: crossings | frequency=ω, first=first delay, spacing=again after, direction=the pair",
        "ranges: delays | low=from, high=to, right=roots on the right, verdict",
    ),
    examples=(
        'dynamics stability delay "s^2 + 0.4s + 1" --delayed 0.5',
        'dynamics stability delay "s" --delayed "1" --delay "1.2 s"',
    ),
    table="ranges",
    arrays=False,
    tracked=False,
    plot=f"{PICTURES}:delay",
)  # fmt: skip

MATRIX = Task(
    "matrix",
    "Stability from A, or from mass, damping, gyroscopic and stiffness matrices.",
    Model(
        "characteristic polynomial",
        "dynamics_cli.stability.matrix:matrix",
        source=BOOK + "sections 14.5 to 14.7; Chetaev, The Stability of Motion, Pergamon 1961",
        formula="det(M·s² + (C + G)·s + K) = 0",
        assumptions=("a linear system with constant coefficients", "elements are exact as typed", SECONDS),
        method="exact counts",
    ),
    headline=(
        "verdict", "growth: it grows by", "left: roots on the left", "right: on the right", "axis: on the axis",
        "without_gyroscopic: without G", ROOTS,
    ),
    examples=(
        'dynamics stability matrix "0, 1; -4, -0.2"',
        'dynamics stability matrix --mass "1, 0; 0, 1" --gyroscopic "0, -3; 3, 0" --stiffness "-1, 0; 0, -2"',
    ),
    table="roots",
    arrays=False,
    tracked=False,
    plot=f"{PICTURES}:matrix",
)  # fmt: skip

EQUILIBRIUM = Task(
    "equilibrium",
    "Equilibria of a potential, or of states with any rates, and which of them are stable.",
    Model(
        "minimum of the potential, or linear terms",
        "dynamics_cli.stability.equilibria.equilibrium:equilibrium",
        source=BOOK + "sections 14.2 and 14.3",
        formula="V′ = 0, V″ > 0 stable, ω = √(V″/m); or ẋ = f(x) = 0, roots of det(s·1 − ∂f/∂x)",
        assumptions=(
            "of a potential: a conservative system with one coordinate and the same inertia everywhere",
            "of states: their ranges are searched from even starts, not proved complete",
        ),
        method="roots of exact derivatives",
    ),
    headline=(
        "stable: stable equilibria", "unstable: unstable ones", "undecided: undecided ones",
        "growth: fastest growth", "decay: slowest decay", "frequency: lowest frequency of a stable one",
        "points: equilibria | at, verdict, rightmost=growth, frequency",
        "places: equilibria | position=x, angle=θ, energy=V, verdict, frequency, growth",
    ),
    examples=(
        'dynamics stability equilibrium --potential "4*x^4 - 2*x^2 J" --lowest "-2 m" --highest "2 m" --mass "2 kg"',
        'dynamics stability equilibrium --potential "m*g*l*(1 - cos(theta)) J" --let "m=2 kg, g=9.81 m/s^2, l=0.5 m" '
        '--inertia "0.5 kg*m^2"',
        'dynamics stability equilibrium --state "name=theta, rate=w" --state "name=w, rate=-9.81/l*sin(theta) - 0.4*w" '
        '--let "l=0.5"',
    ),
    scene={
        "states[0].name": "x", "states[0].rate": "v", "states[1].name": "v", "states[1].rate": "x - x^3 - 0.2*v",
    },
    table="places",
    arrays=False,
    tracked=False,
    points=400,
    plot=f"{PICTURES}:equilibrium",
)  # fmt: skip

DISCRETE = Task(
    "discrete",
    "Stability of a sampled system: roots about the unit circle.",
    Model(
        "bilinear map and Routh–Hurwitz",
        "dynamics_cli.stability.discrete:discrete",
        source="Jury, Theory and Application of the z-Transform Method, Wiley 1964, chapter 3",
        formula="z = (1 + s)/(1 − s)",
        assumptions=("a linear system with constant coefficients, sampled at equal times", TYPED),
        method="exact counts",
    ),
    headline=(
        "verdict", "inside: roots inside the circle", "outside", "circle: on the circle",
        "repeated: largest multiplicity there",
        "roots: roots, one of each pair | real, imaginary, size=|z|, angle, multiplicity=times",
    ),
    examples=('dynamics stability discrete "z^2 - 1.5z + 0.7"', 'dynamics stability discrete "1, -1.2, 0.11, 0.147"'),
    table="roots",
    arrays=False,
    tracked=False,
    plot=f"{PICTURES}:discrete",
)  # fmt: skip

FAMILIES = {
    "stability": Family(
        "stability",
        "Stability of linear systems and equilibria, exactly counted.",
        ROUTH,
        GAIN,
        INTERVAL,
        DELAY,
        MATRIX,
        EQUILIBRIUM,
        DISCRETE,
    )
}
