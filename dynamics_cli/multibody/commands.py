"""The tasks of `dynamics multibody`."""

from dynamics_cli.core.answering.task import Family, Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
PACKAGE = "dynamics_cli.multibody."
RIGID = ("rigid bodies", "joints without play and friction")
CRANE = "examples/swing_crane/swing_crane.toml"


def _shown() -> "dict[str, str]":
    """Template values: a mast that turns, and a boom on it."""
    mast = {"name": "mast", "joint": "revolute", "axis": "0, 0, 1", "mass": "4 kg", "centroid": "0, 0, 0.2 m",
            "moments": "0.3, 0.3, 0.2 kg*m^2", "speed": "1.2 rad/s"}  # fmt: skip
    boom = {"name": "boom", "parent": "mast", "axis": "0, 1, 0", "position": "0.3, 0, 0.4 m", "mass": "2 kg",
            "rod": "1, 0, 0 m", "angle": "-20 deg", "torque": "30 N*m"}  # fmt: skip
    return {f"bodies[{k}].{key}": value for k, body in enumerate((mast, boom)) for key, value in body.items()}


TOPOLOGY = Task(
    "topology",
    "How bodies hang together: lower body array, paths, branches, degrees of freedom.",
    Model(
        "lower body array",
        PACKAGE + "instant.topology:topology",
        source=BOOK + "sections 18.2 and 18.8",
        formula="L⁰(K) = K, Lʲ(K) = L(Lʲ⁻¹(K))",
        method="counting",
    ),
    headline=(
        "bodies: bodies", "freedoms: degrees of freedom of the tree", "loops: loops",
        "constraints: conditions of the loops", "least_freedoms: degrees of freedom at least",
        "ends: end bodies", "branching: branching bodies", "depth: longest path",
        "tree: K | number=K, name, lower=L(K), sort, joint, speeds, path",
        "powers: powers of L | power=j, array=Lʲ(K)",
        "typed: places as typed",
    ),
    scene=_shown(),
    examples=(
        f"dynamics multibody topology {CRANE}",
        "dynamics multibody topology --lower-bodies 0,1,2,3,4,5,3,7,3,9,10,1,12,13,1,15,16",
    ),
    table="tree",
    arrays=False,
    tracked=False,
)  # fmt: skip

KINEMATICS = Task(
    "kinematics",
    "Places, velocities and accelerations of bodies in space from the motion of their joints.",
    Model(
        "recursion along the tree",
        PACKAGE + "instant.kinematics:kinematics",
        source=BOOK + "sections 18.3 to 18.14",
        formula="v_P = Σ v_l·y_l, ω_K = Σ ω_l·y_l; S_OK = S_OJ·S_JK",
        assumptions=RIGID,
        method="recursion from the ground outwards",
    ),
    headline=(
        "point_position: point at", "point_velocity: its velocity", "point_acceleration: its acceleration",
        "bodies: mass centres, in ground axes | body, centre, velocity",
        "turning: turning | body, angular_velocity=ω, angular_acceleration=α",
        "partials: partial velocities | speed, velocity=v_l of the point, angular_velocity=ω_l of the body",
        "kinetic_energy: kinetic energy T",
    ),
    scene=_shown(),
    examples=(
        f"dynamics multibody kinematics {CRANE}",
        f"dynamics multibody kinematics {CRANE} --of boom --point '6, 0, 0 m'",
    ),
    table="bodies turning partials",
    plot=PACKAGE + "pictures:scene_picture",
    arrays=False,
)  # fmt: skip

MASS_MATRIX = Task(
    "mass-matrix",
    "The mass matrix of a tree of bodies, and weight, velocity, spring and load forces.",
    Model(
        "Kane's equations",
        PACKAGE + "instant.matrix:matrix",
        source=BOOK + "sections 18.16 and 18.17",
        formula="a_lp = Σ m_K·v_Kl·v_Kp + ω_Kl·I_K·ω_Kp",
        assumptions=RIGID,
        method="composite bodies",
    ),
    headline=(
        "condition: condition, free of units",
        "forces: equation of | name=speed, inertia=a_ll, weight, velocity, springs, loads, motor",
        "couplings: coupled | name=speed, other=with, value=a_lp",
    ),
    scene=_shown(),
    examples=(
        f"dynamics multibody mass-matrix {CRANE}",
        f"dynamics multibody mass-matrix {CRANE} --table couplings --format csv",
    ),
    table="couplings",
    errors=("eigenvalues", "condition"),
    arrays=False,
)  # fmt: skip

EFFORTS = Task(
    "efforts",
    "Inverse dynamics: the torques and forces that joints need for a motion, and what they transmit.",
    Model(
        "recursive Newton–Euler",
        PACKAGE + "instant.efforts:efforts",
        source=BOOK + "sections 18.15 to 18.17; Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 5",
        formula="f = m·a_C, n = I·α + ω × I·ω + c × f, from the ends inwards; effort = axis·n or axis·f",
        assumptions=RIGID,
        method="recursion outwards and inwards",
    ),
    headline=(
        "effort: effort",
        "efforts: joint | name=speed, effort, weight=of it weight, inertia, velocity, loads, springs",
        "power: power of the motors",
        "reactions: joint forces | joint=on, by, force, moment",
    ),
    scene=_shown(),
    examples=(
        f"dynamics multibody efforts {CRANE}",
        f"dynamics multibody efforts {CRANE} --up none",
    ),
    table="efforts",
    plot=PACKAGE + "pictures:scene_picture",
    arrays=False,
    also=("inverse-dynamics", "torques"),
)  # fmt: skip

ACCELERATIONS = Task(
    "accelerations",
    "Forward dynamics: how bodies move under weight, loads, springs and motors, loops among them.",
    Model(
        "articulated bodies, loops by orthogonal complement",
        PACKAGE + "instant.accelerations:accelerations",
        source=BOOK + "sections 18.15 to 18.17, 19.17; Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 7",
        formula="Σ a_lp·ẏ_p = F_l − h_l; with loops (CᵀM·C)·ż = Cᵀ(F − h − M·ẏ_p), B·C = 0",
        assumptions=RIGID,
        method="articulated bodies",
    ),
    headline=(
        "acceleration: acceleration",
        "accelerations: joint | name=speed, acceleration=ẏ, effort=motor, springs, speed=y",
        "reactions: joint forces | joint=on, by, force, moment, undetermined=open",
        "kinetic_energy: kinetic energy T", "potential_energy: potential energy V",
    ),
    scene=_shown(),
    examples=(
        f"dynamics multibody accelerations {CRANE}",
        "dynamics multibody accelerations examples/swing_crane/four_bar.toml",
    ),
    table="accelerations",
    plot=PACKAGE + "pictures:scene_picture",
    arrays=False,
    tracked=False,
    also=("forward-dynamics",),
)  # fmt: skip

SIMULATE = Task(
    "simulate",
    "Motion of bodies in space over time, with its energy balance and how long it is known.",
    Model(
        "bodies in space, integrated",
        PACKAGE + "motions.simulate:simulate",
        source=BOOK + "sections 18.7 and 18.17",
        formula="ẏ of multibody accelerations; q̇ = y, of ball joints ė = ½·e·(0, ω); T + V − work stays",
        assumptions=RIGID,
        method="DOP853, two tolerances",
    ),
    headline=(
        "verdict: answer", "horizon: horizon", "difference: two tolerances apart by",
        "energy_error: energy and work balance to", "kinetic_energy: kinetic energy at the end",
        "work: work of motors, loads, dampers",
        "drives: driven joints | name=joint, largest=largest effort, time=at, end=at the end",
        "gap: largest gap of a loop",
        "states: last state known | name=speed, coordinate, speed=y",
        "motion: motion of the body followed | time, centre, velocity, angular_velocity=ω",
    ),
    scene=_shown() | {"duration": "2 s"},
    examples=(
        "dynamics multibody simulate examples/swing_crane/four_bar.toml --duration '0.5 s'",
        "dynamics multibody simulate examples/swing_crane/four_bar.toml --duration '1 s' --follow crank --steps 3",
    ),
    table="motion states",
    plot=PACKAGE + "pictures:motion_picture",
    errors=("horizon", "difference", "energy_error", "gap"),
    arrays=False,
    tracked=False,
)  # fmt: skip

EQUILIBRIUM = Task(
    "equilibrium",
    "Where bodies in space stand still under weight, loads, springs and motors; stability.",
    Model(
        "balance of forces on the free ways",
        PACKAGE + "motions.equilibrium:equilibrium",
        source=BOOK + "sections 14.2 and 18.15",
        formula="Cᵀ·F(q) = 0; stable where K = −∂(Cᵀ·F)/∂q > 0",
        assumptions=RIGID,
        method="Newton, downhill from the start",
    ),
    headline=(
        "stability: equilibrium", "energy: potential energy there",
        "joints: joints there | name=speed, coordinate, motor, spring",
        "bodies: mass centres there | body, centre",
        "frequencies: frequencies of small oscillations",
    ),
    scene=_shown() | {"bodies[1].torsion_stiffness": "80 N*m/rad"},
    examples=(
        "dynamics multibody equilibrium examples/swing_crane/four_bar.toml",
        "dynamics multibody equilibrium examples/swing_crane/four_bar.toml --up none",
    ),
    table="joints",
    arrays=False,
    tracked=False,
)  # fmt: skip

MODES = Task(
    "modes",
    "Small motions of bodies in space about rest: frequencies, damping, shapes.",
    Model(
        "small motions of the free ways",
        PACKAGE + "motions.equilibrium:modes",
        source=BOOK + "sections 13.7 and 18.17",
        formula="(s²·M + s·D + K)·φ = 0",
        assumptions=(*RIGID, "small motions about rest"),
        method="stiffness by five-point differences; eigenvalues",
    ),
    headline=(
        "slowest: lowest frequency", "fastest: highest frequency",
        "modes: modes | number=mode, kind, frequency, damping_ratio=damping, mostly",
        "shapes: shapes | mode, speed, share=part",
    ),
    scene=_shown() | {"bodies[1].torsion_stiffness": "80 N*m/rad"},
    examples=(
        "dynamics multibody modes examples/swing_crane/four_bar.toml",
        "dynamics multibody modes examples/swing_crane/four_bar.toml --gravity '1.62 m/s^2'",
    ),
    table="modes shapes",
    arrays=False,
    tracked=False,
)  # fmt: skip

FAMILIES = {
    "multibody": Family(
        "multibody",
        "Bodies in space on joints: trees, loops, motion, forces.",
        TOPOLOGY, KINEMATICS, MASS_MATRIX, EFFORTS, ACCELERATIONS, EQUILIBRIUM, MODES, SIMULATE,
    )
}  # fmt: skip
