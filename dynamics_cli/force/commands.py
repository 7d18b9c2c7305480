"""The tasks of `dynamics force`."""

from dynamics_cli.core.answering.task import Family, Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
TYPED = "numbers are exact as typed; directions by an angle to 15 digits"
METHOD = "exact sums"
PICTURES = "dynamics_cli.force.pictures"
DRAWN = "dynamics_cli.force.laws.pictures"

RESULTANT = Task(
    "resultant",
    "Resultant of forces and couples: class, line of action, wrench.",
    Model(
        "central axis",
        "dynamics_cli.force.resultant:resultant",
        source=BOOK + "sections 6.2 to 6.6",
        formula="R = Σ F, M = Σ (r − Q)×F + Σ C, {pitch|p} = R·M/R², axis through Q + R×M/R²",
        assumptions=("forces act on one rigid body", TYPED),
        method=METHOD,
    ),
    headline=(
        "system", "arrangement", "force: resultant R", "magnitude: magnitude |R|", "angle: angle from x",
        "moment: moment M", "axis_point: axis through", "direction: axis along", "crosses_x: crosses the x-axis at",
        "crosses_y: crosses the y-axis at", "pitch: pitch p", "wrench_moment: moment of the wrench",
    ),
    examples=(
        'dynamics force resultant --load "force=0, -500 N, at=2, 0 m" --load "force=300 N @ 30 deg, at=4, 1 m"',
        'dynamics force resultant --load "force=10, -4, 3 N, at=1, 2, -1 m" '
        '--load "force=-6, 8, 2 N, at=-2, 0.5, 3 m" --couple "moment=2, -3, 0.5 N*m"',
    ),
    arrays=False,
    tracked=False,
    plot=f"{PICTURES}:resultant",
)  # fmt: skip

MOMENT = Task(
    "moment",
    "Moment of a force about a point and about a line, with its lever.",
    Model(
        "vector product",
        "dynamics_cli.force.moment:moment",
        source=BOOK + "section 6.3",
        formula="M = (r − Q)×F, {lever|h} = |M|/|F|, {about_line|M_n} = M·n/|n|",
        assumptions=(TYPED,),
        method=METHOD,
    ),
    headline=(
        "moment: moment M", "magnitude: magnitude |M|", "lever", "foot: foot on the line of action",
        "about_line: moment about the line", "line_lever: distance between the lines",
    ),
    examples=(
        'dynamics force moment --force "200 N @ -60 deg" --at "0.3, 0.1 m"',
        'dynamics force moment --force "10, -4, 30 lbf" --at "6, 2, 0 in" --axis "0, 1, 0" --units us',
    ),
    arrays=False,
    tracked=False,
    plot=f"{PICTURES}:moment",
)  # fmt: skip

EQUIVALENT = Task(
    "equivalent",
    "The same system as force and couple elsewhere, wrench, or two forces.",
    Model(
        "equivalent systems",
        "dynamics_cli.force.equivalent:equivalent",
        source=BOOK + "sections 6.5 and 6.6",
        formula="R = Σ F, M_Q = M_O − Q×R",
        assumptions=("forces act on one rigid body", TYPED),
        method=METHOD,
    ),
    headline=(
        "form: equivalent to", "force: force", "at", "couple", "second_force: second force", "second_at: at",
        "pitch: pitch p", "wrench_moment: moment of the wrench",
    ),
    examples=(
        'dynamics force equivalent --load "force=0, -500 N, at=2, 0 m" --about "0.5, 0 m"',
        'dynamics force equivalent --load "force=10, -4, 3 N, at=1, 2, -1 m" --couple "moment=2, -3, 0.5 N*m" '
        "--form two-forces",
    ),
    arrays=False,
    tracked=False,
)  # fmt: skip

EQUILIBRIUM = Task(
    "equilibrium",
    "Reactions of pins, rollers, cables and other supports of a rigid body.",
    Model(
        "equations of equilibrium",
        "dynamics_cli.force.equilibrium:equilibrium",
        source=BOOK + "section 6.5",
        formula="Σ F = 0, Σ M = 0",
        assumptions=("one rigid body at rest", "supports without friction, rigid", TYPED),
        method="exact elimination",
    ),
    headline=(
        "verdict", "largest: largest reaction",
        "reactions: reactions on the body | name, type, force, size, angle, moment, sense",
    ),
    examples=(
        'dynamics force equilibrium --load "force=0, -1000 N, at=2, 0 m" --load "force=300, 0 N, at=4, 1 m" '
        '--support "type=pin, at=0, 0 m" --support "type=roller, at=5, 0 m, direction=1 @ 120 deg"',
        'dynamics force equilibrium --load "500 lbf down at 8 ft" --distributed "60 lbf/ft down from 0 ft to 8 ft" '
        '--support "fixed at 0 ft" --units us',
    ),
    table="reactions",
    scene={
        "loads[0].force": "500 N down", "loads[0].at": "2, 0 m", "supports[0].type": "pin", "supports[0].at": "0, 0 m",
        "supports[1].type": "roller", "supports[1].at": "5, 0 m",
    },
    arrays=False,
    tracked=False,
    plot=f"{PICTURES}:equilibrium",
)  # fmt: skip

SPRING = Task(
    "spring",
    "Force and energy of a spring or a group, with a damper, between two points.",
    Model(
        "linear spring",
        "dynamics_cli.force.laws.spring:spring",
        source=BOOK + "section 6.7",
        formula="{tension|T} = {stiffness|k}·({length|ℓ} − {free_length|ℓ₀}) + {damping|c}·{rate|ℓ̇}",
        assumptions=("force proportional to stretch and to its rate", "the spring pushes as well as pulls"),
    ),
    headline=(
        "state", "tension: tension T", "spring_force: force of the spring", "damper_force: force of the damper",
        "stiffness: stiffness of the group", "stretch", "energy: energy stored", "first_force: force on the first end",
        "second_force: force on the second end", "members: springs | stiffness, force, stretch, energy",
    ),
    examples=(
        'dynamics force spring --length "120 mm" --free-length "100 mm" --stiffness "20 N/mm"',
        'dynamics force spring --first-end "0, 0 m" --second-end "0.3, 0.4 m" --free-length "450 mm" '
        '--stiffness "2 kN/m" --damping "50 N*s/m" --rate "0.2 m/s"',
        'dynamics force spring --length "120 mm" --free-length "100 mm" --stiffness "20, 30 N/mm" --group series',
    ),
    arrays=False,
)  # fmt: skip

GRAVITY = Task(
    "gravity",
    "Weight at an altitude; attraction of two masses.",
    Model(
        "inverse square",
        "dynamics_cli.force.laws.masses:gravity",
        source=BOOK + "section 6.7; CODATA 2018",
        formula="g = {gravity|g₀}·(R/(R + h))², F = m·g, or F = G·m₁·m₂/r²",
        assumptions=(
            "spherical bodies, as point masses at their centres",
            "no rotation of the earth; its mean radius is 6371 km",
        ),
    ),
    headline=("force: force F", "acceleration: acceleration g", "share: ratio to that on the ground"),
    examples=(
        'dynamics force gravity --mass "80 kg" --altitude "400 km"',
        'dynamics force gravity --mass "1000 kg" --other-mass "5.972e24 kg" --distance "7000 km"',
    ),
)

FRICTION = Task(
    "friction",
    "A pushed block on an incline: holds, slides or tips; minimum and maximum push.",
    Model(
        "Coulomb friction and tipping",
        "dynamics_cli.force.laws.friction:friction",
        source=BOOK + "section 6.7",
        formula="{normal_force|N} = {mass|m}·{gravity|g}·cos {angle|α}",
        assumptions=(
            "the block is rigid and at rest", "the push is along the incline",
            "its centre is above the middle of its base",
        ),
    ),
    headline=(
        "verdict", "margin", "least_push: minimum push", "below: under less push", "largest_push: maximum push",
        "above: under more push", "needed_friction: friction needed", "pressure_point: normal force from the middle",
    ),
    examples=(
        'dynamics force friction --mass "80 kg" --friction 0.4 --width "0.5 m" --centre-height "0.6 m" '
        '--push "200 N" --push-height "1 m"',
        'dynamics force friction --mass "300 lb" --angle "15 deg" --friction 0.5 --width "20 in" '
        '--centre-height "18 in" --push-height "10 in" --units us',
    ),
    arrays=False,
    plot=f"{DRAWN}:friction",
)  # fmt: skip

WEDGE = Task(
    "wedge",
    "A wedge under a load: force to drive it, force to pull it out, self-locking.",
    Model(
        "Coulomb friction on every face",
        "dynamics_cli.force.laws.wedge:wedge",
        source="the force on each face is inclined by the angle of friction",
        formula="{drive|P} = {load|W}·cos φ_g·sin({angle|α} + φ + φ₀)/(cos φ₀·cos({angle|α} + φ + φ_g)), φ = atan μ",
        assumptions=("the load moves straight up and down in its guide", "the wedge has no weight"),
    ),
    headline=(
        "drive: force to drive it in", "verdict", "release: force to pull it out",
        "limit_angle: holds by itself up to", "efficiency", "face_force: force on its face",
        "guide_force: force of the guide",
    ),
    examples=(
        'dynamics force wedge --load "5 kN" --angle "8 deg" --friction 0.15',
        'dynamics force wedge --load "1200 lbf" --angle "12 deg" --friction 0.1 --ground-friction 0.3 '
        "--guide-friction 0.2 --units us",
    ),
    plot=f"{DRAWN}:wedge",
)  # fmt: skip

SCREW = Task(
    "screw",
    "A screw under load: torques to raise and lower, self-locking, efficiency.",
    Model(
        "unrolled thread",
        "dynamics_cli.force.laws.screw:screw",
        source="Scilab Textbook Companion to Bhandari, Design of Machine Elements, chapter 6",
        formula="T = {load|W}·d_m/2·(tan λ + μ′)/(1 − μ′·tan λ) + {collar_friction|μ_c}·{load|W}·"
        "{collar_diameter|d_c}/2, tan λ = l/(π·d_m), μ′ = {friction|μ}/cos α",
        assumptions=(
            "friction acts at the mean diameters", "the flank angle across the thread is that along the axis",
        ),
    ),
    headline=(
        "raising_torque: torque to raise the load", "lowering_torque: torque to lower it", "verdict", "efficiency",
        "lead_angle: lead angle λ", "locking_friction: holds by itself from μ",
    ),
    examples=(
        'dynamics force screw --load "15 kN" --thread square --diameter "50 mm" --pitch "8 mm" --starts 3 '
        '--friction 0.15 --collar-diameter "82.5 mm"',
        'dynamics force screw --load "2000 lbf" --thread acme --diameter "1 in" --pitch "0.2 in" --friction 0.12 '
        "--units us",
    ),
)  # fmt: skip

FIRST_MOMENT = Task(
    "first-moment",
    "First moment of mass and mass centre of particles.",
    Model(
        "first moment",
        "dynamics_cli.force.laws.masses:first_moment",
        source=BOOK + "section 6.8",
        formula="S = Σ m·(r − Q), centre = Q + S/Σ m",
        assumptions=("products are exact for the numbers as typed, to 15 digits",),
    ),
    headline=("first_moment: first moment S", "mass: total mass", "centre: mass centre"),
    examples=(
        'dynamics force first-moment --particle "mass=2 kg, at=1, 0 m" --particle "mass=3 kg, at=0, 2 m"',
        'dynamics force first-moment --particle "mass=4 lb, at=1, 2, 0 ft" --particle "mass=6 lb, at=0, 1, 3 ft" '
        '--about "1, 1, 1 ft" --units us',
    ),
    arrays=False,
)

FAMILIES = {
    "force": Family(
        "force",
        "Forces: resultants, moments, reactions, springs, friction.",
        RESULTANT, MOMENT, EQUIVALENT, EQUILIBRIUM, SPRING, GRAVITY, FRICTION, WEDGE, SCREW, FIRST_MOMENT,
    )
}  # fmt: skip
