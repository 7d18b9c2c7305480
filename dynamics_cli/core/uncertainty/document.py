"""What uncertain inputs add to a document: spreads of the results, their drivers, probabilities beyond limits."""

import math

import numpy as np

from dynamics_cli.core.answering.limits import read_limits
from dynamics_cli.core.answering.models import result_numbers
from dynamics_cli.core.inputs.settings import METHODS, read_coverage
from dynamics_cli.core.inputs.uncertain.values import read_correlations
from dynamics_cli.core.output.row_layout import nested
from dynamics_cli.core.uncertainty.carried_correlations import carried
from dynamics_cli.core.uncertainty.limits_and_quantiles import (
    chance,
    chance_entries,
    grouped,
    level_entries,
    limit_entries,
    read_levels,
)
from dynamics_cli.core.uncertainty.methods.outcome import FAIR
from dynamics_cli.core.uncertainty.model import TaskModel
from dynamics_cli.core.uncertainty.propagation import DEFAULT_ACCURACY, Propagation, Spread, propagate
from dynamics_cli.core.uncertainty.tails import drop_moments, narrowing, remedy
from dynamics_cli.errors import UsageError
from dynamics_cli.numerics.quadrature.lattice import DEFAULT_SEED

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any

    from dynamics_cli.core.answering.models import Answer
    from dynamics_cli.core.answering.task import Model, Task
    from dynamics_cli.core.inputs.reader import Reader
    from dynamics_cli.core.inputs.settings import Settings
    from dynamics_cli.core.inputs.values import Fields
    from dynamics_cli.core.units.display import Display, Shown
    from dynamics_cli.pictures import Picture, Spreads
    from dynamics_cli.quantities import Kind

# A formula called case by case is some hundred times slower than one on arrays.
SLOW_POINTS = 20_000
SLOW_ACCURACY = 1e-3
# Number of results named in a warning about poorly known ones.
MOST_NAMED = 3


def add_uncertainty(
    document: "dict[str, Any]",
    task: "Task",
    bound: "Fields",
    answered: "Answer",
    reader: "Reader",
    settings: "Settings",
    display: "Display",
) -> "tuple[Picture | None, Spreads | None]":
    """Propagate the inputs' distributions through the task's model and add the outcome.

    For a requested picture or drawing, how the first result is spread, and what a task's own picture needs to know.
    """
    kinds = {name: kind for name, kind, _ in result_numbers(answered.record, task.specification.result)}
    limits = read_limits(task, bound, answered, settings)
    wanted = grouped((key, reading.si) for key, _, _, reading in limits)
    levels = read_levels(kinds, settings)
    asked = grouped(levels)
    margins = [(margin, 0.0) for margin in task.chances.values() if margin in kinds]
    beyond = grouped([*((key, reading.si) for key, _, _, reading in limits), *margins])
    more = {"limits": beyond, "levels": asked, "slopes": _slopes(answered, task), "curve": bool(settings.plot)}
    more["partly"] = bool(settings.time_limit) and not settings.plot
    only = _chosen(task, settings, kinds, {*beyond, *asked})
    pictured = bool(settings.plot or settings.drawing)
    if settings.only and not pictured and not only:  # a table, or a name that does not exist
        return None, None
    more["shares"] = pictured or not settings.only
    propagation = spread_of(task, answered.model, bound, answered.record, reader, settings, more=more, only=only)
    shown = {name: display.of(name.partition("[")[0], kind) for name, kind in kinds.items()}
    _add_results(document["results"], propagation, shown)
    document["numerics"]["uncertainty"] = _method_entry(propagation)
    if drivers := _sensitivity(propagation, shown):
        document["sensitivity"] = drivers
    if propagation.correlation is not None:
        document["covariance"] = _covariance(propagation, shown)
    if limits:
        document["limits"] = limit_entries(limits, propagation, shown)
    if levels:
        document["quantiles"] = level_entries(levels, propagation, shown)
    document |= chance_entries(task.chances, propagation)
    spread = {name.partition("[")[0].partition(".")[0] for name in kinds}
    nominal = any(isinstance(node, dict | list) for name, node in document["results"].items() if name not in spread)
    document["warnings"] += _warnings(propagation, _seen(task, settings), nominal=nominal)
    if not pictured:
        return None, None
    from dynamics_cli.core.uncertainty.pictures import of_spread, spreads_of

    spreads = spreads_of(task, bound, document["inputs"], propagation, wanted, reader.uncertain or {})
    return of_spread(task, document["inputs"], propagation, kinds, wanted) if settings.plot else None, spreads


def _chosen(task: "Task", settings: "Settings", kinds: "Mapping[str, Kind]", named: "set[str]") -> "tuple[str, ...]":
    """The results that the answer shows, and those named by limits and quantiles; none for all of them."""
    pictured = settings.plot or settings.drawing
    if settings.only and not pictured:
        asked = (*settings.only, *named)
        return tuple(
            name
            for name in kinds
            if any(f"{one}.".startswith(f"{name.partition('[')[0]}.") or name.startswith(f"{one}.") for one in asked)
        )
    shown = _seen(task, settings)
    return () if pictured or not shown else tuple(name for name in kinds if name.partition("[")[0] in shown | named)


def _seen(task: "Task", settings: "Settings") -> "set[str]":
    """The results of an answer that shows the headline alone; none where all are shown, or those asked for."""
    chosen = settings.format != "table" or settings.all or settings.only
    return set() if chosen else {address for address, _ in task.headline}


def spread_of(
    task: "Task",
    model: "Model",
    bound: "Fields",
    record: "Any",
    reader: "Reader",
    settings: "Settings",
    *,
    more: "Mapping[str, Any] | None" = None,
    only: "tuple[str, ...]" = (),
) -> Propagation:
    """The distributions of a task's results, or `only` of some, by the settings of the call."""
    sampled = TaskModel(task, model, bound, record)
    sampled.names = [name for name in sampled.names if not only or name in only]
    distributions = reader.uncertain or {}
    asked = read_correlations(settings.correlate, list(distributions))
    come = carried(reader.origins, list(distributions)) if len(reader.origins) > 1 else {}
    come = {(a, b): rho for (a, b), rho in come.items() if (a, b) not in asked and (b, a) not in asked}
    # what leaves the range of a double somewhere in a distribution is no word for the terminal
    with np.errstate(all="ignore"):
        propagation = propagate(
            sampled,
            distributions,
            {**come, **asked},
            coverage=read_coverage(settings.coverage),
            method=read_method(settings.method),
            accuracy=DEFAULT_ACCURACY if task.arrays else SLOW_ACCURACY,
            samples=settings.samples or task.points or (0 if task.arrays else SLOW_POINTS),
            seed=settings.seed or DEFAULT_SEED,
            **{"shares": False, **(more or {})},
        )
    for spread in propagation.spreads.values():
        drop_moments(spread, propagation.coverage)
    return propagation


def read_method(text: str) -> str:
    """The name of a method of propagation as `--method` takes it."""
    name = text.lower().replace("_", "-") or "auto"
    if name not in METHODS:
        raise UsageError(
            f"read {text!r}, wanted one of {', '.join(METHODS)}", parameter="method", code="unknown-choice"
        )
    return name


def _slopes(answered: "Answer", task: "Task") -> "dict[str, dict[str, float]] | None":
    """Derivatives with respect to the inputs, as carried through the formula at the means."""
    if not answered.leaves:
        return None
    made = {}
    for name, _, value in result_numbers(answered.record, task.specification.result):
        slopes = getattr(value, "slopes", None)
        if slopes is not None:
            made[name] = {leaf: slope for (leaf, _), slope in zip(answered.leaves, slopes, strict=True)}
    return made or None


def _add_results(results: "dict[str, Any]", propagation: Propagation, shown: "Mapping[str, Shown]") -> None:
    """Put its distribution beside every result that varies; for a vector, in lists like its value."""
    vary = propagation.varying()
    for name, spread in propagation.spreads.items():
        stem, *steps = name.replace("]", "").split("[")
        indices = [int(step) for step in steps]
        node: Any = results
        for key in stem.split("."):
            node = node.get(key) if isinstance(node, dict) else None
        if stem not in vary or not isinstance(node, dict) or "value" not in node:
            continue
        unit = shown[name]
        low, high = (unit.value(end) for end in spread.interval)
        figures = {
            "mean": _finite(unit.value(spread.mean)) if math.isfinite(spread.mean) else None,
            "median": unit.value(spread.median),
            "std": unit.deviation(spread.std) if math.isfinite(spread.std) else None,
        }
        if not indices:
            node |= {**figures, "interval": [low, high], "coverage": propagation.coverage}
            continue
        for key, figure in figures.items():
            nested(node.setdefault(key, []), indices).append(figure)
        for end, figure in zip(node.setdefault("interval", [[], []]), (low, high), strict=True):
            nested(end, indices).append(figure)
        node["coverage"] = propagation.coverage


def _finite(value: "Any") -> "Any":
    return value if isinstance(value, list) or math.isfinite(value) else None


def _method_entry(propagation: Propagation) -> "dict[str, Any]":
    """Method and error estimate (in standard deviations) of every result; the method of the shares."""
    results = {}
    for name, spread in propagation.spreads.items():
        if spread.varies:
            entry: dict[str, Any] = {"method": spread.method, "estimate": _two_digits(spread.estimate)}
            if spread.admissible < 1.0 - 1e-12:
                entry["admissible"] = spread.admissible
            results[name] = entry
    out: dict[str, Any] = {"results": results, "seed": propagation.seed, "evaluations": propagation.points}
    if propagation.correlated:
        out["correlations"] = {f"{one},{other}": rho for (one, other), rho in propagation.correlated.items()}
    if propagation.shares_method:
        out["shares"] = {"method": propagation.shares_method}
        if math.isfinite(propagation.shares_error):
            out["shares"]["estimate"] = _two_digits(propagation.shares_error)
    return out


def _two_digits(number_: float) -> "float | None":
    return float(f"{number_:.1e}") if math.isfinite(number_) else None


def _share(value: float) -> float:
    return float(f"{value:.4f}") + 0.0


def _sensitivity(propagation: Propagation, shown: "Mapping[str, Shown]") -> "dict[str, Any]":
    """For every result the inputs ranked by share of the variance, the range each gives alone, and the corners."""
    out = {}
    for name, spread in propagation.spreads.items():
        if not spread.first or not spread.varies:
            continue
        unit = shown[name]
        rows = []
        for index, leaf in enumerate(propagation.inputs):
            row: dict[str, Any] = {"input": leaf, "share": _share(spread.first[index])}
            if spread.total[index] != spread.first[index]:
                row["total"] = _share(spread.total[index])
            low, high = spread.tornado[index] if spread.tornado else (math.nan, math.nan)
            row["alone"] = [_number(unit, low), _number(unit, high)]
            rows.append(row)
        rows.sort(key=lambda row: -abs(row.get("total", row["share"])))
        entry: dict[str, Any] = {"inputs": rows}
        if unit.text:
            entry["unit"] = unit.text
        if spread.corners:
            entry["worst_case"] = [_number(unit, spread.corners[0]), _number(unit, spread.corners[1])]
        out[name] = entry
    return out


def _number(unit: "Shown", si: float) -> "Any":
    return unit.value(si) if math.isfinite(si) else None


def _covariance(propagation: Propagation, shown: "Mapping[str, Shown]") -> "dict[str, Any]":
    """Correlation and covariance of the results that vary and are not copies of one another, in the units shown."""
    assert propagation.correlation is not None
    names = list(propagation.spreads)
    kept: list[int] = []
    same: dict[str, str] = {}
    for i, name in enumerate(names):
        spread = propagation.spreads[name]
        if spread.std > 0.0:
            twin = next((names[j] for j in kept if _same(spread, propagation.spreads[names[j]])), "")
            if twin:
                same[name] = twin
            else:
                kept.append(i)
    copies = {"same": same} if same else {}
    if len(kept) < 2:
        return {"results": [names[i] for i in kept], **copies}
    correlation = propagation.correlation[np.ix_(kept, kept)]
    widths = np.array([shown[names[i]].width(propagation.spreads[names[i]].std) for i in kept])
    return {
        "results": [names[i] for i in kept],
        **copies,
        "units": [shown[names[i]].text for i in kept],
        "correlation": [[float(f"{x:.6f}") + 0.0 for x in row] for row in correlation],
        "covariance": [[float(f"{x:.6g}") + 0.0 for x in row] for row in correlation * np.outer(widths, widths)],
    }


def _same(one: Spread, other: Spread) -> bool:
    return one.interval == other.interval and one.median == other.median


def _warnings(propagation: Propagation, seen: "set[str]", *, nominal: bool) -> "list[dict[str, Any]]":
    """What a reader has to know of the intervals, and of a headline (`seen`) that has none."""
    out, vary = [], propagation.varying()
    partly = [s for s in propagation.spreads.values() if s.admissible < 1.0 - 1e-5]  # rarer: no digit
    if partly:
        least, refused = min(partly, key=lambda spread: spread.admissible), propagation.space.refuses
        name, share = least.name.replace("_", " ").replace(".", " "), 1.0 - least.admissible
        what = "is inadmissible; results are" if refused else f"has no {name}; its interval is"
        message = f"{chance(share)} of the inputs' distribution {what} for the rest"
        severity = "serious" if refused and share >= 0.05 else "caution" if share >= 1e-3 else "note"
        out.append({"code": "partly-inadmissible", "severity": severity, "message": message})
    rough = [s for s in propagation.spreads.values() if s.varies and not s.estimate <= FAIR and not s.tails]
    if rough:
        names = [s.name.replace("_", " ").replace(".", " ") for s in rough[:MOST_NAMED]] + [
            f"{len(rough) - MOST_NAMED} more"
        ] * (len(rough) > MOST_NAMED)
        listed = " and ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names)
        are = "intervals of {} are themselves" if len(rough) > 1 else "interval of {} is itself"
        worst = max(s.estimate for s in rough)
        known = f"known only to {worst:.1g} standard deviations" if math.isfinite(worst) else "hardly known"
        message, helps = f"the {are.format(listed)} {known}", remedy(propagation, rough)
        out.append({"code": "uncertainty-estimate", "severity": "caution", "message": message, "remedy": helps})
    if propagation.stopped:
        done, every = len(propagation.spreads), len(propagation.stopped)
        message = f"the time limit was reached: {done} of {every} results have a distribution"
        helps = "raise --time-limit, or give a smaller number of --samples"
        out.append({"code": "time-limit", "severity": "serious", "message": message, "remedy": helps})
    elif propagation.inputs and (not vary or (seen and not vary & seen)):
        message = "no interval is calculated for these results: they hold at the means of the uncertain inputs"
        message = message if nominal else "none of the results here depends on the uncertain inputs"
        out.append({"code": "nothing-varies", "severity": "caution", "message": message})
    return out + _no_deviations(propagation)


def _no_deviations(propagation: Propagation) -> "list[dict[str, Any]]":
    """Results whose distribution has no standard deviation."""
    out: list[dict[str, Any]] = []
    if long := [s for s in propagation.spreads.values() if s.tails]:
        names = ", ".join(s.name.replace("_", " ").replace(".", " ") for s in long)
        message = f"{names}: no standard deviation, values have no bound within the inputs' distribution"
        other = narrowing(propagation, long[0]) or "give inputs with bounds, such as 0.3..0.4"
        helps = f"use the median and the interval, or {other}"
        out.append({"code": "no-deviation", "severity": "caution", "message": message, "remedy": helps})
    if any(s.varies and not s.tails and not math.isfinite(s.std) for s in propagation.spreads.values()):
        message = "two or three readings give no standard deviation; intervals hold, shares are slopes"
        helps = "four readings or more"
        out.append({"code": "no-deviation", "severity": "note", "message": message, "remedy": helps})
    return out
