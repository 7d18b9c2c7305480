"""Standard uncertainties of measured parts rolled up to the assembly, in first order and for independent parts."""

from dynamics_cli.inertia.bodies.records import Deviation
from dynamics_cli.numerics.number import over_plain, plain
from dynamics_cli.numerics.orientation.rotations import IDENTITY, product
from dynamics_cli.numerics.vectors import subtract

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.assembly.parts import Leaf
    from dynamics_cli.inertia.bodies.compose import Composed
    from dynamics_cli.inertia.bodies.mass_moments import Lump, Matrix

PAIRS = ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0))


def deviation(assembly: "Composed") -> Deviation | None:
    """Standard uncertainties of the assembly, or None if no part has one.

    About the mass centre: σ²(I) = Σ σ²(Iᵢ) + (∂I/∂mᵢ σ(mᵢ))² + Σₖ (∂I/∂cᵢₖ σ(cᵢₖ))²; terms through the common mass
    centre vanish there (SAWE paper 3360).
    """
    leaves = [
        (leaf, piece)
        for leaf, piece in zip(assembly.leaves, assembly.pieces, strict=True)
        if not (leaf.part.mass_std is None and leaf.part.centroid_std is None and leaf.part.tensor_std is None)
    ]
    if not leaves:
        return None
    total = plain(assembly.lump.mass)
    middle = tuple(plain(x) for x in assembly.lump.centroid)
    mass_variance = 0.0
    centroid = [0.0] * 3
    about_axes, about_principal = [0.0] * 6, [0.0] * 6
    for leaf, piece in leaves:
        sigma = plain(leaf.part.mass_std or 0.0)
        mass_variance += sigma * sigma
        away = tuple(plain(x) for x in subtract(piece.centroid, middle))  # type: ignore[arg-type]
        along = _centroid_variances(leaf)
        fraction = plain(piece.mass) / total
        for k in range(3):
            centroid[k] += (away[k] / total * sigma) ** 2 + fraction * fraction * along[k][k]
        _add(about_axes, leaf, piece, away, along, IDENTITY)
        _add(about_principal, leaf, piece, away, along, over_plain(assembly.spread.axes))
    roots = [x**0.5 for x in about_axes]
    return Deviation(
        mass=mass_variance**0.5,
        centroid=(centroid[0] ** 0.5, centroid[1] ** 0.5, centroid[2] ** 0.5),
        moments=tuple(roots[:3]),
        products=tuple(roots[3:]),
        principal_moments=tuple(x**0.5 for x in about_principal[:3]),
    )


def _centroid_variances(leaf: "Leaf") -> "list[list[float]]":
    """Covariance of a part's mass centre in the assembly's axes."""
    if leaf.part.centroid_std is None:
        return [[0.0] * 3 for _ in range(3)]
    r = over_plain(leaf.rotation)
    variances = [plain(x) ** 2 for x in leaf.part.centroid_std]
    return [[sum(r[i][k] * variances[k] * r[j][k] for k in range(3)) for j in range(3)] for i in range(3)]


def _add(
    sums: "list[float]",
    leaf: "Leaf",
    piece: "Lump",
    away: "tuple[float, ...]",
    centroid: "list[list[float]]",
    frame: "Matrix",
) -> None:
    """Add a part's variances of the six elements of the tensor in axes that are the rows of `frame`."""
    d = [sum(frame[i][k] * away[k] for k in range(3)) for i in range(3)]
    rotation = over_plain(product(frame, leaf.rotation))
    cov = [
        [sum(frame[i][p] * centroid[p][q] * frame[j][q] for p in range(3) for q in range(3)) for j in range(3)]
        for i in range(3)
    ]
    mass, sigma = plain(piece.mass), plain(leaf.part.mass_std or 0.0)
    scale = _per_mass(leaf, rotation)
    square = sum(x * x for x in d)
    for n, (i, j) in enumerate(PAIRS):
        by_mass = scale[n] + (square if i == j else 0.0) - d[i] * d[j]
        slope = [
            mass * ((2.0 * d[k] if i == j else 0.0) - (d[j] if k == i else 0.0) - (d[i] if k == j else 0.0))
            for k in range(3)
        ]
        sums[n] += (by_mass * sigma) ** 2
        sums[n] += sum(slope[p] * cov[p][q] * slope[q] for p in range(3) for q in range(3))
        sums[n] += _tensor_variance(leaf, rotation, i, j)


def _per_mass(leaf: "Leaf", rotation: "Matrix") -> "list[float]":
    """Derivative of a part's tensor by its mass: proportional for a shape, zero for a measured tensor."""
    if leaf.part.tensor is not None:
        return [0.0] * 6
    from dynamics_cli.inertia.bodies.mass_moments import tensor_of, turned

    mass = plain(leaf.lump.mass)
    tensor = tensor_of(turned(over_plain(leaf.lump.second), rotation))
    return [tensor[i][j] / mass for i, j in PAIRS]


def _tensor_variance(leaf: "Leaf", r: "Matrix", i: int, j: int) -> float:
    """Variance of an element of R I Rᵀ from the variances of the six elements of I."""
    if leaf.part.tensor_std is None:
        return 0.0
    total = 0.0
    for p, q in PAIRS:
        slope = r[i][p] * r[j][q] + (r[i][q] * r[j][p] if p != q else 0.0)
        total += (slope * plain(leaf.part.tensor_std[p][q])) ** 2
    return total
