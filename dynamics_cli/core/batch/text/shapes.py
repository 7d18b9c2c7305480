"""Objects of one shape: found by one pattern, which also proves that each line is strict JSON of just that shape.

A shape is an object with its numbers removed, and without the strings that are not parameters. The pattern matches
only numbers and strings as JSON writes them, so a line that matches means the same to a JSON parser.
"""

import re

from dynamics_cli.core.batch.text.numbers import NUMBER, is_number, written
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Any

# Numbers of any length that only pass through; strings without escapes.
_OTHER_NUMBER = rb"-?(?:0|[1-9][0-9]*)(?:\.[0-9]+)?(?:[eE][+-]?[0-9]+)?"
_OTHER_STRING = rb'"[^"\\\x00-\x1f]*"'
_TOKEN = re.compile(rb'"(?:[^"\\]|\\.)*"|[{}\[\]:,]|[^\s{}\[\]:,"]+')

Path = tuple["str | int", ...]


class Token:
    """A string or a bare word of the object, with the path of keys that leads to it; `key` when it is a key itself."""

    __slots__ = ("end", "key", "path", "start", "text")

    def __init__(self, path: Path, start: int, end: int, text: bytes, *, key: bool) -> None:
        self.path = path
        self.start = start
        self.end = end
        self.text = text
        self.key = key


def tokens(line: bytes) -> "Iterator[Token]":
    """The strings and bare words of a valid JSON object."""
    stack: list[Any] = []
    waits_for_key = False
    for match in _TOKEN.finditer(line):
        text = match[0]
        if text in b"{[":
            stack.append("" if text == b"{" else 0)
            waits_for_key = text == b"{"
        elif text in b"}]":
            stack.pop()
            waits_for_key = False
        elif text == b",":
            waits_for_key = isinstance(stack[-1], str)
            if not waits_for_key:
                stack[-1] += 1
        elif text == b":":
            waits_for_key = False
        else:
            if waits_for_key:
                stack[-1] = _unescaped(text)
            yield Token(tuple(stack), match.start(), match.end(), text, key=waits_for_key)


def _unescaped(text: bytes) -> str:
    if b"\\" not in text:
        return text[1:-1].decode()
    import json

    return str(json.loads(text))


def members(line: bytes) -> "dict[str, tuple[int, int]]":
    """Where each member of the object begins (at its key) and ends."""
    depth = 0
    name, start = "", -1
    spans: dict[str, tuple[int, int]] = {}
    for match in _TOKEN.finditer(line):
        text = match[0]
        if text in b"{[":
            depth += 1
        elif text in b"}]":
            depth -= 1
        elif depth == 1 and text not in b":," and start < 0:
            name, start = _unescaped(text), match.start()
        if start >= 0 and ((depth == 1 and text == b",") or depth == 0):
            spans[name] = (start, match.start())
            start = -1
    return spans


def without_members(line: bytes, names: "tuple[str, ...]") -> bytes:
    """The object without some members and without its closing brace; the text before the first of them unchanged."""
    spans = members(line)
    left = list(spans)
    while left and left[-1] in names:
        left.pop()
    head = line[: spans[left[-1]][1]].rstrip() if left else b"{"
    if names and any(name in names for name in left):
        parts = [line[start:end].rstrip() for name, (start, end) in spans.items() if name not in names]
        return b"{" + b",".join(parts)
    return head


class Shape:
    """One shape of objects: its pattern, and the addresses of the numbers that it finds."""

    __slots__ = ("_search", "addresses", "cut", "line", "plan", "units", "whole")

    def __init__(self, line: bytes, names: "set[str]", numeric: "set[str] | None" = None) -> None:
        self.line = line
        self.plan: Any = None
        self.addresses: list[str] = []
        # The units of numbers in strings; None for bare numbers.
        self.units: list[str | None] = []
        results = members(line).get("results")
        # Where the row ends and an earlier step's results begin, at the comma between them.
        self.cut = _comma_before(line, results) if results else 0
        pairs = _pairs(line)
        pattern, position = b"", 0
        for token in tokens(line):
            in_results = results is not None and token.start > results[0]
            piece, addresses, units = _piece(token, names, pairs, numeric, in_results=in_results)
            pattern += self._between(position, token.start) + piece
            position = token.end
            self.addresses += addresses
            self.units += units
        pattern += re.escape(line[position:])
        if self.cut:
            pattern = b"(" + pattern
        self.whole = re.compile(pattern)
        # A JSON parser reads the numbers afterwards, so a looser, faster pattern is enough for whole blocks.
        self._search = re.compile(pattern.replace(b"(" + NUMBER + b")", b"([-+.0-9eE]+)"))

    def find(self, data: bytes, count: int) -> "list[list[bytes]] | None":
        """The matches of each group in all lines, or None when some line has another shape."""
        stride = self._search.groups + 1
        parts = self._search.split(data)
        # Line ends occur between matches, and only there.
        ends = parts[stride:-1:stride]
        if len(parts) != count * stride + 1 or parts[0] or parts[-1] or ends.count(b"\n") != count - 1:
            return None
        return [parts[group::stride] for group in range(1, stride)]

    def _between(self, start: int, end: int) -> bytes:
        if start <= self.cut < end and self.cut:
            return re.escape(self.line[start : self.cut]) + b")" + re.escape(self.line[self.cut : end])
        return re.escape(self.line[start:end])


def _comma_before(line: bytes, results: "tuple[int, int]") -> int:
    before = line[: results[0]].rstrip()
    if not before.endswith(b",") or line[results[1] :].strip() != b"}":
        raise ValueError("only results at the end of the row can be cut off")
    return len(before) - 1


def _pairs(line: bytes) -> "set[Path]":
    """The paths of objects that are a value with its unit."""
    return {
        token.path[:-1] for token in tokens(line) if token.key and token.path[-1] == "value" and len(token.path) > 1
    }


def _piece(
    token: Token, names: "set[str]", pairs: "set[Path]", numeric: "set[str] | None", *, in_results: bool
) -> "tuple[bytes, list[str], list[str | None]]":
    """The pattern of one token, the addresses of the numbers it finds, and the units of those in a string."""
    fixed: tuple[bytes, list[str], list[str | None]] = (re.escape(token.text), [], [])
    if token.key:
        return fixed
    path = token.path[1:] if in_results else token.path
    string = token.text.startswith(b'"')
    if not path or path[0] not in names:
        if string and b"\\" not in token.text:
            return _OTHER_STRING, [], []
        return (_OTHER_NUMBER, [], []) if is_number(token.text) else fixed
    address = _address(path, pairs, 1 if in_results else 0, token.path)
    if not address:
        return fixed
    if not string:
        found = is_number(token.text) and (numeric is None or address in numeric)
        return (b"(" + NUMBER + b")", [address], [None]) if found else fixed
    quantity = written(token.text[1:-1]) if b"\\" not in token.text else None
    # In a value with its unit only the value is a number, and `1/s` is not a number with a unit `/s`.
    if quantity is None or token.path[-1] == "unit" or quantity.after[:1].isdigit():
        return fixed
    addresses = quantity.addresses(address)
    if numeric is not None and not numeric.issuperset(addresses):
        return fixed
    return b'"' + quantity.pattern(b"(" + NUMBER + b")") + b'"', addresses, quantity.units()


def _address(path: Path, pairs: "set[Path]", skipped: int, whole: Path) -> str:
    """`first.mass` of a path of keys; the `value` of a value with its unit has the address of both."""
    address = ""
    for index, step in enumerate(path):
        if step == "value" and whole[: index + skipped] in pairs:
            continue
        address += f"[{step}]" if isinstance(step, int) else f".{step}"
    return address.lstrip(".")


def shape_of(line: bytes, names: "set[str]", numeric: "set[str] | None" = None) -> "Shape | None":
    """The shape of a line, or None when it has none that is safe."""
    if line != line.strip() or line[-2:-1].isspace():
        return None
    try:
        shape = Shape(line, names, numeric)
    except (UsageError, ValueError, IndexError):
        return None
    match = shape.whole.fullmatch(line)
    return shape if match is not None and shape.addresses else None
