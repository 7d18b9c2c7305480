"""Tasks of `dynamics inertia`: bodies."""

from dynamics_cli.core.task import Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
HERE = "dynamics_cli.inertia."
WRITERS = {
    ending: HERE + "writers:" + name
    for ending, name in (("urdf", "urdf"), ("sdf", "sdf"), ("mjcf", "mjcf"), ("xml", "mjcf"), ("md", "markdown"))
}
RIGID = "the body is rigid and of one density"

SHAPE = Task(
    "shape",
    "Mass, centroid and inertia of one shape: a rod, a lamina, a shell or a solid.",
    Model(
        "closed form",
        HERE + "shape:shape",
        source=BOOK + "chapter 7, appendices I and II",
        formula="I = tr(S)·1 − S, S = ∫ (r − c)(r − c)ᵀ dm; about a point at d from c: + {mass|m}·(d²·1 − d dᵀ)",
        assumptions=(RIGID, "rods, laminae and shells have no thickness"),
    ),
    arrays=False,
    writers=WRITERS,
    plot=HERE + "pictures:shape_picture",
    names={"material": HERE + "materials:TABLE"},
    examples=(
        'dynamics inertia shape cylinder --radius "40 mm" --length "120 mm" --material steel',
        'dynamics inertia shape hollow-sphere --radius "0.5 m" --thickness "1 mm" --material aluminium --about origin',
        'dynamics inertia shape rod --length "3 ft" --mass "4 lb" --about-point "-1.5, 0, 0 ft" --units us',
        'dynamics inertia shape quarter-disk --radius "4 in" --areal-density "2 lb/ft^2" --axes principal',
        'dynamics inertia shape frustum --base-radius "20 mm" --top-radius "8..12 mm" --height "60 mm" --mass "300 g"',
        'dynamics inertia shape disk --radius "0.2 m" --mass "30 ± 0.5 kg" --shaft-direction "0, 0, 1"',
    ),
)

SHAPES = Task(
    "shapes",
    "The shapes there are, with their sizes, their own axes and their formulas.",
    Model("table", HERE + "listing:shapes", source=BOOK + "appendices I and II; derived by integration", method="none"),
    arrays=False,
    tracked=False,
    table="shapes",
    examples=("dynamics inertia shapes", "dynamics inertia shapes --kind rod", "dynamics inertia shapes --kind torus"),
)

MATERIALS = Task(
    "materials",
    "Densities of common materials, with their sources and how far grades differ.",
    Model("table", HERE + "materials:materials", source="as each row says", method="none"),
    arrays=False,
    tracked=False,
    table="materials",
    examples=("dynamics inertia materials", "dynamics inertia materials --name steel"),
    names={"name": HERE + "materials:TABLE"},
)

TENSOR = Task(
    "tensor",
    "Principal moments and axes of a given inertia tensor, whether a body can have it, and its extreme products.",
    Model(
        "Jacobi rotations",
        HERE + "tensor:tensor",
        source=BOOK + "sections 7.7 to 7.11",
        formula="det(I − λ·1) = 0; {greatest_product|Iₓᵧ} = (I₃ − I₁)/2",
        assumptions=(RIGID.replace(" and of one density", ""),),
        method="Jacobi rotations",
    ),
    arrays=False,
    plot=HERE + "tensor_pictures:mohr",
    examples=(
        'dynamics inertia tensor --moments "2, 2, 3 kg*m^2" --products "-0.5, 0, 0 kg*m^2"',
        'dynamics inertia tensor --tensor "[[10, -2, 1], [-2, 12, 3], [1, 3, 14]] kg*m^2" --mass "40 kg" '
        '--direction "1, 1, 0"',
    ),
)

TORQUE = Task(
    "torque",
    "Inertia torque of a rigid body for its angular velocity and acceleration, and its inertia force.",
    Model(
        "d'Alembert",
        HERE + "torque:torque",
        source=BOOK + "section 7.12",
        formula="T* = −I·{angular_acceleration|α} − {angular_velocity|ω} × (I·{angular_velocity|ω})",
        assumptions=("the body is rigid", "the tensor is about the mass centre, in the axes of ω and α"),
    ),
    arrays=False,
    plot=HERE + "tensor_pictures:torque",
    examples=(
        'dynamics inertia torque --tensor "[[0.02, 0, 0], [0, 0.03, 0], [0, 0, 0.04]] kg*m^2" '
        '--angular-velocity "0, 3000, 20 rpm" --angular-acceleration "0, 0, 5 rad/s^2"',
        'dynamics inertia torque --tensor "[[2, -0.1, 0], [-0.1, 3, 0], [0, 0, 4]] kg*m^2" '
        '--angular-velocity "10, 0, 0 rad/s" --mass "12 kg" --acceleration "0, 0, 3 m/s^2"',
    ),
)

BODY = Task(
    "body",
    "Mass, centroid and inertia of an assembly of parts and holes, from a scene file.",
    Model(
        "composition",
        HERE + "assembly:body",
        source=BOOK + "sections 7.6 to 7.9; uncertainties: SAWE paper 3360",
        formula="S = Σ Rᵢ·Sᵢ·Rᵢᵀ + mᵢ·(cᵢ − c)(cᵢ − c)ᵀ, I = tr(S)·1 − S",
        assumptions=("parts are rigid and of one density each", "a hole lies within its body"),
    ),
    arrays=False,
    table="parts",
    writers=WRITERS,
    plot=HERE + "pictures:body_picture",
    examples=(
        "dynamics inertia body examples/flywheel.toml --shaft-direction 0,0,1",
        "dynamics inertia body examples/payload.toml --about origin --product-sign positive",
    ),
)

COMPARE = Task(
    "compare",
    "Two bodies compared: mass, mass centre, moments, and how far their principal axes are turned.",
    Model(
        "composition",
        HERE + "compare:compare",
        source=BOOK + "sections 7.6 to 7.9",
        assumptions=("both bodies are in one frame",),
        method="composition of each; Jacobi rotations",
    ),
    arrays=False,
    table="moments",
    plot=HERE + "tensor_pictures:compared",
    examples=("dynamics inertia compare examples/compare_plates.toml",),
)

TASKS: "tuple[Task, ...]" = (SHAPE, SHAPES, BODY, COMPARE, MATERIALS, TENSOR, TORQUE)
