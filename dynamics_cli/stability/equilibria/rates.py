"""States and their rates as formulas, with exact slopes."""

import math

from dynamics_cli.errors import UsageError
from dynamics_cli.numerics.expressions import check_names, parse
from dynamics_cli.numerics.expressions.jets import Jet
from dynamics_cli.numerics.tracked import Tracked
from dynamics_cli.quantities import Annotated, Ratio, Text, Variable
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Point = tuple[float, ...]


@record
class State:
    """One state and its rate."""

    name: Annotated[Text, "The state, a name for formulas, e.g. x."]
    rate: Annotated[Text, "Its rate, a formula of the states, e.g. y - x^3."]
    low: Annotated[Ratio, "Where its range of search begins, e.g. -5."] = -5.0
    high: Annotated[Ratio, "Where it ends, e.g. 5."] = 5.0


class Rates:
    """The rates of the states as one function of doubles or jets."""

    def __init__(self, states: "tuple[State, ...]", let: "tuple[Variable, ...]") -> None:
        self.names = [state.name for state in states]
        if len(set(self.names)) < len(self.names):
            raise UsageError("two states have one name", code="names", parameter="states")
        values = {one.name: one.value for one in let}
        self.values = {name: value for name, value in values.items() if name not in self.names}
        self.formulas = [parse(state.rate) for state in states]
        for formula in self.formulas:
            check_names(formula, {*self.names, *values})

    def at(self, place: "Point") -> "list[float]":
        """The rates at a place; what has no value is not a number."""
        return self._evaluated(dict(zip(self.names, place, strict=True)))

    def _evaluated(self, given: "dict[str, Any]") -> "list[Any]":
        try:
            return [formula(**self.values, **given) for formula in self.formulas]
        except (ArithmeticError, ValueError):
            return [math.nan] * len(self.names)

    def on(self, curve: "list[list[float]]") -> "list[list[float]]":
        """Taylor coefficients of each rate on a curve, given by those of every state."""
        order = len(curve[0]) - 1
        rates = self._evaluated(dict(zip(self.names, map(Jet, curve), strict=True)))
        return [parts_of(rate, order) for rate in rates]

    def along(self, place: "Point", direction: "Point", order: int) -> "list[list[float]]":
        """Taylor coefficients of each rate in t, on the line place + t·direction."""
        return self.on([[at, step, *[0.0] * (order - 1)] for at, step in zip(place, direction, strict=True)])

    def tracked(self, place: "Point") -> "list[Tracked]":
        """The rates at a place with their rounding and their slopes."""
        rates = self._evaluated(dict(zip(self.names, Tracked.inputs(place), strict=True)))
        return [rate if isinstance(rate, Tracked) else Tracked(rate, 0.0, (0.0,) * len(place)) for rate in rates]

    def jacobian(self, place: "Point") -> "list[list[float]]":
        """The slopes by every state, a row for each rate, exact but for rounding."""
        return self.linear(place)[0]

    def linear(self, place: "Point") -> "tuple[list[list[float]], list[float]]":
        """The slopes, a row for each rate, and the rates themselves."""
        given = dict(zip(self.names, place, strict=True))
        columns: list[list[float]] = []
        values = [math.nan] * len(self.names)
        for name, value in given.items():
            rates = self._evaluated({**given, name: Jet.variable(value, 1)})
            values = [rate.parts[0] if isinstance(rate, Jet) else rate for rate in rates]
            columns.append([rate.parts[1] if isinstance(rate, Jet) else 0.0 * rate for rate in rates])
        return [list(row) for row in zip(*columns, strict=True)], values


def parts_of(value: "Any", order: int) -> "list[float]":
    """The Taylor coefficients of a rate; those of a constant are zero."""
    return value.parts if isinstance(value, Jet) else [value, *[0.0] * order]
