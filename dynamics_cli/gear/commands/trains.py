"""Tasks of `dynamics gear`: trains."""

from dynamics_cli.core.task import Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
HERE = "dynamics_cli.gear."

TRAIN = Task(
    "train",
    "Speeds, torques and powers of any gear train: simple, compound, planetary, differential.",
    Model(
        "Willis",
        HERE + "train:train",
        source="Willis, Principles of Mechanism, 1841; " + BOOK + "section 17.10",
        formula="z₁·(ω₁ − ω_c) + z₂·(ω₂ − ω_c) = 0 for every mesh; {ratio|i} = ω_driver/ω_driven",
        assumptions=("no losses", "equal planets share the load as one"),
        method="whole numbers",
    ),
    examples=(
        'dynamics gear train --stages "20:60, 18:54" --speed "1500 rpm" --torque "12 N*m"',
        'dynamics gear train --sun 24 --ring 72 --planets 4 --module "2 mm" --speed "3000 rpm" --power "5 kW"',
        'dynamics gear train --sun 24 --ring 72 --fixed none --driver sun --driven carrier --speed "3000 rpm" '
        '--shaft "name=ring, speed=-100 rpm"',
        'dynamics gear train --mesh "first=a, first_teeth=99, second=planet, second_teeth=100, carrier=arm" '
        '--mesh "first=planet, first_teeth=101, second=b, second_teeth=100, carrier=arm" '
        "--driver arm --driven b --fixed a",
    ),
    table="shafts",
    arrays=False,
    tracked=False,
)

RATIO = Task(
    "ratio",
    "Best tooth numbers for a wanted ratio, every train within the limits looked at.",
    Model(
        "exhaustive search",
        HERE + "ratio:ratio",
        source="products of tooth numbers sorted and compared; ranked as exact fractions",
        formula="i = Π z_driven/Π z_driver",
        assumptions=("the sign of the ratio is that of the number of external meshes",),
        method="whole numbers",
    ),
    examples=(
        "dynamics gear ratio --target 365.2422/27.3217 --stages 3 --teeth 12..120",
        "dynamics gear ratio --target 3.14159265358979 --stages 1 --teeth 17..400 --coprime",
        'dynamics gear ratio --target 19.2 --teeth 15..90 --coaxial --coprime --largest-stage 6',
        'dynamics gear ratio --target 6.3 --teeth 17..90 --centre-distance "90 mm" --module "2 mm"',
    ),
    table="best",
    arrays=False,
    tracked=False,
)

TASKS: "tuple[Task, ...]" = (TRAIN, RATIO)
