"""Tasks of `dynamics inertia`: bodies."""

from dynamics_cli.core.answering.task import Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, "
WRITERS = {
    ending: "dynamics_cli.inertia.assembly.writers:" + name
    for ending, name in (("urdf", "urdf"), ("sdf", "sdf"), ("mjcf", "mjcf"), ("xml", "mjcf"))
}
NAMED = {"density": "a material by its name: --material steel (dynamics inertia materials lists them)"}
RIGID = "the body is rigid and of one density"
MEASURES = ("mass: mass m", "volume: volume V", "area: area A", "length: length L", "centroid: mass centre C")
MOMENTS = (
    "about: moments about",
    "moments.xx: moment of inertia I_xx",
    "moments.yy: moment of inertia I_yy",
    "moments.zz: moment of inertia I_zz",
)
SHAFT = ("shaft.moment: moment about the shaft J",)
PRINCIPAL = (
    "principal_moments.first: principal moment I₁",
    "principal_moments.second: principal moment I₂",
    "principal_moments.third: principal moment I₃",
)

SHAPE = Task(
    "shape",
    "Mass, centroid and inertia of one shape: a rod, a lamina, a shell or a solid.",
    Model(
        "closed form",
        "dynamics_cli.inertia.shapes.task:shape",
        source=BOOK + "chapter 7, appendices I and II",
        formula="I = tr(S)·1 − S, S = ∫ (r − c)(r − c)ᵀ dm; about a point at d from c: + {mass|m}·(d²·1 − d dᵀ)",
        formula_of="dynamics_cli.inertia.shapes.listing:formula",
        assumptions=(RIGID, "rods, laminae and shells have no thickness"),
    ),
    headline=(*MEASURES, *MOMENTS, *SHAFT),
    arrays=False,
    writers=WRITERS,
    plot="dynamics_cli.inertia.pictures:shape_picture",
    names={"material": "dynamics_cli.inertia.bodies.materials:TABLE"},
    pointers=NAMED,
    examples=(
        'dynamics inertia shape cylinder --diameter "80 mm" --length "120 mm" --material steel',
        'dynamics inertia shape regular-prism --sides 6 --across-flats "17 mm" --height "0.5 m" --material steel',
        'dynamics inertia shape hollow-sphere --radius "0.5 m" --thickness "1 mm" --material aluminium --about origin',
        'dynamics inertia shape rod --length "3 ft" --mass "4 lb" --about-point "-1.5, 0, 0 ft" --units us',
        'dynamics inertia shape quarter-disk --radius "4 in" --areal-density "2 lb/ft^2" --axes principal',
        'dynamics inertia shape frustum --base-radius "20 mm" --top-radius "8..12 mm" --height "60 mm" --mass "300 g"',
        'dynamics inertia shape disk --radius "0.2 m" --mass "30 ± 0.5 kg" --shaft-direction "0, 0, 1"',
    ),
)

SHAPES = Task(
    "shapes",
    "All shapes with their sizes, their axes and their formulas.",
    Model(
        "table",
        "dynamics_cli.inertia.shapes.listing:shapes",
        source=BOOK + "appendices I and II; derived by integration",
        method="none",
    ),
    headline=("shapes",),
    arrays=False,
    tracked=False,
    table="shapes",
    listing=True,
    examples=("dynamics inertia shapes", "dynamics inertia shapes --kind rod", "dynamics inertia shapes --kind torus"),
)

MATERIALS = Task(
    "materials",
    "Densities of common materials, their ranges and their sources.",
    Model("table", "dynamics_cli.inertia.bodies.materials:materials", source="as each row says", method="none"),
    headline=("materials",),
    arrays=False,
    tracked=False,
    table="materials",
    listing=True,
    examples=("dynamics inertia materials", "dynamics inertia materials --name steel"),
    names={"name": "dynamics_cli.inertia.bodies.materials:TABLE"},
)

TENSOR = Task(
    "tensor",
    "Principal moments and axes of an inertia tensor, its maximum products, and whether a body can have it.",
    Model(
        "Jacobi rotations",
        "dynamics_cli.inertia.tensors.tensor:tensor",
        source=BOOK + "sections 7.7 to 7.11",
        formula="det(I − λ·1) = 0; {greatest_product|Iₓᵧ} = (I₃ − I₁)/2",
        assumptions=(RIGID.replace(" and of one density", ""),),
        method="Jacobi rotations",
    ),
    headline=(
        *PRINCIPAL,
        "principal_axes[0]: principal axis e₁",
        "principal_axes[1]: principal axis e₂",
        "principal_axes[2]: principal axis e₃",
        "greatest_product: maximum product (I₃ − I₁)/2",
        "direction_moment: moment about the direction",
        "equivalent_box: sides of the equivalent box",
    ),
    arrays=False,
    plot="dynamics_cli.inertia.tensors.pictures:mohr",
    examples=(
        'dynamics inertia tensor --moments "2, 2, 3 kg*m^2" --products "-0.5, 0, 0 kg*m^2"',
        'dynamics inertia tensor --tensor "[[10, -2, 1], [-2, 12, 3], [1, 3, 14]] kg*m^2" --mass "40 kg" '
        '--direction "1, 1, 0"',
    ),
)

TORQUE = Task(
    "torque",
    "Inertia torque and inertia force of a rigid body for its angular velocity and acceleration.",
    Model(
        "d'Alembert",
        "dynamics_cli.inertia.tensors.torque:torque",
        source=BOOK + "section 7.12",
        formula="T* = −I·{angular_acceleration|α} − {angular_velocity|ω} × (I·{angular_velocity|ω})",
        assumptions=("the body is rigid", "the tensor is about the mass centre, in the axes of ω and α"),
    ),
    headline=(
        "inertia_torque: inertia torque T*",
        "magnitude: magnitude |T*|",
        "acceleration_part: acceleration part −I·α",
        "gyroscopic_part: gyroscopic part −ω × I·ω",
        "angular_momentum: angular momentum I·ω",
        "rotational_energy: rotational energy ω·I·ω/2",
        "inertia_force: inertia force F*",
    ),
    arrays=False,
    plot="dynamics_cli.inertia.tensors.pictures:torque",
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
        "dynamics_cli.inertia.assembly.assembly:body",
        source=BOOK + "sections 7.6 to 7.9; uncertainties: SAWE paper 3360",
        formula="S = Σ Rᵢ·Sᵢ·Rᵢᵀ + mᵢ·(cᵢ − c)(cᵢ − c)ᵀ, I = tr(S)·1 − S",
        assumptions=("parts are rigid and of one density each", "a hole lies within its body"),
    ),
    headline=(*MEASURES, *MOMENTS, *SHAFT, *PRINCIPAL),
    pointers=NAMED,
    arrays=False,
    table="parts",
    writers=WRITERS,
    plot="dynamics_cli.inertia.pictures:body_picture",
    examples=(
        "dynamics inertia body examples/flywheel.toml --shaft-direction 0,0,1",
        "dynamics inertia body examples/payload.toml --about origin --product-sign positive",
    ),
)

COMPARE = Task(
    "compare",
    "Two bodies compared: mass, mass centre, moments, and the angle between their principal axes.",
    Model(
        "composition",
        "dynamics_cli.inertia.assembly.compare:compare",
        source=BOOK + "sections 7.6 to 7.9",
        assumptions=("both bodies are in one frame",),
        method="composition of each; Jacobi rotations",
    ),
    headline=(
        "first_mass: first mass m₁",
        "second_mass: second mass m₂",
        "mass_ratio: mass ratio m₂/m₁",
        "centroid_distance: distance of the mass centres",
        "axes_angle: angle between the principal axes",
        "tensor_distance: relative difference of the tensors",
        "moments: moments and products about each mass centre",
    ),
    pointers=NAMED,
    arrays=False,
    table="moments",
    plot="dynamics_cli.inertia.tensors.pictures:compared",
    examples=("dynamics inertia compare examples/compare_plates.toml",),
)

TASKS: "tuple[Task, ...]" = (SHAPE, SHAPES, BODY, COMPARE, MATERIALS, TENSOR, TORQUE)
