"""A report as a list of blocks, and its two forms: Markdown, and HTML that needs no other file."""

from html import escape as escaped

from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence


@record
class Heading:
    """A heading of a level from 1."""

    level: int
    text: str


@record
class Paragraph:
    """Words."""

    text: str


@record
class Items:
    """A list of words."""

    texts: "Sequence[str]"


@record
class Table:
    """Rows of text under a head; tables are numbered as they come."""

    head: "Sequence[str]"
    rows: "Sequence[Sequence[str]]"
    caption: str


@record
class Code:
    """Text that stands as it is."""

    text: str


@record
class Image:
    """An SVG picture with the words that stand under it; pictures are numbered as they come."""

    svg: bytes
    text: str


Block = Heading | Paragraph | Items | Table | Code | Image

STYLE = (
    "body{font:11pt/1.45 system-ui,sans-serif;max-width:46em;margin:2em auto;padding:0 1em;color:#111}"
    "table{border-collapse:collapse;margin:.6em 0 1em}td,th{border:1px solid #bbb;padding:.2em .6em;text-align:left;"
    "vertical-align:top;overflow-wrap:anywhere}th,td:first-child{overflow-wrap:normal}th{background:#eee}caption,figcaption{text-align:left;font-size:9.5pt;"
    "color:#333;padding:.2em 0}caption{caption-side:top}pre{background:#f6f6f6;padding:.6em;overflow:auto;"
    "font-size:9pt;white-space:pre-wrap;overflow-wrap:anywhere}figure{margin:1em 0}svg{max-width:100%;height:auto}"
    "h2{border-bottom:1px solid #bbb;margin-top:2em}"
    "@page{margin:20mm 18mm;@bottom-right{content:counter(page) ' / ' counter(pages)}}"
    "@media print{body{margin:0;padding:0;max-width:none;font-size:10pt}h2{break-before:page}h2:first-of-type{break-before:auto}h2,h3{break-after:avoid}"
    "tr,figure{break-inside:avoid}thead{display:table-header-group}pre{break-inside:auto}}"
)


# Control characters would command the terminal that shows the report, and half characters cannot be written.
_UNPRINTABLE = {**dict.fromkeys(range(0x20)), 0x09: " ", 0x0A: "\n", **dict.fromkeys(range(0x7F, 0xA0))}


def clean(text: str) -> str:
    """Text without what cannot be printed."""
    return text.translate(_UNPRINTABLE).encode("utf-8", "backslashreplace").decode()


def escape(text: str) -> str:
    """Text as HTML shows it."""
    return escaped(clean(text))


def markdown(blocks: "Sequence[Block]", images: "Sequence[str]") -> str:
    """The report as Markdown; `images` names the pictures' files in order, none where they are left out."""
    names = iter(images)
    parts: list[str] = []
    tables = figures = 0
    for block in blocks:
        if isinstance(block, Heading):
            parts.append(f"{'#' * block.level} {_plain(block.text)}")
        elif isinstance(block, Paragraph):
            parts.append(_plain(block.text))
        elif isinstance(block, Items):
            parts.append("\n".join(f"- {_plain(text)}" for text in block.texts))
        elif isinstance(block, Table):
            tables += 1
            lines = [_row(block.head), "|" + "---|" * len(block.head), *map(_row, block.rows)]
            parts += [f"*Table {tables}. {_plain(block.caption)}*", "\n".join(lines)]
        elif isinstance(block, Code):
            text = clean(block.text)
            fence = "`" * max(3, 1 + _longest_run(text, "`"))
            parts.append(f"{fence}\n{text}\n{fence}")
        elif (name := next(names, "")) != "":
            figures += 1
            words = _plain(block.text)
            parts += [f"![{words}]({name.replace(' ', '%20')})", f"*Figure {figures}. {words}*"]
    return "\n\n".join(parts) + "\n"


def _row(cells: "Sequence[str]") -> str:
    return "| " + " | ".join(_plain(cell) for cell in cells) + " |"


def _plain(text: str) -> str:
    text = clean(text)
    for mark in ("\\", "|", "*", "_", "<", "`", "["):
        text = text.replace(mark, f"\\{mark}")
    return " ".join(text.split())


def _longest_run(text: str, mark: str) -> int:
    longest = run = 0
    for character in text:
        run = run + 1 if character == mark else 0
        longest = max(longest, run)
    return longest


def html(blocks: "Sequence[Block]", title: str) -> str:
    """The report as one HTML file, pictures within it."""
    head = (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width"><meta name="generator" content="dynamics">'
        f"<title>{escape(title)}</title>"
    )
    parts = [f"{head}<style>{STYLE}</style></head><body>"]
    tables = figures = 0
    for nth, block in enumerate(blocks):
        if isinstance(block, Heading):
            parts.append(f"<h{block.level}>{escape(block.text)}</h{block.level}>")
        elif isinstance(block, Paragraph):
            parts.append(f"<p>{escape(block.text)}</p>")
        elif isinstance(block, Items):
            parts.append("<ul>" + "".join(f"<li>{escape(text)}</li>" for text in block.texts) + "</ul>")
        elif isinstance(block, Table):
            tables += 1
            caption = f"<caption>Table {tables}. {escape(block.caption)}</caption>"
            rows = "".join(_cells("td", row) for row in block.rows)
            parts.append(f"<table>{caption}<thead>{_cells('th', block.head)}</thead><tbody>{rows}</tbody></table>")
        elif isinstance(block, Code):
            parts.append(f"<pre>{escape(block.text)}</pre>")
        else:
            figures += 1
            words = escape(block.text)
            caption = f"<figcaption>Figure {figures}. {words}</figcaption>"
            parts.append(f'<figure role="img" aria-label="{words}">{_inline(block.svg, f"p{nth}-")}{caption}</figure>')
    return "\n".join([*parts, "</body></html>"]) + "\n"


def _cells(kind: str, texts: "Sequence[str]") -> str:
    start = '<th scope="col">' if kind == "th" else "<td>"
    return "<tr>" + "".join(f"{start}{escape(text)}</{kind}>" for text in texts) + "</tr>"


def _inline(svg: bytes, prefix: str) -> str:
    """The picture's element, its names made its own: several pictures stand in one page."""
    text = svg.decode()
    text = text[text.index("<svg") :].rstrip()
    return (
        text.replace('id="', f'id="{prefix}').replace("url(#", f"url(#{prefix}").replace('href="#', f'href="#{prefix}')
    )
