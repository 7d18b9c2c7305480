"""A document calculated again from the inputs it holds, and whether it gives the same results."""

from dynamics_cli.core.call import Settings
from dynamics_cli.core.execute import answered_case
from dynamics_cli.core.gather import Gathered
from dynamics_cli.core.loading import parse_json
from dynamics_cli.core.reading import Reader
from dynamics_cli.core.render import columns, flatten, is_table, number, to_json
from dynamics_cli.errors import DynamicsError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.core.task import Task
    from dynamics_cli.core.terminal import Terminal
    from dynamics_cli.pictures import Picture

    Document = dict[str, Any]
    Leaves = dict[str, tuple[Any, str]]


class Again:
    """What came of it: the new document and its picture, or why there is none, and whether the results are the same."""

    def __init__(
        self, words: str, document: "Document | None" = None, picture: "Picture | None" = None, *, same: bool = False
    ) -> None:
        self.words = words
        self.document = document
        self.picture = picture
        self.same = same

    @property
    def short(self) -> str:
        """In three words at most."""
        return "the same" if self.same else "not the same" if self.document is not None else "not repeated"


def calculate(task: "Task", document: "Document", folder: str, terminal: "Terminal") -> Again:
    """Calculate a document's task again from its inputs."""
    raw = parse_json(to_json(document["inputs"]), "inputs")
    raw.pop("sweep", None)
    swept = document["inputs"].get("sweep")
    gathered = Gathered(raw, Reader(terminal.environ, folder=folder))
    try:
        if swept is not None:
            made, picture = _sweep(task, document, swept, gathered)
        else:
            asked = _settings(task, document)
            made, _, picture = answered_case(task, gathered, Settings(asked, {}))
            shown = _units(made["results"])
            to = [f"{name}={unit}" for name, unit in _units(document["results"]).items() if shown.get(name) != unit]
            if to:
                made, _, picture = answered_case(task, gathered, Settings({**asked, "to": to}, {}))
    except DynamicsError as error:
        return Again(f"not calculated again: {'; '.join(one.message for one in error.all())}")
    words, same = _compared(document, made)
    return Again(words, made, picture, same=same)


def _sweep(
    task: "Task", document: "Document", swept: "list[Document]", gathered: Gathered
) -> "tuple[Document, Picture | None]":
    """A sweep calculated again, and its picture."""
    from dynamics_cli.core.plot.made import of_sweep
    from dynamics_cli.core.sweep import sweep

    table = document["results"]["sweep"]
    axes = [axis["parameter"] for axis in swept]
    told = document["numerics"].get("uncertainty", {})
    asked: dict[str, Any] = {
        "sweep": [
            f"{axis['parameter']}={_written(axis['from'])}:{_written(axis['to'])}:{axis['count']}" for axis in swept
        ],
        "to": [
            f"{name}={cell['unit']}"
            for name, cell in table.items()
            if name not in axes and cell.get("unit") and name.rpartition(".")[0] not in table
        ],
    }
    if document["model"].get("why") == "asked for":
        asked["model"] = _asked_for(task, document)
    if told:
        asked |= {"seed": str(told["seed"]), "coverage": repr(told["coverage"])}
    made, _ = sweep(task, gathered, Settings(asked, {}))
    return made, of_sweep(made)


def _asked_for(task: "Task", document: "Document") -> str:
    return next(model.key for model in task.models if model.name == document["model"]["name"])


def _settings(task: "Task", document: "Document") -> "dict[str, Any]":
    """The options of the call that its document shows."""
    asked: dict[str, Any] = {"explain": True}
    if document["model"].get("why") == "asked for":
        asked["model"] = _asked_for(task, document)
    told = document["numerics"].get("uncertainty", {})
    if task.plot or told:
        asked["plot"] = "-"
    if told:
        asked["seed"] = str(told.get("seed", 1))
        asked["correlate"] = [f"{pair}={rho!r}" for pair, rho in told.get("correlations", {}).items()]
        coverage = _coverage(document["results"])
        asked |= {"coverage": repr(coverage)} if coverage is not None else {}
    limits = document.get("limits", ())
    if limits:
        asked["limit"] = [f"{item['result']}={_written(item['limit'])}" for item in limits]
    return asked


def _units(results: "Document") -> "dict[str, str]":
    """The unit of every result that has one, of those in tables as well."""
    made = {name: unit for name, _, unit in flatten(results) if unit and "[" not in name}
    for name, table in results.items():
        if is_table(table):
            cells = table[0] if isinstance(table, list) else table
            units = {key: cell.get("unit") for key, cell in cells.items() if isinstance(cell, dict)}
            made |= {f"{name}.{key}": unit for key, unit in units.items() if unit}
    return made


def _coverage(node: "Any") -> "float | None":
    """The chance that stands behind the intervals, from the first that there is."""
    if isinstance(node, dict) and "interval" in node:
        return float(node["coverage"])
    items = node.values() if isinstance(node, dict) else node if isinstance(node, list) else ()
    return next((found for found in map(_coverage, items) if found is not None), None)


def _written(node: "Document") -> str:
    return f"{node['value']!r} {node.get('unit', '')}".rstrip()


def _compared(before: "Document", after: "Document") -> "tuple[str, bool]":
    """In words: which results came out otherwise; and whether none did."""
    old, new = _leaves(before["results"]), _leaves(after["results"])
    apart = [name for name, entry in old.items() if new.get(name) != entry]
    sampled = [name for name in apart if _within(name, before, old, new)]
    apart = [name for name in apart if name not in sampled]
    version = f"version {after['version']}"
    if apart:
        told = [f"{name} was {_number(old, name)}, now {_number(new, name)}" for name in apart]
        return f"calculated again by {version}, these differ: {'; '.join(told)}", False
    words = f"calculated again from these inputs by {version}: every result is the same to the last digit"
    if sampled:
        words += f", but for sampled figures that agree within their own stated accuracy: {'; '.join(sampled)}"
    return words, True


def _within(name: str, document: "Document", old: "Leaves", new: "Leaves") -> bool:
    """Whether a figure of a distribution moved by no more than its method says it is good for."""
    result, _, figure = name.rpartition(", ")
    entry = document["numerics"].get("uncertainty", {}).get("results", {}).get(result, {})
    scale = old.get(f"{result}, std", (None, ""))[0]
    if not figure or not entry.get("estimate") or not isinstance(scale, float) or name not in new:
        return False
    one, other = (value if isinstance(value, list) else [value] for value in (old[name][0], new[name][0]))
    return all(abs(a - b) <= 2.0 * entry["estimate"] * scale for a, b in zip(one, other, strict=True))


def _leaves(results: "Document") -> "Leaves":
    """Every number of the results with its unit, those of tables and the ends of intervals as well."""
    made: Leaves = {name: (value, unit) for name, value, unit in flatten(results)}
    for name, table in results.items():
        if is_table(table):
            for label, unit, values in columns(table):
                made |= {f"{name}[{nth}].{label}": (value, unit) for nth, value in enumerate(values)}
        elif isinstance(table, dict):
            made |= _spreads(table, name)
    return made


def _spreads(node: "Document", address: str) -> "Leaves":
    """Standard deviations and intervals, which `flatten` leaves out."""
    if "interval" in node:
        ends = {f"{address}, {key}": (node[key], "") for key in ("mean", "median", "std") if key in node}
        return ends | {f"{address}, interval": (node["interval"], "")}
    made: Leaves = {}
    for key, item in node.items():
        if isinstance(item, dict):
            made |= _spreads(item, f"{address}.{key}")
    return made


def _number(results: "Leaves", name: str) -> str:
    return number(results[name][0], 17) if name in results else "missing"
