"""What a driver does over time, and what a load is: formulas and tables as functions of SI numbers."""

import math

from dynamics_cli.errors import require
from dynamics_cli.numerics.expressions.jets import Jet
from dynamics_cli.numerics.expressions.laws import law_of, parsed
from dynamics_cli.numerics.fitting.records_file import read_columns

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.motion.bodies.records import Driver
    from dynamics_cli.records import Formula

    # value, rate and second derivative at a time
    Law = Callable[[float], tuple[float, float, float]]

DEGREE = math.pi / 180.0
TURNED = {
    "angle": {"deg": DEGREE, "rad": 1.0},
    "speed": {"rad/s": 1.0, "rpm": math.pi / 30.0, "deg/s": DEGREE},
}
PUSHED = {"position": {"mm": 1e-3, "m": 1.0, "in": 0.0254}}
FORCES = {"N": 1.0, "kN": 1e3, "lbf": 4.4482216152605}
LOADED = {
    "force_x": FORCES, "force_y": FORCES,
    "torque": {"N*m": 1.0, "N·m": 1.0, "lbf*ft": 1.3558179483314004},
}  # fmt: skip


class Motion:
    """A prescribed motion: its law, whether this gives the rate alone, and times at which it has a corner."""

    def __init__(self, law: "Law", *, of_rate: bool = False, knots: "tuple[float, ...]" = ()) -> None:
        self.law, self.of_rate, self.knots = law, of_rate, knots


def prescribed(driver: "Driver", start: float, scale: float) -> Motion:
    """The motion of a driver in units of `scale` (1 for angles); `start` is where the scene has it."""
    turned = not driver.point
    formula = driver.angle_law if turned else driver.position_law
    given = [one for one in (formula, driver.speed_law, driver.table or None) if one is not None]
    who = repr(driver.link or driver.point)
    require(len(given) <= 1, "the driver of {who} has several laws", who=who, code="driver", hint="give one of them")
    wrong = (driver.position_law,) if turned else (driver.angle_law, driver.speed_law)
    require(not any(wrong), "the driver of {who} has a law of the wrong kind", who=who, code="driver",
            hint="angle_law or speed_law for a link, position_law for a pin")  # fmt: skip
    if driver.table:
        return _of_table(driver.table, turned=turned, scale=scale)
    if formula is not None:
        return Motion(_of_formula(formula, scale))
    if driver.speed_law is not None:
        whole = _of_formula(driver.speed_law, 1.0)
        return Motion(lambda t: (0.0, *whole(t)[:2]), of_rate=True)
    at = (driver.angle if turned else driver.position) if turned or driver.position is None else driver.position
    p = (start if at is None else at) / scale
    v, a = (driver.speed, driver.angular_acceleration) if turned else (driver.velocity, driver.acceleration)
    v, a = v / scale, a / scale
    return Motion(lambda t: (p + t * (v + 0.5 * t * a), v + a * t, a))


def _of_formula(formula: "Formula", scale: float) -> "Law":
    law = law_of(formula, (), ("t",))

    def at(t: float) -> "tuple[float, float, float]":
        out = law(t=Jet.variable(t, 2))
        parts = out.parts if isinstance(out, Jet) else (out, 0.0, 0.0)
        return parts[0] / scale, parts[1] / scale, 2.0 * parts[2] / scale

    return at


def _of_table(file: str, *, turned: bool, scale: float) -> Motion:
    times, columns = read_columns(file, TURNED if turned else PUSHED)
    require(len(columns) == 1, "the table of a driver has one column beside the time", code="header")
    ((name, values),) = columns.items()
    if name == "speed":
        value = linear(times, values)

        def rate(t: float) -> "tuple[float, float, float]":
            return 0.0, *value(t)

        return Motion(rate, of_rate=True, knots=tuple(times))
    from scipy.interpolate import CubicSpline

    require(len(times) > 2, "a spline through a table needs three rows", code="length")
    spline = CubicSpline(times, [x / scale for x in values])
    slope, bend = spline.derivative(1), spline.derivative(2)
    return Motion(lambda t: (float(spline(t)), float(slope(t)), float(bend(t))), knots=tuple(times))


def linear(times: "list[float]", values: "list[float]") -> "Callable[[float], tuple[float, float]]":
    """Value and slope of straight lines between points, level beyond them."""
    from bisect import bisect_right

    def at(t: float) -> "tuple[float, float]":
        k = bisect_right(times, t)
        if k in (0, len(times)):
            return values[0 if k == 0 else -1], 0.0
        slope = (values[k] - values[k - 1]) / (times[k] - times[k - 1])
        return values[k - 1] + slope * (t - times[k - 1]), slope

    return at


class Loading:
    """A force or torque by a formula, as a function of named numbers in SI or of arrays of them."""

    def __init__(self, formula: "Formula", names: "tuple[str, ...]") -> None:
        self.formula, self._law = formula, law_of(formula, (), names)
        used = parsed(formula, names).names
        self._needed = [name for name in names if name in used]
        self._constant = None if self._needed else float(self._law())

    def __call__(self, given: "dict[str, Any]") -> "Any":
        """Its value."""
        if self._constant is not None:
            return self._constant
        return self._law(**{name: given[name] for name in self._needed})
