"""One calculation as a section: inputs, formula with numbers, results, their drivers, assumptions, warnings."""

from dynamics_cli.core.documents import columns, is_table, number
from dynamics_cli.core.output.answer_words import body_names, message_in_words
from dynamics_cli.core.output.render import to_pretty_json
from dynamics_cli.report.blocks import Code, Formula, Heading, Items, Paragraph, Table
from dynamics_cli.report.calculation import SWEEP, leaves, limit_words, words
from dynamics_cli.report.formula import plain

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from dynamics_cli.report.blocks import Block, Image
    from dynamics_cli.report.calculation import Calculation

    Document = dict[str, Any]

# A longer table is shown by its first and last rows.
MOST_ROWS = 40
# Small letters across a page; those of a column beside its digits: sign, point, leading zero and gap.
PAGE, BESIDE_DIGITS = 155, 5
# A longer formula has its numbers on a second line.
LONGEST_FORMULA = 90
# More inputs than these are a table.
MOST_IN_A_SENTENCE = 6


def section(one: "Calculation", drawn: "Sequence[Image]" = ()) -> "list[Block]":
    """The section of a calculation.

    Where the recalculation failed, the file's content is shown as plain data.
    """
    blocks: list[Block] = [Heading(2, f"{one.section}. {one.title}")]
    if one.document is None:
        inputs_left_out = {key: node for key, node in one.source.document.items() if key != "inputs"}
        text = f"{_sentence(one.again.words)} From the file, not calculated here:"
        return [*blocks, Paragraph(text), Code(to_pretty_json(inputs_left_out).rstrip())]
    blocks += _given(one)
    for steps in one.formulas():
        blocks += _formula(steps)
    blocks += _where(one)
    blocks += _results(one)
    blocks += [*warnings_of(one.document), *drawn, Paragraph(basis(one), small=True)]
    return [*blocks, Paragraph(_sentence(one.again.words), small=one.again.same)]


def _sentence(text: str) -> str:
    return f"{text[:1].upper()}{text[1:]}."


def _given(case: "Calculation") -> "list[Block]":
    """The inputs: a few as a sentence, more as a table, those of bodies alike side by side."""
    inputs = case.given()
    blocks: list[Block] = []
    if len(inputs) <= MOST_IN_A_SENTENCE:
        text = "; ".join(f"{label} {value}" for label, value in inputs)
        blocks += [Paragraph(("", "Given: ", f"{text}."))] if inputs else []
    else:
        blocks += _given_table(case, inputs)
    assert case.document is not None
    for address, table in leaves(case.document["inputs"]):
        if is_table(table) and address.partition(".")[0] != SWEEP:
            blocks.append(_table(table, f"Given: {case.named(words(address))}", 17))
    correlations = case.document["numerics"].get("uncertainty", {}).get("correlations", {})
    pairs = [f"{' and '.join(pair.split(','))} {number(rho, 6)}" for pair, rho in correlations.items()]
    return [*blocks, *([Paragraph(f"Correlation of {'; '.join(pairs)}.")] if pairs else [])]


def _given_table(case: "Calculation", inputs: "list[tuple[str, str]]") -> "list[Block]":
    sides = [case.named("first"), case.named("second")]
    paired: dict[str, list[str]] = {}
    rest = []
    for label, value in inputs:
        side = next((nth for nth, side in enumerate(sides) if label.startswith(f"{side} ")), None)
        if side is None:
            rest.append((label, value))
        else:
            paired.setdefault(label[len(sides[side]) + 1 :], ["–", "–"])[side] = value
    blocks: list[Block] = []
    if paired:
        blocks.append(Table(["given", *sides], [[label, *pair] for label, pair in paired.items()], "Given"))
    if len(rest) <= MOST_IN_A_SENTENCE:
        text = "; ".join(f"{label} {value}" for label, value in rest)
        return [*blocks, *([Paragraph(("", "Other inputs: " if paired else "Given: ", f"{text}."))] if rest else [])]
    return [*blocks, Table(["given", "value"], [list(row) for row in rest], "Given")]


def _formula(steps: "list[str]") -> "list[Block]":
    """A clause of the formula on one line, or on two where it is long."""
    equation = " = ".join(steps)
    if len(plain(equation)) <= LONGEST_FORMULA or len(steps) == 1:
        return [Formula(equation)]
    return [Formula(steps[0]), Formula(f"= {' = '.join(steps[1:])}")]


def _where(case: "Calculation") -> "list[Block]":
    """The meaning of the symbols."""
    symbols = (case.document or {}).get("explanation", {}).get("symbols", ())
    return [Paragraph(f"where {'; '.join(symbols)}.", small=True)] if symbols else []


def _results(case: "Calculation") -> "list[Block]":
    """The headline results with interval, limit and drivers; then the reason why a value lies outside its interval."""
    labels = case.labels()
    rows = [(label, case.value(address), address) for address, label in labels.items()]
    coverage = next((value.coverage for _, value, _ in rows if value.coverage), "")
    limited = any(case.limits(address) for address in labels)
    head = ["result", "value", *([f"{coverage} interval"] if coverage else []), *(["limit"] if limited else [])]
    head += ["decided by"] if coverage else []
    body = []
    for label, value, address in rows:
        row = [label, value.whole, *([value.interval or case.chance(address)] if coverage else [])]
        row += ["; ".join(map(limit_words, case.limits(address)))] if limited else []
        body.append([*row, *([case.drivers(address)] if coverage else [])])
    right = [1, 2] if coverage else [1]
    assert case.document is not None
    blocks: list[Block] = [Table(head, body, f"Results of section {case.section}", right)] if body else []
    blocks += [
        Paragraph(f"{_sentence(label + ': ' + value.outside)}", small=True) for label, value, _ in rows if value.outside
    ]
    if not body:
        for name, table in case.results.items():
            if is_table(table):
                blocks.append(_table(table, _sentence(name.replace("_", " ")).rstrip("."), case.digits))
    return blocks


def _table(node: "Any", caption: str, digits: int, *, small: bool = False) -> Table:
    """A table of a document, its middle left out where it is long."""
    table_columns = columns(node)
    rows = [
        [number(cell, digits) for cell in row] for row in zip(*(values for _, _, values in table_columns), strict=True)
    ]
    if len(rows) > MOST_ROWS:
        half = MOST_ROWS // 2
        caption += f"; {len(rows)} rows, of which the first and the last {half} are shown"
        rows = [*rows[:half], ["…"] * len(table_columns), *rows[-half:]]
    heads = [
        f"{label.replace('_', ' ')} [{unit}]" if unit else label.replace("_", " ") for label, unit, _ in table_columns
    ]
    right = [
        nth for nth, (_, _, values) in enumerate(table_columns) if not any(isinstance(value, str) for value in values)
    ]
    return Table(heads, rows, caption, right, small)


def table(node: "Any", caption: str) -> Table:
    """A table of a document for an appendix, with as many digits as its columns leave room for."""
    digits = max(4, min(12, PAGE // len(columns(node)) - BESIDE_DIGITS))
    return _table(node, caption, digits, small=True)


def warnings_of(document: "Document") -> "list[Items]":
    """Warnings with their remedies, worst first."""
    lines = []
    inputs = document["inputs"]
    names = body_names(inputs)
    for item in sorted(document["warnings"], key=lambda item: item["severity"] == "note"):
        remedy = f" Remedy: {item['remedy']}." if item.get("remedy") else ""
        message = message_in_words(item["message"], inputs, names).rstrip(".")
        lines.append(("", f"{item['severity'].capitalize()}: ", f"{message}.{remedy}"))
    return [Items(lines)] if lines else []


def basis(case: "Calculation") -> str:
    """Assumptions, source and checks."""
    document = case.document
    assert document is not None
    model = document["model"]
    why = f" ({model['why']})" if model.get("why") else ""
    parts = [f"Assumes: {'; '.join(model['assumptions'])}."] if model.get("assumptions") else []
    parts.append(f"Model: {model['name']}{why}. Source: {model['source']}.")
    failed = [check["name"] for check in document["checks"] if not check["passed"]]
    if failed:
        parts.append(f"Failed checks: {', '.join(failed)}.")
    elif document["checks"]:
        parts.append(f"Checks passed: {', '.join(dict.fromkeys(check['name'] for check in document['checks']))}.")
    return " ".join(parts)
