"""The tasks of `dynamics energy`."""

from dynamics_cli.core.answering.task import Family, Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
PICTURES = "dynamics_cli.energy.pictures"

WORK = Task(
    "work",
    "Work of forces, springs, couples, gravity, friction, measured forces.",
    Model(
        "work",
        "dynamics_cli.energy.work:work",
        source=BOOK + "sections 10.2 and 10.3",
        formula="{force|F}·{distance|s}·cos {angle|α}; ½·{stiffness|k}·(δ₁ − δ₂)·(δ₁ + δ₂); {torque|M}·{turn|θ}; "
        "−{mass|m}·{gravity|g}·{rise|h}; −{friction|μ}·{normal_force|N}·s; ∫ F dx",
        assumptions=("a table's force changes on straight lines between positions, or in steps",),
    ),
    headline=(
        "total: work of all", "constant: of the force", "couple: of the couple", "weight: of gravity",
        "rubbing: of friction", "spring: of the spring", "measured: of the measured force", "mean_force: its mean",
    ),
    examples=(
        'dynamics energy work --force "200 N" --distance "5 m" --angle "30 deg" --friction 0.3 '
        '--normal-force "400 N"',
        'dynamics energy work --measured-positions "0, 50, 100, 150, 200 mm" '
        '--measured-forces "0, 180, 240, 260, 90 N" --mass "4 kg" --rise "200 mm"',
        'dynamics energy work --spring-stiffness "12 lbf/in" --spring-start-stretch "-3 in" '
        '--spring-end-stretch "0 in" --units us',
    ),
    plot=f"{PICTURES}:work",
    arrays=False,
)  # fmt: skip

BODY = Task(
    "body",
    "Kinetic energy, momentum and angular momentum of bodies.",
    Model(
        "bodies in a plane motion",
        "dynamics_cli.energy.body:body",
        source=BOOK + "sections 9.3 to 9.6 and 10.4",
        formula="T = ½·Σ(m·v² + I·ω²), p = Σ m·v, H = Σ((r − Q) × m·v + I·ω)",
        assumptions=("every body turns about an axis parallel to z, through its mass centre",),
    ),
    headline=(
        "energy: kinetic energy",
        "translation: of the mass centres",
        "rotation: of turning",
        "inner_energy: beside the common centre",
        "momentum",
        "angular_momentum: angular momentum",
        "centre: common mass centre",
        "centre_velocity: its velocity",
    ),
    examples=(
        'dynamics energy body --body "mass=2 kg, velocity=3, 0 m/s, at=0, 1 m, inertia=0.1 kg*m^2, rotation=20 rad/s"',
        'dynamics energy body --body "mass=1500 kg, velocity=20, 0 m/s" '
        '--body "mass=900 kg, velocity=0, 12 m/s, at=2, -1 m" --about "1, 0 m"',
    ),
    arrays=False,
)

SPEED = Task(
    "speed",
    "Speed after work; the work, force or distance that a speed takes.",
    Model(
        "work and kinetic energy",
        "dynamics_cli.energy.speed:speed",
        source=BOOK + "sections 10.5 to 10.9",
        formula="½·M·(v₂² − v₁²) = W + {force|F}·{distance|s} + {mass|m}·{gravity|g}·{drop|h}, M = {mass|m} + I/r²",
        assumptions=("the force keeps its value along the way", "what turns rolls without slip"),
    ),
    headline=(
        "end_speed: speed at the end", "change: change of speed", "distance", "force", "work",
        "gravity_work: work of gravity", "start_energy: energy before", "end_energy: energy after",
        "effective_mass: mass with what turns",
    ),
    examples=(
        'dynamics energy speed --mass "1500 kg" --start-speed "25 m/s" --force "-6 kN" --distance "40 m" --drop "2 m"',
        'dynamics energy speed --mass "1500 kg" --start-speed "25 m/s" --end-speed "0 m/s" --distance "50 m"',
        'dynamics energy speed --mass "50 lb" --drop "10 ft" --rolling-inertia "0.5 slug*ft^2" --rolling-radius "8 in" '
        "--units us",
    ),
    arrays=False,
)  # fmt: skip

DROP = Task(
    "drop",
    "A mass falls or runs onto a spring: compression, force, stiffness.",
    Model(
        "energy of spring and weight",
        "dynamics_cli.energy.drop:drop",
        source=BOOK + "section 10.9",
        formula="x = δ·(1 + √(1 + 2·{height|h}/δ)), δ = {mass|m}·{gravity|g}/{stiffness|k}; level x = {speed|v}·√(m/k)",
        assumptions=("a spring without mass, damping or end of its travel", "nothing is lost as they meet"),
    ),
    headline=(
        "compression: greatest compression", "force: greatest force", "deceleration: greatest deceleration",
        "stiffness", "speed: meets it with", "top_speed: greatest speed", "rest: compressed at rest",
        "factor: force over weight", "energy: energy in the spring",
    ),
    examples=(
        'dynamics energy drop --mass "2 kg" --height "0.5 m" --stiffness "5 N/mm"',
        'dynamics energy drop --mass "800 kg" --speed "1.5 m/s" --stroke "80 mm"',
    ),
    arrays=False,
)  # fmt: skip

ROLL = Task(
    "roll",
    "A round body on a slope: does it roll or slip, and how fast.",
    Model(
        "rolling with Coulomb friction",
        "dynamics_cli.energy.roll:roll",
        source=BOOK + "section 10.9",
        formula="a = {gravity|g}·sin {angle|α}/(1 + κ), κ = I/(m·r²)",
        assumptions=("a rigid body on a rigid slope: no rolling resistance", "one coefficient at rest and slipping"),
    ),
    headline=(
        "motion", "acceleration", "needed_friction: friction needed to roll", "speed", "time",
        "rim_speed: speed of the rim", "turning_share: energy in turning", "lost_share: taken by friction",
    ),
    examples=(
        'dynamics energy roll --form disk --angle "20 deg" --distance "3 m" --friction 0.2',
        'dynamics energy roll --form sphere --angle "50 deg" --distance "10 ft" --friction 0.2 --units us',
    ),
    arrays=False,
)  # fmt: skip

POWER = Task(
    "power",
    "Power of a force or a torque, with efficiency and time.",
    Model(
        "power",
        "dynamics_cli.energy.power:power",
        source=BOOK + "section 10.4",
        formula="P = {force|F}·{speed|v}·cos {angle|α}, or {torque|M}·{rotation|ω}",
        assumptions=("force, speed and torque stay as they are",),
    ),
    headline=("power", "input_power: power put in", "loss: power lost", "energy: energy over the time"),
    examples=(
        'dynamics energy power --torque "150 N*m" --rotation "3000 rpm" --efficiency "92 %"',
        'dynamics energy power --force "400 lbf" --speed "12 ft/s" --time "30 s" --units us',
    ),
)

DRIVE = Task(
    "drive",
    "Power that a vehicle needs at a speed; the top speed of a power.",
    Model(
        "resistances of a vehicle",
        "dynamics_cli.energy.power:drive",
        source=BOOK + "section 10.4",
        formula="P = (m·g·(c_r·cos α + sin α) + ½·{density|ρ}·{drag_area|c_dA}·v² + {mass|m}·{acceleration|a})·v/"
        "{efficiency|η}",
        assumptions=("rolling resistance in proportion to the force on the road", "still air",
                     "wheels and engine add nothing to the mass"),
    ),
    headline=(
        "power", "speed", "force: force at the wheels", "rolling: rolling resistance", "climbing: of the slope",
        "drag: drag of the air", "inertia_force: to accelerate",
    ),
    examples=(
        'dynamics energy drive --mass "1500 kg" --speed "90 km/h" --slope "5 %" --rolling-resistance 0.012 '
        '--drag-area "0.7 m^2"',
        'dynamics energy drive --mass "3300 lb" --power "80 hp" --rolling-resistance 0.012 --drag-area "7.5 ft^2" '
        "--units us",
    ),
    plot=f"{PICTURES}:drive",
    arrays=False,
)  # fmt: skip

IMPULSE = Task(
    "impulse",
    "Impulse of a force over time, the speed it gives, the mean force.",
    Model(
        "impulse and momentum",
        "dynamics_cli.energy.impulse:impulse",
        source=BOOK + "sections 9.2 and 9.5",
        formula="J = ∫ F dt = {mass|m}·(v₂ − {start_speed|v₁})",
        assumptions=(
            "forces along one line",
            "a recorded force changes on straight lines, or in steps",
        ),
    ),
    headline=(
        "impulse",
        "mean_force: mean force",
        "greatest_force: largest sample",
        "duration",
        "change: change of speed",
        "end_speed: speed at the end",
        "work: change of energy",
    ),
    examples=(
        'dynamics energy impulse --times "0, 2, 5, 9, 12 ms" --forces "0, 900, 1400, 600, 0 N" --mass "0.145 kg" '
        '--start-speed "-40 m/s"',
        'dynamics energy impulse --mass "160 lb" --start-speed "30 ft/s" --end-speed "0 ft/s" --duration "120 ms" '
        "--units us",
    ),
    plot=f"{PICTURES}:impulse",
    arrays=False,
)

DRAW_IN = Task(
    "draw-in",
    "A turning body draws its mass in: its speed then, and the work.",
    Model(
        "angular momentum stays",
        "dynamics_cli.energy.impulse:draw_in",
        source=BOOK + "sections 9.7 and 10.4",
        formula="{inertia|I₁}·{rotation|ω₁} = {end_inertia|I₂}·ω₂, W = ½·I₁·ω₁²·(I₁ − I₂)/I₂",
        assumptions=("no torque about the axis",),
    ),
    headline=(
        "end_rotation: speed then",
        "work",
        "energy_ratio: energy over that before",
        "angular_momentum: angular momentum",
    ),
    examples=('dynamics energy draw-in --inertia "5 kg*m^2" --end-inertia "1.2 kg*m^2" --rotation "2 rad/s"',),
)

FAMILIES = {
    "energy": Family(
        "energy",
        "Work, power, kinetic energy, impulse and momentum.",
        WORK, BODY, SPEED, DROP, ROLL, POWER, DRIVE, IMPULSE, DRAW_IN,
    )
}  # fmt: skip
