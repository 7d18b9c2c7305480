"""Tasks of `dynamics gear`: shafts that meet or cross, and rolling wheels."""

from dynamics_cli.core.answering.task import Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "

BEVEL = Task(
    "bevel",
    "A bevel pair at any shaft angle: straight, spiral or zerol, crown and internal wheels (no strength rating).",
    Model(
        "pitch cones",
        "dynamics_cli.gear.crossing.bevel:bevel",
        source="ISO 23509; Gleason proportions as handbooks print them; " + BOOK + "section 17.13",
        formula="{first.pitch_angle|δ₁} = atan2(sin({shaft_angle|Σ}), {ratio|u} + cos({shaft_angle|Σ})), "
        "{cone_distance|R_e} = {first.pitch_diameter|d_e1}/(2·sin({first.pitch_angle|δ₁}))",
        assumptions=("tip and root cones with constant clearance, unless standard", "strength is not rated"),
    ),
    plot="dynamics_cli.gear.crossing.pictures:bevel",
    examples=(
        'dynamics gear bevel --first-teeth 20 --second-teeth 40 --module "3 mm" --face-width "22 mm"',
        'dynamics gear bevel --first-teeth 20 --second-teeth 40 --module "3 mm" --face-width "20 mm" --kind spiral '
        '--torque "20 N*m"',
        'dynamics gear bevel --first-teeth 20 --second-teeth 20 --module "2 mm" --face-width "7 mm" '
        '--shaft-angle "120 deg" --kind standard',
    ),
    arrays=False,
    headline=(
        "first.pitch_angle: pitch angle of the pinion δ_1",
        "second.pitch_angle: pitch angle of the wheel δ_2",
        "cone_distance: outer cone distance R_e",
        "first.pitch_diameter: pitch diameter of the pinion d_e1",
        "second.pitch_diameter: pitch diameter of the wheel d_e2",
        "first.tip_diameter: tip diameter of the pinion d_ae1",
        "second.tip_diameter: tip diameter of the wheel d_ae2",
        "contact_ratio: contact ratio ε_α",
        "first.tangential_force: tangential force F_t",
        "first.axial_force: axial force on the pinion",
        "first.radial_force: radial force on the pinion",
    ),
)

CROSSED = Task(
    "crossed",
    "Crossed helical (screw) gears: distance, working helices, shaft angle, sliding, efficiency (no strength rating).",
    Model(
        "virtual spur gears",
        "dynamics_cli.gear.crossing.crossed:crossed",
        source="KHK gear technical reference, screw gears; " + BOOK + "section 17.14",
        formula="{centre_distance|a_w} = {reference_distance|a_d} + {distance_modification|y}·{module|m_n}, "
        "{shaft_angle|Σ} = |{first_working_helix|β_w1} + {second_working_helix|β_w2}|",
        assumptions=("exact when the profile shifts sum to zero", "friction at the pitch point"),
    ),
    plot="dynamics_cli.gear.crossing.skew_pictures:crossed",
    examples=(
        'dynamics gear crossed --first-teeth 15 --first-helix-angle "20 deg" --first-profile-shift 0.4 '
        '--second-teeth 24 --second-helix-angle "30 deg" --second-profile-shift 0.2 --module "3 mm"',
        'dynamics gear crossed --first-teeth 13 --first-helix-angle "45 deg" --second-teeth 26 '
        '--second-helix-angle "45 deg" --module "2 mm" --speed "600 rpm"',
    ),
    arrays=False,
    headline=(
        "centre_distance: centre distance a_w",
        "shaft_angle: shaft angle Σ",
        "ratio: gear ratio u",
        "first_working_diameter: working diameter d_w1",
        "second_working_diameter: working diameter d_w2",
        "working_pressure_angle: working normal pressure angle α_wn",
        "efficiency: efficiency η",
        "sliding_speed: sliding speed v_g",
    ),
)

WORM = Task(
    "worm",
    "A worm pair: geometry, lead angle, efficiency both ways, self-locking, forces (no strength rating).",
    Model(
        "inclined plane",
        "dynamics_cli.gear.crossing.worm:worm",
        source="DIN 3975; " + BOOK + "section 17.14",
        formula="{lead_angle|γ} = atan({axial_module|m_x}·{threads|z₁}/{worm_diameter|d₁}), {efficiency|η} = "
        "tan({lead_angle|γ})/tan({lead_angle|γ} + {friction_angle|ρ'}), {backward_efficiency|η'} = "
        "tan({lead_angle|γ} − {friction_angle|ρ'})/tan({lead_angle|γ})",
        assumptions=("shafts at right angles", "friction at the pitch point only", "strength is not rated"),
    ),
    plot="dynamics_cli.gear.crossing.pictures:worm",
    examples=(
        'dynamics gear worm --threads 2 --teeth 30 --module "3 mm" --worm-diameter "44 mm"',
        'dynamics gear worm --threads 1 --teeth 40 --module "4 mm" --diameter-factor 10 --friction 0.12 '
        '--speed "1450 rpm" --power "2 kW"',
        'dynamics gear worm --threads 2 --teeth 39 --module "4 mm" --centre-distance "100 mm"',
        'dynamics gear worm --threads 4 --teeth 40 --normal-module "4 mm" --lead-angle "20 deg"',
    ),
    arrays=False,
    headline=(
        "ratio: ratio i",
        "lead_angle: lead angle γ",
        "centre_distance: centre distance a",
        "worm_diameter: reference diameter of the worm d_1",
        "wheel_diameter: reference diameter of the wheel d_2",
        "profile_shift: profile shift of the wheel x_2",
        "efficiency: efficiency η, worm driving",
        "backward_efficiency: efficiency η', wheel driving",
        "self_locking: self-locking",
        "wheel_torque: torque on the wheel T_2",
    ),
)

HYPOID = Task(
    "hypoid",
    "Pitch-point geometry of a hypoid pair: cones, offset and spiral angles, sliding, limit pressure angle.",
    Model(
        "pitch cones in contact",
        "dynamics_cli.gear.crossing.hypoid:hypoid",
        source="Wildhaber 1946; ISO 23509; " + BOOK + "section 17.14",
        formula="sin({axial_offset_angle|η}) = {offset|E}/({wheel_radius|r₂} + {first_pitch_radius|r₁}·"
        "cos({second_pitch_angle|δ₂})/cos({first_pitch_angle|δ₁})), {second_spiral_angle|β₂} = "
        "{first_spiral_angle|β₁} − {pitch_offset_angle|ε'}",
        assumptions=("the pitch angle of the wheel is the user's choice", "strength is not rated"),
        method="bracketed root, one tracked Newton step",
    ),
    plot="dynamics_cli.gear.crossing.skew_pictures:hypoid",
    examples=(
        'dynamics gear hypoid --first-teeth 10 --second-teeth 41 --offset "35 mm" --wheel-radius "85 mm"',
        'dynamics gear hypoid --first-teeth 13 --second-teeth 38 --offset "20 mm" --wheel-radius "70 mm" '
        '--wheel-pitch-angle "68 deg" --pinion-spiral-angle "45 deg" --speed "3000 rpm"',
    ),
    arrays=False,
    headline=(
        "ratio: ratio i",
        "first_pitch_angle: pitch angle of the pinion δ_1",
        "second_pitch_angle: pitch angle of the wheel δ_2",
        "first_spiral_angle: spiral angle of the pinion β_1",
        "second_spiral_angle: spiral angle of the wheel β_2",
        "first_pitch_radius: pitch radius of the pinion r_1",
        "limit_pressure_angle: limit pressure angle α_lim",
        "sliding_speed: sliding speed v_g",
    ),
)

WHEELS = Task(
    "wheels",
    "Rolling wheels and belts: speeds, belt length and wrap, what friction carries.",
    Model(
        "rolling without slip",
        "dynamics_cli.gear.trains.wheels:wheels",
        source=BOOK + "section 17.2; Euler's belt formula",
        formula=(
            "{belt_length|L} = 2·{span|s} + {first_diameter|d₁}/2·{first_wrap|θ₁} + "
            "{second_diameter|d₂}/2·{second_wrap|θ₂}",
            "{ratio|ω₁/ω₂} = ∓{second_diameter|d₂}/{first_diameter|d₁}",
        ),
        assumptions=("rigid wheels, an inextensible and flexible belt", "no slip"),
    ),
    plot="dynamics_cli.gear.trains.wheel_pictures:wheels",
    examples=(
        'dynamics gear wheels --first-diameter "100 mm" --second-diameter "300 mm" --drive open-belt '
        '--centre-distance "500 mm" --speed "1450 rpm" --power "2 kW" --friction 0.3',
        'dynamics gear wheels --first-diameter "4 in" --second-diameter "10 in" --speed "300 rpm" --units us',
    ),
    arrays=False,
    headline=(
        "ratio: ratio i",
        "second_speed: speed of the second wheel n_2",
        "rim_speed: rim speed v",
        "belt_length: belt length L",
        "first_wrap: wrap of the first wheel θ_1",
        "tight_tension: tight side F_1",
        "slack_tension: slack side F_2",
        "normal_force: pressing force",
    ),
)
