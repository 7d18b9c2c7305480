"""Task of `dynamics impact` for a light vehicle against a heavy one."""

from dynamics_cli.core.answering.task import Model, Task

ROTATION = Task(
    "rotation",
    "Speed of a light vehicle from how it turned the heavy one it struck.",
    Model(
        "momentum of rotation",
        "dynamics_cli.impact.reconstruction.rotation:rotation",
        source="Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 9.4",
        formula="{impulse|p} = {heavy_inertia|J₁}·{heavy_spin|Δω₁}/{lever|h}, "
        "{speed|v₂} = {impulse|p}/{light_mass|m₂} + {exit_speed|u₂}",
        assumptions=(
            "one impulse, along the approach of the light vehicle",
            "the tyres of the heavy vehicle do not hold it against the turn",
            "it did not turn before",
        ),
    ),
    findings=(
        "speed: the light vehicle's speed",
        "light_change: its ΔV",
        "heavy_change: the heavy vehicle's ΔV",
    ),
    headline=(
        "speed: speed of the light vehicle",
        "impulse",
        "light_change: its ΔV",
        "heavy_change: ΔV of the heavy vehicle",
    ),
    examples=(
        'dynamics impact rotation --heavy-inertia "1800 kg*m^2" --heavy-spin "1.15 rad/s" --lever "1.6 m" '
        '--light-mass "250 kg" --exit-speed "2 m/s" --heavy-mass "1450 kg"',
    ),
    plot="dynamics_cli.impact.reconstruction.rotation_picture:rotation",
)

TASKS = (ROTATION,)
