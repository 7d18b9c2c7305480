"""Points of a cam: the exact envelope, beside differences of the pitch curve and the radius of knife-edge textbooks."""

from dynamics_cli.accuracy.alternatives.cam.extremes import compared

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.accuracy.cases import Case
    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.measure import Errors
    from dynamics_cli.accuracy.rows import Row
    from dynamics_cli.cam.geometry.contact import Geometry

COUNT = 16


def _angles() -> "Any":
    import numpy as np

    return np.arange(COUNT) * (2.0 * np.pi / COUNT)


def envelope(geometry: "Geometry", motion: "Any") -> "tuple[Any, Any]":
    """The program's own: the point of contact in closed form."""
    from dynamics_cli.cam.geometry.contact import curve

    return curve(geometry, motion, _angles())


def _pitch(geometry: "Geometry", motion: "Any", theta: "Any") -> "tuple[Any, Any]":
    if geometry.flat:
        raise ArithmeticError
    return geometry.turned(geometry.touch(*motion.at(theta, 2)).centre, theta)


def by_differences(step: float) -> "Callable[[Geometry, Any], tuple[Any, Any]]":
    """The roller's centres, and normals from centres a step before and after; a flat face has no centre."""

    def answer(geometry: "Geometry", motion: "Any") -> "tuple[Any, Any]":
        import numpy as np

        theta = _angles()
        x, y = _pitch(geometry, motion, theta)
        (ax, ay), (bx, by) = (_pitch(geometry, motion, (theta + way * step) % (2.0 * np.pi)) for way in (-1.0, 1.0))
        tx, ty = bx - ax, by - ay
        # towards the cam's side of its direction of travel
        reach = geometry.side * geometry.turn * geometry.roller / np.hypot(tx, ty)
        return x - reach * -ty, y - reach * tx

    return answer


METHODS: "tuple[tuple[str, Callable[[Geometry, Any], Any]], ...]" = (
    ("exact envelope (chosen)", envelope),
    ("normals by differences over 0.1°", by_differences(1.7453292519943296e-3)),
    ("normals by differences over 6e-6 rad", by_differences(6e-6)),
)


def compare(comparing: "Comparing") -> "list[Row]":
    """Sixteen points of every cam of the references; errors in shares of the size of cam and follower."""
    return compared(comparing, METHODS, counted)


def counted(errors: "Errors", case: "Case", _: "Geometry", found: "tuple[Any, Any]") -> None:
    """What coordinates are differences of is their measure."""
    import numpy as np

    given = case.inputs["follower"]
    sizes = [float(value) for key, value in given.items() if key not in ("record", "arm_angle", "offset")]
    size = max(sum(sizes), float(np.hypot(*found).max()))
    for which, name in enumerate("xy"):
        for index in range(COUNT):
            text = case.results.get(f"points[{index}].{name}")
            if text is not None:
                errors.note(f"{case.name}: point {index}", abs(float(found[which][index]) - float(text)) / size, None)
