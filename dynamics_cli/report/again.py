"""A document calculated again from the inputs it holds, and whether it gives the same results."""

from dynamics_cli.core.call import Settings
from dynamics_cli.core.execute import answered_case
from dynamics_cli.core.gather import Gathered
from dynamics_cli.core.loading import parse_json
from dynamics_cli.core.reading import Reader
from dynamics_cli.core.render import flatten, is_table, number, to_json
from dynamics_cli.errors import DynamicsError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.core.task import Task
    from dynamics_cli.core.terminal import Terminal
    from dynamics_cli.pictures import Picture

    Document = dict[str, Any]


class Again:
    """What came of it: the new document and its picture, or why there is none, and what differs."""

    def __init__(self, words: str, document: "Document | None" = None, picture: "Picture | None" = None) -> None:
        self.words = words
        self.document = document
        self.picture = picture


def calculate(task: "Task", document: "Document", folder: str, terminal: "Terminal") -> Again:
    """Calculate a document's task again from its inputs."""
    if "sweep" in document["inputs"]:
        return Again("a sweep, shown as it was written")
    raw = parse_json(to_json(document["inputs"]), "inputs")
    asked = _settings(task, document)
    try:
        settings = Settings(asked, {})
        made, _, picture = answered_case(task, Gathered(raw, Reader(terminal.environ, folder=folder)), settings)
    except DynamicsError as error:
        return Again(f"not calculated again: {'; '.join(one.message for one in error.all())}")
    return Again(_compared(document, made), made, picture)


def _settings(task: "Task", document: "Document") -> "dict[str, Any]":
    """The options of the call that its document shows."""
    to = [f"{name}={unit}" for name, _, unit in flatten(document["results"]) if unit and "[" not in name]
    for name, table in document["results"].items():
        if is_table(table) and isinstance(table, list):
            units = {f"{name}.{key}": cell.get("unit") for key, cell in table[0].items() if isinstance(cell, dict)}
            to += [f"{address}={unit}" for address, unit in units.items() if unit]
    asked: dict[str, Any] = {"explain": True, "to": to}
    if document["model"].get("why") == "asked for":
        asked["model"] = next(model.key for model in task.models if model.name == document["model"]["name"])
    told = document["numerics"].get("uncertainty", {})
    if task.plot or told:
        asked["plot"] = "-"
    if told:
        asked["seed"] = str(told.get("seed", 1))
        asked["correlate"] = [f"{pair}={rho!r}" for pair, rho in told.get("correlations", {}).items()]
        coverage = [node["coverage"] for node in document["results"].values() if "coverage" in node]
        asked |= {"coverage": repr(coverage[0])} if coverage else {}
    limits = document.get("limits", ())
    if limits:
        asked["limit"] = [f"{item['result']}={_written(item['limit'])}" for item in limits]
    return asked


def _written(node: "Document") -> str:
    return f"{node['value']!r} {node.get('unit', '')}".rstrip()


def _compared(before: "Document", after: "Document") -> str:
    """In words: which results came out otherwise."""
    old = {name: (value, unit) for name, value, unit in flatten(before["results"])}
    new = {name: (value, unit) for name, value, unit in flatten(after["results"])}
    apart = [name for name, entry in old.items() if new.get(name) != entry]
    version = f"version {after['version']}"
    if not apart:
        return f"calculated again from these inputs by {version}: every result is the same to the last digit"
    told = [f"{name} was {_number(old, name)}, now {_number(new, name)}" for name in apart]
    return f"calculated again by {version}, these differ: {'; '.join(told)}"


def _number(results: "dict[str, tuple[Any, str]]", name: str) -> str:
    return number(results[name][0], 17) if name in results else "missing"
