"""The appendices: complete numbers with error bounds, how to reproduce them, the files, and how to read the report."""

import os

from dynamics_cli.core.documents import bound_text, check_line, flatten, is_table, number, quantity
from dynamics_cli.core.output.render import to_pretty_json
from dynamics_cli.core.output.uncertainty import spreads
from dynamics_cli.report.blocks import Code, Heading, Items, Paragraph, Table
from dynamics_cli.report.calculation import Calculation
from dynamics_cli.report.recalculation import read_files
from dynamics_cli.report.sections import table

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from dynamics_cli.report.blocks import Block

    Document = dict[str, Any]

ALL_DIGITS = 17
READING = (
    "a ± b: an input with the standard uncertainty b, normally distributed; a..b: anywhere between, equally likely.",
    "Interval: the middle part of a result's distribution, with the probability that it stands for. A result's value "
    "is the one at the nominal inputs and need not be the middle of its interval.",
    "An input that is a result of an earlier section is shown as in that section. The calculation takes its whole "
    "distribution, with the mean as nominal value; both are in appendix B.",
    "Share of the variance: the part of a result's uncertainty due to an input, alone or together with others.",
    "All inputs at their limits: the range over the corners, where every input is at an end of its interval; a result "
    "with an extreme between them may go beyond it.",
    "Maximum rounding error: the error of the arithmetic itself, for the inputs as written. It does not include errors "
    "of measurement.",
    "Calculated again: this program repeated each calculation from its inputs while it wrote the report.",
)


def appendices(calculations: "Sequence[Calculation]") -> "list[Block]":
    """All of them."""
    return [*_numbers(calculations), *_reproduction(calculations), *_files(calculations)]


def _numbers(calculations: "Sequence[Calculation]") -> "list[Block]":
    blocks: list[Block] = [Heading(2, "Appendix A: Complete numbers and error bounds")]
    for case in calculations:
        if case.document is None:
            continue
        blocks += _complete(case)
        for name, node in case.results.items():
            if is_table(node):
                blocks.append(table(node, f"Section {case.section}, {name.replace('_', ' ')}"))
        lines = [check_line(check) for check in case.document["checks"]]
        lines += _propagation(case.document["numerics"].get("uncertainty", {}))
        method = case.document["numerics"].get("method", "")
        blocks.append(Paragraph(f"Section {case.section}: method {method}. {'; '.join(lines)}", small=True))
    return blocks


def _complete(case: Calculation) -> "list[Block]":
    """Every result with all digits, its interval and deviation, the worst case, and its error bound."""
    document = case.document
    assert document is not None
    bounds = document["numerics"].get("error_bound", {})
    spread = dict(spreads(case.results))
    sensitivities = document.get("sensitivity", {})
    head = [
        "result",
        "value",
        "unit",
        *(["interval", "std. deviation", "all inputs at their limits"] if spread else []),
    ]
    rows = []
    notes = []
    for name, value, unit in flatten(case.results):
        if value == "":
            continue
        if isinstance(value, str) or value is None:
            notes.append(f"{name}: {value if value is not None else 'none'}")
            continue
        row = [name, number(value, ALL_DIGITS), unit]
        if spread:
            row += _spread(spread.get(name), sensitivities.get(name, {}))
        rows.append([*row, bound_text(bounds[name]) if name in bounds else ""])
    caption = f"Section {case.section}, {case.name}: dynamics {document['command']}, complete"
    head = [*head, "maximum rounding error"]
    blocks: list[Block] = [Table(head, rows, caption, small=True)] if rows else []
    return [*blocks, *([Paragraph(f"Section {case.section}: {'; '.join(notes)}.", small=True)] if notes else [])]


def _spread(node: "Document | None", shares: "Document") -> "list[str]":
    if node is None:
        return ["", "", ""]
    unit = str(node.get("unit"))
    if ";" in unit:
        low, high, std = (quantity(part, unit, 6) for part in (*node["interval"], node["std"]))
        return [f"{low} to {high}", std, ""]
    low, high = (number(end, 8) for end in node["interval"])
    worst = " to ".join(number(end, 6) for end in shares["worst_case"]) if "worst_case" in shares else ""
    return [f"{low} to {high}", number(node["std"], 3), worst]


def _propagation(uncertainty: "Document") -> "list[str]":
    """By which methods the uncertainty went through, and how far they trust themselves."""
    methods: dict[str, float] = {}
    for entry in uncertainty.get("results", {}).values():
        method = entry["method"].partition(",")[0]
        methods[method] = max(methods.get(method, 0.0), entry.get("estimate") or 0.0)
    lines = [
        f"uncertainty: {method}, its error estimated at {number(error, 2)} standard deviations or less"
        for method, error in methods.items()
    ]
    if "evaluations" in uncertainty:
        lines.append(f"{uncertainty['evaluations']} evaluations of the formulas, seed {uncertainty.get('seed', 1)}")
    return lines


def _reproduction(calculations: "Sequence[Calculation]") -> "list[Block]":
    """The inputs as data: what `--input` takes to calculate everything again."""
    text = (
        "To repeat a section, save its block in a file and run the command above it, which reads the file with --input "
        "(ranges of a sweep are given with --sweep). dynamics report also repeats every calculation."
    )
    blocks: list[Block] = [Heading(2, "Appendix B: How to reproduce"), Paragraph(text)]
    for case in calculations:
        document = case.source.document
        version = document.get("version")
        command = f"dynamics {document['command']} --input FILE{_options(case.document or {})}"
        blocks.append(Paragraph(f"Section {case.section}, version {version}: {command}"))
        blocks.append(Code(to_pretty_json(document["inputs"]).rstrip()))
    return [*blocks, Heading(2, "Appendix C: How to read this report"), Items(READING)]


def _options(document: "Document") -> str:
    """The options that the call had beside its inputs."""
    model = document.get("model", {})
    limits = [
        f' --limit "{entry["result"]}={number(entry["limit"]["value"], 17)} {entry["limit"].get("unit", "")}'.rstrip()
        + '"'
        for entry in document.get("limits", ())
    ]
    model_option = f' --model "{model["name"]}"' if model.get("why") == "asked for" else ""
    seed = document.get("numerics", {}).get("uncertainty", {}).get("seed", 1)
    return model_option + "".join(limits) + (f" --seed {seed}" if seed != 1 else "")


def _files(calculations: "Sequence[Calculation]") -> "list[Block]":
    """Every file behind the report with its SHA-256, and the section that read it."""
    digests = {case.source.digest: case.section for case in calculations}
    rows: dict[tuple[str, str], list[str]] = {}
    for case in calculations:
        name = "standard input" if case.source.file == "-" else os.path.basename(case.source.file)
        rows.setdefault((name, case.source.digest), []).append(f"document of section {case.section}")
    for case in calculations:
        read = read_files(case.document or {})
        listed = read_files(case.source.document)
        for name, digest in [*read, *(file for file in listed if file[0] not in dict(read))]:
            origin = digests.get(digest)
            source = "" if origin or (name, digest) in read else ", as its document says"
            rows.setdefault((os.path.basename(name), digest), []).append(f"read by section {case.section}{source}")
        for name, digest in read_files(case.source.document, written=True):
            use = f"written by section {case.section}, as its document says"
            rows.setdefault((os.path.basename(name), digest), []).append(use)
    rows_written = [[name, "; ".join(dict.fromkeys(uses)), digest] for (name, digest), uses in rows.items()]
    caption = "Files used for this report"
    return [Heading(2, "Appendix D: Files"), Table(["file", "use", "SHA-256"], rows_written, caption, small=True)]
