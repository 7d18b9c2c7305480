"""The tasks of `dynamics spin`."""

from dynamics_cli.core.answering.task import Family, Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
PICTURES = "dynamics_cli.spin.pictures"

GYRO = Task(
    "gyro",
    "Gyroscopic torque of a rotor whose axis turns, and its bearing forces.",
    Model(
        "steady precession",
        "dynamics_cli.spin.gyro:gyro",
        source="Euler's equations",
        formula=(
            "{torque|M} = {precession|Ω}·sin {angle|θ}·(C·({spin|s} + {precession|Ω}·cos {angle|θ}) "
            "− A·{precession|Ω}·cos {angle|θ})",
            "{torque|M} = C·{spin|s}·{precession|Ω}",
        ),
        assumptions=("the rotor is alike in all directions across its axis", "both rates and the angle are steady"),
    ),
    headline=(
        "torque: gyroscopic torque", "sense", "bearing_force: force on each bearing",
        "simple_torque: spin times precession alone", "angular_momentum: angular momentum of the spin",
    ),
    examples=(
        'dynamics spin gyro --axial "0.03 kg*m^2" --transverse "0.02 kg*m^2" --spin "3000 rpm" '
        '--precession "2 rad/s" --angle "60 deg" --span "200 mm"',
        'dynamics spin gyro --mass "5 kg" --radius "100 mm" --spin "10000 rpm" --precession "2 rad/s"',
        'dynamics spin gyro --axial "0.4 slug*ft^2" --spin "2400 rpm" '
        '--precession "20 deg/s" --span "18 in" --units us',
    ),
    plot=f"{PICTURES}:gyro",
    arrays=False,
)  # fmt: skip

FREE = Task(
    "free",
    "A rigid body turning without torque: period, nutation, precession.",
    Model(
        "Euler's equations without torque",
        "dynamics_cli.spin.free:free",
        source=BOOK + "section 14.4",
        formula="{period|T} = 2π/M(λ, λ′), M the arithmetic–geometric mean",
        assumptions=("the body is rigid", "no torque about its centre of mass"),
    ),
    headline=(
        "motion", "period", "greatest: greatest components", "least: least components",
        "least_nutation: least nutation", "greatest_nutation: greatest nutation",
        "least_precession: least precession", "greatest_precession: greatest precession",
        "growth: growth about the middle axis", "angular_momentum", "energy",
        "principal_moments", "axes[0]: principal axis 1", "axes[1]: principal axis 2", "axes[2]: principal axis 3",
    ),
    examples=(
        'dynamics spin free --moments "1, 2, 3 kg*m^2" --angular-velocity "0.2, 1, 0.5 rad/s"',
        'dynamics spin free --tensor "2, -0.5, 0; -0.5, 2, 0; 0, 0, 3 kg*m^2" --angular-velocity "0.2, 1, 0.5 rad/s"',
    ),
    plot=f"{PICTURES}:free",
    arrays=False,
)  # fmt: skip

TOP = Task(
    "top",
    "A spinning top: slow and fast precession, nutation, sleeping limit.",
    Model(
        "heavy symmetric top",
        "dynamics_cli.spin.top:top",
        source="Euler's equations",
        formula="{transverse|A}·cos {tilt|θ}·Ω² − {axial|C}·{spin|n}·Ω + {mass|m}·{gravity|g}·{distance|ℓ} = 0",
        assumptions=("it stands on a fixed point without friction", "alike in all directions across its axis"),
    ),
    headline=(
        "slow: slow precession", "fast: fast precession", "nutation: nutation about the slow one",
        "lowest_tilt: let go at rest it dips to", "least_spin: steady precession from", "upright",
        "sleeping_spin: it sleeps from",
    ),
    examples=(
        'dynamics spin top --mass "0.5 kg" --distance "60 mm" --axial "6e-4 kg*m^2" '
        '--transverse "2.5e-3 kg*m^2" --spin "200 rad/s" --tilt "30 deg"',
        'dynamics spin top --mass "0.5 kg" --distance "60 mm" --axial "6e-4 kg*m^2" '
        '--transverse "2.5e-3 kg*m^2" --spin "800 rpm"',
    ),
    plot=f"{PICTURES}:top",
    arrays=False,
)  # fmt: skip

SHAFT = Task(
    "shaft",
    "Bearing loads of a rotor that is off its axis or skewed on its shaft.",
    Model(
        "rigid rotor on a rigid shaft",
        "dynamics_cli.spin.shaft:shaft",
        source=BOOK + "sections 8.8 and 15.3",
        formula=(
            "{force|F} = {mass|m}·{eccentricity|e}·{speed|Ω}²",
            "{couple|K} = |C − A|·{speed|Ω}²·sin β·cos β",
        ),
        assumptions=(
            "shaft and bearings are rigid", "the weight is left out",
            "angles turn with the shaft, counted from the eccentricity",
        ),
    ),
    headline=(
        "left_load: load on the left bearing", "left_angle: its direction", "right_load: load on the right bearing",
        "right_angle: its direction", "force: centrifugal force", "couple: couple of the skew",
        "unbalance", "couple_unbalance: couple unbalance",
    ),
    examples=(
        'dynamics spin shaft --mass "10 kg" --speed "3000 rpm" --span "400 mm" --position "150 mm" --skew "2 deg" '
        '--axial "0.2 kg*m^2" --transverse "0.1 kg*m^2" --eccentricity "50 um" --skew-direction "90 deg"',
        'dynamics spin shaft --mass "22 lb" --speed "3600 rpm" --span "16 in" --position "20 in" '
        '--eccentricity "2 mil" --units us',
    ),
    plot="dynamics_cli.spin.rotor_pictures:shaft",
    arrays=False,
)  # fmt: skip

DISK = Task(
    "disk",
    "A disk or hoop on the floor: least speeds of rolling and pivoting, steady turns.",
    Model(
        "thin disk without slip",
        "dynamics_cli.spin.disk:disk",
        source=BOOK + "sections 8.13 and 14.5",
        formula="(C + m·{radius|r}²)·{spin|ω}·{turn|φ̇}·sin θ = A·{turn|φ̇}²·sin θ·cos θ − m·g·{radius|r}·cos θ",
        assumptions=("thin, on a level floor", "it does not slip"),
    ),
    headline=(
        "upright: upright rolling", "growth: it falls at", "rolling_limit: rolls stably above",
        "pivoting_limit: pivots stably above", "spin: steady turn, spin", "path_radius: circle of its centre",
        "needed_friction: friction it needs",
    ),
    examples=(
        'dynamics spin disk --radius "300 mm" --roll "3 rad/s" --lean "20 deg" --turn "1.5 rad/s"',
        'dynamics spin disk --radius "12 in" --wheel hoop --roll "40 rpm" --units us',
    ),
    plot=f"{PICTURES}:disk",
    arrays=False,
)  # fmt: skip

ROD = Task(
    "rod",
    "A rod pinned to a turning vertical shaft: critical speed, angle, frequency.",
    Model(
        "pinned rod",
        "dynamics_cli.spin.rod:rod",
        source=BOOK + "section 8.12",
        formula="cos {angle|θ} = 3·{gravity|g}/(2·{length|L}·{speed|Ω}²)",
        assumptions=("a uniform rod, its pin level and on the axis of the shaft", "the shaft turns at a steady speed"),
    ),
    headline=(
        "motion", "angle: angle from the vertical", "frequency", "critical: stands out above",
        "pin_force: force of the pin",
    ),
    examples=(
        'dynamics spin rod --length "0.8 m" --speed "7 rad/s" --mass "2 kg"',
        'dynamics spin rod --length "30 in" --speed "40 rpm" --units us',
    ),
    arrays=False,
)  # fmt: skip

FAMILIES = {
    "spin": Family("spin", "Spinning bodies: gyroscopes, free bodies, tops, disks.", GYRO, FREE, TOP, SHAFT, DISK, ROD)
}
