"""Tasks of `dynamics impact`: particles, momentum and crush."""

from dynamics_cli.core.task import Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section "
HERE = "dynamics_cli.impact."
SHORT = "the impact is short: forces other than that of contact have no impulse"

CENTRAL = Task(
    "central",
    "Two bodies that meet head on: velocities after, impulse, energy lost.",
    Model(
        "central impact",
        HERE + "central:central",
        source=BOOK + "9.10",
        formula="{impulse|p} = (1 + {restitution|e})·{reduced_mass|m_r}·{closing_speed|u}; "
        "{first.velocity|v₁'} = v₁ − p/{first.mass|m₁}; {second.velocity|v₂'} = v₂ + p/{second.mass|m₂}; "
        "{energy_lost|E} = ½·m_r·(1 − e²)·u²",
        assumptions=(SHORT, "mass centres and contact lie on one line, along which both bodies move"),
    ),
    examples=(
        'dynamics impact central --first-mass "2 kg" --first-velocity "3 m/s" --second-mass "1 kg" --restitution 0.5',
        'dynamics impact central --first-weight "3400 lbf" --first-velocity "30 mph" --second-weight "2600 lbf" '
        '--second-velocity "-25 mph" --restitution 0.15 --units us',
        'dynamics impact central --first-mass "0.058 kg" --first-velocity "20 m/s" --second-fixed --restitution 0.73',
    ),
)

OBLIQUE = Task(
    "oblique",
    "Two particles or smooth spheres that meet at an angle.",
    Model(
        "oblique impact of smooth bodies",
        HERE + "oblique:oblique",
        source=BOOK + "9.11",
        formula="{impulse|p} = (1 + {restitution|e})·m_r·{closing_speed|u}, u = (v₁ − v₂)·n; "
        "{energy_lost|E} = ½·m_r·(1 − e²)·u²",
        assumptions=(SHORT, "the surfaces are smooth: the impulse acts along the line of impact"),
    ),
    examples=(
        'dynamics impact oblique --first-mass "1 kg" --first-velocity "20 cm/s @ 45 deg" --second-mass "1 kg" '
        '--second-velocity "15 cm/s @ 150 deg" --normal "0 deg" --restitution 0.95',
        'dynamics impact oblique --first-mass "0.17 kg" --first-velocity "3, 0 m/s" --second-mass "0.17 kg" '
        '--offset "20 mm" --first-radius "28.6 mm" --second-radius "28.6 mm" --restitution 0.94 --json',
        'dynamics impact oblique --first-mass "0.6 kg" --first-speed "10 m/s" --first-heading "-30 deg" --second-fixed '
        '--normal "-90 deg" --restitution 0.75',
    ),
)

TASKS: "tuple[Task, ...]" = (CENTRAL, OBLIQUE)
