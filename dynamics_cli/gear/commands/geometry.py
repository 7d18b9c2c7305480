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
    plot=HERE + "single_pictures:gear_picture",
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
    plot=HERE + "single_pictures:gear_picture",
    examples=(
        'dynamics gear helical --teeth 12 --module "3 mm" --helix-angle "30 deg" --profile-shift 0.09809',
        'dynamics gear helical --teeth 20 --transverse-module "3 mm" --helix-angle "15 deg" --hand left '
        '--transverse-pressure-angle "20 deg"',
    ),
    arrays=False,
)

INVOLUTE = Task(
    "involute",
    "Involute function and inverse, roll angle, tooth thickness at any radius, points of the curve.",
    Model(
        "involute of a circle",
        HERE + "curve:involute_point",
        source="ISO 21771, section 4; " + BOOK + "section 17.4",
        formula="{involute|inv α} = tan({pressure_angle|α}) − {pressure_angle|α}, {roll_angle|ξ} = "
        "tan({pressure_angle|α}), {diameter|d_y} = {base_diameter|d_b}/cos({pressure_angle|α})",
        method="series, no iteration",
    ),
    examples=(
        'dynamics gear involute --angle "20 deg"',
        "dynamics gear involute --involute 0.034316",
        'dynamics gear involute --diameter "45.6 mm" --base-diameter "33.8289 mm" '
        '--known-thickness "6.0227 mm" --known-diameter "36 mm" --points 5',
    ),
    plot=HERE + "pair_pictures:involute_curve",
    table="points",
    arrays=False,
)

PAIR = Task(
    "pair",
    "Two gears in mesh: distance, shifts, contact, sliding, backlash, interference, forces (no strength rating).",
    Model(
        "parallel shafts",
        HERE + "pair:pair",
        source="ISO 21771, sections 5 to 7; " + BOOK + "sections 17.6 to 17.8; efficiency after Ohlendorf 1958",
        formula="inv({working_pressure_angle|α_wt}) = inv(α_t) + 2·({first_profile_shift|x₁} + "
        "{second_profile_shift|x₂})·tan(α_n)/(z₁ + z₂), {centre_distance|a_w} = {reference_distance|a_d}·cos(α_t)/"
        "cos({working_pressure_angle|α_wt}), {transverse_contact_ratio|ε_α} = {path_length|g_α}/p_bt",
        assumptions=("involute flanks without deviations, rigid teeth, parallel shafts", "strength is not rated"),
    ),
    examples=(
        'dynamics gear pair --first-teeth 12 --second-teeth 24 --module "3 mm" --first-profile-shift 0.6 '
        "--second-profile-shift 0.36",
        'dynamics gear pair --first-teeth 16 --second-teeth 24 --module "3 mm" --internal --second-profile-shift 0.5 '
        "--shift-sign khk",
        'dynamics gear pair --first-teeth 12 --second-teeth 60 --module "3 mm" --helix-angle "30 deg" '
        '--centre-distance "125 mm" --split first --face-width "60 mm" --power "5 kW" --speed "1450 rpm" '
        '--first-bearings-left "50 mm" --first-bearings-right "50 mm"',
        'dynamics gear pair --first-teeth 17 --second-teeth 43 --module "2 mm" --centre-distance "61 mm" '
        "--split balanced-sliding",
    ),
    plot=HERE + "pair_pictures:pair",
    table="points",
    arrays=False,
)

RACK_TASK = Task(
    "rack",
    "A rack and the gear on it: dimensions, distance, contact ratio, travel, forces (no strength rating).",
    Model(
        "gear and rack",
        HERE + "rack:rack",
        source="ISO 53, ISO 21771; " + BOOK + "section 17.9",
        formula="{datum_distance|a} = {reference_diameter|d}/2 + x·m_n, {travel|s} = z·{pitch|p_t}, "
        "{transverse_contact_ratio|ε_α} = ({approach_length|g_f} + {recess_length|g_a})/p_bt",
        assumptions=("no backlash, no deviations", "strength is not rated"),
    ),
    plot=HERE + "single_pictures:rack_picture",
    examples=(
        'dynamics gear rack --teeth 12 --module "3 mm" --profile-shift 0.6 --datum-height "32 mm"',
        'dynamics gear rack --teeth 20 --transverse-module "2 mm" --helix-angle "20 deg" --speed "120 rpm" '
        '--torque "15 N*m"',
    ),
    arrays=False,
)

BEVEL = Task(
    "bevel",
    "A bevel pair at any shaft angle: straight, spiral or zerol, crown and internal wheels (no strength rating).",
    Model(
        "pitch cones",
        HERE + "bevel:bevel",
        source="ISO 23509; Gleason proportions as handbooks print them; " + BOOK + "section 17.13",
        formula="{first.pitch_angle|δ₁} = atan2(sin({shaft_angle|Σ}), {ratio|u} + cos({shaft_angle|Σ})), "
        "{cone_distance|R_e} = {first.pitch_diameter|d_e1}/(2·sin({first.pitch_angle|δ₁}))",
        assumptions=("tip and root cones with constant clearance, unless standard", "strength is not rated"),
    ),
    plot=HERE + "axes_pictures:bevel",
    examples=(
        'dynamics gear bevel --first-teeth 20 --second-teeth 40 --module "3 mm" --face-width "22 mm"',
        'dynamics gear bevel --first-teeth 20 --second-teeth 40 --module "3 mm" --face-width "20 mm" --kind spiral '
        '--torque "20 N*m"',
        'dynamics gear bevel --first-teeth 20 --second-teeth 20 --module "2 mm" --face-width "7 mm" '
        '--shaft-angle "120 deg" --kind standard',
    ),
    arrays=False,
)

CROSSED = Task(
    "crossed",
    "Crossed helical (screw) gears: distance, working helices, shaft angle, sliding, efficiency (no strength rating).",
    Model(
        "virtual spur gears",
        HERE + "crossed:crossed",
        source="KHK gear technical reference, screw gears; " + BOOK + "section 17.14",
        formula="{centre_distance|a_w} = {reference_distance|a_d} + {distance_modification|y}·{module|m_n}, "
        "{shaft_angle|Σ} = |{first_working_helix|β_w1} + {second_working_helix|β_w2}|",
        assumptions=("exact when the profile shifts sum to zero", "friction at the pitch point"),
    ),
    plot=HERE + "axes_pictures:crossed",
    examples=(
        'dynamics gear crossed --first-teeth 15 --first-helix-angle "20 deg" --first-profile-shift 0.4 '
        '--second-teeth 24 --second-helix-angle "30 deg" --second-profile-shift 0.2 --module "3 mm"',
        'dynamics gear crossed --first-teeth 13 --first-helix-angle "45 deg" --second-teeth 26 '
        '--second-helix-angle "45 deg" --module "2 mm" --speed "600 rpm"',
    ),
    arrays=False,
)

WORM = Task(
    "worm",
    "A worm pair: geometry, lead angle, efficiency both ways, self-locking, forces (no strength rating).",
    Model(
        "inclined plane",
        HERE + "worm:worm",
        source="DIN 3975; " + BOOK + "section 17.14",
        formula="{lead_angle|γ} = atan({axial_module|m_x}·{threads|z₁}/{worm_diameter|d₁}), {efficiency|η} = "
        "tan({lead_angle|γ})/tan({lead_angle|γ} + {friction_angle|ρ'}), {backward_efficiency|η'} = "
        "tan({lead_angle|γ} − {friction_angle|ρ'})/tan({lead_angle|γ})",
        assumptions=("shafts at right angles", "friction at the pitch point only", "strength is not rated"),
    ),
    plot=HERE + "axes_pictures:worm",
    examples=(
        'dynamics gear worm --threads 2 --teeth 30 --module "3 mm" --worm-diameter "44 mm"',
        'dynamics gear worm --threads 1 --teeth 40 --module "4 mm" --diameter-factor 10 --friction 0.12 '
        '--speed "1450 rpm" --power "2 kW"',
        'dynamics gear worm --threads 4 --teeth 40 --normal-module "4 mm" --lead-angle "20 deg"',
    ),
    arrays=False,
)

HYPOID = Task(
    "hypoid",
    "Pitch-point geometry of a hypoid pair: cones, offset and spiral angles, sliding, limit pressure angle.",
    Model(
        "pitch cones in contact",
        HERE + "hypoid:hypoid",
        source="Wildhaber 1946; ISO 23509; " + BOOK + "section 17.14",
        formula="sin({axial_offset_angle|η}) = {offset|E}/({wheel_radius|r₂} + {first_pitch_radius|r₁}·"
        "cos({second_pitch_angle|δ₂})/cos({first_pitch_angle|δ₁})), {second_spiral_angle|β₂} = "
        "{first_spiral_angle|β₁} − {pitch_offset_angle|ε'}",
        assumptions=("the pitch angle of the wheel is the user's choice", "strength is not rated"),
        method="bracketed root, one tracked Newton step",
    ),
    plot=HERE + "axes_pictures:hypoid",
    examples=(
        'dynamics gear hypoid --first-teeth 10 --second-teeth 41 --offset "35 mm" --wheel-radius "85 mm"',
        'dynamics gear hypoid --first-teeth 13 --second-teeth 38 --offset "20 mm" --wheel-radius "70 mm" '
        '--wheel-pitch-angle "68 deg" --pinion-spiral-angle "45 deg" --speed "3000 rpm"',
    ),
    arrays=False,
)

WHEELS = Task(
    "wheels",
    "Rolling wheels and belts: speeds, belt length and wrap, what friction carries.",
    Model(
        "rolling without slip",
        HERE + "wheels:wheels",
        source=BOOK + "section 17.2; Euler's belt formula",
        formula=(
            "{belt_length|L} = 2·{span|s} + {first_diameter|d₁}/2·{first_wrap|θ₁} + "
            "{second_diameter|d₂}/2·{second_wrap|θ₂}",
            "{ratio|ω₁/ω₂} = ∓{second_diameter|d₂}/{first_diameter|d₁}",
        ),
        assumptions=("rigid wheels, an inextensible and flexible belt", "no slip"),
    ),
    plot=HERE + "axes_pictures:wheels",
    examples=(
        'dynamics gear wheels --first-diameter "100 mm" --second-diameter "300 mm" --drive open-belt '
        '--centre-distance "500 mm" --speed "1450 rpm" --power "2 kW" --friction 0.3',
        'dynamics gear wheels --first-diameter "4 in" --second-diameter "10 in" --speed "300 rpm" --units us',
    ),
    arrays=False,
)

GLOSSARY = Task(
    "glossary",
    "The terms of gearing with symbol, other names and formula.",
    Model(
        "words",
        HERE + "glossary:glossary",
        source=BOOK + "section 17.16 (the terms; the words are ours); symbols of ISO 21771",
        method="a table",
    ),
    examples=("dynamics gear glossary", "dynamics gear glossary backlash 'base pitch'"),
    table="entries",
    arrays=False,
    tracked=False,
)

DATA_BLOCK = Task(
    "data-block",
    "The table that goes on a gear drawing, with inspection sizes; as table, Markdown or CSV.",
    Model(
        "generating rack",
        HERE + "data_block:data_block",
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
)

TASKS: "tuple[Task, ...]" = (
    SPUR,
    HELICAL,
    INVOLUTE,
    PAIR,
    RACK_TASK,
    BEVEL,
    CROSSED,
    WORM,
    HYPOID,
    WHEELS,
    GLOSSARY,
    DATA_BLOCK,
)
