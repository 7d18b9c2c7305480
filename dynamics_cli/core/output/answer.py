"""The short answer for people: headline results first, then the inputs, the method, and where to find more.

A screen is 80 columns and 24 lines. Results not named in a task's headline appear with `--all`.
"""

from math import log10

from dynamics_cli.core.documents import (
    bound_text,
    flatten,
    given_inputs,
    is_table,
    quantity,
)
from dynamics_cli.core.output.answer_tables import file_lines, headline_tables
from dynamics_cli.core.output.answer_words import (
    asked_of,
    bears_on_results,
    body_names,
    designated,
    deviation,
    estimated,
    headline_labels,
    in_words,
    input_in_words,
    interval_in_words,
    is_in_parts,
    is_uncertain_vector,
    letters,
    listed,
    message_in_words,
    node_at,
    parts_in_words,
    short_source,
    suits_us_units,
    uncertain_in_words,
    value_in_words,
    with_name,
    without_rounding,
)
from dynamics_cli.core.output.wrapping import fitted, wrapped

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.core.answering.task import Task

    Document = dict[str, Any]

LINES = 24
# Minimum number of lines of a table.
LEAST_TABLE = 7
# Statements about what drives the results, and how many inputs each names: as many as the screen has room for.
MOST_DRIVEN = ((3, 5), (2, 3), (1, 3))
# A share of the variance below this is not mentioned.
LEAST_SHARE = 0.005
# A bound is mentioned when it leaves fewer digits than this.
WORTH_SAYING = 1e-9
# An error bound below this share of the standard deviation does not show.
NEGLIGIBLE = 0.02
SEVERITIES = ("serious", "caution", "note")
MARGIN = 6
AXES = 3
# A non-breaking space.
JOINED = "\u00a0"


def to_answer(
    document: "Document", task: "Task", digits: int, width: int, *, quiet: bool = False, asked: bool = False
) -> str:
    """The answer as lines no wider than `width`; `quiet` gives only the headline results.

    Requested digits (`asked`) apply to uncertain results too.
    """
    answer = _Answer(document, task, digits, width, asked=asked)
    head = answer.headline()
    if quiet:
        # a table that stands first in the headline is the answer
        leading = task.headline[0][0] if task.headline else ""
        table = answer.tables(LINES - len(head)) if not head or leading in answer.table_names else []
        return _text([*head, *table])
    # How a bare number was read is shown right beneath it.
    unlabelled = not any(answer.labels.values())
    rest = answer.beneath(len(head))
    space = LINES - len(head) - len(rest)
    lines_left = space - max(len(answer.warnings(0)), min(len(answer.warnings(LINES)), space // 2))
    if head and lines_left < LEAST_TABLE and answer.without_tables():
        rest = answer.beneath(len(head))
    body = answer.tables(max(lines_left, LEAST_TABLE))
    warnings = answer.warnings(LINES - len(head) - len(body) - len(rest))
    footer = [*warnings, *rest] if unlabelled else [*rest, *warnings]
    return _text([*head, *body, *footer, *answer.explanation()])


def _text(lines: "list[str]") -> str:
    return "\n".join(lines).lstrip("\n").replace(JOINED, " ") + "\n"


class _Answer:
    """One document as short lines."""

    def __init__(self, document: "Document", task: "Task", digits: int, width: int, *, asked: bool) -> None:
        self.document = document
        self.task = task
        self.digits = digits
        self.asked = asked
        self.width = width
        self.results = document["results"]
        self.flat = {name: (value, unit) for name, value, unit in flatten(self.results)}
        self.names = body_names(document["inputs"])
        self.table_names = [name for name, node in self.results.items() if is_table(node)]
        labels = headline_labels(task, self.flat, self.table_names)
        # of a body that is fixed nothing changes
        fixed = [body for body, given in document["inputs"].items() if isinstance(given, dict) and given.get("fixed")]
        self.labels = {
            address: with_name(label, self.names)
            for address, label in labels.items()
            if address.partition(".")[0] not in fixed
        }
        self.bounds = document["numerics"].get("error_bound", {})
        self.letters = letters(task)

    def headline(self) -> "list[str]":
        """A line for each headline result: label, value with unit, interval or limit."""
        rows = [
            (label, designated(self._text(address), self.letters.get(address)), self._remarks(address))
            for address, label in self.labels.items()
            if address in self.flat
        ]
        label_width = max((len(label) for label, _, _ in rows), default=0)
        middle = max((len(text) for _, text, remarks in rows if remarks), default=0)
        lines = []
        for label, text, remarks in rows:
            head = f"{label:<{label_width}}  " if label_width else ""
            lines += fitted(f"{head}{text:<{middle if remarks else 0}}", remarks, self.width, len(head))
        return lines

    def _text(self, address: str) -> str:
        """A result with its unit, in significant digits."""
        value, unit = self.flat[address]
        node = node_at(self.results, address)
        if isinstance(node, dict) and "interval" in node and is_in_parts(node):
            return parts_in_words(value, node, self.digits, asked=self.asked)
        if is_uncertain_vector(node) or (self._deviation(address) and not isinstance(value, list)):
            text = uncertain_in_words(node["value"], node, self._deviation(address), self.digits, asked=self.asked)
            return f"{text} {unit}".rstrip()
        lost = isinstance(value, float) and abs(value) <= self._absolute_bound(address, value)
        value = 0.0 if lost else without_rounding(value)
        if value in ([], ""):
            return "none"
        rough = address in self.task.unspread and not self.asked
        text = estimated(value, unit) if rough else quantity(value, unit, self.digits)
        if isinstance(value, list) and isinstance(value[0], list) and len(value[0]) <= AXES:
            # a matrix breaks between its rows
            return text.replace(" ", JOINED).replace(f"],{JOINED}[", "], [")
        return text

    def _absolute_bound(self, address: str, value: float) -> float:
        entry = self.bounds.get(address) or {}
        bound: float = entry.get("absolute", abs(value) * entry.get("relative", 0.0))
        return bound

    def _remarks(self, address: str) -> "list[str]":
        """The interval of an uncertain result, and its limits."""
        remarks = []
        node = node_at(self.results, address)
        if isinstance(node, dict) and "interval" in node:
            std = self._deviation(address)
            remarks.append(interval_in_words(self.document, address, std, self.digits, asked=self.asked))
        return remarks + asked_of(self.document, address)

    def _deviation(self, address: str) -> float:
        """The standard deviation that digits follow; none where they were asked for."""
        return 0.0 if self.asked else deviation(self.results, address)

    def without_tables(self) -> bool:
        """Drop the tables; returns whether there were any."""
        tables = [address for address in self.labels if address in self.table_names]
        for address in tables:
            del self.labels[address]
        return bool(tables)

    def tables(self, space: int) -> "list[str]":
        """Headline tables, without middle rows where they do not fit."""
        size = {"digits": self.digits, "width": self.width, "space": space}
        labels = {name: label for name, label in self.labels.items() if name in self.table_names and self.results[name]}
        lines = headline_tables(self.document, self.task, labels, self.bounds, **size)
        saved = [file for file in self.document.get("files", ()) if file.get("written")]
        return lines + ([""] if saved else []) + [line for file in saved for line in file_lines(file, self.width)]

    def accuracy(self) -> "list[str]":
        """Results accurate to few digits, and limits that lie within an error bound."""
        labels: dict[int, list[str]] = {}
        for address, label in self.labels.items():
            value = self.flat.get(address, (None, ""))[0]
            if isinstance(value, float) and value and address in self.bounds and address not in self.task.unspread:
                relative = self._absolute_bound(address, value) / abs(value)
                if self._worth_saying(address, value) < relative < 1.0:
                    labels.setdefault(max(int(-log10(relative)), 0), []).append(label)
        lines = [f"{', '.join(alike)}: accurate to {sure_digits} digits" for sure_digits, alike in labels.items()]
        return ["", *(line for text in lines for line in wrapped(text, self.width, 4))] if lines else []

    def _worth_saying(self, address: str, value: float) -> float:
        """The relative error bound from which a line is due: one that hides in the deviation is not worth it."""
        return max(WORTH_SAYING, NEGLIGIBLE * self._deviation(address) / abs(value))

    def beneath(self, above: int) -> "list[str]":
        """The lines beneath the results, which take `above` lines: drivers only as far as the screen has room."""
        accuracy, provenance = self.accuracy(), self.provenance()
        for most in MOST_DRIVEN:
            lines = [*accuracy, *self.drivers(*most), *provenance]
            if above + len(lines) <= LINES:
                break
        return lines

    def drivers(self, statements: int, inputs: int) -> "list[str]":
        """Which inputs drive the headline results, in one line for results with the same drivers."""
        grouped: dict[str, list[str]] = {}
        for address, entry in self.document.get("sensitivity", {}).items():
            rows = [(row["input"], row.get("total", row["share"])) for row in entry["inputs"]]
            if address in self.labels and len(rows) > 1 and rows[0][1] < 1.0 - LEAST_SHARE:
                parts = [
                    f"{self._input(name)} {100.0 * share:.0f}{JOINED}%" for name, share in rows if share > LEAST_SHARE
                ]
                more = [f"{len(parts) - inputs}{JOINED}more"] if len(parts) > inputs else []
                statement = ", ".join([*parts[:inputs], *more])
                grouped.setdefault(statement, []).append(self.labels[address])
        lines: list[str] = []
        for statement, labels in list(grouped.items())[:statements]:
            verb = "is" if len(labels) == 1 else "are"
            lines += wrapped(f"{', '.join(labels)} {verb} driven by  {statement}", self.width, 4)
        return ["", *lines] if lines else []

    def provenance(self) -> "list[str]":
        """The inputs of the answer, its method, and further results available."""
        blocks = [("for", self._inputs()), ("by", self._method()), ("more", self._more())]
        lines = [""]
        for word, text in blocks:
            if text:
                first, *more_lines = wrapped(text, self.width - MARGIN, 0)
                lines += [f"{word:<{MARGIN}}{first}", *(" " * MARGIN + line for line in more_lines)]
        if "timing" in self.document:
            lines.append(f"{'took':<{MARGIN}}{self.document['timing']['value'] * 1e6:.0f} µs")
        return lines

    def _input(self, address: str) -> str:
        return input_in_words(address, self.document["inputs"], self.names)

    def _inputs(self) -> str:
        entries = []
        inputs = self.document["inputs"]
        for name, value, unit in listed(given_inputs(inputs)):
            standard = " (standard)" if name == "gravity" and value == 9.80665 and unit == "m/s²" else ""
            if standard and not bears_on_results(name, self.document):
                continue
            value_text = designated(value_in_words(value, unit), self.letters.get(name))
            unbroken = value_text.replace(" ", JOINED) if len(value_text) < self.width // 3 else value_text
            if not name:
                value_text = self._counted(value_text)
            if name.removesuffix(".name") not in self.names:
                entries.append(f"{self._input(name)} {unbroken}{standard}" if name else value_text)
        entries += [f"{in_words(axis['parameter'])} as listed" for axis in inputs.get("sweep", ())]
        text = ", ".join(entries)
        space = 4 * (self.width - MARGIN)
        if len(text) <= space:
            return text
        entries_shown: list[str] = []
        for entry in entries:
            if len(", ".join([*entries_shown, entry])) > space - 30:
                break
            entries_shown.append(entry)
        more = len(entries) - len(entries_shown)
        return ", ".join([*entries_shown, f"and {more} more input{'s' if more > 1 else ''}"])

    def _counted(self, value_text: str) -> str:
        """How many records there are, `2 first after`, by the name of their body."""
        count, _, noun = value_text.partition(" ")
        named = with_name(noun, self.names)
        return value_text if named == noun else f"{named}: {count}"

    def _method(self) -> str:
        model = self.document["model"]
        source = short_source(model["source"])
        # a model named after its source is not named twice
        named = "" if source.startswith(model["name"] + ",") else model["name"]
        parts = [named + (f" ({model['why']})" if model.get("why") else ""), source]
        checks = self.document["checks"]
        failed = [check["name"] for check in checks if not check["passed"]]
        verdict = "; checks passed" if checks and not failed else ""
        return (
            ", ".join(part.strip() for part in parts if part)
            + verdict
            + "".join(f"; check FAILED: {name}" for name in failed)
        )

    def _more(self) -> str:
        hidden = [name for name in self.flat if name not in self.labels]
        tables = [in_words(name) for name in self.table_names if name not in self.labels]
        hidden_words = ([f"{len(hidden)} more results"] if len(hidden) > 1 else list(map(in_words, hidden))) + tables
        if "explanation" in self.document:
            return f"--all ({', '.join(hidden_words)})" if hidden_words else ""
        more = f"--all ({', '.join(hidden_words)}), " if hidden_words else ""
        explained = "formula, sensitivity, error bounds" if self.task.tracked else "formula, assumptions"
        in_us = f", --units{JOINED}us" if suits_us_units(self.document) else ""
        return f"{more}--explain ({explained}){in_us}"

    def explanation(self) -> "list[str]":
        """The formula with its numbers, assumptions and sensitivities, with `--explain`."""
        if "explanation" not in self.document:
            return []
        from dynamics_cli.core.output.sensitivity import sensitivity_lines

        lines = [""]
        for name, content in self.document["explanation"].items():
            if isinstance(content, dict):
                changes = {result: entry for result, entry in content.items() if result in self.labels} or content
                lines += sensitivity_lines(changes, lambda name: self.labels.get(name, name), self._input, self.width)
            elif isinstance(content, list):
                lines.append(in_words(name))
                lines += [f"  {line}" for item in content for line in wrapped(item, self.width - 2, 2)]
            elif name not in ("model", "source", "why"):
                lines += wrapped(f"{in_words(name)}  {content}", self.width, 4)
        said: dict[str, list[str]] = {}
        for name, entry in self.bounds.items():
            if self.labels.get(name):
                said.setdefault(bound_text(entry), []).append(self.labels[name])
        each = (f"{bound}: {', '.join(names)}" for bound, names in said.items())
        bounds = [f"  {line}" for text in each for line in wrapped(text, self.width - 2, 2)]
        return lines + (["accurate to (rounding of the calculation alone)", *bounds] if bounds else [])

    def warnings(self, space: int) -> "list[str]":
        """A paragraph for each warning, worst first; those that do not fit into `space` lines are only counted."""
        lines: list[str] = []
        limits = [{**item, "code": "limit"} for item in self.document.get("limits", ()) if "by" not in item]
        every = [{"severity": "note", **item} for item in (*self.document["warnings"], *limits)]
        in_order = sorted(every, key=lambda item: SEVERITIES.index(item["severity"]))
        for nth, item in enumerate(in_order):
            remedy = item.get("remedy")
            message = message_in_words(item["message"], self.document["inputs"], self.names)
            text = f"{item['severity']}: {message}" + (f". Remedy: {remedy}" if remedy else "")
            joined = nth and item["code"] == in_order[nth - 1]["code"] == "reading"
            paragraph = [*([] if joined else [""]), *wrapped(text, self.width, 2)]
            if nth and len(lines) + len(paragraph) + (2 if in_order[nth + 1 :] else 0) > space:
                counts = [(sum(each["severity"] == name for each in in_order[nth:]), name) for name in SEVERITIES]
                named = ", ".join(f"{count} {name}" for count, name in counts if count)
                more = len(in_order) - nth
                return [*lines, "", f"{more} more warning{'s' * (more > 1)} ({named}): --all"]
            lines += paragraph
        return lines
