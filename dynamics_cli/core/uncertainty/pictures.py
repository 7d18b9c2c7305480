"""The picture of an uncertain result: its distribution, and what drives it."""

import itertools
import math

import numpy as np

from dynamics_cli.core.answering.models import arguments
from dynamics_cli.core.output.answer_words import body_names, input_in_words, label_in_words, with_name
from dynamics_cli.numerics.distributions.normal_arrays import quantile
from dynamics_cli.numerics.quadrature.lattice import MOST_DIMENSIONS, lattice
from dynamics_cli.pictures import Axis, Band, Bars, Curve, Panel, Picture, Spreads

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping
    from typing import Any

    from dynamics_cli.core.answering.task import Task
    from dynamics_cli.core.inputs.uncertain.distributions import Distribution
    from dynamics_cli.core.inputs.values import Fields
    from dynamics_cli.core.uncertainty.propagation import Propagation, Spread
    from dynamics_cli.quantities import Kind

MOST_DRIVERS = 12
FAIR_CASES = 512


def of_spread(
    task: "Task",
    inputs: "dict[str, Any]",
    made: "Propagation",
    kinds: "Mapping[str, Kind]",
    limits: "Mapping[str, list[float]]",
) -> "Picture | None":
    """The distribution of the first result that varies (the limited one, if any) and its tornado."""
    varying = [spread for spread in made.spreads.values() if spread.interval[0] < spread.interval[1]]
    # a curve is there for those with a limit, or a threshold of the task's own
    varying.sort(key=lambda spread: (spread.name not in limits, not spread.cumulative[0]))
    if not varying:
        return None
    spread = varying[0]
    names = body_names(inputs)
    label = with_name(label_in_words(task, spread.name), names)
    axis = Axis(label, kinds[spread.name])
    panels = [_density(spread, axis, made.coverage, limits.get(spread.name, []))]
    if any(math.isfinite(end) for ends in spread.tornado for end in ends):
        panels.append(_tornado(made, spread, axis, inputs, names))
    return Picture(tuple(panels), f"{task.path}: distribution of {axis.title}", distributions=len(panels))


def spreads_of(
    task: "Task",
    bound: "Fields",
    inputs: "dict[str, Any]",
    made: "Propagation",
    limits: "Mapping[str, list[float]]",
    distributions: "Mapping[str, Distribution]",
) -> Spreads:
    """How uncertain the results are, and the inputs by themselves, for a task's own picture."""
    varying = {name: spread for name, spread in made.spreads.items() if spread.varies}
    names = body_names(inputs)
    shares = {}
    for name, spread in varying.items():
        each = zip(made.inputs, spread.total or spread.first, strict=False)
        shares[name] = tuple(
            sorted(((input_in_words(one, inputs, names), share) for one, share in each), key=lambda pair: -pair[1])
        )
    deviations = {name: one.std for name, one in distributions.items()}
    deviations |= {name: spread.std for name, spread in varying.items()}
    rows = list(made.spreads)
    correlations = {}
    if made.correlation is not None:
        table = made.correlation.tolist()
        correlations = {
            (one, other): table[i][j] for i, one in enumerate(rows) for j, other in enumerate(rows) if i != j
        }
    return Spreads(
        made.coverage,
        {name: spread.interval for name, spread in varying.items()},
        {name: deviation for name, deviation in deviations.items() if math.isfinite(deviation)},
        shares,
        correlations,
        limits,
        lambda: (arguments(task, bound, values)[1] for values in _fair(made)),
    )


def _fair(made: "Propagation") -> "Iterator[dict[str, float]]":
    """The inputs at fair cases, spread evenly."""
    few = quantile(lattice(min(len(made.inputs), MOST_DIMENSIONS), FAIR_CASES, 1, made.seed))
    drawn = made.space.inputs(np.resize(few, (len(made.inputs), FAIR_CASES)))
    for row in range(FAIR_CASES):
        yield {name: float(values[row] if np.ndim(values) else values) for name, values in drawn.items()}


def _density(spread: "Spread", axis: Axis, coverage: float, limits: "list[float]") -> Panel:
    values, chances = spread.cumulative
    middles = [0.5 * (a + b) for a, b in itertools.pairwise(values)]
    heights = np.maximum(0.0, np.diff(chances)).tolist()
    if spread.cases and math.isfinite(spread.std):
        # counted cases scatter: Silverman's width of a normal kernel
        heights = _smooth(heights, 0.9 * spread.std * spread.cases**-0.2 / (values[1] - values[0]))
    # Relative to the highest, so that the vertical axis needs no unit.
    top = max(heights, default=1.0) or 1.0
    items: list[Any] = [
        Band(*spread.interval, f"{100.0 * coverage:.6g} % interval"),
        Curve(middles, [height / top for height in heights], "density", role=0),
        Curve(values, chances, "probability of less", "dashed", role=6),
    ]
    items += [Band(limit, limit, "limit") for limit in limits]
    return Panel(axis, Axis("relative density, probability"), tuple(items))


def _smooth(heights: "list[float]", width: float) -> "list[float]":
    """Heights at even steps with a normal kernel of `width` steps."""
    reach = min(int(4.0 * width), len(heights) // 2)
    if reach < 1:
        return heights
    kernel = np.exp(-0.5 * (np.arange(-reach, reach + 1) / width) ** 2)
    smooth = np.convolve(heights, kernel, mode="same") / np.convolve(np.ones(len(heights)), kernel, mode="same")
    return [float(height) for height in smooth]


def _tornado(
    made: "Propagation", spread: "Spread", axis: Axis, inputs: "dict[str, Any]", names: "dict[str, str]"
) -> Panel:
    rows = []
    for name, (a, b), share in zip(made.inputs, spread.tornado, spread.total or spread.first, strict=True):
        if math.isfinite(a) and math.isfinite(b):
            percent = 100.0 * min(share, 1.0)  # estimates of shares may lie above 1
            rows.append((abs(b - a), f"{input_in_words(name, inputs, names)} ({percent:.0f} %)", min(a, b), max(a, b)))
    rows.sort(key=lambda row: -row[0])
    rows = rows[:MOST_DRIVERS]
    bars = Bars(tuple(row[1] for row in rows), [row[2] for row in rows], [row[3] for row in rows])
    title = "each input alone (share of variance)"
    return Panel(axis, Axis(""), (bars, Band(spread.median, spread.median, "median")), title)
