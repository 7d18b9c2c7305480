"""A formula with its unit, or units at its numbers, as a function of numbers in SI."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.expressions import Expression, check_names, parse
from dynamics_cli.records import Formula, Let

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping
    from typing import Any


def parsed(formula: Formula, taken: "Iterable[str]" = ()) -> Expression:
    """The formula read; in `3 m/s*m` the last m is a variable if that name is taken."""
    units = {name: (size, powers) for name, size, powers in formula.units}
    return parse(formula.text, None, units, set(taken))


def law_of(
    formula: Formula,
    let: "tuple[Let, ...]" = (),
    variables: "tuple[str, ...] | Mapping[str, tuple[int, ...]]" = ("t", "x", "v"),
    more: str = "",
) -> "Callable[..., Any]":
    """The function of a formula in SI, with the variables of `let` filled in; `more` ends the hint about others.

    Raises
    ------
    UsageError
        When a name has no value, or numbers have units and the formula's dimension does not fit.
    InadmissibleError
        When the formula has variables with units, and its own unit is not the coherent one of SI.
    """
    values = {item.name: item.value for item in let}
    expression = parsed(formula, {*variables, *values})
    check_names(expression, {*variables, *values}, more)
    used = [item.name for item in let if item.unit and item.name in expression.names]
    require(
        not used or formula.factor == 1.0,
        "the formula {text} ends in {unit}, but {names} in it has a unit too",
        code="mixed-units",
        hint="variables are in m, s and rad: end the formula in m, rad or m/s^2",
        text=repr(formula.text),
        unit=formula.unit,
        names=", ".join(used),
    )
    if formula.wanted and (formula.units or used):
        from dynamics_cli.numerics.expressions.dimensions import VARIABLES, check_dimension

        table = variables if isinstance(variables, dict) else VARIABLES
        # where plain numbers may stand for anything, so may t and x
        known = {name: table.get(name) for name in variables} if formula.units else {}
        check_dimension(formula, expression.tree, known | {item.name: item.dimension for item in let})

    def value(**variables_now: "Any") -> "Any":
        out = expression(**values, **variables_now)
        return out if formula.factor == 1.0 else out * formula.factor

    return value
