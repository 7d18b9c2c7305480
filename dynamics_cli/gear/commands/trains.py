"""Tasks of `dynamics gear`: trains."""

from dynamics_cli.core.answering.task import Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "

TRAIN = Task(
    "train",
    "Speeds, torques and powers of any gear train: simple, compound, planetary, differential.",
    Model(
        "Willis",
        "dynamics_cli.gear.trains.train:train",
        source="Willis, Principles of Mechanism, 1841; " + BOOK + "section 17.10",
        formula="z₁·(ω₁ − ω_c) + z₂·(ω₂ − ω_c) = 0 for every mesh; {ratio|i} = ω_driver/ω_driven",
        assumptions=("no losses", "equal planets share the load equally"),
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
    plot="dynamics_cli.gear.trains.pictures:train_picture",
    scene={"stages": "20:60, 18:54", "speed": "1500 rpm", "torque": "12 N*m"},
    headline=(
        "ratio: ratio i",
        "ratio_value: ratio i, decimal",
        "input_power: input power",
        "basic_ratio: basic ratio i_0",
        "circulating_power: circulating power",
        "assembly.equal_spacing: planets equally spaced",
        "assembly.neighbour_gap: gap between planets",
        "shafts",
        "meshes",
    ),
)

RATIO = Task(
    "ratio",
    "Best tooth numbers for a wanted ratio, from every train within the limits.",
    Model(
        "exhaustive search",
        "dynamics_cli.gear.trains.ratio:ratio",
        source="products of tooth numbers sorted and compared; ranked as exact fractions",
        formula="i = Π z_driven/Π z_driver",
        assumptions=("the sign of the ratio is that of the number of external meshes",),
        method="whole numbers",
    ),
    plot="dynamics_cli.gear.trains.pictures:ratio_picture",
    examples=(
        'dynamics gear ratio --target 6.3 --teeth 17..90 --centre-distance "90 mm" --module "2 mm"',
        "dynamics gear ratio --target 365.2422/27.3217 --stages 3 --teeth 12..120",
        "dynamics gear ratio --target 3.14159265358979 --stages 1 --teeth 17..400 --coprime",
        "dynamics gear ratio --target 19.2 --teeth 15..90 --coaxial --coprime --largest-stage 6",
    ),
    table="best",
    arrays=False,
    tracked=False,
    headline=(
        "best: best trains",
        "considered: trains considered",
    ),
)

MEASURE = Task(
    "measure",
    "Sizes that show a gear's tooth thickness: span, over pins, chords; and the profile shift from a measured size.",
    Model(
        "involute geometry",
        "dynamics_cli.gear.measure.measurement:measure",
        source="ISO 21771; KHK Gear Technical Reference, tooth thickness",
        formula="{span.span|W_k} = m_n·cos α_n·((k − ½)·π + z·inv α_t) + 2·x·m_n·sin α_n; "
        "{pins.size|M} = d_b/cos α_K·(cos 90°/z when z is odd) + {pins.pin|D_M}, "
        "inv α_K = D_M/(z·m_n·cos α_n) − π/(2z) + 2·x·tan α_n/z + inv α_t",
        assumptions=("the root is cut by a rack with a rounded corner (an internal gear has a fillet)",),
    ),
    plot="dynamics_cli.gear.measure.pictures:measure_picture",
    examples=(
        'dynamics gear measure --teeth 24 --module "3 mm" --profile-shift 0.4',
        'dynamics gear measure --teeth 37 --diametral-pitch "8 1/in" --pin "0.216 in" --measured-pins "4.921 in" '
        "--units us",
        'dynamics gear measure --teeth 31 --module "2 mm" --helix-angle "15 deg" --upper-allowance "-0.05 mm" '
        '--lower-allowance "-0.09 mm" --face-width "20 mm"',
        'dynamics gear measure --teeth 72 --module "2 mm" --internal',
    ),
    arrays=False,
    headline=(
        "from_span.profile_shift: profile shift x, from the span",
        "from_span.thickness_deviation: tooth thickness, off nominal by",
        "from_pins.profile_shift: profile shift x, from the pins",
        "from_pins.thickness_deviation: tooth thickness, off nominal by",
        "from_chord.profile_shift: profile shift x, from the chord",
        "from_chord.thickness_deviation: tooth thickness, off nominal by",
        "normal_thickness: normal tooth thickness s_n",
        "span.over: teeth to span k",
        "span.span: span W_k",
        "span.span_upper: span of the thickest teeth",
        "span.span_lower: span of the thinnest teeth",
        "pins.pin: pin diameter D_M",
        "pins.size: size over pins M",
        "pins.size_upper: over pins, thickest teeth",
        "pins.size_lower: over pins, thinnest teeth",
        "chordal.thickness: chordal thickness",
        "chordal.height: chordal height",
    ),
)

PROFILE = Task(
    "profile",
    "Exact profile of a gear, internal gear or rack, for --drawing FILE.dxf, .svg or .csv.",
    Model(
        "generation by a rack",
        "dynamics_cli.gear.single.profile:profile",
        source="ISO 21771; law of gearing applied to the rack's corner",
        formula="R = r_b·√(1 + t²), ψ = ψ_b − (t − atan t); d_Ff = 2·√(r_b² + ξ²), or where trochoid and involute meet",
        assumptions=("an internal gear's root is a fillet tangent to root circle and involute",),
    ),
    examples=(
        'dynamics gear profile --teeth 20 --module "2 mm"',
        'dynamics gear profile --teeth 9 --module "3 mm" --profile-shift 0.1 --only-teeth 1 --tolerance "0.1 um"',
        'dynamics gear profile --teeth 72 --module "2 mm" --internal',
        'dynamics gear profile --teeth 6 --module "2 mm" --rack',
    ),
    arrays=False,
    tracked=False,
    plot="dynamics_cli.gear.single.pictures:profile_picture",
    headline=(
        "tip_diameter: tip diameter d_a",
        "root_diameter: root diameter d_f",
        "base_diameter: base diameter d_b",
        "form_diameter: root form diameter d_Ff",
        "undercut",
        "deviation: maximum deviation",
        "pieces",
    ),
)

MESH = Task(
    "mesh",
    "Proof of a mesh: both exact profiles turned through it, point by point.",
    Model(
        "rotated profiles",
        "dynamics_cli.gear.mesh.mesh:mesh",
        source="law of gearing; ISO 21771",
        formula="{contact_ratio|ε_α} = (end − start of contact)/p_bt, both as tips and form circles allow",
        assumptions=("rigid gears of exact shape on parallel axes", "both have the same basic rack"),
        method="sampling of exact profiles",
    ),
    examples=(
        'dynamics gear mesh --first-teeth 12 --second-teeth 24 --module "3 mm" --first-profile-shift 0.6 '
        "--second-profile-shift 0.36",
        'dynamics gear mesh --first-teeth 16 --second-teeth 24 --module "3 mm" --internal '
        "--second-profile-shift 0.5 --shift-sign khk",
        'dynamics gear mesh --first-teeth 17 --second-teeth 51 --module "2 mm" --centre-distance "68.1 mm"',
    ),
    table="path",
    arrays=False,
    cost=9e-3,
    tracked=False,
    plot="dynamics_cli.gear.mesh.pictures:mesh_picture",
    headline=(
        "centre_distance: centre distance a_w",
        "working_pressure_angle: working pressure angle α_wt",
        "contact_ratio: contact ratio ε_α",
        "transmission_error: transmission error",
        "backlash: normal backlash j_bn",
        "first_in_second: clearance of gear 1 in gear 2",
        "second_in_first: clearance of gear 2 in gear 1",
        "runs: runs freely",
    ),
)

IDENTIFY = Task(
    "identify",
    "An unknown gear from its teeth, spans and tip diameter: module or pitch, pressure angle, profile shift.",
    Model(
        "base pitch and span",
        "dynamics_cli.gear.measure.identify:identify",
        source="ISO 21771, ISO 54; KHK Gear Technical Reference",
        formula="{base_pitch|p_bn} = (W_k − W_j)/(k − j) = π·m_n·cos α_n",
        assumptions=("the gear is a standard one with teeth of full depth or stub teeth",),
    ),
    plot="dynamics_cli.gear.measure.pictures:candidates",
    scene={
        "teeth": "24",
        "tip_diameter": "80.4 mm",
        "spans[0].over": "3",
        "spans[0].length": "23.97 mm",
        "spans[1].over": "4",
        "spans[1].length": "32.83 mm",
    },
    examples=(
        'dynamics gear identify --teeth 24 --span-read "over=3, length=23.97 mm" --span-read "over=4, length=32.83 mm" '
        '--tip-diameter "80.4 mm"',
        'dynamics gear identify --teeth 32 --span-read "over=3, length=24.69 mm" --tip-diameter "4.25 in"',
        'dynamics gear identify --teeth 20 --tip-diameter "2.75 in" --units us',
    ),
    table="candidates",
    arrays=False,
    headline=(
        "base_pitch: normal base pitch p_bn",
        "candidates: gears that fit",
    ),
)
