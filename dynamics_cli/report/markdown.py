"""A report as Markdown."""

from dynamics_cli.markup import fenced
from dynamics_cli.markup import markdown as in_markdown
from dynamics_cli.report.blocks import (
    Beside,
    Break,
    Code,
    Formula,
    Heading,
    Image,
    Items,
    Paragraph,
    Table,
    Title,
    clean,
    pieces,
)
from dynamics_cli.report.formula import plain

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from dynamics_cli.report.blocks import Block, Text


def markdown(blocks: "Sequence[Block]", names: "Sequence[str]") -> str:
    """The report as Markdown; `names` are the pictures' files in order, none where they are left out."""
    return "\n\n".join(_Writer(names).parts(blocks)) + "\n"


class _Writer:
    """Counts tables and figures."""

    def __init__(self, names: "Sequence[str]") -> None:
        self.names = iter(names)
        self.tables = self.figures = 0

    def parts(self, blocks: "Sequence[Block]") -> "list[str]":
        """The text of each block, in order."""
        return [part for block in blocks for part in self._block(block)]

    def _block(self, block: "Block") -> "list[str]":
        if isinstance(block, Title):
            return [f"# {_words(block.text)}", "\n".join(f"- {_words(fact)}" for fact in block.facts)]
        if isinstance(block, Heading):
            return [f"{'#' * block.level} {_words(block.text)}"]
        if isinstance(block, Paragraph):
            return [_words(block.text)]
        if isinstance(block, Items):
            marks = [f"{nth}." if block.ordered else "-" for nth in range(1, len(block.texts) + 1)]
            return ["\n".join(f"{mark} {_words(text)}" for mark, text in zip(marks, block.texts, strict=True))]
        if isinstance(block, Table):
            self.tables += not block.tight
            number = "" if block.tight else f"Table {self.tables}. "
            rule = "|" + "".join("--:|" if nth in block.right else "---|" for nth in range(len(block.head)))
            lines = [_row(block.head), rule, *map(_row, block.rows)]
            return [f"*{number}{_words(block.caption)}*", "\n".join(lines)]
        if isinstance(block, Formula):
            return [fenced(clean(plain(block.text)))]
        if isinstance(block, Code):
            return [fenced(clean(block.text))]
        if isinstance(block, Break):
            return ["---"]
        if isinstance(block, Beside):
            return self.parts([*block.left, *block.right])
        return self._image(block)

    def _image(self, block: Image) -> "list[str]":
        name = next(self.names, "")
        if not name:
            return []
        self.figures += 1
        caption = f"*Figure {self.figures}. {_words(block.text)}*"
        return [f"![{_words(block.description)}]({name.replace(' ', '%20')})", caption]


def _row(cells: "Sequence[str]") -> str:
    return "| " + " | ".join(_words(cell) for cell in cells) + " |"


def _words(text: "Text") -> str:
    return "".join(_piece(piece, bold) for piece, bold in pieces(text))


def _piece(text: str, bold: bool) -> str:
    """A piece with its surrounding spaces outside the bold marks."""
    words = text.strip()
    before, after = text[: len(text) - len(text.lstrip())], text[len(text.rstrip()) :]
    return f"{before}**{_plain(words)}**{after}" if bold else f"{before}{_plain(words)}{after}"


def _plain(text: str) -> str:
    return in_markdown(text, "\\|*_<`[")
