"""Mass properties: the questions asked of them."""

from dynamics_cli.accuracy.questions import Comparison, Method, Question

HERE = "dynamics_cli.accuracy.alternatives.inertia."
BODIES, MESH, WALLS, EIGEN = (HERE + name for name in ("bodies:", "mesh:", "walls:", "eigen:"))

QUESTIONS = (
    Question(
        "inertia", "shape", "inertia shape", "inertia_bodies.json", "shape",
        Method("textbook: about the origin, parallel axes", HERE + "book:shape"),
    ),
    Comparison("inertia", "shape", "thin walls", WALLS + "compare"),
    Comparison("inertia", "body", "inertia body", BODIES + "compare_assemblies"),
    Comparison("inertia", "compare", "inertia compare", HERE + "vectors:compare_pairs"),
    Comparison("inertia", "tensor", "inertia tensor", HERE + "vectors:compare_tensors"),
    Comparison("inertia", "tensor", "principal moments", EIGEN + "compare"),
    Comparison("inertia", "tensor", "principal axes, by relative gap", EIGEN + "compare_axes"),
    Question(
        "inertia", "torque", "inertia torque", "inertia_bodies.json", "torque",
        Method("textbook: ω × (I·ω) as it stands", HERE + "vectors:torque_by_cross"),
        Method("Euler's equations in principal axes, LAPACK", HERE + "vectors:torque_along_axes"),
    ),
    Comparison("inertia", "mesh", "mesh moments", MESH + "compare"),
    Comparison("inertia", "mesh", "mesh moments, 32,768 triangles", MESH + "compare_large"),
    Comparison("inertia", "mesh", "mesh moments, faces that overlap", MESH + "compare_overlapping"),
    Comparison("inertia", "mesh", "shell moments", MESH + "compare_shells"),
    Comparison("inertia", "section", "inertia section", HERE + "sections:compare"),
)  # fmt: skip
