"""Tasks of `dynamics gear`: geometry."""

from dynamics_cli.core.task import Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
HERE = "dynamics_cli.gear."
RACK = ("the flanks are those a rack generates, without allowances or deviations", "strength is not rated")

SPUR = Task(
    "spur",
    "All dimensions of one spur gear from its generating rack (strength rating is out of scope).",
    Model(
        "generating rack",
        HERE + "single:spur",
        source="ISO 21771, ISO 53; " + BOOK + "sections 17.4, 17.5",
        formula="{reference_diameter|d} = {teeth|z}·{normal_module|m}, {base_diameter|d_b} = {reference_diameter|d}·"
        "cos({pressure_angle|α}), {tip_diameter|d_a} = {reference_diameter|d} + 2·{addendum|h_a}, "
        "{root_diameter|d_f} = {reference_diameter|d} − 2·{dedendum|h_f}",
        assumptions=RACK,
    ),
    examples=(
        'dynamics gear spur --teeth 12 --module "3 mm" --profile-shift 0.6',
        'dynamics gear spur --teeth 24 --module "3 mm" --profile-shift 0.5 --internal --shift-sign khk',
        'dynamics gear spur --teeth 18 --diametral-pitch "8 1/in" --pressure-angle "14.5 deg" --units us',
        'dynamics gear spur --teeth 9 --module "2 mm" --avoid-undercut',
    ),
    arrays=False,
)

HELICAL = Task(
    "helical",
    "All dimensions of one helical gear from its generating rack (strength rating is out of scope).",
    Model(
        "generating rack",
        HERE + "single:helical",
        source="ISO 21771, ISO 53; " + BOOK + "section 17.12",
        formula="{transverse_module|m_t} = {normal_module|m_n}/cos({helix_angle|β}), {reference_diameter|d} = "
        "{teeth|z}·{transverse_module|m_t}, {base_diameter|d_b} = {reference_diameter|d}·cos("
        "{transverse_pressure_angle|α_t})",
        assumptions=RACK,
    ),
    examples=(
        'dynamics gear helical --teeth 12 --module "3 mm" --helix-angle "30 deg" --profile-shift 0.09809',
        'dynamics gear helical --teeth 20 --transverse-module "3 mm" --helix-angle "15 deg" --hand left '
        '--transverse-pressure-angle "20 deg"',
    ),
    arrays=False,
)

TASKS: "tuple[Task, ...]" = (SPUR, HELICAL)
