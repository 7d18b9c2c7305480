"""A report as a list of blocks; `html`, `markdown` and `typst` write them."""

import re

from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    # Words; of several pieces every second one is bold.
    Text = str | tuple[str, ...]


# A table of no more rows than this is not cut.
MOST_UNCUT = 14


@record
class Title:
    """The title block: title, case, author, date and program."""

    text: str
    facts: "Sequence[str]"


@record
class Heading:
    """A heading of a level from 2."""

    level: int
    text: str


@record
class Paragraph:
    """Words; `small` for remarks."""

    text: "Text"
    small: bool = False


@record
class Items:
    """A list of words, numbered where `ordered`."""

    texts: "Sequence[Text]"
    ordered: bool = False


@record
class Table:
    """Rows of text under a head; tables are numbered as they come. `right` names the columns of numbers.

    The first column names the row; `small` is for appendices, whose names stand as they are typed; `tight` fills its
    column on a data sheet, under its caption as a heading without a number.
    """

    head: "Sequence[str]"
    rows: "Sequence[Sequence[str]]"
    caption: str
    right: "Sequence[int]" = ()
    small: bool = False
    tight: bool = False

    @property
    def short(self) -> bool:
        """Whether it stays on one page."""
        return len(self.rows) <= MOST_UNCUT


@record
class Code:
    """Text that stands as it is."""

    text: str


@record
class Formula:
    """A formula as `formula.parse` reads it."""

    text: str


@record
class Image:
    """An SVG picture, its caption, and its description for readers who cannot see it.

    Pictures are numbered in their order; `width` is a fraction of the text width.
    """

    svg: bytes
    text: str
    description: str
    width: float = 1.0


@record
class Beside:
    """Two lists of blocks side by side, where the page is wide enough."""

    left: "Sequence[Block]"
    right: "Sequence[Block]"


@record
class Break:
    """A page break."""


Block = Title | Heading | Paragraph | Items | Table | Code | Formula | Image | Beside | Break

# A symbol of one letter with a subscript.
SUBSCRIPT = re.compile(r"(?<![^\W\d_])([^\W\d_])_(\w+)")
# Control characters would command the terminal that shows the report, and half characters cannot be written.
_UNPRINTABLE = {**dict.fromkeys(range(0x20)), 0x09: " ", 0x0A: "\n", **dict.fromkeys(range(0x7F, 0xA0))}


def clean(text: str) -> str:
    """Text without unprintable characters."""
    return text.translate(_UNPRINTABLE).encode("utf-8", "backslashreplace").decode()


def pieces(text: "Text") -> "Iterator[tuple[str, bool]]":
    """The pieces of a text and whether each is bold."""
    for nth, piece in enumerate((text,) if isinstance(text, str) else text):
        if piece:
            yield clean(piece), nth % 2 == 1


def images(blocks: "Sequence[Block]") -> "list[Image]":
    """The pictures of a report in their order."""
    pictures: list[Image] = []
    for block in blocks:
        if isinstance(block, Beside):
            pictures += images([*block.left, *block.right])
        elif isinstance(block, Image):
            pictures.append(block)
    return pictures
