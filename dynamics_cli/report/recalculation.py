"""A document calculated again from the inputs it holds, and whether it gives the same results."""

import re

from dynamics_cli.core.answering.gather import Gathered
from dynamics_cli.core.answering.models import arguments
from dynamics_cli.core.answering.task import load
from dynamics_cli.core.command.execute import answered_case
from dynamics_cli.core.documents import number
from dynamics_cli.core.inputs.reader import Reader
from dynamics_cli.core.inputs.settings import Settings
from dynamics_cli.core.inputs.sources.files import parse_json
from dynamics_cli.core.json_text import to_json
from dynamics_cli.errors import DynamicsError, UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Any

    from dynamics_cli.core.answering.task import Task
    from dynamics_cli.core.terminal import Terminal
    from dynamics_cli.pictures import Picture, Sheet

    Document = dict[str, Any]
    # Numbers and words by their address.
    Leaves = dict[str, Any]


# So many differences are listed; the rest is counted.
MOST_TOLD = 12
# An uncertain figure is known no worse than this, in standard deviations, or it does not count as the same.
ROUGHEST = 0.1
# Units that indicate US customary input.
US = {"in", "ft", "mi", "mph", "lb", "lbf", "slug", "psi", "hp"}
# Entries about the call itself, entries compared separately, and the inputs of the recalculation.
NOT_COMPARED = ("schema", "command", "version", "inputs", "results", "timing", "files")
# The amount of work depends on the other options of the call.
WORK = "numerics.uncertainty.evaluations"


class Again:
    """Outcome of a recalculation: new document and picture, or the reason for a failure, and whether both agree.

    The results in a file are claims; only the recalculated document is shown as calculated.
    """

    def __init__(
        self,
        words: str,
        document: "Document | None" = None,
        picture: "Picture | None" = None,
        *,
        short: str = "",
        sheet: "Sheet | None" = None,
    ) -> None:
        self.words = words
        self.document = document
        self.picture = picture
        self.sheet = sheet
        # In a few words.
        self.short = short or ("the same" if document is not None else "not repeated")

    @property
    def same(self) -> bool:
        """Whether everything came out as the file says."""
        return self.short == "the same"


def calculate(task: "Task", document: "Document", folder: str, terminal: "Terminal") -> Again:
    """Calculate a document's task again from its inputs."""
    try:
        if "sweep" in document["inputs"]:
            answer, picture = _sweep(task, document, _gathered(document, folder, terminal))
        else:
            options = _settings(task, document)
            answer, _, picture = answered_case(task, _gathered(document, folder, terminal), Settings(options, {}))
            units = _units(answer["results"])
            to = [f"{name}={unit}" for name, unit in _units(document["results"]).items() if units.get(name) != unit]
            if to:
                settings = Settings({**options, "to": to}, {})
                answer, _, picture = answered_case(task, _gathered(document, folder, terminal), settings)
    except DynamicsError as error:
        return Again(f"not calculated again: {'; '.join(refusal.message for refusal in error.all())}")
    words, short = _compared(document, answer)
    return Again(words, answer, picture, short=short, sheet=_sheet(task, document, folder, terminal))


def _sheet(task: "Task", document: "Document", folder: str, terminal: "Terminal") -> "Sheet | None":
    """The data sheet of a task that has one; not for an uncertain case or a sweep, which have no single drawing."""
    if not task.sheet or "sweep" in document["inputs"]:
        return None
    gathered = _gathered(document, folder, terminal)
    gathered.reader.uncertain = {}
    bound = gathered.reader.read(task.specification.fields, gathered.raw)
    if gathered.reader.uncertain:
        return None
    words, options = arguments(task, bound)
    data_sheet: Sheet = load(task.sheet)(task.models[0].call()(*words, **options), *words, **options)
    return data_sheet


def system_of(document: "Document") -> str:
    """The units of a document's pictures: us where a result of it is in feet, pounds or their like."""
    units = " ".join(_units(document["results"]).values())
    return "us" if not US.isdisjoint(re.findall("[a-z]+", units.lower())) else "si"


def _gathered(document: "Document", folder: str, terminal: "Terminal") -> Gathered:
    """The inputs of a document, to be read anew."""
    raw = parse_json(to_json(document["inputs"]), "inputs")
    raw.pop("sweep", None)
    return Gathered(raw, Reader(terminal.environ, folder=folder))


def _sweep(task: "Task", document: "Document", gathered: Gathered) -> "tuple[Document, Picture | None]":
    """A sweep calculated again, and its picture."""
    from dynamics_cli.core.batch.sweep import sweep
    from dynamics_cli.core.batch.sweep_pictures import of_sweep

    swept = document["inputs"]["sweep"]
    table = _part(document, "results", "sweep")
    try:
        axes = [axis["parameter"] for axis in swept]
        points = [f"{axis['parameter']}={_points(axis)}" for axis in swept]
    except (LookupError, TypeError):
        raise UsageError("its sweep cannot be read") from None
    options: dict[str, Any] = {
        "sweep": points,
        "to": [
            f"{name}={cell['unit']}"
            for name, cell in table.items()
            if isinstance(cell, dict) and name not in axes and cell.get("unit") and name.rpartition(".")[0] not in table
        ],
    }
    options |= {**_model(task, document), **_limits(document)}
    uncertainty = _part(document, "numerics", "uncertainty")
    if uncertainty:
        options |= {"seed": str(uncertainty.get("seed", 1)), "coverage": repr(uncertainty.get("coverage"))}
    answer, _ = sweep(task, gathered, Settings(options, {}))
    return answer, of_sweep(answer, task)


def _points(axis: "Document") -> str:
    """The points of a sweep as they were given."""
    if "values" not in axis:
        return f"{_written(axis['from'])}:{_written(axis['to'])}:{axis['count']}"
    unit = f" {axis['unit']}" if axis.get("unit") else ""
    return ", ".join(f"{value}{unit}" for value in axis["values"])


def _part(node: "Any", *keys: str) -> "Document":
    """The value in nested objects under these keys; empty where one is missing."""
    for key in keys:
        node = node.get(key) if isinstance(node, dict) else None
    return node if isinstance(node, dict) else {}


def _model(task: "Task", document: "Document") -> "dict[str, str]":
    """The option that chose the model, where one did."""
    chosen = _part(document, "model")
    if chosen.get("why") != "asked for":
        return {}
    key = next((model.key for model in task.models if model.name == chosen.get("name")), None)
    if key is None:
        raise UsageError(f"{task.path} has no model {chosen.get('name')!r}")
    return {"model": key}


def _settings(task: "Task", document: "Document") -> "dict[str, Any]":
    """The options of the call that its document shows."""
    options: dict[str, Any] = {"explain": True, **_model(task, document)}
    uncertainty = _part(document, "numerics", "uncertainty")
    if task.plot or uncertainty:
        options["plot"] = "-"
    if uncertainty:
        options |= {"seed": str(uncertainty.get("seed", 1)), **_method(uncertainty)}
        options["correlate"] = [f"{pair}={rho!r}" for pair, rho in _part(uncertainty, "correlations").items()]
        coverage = _coverage(document["results"])
        options |= {"coverage": repr(coverage)} if coverage is not None else {}
    return {**options, **_limits(document)}


def _limits(document: "Document") -> "dict[str, list[str]]":
    """The option that its limits were given by."""
    try:
        limits = [f"{item['result']}={_written(item['limit'])}" for item in document.get("limits") or ()]
    except (LookupError, TypeError):
        raise UsageError("its limits cannot be read") from None
    return {"limit": limits} if limits else {}


def _method(uncertainty: "Document") -> "dict[str, str]":
    """The method that was asked for: linear and Monte Carlo are those of all results, or of none."""
    methods = {str(_part(entry).get("method")) for entry in _part(uncertainty, "results").values()}
    linear = methods and all(method.startswith("linear, at the means") for method in methods)
    return {"method": "linear"} if linear else {}


def _units(node: "Any", address: str = "") -> "dict[str, str]":
    """The unit of every result that has one, of columns and rows as well."""
    units: dict[str, str] = {}
    if isinstance(node, list):
        for item in node:
            units |= _units(item, address)
    elif isinstance(node, dict):
        if isinstance(node.get("unit"), str) and node["unit"] and "value" in node:
            units[address] = node["unit"]
        for key, item in node.items():
            units |= _units(item, f"{address}.{key}" if address else key)
    return units


def _coverage(node: "Any") -> "Any":
    """The chance that stands behind the intervals, from the first that there is."""
    if isinstance(node, dict) and "interval" in node:
        return node.get("coverage")
    items = node.values() if isinstance(node, dict) else node if isinstance(node, list) else ()
    return next((chance for chance in map(_coverage, items) if chance is not None), None)


def _written(node: "Document") -> str:
    return f"{node['value']!r} {node.get('unit', '')}".rstrip()


def _compared(before: "Document", after: "Document") -> "tuple[str, str]":
    """The differences from the file, as sentences and in short."""
    old, new = dict(_leaves(before["results"])), dict(_leaves(after["results"]))
    apart = _apart(old, new)
    sampled = [name for name in apart if _within(name, before, after, old, new)]
    apart = [name for name in apart if name not in sampled]
    version = f"version {after['version']}"
    words = f"calculated again from these inputs by {version}: every result is the same to the last digit"
    short = "the same"
    if apart:
        words, short = f"calculated again by {version}, these differ: {_told(apart, old, new)}", "not the same"
    elif sampled:
        words += f", but for sampled figures that agree within the accuracy stated: {'; '.join(sampled)}"
    claimed, figures = _claims(before), _claims(after)
    if "explanation" not in before:
        figures = {name: node for name, node in figures.items() if not name.startswith("explanation")}
    hashes = {file["name"]: file["sha256"] for file in after.get("files", ())}
    for name, digest in read_files(before):
        if name in hashes:
            claimed[f"SHA-256 of {name}"], figures[f"SHA-256 of {name}"] = digest, hashes[name]
    differing = _apart(claimed, figures)
    if differing:
        words += f". Other differences from the file: {_told(differing, claimed, figures)}"
        short = "not the same" if apart else "results the same, claims differ"
    return words, short


def _claims(document: "Document") -> "Leaves":
    """The entries of a document other than its results."""
    statements = {key: node for key, node in document.items() if key not in NOT_COMPARED}
    return {name: node for name, node in _leaves(statements) if name != WORK}


def read_files(document: "Document", *, written: bool = False) -> "list[tuple[str, str]]":
    """The files that a document says were read (or written) for it: name and hash."""
    listed = document.get("files")
    return [
        (str(file.get("name")), str(file.get("sha256")))
        for file in (listed if isinstance(listed, list) else ())
        if isinstance(file, dict) and bool(file.get("written")) is written
    ]


def _apart(old: "Leaves", new: "Leaves") -> "list[str]":
    """The names of entries that differ or are in one document only."""
    missing = object()
    return [name for name in {**old, **new} if old.get(name, missing) != new.get(name, missing)]


def _told(names: "list[str]", old: "Leaves", new: "Leaves") -> str:
    differences = [f"{name} was {_shown(old, name)}, now {_shown(new, name)}" for name in names[:MOST_TOLD]]
    rest = len(names) - len(differences)
    return "; ".join(differences) + (f"; and {rest} more" if rest else "")


def _within(name: str, before: "Document", after: "Document", old: "Leaves", new: "Leaves") -> bool:
    """Whether a figure of a distribution changed by at most the stated errors of the old and the new method."""
    result, _, _ = name.rpartition(", ")
    scale = new.get(f"{result}, std")
    estimates = [
        _part(document, "numerics", "uncertainty", "results", result).get("estimate") for document in (before, after)
    ]
    figures = [old.get(name), new.get(name), scale, *estimates]
    numbers = [float(figure) for figure in figures if isinstance(figure, int | float)]
    if not result or len(numbers) < len(figures):
        return False
    was, now, deviation, *bounds = numbers
    return abs(was - now) <= 2.0 * min(ROUGHEST, max(bounds)) * deviation


def _leaves(node: "Any", address: str = "") -> "Iterator[tuple[str, Any]]":
    """Every number and word below a node, with its address."""
    if isinstance(node, dict):
        for key, item in node.items():
            inner = f"{address}, {key}" if "value" in node else f"{address}.{key}" if address else key
            yield from _leaves(item, address if key == "value" else inner)
    elif isinstance(node, list):
        for nth, item in enumerate(node):
            yield from _leaves(item, f"{address}[{nth}]")
    else:
        yield address, node


def _shown(leaves: "Leaves", name: str) -> str:
    return number(leaves[name], 17) if name in leaves else "missing"
