"""Impacts: the questions asked of them."""

from dynamics_cli.accuracy.questions import Comparison, Method, Question

RIVALS = "dynamics_cli.accuracy.rivals."
BODIES = RIVALS + "impact_bodies:"
PARTICLES, RIGID = "impact_particles.json", "impact_rigid.json"

# Rivals of a task join its own question, which the catalogue makes.
QUESTIONS = (
    Question(
        "impact", "central", "impact central", PARTICLES, "central",
        Method("velocities, then differences", BODIES + "central"),
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
        Method("the same velocities, then differences", BODIES + "planar"),
        Method("pycrash, Kudlich–Slibar without spin before", BODIES + "planar_by_pycrash", needs="pycrash"),
    ),
    Comparison("impact", "planar", "planar path, by its impulse", RIVALS + "impact_paths:compare", peers=("scipy",)),
    Comparison("impact", "spatial", "path in space, by its impulse", RIVALS + "impact_space:compare", peers=("scipy",)),
)  # fmt: skip
