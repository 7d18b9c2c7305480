"""Pictures that the core makes itself: of a sweep, and of an uncertain result and what drives it."""

import math

from dynamics_cli.pictures import Axis, Band, Bars, Curve, Panel, Picture

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any

    from dynamics_cli.core.uncertainty import Propagation, Spread
    from dynamics_cli.quantities import Kind

MOST_SWEPT = 6
MOST_DRIVERS = 12


def of_sweep(document: "dict[str, Any]") -> "Picture | None":
    """Every result of a sweep over the swept parameter; of two, a curve for each value of the second."""
    table: dict[str, Any] = document["results"]["sweep"]
    axes: list[str] = [axis["parameter"] for axis in document["inputs"]["sweep"]]
    names = [
        name
        for name in table
        if name not in axes and name.rpartition(".")[0] not in table and _numbers(table[name]["value"])
    ]
    panels = tuple(_swept(table, axes, name) for name in names[:MOST_SWEPT])
    return Picture(panels, f"dynamics {document['command']}") if panels else None


def _numbers(column: "list[Any]") -> bool:
    return all(value is None or isinstance(value, int | float) for value in column) and any(
        isinstance(value, float) for value in column
    )


def _swept(table: "dict[str, Any]", axes: "list[str]", name: str) -> Panel:
    def titled(key: str) -> Axis:
        unit = table[key].get("unit", "")
        words = key.replace("_", " ")
        return Axis(f"{words} [{unit}]" if unit else words)

    first = table[axes[0]]["value"]
    values = [math.nan if value is None else value for value in table[name]["value"]]
    if len(axes) == 1:
        items = [Curve(first, values, role=0)]
        for end in (f"{name}.low", f"{name}.high"):
            if end in table:
                ends = [math.nan if value is None else value for value in table[end]["value"]]
                items.append(Curve(first, ends, "" if end.endswith("high") else "ends of the interval", "dashed", 0))
        return Panel(titled(axes[0]), titled(name), tuple(items))
    second = table[axes[1]]
    curves = []
    for level in dict.fromkeys(second["value"]):
        rows = [index for index, value in enumerate(second["value"]) if value == level]
        label = f"{axes[1].replace('_', ' ')} = {level:g} {second.get('unit', '')}".rstrip()
        curves.append(Curve([first[row] for row in rows], [values[row] for row in rows], label))
    return Panel(titled(axes[0]), titled(name), tuple(curves))


def of_spread(
    command: str, made: "Propagation", kinds: "Mapping[str, Kind]", limits: "Mapping[str, list[float]]"
) -> "Picture | None":
    """The distribution of the first result that varies (the limited one, if any) and its tornado."""
    varying = [spread for spread in made.spreads.values() if spread.interval[0] < spread.interval[1]]
    varying.sort(key=lambda spread: spread.name not in limits)
    if not varying:
        return None
    spread = varying[0]
    axis = Axis(spread.name.replace("_", " "), kinds[spread.name])
    panels = [_density(spread, axis, made.coverage, limits.get(spread.name, []))]
    if spread.tornado:
        panels.append(_tornado(made, spread, axis))
    return Picture(tuple(panels), f"dynamics {command}: {axis.title}")


def _density(spread: "Spread", axis: Axis, coverage: float, limits: "list[float]") -> Panel:
    values, chances = spread.cumulative
    middles, heights = [], []
    for i in range(len(values) - 1):
        step = values[i + 1] - values[i]
        middles.append(0.5 * (values[i] + values[i + 1]))
        heights.append(max(0.0, chances[i + 1] - chances[i]) / step)
    # Relative to the highest, so that the vertical axis needs no unit.
    top = max(heights, default=1.0) or 1.0
    items: list[Any] = [
        Band(*spread.interval, f"{100.0 * coverage:.6g} % interval"),
        Curve(middles, [height / top for height in heights], "density", role=0),
        Curve(values, chances, "probability of less", "dashed", role=6),
    ]
    items += [Band(limit, limit, "limit") for limit in limits]
    return Panel(axis, Axis("relative density, probability"), tuple(items))


def _tornado(made: "Propagation", spread: "Spread", axis: Axis) -> Panel:
    rows = []
    for name, (a, b), share in zip(made.inputs, spread.tornado, spread.total or spread.first, strict=True):
        if math.isfinite(a) and math.isfinite(b):
            rows.append((abs(b - a), f"{name} ({100.0 * share:.0f} %)", min(a, b), max(a, b)))
    rows.sort(key=lambda row: -row[0])
    rows = rows[:MOST_DRIVERS]
    bars = Bars(tuple(row[1] for row in rows), [row[2] for row in rows], [row[3] for row in rows])
    title = "each input alone over its interval (share of the variance)"
    return Panel(axis, Axis(""), (bars, Band(spread.median, spread.median, "median")), title)
