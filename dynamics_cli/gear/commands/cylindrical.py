"""Tasks of `dynamics gear`: one cylindrical gear, pairs on parallel shafts, and the glossary."""

from dynamics_cli.core.answering.task import Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
DRAWN = {"drawing": "exact outlines, one gear at a time: dynamics gear profile … --drawing gear.dxf; a picture: --plot"}
RACK = ("the flanks are those a rack generates, without allowances or deviations", "strength is not rated")

SPUR = Task(
    "spur",
    "All dimensions of one spur gear from its generating rack (strength rating is out of scope).",
    Model(
        "generating rack",
        "dynamics_cli.gear.single.cylindrical:spur",
        source="ISO 21771, ISO 53; " + BOOK + "sections 17.4, 17.5",
        formula="{reference_diameter|d} = {teeth|z}·{normal_module|m}, {base_diameter|d_b} = {reference_diameter|d}·"
        "cos({pressure_angle|α}), {tip_diameter|d_a} = {reference_diameter|d} + 2·{addendum|h_a}, "
        "{root_diameter|d_f} = {reference_diameter|d} − 2·{dedendum|h_f}",
        assumptions=RACK,
    ),
    plot="dynamics_cli.gear.single.pictures:gear_picture",
    pointers=DRAWN,
    examples=(
        'dynamics gear spur --teeth 12 --module "3 mm" --profile-shift 0.6',
        'dynamics gear spur --teeth 18 --diametral-pitch "8 1/in" --pressure-angle "14.5 deg" --units us',
        'dynamics gear spur --teeth 24 --module "3 mm" --profile-shift 0.5 --internal --shift-sign khk',
        'dynamics gear spur --teeth 9 --module "2 mm" --avoid-undercut',
    ),
    arrays=False,
    headline=(
        "reference_diameter: reference diameter d",
        "base_diameter: base diameter d_b",
        "tip_diameter: tip diameter d_a",
        "root_diameter: root diameter d_f",
        "normal_thickness: tooth thickness s",
        "tip_thickness: tip thickness s_a",
        "profile_shift: profile shift x",
        "undercut",
    ),
)

HELICAL = Task(
    "helical",
    "All dimensions of one helical gear from its generating rack (strength rating is out of scope).",
    Model(
        "generating rack",
        "dynamics_cli.gear.single.cylindrical:helical",
        source="ISO 21771, ISO 53; " + BOOK + "section 17.12",
        formula="{transverse_module|m_t} = {normal_module|m_n}/cos({helix_angle|β}), {reference_diameter|d} = "
        "{teeth|z}·{transverse_module|m_t}, {base_diameter|d_b} = {reference_diameter|d}·cos("
        "{transverse_pressure_angle|α_t})",
        assumptions=RACK,
    ),
    plot="dynamics_cli.gear.single.pictures:gear_picture",
    pointers=DRAWN,
    examples=(
        'dynamics gear helical --teeth 12 --module "3 mm" --helix-angle "30 deg" --profile-shift 0.09809',
        'dynamics gear helical --teeth 20 --transverse-module "3 mm" --helix-angle "15 deg" --hand left '
        '--transverse-pressure-angle "20 deg"',
    ),
    arrays=False,
    headline=(
        "reference_diameter: reference diameter d",
        "tip_diameter: tip diameter d_a",
        "root_diameter: root diameter d_f",
        "transverse_module: transverse module m_t",
        "transverse_pressure_angle: transverse pressure angle α_t",
        "lead: lead p_z",
        "normal_thickness: normal tooth thickness s_n",
        "undercut",
    ),
)

INVOLUTE = Task(
    "involute",
    "Involute function and inverse, roll angle, tooth thickness at any radius, points of the curve.",
    Model(
        "involute of a circle",
        "dynamics_cli.gear.single.involute_curve:involute_point",
        source="ISO 21771, section 4; " + BOOK + "section 17.4",
        formula="{involute|inv α} = tan({pressure_angle|α}) − {pressure_angle|α}, {roll_angle|ξ} = "
        "tan({pressure_angle|α}), {diameter|d_y} = {base_diameter|d_b}/cos({pressure_angle|α})",
        method="series, no iteration",
    ),
    examples=(
        'dynamics gear involute --angle "20 deg"',
        'dynamics gear involute --diameter "45.6 mm" --base-diameter "33.8289 mm" '
        '--known-thickness "6.0227 mm" --known-diameter "36 mm" --points 5',
        "dynamics gear involute --involute 0.034316",
    ),
    plot="dynamics_cli.gear.pair.pictures:involute_curve",
    table="points",
    arrays=False,
    headline=(
        "pressure_angle: pressure angle α",
        "involute: involute inv α",
        "roll_angle: roll angle tan α",
        "diameter: diameter d_y",
        "curvature_radius: radius of curvature ρ",
        "thickness: tooth thickness s_y",
        "pointed_diameter: diameter where the tooth is pointed",
        "points: points of the curve",
    ),
)

PAIR = Task(
    "pair",
    "Two gears in mesh: distance, shifts, contact, sliding, backlash, interference, forces (no strength rating).",
    Model(
        "parallel shafts",
        "dynamics_cli.gear.pair.pair:pair",
        source="ISO 21771, sections 5 to 7; " + BOOK + "sections 17.6 to 17.8; efficiency after Ohlendorf 1958",
        formula="inv({working_pressure_angle|α_wt}) = inv(α_t) + 2·({first_profile_shift|x₁} + "
        "{second_profile_shift|x₂})·tan(α_n)/(z₁ + z₂), {centre_distance|a_w} = {reference_distance|a_d}·cos(α_t)/"
        "cos({working_pressure_angle|α_wt}), {transverse_contact_ratio|ε_α} = {path_length|g_α}/p_bt",
        assumptions=("involute flanks without deviations, rigid teeth, parallel shafts", "strength is not rated"),
    ),
    examples=(
        'dynamics gear pair --first-teeth 12 --second-teeth 24 --module "3 mm" --first-profile-shift 0.6 '
        "--second-profile-shift 0.36",
        'dynamics gear pair --first-teeth 17 --second-teeth 43 --module "2 mm" --centre-distance "61 mm" '
        "--split balanced-sliding",
        'dynamics gear pair --first-teeth 16 --second-teeth 24 --module "3 mm" --internal --second-profile-shift 0.5 '
        "--shift-sign khk",
        'dynamics gear pair --first-teeth 12 --second-teeth 60 --module "3 mm" --helix-angle "30 deg" '
        '--centre-distance "125 mm" --split first --face-width "60 mm" --power "5 kW" --speed "1450 rpm" '
        '--first-bearings-left "50 mm" --first-bearings-right "50 mm"',
    ),
    plot="dynamics_cli.gear.pair.pictures:pair",
    pointers=DRAWN,
    sheet="dynamics_cli.gear.pair.sheet:pair_sheet",
    table="points",
    arrays=False,
    headline=(
        "centre_distance: centre distance a_w",
        "working_pressure_angle: working pressure angle α_wt",
        "ratio: gear ratio u",
        "first_profile_shift: profile shift x₁",
        "second_profile_shift: profile shift x₂",
        "first_tip_diameter: tip diameter d_a1",
        "second_tip_diameter: tip diameter d_a2",
        "transverse_contact_ratio: transverse contact ratio ε_α",
        "total_contact_ratio: total contact ratio ε_γ",
        "circumferential_backlash: circumferential backlash j_wt",
        "efficiency: efficiency η",
        "forces.tangential: tangential force F_t",
        "forces.radial: radial force F_r",
        "forces.axial: axial force F_a",
    ),
)

RACK_TASK = Task(
    "rack",
    "A rack and the gear on it: dimensions, distance, contact ratio, travel, forces (no strength rating).",
    Model(
        "gear and rack",
        "dynamics_cli.gear.pair.rack:rack",
        source="ISO 53, ISO 21771; " + BOOK + "section 17.9",
        formula="{datum_distance|a} = {reference_diameter|d}/2 + x·m_n, {travel|s} = z·{pitch|p_t}, "
        "{transverse_contact_ratio|ε_α} = ({approach_length|g_f} + {recess_length|g_a})/p_bt",
        assumptions=("no backlash, no deviations", "strength is not rated"),
    ),
    plot="dynamics_cli.gear.single.pictures:rack_picture",
    pointers=DRAWN,
    examples=(
        'dynamics gear rack --teeth 12 --module "3 mm" --profile-shift 0.6 --datum-height "32 mm"',
        'dynamics gear rack --teeth 20 --transverse-module "2 mm" --helix-angle "20 deg" --speed "120 rpm" '
        '--torque "15 N*m"',
    ),
    arrays=False,
    headline=(
        "mounting_distance: axis to back of the rack",
        "datum_distance: axis to datum line a",
        "pitch: pitch p_t",
        "travel: travel in one turn",
        "transverse_contact_ratio: transverse contact ratio ε_α",
        "rack_speed: speed of the rack",
        "tangential_force: tangential force F_t",
        "radial_force: radial force F_r",
    ),
)

GLOSSARY = Task(
    "glossary",
    "The terms of gearing with symbol, other names and formula.",
    Model(
        "words",
        "dynamics_cli.gear.glossary:glossary",
        source=BOOK + "section 17.16 for the terms (definitions in our own words); symbols of ISO 21771",
        method="a table",
    ),
    examples=("dynamics gear glossary", "dynamics gear glossary backlash 'base pitch'"),
    table="entries",
    listing=True,
    arrays=False,
    tracked=False,
    headline=("meaning", "entries: terms"),
)

DATA_BLOCK = Task(
    "data-block",
    "The table that goes on a gear drawing, with inspection sizes; as table, Markdown or CSV.",
    Model(
        "generating rack",
        "dynamics_cli.gear.measure.data_block:data_block",
        source="ISO 1340, ISO 21771",
        assumptions=RACK,
    ),
    examples=(
        'dynamics gear data-block --teeth 24 --module "3 mm" --profile-shift 0.4 --accuracy "ISO 1328-1 grade 7" '
        "--format markdown",
        'dynamics gear data-block --teeth 31 --module "3.5 mm" --helix-angle "21 deg" --hand left --mate-teeth 30 '
        '--centre-distance "116.5 mm" --upper-allowance "-0.07 mm" --lower-allowance "-0.11 mm"',
    ),
    table="rows",
    arrays=False,
    tracked=False,
    headline=("rows: gear data",),
)
