"""Tasks of `dynamics orient`: turns themselves."""

from dynamics_cli.core.answering.task import Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
NAMES = "dynamics_cli.numerics.orientation.sequences:ALL"
SENSE = "axes are right-handed, angles counter-clockwise seen from the tip of the axis"

CONVERT = Task(
    "convert",
    "A rotation in every notation, from any of them.",
    Model(
        "rotations",
        "dynamics_cli.orient.turns.convert:convert",
        source=BOOK + "sections 4.2, 18.5, 18.7; Bernardes & Viollet 2022",
        formula="q = (cos ½{rotation_angle|θ}, n·sin ½{rotation_angle|θ}), R = 1 + sin{rotation_angle|θ}·[n×] + "
        "(1 − cos{rotation_angle|θ})·[n×]²",
        assumptions=(SENSE, "the matrix takes body components to fixed ones: its columns are the body axes"),
    ),
    headline=(
        "euler_angles: {angle_names}",
        "quaternion: quaternion w, x, y, z",
        "rotation_angle: angle of the turn θ",
        "rotation_axis: axis of the turn n",
        "rotation_matrix: matrix",
        "names: also called",
    ),
    table="sequences",
    names={"sequence": NAMES, "euler-order": NAMES},
    plot="dynamics_cli.orient.pictures.triads:converted",
    examples=(
        'dynamics orient convert --euler-angles "30, 20, -40 deg" --euler-order zyx',
        'dynamics orient convert --quaternion "0.5, 0.5, 0.5, 0.5" --sequence rpy',
        'dynamics orient convert --rotation-matrix "[[0, 0, 1], [1, 0, 0], [0, 1, 0]]" --sequence zxz',
        'dynamics orient convert --from-direction "1, 0, 0" --to-direction "1, 1, 0.2"',
    ),
)

COMPOSE = Task(
    "compose",
    "Total of a chain of rotations, and direction cosines between all frames.",
    Model(
        "product of turns",
        "dynamics_cli.orient.turns.compose:compose",
        formula="R = R₁·R₂·…·Rₙ about the body's axes, Rₙ·…·R₂·R₁ about the fixed ones",
        assumptions=(SENSE, "each turn is about an axis of its frame"),
    ),
    headline=(
        "rotation_angle: angle of the total turn θ",
        "rotation_axis: its axis n",
        "quaternion: quaternion w, x, y, z",
        "rotation_matrix: matrix",
        "frames",
        "cosines: direction cosines",
    ),
    table="cosines",
    plot="dynamics_cli.orient.pictures.triads:configuration",
    examples=(
        'dynamics orient compose --simple-turn "axis=z, angle=40 deg" --simple-turn "axis=x, angle=25 deg" '
        '--simple-turn "axis=z, angle=70 deg"',
        'dynamics orient compose --simple-turn "axis=z, angle=30 deg, name=cradle" '
        '--simple-turn "axis=y, angle=20 deg, name=tool" --base machine',
        'dynamics orient compose --general-turn "yaw=30 deg, pitch=10 deg, name=robot" '
        '--general-turn "quaternion=(0.924, 0, 0.383, 0), name=tool"',
    ),
)

BETWEEN = Task(
    "between",
    "Rotation from one orientation to another, its part about an axis, orientations in between.",
    Model(
        "quaternions",
        "dynamics_cli.orient.turns.between:between",
        formula="q = q₁⁻¹·q₂ = (cos ½{rotation_angle|θ}, n·sin ½{rotation_angle|θ}); ω = {rotation_angle|θ}·n/{time|t}",
        assumptions=(SENSE, "the shorter way round"),
    ),
    headline=(
        "rotation_angle: angle between them θ",
        "rotation_axis: axis, fixed components",
        "body_axis: axis, body components",
        "angular_velocity: mean angular velocity ω",
        "body_angular_velocity: ω, body components",
        "part_about: part about the axis given",
        "rest: tilt of that axis",
        "quaternion: quaternion w, x, y, z",
        "steps: in between",
    ),
    table="steps",
    names={"sequence": NAMES},
    plot="dynamics_cli.orient.pictures.triads:between",
    examples=(
        'dynamics orient between --first-euler-angles "0, 0, 0 deg" --first-euler-order zyx '
        '--second-euler-angles "30, 20, -40 deg" --second-euler-order zyx --about "0, 0, 1"',
        'dynamics orient between --first-quaternion "1, 0, 0, 0" --second-quaternion "0.5, 0.5, 0.5, 0.5" --count 3',
        'dynamics orient between --first-yaw "10 deg" --second-yaw "12 deg" --second-roll "1 deg" --time "10 ms"',
    ),
)

SCREW = Task(
    "screw",
    "Screw axis, rotation angle and travel of a displacement.",
    Model(
        "screw axis",
        "dynamics_cli.orient.turns.screw:screw",
        formula="{travel|s} = n·d, p = ½·(d⊥ + cot ½{rotation_angle|θ}·n × d⊥)",
        assumptions=(SENSE, "d is the displacement of the body's point that was at the origin"),
    ),
    headline=(
        "rotation_angle: angle of the turn θ",
        "travel: travel along the axis s",
        "lead: travel for a whole turn",
        "axis: axis n",
        "point: point of the axis nearest the origin",
    ),
    plot="dynamics_cli.orient.pictures.triads:screw",
    examples=(
        'dynamics orient screw --euler-angles "40, 25, 70 deg" --euler-order zxz --displacement "0.2, -0.1, 0.3 m"',
        'dynamics orient screw --rotation-axis "0, 0, 1" --rotation-angle "90 deg" --displacement "1, 0, 0 ft" '
        '--of-point "2, 0, 0 ft" --units us',
    ),
)

ALIGN = Task(
    "align",
    "Rotation that takes given directions to measured ones.",
    Model(
        "least squares",
        "dynamics_cli.orient.turns.align:align",
        source="Wahba 1965; Davenport's q-method",
        formula="Σ wᵢ·|R·bᵢ − aᵢ|² = least",
        assumptions=(SENSE, "directions before are in body components, those after in fixed components"),
        method="Jacobi rotations",
    ),
    headline=(
        "euler_angles: {angle_names}",
        "quaternion: quaternion w, x, y, z",
        "rotation_angle: angle of the turn θ",
        "rotation_axis: axis of the turn n",
        "residual: residual (rms)",
        "sharpness: sharpness",
        "pairs",
    ),
    arrays=False,
    tracked=False,
    table="pairs",
    names={"sequence": NAMES},
    plot="dynamics_cli.orient.pictures.triads:aligned",
    scene={
        "pairs[0].before": "1, 0, 0",
        "pairs[0].after": "0.1, 0.99, 0",
        "pairs[1].before": "0, 1, 0",
        "pairs[1].after": "-0.98, 0.12, 0.05",
    },
    examples=(
        'dynamics orient align --pair "before=(1, 0, 0), after=(0.1, 0.99, 0)" '
        '--pair "before=(0, 0, 1), after=(0, 0.02, 1)"',
        'dynamics orient align --pair "before=(1, 0, 0), after=(0, 1, 0), name=edge" '
        '--pair "before=(0, 1, 0), after=(-1, 0, 0.1), name=face" --fit triad',
    ),
)

AVERAGE = Task(
    "average",
    "Mean of several orientations or of a log, and the scatter about it.",
    Model(
        "least squares",
        "dynamics_cli.orient.turns.average:average",
        source="Markley, Cheng, Crassidis & Oshman, J. Guid. Control Dyn. 30, 2007",
        formula="Σ wᵢ·|R − Rᵢ|² = least",
        assumptions=(SENSE,),
        method="Jacobi rotations",
    ),
    headline=(
        "euler_angles: {angle_names}",
        "quaternion: quaternion w, x, y, z",
        "rotation_angle: angle of the turn θ",
        "scatter: scatter (rms)",
        "largest_deviation: largest deviation",
        "farthest: that of",
        "count: orientations",
        "deviations",
    ),
    arrays=False,
    tracked=False,
    table="deviations",
    names={"sequence": NAMES},
    scene={
        "readings[0].yaw": "10 deg",
        "readings[1].yaw": "12 deg",
        "readings[1].pitch": "1 deg",
    },
    examples=(
        'dynamics orient average --reading "yaw=10 deg, pitch=2 deg" --reading "yaw=11 deg, pitch=1.5 deg" '
        '--reading "yaw=10.2 deg, roll=1 deg"',
        "dynamics orient average --log examples/imu/log.csv --sequence rpy",
    ),
    plot="dynamics_cli.orient.pictures.scatter:average",
)

TASKS: "tuple[Task, ...]" = (CONVERT, COMPOSE, BETWEEN, SCREW, ALIGN, AVERAGE)
