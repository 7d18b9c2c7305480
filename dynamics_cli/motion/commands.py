"""The tasks of `dynamics motion`."""

from dynamics_cli.core.answering.task import Family, Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
PICTURES = "dynamics_cli.motion.pictures"

CHAIN = Task(
    "chain",
    "Rods pinned to one another, let go: motion, pin forces, and how long it can be known.",
    Model(
        "chain of rods, integrated",
        "dynamics_cli.motion.chain:chain",
        source=BOOK + "sections 12.4 and 12.5",
        formula="Σ_j a_ij·[q̈_j·cos(q_i − q_j) + q̇_j²·sin(q_i − q_j)] + {gravity|g}·b_i·sin q_i = 0",
        assumptions=("rigid rods in one vertical plane, their centres in the middle", "no friction, no drag"),
        method="DOP853, two tolerances",
        together="dynamics_cli.motion.side_by_side:chains",
    ),
    headline=(
        "verdict: answer", "difference: two runs apart by",
        "energy_error: energy kept to", "top_force: largest force in the top pin",
        "angle: lowest rod at the end",
        "rods: at the end",
        "motion: motion | time, angles, rates",
    ),
    examples=(
        'dynamics motion chain --lengths "0.5, 0.5, 0.5 m" --masses "1 kg" --angles "30, -20, 45 deg" '
        '--duration "2 s" --steps 4',
        'dynamics motion chain --lengths "1, 1 m" --masses "0 kg" --end-masses "1 kg" --angles "90 deg" '
        '--duration "10 s"',
    ),
    table="motion",
    plot=f"{PICTURES}:chain",
    arrays=False,
    tracked=False,
    errors=("horizon", "tenfold", "difference", "energy_error"),
)  # fmt: skip

MODES = Task(
    "modes",
    "Small oscillations of a hanging chain: frequencies and shapes.",
    Model(
        "chain of rods, small angles",
        "dynamics_cli.motion.modes:modes",
        source=BOOK + "sections 12.5 and 13.8; Drmač & Veselić, SIAM J. Matrix Anal. Appl. 29 (2008) 1322",
        formula="({gravity|g}·diag b − ω²·A)·φ = 0",
        assumptions=("small angles about hanging at rest", "no friction, no drag"),
        method="one-sided Jacobi",
    ),
    headline=(
        "slowest: lowest frequency", "fastest: highest frequency",
        "modes: modes | number=mode, frequency, period, shape=angles, ends=ends sideways",
    ),
    examples=(
        'dynamics motion modes --lengths "0.5, 0.5, 0.5 m" --masses "1 kg"',
        'dynamics motion modes --lengths "1, 1, 1 m" --masses "0 kg" --end-masses "1e-6, 1, 1e6 kg"',
    ),
    table="modes",
    plot=f"{PICTURES}:modes",
    arrays=False,
    tracked=False,
)  # fmt: skip


def _shown() -> "dict[str, str]":
    """Template values: an arm on a spring, turned by a torque."""
    arm = {"name": "arm", "mass": "2 kg", "rod": "true", "angle": "-50 deg"}
    scene = {"links[0].name": "ground"} | {f"links[1].{key}": value for key, value in arm.items()}
    points = ((0, (("O", "0, 0 mm"), ("S", "0, 300 mm"))), (1, (("O", "0, 0 mm"), ("P", "400, 0 mm"))))
    for link, pair in points:
        for place, (name, at) in enumerate(pair):
            scene |= {f"links[{link}].points[{place}].name": name, f"links[{link}].points[{place}].at": at}
    spring = {"from": "S", "to": "P", "stiffness": "0.2 N/mm", "free_length": "450 mm"}
    scene |= {f"springs[0].{key}": value for key, value in spring.items()}
    return scene | {"loads[0].link": "arm", "loads[0].torque": "1 - 0.1*speed N*m"}


SCENES = "dynamics_cli.motion.scenes"
TAILGATE = "examples/tailgate/tailgate.toml"
RIGID = ("rigid bodies in one plane", "pins and slides without play and friction")

SCENE = Task(
    "scene",
    "Planar bodies from a file: motion, forces in the joints, and how long it can be known.",
    Model(
        "bodies and joints, integrated",
        f"{SCENES}.scene:scene",
        source=BOOK + "section 12.2",
        formula="M·a + Jᵀ·λ = Q, J·a = γ; E + loss − work stays",
        assumptions=RIGID,
        method="DOP853 or Radau, two tolerances",
        together=f"{SCENES}.side_by_side:scenes",
    ),
    headline=(
        "verdict: answer", "ends: ends at", "horizon: horizon, about", "tenfold: errors grow tenfold in",
        "difference: two runs apart by", "energy_error: energy and work balance to",
        "driver_work: work of drivers", "load_work: work of loads", "damper_loss: lost in dampers",
        "largest_force: largest joint force",
        "time: state at", "angle: angle then", "speed: speed then", "x: x then", "y: y then",
        "links: link | name, angle, speed, centre, velocity",
        "reactions: joint | joint, on, force, moment, largest, largest_moment, when",
        "motion: motion | time, angle, speed, angular_acceleration=α, position, velocity, acceleration, force_x, "
        "force_y, moment",
    ),
    scene=_shown() | {"duration": "2 s"},
    examples=(
        f"dynamics motion scene {TAILGATE} --duration '3 s'",
        f"dynamics motion scene {TAILGATE} --duration '3 s' --follow gate --steps 6",
    ),
    table="motion links",
    plot=f"{SCENES}.pictures:scene_picture",
    writers={"svg": f"{SCENES}.pictures:moving_scene"},
    arrays=False,
    tracked=False,
    errors=("ends", "horizon", "tenfold", "difference", "energy_error", "start_moved", "drift", "time"),
    unused=("place",),
)  # fmt: skip

EQUILIBRIUM = Task(
    "equilibrium",
    "Planar bodies from a file: where they stand still, whether that is stable, frequencies.",
    Model(
        "balance of forces on the joints",
        f"{SCENES}.equilibrium:equilibrium",
        source=BOOK + "section 14.2",
        formula="Q(q) − Jᵀ·λ = 0; stable where ZᵀKZ > 0",
        assumptions=RIGID,
        method="Newton",
    ),
    headline=(
        "stability: equilibrium shown",
        "places: equilibria | number, stability, lowest=lowest frequency, energy, angles",
        "reactions: joint forces | joint, on, by, force, force_x, force_y, moment",
        "springs: springs | name, length, pull",
    ),
    scene=_shown(),
    examples=(f"dynamics motion equilibrium {TAILGATE}", f"dynamics motion equilibrium {TAILGATE} --place 2"),
    table="places",
    plot=f"{SCENES}.pictures:equilibrium_picture",
    unused=("duration", "at", "follow", "steps"),
    arrays=False,
    tracked=False,
)  # fmt: skip

SHOWN = {
    "let": "L=0.8 m",
    "coordinates[0].name": "x", "coordinates[0].position": "0.1 m", "coordinates[0].velocity": "0.5 m/s",
    "coordinates[1].name": "theta", "coordinates[1].angle": "30 deg", "coordinates[1].rate": "2 rad/s",
    "bodies[0].name": "block", "bodies[0].mass": "2 kg", "bodies[0].x": "x m", "bodies[0].y": "0 m",
    "bodies[1].name": "rod", "bodies[1].mass": "1 kg", "bodies[1].inertia": "0.0533 kg*m^2",
    "bodies[1].x": "x + L/2*sin(theta) m", "bodies[1].y": "-L/2*cos(theta) m", "bodies[1].angle": "theta rad",
    "springs[0].name": "spring", "springs[0].start": "origin", "springs[0].end": "block",
    "springs[0].stiffness": "50 N/m",
}  # fmt: skip

EQUATIONS = Task(
    "equations",
    "Equations of motion of bodies given by formulas: Kane's beside Lagrange's.",
    Model(
        "Kane's equations",
        "dynamics_cli.motion.equations.task:equations",
        source=BOOK + "chapters 11 and 12",
        formula="F_r + F*_r = 0, F_r = Σ F·v_r + M·ω_r, F*_r = −Σ m·a·v_r + (I·α + ω × I·ω)·ω_r; "
        "d/dt ∂T/∂q̇_r − ∂T/∂q_r = Q_r + Σ λ·a_r",
        assumptions=("rigid bodies", "constraints kept by formulas of the coordinates, or linear in their rates"),
        method="exact derivatives by jets",
    ),
    headline=(
        "equations: coordinate | name, acceleration=q̈, by_lagrange=by Lagrange, active_force=active F_r, "
        "velocity_force=inertia F*_r at q̈ = 0",
        "speeds: speed | name, value=u, acceleration=u̇, active_force=F̃_r",
        "conditions: condition | name, force=kept by, by_lagrange=λ by Lagrange",
        "drive_power: power of the drive",
        "terms: part | of, sort, velocity=v_r, force=F, angular_velocity=ω_r, moment=M, share",
    ),
    scene=SHOWN,
    examples=(
        "dynamics motion equations examples/sliding_rod/sliding_rod.toml",
        "dynamics motion equations examples/sliding_rod/sliding_rod.toml --terms theta",
        "dynamics motion equations examples/sleigh/sleigh.toml",
    ),
    table="equations",
    errors=("difference",),
    arrays=False,
)  # fmt: skip

FAMILIES = {
    "motion": Family(
        "motion",
        "Motion of bodies and chains, how long it is known; equilibrium.",
        CHAIN, MODES, SCENE, EQUILIBRIUM, EQUATIONS,
    )
}  # fmt: skip
