"""A report as typst's markup, and by typst as PDF. Only this module imports typst."""

import json
import os
import re
import tempfile

from dynamics_cli.errors import UsageError
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
    images,
    pieces,
)
from dynamics_cli.report.formula import typst as mathematics

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from dynamics_cli.report.blocks import Block, Text

PAPERS = {"a4": "a4", "letter": "us-letter"}
# A picture higher than this share of the text's width goes to the top or the end of a page.
TALL = 0.7
# A cell of more letters than this may be broken into lines.
_LONGEST_CELL = 24
# A data sheet's table of no more columns has the first as wide as there is room.
MOST_COLUMNS = 5
_STYLE = """
#set text(font: ("Libertinus Serif", "DejaVu Sans Mono"), size: 10pt, lang: "en", fill: rgb("#1a1a1a"))
#set par(leading: 0.55em, spacing: 0.75em)
#set enum(spacing: 0.7em)
#set table(stroke: none, inset: (x: 0pt, y: 2.6pt), column-gutter: 8pt)
#show heading: set block(above: 1.3em, below: 0.55em, sticky: true)
#show heading.where(level: 2): set text(size: 13pt)
#show heading.where(level: 3): set text(size: 10.5pt)
#show figure: set block(above: 0.7em, below: 0.9em)
#show figure.where(kind: table): set block(breakable: true)
#show figure.where(kind: table): set align(left)
#show figure.where(kind: table): set figure.caption(position: top)
#show figure.caption: it => align(left, text(size: 8.5pt, fill: rgb("#444"), it))
#show table: set align(left)
#show raw: set text(font: "DejaVu Sans Mono", size: 6pt)
#show raw.where(block: true): it => block(width: 100%, fill: rgb("#f4f4f4"), inset: 5pt, it)
#show math.equation.where(block: true): set block(above: 0.7em, below: 0.7em)
#let fitted(file, share, alt) = layout(size => {
  let drawn = image(file, width: share * size.width, alt: alt)
  if measure(drawn).height > 215mm { image(file, height: 215mm, alt: alt) } else { drawn }
})
"""


def need() -> "Any":
    """The library, or how to get it."""
    try:
        import typst
    except ImportError:
        raise UsageError(
            "a report as PDF needs a part that is not installed",
            code="not-installed",
            parameter="output",
            hint="pip install 'dynamics-cli[report]'; or print the HTML report from a browser",
        ) from None
    return typst


def pdf(blocks: "Sequence[Block]", title: str, author: str, paper: str) -> bytes:
    """The report as a PDF file."""
    library = need()
    with tempfile.TemporaryDirectory() as folder:
        for nth, image in enumerate(images(blocks), 1):
            with open(os.path.join(folder, f"{nth}.svg"), "wb") as file:
                file.write(image.svg)
        name = os.path.join(folder, "report.typ")
        with open(name, "w", encoding="utf-8") as file:
            file.write(markup(blocks, title, author, paper))
        pdf_bytes: bytes = library.compile(name, format="pdf", ignore_system_fonts=True)
    return pdf_bytes


def markup(blocks: "Sequence[Block]", title: str, author: str, paper: str) -> str:
    """The report as typst's markup; its pictures are named 1.svg, 2.svg and so on."""
    head = [
        f"#set document(title: {_string(title)}, author: {_string(author or 'dynamics')})",
        f'#set page(paper: "{PAPERS[paper]}", margin: (x: 18mm, top: 13mm, bottom: 15mm), footer: context '
        f'align(right, text(size: 8pt)[{_escape(title)} · page #counter(page).display("1 of 1", both: true)]))',
        _STYLE,
    ]
    return "\n".join([*head, *_Writer().parts(blocks)]) + "\n"


class _Writer:
    """Counts figures."""

    def __init__(self) -> None:
        self.figures = 0

    def parts(self, blocks: "Sequence[Block]") -> "list[str]":
        """The text of each block, in order."""
        return [self._block(block) + "\n" for block in blocks]

    def _block(self, block: "Block") -> str:
        if isinstance(block, Title):
            facts = r" \ ".join(map(_escape, block.facts))
            return (
                f"#grid(columns: (1fr, auto), align: (left + bottom, right + bottom), gutter: 12pt, heading(level: 1, "
                f'text(size: 19pt)[{_escape(block.text)}]), text(size: 8.5pt, fill: rgb("#444"))[{facts}])\n'
                "#line(length: 100%, stroke: 1.2pt)"
            )
        if isinstance(block, Heading):
            return f"#heading(level: {block.level})[{_escape(block.text)}]"
        if isinstance(block, Paragraph):
            words = _words(block.text)
            return f'#par(text(size: 8.5pt, fill: rgb("#444"))[{words}])' if block.small else f"#par[{words}]"
        if isinstance(block, Items):
            items = ", ".join(f"[{_words(text)}]" for text in block.texts)
            return f"#{'enum' if block.ordered else 'list'}({items})"
        if isinstance(block, Table):
            return _table(block)
        if isinstance(block, Formula):
            return f"$ {mathematics(clean(block.text))} $"
        if isinstance(block, Code):
            return f"#raw(block: true, {_string(clean(block.text))})"
        if isinstance(block, Break):
            return "#pagebreak()"
        if isinstance(block, Beside):
            sides = ["\n".join(self.parts(side)) for side in (block.left, block.right)]
            return f"#grid(columns: (11fr, 9fr), gutter: 16pt, [{sides[0]}], [{sides[1]}])"
        self.figures += 1
        place = ", placement: auto" if _is_tall(block) else ""
        return (
            f'#figure(fitted("{self.figures}.svg", {100.0 * block.width:.0f}%, {_string(block.description)}), '
            f"caption: [{_escape(block.text)}]{place})"
        )


def _is_tall(image: Image) -> bool:
    """Whether a picture is so high that the page before it would be left half empty."""
    size = re.search(rb'viewBox="0 0 ([\d.]+) ([\d.]+)"', image.svg)
    return size is not None and image.width * float(size[2]) > TALL * float(size[1])


def _table(block: Table) -> str:
    size = "7pt" if block.small and block.tight else "6.5pt" if block.small else "8pt" if block.tight else "8.5pt"
    widths = [max((len(row[nth]) for row in block.rows), default=0) for nth in range(len(block.head))]
    columns = ["auto" if nth in block.right or width <= _LONGEST_CELL else "1fr" for nth, width in enumerate(widths)]
    columns[0] = "1fr" if block.tight and len(block.head) <= MOST_COLUMNS else "auto"
    if block.tight and columns[0] == "auto":
        columns = ["1fr"] * len(columns)
    write = _symbols if block.tight or not block.small else _escape
    sides = ["right" if nth in block.right else "left" for nth in range(len(block.head))]
    head = ", ".join(f"[*{write(text)}*]" for text in block.head)
    rows = "\n".join("  " + ", ".join(f"[{_breakable(write(text))}]" for text in row) + "," for row in block.rows)
    # the first of a few columns has room to spare for wider gaps
    gutter = "12pt" if len(block.head) <= MOST_COLUMNS else "5pt"
    inset = f", inset: (x: 0pt, y: 2.5pt), column-gutter: {gutter}" if block.tight else ""
    table = (
        f"text(size: {size}, table(columns: ({', '.join(columns)},), align: ({', '.join(sides)},){inset},\n"
        f"  table.header({head}), table.hline(stroke: 0.9pt),\n{_ruled(rows)}\n))"
    )
    if block.tight:
        return f"#block(above: 0.8em, below: 0.4em, strong(text(size: 9pt)[{_symbols(block.caption)}]))\n#{table}"
    unbreakable = "#show figure: set block(breakable: false)\n" if block.short else ""
    return f"#[{unbreakable}#figure(kind: table, caption: [{_escape(block.caption)}], {table})]"


def _ruled(rows: str) -> str:
    return "\n".join(f'{row} table.hline(stroke: 0.3pt + rgb("#bbb")),' for row in rows.split("\n") if row)


def _words(text: "Text") -> str:
    boxes = []
    for piece, bold in pieces(text):
        space = " " * (piece.endswith(" ") and bold)
        boxes.append(f"#box(strong[{_escape(piece.rstrip())}]){space}" if bold else _symbols(piece))
    return "".join(boxes)


def _escape(text: str) -> str:
    """Text without markup: every ASCII symbol is escaped; no line ends inside an option."""
    cleaned = clean(text).replace("\n", " ").replace(" %", "\u00a0%")
    escaped = "".join(
        f"\\{letter}" if letter.isascii() and not letter.isalnum() and letter != " " else letter for letter in cleaned
    )
    return re.sub(r"(?<!\S)(?:\\-){2}\w+(?:\\-\w+)*", r"#box[\g<0>]", escaped)


def _symbols(text: str) -> str:
    """Text with the subscripts of its symbols: a_w."""
    return re.sub(r"(?<![^\W\d_])([^\W\d_])\\_(\w+)", r"\1#sub[\2]", _escape(text))


def _breakable(text: str) -> str:
    """Long words of a table may be broken after a point or an underline."""
    return re.sub(r"(?<=[a-z\]])(\\[._])(?=[a-z])", "\\1\u200b", text)


def _string(text: str) -> str:
    return json.dumps(text, ensure_ascii=False)
