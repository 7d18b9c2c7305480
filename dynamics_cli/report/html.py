"""A report as one HTML file that needs no other: pictures, formulas and a style sheet for screen and print in it."""

from html import escape as escaped

from dynamics_cli.report.blocks import (
    SUBSCRIPT,
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
from dynamics_cli.report.formula import mathml

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from dynamics_cli.report.blocks import Block, Text

# The paper is the reader's, A4 or Letter: margins and breaks suit both.
STYLE = (
    ":root{color-scheme:light}"
    "body{font:10.5pt/1.42 Georgia,'DejaVu Serif',serif;max-width:50rem;margin:2rem auto;padding:0 1rem;"
    "color:#1a1a1a;background:#fff}"
    "header,h1,h2,h3,table,figcaption,.small,.findings h2{font-family:'Segoe UI','DejaVu Sans',Arial,sans-serif}"
    "header{display:flex;flex-wrap:wrap;gap:.3rem 2rem;align-items:end;justify-content:space-between;"
    "border-bottom:2px solid #1a1a1a;padding-bottom:.5rem;margin-bottom:1rem}"
    "h1{font-size:20pt;line-height:1.15;margin:0;flex:1 1 60%}"
    "header ul{list-style:none;margin:0;padding:0;font-size:8.5pt;color:#444;text-align:right}"
    "h2{font-size:13pt;margin:1.5rem 0 .3rem}h3{font-size:10.5pt;margin:1rem 0 .2rem}p{margin:.35rem 0}"
    "ol,ul{padding-left:1.4rem;margin:.35rem 0}li{margin:.25rem 0}"
    ".small{font-size:8.5pt;line-height:1.4;color:#444}"
    ".beside{display:grid;grid-template-columns:minmax(0,11fr) minmax(0,9fr);gap:1.4rem;align-items:start}"
    ".beside h2:first-child{margin-top:0}strong{white-space:nowrap}"
    "table{border-collapse:collapse;min-width:50%;margin:.5rem 0 .8rem;font-size:8.5pt;line-height:1.3}"
    "td,th{border-bottom:1px solid #ccc;padding:.2em 1.1em .2em 0;text-align:left;vertical-align:top;"
    "overflow-wrap:anywhere;font-weight:normal}"
    "thead th{border-bottom:1.5px solid #1a1a1a;font-weight:bold;overflow-wrap:normal}"
    "tbody th{overflow-wrap:normal}.number{text-align:right;overflow-wrap:normal;white-space:nowrap}"
    "table.dense{font-size:7pt}"
    "caption,figcaption{caption-side:top;text-align:left;font-size:8pt;color:#444;padding:.1rem 0}"
    "pre{background:#f4f4f4;padding:.5em;font-size:7.5pt;line-height:1.3;white-space:pre-wrap;"
    "overflow-wrap:anywhere}figure{margin:.4rem 0}figure svg{width:100%;height:auto}"
    "sub{line-height:0;font-size:.75em}.page{break-before:page}table.tight{width:100%;margin:.2rem 0 .3rem}"
    ".tight td,.tight th{padding:.1em 0 .1em .6em}"
    ".tight tr>:first-child{padding-left:0}.tight caption{font-weight:bold;color:#1a1a1a;font-size:8.5pt}"
    ".dense td:nth-child(3){white-space:nowrap;overflow-wrap:normal}"
    "math{font-size:11.5pt;margin:.5rem 0;"
    "font-family:'Cambria Math','STIX Two Math','STIX Math',STIX,'Latin Modern Math',math}"
    "@page{margin:11mm 16mm 14mm;@bottom-right{content:'page ' counter(page) ' of ' counter(pages);"
    "font:8pt sans-serif}}@media (max-width:40rem){.beside{display:block}}"
    "@media print{h1{font-size:15pt}header{margin-bottom:.5rem}"
    "body{margin:0;padding:0;max-width:none;font-size:9pt;line-height:1.35}"
    ".small{font-size:7.5pt}table{font-size:7.5pt}table.dense{font-size:5.8pt}table.dense.tight{font-size:6.5pt}"
    "pre{font-size:6.2pt;columns:2;column-gap:1.5em}"
    "math{font-size:10pt;margin:.3rem 0}.dense td,.dense th{padding:.1em .8em .1em 0}h2{margin-top:1rem}"
    "h2,h3,caption{break-after:avoid}tr,figure,math,header,li,table.short{break-inside:avoid}"
    "thead{display:table-header-group}p{orphans:3;widows:3}}"
)


def html(blocks: "Sequence[Block]", title: str) -> str:
    """The report as one HTML file."""
    head = (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width"><meta name="generator" content="dynamics">'
        f"<title>{_escape(title)}</title>"
    )
    body = "\n".join(_Writer().parts(blocks))
    return f"{head}<style>{STYLE}</style></head><body>\n{body}\n</body></html>\n"


class _Writer:
    """Counts tables and figures."""

    def __init__(self) -> None:
        self.tables = self.figures = 0

    def parts(self, blocks: "Sequence[Block]") -> "list[str]":
        """The text of each block, in order."""
        return [self._block(block) for block in blocks]

    def _block(self, block: "Block") -> str:
        if isinstance(block, Title):
            facts = "".join(f"<li>{_escape(fact)}</li>" for fact in block.facts)
            return f"<header><h1>{_escape(block.text)}</h1><ul>{facts}</ul></header>"
        if isinstance(block, Heading):
            return f"<h{block.level}>{_escape(block.text)}</h{block.level}>"
        if isinstance(block, Paragraph):
            return f'<p class="small">{_words(block.text)}</p>' if block.small else f"<p>{_words(block.text)}</p>"
        if isinstance(block, Items):
            tag = "ol" if block.ordered else "ul"
            return f"<{tag}>" + "".join(f"<li>{_words(text)}</li>" for text in block.texts) + f"</{tag}>"
        if isinstance(block, Table):
            return self._table(block)
        if isinstance(block, Formula):
            return mathml(clean(block.text))
        if isinstance(block, Code):
            return f"<pre>{_escape(block.text)}</pre>"
        if isinstance(block, Break):
            return '<div class="page"></div>'
        if isinstance(block, Beside):
            sides = ["".join(self.parts(side)) for side in (block.left, block.right)]
            return '<div class="beside">' + "".join(f"<div>{side}</div>" for side in sides) + "</div>"
        return self._image(block)

    def _table(self, block: Table) -> str:
        self.tables += not block.tight
        number = "" if block.tight else f"Table {self.tables}. "
        caption = f"<caption>{number}{_symbols(block.caption)}</caption>"
        write = _symbols if block.tight or not block.small else _escape
        head = "".join(f'<th scope="col"{_side(block, nth)}>{write(text)}</th>' for nth, text in enumerate(block.head))
        rows = "".join(f"<tr>{_cells(block, row)}</tr>" for row in block.rows)
        classes = " ".join(["dense"] * block.small + ["tight"] * block.tight + ["short"] * block.short)
        kind = f' class="{classes}"' if classes else ""
        return f"<table{kind}>{caption}<thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>"

    def _image(self, block: Image) -> str:
        self.figures += 1
        caption = f"<figcaption>Figure {self.figures}. {_escape(block.text)}</figcaption>"
        style = f' style="max-width:{100.0 * block.width:.0f}%"' if block.width < 1.0 else ""
        svg = _inline(block.svg, f"p{self.figures}-", _escape(block.description))
        return f"<figure{style}>{svg}{caption}</figure>"


def _cells(block: Table, row: "Sequence[str]") -> str:
    write = _symbols if block.tight or not block.small else _escape
    first = f'<th scope="row"{_side(block, 0)}>{write(row[0])}</th>' if row else ""
    return first + "".join(f"<td{_side(block, nth)}>{write(text)}</td>" for nth, text in enumerate(row[1:], 1))


def _side(block: Table, column: int) -> str:
    return ' class="number"' if column in block.right else ""


def _words(text: "Text") -> str:
    return "".join(f"<strong>{_escape(piece)}</strong>" if bold else _symbols(piece) for piece, bold in pieces(text))


def _symbols(text: str) -> str:
    """Text with the subscripts of its symbols: a_w."""
    return SUBSCRIPT.sub(r"\1<sub>\2</sub>", _escape(text))


def _escape(text: str) -> str:
    return escaped(clean(text)).replace(" %", "\u00a0%")


def _inline(svg: bytes, prefix: str, description: str) -> str:
    """The picture's element with its description; its identifiers are made unique within the page."""
    text = svg.decode()
    text = text[text.index("<svg") :].rstrip()
    text = (
        text.replace('id="', f'id="{prefix}').replace("url(#", f"url(#{prefix}").replace('href="#', f'href="#{prefix}')
    )
    return text.replace("<svg", f'<svg role="img" aria-label="{description}"', 1)
