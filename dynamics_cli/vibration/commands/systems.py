"""Tasks of `dynamics vibration` about several masses."""

from dynamics_cli.core.answering.task import Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
PICTURES = "dynamics_cli.vibration.systems.pictures"
SMALL = "small motions, linear springs, viscous dampers"

MODES = Task(
    "modes",
    "Natural frequencies, damping and shapes of several masses, from springs or matrices.",
    Model(
        "modes of a linear system",
        "dynamics_cli.vibration.systems.modes:modes",
        source=BOOK + "sections 13.7 and 13.8; Drmač & Veselić, SIAM J. Matrix Anal. Appl. 29 (2008) 1322",
        formula="(K − ω²·M)·φ = 0; ω are the singular values of √k·A·m^(−½)",
        assumptions=(SMALL, "effective masses are for a base that moves all coordinates alike"),
        method="one-sided Jacobi, symmetric or complex eigenvalues",
    ),
    headline=(
        "first_frequency: natural frequency f₁", "second_frequency: natural frequency f₂",
        "third_frequency: natural frequency f₃", "first_damping_ratio: damping ratio ζ₁", "kind: damping",
        "rigid_modes: rigid modes", "coordinates",
        "modes: modes | number=mode, frequency, damping_ratio=ζ, effective_share=effective mass, shape, "
        "phases=lead in deg",
    ),
    examples=(
        'dynamics vibration modes --masses "1, 2, 3 kg" --stiffnesses "1, 1e14, 1000 N/m"',
        'dynamics vibration modes --body "name=machine, mass=800 kg" --body "name=block, mass=3000 kg" '
        '--coupling "from=machine, to=block, stiffness=2 kN/mm, damping=4 kN*s/m" '
        '--coupling "from=block, to=ground, stiffness=9 kN/mm, damping=60 kN*s/m"',
    ),
    scene={"masses": "1, 2, 3 kg", "stiffnesses": "1, 1e14, 1000 N/m"},
    table="modes",
    plot=f"{PICTURES}:modes",
    arrays=False,
    tracked=False,
)  # fmt: skip

RESPONSE = Task(
    "response",
    "Frequency response between two coordinates of several masses: amplitude, phase, peaks.",
    Model(
        "frequency response of a linear system",
        "dynamics_cli.vibration.systems.response:response",
        source=BOOK + "sections 13.7 and 13.8",
        formula="x = (K − ω²·M + iω·C)⁻¹·{force|F}",
        assumptions=(SMALL, "steady state under a sine force"),
        method="sum over modes, or a solution at each frequency where dampers couple modes",
    ),
    headline=(
        "amplitude: amplitude", "lag: lag behind the force", "receptance",
        "motions: at this frequency | name=coordinate, amplitude, velocity, lag",
        "peak: highest peak", "peak_frequency: its frequency",
        "peaks: peaks | frequency, amplitude, receptance, lag",
    ),
    examples=(
        'dynamics vibration response --body "name=machine, mass=800 kg" --body "name=block, mass=3000 kg" '
        '--coupling "from=machine, to=block, stiffness=2 kN/mm, damping=4 kN*s/m" '
        '--coupling "from=block, to=ground, stiffness=9 kN/mm, damping=60 kN*s/m" --force-at machine --read-at block '
        '--force "500 N" --speed "740 rpm"',
        'dynamics vibration response --masses "1, 1, 1 kg" --stiffnesses "10, 10, 10 N/mm" --damping-ratio 0.01 '
        "--force-at 1 --read-at 3",
    ),
    scene={"masses": "1, 1 kg", "stiffnesses": "10, 10 N/mm", "damping_ratio": "0.01", "force_at": "1", "read_at": "2"},
    table="peaks",
    plot=f"{PICTURES}:response",
    arrays=False,
    tracked=False,
)  # fmt: skip

HISTORY = Task(
    "history",
    "Motion of several masses over time under a force, or on a base that moves: sine, formula, record.",
    Model(
        "motion of a linear system",
        "dynamics_cli.vibration.systems.history:history",
        source=BOOK + "sections 13.6 to 13.8",
        formula="q̈ + C·q̇ + Ω²·q = φᵀ·F(t), x = φ·q; on a base −φᵀ·M·1·a(t)",
        assumptions=(SMALL, "at rest before", "a base moves all coordinates alike",
                     "a recorded load runs straight from sample to sample, a recorded displacement smoothly"),
        method="each mode in closed form, or the exponential of the state matrix where dampers couple modes",
    ),
    headline=(
        "peak: largest displacement", "peak_time: at", "read: of coordinate", "work: work of the load",
        "lost: taken by dampers", "stored: left at the end",
        "peaks: largest of each | name=coordinate, displacement, time=at, absolute=in space, velocity, acceleration",
    ),
    examples=(
        'dynamics vibration history --masses "1, 1, 1 kg" --stiffnesses "10, 10, 10 N/mm" --damping-ratio 0.02 '
        '--force-law "200*exp(-30*t)*sin(60*t) N" --force-at 1 --duration "1 s"',
        'dynamics vibration history --body "name=machine, mass=800 kg" --body "name=block, mass=3000 kg" '
        '--coupling "from=machine, to=block, stiffness=2 kN/mm, damping=4 kN*s/m" '
        '--coupling "from=block, to=ground, stiffness=9 kN/mm, damping=60 kN*s/m" --base-acceleration "0.2 g" '
        '--frequency "6 Hz" --duration "2 s"',
    ),
    scene={"masses": "1, 1 kg", "stiffnesses": "10, 10 N/mm", "damping_ratio": "0.01", "force": "50 N",
           "frequency": "9 Hz", "force_at": "1", "duration": "1 s"},
    table="history",
    plot=f"{PICTURES}:history",
    arrays=False,
    tracked=False,
)  # fmt: skip

TASKS = (MODES, RESPONSE, HISTORY)
