"""Tasks of `dynamics inertia`: surfaces."""

from dynamics_cli.core.answering.task import Model, Task
from dynamics_cli.inertia.commands.bodies import MEASURES, MOMENTS, NAMED, PRINCIPAL, SHAFT, WRITERS

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
            "the triangles neither cross nor overlap (checked up to about 20,000 triangles, of more with --diagnose)",
        ),
        method="divergence theorem over triangles, in blocks",
    ),
    headline=(*MEASURES, *MOMENTS, *SHAFT, *PRINCIPAL),
    arrays=False,
    writers=WRITERS,
    plot="dynamics_cli.inertia.mesh.pictures:mesh_picture",
    names={"material": "dynamics_cli.inertia.bodies.materials:TABLE"},
    pointers=NAMED,
    examples=(
        "dynamics inertia mesh examples/bracket.stl --length-unit mm --material aluminium",
        'dynamics inertia mesh examples/bracket.stl --length-unit mm --density "2700 kg/m^3" --about origin --diagnose',
        'dynamics inertia mesh examples/bracket.stl --length-unit mm --density "7850 kg/m^3" --thickness "1.5 mm"',
    ),
)

SECTION = Task(
    "section",
    "Area, centroid, second moments, principal axes and section moduli of a plane section with holes.",
    Model(
        "exact area integrals",
        "dynamics_cli.inertia.section.task:section_of",
        source=BOOK + "chapter 7 and appendix II; Mohr's circle: section 7.9",
        formula="{area|A} = ½·Σ (xᵢ·yⱼ − xⱼ·yᵢ), Ix = Σ (xᵢ·yⱼ − xⱼ·yᵢ)·(yᵢ² + yᵢ·yⱼ + yⱼ²)/12 − A·ȳ², "
        "{principal.i1|I₁} = (Ix + Iy)/2 + √(((Ix − Iy)/2)² + Ixy²)",
        assumptions=(
            "one material throughout",
            "pieces that do not touch act as one section",
            "bending moduli are elastic",
        ),
        method="exact rational arithmetic of the coordinates as read into doubles, rounded once",
    ),
    headline=(
        "area: area A",
        "linear_density: mass per length",
        "x: centroid x_C",
        "y: centroid y_C",
        "centroidal.ix: second moment I_x",
        "centroidal.iy: second moment I_y",
        "centroidal.ixy: product I_xy",
        "principal.i1: principal second moment I₁",
        "principal.i2: principal second moment I₂",
        "principal.angle: angle of axis 1 from x",
        "moduli.first_least: section modulus S₁",
        "moduli.second_least: section modulus S₂",
    ),
    arrays=False,
    tracked=False,
    plot="dynamics_cli.inertia.section.pictures:section_picture",
    names={"material": "dynamics_cli.inertia.bodies.materials:TABLE"},
    pointers=NAMED,
    examples=(
        'dynamics inertia section --profile i-beam --height "200 mm" --width "100 mm" --web "5.6 mm" '
        '--flange "8.5 mm" --fillet "12 mm"',
        'dynamics inertia section --polygon "0, 0, 60, 0, 60, 8, 8, 8, 8, 40, 0, 40 mm"',
        "dynamics inertia section examples/channel.toml",
        'dynamics inertia section --piece "diameter=60 mm" --hole "diameter=50 mm"',
        'dynamics inertia section --bar "profile=channel, height=200 mm, width=75 mm, web=8.5 mm, flange=11.5 mm" '
        '--bar "profile=flat, width=90 mm, height=10 mm, y=105 mm"',
        'dynamics inertia section --piece "width=50 mm, height=30 mm" '
        """--hole 'polygon="-10, -5, 10, -5, 0, 10 mm"' --digits 8""",
        'dynamics inertia section --polygon "0, 0, 4, 0, 4, 0.5, 0.5, 0.5, 0.5, 6, 0, 6 in" '
        '--hole "diameter=0.2 in, x=0.25 in, y=3 in" --units us',
    ),
)

TASKS: "tuple[Task, ...]" = (MESH, SECTION)
