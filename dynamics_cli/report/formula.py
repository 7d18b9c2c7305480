"""Formulas as text read into a tree, and the tree as MathML and as typst's mathematics.

The text is that of `Model.formula` with its addresses filled in: `v = √(vₑ² + 2·g·d)`; a number with a unit is enclosed
by `quantity`, so that a unit's slash and powers stay what they are.
"""

import re
from html import escape

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    # A node: what it is, and its text or its parts.
    Node = tuple[str, Any]

_OPEN, _CLOSE = "\ue000", "\ue001"
_LOWERED = dict(zip("₀₁₂₃₄₅₆₇₈₉₊₋ₐₑᵢⱼₖₘₙₒₓᵧₚₛₜᵣᵤᵥₗₕᵦ", "0123456789+−aeijkmnoxγpstruvlhβ", strict=True))
_RAISED = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ᵀⁿ", "0123456789+−Tn", strict=True))
_FUNCTIONS = (
    "sin",
    "cos",
    "tan",
    "cot",
    "asin",
    "acos",
    "atan",
    "atan2",
    "inv",
    "max",
    "min",
    "tr",
    "det",
    "sgn",
    "arg",
)
_PAIRS = {"(": ")", "[": "]", "|": "|"}
_FUNCTION = re.compile(f"(?:{'|'.join(sorted(_FUNCTIONS, key=len, reverse=True))})(?![A-Za-z_])")
_SIGNS = "ΣΠ"
_NAME = re.compile("[A-Za-zͰ-Ͽıℓ][A-Za-zͰ-Ͽ]*[̄̇̈′″‴*]*")
_LOW = re.compile(f"_([A-Za-z0-9Ͱ-Ͽ]+)|([{''.join(_LOWERED)}]+)")
_HIGH = re.compile(f"([{''.join(_RAISED)}]+)")
_NUMBER = re.compile(r"\d+(?:\.\d+)?|[½¼¾]")
# Longer runs of letters are words.
_LONGEST_NAME = 2


def quantity(number: str, unit: str) -> str:
    """A number with its unit as one piece of a formula."""
    if unit == "deg":
        return f"{_OPEN}{number}°{_CLOSE}"
    return f"{_OPEN}{number}\u00a0{unit}{_CLOSE}" if unit else f"{_OPEN}{number}{_CLOSE}"


def plain(formula: str) -> str:
    """The formula as text."""
    return re.sub(
        f"{_OPEN}([^{_CLOSE}]*){_CLOSE}([{''.join(_RAISED)}]?)",
        lambda found: f"({found[1]}){found[2]}" if found[2] and "\u00a0" in found[1] else found[1] + found[2],
        formula,
    ).replace("\u00a0", " ")


class _Parser:
    """Reads a formula from left to right; what it does not know stands as it is."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.at = 0

    def row(self, until: str = "") -> "list[Node]":
        """Nodes up to the closing bracket, or to the end."""
        nodes: list[Node] = []
        while self.at < len(self.text) and self.text[self.at] != until:
            if self.text[self.at] == "/" and nodes and nodes[-1][0] not in ("operator", "space", "word"):
                self.at += 1
                nodes.append(("fraction", (_bare(nodes.pop()), _bare(self.factor()))))
            else:
                nodes.append(self.factor())
        return nodes

    def factor(self) -> "Node":
        """One piece with its scripts."""
        node = self._atom()
        if node[0] == "operator" and node[1] in _SIGNS and self.at < len(self.text):
            self._skip_spaces()
            return "row", [node, self.factor()]
        if node[0] in ("space", "operator"):
            return node
        while self.at < len(self.text):
            low, high = _LOW.match(self.text, self.at), _HIGH.match(self.text, self.at)
            if low:
                self.at = low.end()
                node = ("low", (node, low[1] or "".join(_LOWERED[letter] for letter in low[2])))
            elif high:
                self.at = high.end()
                node = ("high", (_grouped(node), [("number", "".join(_RAISED[letter] for letter in high[1]))]))
            elif self.text[self.at] == "^":
                self.at += 1
                node = ("high", (_grouped(node), _bare(self._atom())))
            else:
                break
        return self._applied(node)

    def _skip_spaces(self) -> None:
        while self.text[self.at] == " " and self.at + 1 < len(self.text):
            self.at += 1

    def _applied(self, node: "Node") -> "Node":
        """A function with its argument."""
        base = node
        while base[0] in ("low", "high"):
            base = base[1][0]
        if base[0] != "function":
            return node
        if self.at >= len(self.text):
            return node
        self._skip_spaces()
        return "row", [node, self.factor()]

    def _atom(self) -> "Node":
        text, start = self.text, self.at
        letter = text[start]
        if letter == _OPEN:
            self.at = text.index(_CLOSE, start) + 1
            return "quantity", text[start + 1 : self.at - 1]
        if letter in _PAIRS and _PAIRS[letter] in text[start + 1 :]:
            self.at += 1
            inside = self.row(_PAIRS[letter])
            if self.at >= len(text):
                return "row", [("operator", letter), *inside]
            self.at += 1
            return "brackets", (letter, inside, _PAIRS[letter])
        if letter == "√" and start + 1 < len(text):
            self.at += 1
            return "root", _bare(self.factor())
        if found := _NUMBER.match(text, start):
            self.at = found.end()
            return "number", found[0]
        if found := _FUNCTION.match(text, start):
            self.at = found.end()
            return "function", found[0]
        if found := _NAME.match(text, start):
            self.at = found.end()
            return "word" if len(found[0].rstrip("′″‴*")) > _LONGEST_NAME else "name", found[0]
        self.at += 1
        return ("space", " ") if letter == " " else ("operator", letter)


def _bare(node: "Node") -> "list[Node]":
    """What stands within brackets that the layout makes superfluous."""
    return list(node[1][1]) if node[0] == "brackets" and node[1][0] == "(" else [node]


def _grouped(node: "Node") -> "Node":
    """A number with a unit in brackets, so that a power is one of both."""
    return ("brackets", ("(", [node], ")")) if node[0] == "quantity" and "\u00a0" in node[1] else node


def parse(text: str) -> "list[Node]":
    """The formula as a tree."""
    return _Parser(text).row()


def mathml(formula: str) -> str:
    """The formula as a MathML element that stands by itself."""
    label = escape(plain(formula), quote=True)
    return f'<math display="block" aria-label="{label}"><mrow>{_elements(parse(formula))}</mrow></math>'


def _elements(nodes: "list[Node]") -> str:
    return "".join(map(_element, nodes))


def _element(node: "Node") -> str:
    what, held = node
    if what == "quantity":
        number, _, unit = held.partition("\u00a0")
        return f"<mn>{escape(number)}</mn>" + (f"<mtext>\u00a0{escape(unit)}</mtext>" if unit else "")
    if what == "row":
        return f"<mrow>{_elements(held)}</mrow>"
    if what == "brackets":
        return f'<mrow><mo stretchy="true">{held[0]}</mo>{_elements(held[1])}<mo stretchy="true">{held[2]}</mo></mrow>'
    if what == "root":
        return f"<msqrt>{_elements(held)}</msqrt>"
    if what == "fraction":
        return f"<mfrac><mrow>{_elements(held[0])}</mrow><mrow>{_elements(held[1])}</mrow></mfrac>"
    if what == "low":
        return f"<msub><mrow>{_element(held[0])}</mrow><mtext>{escape(held[1])}</mtext></msub>"
    if what == "high" and held[0][0] == "low":
        base, low = held[0][1]
        return f"<msubsup>{_element(base)}<mtext>{escape(low)}</mtext><mrow>{_elements(held[1])}</mrow></msubsup>"
    if what == "high":
        return f"<msup><mrow>{_element(held[0])}</mrow><mrow>{_elements(held[1])}</mrow></msup>"
    if what == "space":
        return ""
    if what == "word":
        return f"<mtext>\u00a0{escape(held)}\u00a0</mtext>"
    tag = {"number": "mn", "name": "mi", "function": "mi", "operator": "mo"}[what]
    after = "<mo>&#x2061;</mo><mspace width='0.15em'></mspace>" if what == "function" else ""
    return f"<{tag}>{escape(held)}</{tag}>{after}"


def typst(formula: str) -> str:
    """The formula as typst's mathematics, without the dollar signs."""
    return _written(parse(formula))


def _written(nodes: "list[Node]") -> str:
    return " ".join(map(_piece, nodes))


def _piece(node: "Node") -> str:
    what, held = node
    if what == "quantity":
        number, _, unit = held.partition("\u00a0")
        return f"{_quoted(number)} thin {_quoted(unit)}" if unit else _quoted(number)
    if what == "row":
        return _written(held)
    if what == "brackets":
        return f"lr(\\{held[0]} {_written(held[1])} \\{held[2]})"
    if what == "root":
        return f"sqrt({_written(held)})"
    if what == "fraction":
        return f"frac({_written(held[0])}, {_written(held[1])})"
    if what == "low":
        return f"attach({_piece(held[0])}, b: {_quoted(held[1])})"
    if what == "high" and held[0][0] == "low":
        base, low = held[0][1]
        return f"attach({_piece(base)}, b: {_quoted(low)}, t: {_written(held[1])})"
    if what == "high":
        return f"attach({_piece(held[0])}, t: {_written(held[1])})"
    if what == "space":
        return ""
    if what == "function":
        return f"op({_quoted(held)}) thin"
    if what == "word":
        return f'" " {_quoted(held)} " "'
    if what == "number":
        return _quoted(held)
    if what == "name":
        return held if len(held) == 1 else f"italic({_quoted(held)})"
    return f"\\{held}" if held in "#$&_^/\\\"'()[]{},;*~`@=<>|!:-" else str(held)


def _quoted(text: str) -> str:
    """Upright text."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'
