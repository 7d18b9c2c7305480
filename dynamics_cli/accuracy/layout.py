"""The report for people: what the program's own methods achieve, then the alternatives question by question."""

from dynamics_cli.accuracy import listing
from dynamics_cli.accuracy.rows import CHOSEN, ESTIMATE
from dynamics_cli.core.documents import quantity

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    Entry = dict[str, Any]

# Where standard output is no terminal the width is always the same, so that the bytes are.
WIDTH = 80
LEAST_WIDTH, LARGEST_WIDTH = 80, 140
LEAST_NAME = 24
# Worse than this, a result's true value is shown beside it.
FEW_DIGITS = 1e-10
VANISHING = (
    "errors are shares of each result: a large one is that of a result that all but vanishes, as a difference that "
    "cancels does; its stated bound says so"
)
MEASURES = "¹: errors in the measure that the question's block below names"
# What columns, by their first words, and marks mean; said of those that are there.
LEGEND = {
    "ratio": "ratio: time of the formula alone over that of the program's own method (▸) in the same cases; ours also "
    "gives results that have no reference, and checks its answer",
    "gives": "gives: the share of our own method's results that this one gives",
    "arrays": "arrays: time for each case of one call on arrays",
    "worst": "worst, median: errors, as shares of the reference unless said otherwise",
    "truly": "truly: the true value, in SI units, where few digits are right: a small error is a large share of a "
    "result that all but vanishes, as a difference that cancels does",
    "in": "in ulp: in units of a double's last place",
    "ours": "ours: the worst error of our own method over the very results that this one gave",
    "bound": "held ×n: the stated bound was never below the true error, and n times it in the median (~: an estimate)",
    "cases": "a/b: of b cases b − a were not answered",
    "*": "*: no other method is as quick and as exact",
}


class Column:
    """One column of figures: its title, its text for a row, and how gladly it is given up where there is no room."""

    def __init__(self, title: str, text: "Callable[[Entry], str]", order: int = 0) -> None:
        self.title = title
        self.text = text
        self.order = order


def lines(results: "Entry", digits: int, width: int) -> "list[str]":
    """The results of a report."""
    rows = results["methods"]
    width = min(max(width or WIDTH, LEAST_WIDTH), LARGEST_WIDTH)
    if "cases" in results:
        return listing.lines(results["cases"], _wrapped, width)
    columns = _fitting(_columns(rows, digits), rows, width)
    text = [*_own(rows, width), "", *_legend(columns, rows, width), *_about(results, width)]
    longest = max(len(row["method"].removesuffix(CHOSEN)) for row in rows)
    room = min(width - 4 - sum(2 + size for _, size in columns), longest)
    for block in _blocks(rows):
        text += ["", *_block(block, columns, room, width)]
    return text


def _own(rows: "list[Entry]", width: int) -> "list[str]":
    """What the program's own methods achieve: their errors, whether their bounds held, and their times."""
    own = [row for row in rows if row["method"].endswith(CHOSEN)]
    unit = next((f" {row['time']['unit']}" for row in own if "time" in row), "")
    heads = ("worst", "median", "bound", *((f"time{unit}",) if unit else ()))
    figures = [
        (error(row["worst"]["value"], 3), error(row["median"]["value"], 3), _bound(row),
         *((short(row["time"]["value"], 3) if "time" in row else "",) if unit else ()))
        for row in own
    ]  # fmt: skip
    sizes = [max(map(len, column)) for column in zip(heads, *figures, strict=True)]
    names = [row["question"] + ("" if row["measure"] == "relative" else ", ¹") for row in own]
    title = "the program's own methods"
    room = min(max(map(len, (title, *names))), width - 2 - sum(2 + size for size in sizes))
    lines = ["", f"  {title:<{room}}" + "".join(f"  {head:>{size}}" for head, size in zip(heads, sizes, strict=True))]
    for name, row in zip(names, figures, strict=True):
        texts = "".join(f"  {text:>{size}}" for text, size in zip(row, sizes, strict=True))
        lines.append(f"  {_clipped(name, room):<{room}}{texts}".rstrip())
    notes = [VANISHING] if any(row["worst"]["value"] > FEW_DIGITS for row in own) else []
    notes += [MEASURES] if any(name.endswith("¹") for name in names) else []
    text = "; ".join(notes)
    return lines + ["", *(f"  {line}" for line in _wrapped(text, width - 2))] if notes else lines


def _legend(columns: "list[tuple[Column, int]]", rows: "list[Entry]", width: int) -> "list[str]":
    """What the columns there are mean, in lines as wide as the terminal."""
    there = {column.title.split()[0] for column, _ in columns} | ({"*"} if any(row["front"] for row in rows) else set())
    if not any(row["refused"]["value"] for row in rows):
        there.discard("cases")
    if any(_truly(row) for row in rows):
        there.add("truly")
    text = "; ".join(words for key, words in LEGEND.items() if key in there)
    return [f"  {line}" for line in _wrapped(text, width - 2)]


def _about(results: "Entry", width: int) -> "list[str]":
    """What times were measured on, libraries of others, and how loose bounds are in all."""
    made = []
    if "looseness" in results:
        loose = results["looseness"]["value"]
        made.append(f"stated bounds are {loose:.2g} times the true error: the median over the program's own methods")
    if "call_time" in results:
        call = results["call_time"]
        made.append(
            f"a whole call of the program takes {short(call['value'], 3)} {call['unit']}, with start, reading and "
            "writing: of that a quicker formula saves its own time only, and most of them lose digits"
        )
    if "machine" in results:
        one = results["machine"]
        made.append(f"measured on {one['processor']}, {one['system']}, {one['python']}, numpy {one['numpy']}")
    if "peers" in results:
        there = [f"{one['name']} {one['version']}" for one in results["peers"] if one["installed"]]
        gone = [one["name"] for one in results["peers"] if not one["installed"]]
        made.append(f"libraries of others: {', '.join(there) or 'none'}")
        made += [f"not here: {', '.join(gone)}"] if gone else []
    return ["", *(f"  {line}" for text in made for line in _wrapped(text, width - 2))] if made else []


def _columns(rows: "list[Entry]", digits: int) -> "list[Column]":
    def unit(name: str) -> str:
        return next((f" {row[name]['unit']}" for row in rows if name in row), "")

    def figure(name: str, form: "Callable[[float, int], str]" = short) -> "Callable[[Entry], str]":
        return lambda row: form(row[name]["value"], digits) if name in row else ""

    return [
        Column("worst", figure("worst", error)),
        Column("median", figure("median", error), 5),
        Column("in ulp", figure("worst_ulp"), 1),
        Column("median", figure("median_ulp"), 6),
        Column("ours", figure("own_worst", error), 3),
        Column("bound", _bound),
        Column(f"time{unit('time')}", figure("time", whole), 2),
        Column(f"arrays{unit('array_time')}", figure("array_time"), 4),
        Column("ratio", figure("slower")),
        Column("pieces", figure("entities", whole)),
        Column("gives", _gives, 4),
        Column("cases", _cases),
    ]


def short(value: float, digits: int) -> str:
    """A number without an exponent while that is short."""
    if value and not 1e-3 <= abs(value) < 1e5:
        return f"{value:.{max(digits - 2, 0)}e}"
    return quantity(value, "", digits) if abs(value) < 1000 else f"{value:.0f}"


def whole(value: float, digits: int) -> str:
    """A number whose size is seen by its length."""
    return f"{value:.0f}" if 1e5 <= value < 1e9 else short(value, digits)


def error(value: float, digits: int) -> str:
    """An error: two digits and its power of ten, as they are compared by that."""
    return f"{value:.{max(digits - 2, 0)}e}" if value else "0"


def _bound(row: "Entry") -> str:
    if not row["stated"]["value"]:
        return ""
    broken, word = row["broken"]["value"], "~" if row["bound"].startswith(ESTIMATE) else ""
    if broken:
        return f"{word}short {broken}/{row['stated']['value']}"
    if "looseness" not in row:
        return f"{word}held"
    loose = row["looseness"]["value"]
    return f"{word}held ×{loose:.0f}" if loose < 9.95e3 else f"{word}held ×{loose:.0e}"


def _gives(row: "Entry") -> str:
    """How much of it all a method gives, where that is less."""
    share = row.get("share", {"value": 1.0})["value"]
    return f"{100.0 * share:.0f}%" if share < 0.995 else ""


def _cases(row: "Entry") -> str:
    cases, refused = row["cases"]["value"], row["refused"]["value"]
    return f"{cases}/{cases + refused}" if refused else str(cases)


def _fitting(columns: "list[Column]", rows: "list[Entry]", width: int) -> "list[tuple[Column, int]]":
    """The columns that hold something, and their widths; the least wanted go where names would have no room."""
    sized = []
    for column in columns:
        most = max((len(column.text(row)) for row in rows), default=0)
        if most:
            sized.append((column, max(most, len(column.title))))
    while sum(2 + size for _, size in sized) > width - 4 - LEAST_NAME and any(column.order for column, _ in sized):
        sized.remove(max(sized, key=lambda pair: pair[0].order))
    return sized


def _blocks(rows: "list[Entry]") -> "list[list[Entry]]":
    """Rows that follow one another and answer one question."""
    blocks: list[list[Entry]] = []
    for row in rows:
        if blocks and blocks[-1][0]["question"] == row["question"] and blocks[-1][0]["family"] == row["family"]:
            blocks[-1].append(row)
        else:
            blocks.append([row])
    return blocks


def _block(rows: "list[Entry]", columns: "list[tuple[Column, int]]", room: int, width: int) -> "list[str]":
    measure = rows[0]["measure"]
    title = rows[0]["question"] + (f", errors in {measure}" if measure != "relative" else "")
    heads = "".join(f"  {column.title:>{size}}" for column, size in columns)
    text = [f"  {title:<{room + 2}}{heads}" if len(title) <= room + 2 else f"  {title}\n{'':{room + 4}}{heads}"]
    for row in rows:
        name = row["method"].removesuffix(CHOSEN)
        mark = "▸ " if name != row["method"] else "* " if row["front"] else "  "
        figures = "".join(f"  {column.text(row):>{size}}" for column, size in columns)
        first, *rest = _wrapped(name, room)
        text.append(f"  {mark}{first:<{room}}{figures}".rstrip())
        text += [f"      {part}" for part in rest]
        if row["worst_case"] and row["worst"]["value"]:
            truly = _truly(row)
            text.append(_clipped(f"      worst: {row['worst_case']}", width - len(truly)) + truly)
    return text


def _truly(row: "Entry") -> str:
    """The true value of the worst result, where a reader must see whether its error is one or the result is none."""
    few = row["measure"] == "relative" and row["worst"]["value"] > FEW_DIGITS
    return f", truly {row['worst_reference']}" if few and row["worst_reference"] else ""


def _wrapped(text: str, room: int) -> "list[str]":
    """Words in lines that fit, those after the first set in by two."""
    wrapped: list[str] = []
    for word in text.split():
        if wrapped and len(wrapped[-1]) + 1 + len(word) <= room - (2 if len(wrapped) > 1 else 0):
            wrapped[-1] += f" {word}"
        else:
            wrapped.append(word)
    return wrapped


def _clipped(text: str, width: int) -> str:
    """One line, its middle left out where it is too long: what comes last names the result."""
    if len(text) <= width:
        return text
    tail = min(24, width // 3)
    return f"{text[: width - tail - 1]}…{text[-tail:]}"
