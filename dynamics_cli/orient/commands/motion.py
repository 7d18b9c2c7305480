"""Tasks of `dynamics orient`: turning motion and contact."""

from dynamics_cli.core.answering.task import Model, Task

SENSE = "axes are right-handed, angles counter-clockwise seen from the tip of the axis"
RIGID = "the bodies are rigid"

RATES = Task(
    "rates",
    "Angular velocity and acceleration from rates of angles, or the rates from these.",
    Model(
        "turning axes",
        "dynamics_cli.orient.motion.rates:rates",
        formula="ω = ȧ·u₁ + ḃ·u₂ + ċ·u₃, α = ä·u₁ + b̈·u₂ + c̈·u₃ + ȧ·u₁×ḃ·u₂ + (ȧ·u₁ + ḃ·u₂)×ċ·u₃",
        assumptions=(SENSE, "fixed components unless body components are named"),
    ),
    headline=(
        "angular_velocity: angular velocity ω",
        "body_angular_velocity: ω, body components",
        "angular_speed: |ω|",
        "angular_acceleration: angular acceleration α",
        "body_angular_acceleration: α, body components",
        "angular_acceleration_size: |α|",
        "angle_rates: rates of the angles",
        "angle_accelerations: second rates",
        "condition",
    ),
    names={"euler-order": "dynamics_cli.numerics.orientation.sequences:ALL"},
    plot="dynamics_cli.orient.pictures.motion:rates",
    examples=(
        'dynamics orient rates --euler-angles "30, 20, -40 deg" --angle-rates "0.1, 0.2, 0.3 rad/s" '
        '--angle-accelerations "0.4, -0.5, 0.6 rad/s^2"',
        'dynamics orient rates --euler-angles "30, 20, -40 deg" --body-angular-velocity "0.27, 0.09, 0.2 rad/s"',
    ),
)

ADDITION = Task(
    "addition",
    "Angular velocity and acceleration along a chain of bodies, term by term.",
    Model(
        "addition theorem",
        "dynamics_cli.orient.motion.addition:addition",
        formula="ω_AC = ω_AB + ω_BC, α_AC = α_AB + α_BC + ω_AB × ω_BC",
        assumptions=(SENSE, "each axis is fixed in the body before"),
    ),
    headline=(
        "angular_velocity: angular velocity of the last ω",
        "angular_speed: |ω|",
        "angular_acceleration: angular acceleration of the last α",
        "angular_acceleration_size: |α|",
        "links: links | name, angular_velocity, angular_acceleration, carried",
    ),
    table="links",
    plot="dynamics_cli.orient.pictures.motion:addition",
    examples=(
        'dynamics orient addition --link "axis=(0, 0, 1), rate=12 rpm, name=mast" '
        '--link "axis=(0, 1, 0), rate=-40 deg/s, angle=-30 deg, name=boom" '
        '--link "axis=(1, 0, 0), rate=20 rpm, name=drum"',
    ),
)

POINTS = Task(
    "points",
    "Velocities and accelerations of points of a rigid body, or its motion from theirs.",
    Model(
        "rigid body",
        "dynamics_cli.orient.motion.points:points",
        formula="v_Q = v_P + ω × r, a_Q = a_P + α × r + ω × (ω × r)",
        assumptions=(RIGID, "all vectors in one set of axes"),
    ),
    headline=(
        "angular_velocity: angular velocity ω",
        "axis: screw axis",
        "axis_point: point of the axis",
        "slide: speed along the axis",
        "pitch: pitch ω·v/ω²",
        "misfit: departure from rigidity (rms)",
        "points: points | name, velocity, speed, acceleration",
    ),
    table="points",
    plot="dynamics_cli.orient.pictures.motion:points",
    scene={
        "angular_velocity": "0, 0, 2 rad/s",
        "angular_acceleration": "0, 0, 5 rad/s^2",
        "base_velocity": "3, 0, 0 m/s",
        "points[0].position": "0.5, 0, 0 m",
        "points[0].name": "A",
        "points[1].position": "0.5, 0.4, 0 m",
        "points[1].name": "B",
    },
    examples=(
        'dynamics orient points --angular-velocity "0, 0, 2 rad/s" --angular-acceleration "0, 0, 5 rad/s^2" '
        '--base-velocity "3, 0, 0 m/s" --body-point "position=(0.5, 0, 0 m), name=A" '
        '--body-point "position=(0.5, 0.4, 0 m), name=B"',
        'dynamics orient points --body-point "position=(0, 0, 0 m), velocity=(1, 0, 0.2 m/s)" '
        '--body-point "position=(1, 0, 0 m), velocity=(1, 2, 0.2 m/s)" '
        '--body-point "position=(0, 1, 0 m), velocity=(-1, 0, 0.2 m/s)"',
    ),
)

MOVING_POINT = Task(
    "moving-point",
    "Velocity and acceleration of a point that moves on a moving body, term by term.",
    Model(
        "moving frame",
        "dynamics_cli.numerics.orientation.moving_frame:moving_frame",
        formula="v = v_O + ω × r + v_rel, a = a_O + α × r + ω × (ω × r) + 2·ω × v_rel + a_rel",
        assumptions=(RIGID, "all vectors in one set of axes"),
    ),
    headline=(
        "velocity: velocity v",
        "speed: |v|",
        "acceleration: acceleration a",
        "acceleration_size: |a|",
        "angular_part: tangential α × r",
        "centripetal: centripetal ω × (ω × r)",
        "coriolis: Coriolis 2 ω × v_rel",
        "relative_part: relative a_rel",
    ),
    plot="dynamics_cli.orient.pictures.motion:moving_point",
    examples=(
        'dynamics orient moving-point --angular-velocity "0, 0, 20 rpm" --position "3, 0, 0 m" '
        '--relative-velocity "0.5, 0, 0 m/s" --angular-acceleration "0, 0, 0.4 rad/s^2"',
    ),
)

ROLLING = Task(
    "rolling",
    "Rates at which two bodies roll on each other; slip, spin and roll.",
    Model(
        "equal velocities at the contact",
        "dynamics_cli.orient.contact.rolling:rolling",
        formula="v₁ + ω₁ × r₁ = v₂ + ω₂ × r₂ along the surfaces",
        assumptions=(RIGID, "they touch at one point", "rates are constant where α is given"),
    ),
    headline=(
        "first.rate: rate of the first",
        "second.rate: rate of the second",
        "first.angular_velocity: angular velocity of the first ω₁",
        "first.angular_speed: |ω₁|",
        "first.angular_acceleration: angular acceleration of the first α₁",
        "second.angular_velocity: angular velocity of the second ω₂",
        "slip_speed: slip",
        "closing_speed: speed along the normal",
        "spin: spin about the normal",
        "roll_speed: roll",
    ),
    plot="dynamics_cli.orient.pictures.motion:rolling",
    examples=(
        'dynamics orient rolling --contact "1, 0, 0 m" --normal "0, 0, 1" --first-angular-velocity "0, 0, 2 rad/s" '
        '--first-axis "0.9396926, 0, 0.3420201"',
        'dynamics orient rolling --contact "0, 0, 0 m" --normal "0, 0, 1" --first-axis "0, 1, 0" '
        '--first-point "0, 0, 0.3 m" --first-velocity "6, 0, 0 m/s"',
    ),
)

DISK = Task(
    "disk",
    "Motion of a disk rolling on a level floor, in any attitude.",
    Model(
        "thin disk rolling without slip",
        "dynamics_cli.orient.contact.disk:disk",
        formula="v_G = (−r·u, 0, r·θ̇), u = ψ̇ + φ̇·cos θ",
        assumptions=(
            "components are along the line of nodes, up the disk, and along its axis",
            "the disk is thin and the floor level",
            "it rolls without slipping",
        ),
    ),
    headline=(
        "angular_velocity: angular velocity ω",
        "angular_acceleration: angular acceleration α",
        "centre_velocity: velocity of the centre v_G",
        "centre_speed: |v_G|",
        "centre_acceleration: acceleration of the centre a_G",
        "contact_acceleration: acceleration of the contact",
        "rim_velocity: velocity of the rim point",
        "contact_path_speed: speed of the contact on the floor",
        "centre_path_radius: radius of the centre's circle",
        "contact_path_radius: radius of the circle on the floor",
    ),
    plot="dynamics_cli.orient.pictures.contact:disk",
    examples=(
        'dynamics orient disk --radius "350 mm" --tilt "60 deg" --heading-rate "1.5 rad/s" --spin-rate "-6 rad/s" '
        '--tilt-rate "0.4 rad/s"',
        'dynamics orient disk --radius "13 in" --tilt "75 deg" --heading-rate "40 deg/s" --spin-rate "-90 rpm" '
        "--units us",
    ),
)

BEARING = Task(
    "bearing",
    "Ball between a fixed race and a conical shaft: radius without spin, and speeds.",
    Model(
        "rolling at three contacts",
        "dynamics_cli.orient.contact.bearing:bearing",
        formula="{rolling_radius|b} = {ball_radius|a}·(1 + sin{cone_angle|θ})/(cos{cone_angle|θ} − sin{cone_angle|θ})",
        assumptions=("floor and wall of the race are fixed, at right angles", "balls roll without slipping"),
    ),
    headline=(
        "rolling_radius: radius without spin b",
        "contact_radius: radius of the shaft there",
        "cage_ratio: cage over shaft",
        "ball_ratio: ball over shaft",
        "spin_ratio: spin over shaft",
        "cage_speed: speed of the cage",
        "ball_speed: speed of a ball",
        "spin_speed: spin at the shaft",
    ),
    plot="dynamics_cli.orient.pictures.contact:bearing",
    examples=(
        'dynamics orient bearing --cone-angle "25 deg" --ball-radius "12 mm" --shaft-speed "1500 rpm"',
        'dynamics orient bearing --cone-angle "25 deg" --ball-radius "12 mm" --centre-radius "40 mm"',
    ),
)

JOINT = Task(
    "joint",
    "Angle, speed ratio and acceleration of a universal joint, or of two.",
    Model(
        "universal joint",
        "dynamics_cli.orient.contact.joint:joint",
        formula="{ratio|i} = cos{joint_angle|β}/(1 − sin²{joint_angle|β}·cos²{input_angle|θ})",
        assumptions=("axes meet at the centre of the joint", "of two joints, all shafts are in one plane"),
    ),
    headline=(
        "output_angle: angle of the driven shaft",
        "lead",
        "ratio: speed ratio i",
        "highest_ratio: highest ratio in a turn 1/cos β",
        "lowest_ratio: lowest ratio cos β",
        "unevenness",
        "output_speed: speed of the driven shaft",
        "output_acceleration: its acceleration",
        "intermediate_ratio: ratio of the intermediate shaft",
    ),
    plot="dynamics_cli.orient.pictures.contact:joint",
    examples=(
        'dynamics orient joint --joint-angle "30 deg" --input-angle "50 deg" --speed "1500 rpm"',
        'dynamics orient joint --joint-angle "20 deg" --second-joint-angle "15 deg" --input-angle "30 deg"',
    ),
)

TASKS: "tuple[Task, ...]" = (
    RATES, ADDITION, POINTS, MOVING_POINT, ROLLING, DISK, BEARING, JOINT,
)  # fmt: skip
