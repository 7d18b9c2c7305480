"""The task of `dynamics vibration` about nonlinear oscillators."""

from dynamics_cli.core.answering.task import Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "

NONLINEAR = Task(
    "nonlinear",
    "Nonlinear oscillators: Krylov–Bogoliuboff beside the integrated truth; jumps under a force.",
    Model(
        "averaging and integration",
        "dynamics_cli.vibration.nonlinear.task:nonlinear",
        source=BOOK + "sections 13.9 and 13.10; Krylov & Bogoliuboff, Introduction to Non-Linear Mechanics, 1947",
        formula="ȧ = −(1/2π)·∮f·cos ψ dψ, ψ̇ = 1 + (1/2πa)·∮f·sin ψ dψ for ẍ + x + f(x, ẋ) = 0",
        assumptions=("time counts in radians of the linear vibration", "one coordinate, no noise"),
        method="arithmetic–geometric mean, DOP853, Radau, shooting",
    ),
    headline=(
        "averaged_frequency: frequency, averaged", "true_frequency: frequency, true", "frequency_error: off by",
        "averaged_amplitude: amplitude, averaged", "true_amplitude: amplitude, true", "amplitude_error: off by",
        "true_period: period",
        "large_amplitude: large amplitude, averaged", "small_amplitude: small amplitude, averaged",
        "rising_jump: jump, frequency rising", "falling_jump: jump, frequency falling",
        "branches: steady amplitudes | amplitude=averaged, true_amplitude=integrated, error=off by, stable",
    ),
    examples=(
        "dynamics vibration nonlinear --law van-der-pol --mu 1",
        "dynamics vibration nonlinear --law forced-duffing --cubic 0.5 --damping-ratio 0.02 --force 0.2 "
        "--frequency-ratio 1.6",
        'dynamics vibration nonlinear --law pendulum --swing "90 deg" --natural-frequency "0.5 Hz"',
        'dynamics vibration nonlinear --law custom --function "0.05*v*abs(v) + 0.1*x^3" --amplitude 1 --cycles 6',
    ),
    scene={"law": "duffing", "cubic": "0.1"},
    plot="dynamics_cli.vibration.nonlinear.pictures:nonlinear",
    arrays=False,
    tracked=False,
)  # fmt: skip

TASKS = (NONLINEAR,)
