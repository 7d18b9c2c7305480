"""Tasks of `dynamics linkage`: one body, an open chain, linkages from scenes."""

from dynamics_cli.core.answering.task import Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
RIGID = "rigid links in one plane, pins and slides without play"
SIX_BAR = "examples/six_bar.toml"


def _shown() -> "dict[str, str]":
    """Template values: a four-bar with a driven crank."""
    links = (
        ("ground", ("O2", "0, 0 mm"), ("O4", "100, 0 mm")),
        ("crank", ("O2", "0, 0 mm"), ("A", "40, 0 mm")),
        ("coupler", ("A", "0, 0 mm"), ("B", "120, 0 mm")),
        ("rocker", ("O4", "0, 0 mm"), ("B", "80, 0 mm")),
    )
    scene = {}
    for index, (name, *points) in enumerate(links):
        scene[f"links[{index}].name"] = name
        for place, (pin, position) in enumerate(points):
            scene[f"links[{index}].points[{place}].name"] = pin
            scene[f"links[{index}].points[{place}].at"] = position
    driver = {"link": "crank", "angle": "40 deg", "speed": "10 rad/s"}
    side = {"pin": "B", "side": "left"}
    scene |= {f"drivers[0].{key}": value for key, value in driver.items()}
    return scene | {f"sides[0].{key}": value for key, value in side.items()}


SHOWN = _shown()

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

SOLVE = Task(
    "solve",
    "Any planar linkage from a scene of links, pins, slides and drivers: position, velocity, acceleration, proved.",
    Model(
        "dyads, then Newton with a certificate",
        "dynamics_cli.linkage.scenes.solve:solve",
        source=BOOK + "sections 5.2 and 5.6; Kantorovich's theorem",
        formula="½(|P − Q|² − L²) = 0, (R − P)×(Q − P) = 0; J·q̇ = −Φ_t; h = ‖J⁻¹‖·√Σ‖H‖²·‖J⁻¹Φ‖ ≤ ½",
        assumptions=(RIGID,),
        method="closed form and Newton–Kantorovich",
    ),
    headline=(
        "assembly: assembly",
        "driver_from: driver from",
        "driver_to: driver to",
        "followed_by: this motion is",
        "motion: motion | driver_angle=driver, driver_position=driver at, angle, speed=ω, acceleration=α, position, "
        "velocity, pin_acceleration=a",
        "links: link | name, angle, speed=ω, acceleration=α",
        "pins: pin | name, position, velocity, acceleration",
        "every_assembly: assembly | number, sides, pin, position",
    ),
    scene=SHOWN,
    examples=(f"dynamics linkage solve {SIX_BAR}",),
    table="motion pins",
    arrays=False,
    tracked=False,
    plot="dynamics_cli.linkage.scenes.pictures:scene_picture",
    writers={"svg": "dynamics_cli.linkage.scenes.pictures:moving_scene"},
)

CENTRES = Task(
    "centres",
    "Instant centres of every two links of a linkage, centres at infinity among them.",
    Model(
        "velocities of the links",
        "dynamics_cli.linkage.scenes.centres:centres",
        formula="I_ij = i·(v_j − v_i)/(ω_j − ω_i), v of the links' points at the origin",
        assumptions=(RIGID,),
    ),
    headline=(
        "count: instant centres",
        "centres: centre | first, second, position, direction, ratio=ω/ω",
    ),
    scene=SHOWN,
    examples=(f"dynamics linkage centres {SIX_BAR}",),
    table="centres",
    arrays=False,
    tracked=False,
    plot="dynamics_cli.linkage.scenes.pictures:centres_picture",
)

MOBILITY = Task(
    "mobility",
    "Degrees of freedom of a linkage: counted, and true at its pose; redundant conditions.",
    Model(
        "Grübler's count and the rank of the Jacobian",
        "dynamics_cli.linkage.scenes.mobility:mobility",
        formula="{counted|M} = 3·({links|n} − 1) − 2·{pins|j₁} − {slides|j₂}",
        assumptions=(RIGID,),
        method="singular values",
    ),
    headline=(
        "freedom: degrees of freedom",
        "counted: counted 3(n − 1) − 2j₁ − j₂",
        "links: links n",
        "pins: pins j₁",
        "slides: slides j₂",
        "repeated: redundant conditions",
        "named: conditions involved",
    ),
    scene=SHOWN,
    examples=(f"dynamics linkage mobility {SIX_BAR}",),
    arrays=False,
    tracked=False,
)

BODIES: "tuple[Task, ...]" = (BODY, CHAIN)
SCENES: "tuple[Task, ...]" = (CENTRES, MOBILITY, SOLVE)
