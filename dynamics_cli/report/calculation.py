"""One calculation of a report: its recalculated document, the labels of its results, and its inputs."""

import re

from dynamics_cli.core.answering.explain import formulas_with_numbers
from dynamics_cli.core.documents import decimals, flatten, is_quantity, is_table, number, quantity
from dynamics_cli.core.output.answer_words import (
    ESTIMATE_DIGITS,
    body_names,
    headline_labels,
    is_in_parts,
    parts_in_words,
    percent,
)
from dynamics_cli.core.output.uncertainty import spreads
from dynamics_cli.core.units.display import pretty
from dynamics_cli.records import record
from dynamics_cli.report.recalculation import read_files

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence
    from typing import Any

    from dynamics_cli.core.answering.task import Task
    from dynamics_cli.report.recalculation import Again

    Document = dict[str, Any]

# Below this an input's share of a variance is not worth a word.
LEAST_SHARE = 0.01
MOST_DRIVERS = 4
STANDARD_GRAVITY = {"value": 9.80665, "unit": "m/s²"}
SWEEP = "sweep"
# Significant digits of certain results: in tables unless asked for, and in sentences. Sizes and angles keep the former.
DEFAULT_DIGITS, SENTENCE_DIGITS = 6, 4
FINE_UNITS = ("mm", "in", "µm", "deg", "rad")


@record
class Source:
    """A document with the name of its file, the file's hash, and the name of its section."""

    file: str
    document: "Document"
    digest: str
    name: str


@record
class Value:
    """A number as the report shows it: rounded to two digits of its standard deviation, its interval likewise."""

    text: str
    unit: str
    low: str = ""
    high: str = ""
    coverage: str = ""
    outside: str = ""
    """What is to be said of a value outside its interval."""

    @property
    def whole(self) -> str:
        """The value with its unit."""
        return f"{self.text} {self.unit}".rstrip()

    @property
    def interval(self) -> str:
        """The interval without its unit."""
        return f"{self.low} to {self.high}" if self.low else ""


class Calculation:
    """A section of the report."""

    def __init__(
        self, section: int, source: Source, again: "Again", task: "Task | None", before: "Sequence[Calculation]"
    ) -> None:
        self.section = section
        self.source = source
        self.again = again
        self.task = task
        self.document: Document | None = again.document
        self.before = before
        self.digits = 6
        words = source.name.lstrip("0123456789_-. ").replace("_", " ") or source.name
        self.name = words[:1].upper() + words[1:]
        command = source.document["command"]
        self.about = task.summary.rstrip(".").partition(":")[0] if task else command
        self.title = f"{self.name}: {_lowered(task.summary) if task else command}"

    @property
    def results(self) -> "Document":
        """The results calculated here; none where nothing was."""
        return self.document["results"] if self.document is not None else {}

    @property
    def past(self) -> bool:
        """Whether it is a reconstruction of a past event."""
        return self.source.document["command"].partition(" ")[0] in ("skid", "impact")

    def labels(self) -> "dict[str, str]":
        """The headline results present, with their labels, and results with limits."""
        if self.document is None or self.task is None:
            return {}
        flat = {name: (value, unit) for name, value, unit in flatten(self.results)}
        tables = [name for name, node in self.results.items() if is_table(node)]
        labels_shown = headline_labels(self.task, flat, tables)
        for entry in self.document.get("limits", ()):
            labels_shown.setdefault(entry["result"], entry["result"].replace("_", " ").replace(".", " "))
        return {address: self.named(label) for address, label in labels_shown.items() if address in flat}

    def named(self, label: str) -> str:
        """A label with the name that the scene gives its body, or one of its surfaces."""
        for side, name in body_names(self.source.document["inputs"]).items():
            if label == (side := words(side)) or label.startswith(f"{side} "):
                return f"{name}{label[len(side) :]}"
        return label

    def value(self, address: str, *, brief: bool = False) -> Value:
        """A result as the report shows it, `brief` in a sentence; one that repeats an input is shown like the input."""
        node = node_at(self.results, address)
        for _, input_node in leaves(self.document["inputs"]) if self.document and is_quantity(node) else ():
            if _repeats(node, input_node):
                origin = self.origin(input_node)
                if origin is not None:
                    return origin[0].value(origin[1])
        rough = self.task is not None and address in self.task.unspread
        digits = self.digits
        if brief and digits == DEFAULT_DIGITS and node_unit(node) not in FINE_UNITS:
            digits = SENTENCE_DIGITS
        return shown(node, ESTIMATE_DIGITS if rough else digits)

    def limits(self, address: str) -> "list[Document]":
        """The statement about a result's limits."""
        return [entry for entry in (self.document or {}).get("limits", ()) if entry["result"] == address]

    def chance(self, address: str) -> str:
        """The probability of a yes or no as it is; none where nothing spreads it."""
        entry = (self.document or {}).get("chances", {}).get(address)
        if not entry:
            return ""
        yes = entry["probability"]
        return f"with a probability of {percent(yes if node_at(self.results, address) else 1.0 - yes)}"

    def drivers(self, address: str) -> str:
        """The inputs that decide a result, with their shares of its variance."""
        entry = (self.document or {}).get("sensitivity", {}).get(address)
        if not entry:
            return ""
        counted = [(row["input"], row.get("total", row["share"])) for row in entry["inputs"]]
        if counted[0][1] > 1.0 - LEAST_SHARE:
            return self.named(words(counted[0][0]))
        main = [item for item in counted if item[1] >= LEAST_SHARE][:MOST_DRIVERS]
        return ", ".join(f"{self.named(words(name))} {percent(share)}" for name, share in main)

    def given(self) -> "list[tuple[str, str]]":
        """Label and value of every input outside tables; a value from an earlier section refers to it."""
        entries = []
        for address, node in leaves(self.document["inputs"] if self.document else {}):
            if address.partition(".")[0] == SWEEP or address.endswith(".name") or is_table(node):
                continue
            entries.append((self.named(words(address)), self.input_text(address, node)))
        for axis in (self.document or {}).get("inputs", {}).get(SWEEP, ()):
            if "values" in axis:
                listed = ", ".join(number(value, 17) for value in axis["values"])
                entries.append((words(axis["parameter"]), f"{listed} {axis.get('unit', '')}".rstrip()))
                continue
            ends = [quantity(axis[end]["value"], axis[end].get("unit", ""), 17) for end in ("from", "to")]
            entries.append((words(axis["parameter"]), f"{ends[0]} to {ends[1]}, {axis['count']} values"))
        return entries

    def input_text(self, address: str, node: "Any") -> str:
        """An input as given, or as an earlier section found it."""
        if isinstance(node, dict) and node.get("distribution") == "result":
            origin = self.origin(node)
            if origin is not None:
                value = origin[0].value(origin[1])
                return f"{value.whole} ({value.coverage}: {value.interval}), from section {origin[0].section}"
        text = "; ".join(quantity(value, pretty(unit), 17) for _, value, unit in flatten(node))
        return f"{text} (standard)" if address == "gravity" and node == STANDARD_GRAVITY else text

    def origin(self, node: "Document") -> "tuple[Calculation, str] | None":
        """The earlier section and its result that an input was read from."""
        read = {
            digest for document in (self.document or {}, self.source.document) for _, digest in read_files(document)
        }
        for other in self.before:
            if other.source.digest not in read or other.document is None:
                continue
            for address, spread in spreads(other.results):
                if spread["interval"] == [node["low"], node["high"]] and spread.get("unit") == node.get("unit"):
                    return other, address
        return None

    def formulas(self) -> "list[list[str]]":
        """The clauses of the formula as steps: symbols, numbers, the result; as `formula.parse` reads them."""
        from dynamics_cli.report.formula import quantity as piece

        if self.document is None or self.task is None:
            return []
        numbers: dict[str, str] = {}
        for side in ("results", "inputs"):
            for address, node in leaves(self.document[side]):
                text = self._number(node)
                if text is not None:
                    numbers[address] = numbers[f"{side}.{address}"] = piece(*text)
            for name, table in self.document[side].items():
                rows = table if is_table(table) and isinstance(table, list) else ()
                for key, node in rows[0].items() if len(rows) == 1 else ():
                    text = self._number(node)
                    if text is not None:
                        numbers[f"{name}.{key}"] = numbers[f"{side}.{key}"] = piece(*text)
                        numbers.setdefault(key, piece(*text))
        return formulas_with_numbers(self.task, self.document, numbers, piece)

    def _number(self, node: "Any") -> "tuple[str, str] | None":
        """A lone number as a formula shows it: text and unit."""
        if not is_quantity(node) or isinstance(node["value"], bool | list | str) or node["value"] is None:
            return None
        origin = self.origin(node) if node.get("distribution") == "result" else None
        if origin is not None:
            value = origin[0].value(origin[1])
            return value.text, value.unit
        value = shown(node, self.digits)
        return value.text, value.unit


def node_unit(node: "Any") -> str:
    """The unit of a node of a document; empty where it has none."""
    return str(node.get("unit", "")) if isinstance(node, dict) else ""


def shown(node: "Any", digits: int) -> Value:
    """A node of a document as the report shows it."""
    if not is_quantity(node):
        return Value(number(node, digits), "")
    value, unit, deviation = node["value"], node.get("unit", ""), node.get("std")
    if "interval" in node and is_in_parts(node):
        text, low, high = (parts_in_words(part, node, digits) for part in (value, *node["interval"]))
        return Value(text, "", low, high, f"{100.0 * node['coverage']:.6g} %")
    if "interval" not in node or isinstance(value, list | str):
        compound = ";" in unit and isinstance(value, list)
        return Value(quantity(value, unit, digits), "") if compound else Value(number(value, digits), unit)
    if not deviation:
        low, high = (number(end, digits) for end in node["interval"])
        text, mean = number(value, digits), number(node["mean"], digits)
    else:
        low, high = (decimals(end, deviation) for end in node["interval"])
        text, mean = decimals(value, deviation), decimals(node["mean"], deviation)
    coverage = f"{100.0 * node['coverage']:.6g} %"
    return Value(text, unit, low, high, coverage, _outside(value, node["interval"], mean, unit))


def _lowered(summary: str) -> str:
    """A task's line of help as the end of a heading."""
    text = summary.rstrip(".").partition(":")[0]
    return text if text[1:2].isupper() else text[:1].lower() + text[1:]


def _repeats(result: "Document", entered: "Any") -> bool:
    """Whether a result is an input that was taken from an earlier section."""
    return (
        isinstance(entered, dict)
        and entered.get("distribution") == "result"
        and "interval" in result
        and all(entered.get(key) == result.get(key) for key in ("value", "unit"))
    )


def _outside(value: float, interval: "Sequence[float]", mean: str, unit: str) -> str:
    if interval[0] <= value <= interval[1]:
        return ""
    side, change = ("below", "increases") if value < interval[0] else ("above", "decreases")
    return (
        f"the value is the one at the nominal inputs and lies {side} the interval: almost every deviation of the "
        f"inputs {change} it (mean {mean} {unit}".rstrip()
        + ")"
    )


def limit_words(entry: "Document") -> str:
    """A limit as the end of a sentence."""
    limit = quantity(entry["limit"]["value"], entry["limit"].get("unit", ""), 6)
    if "probability" in entry:
        chance = entry["probability"]
        if chance > 0.999:
            return f"above the limit of {limit}: practically certain, {percent(chance)}"
        if chance < 0.001:
            return f"within the limit of {limit}: practically certain, {percent(1.0 - chance)}"
        if chance < 0.5:
            return f"within the limit of {limit}; it was exceeded with a probability of {percent(chance)}"
        return f"above the limit of {limit} with a probability of {percent(chance)}"
    if entry.get("undecided"):
        return f"at the limit of {limit}: the difference is less than the error bound"
    by = quantity(entry["by"]["value"], entry["by"].get("unit", ""), 4)
    if not entry["by"]["value"]:
        return f"at the limit of {limit}"
    return f"above the limit of {limit} by {by}" if entry["beyond"] else f"within the limit of {limit} by {by}"


def words(address: str) -> str:
    """An address as words: `segments[0].distance` as "segment 1 distance"."""
    address = re.sub(r"(\w+?)s?\[(\d+)\]", lambda match: f"{match[1]} {int(match[2]) + 1}", address)
    return address.replace("_", " ").replace(".", " ")


def node_at(results: "Any", address: str) -> "Any":
    """The node of a result, `parts[2].mass` among them."""
    node = results
    for step in address.replace("[", ".").replace("]", "").split("."):
        if is_quantity(node) and isinstance(node["value"], list) and step.isdigit():
            node = {"value": node["value"][int(step)], "unit": node.get("unit", "")}
        elif isinstance(node, list) and step.isdigit():
            node = node[int(step)]
        else:
            node = node.get(step) if isinstance(node, dict) else None
    return node


def leaves(node: "Any", address: str = "") -> "Iterator[tuple[str, Any]]":
    """Every quantity, word or table below a node."""
    if isinstance(node, dict) and not is_quantity(node) and not ("magnitude" in node or (is_table(node) and address)):
        for key, item in node.items():
            yield from leaves(item, f"{address}.{key}" if address else key)
    else:
        yield address, node
