"""Tasks of `dynamics linkage`: one body, an open chain."""

from dynamics_cli.core.answering.task import Model, Task

BODY = Task(
    "body",
    "Plane motion of a body: ω, α, instant centre, centre of zero acceleration, motion of further points.",
    Model(
        "rigid body in plane motion",
        "dynamics_cli.linkage.bodies.body:body",
        formula="P = A + k×v/{angular_velocity|ω}; "
        "J = A + a·({angular_velocity|ω}² + i·α)/({angular_velocity|ω}⁴ + α²)",
        assumptions=("the body is rigid and moves in one plane",),
    ),
    headline=(
        "angular_velocity: angular velocity ω",
        "angular_acceleration: angular acceleration α",
        "instant_centre: instant centre P",
        "distance: distance A–P",
        "zero_acceleration: zero acceleration at J",
        "inflection_diameter: inflection circle, diameter",
        "parting: departure from rigidity",
        "points: point | position, velocity, acceleration, radius_of_curvature=ρ",
    ),
    examples=(
        'dynamics linkage body --point "0, 0 mm" --velocity "2, 0 m/s" --second-point "0, 300 mm" '
        '--second-velocity "0.5, 0 m/s"',
        'dynamics linkage body --point "0, 0 mm" --velocity "2, 1 m/s" --acceleration "0, -5 m/s^2" '
        '--angular-velocity "4 rad/s" --angular-acceleration "3 rad/s^2" --place "x=100 mm, y=50 mm"',
    ),
    arrays=False,
    plot="dynamics_cli.linkage.bodies.pictures:body_picture",
)

CHAIN = Task(
    "chain",
    "Open chain of links: joints, velocities, accelerations, partial velocities.",
    Model(
        "sum of links",
        "dynamics_cli.linkage.bodies.chain:chain",
        formula="r = Σ l·e^(iθ), v = Σ iω·l·e^(iθ), a = Σ (iα − ω²)·l·e^(iθ)",
        assumptions=("rigid links in one plane, pins without play",),
    ),
    headline=(
        "position: tip",
        "velocity: velocity of the tip",
        "acceleration: acceleration of the tip",
        "angular_velocity: ω of the last link",
        "angular_acceleration: α of the last link",
        "joints: joint | link, angle, position, velocity, acceleration, partial_velocity=∂r/∂θ",
    ),
    examples=(
        'dynamics linkage chain --chain-link "length=300 mm, angle=30 deg, speed=2 rad/s" '
        '--chain-link "length=200 mm, angle=75 deg, speed=-1 rad/s"',
    ),
    arrays=False,
    plot="dynamics_cli.linkage.bodies.pictures:chain_picture",
)

TASKS: "tuple[Task, ...]" = (BODY, CHAIN)
