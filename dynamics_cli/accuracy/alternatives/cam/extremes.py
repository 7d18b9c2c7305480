"""Extremes of a cam: Chebyshev proxies of every piece, beside dense sampling, refined or not."""

from dynamics_cli.accuracy.cases import Case
from dynamics_cli.accuracy.measure import Errors

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any

    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.rows import Row
    from dynamics_cli.cam.geometry.contact import Geometry

    Found = dict[str, tuple[float | None, float | None]]

FILES = ("cam_geometry.json", "cam_found.json")
GOLDEN = 0.6180339887498949
# Pressure angles are compared with this at the least: a follower in line has angles about zero.
SMALL_ANGLE = 1e-3
PRESSURE = ("largest_pressure_angle", "least_pressure_angle")
CONVEX = "least_convex_radius"


def _given(case: Case) -> "tuple[Geometry, Any]":
    from dynamics_cli.cam.geometry import followers
    from dynamics_cli.cam.geometry.contact import Geometry
    from dynamics_cli.cam.program.reading import Program, motion_of

    inputs = case.inputs
    sizes = {key: float(value) for key, value in inputs["follower"].items() if key != "record"}
    follower = getattr(followers, inputs["follower"]["record"])(**sizes)
    return Geometry(follower, inputs["rotation"], inputs["flank"]), motion_of(Program(), inputs["program"])


def by_proxies(geometry: "Geometry", motion: "Any") -> "Found":
    """The program's own: Chebyshev proxies of every piece of every law, each with a bound."""
    from dynamics_cli.cam.geometry.analysis import analyse, pressure_bounds
    from dynamics_cli.cam.geometry.profile import convex, radius_bounds

    analysis = analyse(geometry, motion)
    bounds = {bound.result: bound.bound for bound in pressure_bounds(analysis)}
    radii = {bound.result: bound.bound for bound in radius_bounds(geometry, analysis)}
    large, least = analysis.pressure.largest()[0], analysis.pressure.smallest()[0]
    return {
        PRESSURE[0]: (large, _of(bounds, PRESSURE[0], large)),
        PRESSURE[1]: (least, _of(bounds, PRESSURE[1], least)),
        CONVEX: (convex(geometry, analysis)[0], radii.get(CONVEX)),
    }


def _of(bounds: "dict[str, float]", name: str, value: float) -> "float | None":
    return bounds[name] * abs(value) if name in bounds else None


def _functions(geometry: "Geometry", motion: "Any") -> "Callable[[Any], tuple[Any, Any]]":
    """Pressure angle, and what is greatest where the cam is sharpest, of cam angles."""
    import numpy as np

    def values(theta: "Any") -> "tuple[Any, Any]":
        touch = geometry.touch(*motion.at(theta, 2))
        sharp = touch.curvature if touch.radius is None else -touch.radius
        return np.broadcast_to(touch.pressure_angle, theta.shape), np.broadcast_to(sharp, theta.shape)

    return values


def _radius(geometry: "Geometry", sharp: float) -> "float | None":
    if geometry.flat:
        return -sharp
    return 1.0 / sharp - geometry.side * geometry.roller if sharp > 0.0 else None


def sampled(count: int) -> "Callable[[Geometry, Any], Found]":
    """So many equal steps of cam angle, the largest taken."""

    def answer(geometry: "Geometry", motion: "Any") -> "Found":
        import numpy as np

        angle, sharp = _functions(geometry, motion)(np.arange(count) * (2.0 * np.pi / count))
        return {
            PRESSURE[0]: (float(angle.max()), None),
            PRESSURE[1]: (float(angle.min()), None),
            CONVEX: (_radius(geometry, float(sharp.max())), None),
        }

    return answer


def refined(geometry: "Geometry", motion: "Any") -> "Found":
    """360 samples, then golden sections between the neighbours of the largest."""
    import numpy as np

    count = 360
    values, step = _functions(geometry, motion), 2.0 * np.pi / count
    theta = np.arange(count) * step
    angle, sharp = values(theta)
    rows = np.stack((angle, -angle, sharp))
    place = theta[rows.argmax(axis=1)]
    low, high = place - step, place + step
    for _ in range(45):
        a, b = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
        (a0, a2), (b0, b2) = values(a % (2.0 * np.pi)), values(b % (2.0 * np.pi))
        left = np.array([a0[0], -a0[1], a2[2]]) > np.array([b0[0], -b0[1], b2[2]])
        low, high = np.where(left, low, a), np.where(left, b, high)
    angle, sharp = values((0.5 * (low + high)) % (2.0 * np.pi))
    best = np.maximum(rows.max(axis=1), np.array([angle[0], -angle[1], sharp[2]]))
    return {
        PRESSURE[0]: (float(best[0]), None),
        PRESSURE[1]: (-float(best[1]), None),
        CONVEX: (_radius(geometry, float(best[2])), None),
    }


METHODS: "tuple[tuple[str, Callable[[Geometry, Any], Found]], ...]" = (
    ("Chebyshev proxies (chosen)", by_proxies),
    ("360 samples", sampled(360)),
    ("36,000 samples", sampled(36_000)),
    ("360 samples and golden sections", refined),
)


def compare(comparing: "Comparing") -> "list[Row]":
    """Extremes of the pressure angle and the least radius of the convex cam, on every cam of the references."""
    return compared(comparing, METHODS, extremes_counted)


def compared(
    comparing: "Comparing", methods: "Sequence[tuple[str, Callable[[Geometry, Any], Any]]]",
    count: "Callable[[Errors, Case, Geometry, Any], None]",
) -> "list[Row]":  # fmt: skip
    """Rows for methods on every cam; `count` says how an answer errs."""
    import numpy as np

    def answer(errors: "Errors", case: Case, function: "Any", _: int) -> "Callable[[], Any]":
        geometry, motion = _given(case)
        count(errors, case, geometry, function(geometry, motion))
        return lambda: function(geometry, motion)

    with np.errstate(all="ignore"):
        return comparing.rows(methods, comparing.cases(*FILES, task="profile"), answer)


def extremes_counted(errors: Errors, case: Case, geometry: "Geometry", analysis: "Found") -> None:
    """Angles in shares of themselves, or of a thousandth of a radian; a radius in shares of it and the roller.

    An arm's angle is what sums of directions leave, its start's and its swing's: of the two extremes one may all but
    vanish, and both are measured by the larger.
    """
    follower = geometry.follower
    leaning = max(abs(float(case.results[address])) for address in PRESSURE)
    for address, (value, bound) in analysis.items():
        reference = float(case.results[address])
        if value is None or (address == CONVEX and reference < 0.0):
            continue
        size = max(leaning if geometry.oscillating else abs(reference), SMALL_ANGLE)
        if address == CONVEX:
            size = abs(reference) + getattr(follower, "roller_radius", follower.base_radius)
        errors.note(f"{case.name}: {address}", abs(value - reference) / size, bound and bound / size)
