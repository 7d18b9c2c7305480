"""Plausibility of holes: inside their bodies, and with a density that a body has."""

from dynamics_cli.inertia.shapes.wires import wires
from dynamics_cli.numerics.number import over_plain, plain
from dynamics_cli.numerics.orientation.rotations import transposed
from dynamics_cli.numerics.vectors import add, subtract, times
from dynamics_cli.records import Advice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.assembly.parts import Leaf
    from dynamics_cli.inertia.bodies.mass_moments import Vector

# Densities that differ by more than this are not those of one material.
ALIKE = 1e-6
# Round shapes are represented by lines that fall short of them by up to this share of their size.
DRAWN = 2e-3
# With more parts than this holes are not checked: it would take longer than the answer.
MOST = 500


def hole_advice(leaves: "list[Leaf]") -> tuple[Advice, ...]:
    """Serious warnings about holes that remove material that no body has."""
    holes = [leaf for leaf in leaves if leaf.sign < 0.0]
    bodies = [leaf for leaf in leaves if leaf.sign > 0.0]
    if not holes or len(leaves) > MOST:
        return ()
    boxes = [_Box(body) for body in bodies] if all(body.part.shape is not None for body in bodies) else []
    advice = []
    for hole in holes:
        if boxes and hole.part.shape is not None and _leaves(hole, boxes):
            message = f"{hole.name} reaches outside every body: there is no mass to remove there"
            advice.append(Advice("hole-outside", message, "serious", "end the hole where its body ends"))
        rho = _density(hole)
        solids = [density for density in map(_density, bodies) if density is not None]
        alike = any(rho and rho[0] == d[0] and abs(rho[1] - d[1]) <= ALIKE * d[1] for d in solids)
        if rho and len(solids) == len(bodies) and not alike:
            text = f"{hole.name} removes material of a density that no body has"
            remedy = "give the hole the density of the body that it is cut out of"
            advice.append(Advice("hole-density", text, "serious", remedy))
    return tuple(advice)


def _density(leaf: "Leaf") -> "tuple[int, float] | None":
    """Dimension and mass per measure of a body; none of a measured one."""
    if not leaf.measures:
        return None
    dimension, measure = leaf.measures
    return dimension, plain(leaf.lump.mass) / plain(measure)


class _Box:
    """The bounding box of a body along its own axes."""

    def __init__(self, leaf: "Leaf") -> None:
        self.origin = over_plain(leaf.origin)
        self.back = transposed(over_plain(leaf.rotation))
        columns = list(zip(*(point for wire in wires(over_plain(leaf.part.shape)) for point in wire), strict=True))
        margin = DRAWN * max(max(column) - min(column) for column in columns)
        self.low = [min(column) - margin for column in columns]
        self.high = [max(column) + margin for column in columns]

    def holds(self, point: "Vector") -> bool:
        """Whether a point is within it."""
        local = times(self.back, subtract(point, self.origin))
        return all(low <= x <= high for low, x, high in zip(self.low, local, self.high, strict=True))


def _leaves(hole: "Leaf", boxes: "list[_Box]") -> bool:
    """Whether a point of a hole is outside the boxes of all bodies."""
    origin, rotation = over_plain(hole.origin), over_plain(hole.rotation)
    points = [point for wire in wires(over_plain(hole.part.shape)) for point in wire]
    return any(not any(box.holds(add(origin, times(rotation, point))) for box in boxes) for point in points)
