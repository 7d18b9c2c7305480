"""The tasks of `dynamics motion`."""

from dynamics_cli.core.answering.task import Family, Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
PICTURES = "dynamics_cli.motion.pictures"

CHAIN = Task(
    "chain",
    "Rods pinned to one another, let go: motion, pin forces, and how long it can be known.",
    Model(
        "chain of rods, integrated",
        "dynamics_cli.motion.chain:chain",
        source=BOOK + "sections 12.4 and 12.5",
        formula="Σ_j a_ij·[q̈_j·cos(q_i − q_j) + q̇_j²·sin(q_i − q_j)] + {gravity|g}·b_i·sin q_i = 0",
        assumptions=("rigid rods in one vertical plane, their centres in the middle", "no friction, no drag"),
        method="DOP853, two tolerances",
    ),
    headline=(
        "verdict: answer", "horizon: horizon, about", "tenfold: errors grow tenfold in",
        "difference: two runs apart by",
        "energy_error: energy kept to", "top_force: largest force in the top pin",
        "rods: at the end",
        "motion: motion | time, angles",
    ),
    examples=(
        'dynamics motion chain --lengths "0.5, 0.5, 0.5 m" --masses "1 kg" --angles "30, -20, 45 deg" '
        '--duration "2 s" --steps 4',
        'dynamics motion chain --lengths "1, 1 m" --masses "0 kg" --end-masses "1 kg" --angles "90 deg" '
        '--duration "10 s"',
    ),
    table="motion",
    plot=f"{PICTURES}:chain",
    arrays=False,
    tracked=False,
)  # fmt: skip

MODES = Task(
    "modes",
    "Small oscillations of a hanging chain: frequencies and shapes.",
    Model(
        "chain of rods, small angles",
        "dynamics_cli.motion.modes:modes",
        source=BOOK + "sections 12.5 and 13.8; Drmač & Veselić, SIAM J. Matrix Anal. Appl. 29 (2008) 1322",
        formula="({gravity|g}·diag b − ω²·A)·φ = 0",
        assumptions=("small angles about hanging at rest", "no friction, no drag"),
        method="one-sided Jacobi",
    ),
    headline=(
        "slowest: lowest frequency", "fastest: highest frequency",
        "modes: modes | number=mode, frequency, period, shape=angles, ends=ends sideways",
    ),
    examples=(
        'dynamics motion modes --lengths "0.5, 0.5, 0.5 m" --masses "1 kg"',
        'dynamics motion modes --lengths "1, 1, 1 m" --masses "0 kg" --end-masses "1e-6, 1, 1e6 kg"',
    ),
    table="modes",
    plot=f"{PICTURES}:modes",
    arrays=False,
    tracked=False,
)  # fmt: skip

FAMILIES = {
    "motion": Family("motion", "Motion of chains of rods: how they move, and how long that is known.", CHAIN, MODES)
}
