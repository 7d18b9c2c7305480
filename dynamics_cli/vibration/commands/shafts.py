"""Tasks of `dynamics vibration` about shafts and rotors."""

from dynamics_cli.core.answering.task import Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
PICTURES = "dynamics_cli.vibration.shafts.pictures"

SHAFT = Task(
    "shaft",
    "Torsional vibration of a shaft line with gears and branches; critical speeds by order.",
    Model(
        "torsional line",
        "dynamics_cli.vibration.shafts.shaft:shaft",
        source=BOOK + "section 13.7; Holzer's method",
        formula="(K − ω²·J)·φ = 0, reduced to the reference's speed; n = 60·f/h",
        assumptions=("massless shafts between rigid rotors", "gears without backlash, their teeth rigid"),
        method="one-sided Jacobi on the factor",
    ),
    headline=(
        "first_frequency: natural frequency f₁", "critical_speed: critical speed", "rotors",
        "modes_below: modes below",
        "modes: modes | number=mode, frequency, nodes, damping_ratio=ζ, twisted=most twisted, angles",
        "criticals: critical speeds | speed, order, mode, frequency, place=running",
    ),
    examples=(
        'dynamics vibration shaft --rotor "name=motor, inertia=0.5 kg*m^2" --rotor "name=pinion, inertia=0.01 kg*m^2" '
        '--rotor "name=wheel, inertia=0.3 kg*m^2" --rotor "name=drum, inertia=4 kg*m^2" '
        '--shaft "from=motor, to=pinion, stiffness=2000 N*m/rad" --shaft "from=wheel, to=drum, stiffness=9000 N*m/rad" '
        '--gear "driver=pinion, driven=wheel, driver_teeth=20, driven_teeth=60" --orders 1,2 --lowest-speed "300 rpm" '
        '--highest-speed "1500 rpm"',
    ),
    scene={
        "rotors[0].name": "motor", "rotors[0].inertia": "0.5 kg*m^2", "rotors[1].name": "drum",
        "rotors[1].inertia": "4 kg*m^2", "shafts[0].from": "motor", "shafts[0].to": "drum",
        "shafts[0].stiffness": "2000 N*m/rad",
    },
    table="modes",
    plot=f"{PICTURES}:shaft",
    arrays=False,
    tracked=False,
)  # fmt: skip

ROTOR_PICTURES = "dynamics_cli.vibration.rotors.pictures"
ROTORS = "dynamics_cli.vibration.shafts.rotor_pictures"

ABSORBER = Task(
    "absorber",
    "Tuned mass absorber: Den Hartog's tuning or the least peak, and the peaks that result.",
    Model(
        "damped absorber on an undamped machine",
        "dynamics_cli.vibration.shafts.absorber:absorber",
        source="Den Hartog, Mechanical Vibrations; least peak after Nishihara & Asami (2002)",
        formula="{frequency_ratio|f} = 1/(1 + {mass_ratio|μ}), {damping_ratio|ζ}² = 3·{mass_ratio|μ}/(8·(1 + "
        "{mass_ratio|μ}))",
        assumptions=("the machine has no damping of its own", "a sine force acts on the machine"),
    ),
    headline=(
        "frequency_ratio: frequency ratio f", "damping_ratio: damping ratio ζ (absorber alone)",
        "lower_peak: first peak", "lower_ratio: at", "upper_peak: second peak", "upper_ratio: at",
        "frequency: tune the absorber to", "stiffness: spring", "damping: damper",
    ),
    examples=(
        'dynamics vibration absorber --mass "200 kg" --absorber-mass "10 kg" --natural-frequency "12 Hz"',
        "dynamics vibration absorber --mass-ratio 0.05 --tuning minimax",
    ),
    plot=f"{ROTORS}:absorber",
)  # fmt: skip

BEAM = Task(
    "beam",
    "Bending frequencies, shapes and nodes of a uniform beam by its ends.",
    Model(
        "Euler–Bernoulli beam",
        "dynamics_cli.vibration.shafts.beam:beam",
        source="Thomson, Theory of Vibration with Applications, appendix D",
        formula="{first_frequency|f} = (βL)²/(2π·{length|L}²)·√({elastic_modulus|E}·I/m)",
        assumptions=("slender and uniform; shear and rotary inertia are neglected", "small deflections"),
    ),
    headline=(
        "first_frequency: lowest frequency", "modes: modes | number=mode, frequency, root=βL, nodes=nodes at x/L",
    ),
    examples=(
        'dynamics vibration beam --ends clamped-free --length "800 mm" --width "40 mm" --height "10 mm"',
        'dynamics vibration beam --ends pinned-pinned --length "6 ft" --diameter "2 in" --bore "1.5 in" --units us',
    ),
    table="modes",
    plot=f"{ROTORS}:beam",
)  # fmt: skip

WHIRL = Task(
    "whirl",
    "A disk on a flexible shaft: critical speeds, whirl; Campbell diagram of a disk that tilts.",
    Model(
        "Jeffcott rotor",
        "dynamics_cli.vibration.shafts.whirl:whirl",
        source="Jeffcott, Phil. Mag. 37 (1919) 304; " + BOOK + "section 13.6",
        formula="{critical_speed|Ω_c} = √({stiffness|k}/{mass|m}), {amplitude|w} = {eccentricity|e}·r²/√((1 − r²)² + "
        "(2·{damping_ratio|ζ}·r)²)",
        assumptions=("a massless shaft in rigid, short bearings", "external damping; none inside the shaft",
                     "the amplitude is of a disk that does not tilt"),
    ),
    headline=(
        "critical_speed", "amplitude: whirl of the shaft", "phase: lag", "ratio: speed over critical",
        "bearing_force: force on both bearings", "peak_amplitude: whirl at the critical speed", "static_deflection",
        "criticals: critical speeds | speed, order, whirl, mode, frequency",
        "campbell: over speed | speed, first_backward=1 backward, first_forward=1 forward, "
        "second_backward=2 backward, second_forward=2 forward",
    ),
    examples=(
        'dynamics vibration whirl --mass "30 kg" --diameter "40 mm" --length "900 mm" --position "300 mm" '
        '--eccentricity "20 um" --speed "3600 rpm" --damping-ratio 0.02 --polar-inertia "0.5 kg*m^2" '
        '--diametral-inertia "0.25 kg*m^2" --orders 1,2',
        'dynamics vibration whirl --mass "30 kg" --stiffness "4000 N/mm" --eccentricity "20 um" --speed "1500 rpm"',
    ),
    plot=f"{ROTORS}:whirl",
)  # fmt: skip

ROTOR = Task(
    "rotor",
    "Critical speeds, whirl and Campbell diagram of a stepped shaft with disks on bearings.",
    Model(
        "beam elements with gyroscopic moments",
        "dynamics_cli.vibration.rotors.rotor:rotor",
        source="Timoshenko beam, shear coefficient of Cowper",
        formula="(K + λΩ·G − λ²·M)·z = 0; K·z = λ²·(M ∓ G/h)·z at λ = ±hΩ",
        assumptions=(
            "a round shaft with shear and rotary inertia; rigid disks",
            "bearings alike in every direction; no damping",
        ),
        method="beam elements, symmetric eigenvalues",
    ),
    headline=(
        "critical_speed: first critical speed (unbalance)", "margin: running speed over the nearest",
        "mass: mass of the rotor",
        "criticals: critical speeds | speed, order, whirl, mode, frequency",
        "whirls: at the running speed | mode, backward, forward",
    ),
    examples=(
        'dynamics vibration rotor --section "length=200 mm, diameter=50 mm" --section "length=500 mm, diameter=65 mm" '
        '--section "length=300 mm, diameter=50 mm" --bearing "position=60 mm, stiffness=80 kN/mm" '
        '--bearing "position=750 mm, stiffness=60 kN/mm" --disk "position=400 mm, mass=35 kg, '
        'polar-inertia=0.8 kg*m^2" '
        '--disk "position=970 mm, mass=12 kg, polar-inertia=0.2 kg*m^2" --speed "3000 rpm"',
        'dynamics vibration rotor --length "1 m" --diameter "40 mm" --bearing "position=0 m" --bearing "position=1 m"',
    ),
    scene={
        "sections[0].length": "800 mm", "sections[0].diameter": "50 mm", "bearings[0].position": "0 mm",
        "bearings[1].position": "800 mm", "disks[0].position": "300 mm", "disks[0].mass": "30 kg",
    },
    table="criticals whirls campbell",
    plot=f"{ROTOR_PICTURES}:rotor",
    arrays=False,
    tracked=False,
    points=400,
)  # fmt: skip

ROTOR_RESPONSE = Task(
    "rotor-response",
    "A rotor on real bearings: response to unbalance, logarithmic decrements, onset of instability.",
    Model(
        "beam elements in two planes",
        "dynamics_cli.vibration.rotors.response:rotor_response",
        source="Timoshenko beam, shear coefficient of Cowper",
        formula="M·q̈ + (C + Ω·J)·q̇ + (K + Ω·S)·q = Ω²·u·e^(iΩt); δ = −2π·σ/ω for e^(σt + iωt)",
        assumptions=(
            "a round shaft with shear and rotary inertia, without damping of its own; rigid disks",
            "coefficients of bearings hold at every speed",
        ),
        method="beam elements, lowest modes with static corrections",
    ),
    headline=(
        "critical_speed: first peak of the response", "amplitude: largest amplitude at the running speed",
        "force: largest force on a bearing",
        "stable_to: stable at least to", "onset: unstable from", "onset_frequency: by a whirl of",
        "decrement: least logarithmic decrement",
        "peaks: peaks | position, speed, horizontal, vertical, major=long half axis, whirl",
        "orbits: at the running speed | position, horizontal, horizontal_lag=lag, vertical, vertical_lag=lag, whirl",
    ),
    examples=(
        'dynamics vibration rotor-response --section "length=1 m, diameter=60 mm" '
        '--bearing "position=50 mm, kxx=40 kN/mm, kyy=90 kN/mm, cxx=20 kN*s/m" '
        '--bearing "position=950 mm, kxx=40 kN/mm, kyy=90 kN/mm, cxx=20 kN*s/m" '
        '--disk "position=400 mm, mass=35 kg, polar-inertia=0.8 kg*m^2" '
        '--unbalance "position=400 mm, unbalance=500 g*mm" --speed "3000 rpm"',
    ),
    scene={
        "sections[0].length": "800 mm", "sections[0].diameter": "50 mm", "bearings[0].position": "0 mm",
        "bearings[0].kxx": "40 kN/mm", "bearings[0].kyy": "90 kN/mm", "bearings[0].cxx": "20 kN*s/m",
        "bearings[1].position": "800 mm", "bearings[1].kxx": "40 kN/mm", "bearings[1].kyy": "90 kN/mm",
        "bearings[1].cxx": "20 kN*s/m", "disks[0].position": "300 mm", "disks[0].mass": "30 kg",
        "unbalances[0].position": "300 mm", "unbalances[0].unbalance": "500 g*mm", "speed": "3000 rpm",
    },
    table="orbits peaks over_speed campbell",
    plot=f"{ROTOR_PICTURES}:rotor_response",
    arrays=False,
    tracked=False,
    points=100,
)  # fmt: skip

TASKS = (SHAFT, ABSORBER, BEAM, WHIRL, ROTOR, ROTOR_RESPONSE)
