"""Impacts: the questions asked of them."""

from dynamics_cli.accuracy.questions import Comparison, Method, Question

RIVALS = "dynamics_cli.accuracy.rivals.impact_"
BODIES, SYSTEMS, SPATIAL = (RIVALS + name for name in ("bodies:", "systems:", "spatial:"))
PARTICLES, RIGID, IN_SPACE = "impact_particles.json", "impact_rigid.json", "impact_spatial.json"


def _task(task: str, *methods: "tuple[str, str]", cases: str = "", file: str = PARTICLES) -> Question:
    """Rivals of a task, which join its own question: the catalogue makes it."""
    rivals = (Method(words, RIVALS + function) for words, function in methods)
    return Question("impact", task, f"impact {task}", file, cases or task.replace("-", "_"), *rivals)


QUESTIONS = (
    _task(
        "central",
        ("textbook: velocities, then differences", "lines:central"),
        ("2×2 system, numpy.linalg.solve", "lines:central_by_matrix"),
    ),
    _task(
        "oblique",
        ("textbook: components, then differences", "oblique:by_components"),
        ("4×4 system, numpy.linalg.solve", "oblique:by_matrix"),
    ),
    _task(
        "drop",
        ("textbook: powers and sums as printed", "lines:drop"),
        ("bounce by bounce until it rests", "lines:drop_by_bounces"),
    ),
    _task(
        "pendulum",
        ("textbook: 1 − cos θ, energies subtracted", "lines:pendulum"),
        ("swing by Dormand–Prince steps, 2×2 system", "lines:pendulum_by_swing"),
    ),
    _task(
        "seize",
        ("textbook: inverse about the point, energies subtracted", "held:seize_by_book"),
        ("bodies and constraints as one system, LAPACK", "held:seize_by_matrix"),
    ),
    _task(
        "step",
        ("textbook: energies subtracted", "held:step_by_book"),
        ("3×3 system, Brent's method", "held:step_by_equations"),
    ),
    _task(
        "chain",
        ("textbook: velocities pair by pair, active set by LAPACK", "chain:by_velocities"),
        ("2×2 systems, 400 sweeps of Gauss–Seidel", "chain:by_sweeps"),
    ),
    _task(
        "momentum",
        ("textbook: components, Cramer's rule", "momentum:by_components"),
        ("Newton on both components", "momentum:by_solver"),
    ),
    _task(
        "momentum",
        ("textbook: quadratic for one speed", "momentum:energy_by_quadratic"),
        ("Newton on momentum and energy", "momentum:energy_by_solver"),
        cases="momentum_and_energy",
    ),
    _task(
        "crush",
        ("textbook: sums over stations as printed", "damage:crush_as_printed"),
        ("50 strips from station to station", "damage:crush_by_strips"),
        ("mean depth squared", "damage:crush_by_mean"),
    ),
    _task(
        "yaw-inertia",
        ("textbook: radii of gyration", "damage:yaw_by_gyration"),
        ("the same in 32 bits", "damage:yaw_single"),
    ),
    Question(
        "impact", "momentum", "momentum, speeds before", PARTICLES, "approach",
        Method("cross products", BODIES + "cross_products", chosen=True, tracked=True, arrays=True),
        Method("2×2 system, numpy.linalg.solve", BODIES + "by_matrix"),
        Method("2×2 system, Cramer's rule", BODIES + "by_cramer"),
        Method("2×2 system, elimination by hand", BODIES + "by_elimination"),
    ),
    Question(
        "impact", "planar", "impact planar", RIGID, "planar",
        Method("textbook: slides or sticks, 8×8 system by LAPACK", SYSTEMS + "by_system"),
        Method("the same velocities, then differences", BODIES + "planar"),
        Method("Dormand–Prince along the impulse", SYSTEMS + "by_integration"),
        Method("pycrash, Kudlich–Slibar without spin before", BODIES + "planar_by_pycrash", needs="pycrash"),
    ),
    Question(
        "impact", "spatial", "impact spatial", IN_SPACE, "spatial",
        Method("textbook: slides or sticks, LAPACK", SPATIAL + "by_system"),
        Method("Dormand–Prince along the impulse, 1e-10", SPATIAL + "by_integration"),
    ),
    Comparison("impact", "planar", "planar path, by its impulse", RIVALS + "paths:compare", peers=("scipy",)),
    Comparison("impact", "spatial", "path in space, by its impulse", RIVALS + "space:compare", peers=("scipy",)),
)  # fmt: skip
