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

TASKS: "tuple[Task, ...]" = (TRAIN,)
