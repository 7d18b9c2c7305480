"""The tasks of `dynamics vec`."""

from dynamics_cli.core.answering.task import Family, Model, Task

PLANAR = "a planar vector lies in the x–y plane of the others; angles are counter-clockwise from x"
TYPED = "products are exact for the numbers as typed, to 15 digits"
PICTURES = "dynamics_cli.vec.pictures"

RESULTANT = Task(
    "resultant",
    "Sum of forces, velocities or other vectors of one kind.",
    Model(
        "vector sum",
        "dynamics_cli.vec.sums:resultant",
        formula="{resultant|R} = Σ aᵢ; |R| = √((A − B)² + 4·A·B·cos²({between|φ}/2)) of two magnitudes at an angle",
        assumptions=(PLANAR, TYPED),
    ),
    headline=(
        "resultant: resultant R", "magnitude: magnitude |R|", "angle: angle from x", "angle_x: angle with x",
        "angle_y: angle with y", "angle_z: angle with z", "equilibrant: equilibrant −R",
    ),
    examples=(
        'dynamics vec resultant "20 N @ 30 deg" "15 N @ 110 deg" "8, -3 N"',
        'dynamics vec resultant "15 N" "12 N" --between "60 deg"',
    ),
    plot=f"{PICTURES}:resultant",
    table="parts",
    arrays=False,
)  # fmt: skip

DIRECTION = Task(
    "direction",
    "Magnitude, unit vector and direction angles; lines of sight.",
    Model(
        "direction cosines",
        "dynamics_cli.vec.sums:direction",
        formula="{magnitude|v} = √(v_x² + v_y² + v_z²), {angle_x|θx} = atan2(√(v_y² + v_z²), v_x)",
        assumptions=(PLANAR,),
    ),
    headline=(
        "magnitude", "angle: angle from x", "angle_x: angle with x", "angle_y: angle with y", "angle_z: angle with z",
        "direction: direction cosines",
    ),
    examples=(
        'dynamics vec direction "8, 12, 7 m"',
        'dynamics vec direction "0, 0, 1.2 m" "30, 4, 6.5 m"',
    ),
    plot=f"{PICTURES}:direction",
    arrays=False,
)  # fmt: skip

ANGLE = Task(
    "angle",
    "Angle between two vectors, to the last digit near 0 and 180 degrees.",
    Model(
        "two products",
        "dynamics_cli.vec.angles:angle",
        formula="{angle|θ} = atan2(|a×b|, {scalar_product|a·b})",
        assumptions=(PLANAR, TYPED),
    ),
    headline=("angle: angle θ", "supplement: supplement 180° − θ", "relation", "cosine", "sine"),
    examples=(
        'dynamics vec angle "1, 2, 3" "4, 0, -1"',
        'dynamics vec angle "20 N @ 30 deg" "5 m @ 100 deg" --axis "0, 0, 1"',
    ),
    plot=f"{PICTURES}:angle",
    arrays=False,
)

PRODUCT = Task(
    "product",
    "Scalar, vector and triple products; areas, volumes, moments, work.",
    Model(
        "exact products",
        "dynamics_cli.vec.products:product",
        formula="a·b = Σ aᵢ·bᵢ, (a×b)_x = a_y·b_z − a_z·b_y, a·(b×c) = determinant, a×(b×c) = b(a·c) − c(a·b)",
        assumptions=(PLANAR, TYPED),
    ),
    headline=(
        "scalar_product: scalar product a·b", "vector_product: vector product a×b", "parallelogram", "triangle",
        "relation", "triple_product: triple product a·(b×c)", "tetrahedron", "coplanar: three vectors",
    ),
    examples=(
        'dynamics vec product "0.3, 0, 0.4 m" "0, 200, 50 N"',
        'dynamics vec product "0.1, 0.2, 0.3" "0.4, 0.5, 0.6" "0.7, 0.8, 0.9"',
    ),
    plot=f"{PICTURES}:product",
    arrays=False,
)  # fmt: skip

RESOLVE = Task(
    "resolve",
    "Components along a direction, in a plane, or along oblique axes.",
    Model(
        "projection",
        "dynamics_cli.vec.resolve:resolve",
        formula="{component|v_n} = v·n/|n|, {across|v_t} = |v×n|/|n|; in a basis (v·(b₂×b₃))/(b₁·(b₂×b₃)) in turn",
        assumptions=(PLANAR, TYPED),
    ),
    headline=(
        "components: along the directions | component, coefficient, part",
        "component: component along", "across: component across", "out_of_plane: component along the normal",
        "in_plane: component in the plane", "angle", "part_along", "part_across", "part_out_of_plane",
        "part_in_plane", "condition: condition of the basis",
    ),
    examples=(
        'dynamics vec resolve "100 N @ 70 deg" --along "1 @ 20 deg"',
        'dynamics vec resolve "0, 0, -500 N" --first "3, 0, 4" --second "-3, 2, 4" --third "0, -2, 4"',
    ),
    plot=f"{PICTURES}:resolve",
    table="components",
    arrays=False,
)  # fmt: skip

POLYGON = Task(
    "polygon",
    "Planar vector polygon with two unknowns: every solution.",
    Model(
        "vector triangle",
        "dynamics_cli.vec.polygon:polygon",
        formula="p + q = T; p = T·(u ± i·v)/|T|, u = (T² + (A − B)·(A + B))/(2·|T|)",
        assumptions=("all vectors lie in one plane; angles are counter-clockwise from x", TYPED),
    ),
    headline=(
        "solutions: solutions | first_magnitude=first, first_angle=at, second_magnitude=second, second_angle=at",
        "missing: sum of the two unknowns",
    ),
    examples=(
        'dynamics vec polygon --sum "6, 2 kN" --magnitudes "5, 4 kN"',
        'dynamics vec polygon "0, -500 N" --directions "30, 135 deg"',
    ),
    plot=f"{PICTURES}:polygon",
    table="solutions",
    arrays=False,
)

FRAME = Task(
    "frame",
    "Right-handed triad from two or three directions, or three points.",
    Model(
        "one kept, the others perpendicular to it",
        "dynamics_cli.vec.frame:frame",
        formula="e₁ = a/|a|, e₃ = (a×b)/|a×b|, e₂ = e₃×e₁",
        assumptions=("the first given direction is kept, the second stays in its plane with the first", TYPED),
    ),
    headline=(
        "x_axis: x-axis", "y_axis: y-axis", "z_axis: z-axis", "kept", "departure: departure from right angles",
        "handedness", "components: components of the vector",
    ),
    examples=(
        'dynamics vec frame --x "3, 4, 0" --y "-4, 3, 1" --vector "0, 0, -9.81 m/s^2"',
        'dynamics vec frame "0, 0, 0 m" "2, 1, 0 m" "0, 3, 1 m"',
    ),
    plot=f"{PICTURES}:frame",
    arrays=False,
)  # fmt: skip

LINES = Task(
    "lines",
    "Distances, angles and intersections of points, lines and planes.",
    Model(
        "common perpendicular",
        "dynamics_cli.vec.lines:lines",
        formula="{distance|d} = |(q − p)·(u×v)|/|u×v|, parallel |(q − p)×u|/|u|, from a plane |n·(q − p)|/|n|",
        assumptions=("lines and planes are infinite", TYPED),
    ),
    headline=(
        "relation", "distance", "angle", "first_foot: foot on the first", "second_foot: foot on the second",
        "intersection", "common_direction",
    ),
    examples=(
        'dynamics vec lines --first-point "1, 2, 3 m" --first-direction "1, 1, 1" '
        '--second-point "4, 0.5, -1 m" --second-direction "1, 1, 2"',
        'dynamics vec lines --first-point "0, 0, 2 m" --second-point "1, 0, 0 m" --second-normal "1, 2, 2"',
    ),
    plot=f"{PICTURES}:lines",
    arrays=False,
    cost=1e-4,
)  # fmt: skip

MATRIX = Task(
    "matrix",
    "Determinant, inverse, products and equations up to 6 by 6, exactly.",
    Model(
        "elimination in whole numbers",
        "dynamics_cli.vec.matrix:matrix",
        formula="A⁻¹·A = 1, A·x = b",
        assumptions=("the numbers typed are exact",),
        method="exact rational arithmetic",
    ),
    headline=(
        "determinant_exact: determinant, exactly", "determinant", "rank", "inverse",
        "condition", "sum", "product", "solution", "solution_exact: solution, exactly",
    ),
    examples=(
        'dynamics vec matrix "2, 1; 1, 3" --right-hand "3, 5"',
        'dynamics vec matrix "1, 2, 3; 4, 5, 6; 7, 8, 9.0000000001"',
    ),
    arrays=False,
    tracked=False,
)  # fmt: skip

FAMILIES = {
    "vec": Family(
        "vec",
        "Vectors: sums, angles, products, components, frames, lines.",
        RESULTANT, DIRECTION, ANGLE, PRODUCT, RESOLVE, POLYGON, FRAME, LINES, MATRIX,
    )
}  # fmt: skip
