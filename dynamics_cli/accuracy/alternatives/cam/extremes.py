"""Extremes and points of a cam: Chebyshev proxies and the exact envelope, beside samples and differences."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.accuracy.cases import Case
    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.measure import Errors
    from dynamics_cli.accuracy.rows import Row
    from dynamics_cli.cam.geometry.contact import Geometry

    # Value and bound by address.
    Stated = dict[str, tuple[float | None, float | None]]
    Method = Callable[[Geometry, Any], Any]

FILES = ("cam_geometry.json", "cam_found.json")
# Pressure angles are compared with this at the least: a follower in line has angles about zero.
SMALL_ANGLE = 1e-3
PRESSURE = ("largest_pressure_angle", "least_pressure_angle")
CONVEX = "least_convex_radius"
POINTS = 16
STEP = 1.7453292519943296e-3
# A table of one turn by whole degrees.
SAMPLES = 360


def _given(case: "Case") -> "tuple[Geometry, Any]":
    from dynamics_cli.cam.geometry import followers
    from dynamics_cli.cam.geometry.contact import Geometry
    from dynamics_cli.cam.program.reading import Program, motion_of

    inputs = case.inputs
    sizes = {key: float(value) for key, value in inputs["follower"].items() if key != "record"}
    follower = getattr(followers, inputs["follower"]["record"])(**sizes)
    return Geometry(follower, inputs["rotation"], inputs["flank"]), motion_of(Program(), inputs["program"])


def by_proxies(geometry: "Geometry", motion: "Any") -> "Stated":
    """The program's own: Chebyshev proxies of every piece of every law, each with a bound."""
    from dynamics_cli.cam.geometry.analysis import analyse, convex, pressure_bounds, radius_bounds

    analysis = analyse(geometry, motion)
    bounds = {bound.result: bound.bound for bound in pressure_bounds(analysis)}
    radii = {bound.result: bound.bound for bound in radius_bounds(geometry, analysis)}
    angles = analysis.pressure.largest()[0], analysis.pressure.smallest()[0]
    results: Stated = {
        name: (angle, bounds[name] * abs(angle) if name in bounds else None)
        for name, angle in zip(PRESSURE, angles, strict=True)
    }
    return results | {CONVEX: (convex(geometry, analysis)[0], radii.get(CONVEX))}


def by_samples(geometry: "Geometry", motion: "Any") -> "Stated":
    """The pressure angle in a table of a turn, and what is greatest there where the cam is sharpest."""
    import numpy as np

    touch = geometry.touch(*motion.at(np.arange(SAMPLES) * (2.0 * np.pi / SAMPLES), 2))
    angle = touch.pressure_angle
    sharp = float(np.max(touch.curvature if touch.radius is None else -touch.radius))
    radius = -sharp if geometry.flat else None
    if not geometry.flat and sharp > 0.0:
        radius = 1.0 / sharp - geometry.side * geometry.roller
    return {
        PRESSURE[0]: (float(np.max(angle)), None),
        PRESSURE[1]: (float(np.min(angle)), None),
        CONVEX: (radius, None),
    }


def _compared(
    comparing: "Comparing", count: "Callable[[Errors, Case, Geometry, Any], None]", *methods: "tuple[str, Method]"
) -> "list[Row]":
    """Rows for methods on every cam; `count` says how an answer errs."""
    import numpy as np

    def answer(errors: "Errors", case: "Case", function: "Any", _: int) -> "Callable[[], Any]":
        geometry, motion = _given(case)
        count(errors, case, geometry, function(geometry, motion))
        return lambda: function(geometry, motion)

    with np.errstate(all="ignore"):
        return comparing.rows(methods, comparing.cases(*FILES, task="profile"), answer)


def compare(comparing: "Comparing") -> "list[Row]":
    """Extremes of the pressure angle and the least radius of the convex cam, on every cam of the references."""
    return _compared(
        comparing, _count_extremes, ("Chebyshev proxies (chosen)", by_proxies), ("360 samples", by_samples)
    )


def _count_extremes(errors: "Errors", case: "Case", geometry: "Geometry", results: "Stated") -> None:
    """Angles in shares of themselves, or of a thousandth of a radian; a radius in shares of it and the roller.

    An arm's angle is what sums of directions leave, its start's and its swing's: of the two extremes one may all but
    vanish, and both are measured by the larger.
    """
    follower = geometry.follower
    leaning = max(abs(float(case.results[address])) for address in PRESSURE)
    for address, (value, bound) in results.items():
        reference = float(case.results[address])
        if value is None or (address == CONVEX and reference < 0.0):
            continue
        size = max(leaning if geometry.oscillating else abs(reference), SMALL_ANGLE)
        if address == CONVEX:
            size = abs(reference) + getattr(follower, "roller_radius", follower.base_radius)
        errors.note(f"{case.name}: {address}", abs(value - reference) / size, bound and bound / size)


def angles() -> "Any":
    """Where points are compared."""
    import numpy as np

    return np.arange(POINTS) * (2.0 * np.pi / POINTS)


def envelope(geometry: "Geometry", motion: "Any") -> "tuple[Any, Any]":
    """The program's own: the point of contact in closed form."""
    from dynamics_cli.cam.geometry.contact import curve

    return curve(geometry, motion, angles())


def pitch_curve(geometry: "Geometry", motion: "Any", theta: "Any") -> "tuple[Any, Any]":
    """The roller's centres; a flat face has none."""
    if geometry.flat:
        raise ArithmeticError
    return geometry.turned(geometry.touch(*motion.at(theta, 2)).centre, theta)


def by_differences(geometry: "Geometry", motion: "Any") -> "tuple[Any, Any]":
    """The roller's centres, and normals from centres a tenth of a degree before and after."""
    import numpy as np

    theta = angles()
    x, y = pitch_curve(geometry, motion, theta)
    (ax, ay), (bx, by) = (pitch_curve(geometry, motion, (theta + d) % (2.0 * np.pi)) for d in (-STEP, STEP))
    tx, ty = bx - ax, by - ay
    # towards the cam's side of its direction of travel
    reach = geometry.side * geometry.turn * geometry.roller / np.hypot(tx, ty)
    return x + reach * ty, y - reach * tx


def compare_points(comparing: "Comparing") -> "list[Row]":
    """Sixteen points of every cam of the references; errors in shares of the size of cam and follower."""
    return _compared(
        comparing, _count_points, ("exact envelope (chosen)", envelope),
        ("normals by differences over 0.1°", by_differences),
    )  # fmt: skip


def _count_points(errors: "Errors", case: "Case", _: "Geometry", curve: "tuple[Any, Any]") -> None:
    """What coordinates are differences of is their measure."""
    import numpy as np

    given = case.inputs["follower"]
    sizes = [float(value) for key, value in given.items() if key not in ("record", "arm_angle", "offset")]
    size = max(sum(sizes), float(np.hypot(*curve).max()))
    for values, name in zip(curve, "xy", strict=True):
        for index, value in enumerate(values):
            text = case.results.get(f"points[{index}].{name}")
            if text is not None:
                errors.note(f"{case.name}: point {index}", abs(float(value) - float(text)) / size, None)
