"""Tasks of `dynamics vibration` about sudden loads."""

from dynamics_cli.core.answering.task import Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
LINEAR = "one mass, a linear spring, viscous damping, at rest before the load"
PICTURES = "dynamics_cli.vibration.shocks.pictures"

TRANSIENT = Task(
    "transient",
    "Response to a step, ramp, pulse or recorded load: peak, overshoot, motion over time.",
    Model(
        "one degree of freedom",
        "dynamics_cli.vibration.shocks.transient:transient",
        source=BOOK + "section 13.6; Duhamel's integral",
        formula="z̈ + 2ζω·ż + ω²·z = F/{mass|m} or −a of the base",
        assumptions=(LINEAR, "a recorded load runs straight from sample to sample"),
        method="closed form on each piece of the load",
    ),
    headline=(
        "peak: peak displacement", "peak_time: at", "rebound: to the other side", "static: if it came slowly",
        "factor: dynamic factor", "overshoot", "peak_acceleration", "ground_force: force to the ground",
    ),
    examples=(
        'dynamics vibration transient --natural-frequency "20 Hz" --damping-ratio 0.05 --base-acceleration "30 g" '
        '--shape half-sine --duration "11 ms"',
        'dynamics vibration transient --mass "500 kg" --stiffness "400 N/mm" --damping-ratio 0.1 --force "2 kN" '
        "--shape step",
    ),
    table="history",
    plot=f"{PICTURES}:transient",
    arrays=False,
    tracked=False,
)  # fmt: skip

SHOCK = Task(
    "shock",
    "Shock response spectrum of a pulse or a recorded acceleration.",
    Model(
        "oscillators on a base",
        "dynamics_cli.vibration.shocks.shock:shock",
        source="Biot, Trans. ASCE 108 (1943) 365; ISO 18431-4 (definitions)",
        formula="z̈ + 2·{damping_ratio|ζ}·ω·ż + ω²·z = −a, response −(2·{damping_ratio|ζ}·ω·ż + ω²·z)",
        assumptions=("oscillators too light to disturb the base, at rest before",
                     "a recorded acceleration runs straight from sample to sample"),
        method="closed form on each piece of the input",
    ),
    headline=(
        "worst: largest response", "worst_frequency: at", "factor: over the peak of the input",
        "velocity_change: velocity change",
        "spectrum: spectrum | frequency, maximax, primary, residual, pseudo_velocity",
    ),
    examples=(
        'dynamics vibration shock --shape half-sine --base-acceleration "30 g" --duration "11 ms" --lowest "20 Hz" '
        '--highest "500 Hz" --per-octave 2',
    ),
    table="spectrum",
    plot=f"{PICTURES}:shock",
    arrays=False,
    tracked=False,
)  # fmt: skip

TASKS = (TRANSIENT, SHOCK)
