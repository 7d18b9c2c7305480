"""Tasks of `dynamics orient`: turns themselves."""

from dynamics_cli.core.answering.task import Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
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
        "euler_angles: angles",
        "names: that is",
        "quaternion: quaternion w, x, y, z",
        "rotation_angle: angle of the turn θ",
        "rotation_axis: axis of the turn n",
        "rotation_matrix: matrix",
        "lock_distance: distance from lock",
    ),
    table="sequences",
    plot="dynamics_cli.orient.pictures.triads:converted",
    examples=(
        'dynamics orient convert --euler-angles "30, 20, -40 deg" --euler-order zyx',
        'dynamics orient convert --quaternion "0.5, 0.5, 0.5, 0.5" --sequence rpy',
        'dynamics orient convert --rotation-matrix "[[0, 0, 1], [1, 0, 0], [0, 1, 0]]" --sequence zxz',
        'dynamics orient convert --from-direction "1, 0, 0" --to-direction "1, 1, 0.2"',
    ),
)

TASKS: "tuple[Task, ...]" = (CONVERT,)
