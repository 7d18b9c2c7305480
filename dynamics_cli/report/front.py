"""What stands before and after the sections: the case, what was found, how to read it, the files it rests on."""

import os

from dynamics_cli.core.render import flatten, is_table, number, quantity
from dynamics_cli.records import record
from dynamics_cli.report.blocks import Block, Heading, Items, Paragraph, Table

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from dynamics_cli.report.again import Again

    Document = dict[str, Any]

READING = (
    "a ± b: an input with the standard uncertainty b, normally distributed; a..b: anywhere between, all alike",
    "interval: the middle part of a result's distribution, with the chance that stands behind it; a result's value is "
    "that at the nominal inputs and need not be the middle of it",
    "a (b to c) as an input: a result of an earlier section, taken at the mean of its distribution, which the "
    "curvature of a formula sets a little apart from the value at the nominal inputs",
    "rounding error at most: what the arithmetic itself may have added, for the inputs as written; it says nothing of "
    "how well they were measured",
    "share of the variance: how much of a result's uncertainty an input brings, together with others",
    "calculated again: this program repeated each calculation from the inputs shown here while it wrote the report",
)


@record
class Source:
    """A document with the name of its file, the file's hash, and the name of its section."""

    file: str
    document: "Document"
    digest: str
    name: str


def named(read: "Sequence[tuple[str, Document, str]]") -> "list[Source]":
    """The documents with names for their sections: their files', numbered where a file holds several."""
    made = []
    for nth, (file, document, digest) in enumerate(read):
        stem = "standard input" if file == "-" else os.path.splitext(os.path.basename(file))[0]
        same = [other for other, (name, _, _) in enumerate(read) if name == file]
        made.append(Source(file, document, digest, stem if len(same) == 1 else f"{stem} {same.index(nth) + 1}"))
    return made


def front(title: str, case: str, author: str, sources: "Sequence[Source]", answers: "Sequence[Again]") -> "list[Block]":
    """Title, case, what each calculation found, and whether everything holds."""
    blocks: list[Block] = [Heading(1, title)]
    about = [f"{word}: {text}" for word, text in (("Case", case), ("Prepared by", author)) if text]
    if about:
        blocks.append(Items(about))
    blocks.append(Heading(2, "Summary"))
    rows = [
        [str(nth), one.name, f"dynamics {one.document['command']}", _found(one.document), _state(one.document, again)]
        for nth, (one, again) in enumerate(zip(sources, answers, strict=True), 1)
    ]
    head = ["section", "document", "calculation", "main result", "calculated again; checks"]
    blocks.append(Table(head, rows, "The calculations of this report"))
    return [*blocks, Paragraph(_verdict(sources, answers)), Heading(3, "How to read this report"), Items(READING)]


def _found(document: "Document") -> str:
    """The limited result, or the first one, with its interval."""
    results = document["results"]
    limits = document.get("limits", ())
    if limits:
        return "; ".join(item["message"] for item in limits)
    for name, value, unit in flatten(results):
        if isinstance(value, int | float) and not isinstance(value, bool):
            node: Any = results
            for step in name.split("."):
                node = node.get(step, {}) if isinstance(node, dict) else {}
            if "interval" not in node:
                return f"{name} {quantity(value, unit, 6)}"
            low, high = (number(end, 6) for end in node["interval"])
            return f"{name} {quantity(value, unit, 6)}, {100.0 * node['coverage']:.6g} % within {low} to {high}"
    return ", ".join(f"{name}: {_rows(table)} rows" for name, table in results.items() if is_table(table))


def _rows(table: "Any") -> int:
    return len(table) if isinstance(table, list) else len(next(iter(table.values()))["value"])


def _state(document: "Document", again: "Again") -> str:
    checks = document["checks"]
    passed = sum(bool(check["passed"]) for check in checks)
    cautions = sum(item["severity"] != "note" for item in document["warnings"])
    words = [again.short, *([f"{passed} of {len(checks)} checks passed"] if checks else [])]
    return ", ".join([*words, *([f"{cautions} warning{'s' * (cautions > 1)}"] if cautions else [])])


def _verdict(sources: "Sequence[Source]", answers: "Sequence[Again]") -> str:
    same = sum(again.same for again in answers)
    failed = sum(not check["passed"] for one in sources for check in one.document["checks"])
    calculations = f"{len(answers)} calculation{'s' * (len(answers) > 1)}"
    words = f"{same} of {calculations} came out the same when calculated again from these inputs"
    rest = [again.words for again in answers if not again.same]
    told = f"; the other: {'; '.join(rest)}" if rest else ""
    return f"{words}{told}. {failed or 'No'} check{'s' * (failed != 1)} of the program on its own results failed."


def files(sources: "Sequence[Source]", digests: "dict[str, int]") -> "list[Block]":
    """Every file that the report rests on with its SHA-256, and which section read it."""
    rows: dict[tuple[str, str], list[str]] = {}
    for nth, one in enumerate(sources, 1):
        name = "standard input" if one.file == "-" else os.path.basename(one.file)
        rows.setdefault((name, one.digest), []).append(f"document of section {nth}")
    for nth, one in enumerate(sources, 1):
        for file in one.document.get("files", ()):
            name = os.path.basename(file["name"])
            origin = digests.get(file["sha256"])
            use = "written by" if file.get("written") else "read by"
            from_here = f" (the document of section {origin})" if origin and not file.get("written") else ""
            rows.setdefault((name, file["sha256"]), []).append(f"{use} section {nth}{from_here}")
    listed = [[name, "; ".join(dict.fromkeys(uses)), digest] for (name, digest), uses in rows.items()]
    return [Heading(2, "Files"), Table(["file", "use", "SHA-256"], listed, "Files this report rests on")]
