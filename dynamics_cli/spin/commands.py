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
        source=BOOK + "section 14.4",
        formula="{torque|M} = {precession|Ω}·sin {angle|θ}·({axial|C}·({spin|s} + {precession|Ω}·cos {angle|θ}) "
        "− {transverse|A}·{precession|Ω}·cos {angle|θ})",
        assumptions=("the rotor is alike in all directions across its axis", "both rates and the angle are steady"),
    ),
    headline=(
        "torque: gyroscopic torque", "sense", "bearing_force: force on each bearing",
        "simple_torque: spin times precession alone", "angular_momentum: angular momentum of the spin",
    ),
    examples=(
        'dynamics spin gyro --axial "0.03 kg*m^2" --transverse "0.02 kg*m^2" --spin "3000 rpm" '
        '--precession "2 rad/s" --angle "60 deg" --span "200 mm"',
        'dynamics spin gyro --axial "0.4 slug*ft^2" --transverse "0.25 slug*ft^2" --spin "2400 rpm" '
        '--precession "20 deg/s" --span "18 in" --units us',
    ),
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
    ),
    examples=(
        'dynamics spin free --moments "1, 2, 3 kg*m^2" --angular-velocity "0.2, 1, 0.5 rad/s"',
        'dynamics spin free --moments "1, 2, 3 kg*m^2" --angular-velocity "1e-6, 1, 0 rad/s"',
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
        source=BOOK + "section 14.4",
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
    arrays=False,
)  # fmt: skip

FAMILIES = {"spin": Family("spin", "Spinning bodies: gyroscopes, free bodies, tops.", GYRO, FREE, TOP)}
