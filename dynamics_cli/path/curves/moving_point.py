"""A point on a curve over time: position, velocity, acceleration and jerk, by Taylor jets of a formula or a name."""

import math

from dynamics_cli.errors import DynamicsError, require
from dynamics_cli.numerics import elementary
from dynamics_cli.numerics.expressions.jets import Jet
from dynamics_cli.numerics.expressions.laws import law_of
from dynamics_cli.numerics.number import is_carrier, is_many, is_tracked, like, over_plain, plain
from dynamics_cli.numerics.tracked import UNIT_ROUNDOFF, Tracked
from dynamics_cli.numerics.vectors import Vector
from dynamics_cli.path.bends import Bend, bend
from dynamics_cli.quantities import Time
from dynamics_cli.records import Formula, Let

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

LET = "; or give it a value, --let 'k=2 m'"
# A result whose bound is looser than this is evaluated once more, in 60 digits.
LOOSE = 1e-12


class State:
    """Where a point is and how it moves at one time."""

    __slots__ = ("acceleration", "bend", "jerk", "position", "velocity")

    def __init__(self, position: Vector, velocity: Vector, acceleration: Vector, jerk: Vector) -> None:
        self.position = position
        self.velocity = velocity
        self.acceleration = acceleration
        self.jerk = jerk
        self.bend: Bend = bend(velocity, acceleration, jerk)


class MovingPoint:
    """A motion as functions of time, for numbers of any type; `flat`: it stays in the x–y plane."""

    def __init__(
        self,
        formulas: "dict[str, Formula | None]",
        shape: "Any",
        parameter: "Formula | None",
        let: "tuple[Let, ...]",
    ) -> None:
        self.formulas = {name: formula for name, formula in formulas.items() if formula is not None}
        require(
            bool(self.formulas) != (shape is not None),
            "the motion is either formulas x, y, z or a named curve",
            code="motion",
            hint="--x '3*cos(t) m' --y '3*sin(t) m', --radius-law '2 m' --angle-law '3*t rad', or --curve helix",
        )
        self.turns = "radius law" in self.formulas
        self.shape = shape
        self.let = let
        self.parameter = parameter
        self.flat = "z" not in self.formulas if shape is None else type(shape).__name__ not in ("Helix", "Line")
        self.laws = {name: law_of(formula, let, ("t",), LET) for name, formula in self.formulas.items()}
        self.law = law_of(parameter, let, ("t",), LET) if parameter is not None else None

    def state(self, time: "Any") -> State:
        """The state at a time."""
        paths = self._paths(Jet.variable(time, 3))
        return State(*[_vector([path.derivative(k) for path in paths]) for k in range(4)])

    def speed(self, time: float) -> float:
        """The speed alone, of doubles."""
        return math.hypot(*(path.parts[1] for path in self._paths(Jet.variable(time, 1))))

    def _paths(self, clock: Jet) -> "list[Jet]":
        """The coordinates as jets over the time."""
        if self.turns:
            radius, angle = self._turning(clock)
            height = self.laws["z"](t=clock) if "z" in self.laws else 0.0
            parts: Any = (radius * elementary.cos(angle), radius * elementary.sin(angle), height)
        elif self.shape is None:
            parts = [self.laws[name](t=clock) if name in self.laws else 0.0 for name in "xyz"]
        else:
            parts = self.shape.place(clock if self.law is None else _jet(self.law(t=clock), clock))
        return [_jet(part, clock) for part in parts]

    def _turning(self, clock: Jet) -> "tuple[Any, Any]":
        """Distance from the pole and angle as jets."""
        return _jet(self.laws["radius law"](t=clock), clock), _jet(self.laws["angle law"](t=clock), clock)

    def turning(self, time: "Any") -> "tuple[tuple[Any, Any], ...]":
        """Distance from the pole and angle, with their first and second derivatives."""
        radius, angle = self._turning(Jet.variable(time, 2))
        return tuple((radius.derivative(k), angle.derivative(k)) for k in range(3))

    def plainly(self) -> "MovingPoint":
        """The same with doubles in place of tracked numbers."""
        return self._with(plain)

    def many(self) -> "MovingPoint":
        """The same with numbers of many digits."""
        from dynamics_cli.numerics.exact.many_digits import ManyDigits

        return self._with(lambda value: ManyDigits.inputs([plain(value)])[0])

    def _with(self, convert: "Callable[[Any], Any]") -> "MovingPoint":
        """The same with other numbers."""

        def converted(value: "Any") -> "Any":
            if isinstance(value, tuple):
                return tuple(map(converted, value))
            return value if value is None else convert(value)

        let = tuple(Let(each.name, converted(each.value), each.unit, each.dimension) for each in self.let)
        shape = self.shape
        if shape is not None:
            shape = type(shape)(**{name: converted(getattr(shape, name)) for name in shape.fields})
        return MovingPoint({**self.formulas}, shape, self.parameter, let)

    def sharp(self, time: "Any") -> State:
        """The state at a time, evaluated in 60 digits where terms of the formulas cancel."""
        carrier = next(filter(is_carrier, (time, *self._inputs())), None)
        number = like(time, carrier) if carrier is not None else Tracked(time, 0.0, ())
        state = self._sharpened(number)
        if carrier is None:
            for name in State.__slots__:
                setattr(state, name, over_plain(getattr(state, name)))
        return state

    def _inputs(self) -> "list[Any]":
        fields = [getattr(self.shape, name) for name in self.shape.fields] if self.shape is not None else []
        numbers = [variable.value for variable in self.let]
        for field in fields:
            numbers.extend(field if isinstance(field, tuple) else (field,))
        return numbers

    def _sharpened(self, number: "Any") -> State:
        state = self.state(number)
        if is_many(number) or not any(map(_loose, _numbers(state.bend))):
            return state
        from dynamics_cli.numerics.exact.many_digits import ManyDigits, run

        try:
            exact = run(lambda: self.many().state(ManyDigits.inputs([plain(number)])[0]))
        except (DynamicsError, ArithmeticError):
            return state
        for name in ("position", "velocity", "acceleration", "jerk"):
            setattr(state, name, _sharper(getattr(state, name), getattr(exact, name)))
        fields = {name: _sharper(getattr(state.bend, name), getattr(exact.bend, name)) for name in state.bend.fields}  # type: ignore[attr-defined]
        state.bend = Bend(**fields)
        return state

    def check(self, start: float, end: float) -> None:
        """Refuse a pole, a corner or a gap between two times."""
        from dynamics_cli.numerics.expressions.domain import first_fault
        from dynamics_cli.numerics.expressions.laws import parsed

        values = {variable.name: float(plain(variable.value)) for variable in self.let}
        formulas = {**self.formulas, **({"the law": self.parameter} if self.parameter is not None else {})}
        for name, formula in formulas.items():
            expression = parsed(formula, {"t", *values})
            named = {key: value for key, value in values.items() if key in expression.names}
            fault = first_fault(expression, "t", start, end, **named) if end > start else None
            require(
                fault is None,
                "{name} = {text} has a pole, a corner or no value at {time:6}",
                code="pole",
                hint="choose a range of times without it; now it runs from {start} to {end}",
                name=name,
                text=formula.text,
                time=(fault or 0.0, Time),
                start=(start, Time),
                end=(end, Time),
            )


def _jet(part: "Any", clock: Jet) -> Jet:
    return part if isinstance(part, Jet) else clock * 0.0 + part


def _vector(parts: "list[Any]") -> Vector:
    return parts[0], parts[1], parts[2]


def _numbers(motion: Bend) -> "list[Any]":
    values = [getattr(motion, name) for name in ("speed", "tangential", "normal", "curvature", "torsion")]
    return [value for value in values if is_tracked(value)]


def _loose(number: Tracked) -> bool:
    return number.error > LOOSE * abs(number.value)


def _sharper(number: "Any", exact: "Any") -> "Any":
    """A tracked number with the value that many digits give, and its rounding as the only error."""
    if isinstance(number, tuple) and isinstance(exact, tuple):
        return tuple(_sharper(variable, precise) for variable, precise in zip(number, exact, strict=True))
    if not is_tracked(number) or not is_many(exact):
        return exact if number is None and not is_many(exact) else number
    value = plain(exact)
    if not math.isfinite(value):
        return number
    # 60 digits leave this of the error of doubles, and a value below it is none
    left_over = 1e-40 * number.error
    value = value if abs(value) > left_over else 0.0
    return Tracked(value, 2.0 * UNIT_ROUNDOFF * abs(value) + left_over + 5e-324, number.slopes)
