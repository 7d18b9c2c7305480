"""One result document as the blocks of a report's section."""

from dynamics_cli.core.render import (
    bound_text,
    check_line,
    columns,
    flatten,
    is_table,
    number,
    quantity,
    to_pretty_json,
)
from dynamics_cli.report.blocks import Block, Code, Heading, Items, Paragraph, Table

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Document = dict[str, Any]

ALL_DIGITS = 17
# A longer table is shown by its first and last rows.
MOST_ROWS = 40
# Below this an input's share of a variance is not worth a word.
LEAST_SHARE = 5e-4
SWEEP = "sweep"


def section(nth: int, name: str, document: "Document", summary: str, digits: int) -> "list[Block]":
    """What a document says: results, inputs, how they came about, what drives them, checks and warnings."""
    blocks: list[Block] = [Heading(2, f"{nth}. {name}: dynamics {document['command']}")]
    if summary:
        blocks.append(Paragraph(summary))
    blocks += _results(document, digits)
    blocks += _inputs(document)
    blocks += _reasons(document)
    blocks += _drivers(document, digits)
    return blocks + _diagnostics(document)


def _results(document: "Document", digits: int) -> "list[Block]":
    results = document["results"]
    bounds = document["numerics"].get("error_bound", {})
    spread = _spreads(results)
    head = ["result", "value", *(["interval", "standard deviation"] if spread else []), "rounding error at most"]
    rows = []
    for name, value, unit in flatten(results):
        row = [name, quantity(value, unit, digits)]
        if spread:
            row += _interval(spread.get(name), unit, digits)
        rows.append([*row, bound_text(bounds[name]) if name in bounds else ""])
    blocks: list[Block] = [Heading(3, "Results")]
    if rows:
        blocks.append(Table(head, rows, f"Results of dynamics {document['command']}"))
    blocks += _tables(results, digits)
    limits = [item["message"] for item in document.get("limits", ())]
    return blocks + ([Items(limits)] if limits else [])


def _spreads(node: "Any", address: str = "") -> "dict[str, Document]":
    made: dict[str, Document] = {}
    if isinstance(node, dict):
        if "interval" in node:
            return {address: node}
        for key, item in node.items():
            made |= _spreads(item, f"{address}.{key}" if address else key)
    return made


def _interval(node: "Document | None", unit: str, digits: int) -> "list[str]":
    if node is None:
        return ["", ""]
    low, high = (number(end, digits) for end in node["interval"])
    chance = f"{100.0 * node['coverage']:.6g} %"
    deviation = quantity(node["std"], unit, 3) if node["std"] is not None else ""
    return [f"{low} to {high} {unit}".rstrip() + f" ({chance})", deviation]


def _tables(node: "Document", digits: int) -> "list[Block]":
    blocks: list[Block] = []
    for name, table in node.items():
        if not is_table(table):
            continue
        made = columns(table)
        rows = [[number(cell, digits) for cell in row] for row in zip(*(values for _, _, values in made), strict=True)]
        words = name.replace("_", " ")
        if len(rows) > MOST_ROWS:
            half = MOST_ROWS // 2
            words += f"; {len(rows)} rows, of which the first and the last {half} are shown"
            rows = [*rows[:half], ["…"] * len(made), *rows[-half:]]
        heads = [f"{label} [{unit}]" if unit else label for label, unit, _ in made]
        blocks.append(Table(heads, rows, f"{words[:1].upper()}{words[1:]}"))
    return blocks


def _inputs(document: "Document") -> "list[Block]":
    inputs = document["inputs"]
    given = {name: value for name, value in inputs.items() if name != SWEEP}
    rows = [[name, quantity(value, unit, ALL_DIGITS)] for name, value, unit in flatten(given)]
    rows += [_swept(axis) for axis in inputs.get(SWEEP, ())]
    blocks: list[Block] = [Heading(3, "Inputs")]
    if rows:
        blocks.append(Table(["input", "value"], rows, "Inputs as given; ± is a standard uncertainty, .. a range"))
    blocks += _tables(given, ALL_DIGITS)
    told = document["numerics"].get("uncertainty", {}).get("correlations", {})
    if told:
        pairs = [f"{' and '.join(pair.split(','))}: {number(rho, 6)}" for pair, rho in told.items()]
        blocks.append(Items([f"correlation of {pair}" for pair in pairs]))
    return blocks


def _swept(axis: "Document") -> "list[str]":
    """A swept parameter as a row of inputs."""
    ends = [quantity(axis[end]["value"], axis[end].get("unit", ""), ALL_DIGITS) for end in ("from", "to")]
    return [axis["parameter"], f"{ends[0]} to {ends[1]}, {axis['count']} values"]


def _reasons(document: "Document") -> "list[Block]":
    model = document["model"]
    explained = document.get("explanation", {})
    lines = [f"model: {model['name']}" + (f" ({model['why']})" if model.get("why") else "")]
    lines += [f"assumption: {text}" for text in model.get("assumptions", ())]
    lines += [f"source: {model['source']}", f"method: {document['numerics'].get('method', '')}"]
    lines += _propagation(document["numerics"].get("uncertainty", {}))
    blocks: list[Block] = [Heading(3, "How it was calculated"), Items(lines)]
    formula = [explained[key] for key in ("formula", "with_numbers") if explained.get(key)]
    if formula:
        where = "; ".join(explained.get("symbols", ()))
        blocks.append(Code("\n".join([*formula, *([f"where {where}"] if where else [])])))
    return blocks


def _propagation(told: "Document") -> "list[str]":
    """By which methods the uncertainty went through, and how far they trust themselves."""
    methods: dict[str, list[str]] = {}
    worst: dict[str, float] = {}
    for name, entry in told.get("results", {}).items():
        method = entry["method"].partition(",")[0]
        methods.setdefault(method, []).append(name)
        worst[method] = max(worst.get(method, 0.0), entry.get("estimate") or 0.0)
    lines = [
        f"uncertainty: {method}, its error estimated at {number(worst[method], 2)} standard deviations or less, for "
        + ", ".join(names)
        for method, names in methods.items()
    ]
    if "evaluations" in told:
        lines.append(f"uncertainty: {told['evaluations']} evaluations of the formulas, seed {told.get('seed', 1)}")
    return lines


def _drivers(document: "Document", digits: int) -> "list[Block]":
    """One table of what drives each result; for the results in question also what each input does alone."""
    told = document.get("sensitivity", {})
    if not told:
        return []
    rows = []
    for name, entry in told.items():
        worst = entry.get("worst_case")
        ends = f"{_span(worst, entry, digits)}" if worst else ""
        rows.append([name, ", ".join(f"{one['input']} {_share(one)}" for one in _counting(entry)), ends])
    head = ["result", "share of its variance", "every input at its worst (no interval)"]
    blocks: list[Block] = [Heading(3, "What drives the results"), Table(head, rows, "What drives each result")]
    limited = [item["result"] for item in document.get("limits", ())]
    for name in limited or [next(iter(told))]:
        if name in told:
            entry = told[name]
            alone = [[one["input"], _share(one), _span(one["alone"], entry, digits)] for one in _counting(entry)]
            words = f"Each input of {name} alone over its interval, the others at their nominal values"
            blocks.append(Table(["input", "share of the variance", f"{name} then"], alone, words))
    return blocks


def _counting(entry: "Document") -> "list[Document]":
    """The inputs that matter, greatest first."""
    return [one for one in entry["inputs"] if one.get("total", one["share"]) >= LEAST_SHARE]


def _share(one: "Document") -> str:
    return f"{100.0 * (one['total'] if 'total' in one else one['share']):.1f} %"


def _span(ends: "Any", entry: "Document", digits: int) -> str:
    low, high = (number(end, digits) for end in ends)
    return f"{low} to {high} {entry.get('unit', '')}".rstrip()


def _diagnostics(document: "Document") -> "list[Block]":
    lines = [f"check: {check_line(check)}" for check in document["checks"]]
    for item in document["warnings"]:
        mend = f" ({item['mend']})" if item.get("mend") else ""
        lines.append(f"{item['severity']}: {item['message']}{mend}")
    return [Heading(3, "Checks and warnings"), Items(lines)] if lines else []


def embedded(documents: "list[Document]") -> "list[Block]":
    """The inputs as data: what `--input` takes to calculate everything again."""
    blocks: list[Block] = [Heading(2, "Inputs as data")]
    words = (
        "Each block is what --input reads: saved in a file, it calculates its section again (a sweep's ranges are "
        "given with --sweep instead)."
    )
    blocks.append(Paragraph(words))
    for nth, document in enumerate(documents, 1):
        blocks += [
            Paragraph(f"{nth}. dynamics {document['command']}, version {document['version']}:"),
            Code(to_pretty_json(document["inputs"]).rstrip()),
        ]
    return blocks
