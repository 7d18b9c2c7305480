"""Mass properties: the questions asked of them, and the textbook's method for each."""

from dynamics_cli.accuracy.alternatives.inertia.mesh import ASKED
from dynamics_cli.accuracy.questions import Comparison, Method, Question, textbooks

HERE = "dynamics_cli.accuracy.alternatives.inertia."
SCALE = HERE + "bodies:scale"
MOMENTS = (
    Method("Jacobi, an exact quotient each", HERE + "eigen:jacobi", chosen=True),
    Method("trigonometric", HERE + "eigen:by_arc_cosine"),
)
SECTION = Method("whole numbers, rounded once", "dynamics_cli.inertia.section.task:section", chosen=True)
QUESTIONS = (
    *textbooks(
        "inertia", "inertia_bodies.json", HERE,
        ("torque", "textbook: ω × (I·ω) as it stands", "bodies:torque_by_cross"),
    ),
    *textbooks(
        "inertia", "inertia_bodies.json", HERE,
        ("body", "tensors about the origin, parallel axes at the end, LAPACK", "bodies:body_from_origin"),
        ("tensor", "textbook: roots by an arc cosine", "bodies:tensor_by_cardano"),
        scale=SCALE,
    ),
    Question("inertia", "section", "inertia section", "inertia_sections.json", "section", SECTION, scale=SCALE),
    Question("inertia", "tensor", "principal moments", "eigen.json", "eigen", *MOMENTS),
    Comparison("inertia", "tensor", "principal axes, by relative gap", HERE + "eigen:compare_axes"),
    *(Comparison("inertia", "mesh", name, HERE + "mesh:compare") for name in ASKED),
)  # fmt: skip
