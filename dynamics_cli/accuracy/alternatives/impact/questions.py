"""Impacts: the questions asked of them."""

from dynamics_cli.accuracy.questions import Comparison, Method, Question

HERE = "dynamics_cli.accuracy.alternatives.impact."
BODIES, SYSTEMS, SPATIAL = (HERE + name for name in ("bodies:", "systems:", "spatial:"))
PARTICLES, RIGID, IN_SPACE = "impact_particles.json", "impact_rigid.json", "impact_spatial.json"


def _task(task: str, *methods: "tuple[str, str]", cases: str = "", file: str = PARTICLES) -> Question:
    """Alternatives to a task's own method: the catalogue joins them."""
    alternatives = (Method(words, HERE + function) for words, function in methods)
    return Question("impact", task, f"impact {task}", file, cases or task.replace("-", "_"), *alternatives)


QUESTIONS = (
    _task("central", ("textbook: velocities, then differences", "lines:central")),
    _task("oblique", ("textbook: components, then differences", "oblique:by_components")),
    _task("drop", ("textbook: powers and sums as printed", "lines:drop")),
    _task("pendulum", ("textbook: 1 − cos θ, energies subtracted", "lines:pendulum")),
    _task("seize", ("textbook: inverse about the point, energies subtracted", "held:seize_by_book")),
    _task("step", ("textbook: energies subtracted", "held:step_by_book")),
    _task("chain", ("textbook: velocities pair by pair, active set by LAPACK", "chain:by_velocities")),
    _task("momentum", ("textbook: components, Cramer's rule", "momentum:by_components")),
    _task(
        "momentum",
        ("textbook: quadratic for one speed", "momentum:energy_by_quadratic"),
        cases="momentum_and_energy",
    ),
    _task("crush", ("textbook: sums over stations as printed", "damage:crush_as_printed")),
    _task("yaw-inertia", ("textbook: radii of gyration", "damage:yaw_by_gyration")),
    Question(
        "impact", "momentum", "momentum, speeds before", PARTICLES, "approach",
        Method("cross products", BODIES + "cross_products", chosen=True, tracked=True, arrays=True),
        Method("2×2 system, Cramer's rule", BODIES + "by_cramer"),
    ),
    Question(
        "impact", "planar", "impact planar", RIGID, "planar",
        Method("textbook: slides or sticks, 8×8 system by LAPACK", SYSTEMS + "by_system"),
        Method("Dormand–Prince along the impulse", SYSTEMS + "by_integration"),
    ),
    Question(
        "impact", "spatial", "impact spatial", IN_SPACE, "spatial",
        Method("textbook: slides or sticks, LAPACK", SPATIAL + "by_system"),
        Method("Dormand–Prince along the impulse, 1e-10", SPATIAL + "by_integration"),
    ),
    Comparison("impact", "planar", "planar path, by its impulse", HERE + "paths:compare"),
    Comparison("impact", "spatial", "path in space, by its impulse", HERE + "space:compare"),
)  # fmt: skip
