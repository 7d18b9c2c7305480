"""The ranges for people: one line each where there are many, with the sources where there are few."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

FEW = 7
WIDTH = 80


def lines(results: "dict[str, Any]", digits: int, width: int) -> "list[str]":
    """The range first, then its subject; the source below where it fits a screen."""
    rows = results["values"]
    del digits
    width = min(max(width or WIDTH, 60), 120)
    ranges = [_range(row) for row in rows]
    first = max(map(len, ranges)) + 2
    out: list[str] = []
    topic = ""
    for row, text in zip(rows, ranges, strict=True):
        if row["topic"] != topic:
            topic = row["topic"]
            out += ["", topic]
        words = ", ".join(part for part in (row["what"], row["surface"], row["condition"]) if part)
        details = [words, row["source"]] if len(rows) <= FEW else [words]
        head = f"  {text:<{first}}"
        for entry in details:
            for line in _folded(entry, width - len(head)):
                out.append((head + line).rstrip())
                head = " " * len(head)
    if len(rows) > FEW:
        out += ["", "sources: fewer rows (a topic, or words), --json, or --output FILE.csv"]
    return out


def _range(row: "dict[str, Any]") -> str:
    """The ends as text: one number, two, or an upper end."""
    least, greatest = (_number(row.get(name)) for name in ("least", "greatest"))
    unit = f" {row['unit']}" if row["unit"] else ""
    if least == greatest:
        return greatest + unit
    return (f"{least} to {greatest}" if least else f"to {greatest}") + unit


def _number(entry: "Any") -> str:
    number = entry["value"] if isinstance(entry, dict) else entry
    return "" if number is None else f"{number:g}"


def _folded(text: str, width: int) -> "list[str]":
    """Words on lines of a width; the library's way costs more than the rest of the call."""
    out = [""]
    for word in text.split():
        if out[-1] and len(out[-1]) + 1 + len(word) > width:
            out.append("")
        out[-1] = f"{out[-1]} {word}".strip()
    return out
