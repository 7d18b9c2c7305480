"""The tasks of `dynamics balance`."""

from dynamics_cli.core.answering.task import Family, Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
SENSE = "angles of masses and unbalances are measured in one sense from one mark on the rotor"
RIGID = "the rotor is rigid: it runs well below its first critical speed"
PICTURES = "dynamics_cli.balance.pictures"

STATIC = Task(
    "static",
    "Unbalance of masses in one plane, and the mass that balances it.",
    Model(
        "sum of unbalances",
        "dynamics_cli.balance.static:static",
        source=BOOK + "section 15.2",
        formula="{unbalance|U} = |Σ mᵢ·rᵢ|, {force|F} = {unbalance|U}·{speed|Ω}²",
        assumptions=(SENSE, "all masses lie in one plane across the axis; the couple of a long rotor is not balanced"),
    ),
    headline=(
        "unbalance: unbalance U", "angle: at", "correction_mass: mass to add", "correction_angle: opposite, at",
        "eccentricity: eccentricity e", "force: rotating force F", "grade: balance grade G",
    ),
    examples=(
        'dynamics balance static --weight "mass=20 g, radius=80 mm, angle=30 deg" '
        '--weight "mass=35 g, radius=60 mm, angle=150 deg" --correction-radius "100 mm"',
        'dynamics balance static --mass "5 g" --radius "120 mm" --angle "40 deg" --rotor-mass "12 kg" '
        '--speed "2900 rpm"',
    ),
    plot=f"{PICTURES}:static",
    arrays=False,
)  # fmt: skip

GRADE = Task(
    "grade",
    "Residual unbalance that a balance grade permits, by plane; grade reached.",
    Model(
        "balance grade",
        "dynamics_cli.balance.grade:grade",
        source="ISO 21940-11",
        formula="{eccentricity|e_per} = {grade|G}/{speed|Ω}, {unbalance|U_per} = {eccentricity|e_per}·{mass|M}",
        assumptions=(RIGID, "both planes lie between the bearings, the centre of mass between the planes"),
    ),
    headline=(
        "unbalance: permissible unbalance U_per", "eccentricity: permissible eccentricity e_per",
        "first_unbalance: in the first plane", "second_unbalance: in the second plane",
        "permitted: measured unbalance permitted", "reached: grade reached", "usage: measured over permissible",
    ),
    examples=(
        'dynamics balance grade --grade G6.3 --speed "3000 rpm" --mass "120 kg"',
        'dynamics balance grade --grade "2.5 mm/s" --speed "3600 rpm" --mass "80 lb" --first-distance "9 in" '
        '--second-distance "14 in" --measured "3 oz*in" --units us',
    ),
    plot=f"{PICTURES}:grade",
)  # fmt: skip

FOUR_RUNS = Task(
    "four-runs",
    "Correction in one plane from amplitudes alone: four runs without phase.",
    Model(
        "three circles",
        "dynamics_cli.balance.four_runs:four_runs",
        source="law of cosines",
        formula="t² = ⅓·Σ T² − {initial|O}², z = ⅓·Σ T²·e^(iφ), {mass|m} = {trial_mass|W}·|z|/t², opposite z",
        assumptions=(
            "readings are proportional to the unbalance, at the same speed in every run",
            "the correction is mass added, at the radius of the trial weight or its own; the trial weight is taken off",
        ),
    ),
    headline=(
        "mass: add", "angle: at", "unbalance: as an unbalance",
        "consistency: consistency, 1 is best", "miss: circles miss one point by",
        "effect: effect of the trial weight",
        "runs: runs | weight_at=weight at, reading, miss=circle off by",
    ),
    examples=(
        'dynamics balance four-runs --initial "6 mm/s" --first "4 mm/s" --second "9 mm/s" --third "7.5 mm/s" '
        '--trial-mass "10 g"',
        'dynamics balance four-runs --initial "4.2 mil" --first "5.9 mil" --second "2.1 mil" --third "5.6 mil" '
        '--trial-mass "0.5 oz" --second-angle "110 deg" --third-angle "250 deg" --units us',
    ),
    table="runs",
    plot=f"{PICTURES}:four_runs",
    arrays=False,
    also=("four-run",),
)  # fmt: skip

SPLIT = Task(
    "split",
    "A correction split onto two angles, or onto the holes beside it.",
    Model(
        "two places",
        "dynamics_cli.balance.split:split",
        source=BOOK + "section 15.2; law of sines",
        formula="{first_mass|m₁} = {mass|m}·sin({second_angle|β} − {angle|φ})/sin({second_angle|β} − {first_angle|α}), "
        "{second_mass|m₂} = {mass|m}·sin({angle|φ} − {first_angle|α})/sin({second_angle|β} − {first_angle|α})",
        assumptions=("every mass is at the radius of the correction", SENSE),
    ),
    headline=(
        "first_mass: first mass", "first_hole: in hole", "first_angle: at", "second_mass: second mass",
        "second_hole: in hole", "second_angle: at", "residual: remainder", "residual_share: share of it",
    ),
    examples=(
        'dynamics balance split --mass "10 g" --angle "37 deg" --first-angle "20 deg" --second-angle "65 deg"',
        'dynamics balance split --mass "10 g" --angle "37 deg" --holes 12 --stock "0.5 g"',
    ),
    plot=f"{PICTURES}:split",
    arrays=False,
)  # fmt: skip

PLANES = Task(
    "planes",
    "Two-plane balance of a rotor from known unbalances; bearing loads.",
    Model(
        "two correction planes",
        "dynamics_cli.balance.planes:planes",
        source=BOOK + "sections 15.3 and 15.4",
        formula="U_A = −Σ Uᵢ·({second_plane|z_B} − zᵢ)/({second_plane|z_B} − {first_plane|z_A}), "
        "U_B = −Σ Uᵢ·(zᵢ − {first_plane|z_A})/({second_plane|z_B} − {first_plane|z_A})",
        assumptions=(SENSE, RIGID, "corrections are masses added; to take mass away, turn them by 180 degrees"),
    ),
    headline=(
        "first_unbalance: first plane: add", "first_angle: at", "second_unbalance: second plane: add",
        "second_angle: at", "static: static part",
        "static_angle: at", "couple: couple part", "couple_angle: at",
        "bearings: rotating bearing loads | position=bearing at, load=before, balanced=after, angle",
    ),
    examples=(
        'dynamics balance planes --unbalance "amount=12 g*mm, angle=30 deg, position=0.1 m" '
        '--unbalance "amount=20 g*mm, angle=140 deg, position=0.35 m" '
        '--unbalance "amount=8 g*mm, angle=260 deg, position=0.6 m" '
        '--first-plane "0.05 m" --second-plane "0.7 m"',
        'dynamics balance planes --amount "300 g*mm" --angle "0 deg" --position "1 m" --first-plane "0.2 m" '
        '--second-plane "0.6 m" --first-bearing "0 m" --second-bearing "0.8 m" --speed "3000 rpm"',
    ),
    plot=f"{PICTURES}:planes",
    table="bearings",
    arrays=False,
)  # fmt: skip

TRIAL = Task(
    "trial",
    "Corrections in one or two planes from readings with trial weights.",
    Model(
        "influence coefficients",
        "dynamics_cli.balance.trial:trial",
        source="Goodman, J. Eng. Industry 86 (1964) 273 (least squares)",
        formula="α = (V₁ − V₀)/W, Σ|α·x + V₀|² least",
        assumptions=(
            "readings are proportional to the unbalance, at the same speeds in every run",
            "corrections are masses added, at the radius of the trial weight or their own; trial weights are taken off",
            "phases and angles of weights are counted in one sense from one mark, or against it with --phase lag",
        ),
        method="complex least squares by orthogonal columns",
    ),
    headline=(
        "first_mass: first plane: add", "first_angle: at", "first_unbalance: as an unbalance",
        "second_mass: second plane: add", "second_angle: at", "second_unbalance: as an unbalance",
        "predicted: readings | sensor, initial=before, residual=expected after, share",
        "condition: condition of the planes",
    ),
    examples=(
        'dynamics balance trial --sensor "initial=6 mil @ 40 deg, first=8 mil @ 110 deg" --first-trial-mass "5 g" '
        '--first-trial-angle "0 deg"',
        'dynamics balance trial --sensor "initial=170um@112deg, first=235um@94deg, second=186um@115deg" '
        '--sensor "initial=53um@78deg, first=58um@68deg, second=77um@104deg" '
        '--first-trial-mass "1.15 g" --first-trial-angle "0 deg" --second-trial-mass "1.15 g" '
        '--second-trial-angle "0 deg"',
    ),
    plot=f"{PICTURES}:trial",
    table="predicted",
    arrays=False,
)  # fmt: skip

DRAWN_ROD = "the rod is two masses, at pin and small end; its mass at the small end counts as reciprocating"

ENGINE = Task(
    "engine",
    "Inertia forces and couples of an engine by order; what balances them.",
    Model(
        "orders of the slider-crank",
        "dynamics_cli.balance.engines.engine:engine",
        source=BOOK + "sections 15.5 to 15.10",
        formula="forward ½·{reciprocating_mass|m}·{crank_radius|r}·{speed|ω}²·ΣA_n·e^(i(n(φ − β) + β)), "
        "backward with −n; A₁ = 1, A₂ = λ + λ³/4 + …, λ = {crank_radius|r}/{rod_length|l}",
        assumptions=(
            DRAWN_ROD,
            "crank and bank angles are measured in the sense of rotation; a piston is on top where both are equal "
            "(an offset shifts that a little)",
            "couples are about the middle of the shaft, or of the places given",
        ),
    ),
    headline=(
        "primary_force: primary force", "secondary_force: secondary force", "primary_couple: primary couple",
        "secondary_couple: secondary couple",
        "orders: by order | order, force, force_remedy=force taken by, couple, couple_remedy=couple taken by",
    ),
    scene={
        "preset": "inline-3",
        "reciprocating_mass": "0.42 kg",
        "crank_radius": "41 mm",
        "rod_length": "138 mm",
        "spacing": "82 mm",
        "speed": "6000 rpm",
    },
    examples=(
        'dynamics balance engine --preset inline-3 --reciprocating-mass "0.42 kg" --stroke "82 mm" '
        '--rod-length "138 mm" --spacing "82 mm" --speed "6000 rpm"',
        'dynamics balance engine --cylinder "crank=0 deg, bank=-30 deg" --cylinder "crank=0 deg, bank=30 deg" '
        '--reciprocating-mass "0.5 kg" --crank-radius "43 mm" --rod-length "172 mm" --speed "3000 rpm"',
    ),
    plot=f"{PICTURES}:engine",
    table="orders shafts",
    arrays=False,
)  # fmt: skip

LANCHESTER = Task(
    "lanchester",
    "Two balance shafts against the second-order force of an in-line engine.",
    Model(
        "two shafts turning against each other",
        "dynamics_cli.balance.engines.lanchester:lanchester",
        source=BOOK + "section 15.6",
        formula="{force|F} = {cylinders|z}·|A_n|·{reciprocating_mass|m}·{crank_radius|r}·{speed|ω}², "
        "{shaft_unbalance|U} = {force|F}/(2·n²·{speed|ω}²)",
        assumptions=(DRAWN_ROD, "the forces of this order of all cylinders add up", "weights down at top dead centre"),
    ),
    headline=(
        "shaft_unbalance: unbalance of each shaft U", "shaft_mass: weight of each shaft", "shaft_speed: shaft speed",
        "force: force taken away F", "shaft_force: bearing force of each shaft",
    ),
    examples=(
        'dynamics balance lanchester --reciprocating-mass "0.5 kg" --crank-radius "43 mm" --rod-length "172 mm" '
        '--speed "6000 rpm"',
        'dynamics balance lanchester --reciprocating-mass "1.2 lb" --crank-radius "1.75 in" --rod-length "6 in" '
        '--speed "5000 rpm" --weight-radius "0.8 in" --units us',
    ),
    arrays=False,
)  # fmt: skip

TURNING = Task(
    "turning",
    "Turning moment of an engine from its pressure diagram: firing order, orders.",
    Model(
        "gas and inertia torque",
        "dynamics_cli.balance.engines.turning:turning",
        source="virtual power",
        formula="T = p·A·{crank_radius|r}·v − {reciprocating_mass|m}·{crank_radius|r}²·{speed|ω}²·a·v",
        assumptions=(
            DRAWN_ROD,
            "every cylinder has the same pressure diagram, linear between points; pressures are above the crankcase's",
            "angles are those of the crank after it points along the cylinder; friction is left out",
        ),
        method="Gauss–Legendre quadrature by panels of 5 degrees",
    ),
    headline=(
        "mean_torque: mean torque", "power: indicated power", "mean_pressure: mean effective pressure",
        "largest: largest torque", "largest_angle: at", "smallest: smallest torque", "smallest_angle: at",
        "firing_order", "evenness: firing is",
        "orders: by order | order, torque, gas, inertia, single=one cylinder",
    ),
    scene={
        "preset": "inline-4",
        "bore": "86 mm",
        "reciprocating_mass": "0.5 kg",
        "crank_radius": "43 mm",
        "rod_length": "150 mm",
        "speed": "3000 rpm",
        "diagram_points[0].angle": "0 deg",
        "diagram_points[0].pressure": "25 bar",
        "diagram_points[1].angle": "20 deg",
        "diagram_points[1].pressure": "55 bar",
        "diagram_points[2].angle": "90 deg",
        "diagram_points[2].pressure": "8 bar",
        "diagram_points[3].angle": "540 deg",
        "diagram_points[3].pressure": "0 bar",
        "diagram_points[4].angle": "720 deg",
        "diagram_points[4].pressure": "25 bar",
    },
    examples=(
        "dynamics balance turning --diagram @examples/engine_torque/diagram.csv --preset inline-4 "
        '--bore "86 mm" --reciprocating-mass "0.5 kg" --crank-radius "43 mm" --rod-length "150 mm" --speed "3000 rpm"',
    ),
    plot=f"{PICTURES}:turning",
    table="torque orders firings",
    arrays=False,
    cost=4e-3,
    tracked=False,
)  # fmt: skip

FLYWHEEL = Task(
    "flywheel",
    "Energy fluctuation of a torque over a cycle, and the flywheel for it.",
    Model(
        "energy between crossings of the mean torque",
        "dynamics_cli.balance.flywheel:flywheel",
        source=BOOK + "chapter 15",
        formula="{inertia|I} = ΔE/({fluctuation|C_s}·{speed|ω}²)",
        assumptions=("the load is steady, equal to the mean torque", "the torque is linear between points"),
    ),
    headline=(
        "mean_torque: mean torque", "energy: energy fluctuation ΔE", "inertia: moment of inertia I",
        "rim_mass: mass of the rim", "fastest: fastest at", "slowest: slowest at",
    ),
    scene={
        "speed": "300 rpm",
        "points[0].angle": "0 deg",
        "points[0].torque": "-80 N*m",
        "points[1].angle": "30 deg",
        "points[1].torque": "400 N*m",
        "points[2].angle": "75 deg",
        "points[2].torque": "900 N*m",
        "points[3].angle": "120 deg",
        "points[3].torque": "350 N*m",
        "points[4].angle": "180 deg",
        "points[4].torque": "-120 N*m",
        "points[5].angle": "270 deg",
        "points[5].torque": "-160 N*m",
        "points[6].angle": "360 deg",
        "points[6].torque": "-80 N*m",
    },
    examples=(
        'dynamics balance flywheel --point "angle=0 deg, torque=-80 N*m" --point "angle=30 deg, torque=400 N*m" '
        '--point "angle=75 deg, torque=900 N*m" --point "angle=120 deg, torque=350 N*m" '
        '--point "angle=180 deg, torque=-120 N*m" --point "angle=270 deg, torque=-160 N*m" '
        '--point "angle=360 deg, torque=-80 N*m" --speed "300 rpm"',
    ),
    plot=f"{PICTURES}:flywheel",
    table="crossings",
    arrays=False,
)  # fmt: skip

FAMILIES = {
    "balance": Family(
        "balance",
        "Balancing of rotors and engines, balance grades, flywheels.",
        STATIC, PLANES, TRIAL, FOUR_RUNS, SPLIT, GRADE, ENGINE, LANCHESTER, TURNING, FLYWHEEL,
    )
}  # fmt: skip
