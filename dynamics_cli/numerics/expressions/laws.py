"""A formula with its unit as a function of numbers in SI."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.expressions import check_names, parse
from dynamics_cli.records import Formula, Let

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any


def law_of(
    formula: Formula, let: "tuple[Let, ...]" = (), variables: "tuple[str, ...]" = ("t", "x", "v")
) -> "Callable[..., Any]":
    """The function of a formula in SI, with the variables of `let` filled in.

    Raises
    ------
    UsageError
        When a name has no value.
    InadmissibleError
        When the formula has variables with units, and its own unit is not the coherent one of SI.
    """
    expression = parse(formula.text)
    values = {item.name: item.value for item in let}
    check_names(expression, {*variables, *values})
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

    def value(**variables_now: "Any") -> "Any":
        out = expression(**values, **variables_now)
        return out if formula.factor == 1.0 else out * formula.factor

    return value
