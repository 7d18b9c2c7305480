"""Numbers as rows write them: one in a cell or a string, or those of a vector, `0.1, 0.2, 0.3 m`."""

import re

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator

    Tokens = list[bytes]
    Columns = list[Tokens]

# A strict JSON number, short enough that every match is a double.
NUMBER = rb"-?(?:0|[1-9][0-9]{0,40})(?:\.[0-9]{1,40})?(?:[eE][+-]?[0-9]{1,2})?"
# A number as tables may have it besides: `.5`, `5.`, `+5`, `007`.
LOOSE = rb"[+-]?(?:[0-9]{1,41}(?:\.[0-9]{0,40})?|\.[0-9]{1,40})(?:[eE][+-]?[0-9]{1,2})?"
_number_at = re.compile(LOOSE).match
# Stands for a quoted cell while its line is split.
QUOTED = b'"'
_is_number = re.compile(NUMBER).fullmatch
_is_loose = re.compile(rb" *" + LOOSE + rb" *").fullmatch
# A bracket, numbers with the same text between any two, and a bracket or a unit that no number could go on with.
_SEVERAL = re.compile(
    rb"([\[(]?)" + LOOSE + rb"(, ?| )" + LOOSE + rb"(?:\2" + LOOSE + rb")*((?:[\s\])A-DF-Zf-z\x80-\xff%][^,]*)?)"
)
# A magnitude and a direction, `20 N @ 30 deg`.
_POLAR = re.compile(rb"()" + LOOSE + rb"([^\d@,.][^@,]*@ *| *@ *)" + LOOSE + rb"([^\d.@,][^@,]*)")


class Written:
    """The text around the numbers of a cell: how many there are, what precedes, parts and follows them."""

    __slots__ = ("after", "before", "between", "count")

    def __init__(self, count: int, before: bytes, between: bytes, after: bytes) -> None:
        self.count = count
        self.before = before
        self.between = between
        self.after = after

    @property
    def key(self) -> "tuple[int, bytes, bytes, bytes]":
        """What is the same for cells written alike."""
        return self.count, self.before, self.between, self.after

    def units(self, others: str = "") -> "list[str | None]":
        """The unit of each number: that behind them, else that of others."""
        unit = self.after.decode().strip("]) ") or others or None
        return [self.between.decode().strip(" @") or None, unit] if b"@" in self.between else [unit] * self.count

    def addresses(self, address: str) -> "list[str]":
        """Those of the numbers of the input at this address."""
        if b"@" in self.between:
            return [f"{address}.magnitude", f"{address}.direction"]
        return [address] if self.count == 1 else [f"{address}[{index}]" for index in range(self.count)]

    def pattern(self, number: bytes) -> bytes:
        """A pattern of texts written alike, given that of a number."""
        return re.escape(self.before) + re.escape(self.between).join([number] * self.count) + re.escape(self.after)

    def columns(self, cells: "Tokens") -> "Columns | None":
        """The numbers' texts, or None where some cell is written in another way."""
        head, tail = len(self.before), len(self.after)
        if head or tail or self.count > 1:
            # a number alone may have spaces around it
            cells = [cell.strip(b" ") for cell in cells]
        if tail and not all(cell.endswith(self.after) for cell in cells):
            return None
        if head and not all(cell.startswith(self.before) for cell in cells):
            return None
        if head or tail:
            cells = [cell[head : len(cell) - tail] for cell in cells]
        return apart(cells, self.between, self.count) if self.count > 1 else [cells]


def written(text: bytes) -> "Written | None":
    """How a cell or a string that begins with a number, or a bracket, is written; None for other texts."""
    text = text.strip(b" ")
    several = _SEVERAL.fullmatch(text) or _POLAR.fullmatch(text)
    if several is not None:
        before, between, after = several.groups()
        inner = text[len(before) : len(text) - len(after)]
        return Written(inner.count(between) + 1, before, between, after)
    match = _number_at(text)
    return Written(1, b"", b"", text[match.end() :]) if match is not None else None


def loose_numbers(texts: "Tokens") -> "list[float] | None":
    """The doubles nearest to numbers as tables may have them, with spaces around them perhaps; None for other texts."""
    return list(map(float, texts)) if all(map(_is_loose, texts)) else None


def is_number(text: bytes) -> bool:
    """Whether a text is one number."""
    return _is_number(text) is not None


def apart(lines: "Tokens", separator: bytes, width: int, quoted: "Iterator[bytes] | None" = None) -> "Columns | None":
    """Columns of the texts between separators, or None where some line has another number of them.

    A cell of `QUOTED` stands for the next of the quoted texts.
    """
    cells = (separator + b"\n" + separator).join(lines).split(separator)
    # A marker cell parts lines; if each marker is in its place, every line has the right number of cells.
    if len(cells) != len(lines) * (width + 1) - 1 or cells[width :: width + 1].count(b"\n") != len(lines) - 1:
        return None
    if quoted is not None:
        cells = [next(quoted) if cell == QUOTED else cell for cell in cells]
    return [cells[index :: width + 1] for index in range(width)]
