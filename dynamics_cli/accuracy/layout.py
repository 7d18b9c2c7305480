"""The report for people: a line for each question, or every method of the questions of one task."""

from statistics import median

from dynamics_cli.accuracy import listing
from dynamics_cli.accuracy.rows import CHOSEN, ESTIMATE
from dynamics_cli.core.documents import quantity

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any

    Entry = dict[str, Any]

# Where standard output is no terminal the width is always the same, so that the bytes are.
WIDTH = 80
LEAST_WIDTH, LARGEST_WIDTH = 80, 140
LEAST_NAME = 24
# More questions than these have a line each.
FEW_QUESTIONS = 4
# Worse than this, a result's true value is shown beside it.
FEW_DIGITS = 1e-10
# What columns and marks mean, by the first word of the column's title; said of those that are there.
LEGEND = {
    "worst": "errors are shares of the true value (1e-16: its last digit, 1: no digit right)",
    "°": "°: of a result close to zero, and its stated error is as large",
    "truly": "truly: the true value, of which a small error is a large share where it is close to zero",
    "stated": "held ×n: stated errors were never too small, typically n times the true one",
    "~": "~: an estimate",
    "ratio": "ratio: time over that of the program's own method (▸), for the formula alone",
    "gives": "gives: how many of our results the method gives",
    "cases": "a/b: a of b cases answered",
    "textbook": "textbook: its worst error (wrong: no digit right)",
    "its": "its time: over ours",
    "wrong": "wrong: textbooks' methods with a case without a right digit",
    "¹": "¹: errors in another measure, named with the question alone",
}
# The least error that is called wrong.
WRONG = 0.95


class Column:
    """One column of figures: its title, its text for a row, and when it goes for lack of room (0: never)."""

    def __init__(self, title: str, text: "Callable[[Entry], str]", order: int = 0) -> None:
        self.title = title
        self.text = text
        self.order = order


def lines(results: "Entry", digits: int, width: int) -> "list[str]":
    """The results of a report."""
    width = min(max(width or WIDTH, LEAST_WIDTH), LARGEST_WIDTH)
    if "cases" in results:
        return listing.lines(results["cases"], _wrapped, width)[1:]
    blocks = _blocks(results["methods"])
    families = {rows[0]["family"] for rows in blocks}
    several = len(blocks) > 1 and len({(rows[0]["family"], rows[0]["task"]) for rows in blocks}) > 1
    if len(families) > 1 and "peers" not in results:
        text, seen = _of_families(blocks, digits, width)
        more = "a line for each task: dynamics accuracy FAMILY"
        if "most_cases" in results:
            many = results["most_cases"]["value"]
            more = f"over at most {many} hard cases of each question; all cases, {more}"
    elif (several or len(blocks) > FEW_QUESTIONS) and "peers" not in results:
        text, seen = _overview(blocks, digits, width)
        more = f"every method of a task: dynamics accuracy {_example(blocks)}"
    else:
        text, seen = _details(blocks, digits, width)
        more = ""
    return [*text, "", *_legend(seen, width), *_about(results, more, width)]


def _example(blocks: "list[list[Entry]]") -> str:
    """A family and a task that can be asked for."""
    rows = next((rows for rows in blocks if rows[0]["task"] and len(rows) > 1), blocks[0])
    return f"{rows[0]['family']} {rows[0]['task']}".strip()


def _of_families(blocks: "list[list[Entry]]", digits: int, width: int) -> "tuple[list[str], set[str]]":
    """A line for each family: the program's own methods, and how often the textbook's go wrong."""
    by_family: dict[str, list[list[Entry]]] = {}
    for block in blocks:
        by_family.setdefault(block[0]["family"], []).append(block)
    rows = [_summed(asked) for asked in by_family.values()]
    columns = _fitting(
        [
            Column("questions", lambda row: str(row["asked"])),
            *_columns(rows, digits, brief=True),
            Column("wrong", lambda row: row["wrong"]),
        ],
        rows, width,
    )  # fmt: skip
    return _listed("our own methods", list(by_family), rows, columns, width)


def _summed(asked: "list[list[Entry]]") -> "Entry":
    """The worst of the program's methods for questions of a family, and the medians of all."""
    own = [block[0] for block in asked]
    row = dict(max([one for one in own if one["measure"] == "relative"] or own, key=lambda one: one["worst"]["value"]))
    for name in ("median", "looseness", "time"):
        entries = [one[name] for one in own if name in one]
        row |= {name: entries[0] | {"value": median(entry["value"] for entry in entries)}} if entries else {}
    row |= {name: {"value": sum(one[name]["value"] for one in own)} for name in ("stated", "broken")}
    others = [other for other in map(_other, asked) if other]
    wrong = sum(_is_wrong(other) for other in others)
    return row | {"asked": len(asked), "wrong": f"{wrong} of {len(others)}" if others else ""}


def _overview(blocks: "list[list[Entry]]", digits: int, width: int) -> "tuple[list[str], set[str]]":
    """A line for each question: the program's own method, and the first alternative."""
    rows = [rows[0] | {"other": _other(rows)} for rows in blocks]
    columns = _fitting(
        [
            *_columns(rows, digits, brief=True),
            Column("textbook", lambda row: _instead(row["other"], digits)),
            Column("its time", lambda row: _slower(row["other"]), 1),
        ],
        rows, width,
    )  # fmt: skip
    return _listed("our own methods", [row["question"] for row in rows], rows, columns, width)


def _listed(
    title: str, names: "list[str]", rows: "list[Entry]", columns: "list[tuple[Column, int]]", width: int
) -> "tuple[list[str], set[str]]":
    """Rows by their names, and what of the legend they need."""
    names = [
        name + ("" if row["measure"] == "relative" else " ¹") for name, row in zip(names, rows, strict=True)
    ]  # fmt: skip
    room = min(max(map(len, (title, *names))), width - sum(2 + size for _, size in columns))
    text = [f"{title:<{room}}" + "".join(f"  {column.title:>{size}}" for column, size in columns)]
    for name, row in zip(names, rows, strict=True):
        figures = "".join(f"  {column.text(row):>{size}}" for column, size in columns)
        text.append(f"{_clipped(name, room):<{room}}{figures}".rstrip())
    marks = {mark for mark in "¹°" if any(mark in line for line in text)}
    return text, _seen(columns, rows) | marks


def _other(rows: "list[Entry]") -> "Entry | None":
    """The first alternative that answers."""
    return next((row for row in rows[1:] if row["cases"]["value"]), None)


def _is_wrong(row: "Entry") -> bool:
    return bool(row["measure"] == "relative" and row["worst"]["value"] >= WRONG)


def _instead(row: "Entry | None", digits: int) -> str:
    """The worst error of an alternative, or its pieces."""
    if row is None:
        return ""
    return "wrong" if _is_wrong(row) else _worst(row, digits)


def _slower(row: "Entry | None") -> str:
    return f"×{short(row['slower']['value'], 2)}" if row and "slower" in row else ""


def _details(blocks: "list[list[Entry]]", digits: int, width: int) -> "tuple[list[str], set[str]]":
    """Every method of every question."""
    rows = [row for block in blocks for row in block]
    columns = _fitting(_columns(rows, digits), rows, width)
    longest = max(len(row["method"].removesuffix(CHOSEN)) for row in rows)
    room = min(width - 4 - sum(2 + size for _, size in columns), longest)
    text = [line for block in blocks for line in ("", *_block(block, columns, room, width))][1:]
    marks = {"truly"} if any(_truly(row) for row in rows) else set()
    return text, _seen(columns, rows) | marks


def _seen(columns: "list[tuple[Column, int]]", rows: "list[Entry]") -> "set[str]":
    """What of the legend there is to explain."""
    seen = {column.title.split()[0] for column, _ in columns}
    if not any(row["refused"]["value"] for row in rows):
        seen.discard("cases")
    return seen | ({"~"} if any(row["bound"].startswith(ESTIMATE) for row in rows) else set())


def _legend(seen: "set[str]", width: int) -> "list[str]":
    return _wrapped("; ".join(words for key, words in LEGEND.items() if key in seen), width)


def _about(results: "Entry", more: str, width: int) -> "list[str]":
    """What times were measured on, libraries of others, and what can be asked next."""
    notes = []
    if "machine" in results and "call_time" in results:
        machine, call = results["machine"], results["call_time"]
        notes.append(
            f"measured on {machine['processor']}, {machine['python']}; a whole call takes {short(call['value'], 2)} "
            f"{call['unit']}, mostly the start of Python"
        )
    if "peers" in results:
        there = [f"{peer['name']} {peer['version']}" for peer in results["peers"] if peer["installed"]]
        gone = [peer["name"] for peer in results["peers"] if not peer["installed"]]
        notes.append(f"libraries of others: {', '.join(there) or 'none'}")
        notes += [f"not here: {', '.join(gone)}"] if gone else []
    notes += [more] if more else []
    return [line for text in notes for line in _wrapped(text, width)]


def _columns(rows: "list[Entry]", digits: int, *, brief: bool = False) -> "list[Column]":
    def unit(name: str) -> str:
        return next((f" {row[name]['unit']}" for row in rows if name in row), "").replace(" us", " µs")

    def figure(name: str, form: "Callable[[float, int], str]" = short) -> "Callable[[Entry], str]":
        return lambda row: form(row[name]["value"], digits) if name in row else ""

    small = brief and any(map(_is_small, rows))
    columns = [
        Column("worst", lambda row: _worst(row, digits) + (("°" if _is_small(row) else " ") if small else "")),
        Column("median", figure("median", error), 5),
        Column("stated", _bound),
        Column(f"time{unit('time')}", figure("time", whole), 2),
        Column("ratio", figure("slower")),
        Column("gives", _gives, 4),
        Column("cases", _cases),
    ]
    return columns[:4] if brief else columns


def _worst(row: "Entry", digits: int) -> str:
    """The worst error; of whole numbers, whether all are right."""
    worst = row["worst"]["value"]
    if row["counts"]:
        return "wrong" if worst else "right"
    return error(worst, digits)


def _is_small(row: "Entry") -> bool:
    """Whether an error that looks large is that of a result which all but vanishes, and is stated."""
    stated = row["stated"]["value"] and not row["broken"]["value"]
    return bool(stated and row["measure"] == "relative" and row["worst"]["value"] > FEW_DIGITS)


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
    loose = row.get("looseness", {"value": 0.0})["value"]
    if loose < 0.95:
        # below a last bit there is nothing to compare
        return f"{word}held"
    return f"{word}held ×{loose:.0f}" if loose < 9.95e3 else f"{word}held ×{loose:.0e}"


def _gives(row: "Entry") -> str:
    """How much of it all a method gives, where that is less."""
    share = row.get("share", {"value": 1.0})["value"]
    return f"{100.0 * share:.0f}%" if share < 0.995 else ""


def _cases(row: "Entry") -> str:
    cases, refused = row["cases"]["value"], row["refused"]["value"]
    return f"{cases}/{cases + refused}" if refused else str(cases)


def _fitting(columns: "list[Column]", rows: "Sequence[Entry]", width: int) -> "list[tuple[Column, int]]":
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
        mark = "▸ " if name != row["method"] else "  "
        figures = "".join(f"  {column.text(row):>{size}}" for column, size in columns)
        first, *rest = _wrapped(name, room)
        text.append(f"  {mark}{first:<{room}}{figures}".rstrip())
        text += [f"      {part}" for part in rest]
        if row["worst_case"] and row["worst"]["value"]:
            truly = _truly(row)
            text.append(_clipped(f"      worst: {row['worst_case']}", width - len(truly)) + truly)
    return text


def _truly(row: "Entry") -> str:
    """The true value of the worst result, beside a large error: the result may all but vanish."""
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
