"""Inner sizes of walls, and sums that differences of powers factor into."""

from dynamics_cli.errors import require
from dynamics_cli.quantities import Size


def inner_radius(outer: float, thickness: float) -> float:
    """The inner radius of a wall."""
    inner = outer - thickness
    require(
        inner >= 0.0,
        "a wall of {thickness:6} does not fit in a radius of {outer:6}",
        code="thickness",
        hint="give a thickness of at most the outer radius",
        thickness=(thickness, Size),
        outer=(outer, Size),
    )
    return inner


def inner_side(outer: float, thickness: float) -> float:
    """The inner side between two walls."""
    inner = outer - 2.0 * thickness
    require(
        inner >= 0.0,
        "two walls of {thickness:6} do not fit in {outer:6}",
        code="thickness",
        hint="give a thickness of at most half the outer side",
        thickness=(thickness, Size),
        outer=(outer, Size),
    )
    return inner


def cubes(a: float, b: float) -> tuple[float, float]:
    """(a³ − b³)/(a − b) and (a⁵ − b⁵)/(a − b), sums without a negative term."""
    size = a * a + a * b + b * b
    require(size > 0.0, "the outer radius is zero", code="size")
    return size, a * a * size + b * b * b * (a + b)


def require_ring(ring: float, section: float) -> None:
    """Refuse a ring whose sections overlap in the middle."""
    require(
        section <= ring,
        "a section of radius {section:6} overlaps itself in a ring of radius {ring:6}",
        code="torus",
        hint="give a ring radius of at least the section's radius",
        section=(section, Size),
        ring=(ring, Size),
    )
