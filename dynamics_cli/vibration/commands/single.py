"""Tasks of `dynamics vibration` about one mass on a spring."""

from dynamics_cli.core.answering.task import Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
LINEAR = "one mass, a linear spring, viscous damping"
PICTURES = "dynamics_cli.vibration.single.pictures"
FREE = Task(
    "free",
    "Free vibration of one mass: frequencies, damping, decay, state at a time; dry friction.",
    Model(
        "one degree of freedom",
        "dynamics_cli.vibration.single.free:free",
        source=BOOK + "sections 13.3 and 13.5",
        formula="{natural_frequency|f_n} = √({stiffness|k}/{mass|m})/2π, ζ = c/(2·√(k·m)), δ = 2π·ζ/√(1 − ζ²)",
        assumptions=("a linear spring; viscous damping, or dry friction on level ground", "no force but these"),
    ),
    headline=(
        "natural_frequency: natural frequency f_n", "damping_ratio: damping ratio ζ", "motion",
        "damped_frequency: damped frequency f_d", "decrement: logarithmic decrement δ",
        "cycles_to_half: cycles to half the amplitude", "position: displacement", "velocity",
        "half_cycles: half cycles until rest", "rest_position: comes to rest at", "stop_time: after",
    ),
    examples=(
        'dynamics vibration free --mass "2 kg" --stiffness "0.05 N/mm" --damping "4 N*s/m" --displacement "100 mm" '
        '--start-velocity "-200 mm/s" --time "0.7 s"',
        'dynamics vibration free --mass "1 kg" --stiffness "200 N/m" --friction 0.1 --displacement "50 mm"',
    ),
    plot=f"{PICTURES}:free",
)  # fmt: skip

FORCED = Task(
    "forced",
    "Steady vibration under a sine force: amplitude, phase, peak, half-power band, force to ground.",
    Model(
        "one degree of freedom",
        "dynamics_cli.vibration.single.forced:forced",
        source=BOOK + "sections 13.4 and 13.6",
        formula="{amplitude|X} = ({force|F}/k)·{magnification|H}, "
        "{magnification|H} = 1/√((1 − {ratio|r}²)² + (2·{damping_ratio|ζ}·{ratio|r})²)",
        assumptions=(LINEAR, "steady state, except the displacement at a time, which starts from rest"),
    ),
    headline=(
        "amplitude: amplitude X", "phase: lag φ", "magnification: magnification H", "ratio: frequency ratio r",
        "ground_force: force to the ground", "peak_frequency: peak at", "peak_amplitude: peak amplitude",
        "bandwidth: half-power bandwidth", "position: displacement",
    ),
    examples=(
        'dynamics vibration forced --mass "50 kg" --stiffness "200 N/mm" --damping-ratio 0.05 --force "100 N" '
        '--frequency "9 Hz"',
        'dynamics vibration forced --mass "2 kg" --natural-frequency "8 Hz" --force "5 N" --detuning 1e-6 '
        '--time "10 s"',
    ),
    plot=f"{PICTURES}:forced",
)  # fmt: skip

BASE = Task(
    "base",
    "A mass on a base that shakes: transmissibility, absolute and relative motion, isolation.",
    Model(
        "one degree of freedom",
        "dynamics_cli.vibration.single.base:base",
        source=BOOK + "section 13.6",
        formula="{transmissibility|T} = √((1 + (2·{damping_ratio|ζ}·{ratio|r})²)/((1 − {ratio|r}²)² + "
        "(2·{damping_ratio|ζ}·{ratio|r})²))",
        assumptions=(LINEAR, "the base shakes as a sine, whatever the mass does; steady state"),
    ),
    headline=(
        "transmissibility: transmissibility T", "amplitude: amplitude of the mass", "acceleration",
        "relative_amplitude: deflection of the spring", "isolation", "ratio: frequency ratio r",
        "isolates_from: isolates from", "peak_transmissibility: largest transmissibility", "peak_frequency: at",
    ),
    examples=(
        'dynamics vibration base --natural-frequency "6 Hz" --damping-ratio 0.1 --base-amplitude "0.2 mm" '
        '--frequency "25 Hz"',
        'dynamics vibration base --static-deflection "4 mm" --base-acceleration "0.5 g" --frequency "30 Hz"',
        'dynamics vibration base --mass "1200 kg" --stiffness "400 kN/m" --damping-ratio 0.5 --base-amplitude "50 mm" '
        '--road-speed "20 km/h" --wavelength "6 m"',
    ),
    plot=f"{PICTURES}:base",
)  # fmt: skip

UNBALANCE = Task(
    "unbalance",
    "A machine on mounts with a rotating unbalance: amplitude, velocity, force to ground.",
    Model(
        "one degree of freedom",
        "dynamics_cli.vibration.single.base:unbalance",
        source=BOOK + "section 13.6",
        formula="{amplitude|X} = ({unbalance|U}/{mass|M})·{ratio|r}²·H, {ground_force|F} = {unbalance|U}·ω²·"
        "{transmissibility|T}",
        assumptions=(LINEAR, "motion along one line; steady state"),
    ),
    headline=(
        "amplitude: amplitude X", "velocity: velocity (rms)", "unbalance_force: force of the unbalance",
        "ground_force: force to the ground", "transmissibility: transmissibility T", "critical_speed",
        "ratio: speed ratio r", "peak_speed: largest amplitude at", "peak_amplitude: largest amplitude",
    ),
    examples=(
        'dynamics vibration unbalance --mass "200 kg" --unbalance "2000 g*mm" --static-deflection "3 mm" '
        '--damping-ratio 0.05 --speed "1480 rpm"',
        'dynamics vibration unbalance --mass "440 lb" --unbalance "30 oz*in" --natural-frequency "8 Hz" '
        '--speed "1750 rpm" --units us',
    ),
    plot=f"{PICTURES}:unbalance",
)  # fmt: skip

ISOLATOR = Task(
    "isolator",
    "Mounts for a wanted isolation: stiffness, deflection, natural frequency.",
    Model(
        "one degree of freedom",
        "dynamics_cli.vibration.single.isolator:isolator",
        source=BOOK + "section 13.6",
        formula="{transmissibility|T}²·r⁴ + (4·{damping_ratio|ζ}²·{transmissibility|T}² − 4·{damping_ratio|ζ}² − "
        "2·{transmissibility|T}²)·r² + {transmissibility|T}² − 1 = 0",
        assumptions=(LINEAR, "the ground is rigid; the machine moves along one line"),
    ),
    headline=(
        "natural_frequency: natural frequency f_n", "static_deflection: deflection under the weight",
        "stiffness: stiffness of all mounts", "mount_stiffness: stiffness of each mount",
        "transmissibility: transmissibility T", "isolation", "ratio: frequency ratio r",
        "peak: peak at resonance",
    ),
    examples=(
        'dynamics vibration isolator --frequency "25 Hz" --isolation "90 %" --damping-ratio 0.05 --mass "400 kg" '
        '--mounts 4',
        'dynamics vibration isolator --speed "1450 rpm" --static-deflection "5 mm"',
    ),
    plot=f"{PICTURES}:isolator",
)  # fmt: skip

DECREMENT = Task(
    "decrement",
    "Damping from peaks of a decay, a record, or half-power frequencies.",
    Model(
        "logarithmic decrement",
        "dynamics_cli.vibration.single.decrement:decrement",
        source=BOOK + "section 13.5",
        formula=(
            "ln xᵢ = a − {decrement|δ}·i, {damping_ratio|ζ} = {decrement|δ}/√(4π² + {decrement|δ}²)",
            "{damping_ratio|ζ} = sin(½·atan(({upper_frequency|f₂}² − {lower_frequency|f₁}²)/"
            "({upper_frequency|f₂}² + {lower_frequency|f₁}²)))",
        ),
        assumptions=("one mode, viscous damping", "peaks are measured from the middle position"),
        method="least squares on logarithms",
    ),
    headline=(
        "damping_ratio: damping ratio ζ", "deviation: standard deviation of ζ", "decrement: logarithmic decrement δ",
        "quality: quality factor Q", "peak_ratio: peak over the one before", "natural_frequency: natural frequency",
        "peaks_used",
    ),
    examples=(
        "dynamics vibration decrement --peaks 12.1,9.8,7.9,6.5",
        'dynamics vibration decrement --lower-frequency "9.52 Hz" --upper-frequency "10.5 Hz"',
    ),
    plot=f"{PICTURES}:decrement",
)  # fmt: skip

TASKS = (FREE, FORCED, BASE, UNBALANCE, ISOLATOR, DECREMENT)
