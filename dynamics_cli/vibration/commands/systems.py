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
        "kind: damping", "rigid_modes: rigid modes", "coordinates: shapes list",
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

TASKS = (MODES, RESPONSE)
