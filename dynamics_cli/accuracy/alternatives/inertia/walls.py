"""Thin-walled shapes: sums factored in the wall thickness, outer less inner solid, and the wall as a surface."""

from math import pi

from dynamics_cli.accuracy.alternatives.inertia.bodies import FILE, own, shape
from dynamics_cli.accuracy.alternatives.inertia.table import Way, rows_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from dynamics_cli.accuracy.cases import Case
    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.rows import Row

    # Measure, height of the centroid, and second moments about the centroid, for a mass of one.
    Solid = tuple[float, float, float, float, float]


def _disk(radius: float) -> "Solid":
    own = radius**2 / 4.0
    return pi * radius**2, 0.0, own, own, 0.0


def _ball(radius: float) -> "Solid":
    own = radius**2 / 5.0
    return 4.0 / 3.0 * pi * radius**3, 0.0, own, own, own


def _half_ball(radius: float) -> "Solid":
    own = radius**2 / 5.0
    return 2.0 / 3.0 * pi * radius**3, 3.0 / 8.0 * radius, own, own, 19.0 / 320.0 * radius**2


def _cylinder(radius: float, length: float) -> "Solid":
    own = radius**2 / 4.0
    return pi * radius**2 * length, 0.0, own, own, length**2 / 12.0


def _frustum(a: float, b: float, h: float) -> "Solid":
    square = a**2 + a * b + b**2
    middle = h * (a**2 + 2.0 * a * b + 3.0 * b**2) / (4.0 * square)
    across = 3.0 * (a**4 + a**3 * b + a**2 * b**2 + a * b**3 + b**4) / (20.0 * square)
    along = h**2 * (a**2 + 3.0 * a * b + 6.0 * b**2) / (10.0 * square)
    return pi * h * square / 3.0, middle, across, across, along - middle**2


def _block(a: float, b: float, c: float) -> "Solid":
    return a * b * c, 0.0, a**2 / 12.0, b**2 / 12.0, c**2 / 12.0


def _ring(ring: float, radius: float) -> "Solid":
    own = ring**2 / 2.0 + 3.0 * radius**2 / 8.0
    return 2.0 * pi**2 * ring * radius**2, 0.0, own, own, radius**2 / 4.0


# The solid that a wall is cut from: from the sizes and by how much these shrink inwards, of radii and of whole sides.
OUTLINES: "dict[str, Callable[[Mapping[str, float], float], Solid]]" = {
    "Annulus": lambda s, t: _disk(s["radius"] - t),
    "HollowSphere": lambda s, t: _ball(s["radius"] - t),
    "HollowHemisphere": lambda s, t: _half_ball(s["radius"] - t),
    "HollowCylinder": lambda s, t: _cylinder(s["radius"] - t, s["length"]),
    "ClosedCylinder": lambda s, t: _cylinder(s["radius"] - t, s["length"] - 2.0 * t),
    "HollowFrustum": lambda s, t: _frustum(s["base_radius"] - t, s["top_radius"] - t, s["height"]),
    "HollowBlock": lambda s, t: _block(s["width"] - 2.0 * t, s["depth"] - 2.0 * t, s["height"] - 2.0 * t),
    "RectangularTube": lambda s, t: _block(s["width"] - 2.0 * t, s["depth"] - 2.0 * t, s["length"]),
    "HollowTorus": lambda s, t: _ring(s["ring_radius"], s["radius"] - t),
}


def _given(case: "Case") -> "tuple[str, dict[str, float], float]":
    """Class, sizes and mass."""
    own = case.inputs["shape"]
    sizes = {name: float(text) for name, text in own.items() if name != "record"}
    return own["record"], sizes, float(case.inputs["amount"]["mass"])


def outer_less_inner(case: "Case") -> "Callable[[], dict[str, float]]":
    """The textbook: the solid less the solid that the wall leaves, as R⁵ − r⁵ over R³ − r³ for a ball."""
    record, sizes, mass = _given(case)
    solid = OUTLINES[record]

    def answer() -> "dict[str, float]":
        volume, middle, *own = solid(sizes, 0.0)
        hole, its, *inner = solid(sizes, sizes["thickness"])
        left = volume - hole
        height = (volume * middle - hole * its) / left
        lift = (volume * middle**2 - hole * its**2) / left - height**2
        second = [(volume * a - hole * b) / left for a, b in zip(own, inner, strict=True)]
        return _results(mass, left, height, (second[0], second[1], second[2] + lift), flat=record == "Annulus")

    return answer


def _results(
    mass: float, measure: float, height: float, second: "tuple[float, float, float]", *, flat: bool
) -> "dict[str, float]":
    x, y, z = (mass * part for part in second)
    moments = (y + z, z + x, x + y)
    results = {"area" if flat else "volume": measure, "mass": mass, "centroid[2]": height}
    results |= dict.fromkeys(("centroid[0]", "centroid[1]", "products.xy", "products.yz", "products.zx"), 0.0)
    results |= {f"moments.{name}": value for name, value in zip(("xx", "yy", "zz"), moments, strict=True)}
    names = ("first", "second", "third")
    return results | {f"principal_moments.{n}": value for n, value in zip(names, sorted(moments), strict=True)}


METHODS = (
    own("factored in the wall thickness", shape),
    Way("outer less inner solid", outer_less_inner),
)


def compare(comparing: "Comparing") -> "list[Row]":
    """Hollow shapes by their wall thickness."""
    cases = [case for case in comparing.cases(FILE, task="shape") if case.inputs["shape"]["record"] in OUTLINES]
    return rows_of(comparing, cases, METHODS)
