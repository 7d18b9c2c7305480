"""What a wall leaves inside, and sums that differences of powers factor into."""

from dynamics_cli.errors import require


def inner_radius(outer: float, thickness: float) -> float:
    """What a wall leaves of a radius, not less than nothing."""
    inner = outer - thickness
    require(
        inner >= 0.0,
        "a wall of {0:.6g} m does not fit in a radius of {1:.6g} m",
        thickness,
        outer,
        code="thickness",
        hint="the thickness is at most the outer radius",
    )
    return inner


def inner_side(outer: float, thickness: float) -> float:
    """What two walls leave of a side, not less than nothing."""
    inner = outer - 2.0 * thickness
    require(
        inner >= 0.0,
        "two walls of {0:.6g} m do not fit in {1:.6g} m",
        thickness,
        outer,
        code="thickness",
        hint="the thickness is at most half the outer side",
    )
    return inner


def cubes(a: float, b: float) -> tuple[float, float]:
    """(a³ − b³)/(a − b) and (a⁵ − b⁵)/(a − b), sums without a negative term."""
    size = a * a + a * b + b * b
    require(size > 0.0, "a radius of zero leaves nothing", code="size")
    return size, a * a * size + b * b * b * (a + b)


def require_ring(ring: float, section: float) -> None:
    """Refuse a ring whose sections overlap in the middle."""
    require(
        section <= ring,
        "a section of radius {0:.6g} m overlaps itself in a ring of radius {1:.6g} m",
        section,
        ring,
        code="torus",
        hint="the ring's radius is at least the section's",
    )
