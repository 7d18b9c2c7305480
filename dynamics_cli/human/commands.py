"""The tasks of `dynamics human`."""

from dynamics_cli.core.answering.task import Family, Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
PICTURES = "dynamics_cli.human.pictures"
WORKER = {
    "mass": "75 kg", "sex": "male", "head": "24 cm", "trunk": "60 cm", "shoulder": "50 cm",
    "upper_arm": "28 cm", "forearm": "27 cm", "hand": "8.5 cm", "thigh": "42 cm",
    "shank": "43 cm", "foot": "26 cm",
}  # fmt: skip
NOTES = (
    "Every shape has a --length. The ends of a frustum: --base-radius and --top-radius, or --base-girth and "
    "--top-girth; of a stadium: --base-girth and --base-width, --top-girth and --top-width; of an elliptical solid: "
    "--base-width and --base-depth, --top-width and --top-depth; the second end is as the first where it is left out. "
    "An ellipsoid has --width and --depth."
)

SEGMENTS = Task(
    "segments",
    "Masses, mass centres and moments of inertia of body segments.",
    Model(
        "segment table",
        "dynamics_cli.human.bodies.segments:segments",
        source=BOOK + "section 20.2",
        formula="m_i = share·{mass|m}, I_i = m_i·(r_i·L_i)²",
        assumptions=("rigid segments, mass centre on the line between the ends", "left and right alike"),
    ),
    headline=(
        "mass: sum of the segments", "sum: table adds up to", "rescaled",
        "segments: each of | name, count, mass, length=L, centroid_share=c/L, centroid=c, front_back=I front-back, "
        "left_right=I left-right, lengthwise=I long axis",
        "table: source",
    ),
    examples=(
        'dynamics human segments --mass "75 kg" --sex male --thigh "42 cm" --shank "43 cm" --foot "26 cm"',
        'dynamics human segments --mass "80 kg" --height "1.80 m" --segment-table zatsiorsky',
    ),
    table="segments",
    scene={"mass": "75 kg", "sex": "male", "thigh": "42 cm"},
    arrays=False,
)  # fmt: skip

POSTURE = Task(
    "posture",
    "Mass centre, inertia and balance of a body in a posture.",
    Model(
        "linked segments, de Leva's table",
        "dynamics_cli.human.bodies.posture:posture",
        source=BOOK + "sections 20.4 and 20.5; de Leva 1996, table 4",
        formula="r = Σ m_i·r_i/Σ m_i, I = Σ (I_i + m_i·(d_i²·1 − d_i d_iᵀ))",
        assumptions=(
            "rigid segments, mass centre on the line between the ends", "of a side view, left and right alike",
        ),
    ),
    headline=(
        "height: height of the mass centre", "centre: mass centre (forward, left, up)",
        "inertia: inertia, left-right axis", "gyration: its radius of gyration",
        "ankle_inertia: inertia about the ankles",
        "tensor: tensor about the mass centre", "balance", "toe_margin: behind the toes",
        "heel_margin: in front of the heels", "table: source",
    ),
    examples=(
        "dynamics human posture --input examples/lifting/worker.toml --knee-flexion 40deg --hip-flexion 80deg "
        "--shoulder-flexion 50deg --ankle-flexion 10deg",
        'dynamics human posture --mass "75 kg" --sex male --joint-centre @examples/lifting/centres.csv',
    ),
    table="segments",
    scene=WORKER,
    plot=f"{PICTURES}:posture",
    arrays=False,
)  # fmt: skip

MOMENTS = Task(
    "moments",
    "Joint forces and moments of a standing body, with loads in its hands.",
    Model(
        "link segments at rest",
        "dynamics_cli.human.joints.moments:moments",
        source=BOOK + "sections 20.6 to 20.9; de Leva 1996, table 4",
        formula="M = −Σ (r − r_joint)×(m·g − m·a) + Σ I·α, F_muscle = M/b",
        assumptions=(
            "standing on both feet, left and right alike", "net moments: no muscles pull against each other",
            "the load hangs at the knuckles",
        ),
    ),
    headline=(
        "largest: largest moment, at the {largest_joint}", "muscle_force: muscle force", "compression", "shear",
        "pressure_centre: centre of pressure, ahead of the ankles", "residual_force: residual force",
        "residual_moment: residual moment",
        "joints: joints, both sides | name, moment, side=each side, muscles, force",
    ),
    examples=(
        "dynamics human moments --input examples/lifting/worker.toml --ankle-flexion 10deg --knee-flexion 40deg "
        '--hip-flexion 80deg --shoulder-flexion 50deg --load "15 kg" --muscle "joint=back, lever=5 cm"',
        "dynamics human moments --input examples/lifting/worker.toml --shoulder-flexion 30deg --hip-flexion 20deg "
        '--hand-force "-120, 0 N"',
    ),
    table="joints",
    scene=WORKER,
    plot=f"{PICTURES}:moments",
    arrays=False,
)  # fmt: skip

LIMB = Task(
    "limb",
    "Joint forces and moments of a moving limb at one instant.",
    Model(
        "Newton and Euler, from the far end",
        "dynamics_cli.human.joints.limb:limb",
        source=BOOK + "sections 20.7 to 20.9",
        formula="F = m·(a + g) − F_far, M = I·α − (r − c)×F − (r_far − c)×F_far − M_far",
        assumptions=("rigid segments in one plane", "net moments: no muscles pull against each other"),
    ),
    headline=(
        "largest: largest moment, at the {largest_joint}",
        "joints: joints, on the segment below | name, moment, muscles, force",
    ),
    examples=(
        "dynamics human limb --input examples/stride/stance.toml",
        'dynamics human limb --segment "name=forearm, mass=1.2 kg, inertia=0.008 kg*m^2, centre=0.12, 0 m, '
        'joint=0, 0 m" --ground-force "0, -50 N" --ground-at "0.3, 0 m"',
    ),
    table="joints",
    scene={
        "segments[0].name": "foot", "segments[0].mass": "1.0275 kg", "segments[0].inertia": "0.0042 kg*m^2",
        "segments[0].centre": "0.93, 0.062 m", "segments[0].joint": "0.878, 0.105 m",
    },
    arrays=False,
)  # fmt: skip

GAIT = Task(
    "gait",
    "Joint moments and powers of a leg over a stride, with a force plate.",
    Model(
        "Newton and Euler, from the ground up",
        "dynamics_cli.human.joints.gait:gait",
        source=BOOK + "sections 20.7 to 20.9; de Leva 1996, table 4",
        formula="M = I·α − (r − c)×F − (r_far − c)×F_far − M_far, P = M·(ω_below − ω_above)",
        assumptions=(
            "rigid segments in the side view", "net moments: no muscles pull against each other",
            "friction is judged above 10 % of the weight",
        ),
    ),
    headline=(
        "support: largest support moment, at {support_time}", "braking_friction: friction needed when braking",
        "push_friction: friction needed when pushing off",
        "peaks: extremes | name, largest=moment, largest_time=at, smallest=least, smallest_time=at, generated, "
        "absorbed, work",
    ),
    examples=('dynamics human gait examples/stride/stride.csv --mass "75 kg" --sex male --cutoff "6 Hz"',),
    table="history",
    plot=f"{PICTURES}:gait",
    arrays=False,
    tracked=False,
)  # fmt: skip

FALL = Task(
    "fall",
    "Tripping as one piece: time, speeds, friction needed, slipping.",
    Model(
        "rigid body about its support",
        "dynamics_cli.human.fall:fall",
        source=BOOK + "section 20.12; Carlson, Numerical Algorithms 10, 1995",
        formula="p² = {gravity|g}·{centre_height|h}/(k² + h²), ω² = ω₀² + 4p²·sin(½(θ₁ + θ₀))·sin(½(θ₁ − θ₀))",
        assumptions=("the body falls as one rigid piece, without a reaction", "the support stays where it is"),
    ),
    headline=(
        "time", "head_speed: speed of the head", "centre_speed: speed of the mass centre", "rate: angular velocity",
        "energy: kinetic energy", "start_rate: angular velocity after the trip",
        "friction_needed: friction needed, at {friction_angle}", "slip: on this floor", "slip_angle: from",
    ),
    examples=(
        'dynamics human fall --centre-height "1.0 m" --gyration "0.4 m" --start "5 deg" --height "1.75 m"',
        'dynamics human fall --centre-height "0.95 m" --gyration "0.42 m" --speed "1.4 m/s" --height "1.70 m" '
        "--friction 0.3",
    ),
    plot=f"{PICTURES}:fall",
    arrays=False,
    tracked=False,
)  # fmt: skip

SOLID = Task(
    "solid",
    "A segment as a solid from girths and widths: mass, centre, inertia.",
    Model(
        "integrals along the length",
        "dynamics_cli.human.bodies.solid:solid",
        source=BOOK + "section 20.2",
        formula="I = ρ·∫ (J + A·(s − z)²) ds",
        assumptions=("uniform density", "sections change evenly from end to end"),
    ),
    notes=NOTES,
    headline=(
        "mass", "centroid: mass centre from the first end", "axial: inertia, long axis",
        "about_width: inertia, left-right axis", "about_depth: inertia, front-back axis",
    ),
    examples=(
        'dynamics human solid frustum --length "42 cm" --base-girth "56 cm" --top-girth "38 cm" '
        '--density "1050 kg/m^3"',
        'dynamics human solid stadium --length "15 cm" --base-girth "78 cm" --base-width "30 cm" --top-girth "90 cm" '
        '--top-width "34 cm" --density "1010 kg/m^3"',
    ),
)  # fmt: skip

FAMILIES = {
    "human": Family(
        "human",
        "The human body: segments, postures, joint moments, gait, falls.",
        SEGMENTS, POSTURE, MOMENTS, LIMB, GAIT, FALL, SOLID,
    )
}  # fmt: skip
