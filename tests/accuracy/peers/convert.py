"""Conversions by pint."""

from collections.abc import Callable
from functools import cache
from typing import Any

from dynamics_cli.accuracy.cases import Case


@cache
def _registry() -> Any:
    from dynamics_cli.core.units.fallback import registry

    return registry()


def by_pint(case: Case) -> Callable[[], float]:
    """The usual library, its quantity made and converted."""
    source, target = (case.inputs[key].replace("^", "**").replace("rev", "turn") for key in ("from", "to"))
    value, quantity = float(case.inputs["value"]), _registry().Quantity
    return lambda: float(quantity(value, source).to(target).magnitude)
