"""Requests for single results: probabilities beyond limits, and quantiles."""

from dynamics_cli.core.answering.limits import limit_entry
from dynamics_cli.core.documents import number
from dynamics_cli.core.inputs.settings import read_probability
from dynamics_cli.core.units.near_names import instead_of
from dynamics_cli.errors import UsageError
from dynamics_cli.numerics.number import plain

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping
    from typing import Any

    from dynamics_cli.core.inputs.settings import Settings
    from dynamics_cli.core.uncertainty.propagation import Propagation
    from dynamics_cli.core.units.display import Shown
    from dynamics_cli.quantities import Kind

# Quantiles farther out cannot be had from inputs known by mean and deviation.
LEAST_LEVEL = 1e-6
_PERCENT = 100.0


def read_levels(kinds: "Mapping[str, Kind]", settings: "Settings") -> "list[tuple[str, float]]":
    """`--quantile speed="5 %"`: a result by name and a probability, as often as given."""
    levels = []
    for name, text in settings.quantile:
        if name not in kinds:
            hint = instead_of(name, kinds)
            raise UsageError(f"there is no result {name!r}", parameter="quantile", hint=hint, code="unknown-result")
        levels.append((name, read_probability(text, "quantile", LEAST_LEVEL)))
    return levels


def limit_entries(
    limits: "list[Any]", propagation: "Propagation", shown: "Mapping[str, Shown]"
) -> "list[dict[str, Any]]":
    """The document's entry for each limit: within it or not, and the probability of exceeding it."""
    entries = []
    for key, _, value, reading in limits:
        entry = limit_entry(key, plain(value), reading, shown[key])
        if key not in propagation.spreads:
            # a result that is not spread over the inputs, such as an error of the calculation
            entries.append(entry)
            continue
        p = next(p for limit, p in propagation.spreads[key].beyond if limit == reading.si)
        entry["probability"] = p
        text = f"{number(reading.value, 6)} {reading.unit}".rstrip()
        entry["message"] = f"{key} is beyond {text} with a probability of {chance(p)}"
        entries.append(entry)
    return entries


def level_entries(
    levels: "list[tuple[str, float]]", propagation: "Propagation", shown: "Mapping[str, Shown]"
) -> "list[dict[str, Any]]":
    """The document's entry for each requested quantile."""
    entries = []
    for name, level in levels:
        if name not in propagation.spreads:
            continue
        unit = shown[name]
        value = unit.value(
            next(level_value for asked, level_value in propagation.spreads[name].levels if asked == level)
        )
        message = f"{name} is below {number(value, 6)} {unit.text}".rstrip() + f" with a probability of {chance(level)}"
        own = {"unit": unit.text} if unit.text else {}
        entries.append({"result": name, "probability": level, "value": value, **own, "message": message})
    return entries


def chance_entries(chances: "Mapping[str, str]", propagation: "Propagation") -> "dict[str, Any]":
    """The document's entries for each yes or no: the probability of yes, which is that its margin is above zero."""
    spread = [(name, propagation.spreads[margin]) for name, margin in chances.items() if margin in propagation.spreads]
    entries = {
        name: {"probability": next(p for limit, p in margin.beyond if limit == 0.0)}
        for name, margin in spread
        if margin.varies
    }
    return {"chances": entries} if entries else {}


def grouped(pairs: "Iterable[tuple[str, float]]") -> "dict[str, list[float]]":
    """The numbers of each name."""
    numbers: dict[str, list[float]] = {}
    for name, value in pairs:
        numbers.setdefault(name, []).append(value)
    return numbers


def chance(p: float) -> str:
    """A probability for people: `3.4 %`, and never a rounded 0 or 100 %."""
    if p in (0.0, 1.0):
        return f"{_PERCENT * p:.0f} %"
    if p < 1e-4:
        return "< 0.01 %"
    if p > 1.0 - 1e-4:
        return "> 99.99 %"
    return f"{_PERCENT * p:.3g} %"
