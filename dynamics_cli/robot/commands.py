"""The tasks of `dynamics robot`."""

from dynamics_cli.core.answering.task import Family, Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
PICTURES = "dynamics_cli.robot.pictures"
PICTURES_WORKSPACE = "dynamics_cli.robot.workspace.pictures"
RIGID = "rigid links, joints without play"
ARM = {"robot": "dynamics_cli.robot.arms.presets:NAMES"}
SCENE = {
    "convention": "standard", "joints[0].a": "500 mm", "joints[1].a": "400 mm", "angles": "30, 45 deg",
}  # fmt: skip

SCENE_PATH = {"convention": "standard", "joints[0].a": "500 mm", "joints[1].a": "400 mm"}

SCENE_LIMITS = {
    "convention": "standard", "joints[0].a": "500 mm", "joints[0].lower": "-90 deg", "joints[0].upper": "90 deg",
    "joints[1].a": "400 mm", "joints[1].lower": "-150 deg", "joints[1].upper": "150 deg",
}  # fmt: skip

SCENE_AT = {
    "convention": "standard", "joints[0].a": "500 mm", "joints[1].a": "400 mm", "position": "550, 350 mm",
}  # fmt: skip

SCENE_HEAVY = SCENE | {
    "joints[0].mass": "6 kg", "joints[0].centroid": "-250, 0, 0 mm", "joints[1].mass": "4 kg",
    "joints[1].centroid": "-200, 0, 0 mm", "up": "0, 1, 0",
}  # fmt: skip

POSE = Task(
    "pose",
    "Forward kinematics: where the hand of an arm is, and every link.",
    Model(
        "product of link transformations",
        "dynamics_cli.robot.pose:pose",
        source=BOOK + "sections 19.2, 19.3 and 19.8",
        formula="T = T₁·T₂·…·Tₙ",
        assumptions=(RIGID,),
    ),
    headline=(
        "position: hand",
        "hand_angle: angle of the hand",
        "orientation_angles: {angle_names}",
        "distance: distance from the base",
        "links: joint | joint, angle, travel, to_limit=to limit, travel_to_limit=to limit, "
        "joint_position=axis at, axis",
    ),
    examples=(
        'dynamics robot pose --robot puma-560 --angles "20, 40, -30, 0, 60, 0 deg"',
        'dynamics robot pose --lengths "500, 400, 200 mm" --angles "30, 45, -20 deg"',
        'dynamics robot pose examples/scara.toml --angles "30, 60, 0 deg" --slides "80 mm"',
    ),
    scene=SCENE,
    names=ARM,
    also=("forward", "fk", "forward-kinematics"),
    plot=f"{PICTURES}:pose_picture",
    table="links",
    tracked=True,
)

JACOBIAN = Task(
    "jacobian",
    "Jacobian, velocity and force ellipsoids of the hand, and whether the arm is singular.",
    Model(
        "partial velocities of the hand",
        "dynamics_cli.robot.jacobian:jacobian",
        source=BOOK + "sections 19.5 and 19.12",
        formula="v = z×(p − o), ω = z; τ = Jᵀ·F",
        assumptions=(RIGID,),
        method="singular values",
    ),
    headline=(
        "verdict: arm",
        "determinant: det J",
        "manipulability: manipulability w of the place",
        "speed_ratios: hand speed per joint speed",
        "shoulder_factor: shoulder, from singular",
        "elbow_factor: elbow, from straight",
        "wrist_factor: wrist, from in line",
        "lost_direction: cannot move unturned along",
        "lost_turn: cannot turn in place about",
        "idle: joint speeds, hand at rest",
        "velocity: velocity of the hand",
        "angular_velocity: angular velocity",
        "torques: joint torques",
        "slide_forces: forces of slides",
        "columns: column | joint, linear, slide, angular",
    ),
    examples=(
        'dynamics robot jacobian --lengths "500, 400 mm" --angles "30, 75 deg" --force "0, -100, 0 N"',
        'dynamics robot jacobian --robot puma-560 --angles "20, 40, -30, 0, 0, 0 deg"',
    ),
    scene=SCENE,
    names=ARM,
    plot=f"{PICTURES}:jacobian_picture",
    table="columns",
    arrays=False,
    tracked=False,
    errors=("nearness",),
)

RATES = Task(
    "rates",
    "Joint speeds for a velocity of the hand; least norm, weighted or damped.",
    Model(
        "least squares by singular values",
        "dynamics_cli.robot.rates:rates",
        source=BOOK + "section 19.16",
        formula="q̇ = W⁻¹·Jᵀ·(J·W⁻¹·Jᵀ)⁻¹·v",
        assumptions=(RIGID,),
        method="singular values",
    ),
    headline=(
        "solution: joint speeds are",
        "speeds: speeds of revolute joints",
        "slide_speeds: speeds of slides",
        "norm: norm",
        "idle: may be added, hand at rest",
        "missing_velocity: velocity missing",
        "missing_turn: turn missing",
    ),
    examples=(
        'dynamics robot rates --lengths "1000, 800, 500 mm" --angles "20, 40, -25 deg" --velocity "0.2, -0.1, 0 m/s"',
        'dynamics robot rates --robot puma-560 --angles "20, 40, -30, 0, 60, 0 deg" --velocity "0.1, 0, 0 m/s" '
        '--angular-velocity "0, 0, 0 rad/s"',
    ),
    scene=SCENE | {"velocity": "0.2, -0.1, 0 m/s"},
    names=ARM,
    also=("inverse-velocity",),
    plot=f"{PICTURES}:rates_picture",
    table="joints",
    arrays=False,
    tracked=False,
    errors=("missing_velocity", "missing_turn", "nearness"),
)

INVERSE = Task(
    "inverse",
    "Inverse kinematics: every posture that gives a pose, with limits and margins.",
    Model(
        "two links, first axis and wrist in closed form",
        "dynamics_cli.robot.inverse.task:inverse",
        source=BOOK + "section 19.12",
        formula="θ₂ = ±2·atan2(√((l₁ + l₂ − r)·(l₁ + l₂ + r)), √((r − |l₁ − l₂|)·(r + |l₁ − l₂|)))",
        assumptions=(RIGID,),
    ),
    headline=(
        "count: postures",
        "within: of them within limits",
        "angles: first posture",
        "slides: its slides",
        "structure: structure",
        "solutions: posture | number=#, angles, slides, configuration, within=fits, distance=turns",
    ),
    examples=(
        'dynamics robot inverse --lengths "500, 400, 200 mm" --position "550, 350 mm" --hand-angle "1 rad"',
        'dynamics robot inverse --robot puma-560 --position "450, 100, 900 mm" --euler-angles "0, 90, 0 deg" '
        "--euler-order XYZ",
        'dynamics robot inverse examples/scara.toml --position "300, 350, 320 mm" --hand-angle "45 deg"',
    ),
    scene=SCENE_AT,
    names=ARM | {"euler-order": "dynamics_cli.numerics.orientation.sequences:ALL"},
    also=("ik", "inverse-kinematics"),
    plot=f"{PICTURES}:inverse_picture",
    table="solutions",
    digits=5,
    arrays=False,
    tracked=False,
)

TORQUE = Task(
    "torque",
    "Joint torques for a posture, a motion, a payload and a force of the hand, part by part.",
    Model(
        "recursive Newton–Euler",
        "dynamics_cli.robot.torque:torque",
        source=BOOK + "sections 19.13 to 19.15",
        formula="τ = M(q)·q̈ + h(q, q̇) + g(q) + Jᵀ·F",
        assumptions=(
            RIGID,
            "of a motor's rotor only its turning with the joint counts",
            "no friction of joints at rest",
        ),
    ),
    headline=(
        "largest_torque: largest joint torque",
        "torques: joint torques",
        "slide_forces: forces of slides",
        "drives: with rotors and friction",
        "power: power on the links",
        "base_force: force of the base",
        "base_moment: its moment",
        "joints: parts | joint, torque, gravity, inertia, velocity, payload, hand, rotor, friction",
        "prismatic: slides | joint, force, gravity, inertia, velocity, payload, hand",
    ),
    examples=(
        'dynamics robot torque --lengths "500, 400 mm" --masses "6, 4 kg" --angles "30, 45 deg" --payload "2 kg" '
        '--up "0, 1, 0"',
        'dynamics robot torque --robot puma-560 --angles "0, 45, -180, 0, 45, 0 deg" '
        '--speeds "1, 0.5, -1, 0, 1, 0 rad/s" --accelerations "2, 1, 0, 0, 3, 0 rad/s^2"',
    ),
    scene=SCENE_HEAVY,
    names=ARM,
    also=("dynamics", "efforts", "inverse-dynamics"),
    plot=f"{PICTURES}:torque_picture",
    table="joints",
)

WORKSPACE = Task(
    "workspace",
    "Workspace: how far an arm reaches, the area with its border, and whether it reaches a point.",
    Model(
        "border of arcs, in the plane of the links",
        "dynamics_cli.robot.workspace.task:workspace",
        source=BOOK + "section 19.2",
        formula="A = ½·∮(x·dy − y·dx)",
        assumptions=(RIGID, "links and joints may pass through each other"),
        method="arcs of circles",
    ),
    headline=(
        "reached: point reached",
        "from_border: from the border",
        "reach: farthest from the first axis",
        "nearest: nearest to it",
        "lowest: lowest",
        "highest: highest",
        "area: area reached",
        "both_elbows: of it, with both elbows",
        "holes: holes",
        "hole_area: area of the holes",
        "volume: volume",
        "tip: reached by",
        "postures: postures at the point | number=#, angles, travel, elbow",
    ),
    examples=(
        'dynamics robot workspace --lengths "400, 300 mm" --lower "0, -60 deg" --upper "90, 90 deg"',
        'dynamics robot workspace --robot puma-560 --position "450, 100, 900 mm"',
        'dynamics robot workspace examples/scara.toml --position "300, 350, 320 mm"',
    ),
    scene=SCENE_LIMITS,
    names=ARM,
    also=("reach", "envelope"),
    plot=f"{PICTURES_WORKSPACE}:workspace_picture",
    table="border",
    arrays=False,
    tracked=False,
)

PATH = Task(
    "path",
    "A straight line or an arc of the hand: joint angles and speeds in time, against their limits.",
    Model(
        "closed form of the inverse along the path",
        "dynamics_cli.robot.path.task:path",
        source=BOOK + "sections 19.12 and 19.15",
        formula="q̇ = J⁻¹·(p′, θ′)·ṡ; s = 10τ³ − 15τ⁴ + 6τ⁵",
        assumptions=(RIGID,),
    ),
    headline=(
        "within: within limits",
        "duration: duration",
        "shortest_duration: shortest possible",
        "length: length of the path",
        "peak_hand_speed: largest speed of the hand",
        "posture: posture",
        "least_nearness: least σ ratio (0: singular)",
        "least_time: at",
        "jumps: jumps to another posture",
        "joints: joint | joint, start, end, start_travel=from, end_travel=to, peak_speed=peak speed, "
        "peak_slide_speed=peak speed, peak_time=at, share=of allowed",
    ),
    examples=(
        'dynamics robot path --lengths "500, 400 mm" --start "700, 100 mm" --end "200, 500 mm" --duration "2 s"',
        'dynamics robot path --robot puma-560 --start "450, 150, 900 mm" --end "450, -250, 700 mm" '
        '--euler-angles "0, 90, 0 deg" --euler-order XYZ --hand-speed "0.5 m/s"',
    ),
    scene=SCENE_PATH | {"start": "700, 100 mm", "end": "200, 500 mm", "duration": "2 s"},
    names=ARM | {"euler-order": "dynamics_cli.numerics.orientation.sequences:ALL"},
    also=("line", "trajectory"),
    plot="dynamics_cli.robot.path.pictures:path_picture",
    table="points",
    arrays=False,
    tracked=False,
    errors=("least_nearness",),
)

FAMILIES = {
    "robot": Family(
        "robot", "Robot arms: pose, Jacobian, inverse kinematics, workspace, paths, torques.",
        POSE, JACOBIAN, RATES, INVERSE, WORKSPACE, PATH, TORQUE,
    )
}  # fmt: skip
