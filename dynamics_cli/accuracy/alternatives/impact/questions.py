"""Impacts: the questions asked of them, and the textbook's method for each."""

from dynamics_cli.accuracy.questions import Method, Question, textbooks

HERE = "dynamics_cli.accuracy.alternatives.impact."
PARTICLES = "impact_particles.json"
APPROACH = (
    Method("cross products", HERE + "reconstruction:cross_products", chosen=True, tracked=True),
    Method("2×2 system, Cramer's rule", HERE + "reconstruction:by_cramer"),
)
SYSTEM = "textbook: slides or sticks, LAPACK", "rigid:by_system"
QUESTIONS = (
    *textbooks(
        "impact", PARTICLES, HERE,
        ("central", "textbook: velocities, then differences", "lines:central"),
        ("oblique", "textbook: components, then differences", "rigid:oblique"),
        ("drop", "textbook: powers and sums as printed", "lines:drop"),
        ("pendulum", "textbook: 1 − cos θ, energies subtracted", "lines:pendulum"),
        ("step", "textbook: energies subtracted", "lines:step"),
    ),
    *textbooks("impact", "impact_rigid.json", HERE, ("planar", *SYSTEM)),
    *textbooks("impact", "impact_spatial.json", HERE, ("spatial", *SYSTEM)),
    Question("impact", "momentum", "momentum, speeds before", PARTICLES, "approach", *APPROACH),
)  # fmt: skip
