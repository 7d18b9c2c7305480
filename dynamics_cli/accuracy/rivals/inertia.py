"""Mass properties: the questions asked of them."""

from dynamics_cli.accuracy.questions import Comparison, Method, Question

RIVALS = "dynamics_cli.accuracy.rivals.inertia_"
BODIES, MESH, WALLS, EIGEN = (RIVALS + name for name in ("bodies:", "mesh:", "walls:", "eigen:"))
PEERS = ("trimesh", "mujoco")

QUESTIONS = (
    Question(
        "inertia", "shape", "inertia shape", "inertia_bodies.json", "shape",
        Method("closed form", BODIES + "shape", chosen=True, tracked=True),
        Method("textbook: about the origin, parallel axes", RIVALS + "book:shape"),
        Method("Gauss quadrature, 2 to 32 nodes each way", RIVALS + "quadrature:shape"),
    ),
    Comparison("inertia", "shape", "thin walls", WALLS + "compare"),
    Comparison("inertia", "body", "inertia body", BODIES + "compare_assemblies"),
    Comparison("inertia", "compare", "inertia compare", BODIES + "compare_pairs"),
    Comparison("inertia", "tensor", "inertia tensor", BODIES + "compare_tensors"),
    Comparison("inertia", "tensor", "principal moments", EIGEN + "compare"),
    Comparison("inertia", "tensor", "principal axes, by relative gap", EIGEN + "compare_axes"),
    Question(
        "inertia", "torque", "inertia torque", "inertia_bodies.json", "torque",
        Method("differences of moments", "dynamics_cli.inertia.torque:torque", chosen=True, tracked=True),
        Method("textbook: ω × (I·ω) as it stands", RIVALS + "vectors:torque_by_cross"),
        Method("Euler's equations in principal axes, LAPACK", RIVALS + "vectors:torque_along_axes"),
    ),
    Comparison("inertia", "mesh", "mesh moments", MESH + "compare", peers=PEERS),
    Comparison("inertia", "mesh", "mesh moments, 32,768 triangles", MESH + "compare_large", peers=PEERS),
    Comparison("inertia", "mesh", "mesh moments, faces that overlap", MESH + "compare_overlapping"),
    Comparison("inertia", "mesh", "shell moments", MESH + "compare_shells"),
    Comparison("inertia", "section", "inertia section", RIVALS + "sections:compare"),
)  # fmt: skip
