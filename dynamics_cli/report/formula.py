"""Formulas as text read into a tree, and the tree as MathML and as typst's mathematics.

The text is `Model.formula` with its addresses filled in: `v = √(vₑ² + 2·g·d)`; a number with a unit is enclosed
by `quantity`, so that a unit's slash and powers stay what they are.
"""

import re
from html import escape

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    # A node: its kind, and its text or its parts.
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
# Longer runs of letters are words, and these; several in a row stand together.
_WORD = "(?:[A-Za-z]{3,}(?:'s)?|at|by|if|in|is|of|on|or|to)(?![A-Za-z_Ͱ-Ͽ̄̇̈′″‴*])"
_WORDS = re.compile(f"{_WORD}(?: {_WORD})*:?")


def quantity(number: str, unit: str) -> str:
    """A number with its unit as one piece of a formula."""
    if unit == "deg":
        return f"{_OPEN}{number}°{_CLOSE}"
    return f"{_OPEN}{number}\u00a0{unit}{_CLOSE}" if unit else f"{_OPEN}{number}{_CLOSE}"


def plain(formula: str) -> str:
    """The formula as text."""
    return re.sub(
        f"{_OPEN}([^{_CLOSE}]*){_CLOSE}([{''.join(_RAISED)}]?)",
        lambda match: f"({match[1]}){match[2]}" if match[2] and "\u00a0" in match[1] else match[1] + match[2],
        formula,
    ).replace("\u00a0", " ")


class _Parser:
    """Reads a formula from left to right; unknown text is kept unchanged."""

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
        if start >= len(text):
            return "space", " "
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
        if number := _NUMBER.match(text, start):
            self.at = number.end()
            return "number", number[0]
        if number := _FUNCTION.match(text, start):
            self.at = number.end()
            return "function", number[0]
        if number := _WORDS.match(text, start):
            self.at = number.end()
            return "word", number[0]
        if number := _NAME.match(text, start):
            self.at = number.end()
            return "name", number[0]
        self.at += 1
        return ("space", " ") if letter == " " else ("operator", letter)


def _bare(node: "Node") -> "list[Node]":
    """Content of brackets that the layout makes superfluous."""
    return list(node[1][1]) if node[0] == "brackets" and node[1][0] == "(" else [node]


def _grouped(node: "Node") -> "Node":
    """A number with a unit in brackets, so that a power is one of both."""
    return ("brackets", ("(", [node], ")")) if node[0] == "quantity" and "\u00a0" in node[1] else node


def parse(text: str) -> "list[Node]":
    """The formula as a tree."""
    return _Parser(text).row()


class _Language:
    """How the parts of a formula are written: a template for each kind of node, and how texts and signs are quoted."""

    def __init__(
        self, between: str, text: "Callable[[str], str]", sign: "Callable[[str], str]", **templates: str
    ) -> None:
        self.between = between
        self.text = text
        self.sign = sign
        self.templates = templates

    def row(self, nodes: "list[Node]") -> str:
        """Nodes one after another."""
        return self.between.join(map(self.node, nodes))

    def node(self, node: "Node") -> str:
        """One node with all that is in it."""
        kind, content = node
        if kind == "space":
            return ""
        if kind == "operator":
            return self._filled(kind, self.sign(content))
        if kind == "quantity":
            number, _, unit = content.partition("\u00a0")
            return self._filled("measured" if unit else "number", self.text(number), self.text(unit))
        if kind in ("row", "root"):
            return self._filled(kind, self.row(content))
        if kind == "brackets":
            return self._filled(kind, self.sign(content[0]), self.row(content[1]), self.sign(content[2]))
        if kind == "fraction":
            return self._filled(kind, self.row(content[0]), self.row(content[1]))
        if kind == "low":
            return self._filled(kind, self.node(content[0]), self.text(content[1]))
        if kind == "high" and content[0][0] == "low":
            base, low = content[0][1]
            return self._filled("both", self.node(base), self.text(low), self.row(content[1]))
        if kind == "high":
            return self._filled(kind, self.node(content[0]), self.row(content[1]))
        if kind == "name" and len(content) == 1:
            return self._filled("letter", content)
        return self._filled(kind, self.text(content))

    def _filled(self, kind: str, *parts: str) -> str:
        return self.templates[kind].format(*parts)


def _quoted(text: str) -> str:
    """Upright text of typst."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'


def _typst_sign(sign: str) -> str:
    return f"\\{sign}" if sign in "#$&_^/\\\"'()[]{},;*~`@=<>|!:-" else sign


_MATHML = _Language(
    "",
    escape,
    escape,
    number="<mn>{0}</mn>",
    measured="<mn>{0}</mn><mtext>\u00a0{1}</mtext>",
    row="<mrow>{0}</mrow>",
    brackets='<mrow><mo stretchy="true">{0}</mo>{1}<mo stretchy="true">{2}</mo></mrow>',
    root="<msqrt>{0}</msqrt>",
    fraction="<mfrac><mrow>{0}</mrow><mrow>{1}</mrow></mfrac>",
    low="<msub><mrow>{0}</mrow><mtext>{1}</mtext></msub>",
    both="<msubsup>{0}<mtext>{1}</mtext><mrow>{2}</mrow></msubsup>",
    high="<msup><mrow>{0}</mrow><mrow>{1}</mrow></msup>",
    word="<mtext>\u00a0{0}\u00a0</mtext>",
    letter="<mi>{0}</mi>",
    name="<mi>{0}</mi>",
    function="<mi>{0}</mi><mo>&#x2061;</mo><mspace width='0.15em'></mspace>",
    operator="<mo>{0}</mo>",
)
_TYPST = _Language(
    " ",
    _quoted,
    _typst_sign,
    number="{0}",
    measured="{0} thin {1}",
    row="{0}",
    brackets="lr({0} {1} {2})",
    root="sqrt({0})",
    fraction="frac({0}, {1})",
    low="attach({0}, b: {1})",
    both="attach({0}, b: {1}, t: {2})",
    high="attach({0}, t: {1})",
    word='" " {0} " "',
    letter="{0}",
    name="italic({0})",
    function="op({0}) thin",
    operator="{0}",
)


def mathml(formula: str) -> str:
    """The formula as a MathML element in a block of its own."""
    label = escape(plain(formula), quote=True)
    return f'<math display="block" aria-label="{label}"><mrow>{_MATHML.row(parse(formula))}</mrow></math>'


def typst(formula: str) -> str:
    """The formula as typst's mathematics, without the dollar signs."""
    return _TYPST.row(parse(formula))
