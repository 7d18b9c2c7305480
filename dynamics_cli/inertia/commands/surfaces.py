"""Tasks of `dynamics inertia`: surfaces."""

from dynamics_cli.core.task import Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "

MESH = Task(
    "mesh",
    "Mass, centroid, inertia tensor and principal axes of a part given by the triangles of its surface.",
    Model(
        "divergence theorem",
        "dynamics_cli.inertia.mesh.task:mesh",
        source=BOOK + "sections 7.2 to 7.9; Eberly, Polyhedral mass properties (2002)",
        formula="V = Σ a·(e × f)/6, S = ρ·Σ d·(p pᵀ + q qᵀ/18 + f fᵀ/24)/10 − m·c cᵀ",
        assumptions=(
            "one density throughout, or a thin wall of one thickness",
            "the triangles neither cross one another nor are given twice",
        ),
        method="divergence theorem over triangles, in blocks",
    ),
    arrays=False,
    examples=(
        "dynamics inertia mesh examples/bracket.stl --length-unit mm --material aluminium",
        'dynamics inertia mesh examples/bracket.stl --length-unit mm --density "2700 kg/m^3" --about origin --diagnose',
        'dynamics inertia mesh examples/bracket.stl --length-unit mm --density "7850 kg/m^3" --thickness "1.5 mm"',
    ),
)

TASKS: "tuple[Task, ...]" = (MESH,)
