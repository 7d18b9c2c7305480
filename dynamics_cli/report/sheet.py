"""A data sheet: one result on one page in its task's layout, with model, source and checks at the foot."""

import os
from math import floor, isfinite, log10

from dynamics_cli.core.output.plot.axes import Scale, words
from dynamics_cli.core.output.plot.pages import draw
from dynamics_cli.pictures import Listing, Picture
from dynamics_cli.report.blocks import Beside, Break, Heading, Image, Paragraph, Table, Title
from dynamics_cli.report.front import description
from dynamics_cli.report.recalculation import system_of
from dynamics_cli.report.sections import basis, warnings_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from dynamics_cli.report.blocks import Block
    from dynamics_cli.report.calculation import Calculation

# A table of more columns than this is set small.
MOST_COLUMNS = 5
# Digits of the largest number of a column, and decimals at most.
DIGITS, MOST_PLACES = 5, 5


def sheets(cases: "Sequence[Calculation]", title: str, facts: "Sequence[str]") -> "list[Block]":
    """A page for each calculation; the first carries the title block."""
    blocks: list[Block] = []
    for case in cases:
        sheet = case.again.sheet
        assert sheet is not None
        system = system_of(case.source.document)
        name = words(sheet.title, system)
        if case.section == 1:
            blocks.append(Title(title or name, facts))
            blocks += [Heading(2, name)] if title else []
        else:
            blocks += [Break(), Heading(2, name)]
        blocks.append(Paragraph(words(sheet.subtitle, system), small=True))
        blocks.append(Beside(_parts(sheet.left, system), _parts(sheet.right, system)))
        blocks += [*_parts(sheet.foot, system), *_foot(case)]
    return blocks


def file_title(cases: "Sequence[Calculation]") -> str:
    """The title of a file of data sheets without a given title."""
    sheet = cases[0].again.sheet
    assert sheet is not None
    return words(sheet.title, system_of(cases[0].source.document))


def _parts(parts: "Sequence[Picture | Listing]", system: str) -> "list[Block]":
    blocks: list[Block] = []
    for part in parts:
        if isinstance(part, Listing):
            blocks.append(_table(part, system))
        else:
            untitled = Picture(part.panels, "", part.columns, width=part.width)
            text = words(part.title, system)
            svg = draw(untitled, "svg", system)
            caption = f"{text}. {description(untitled, system)}"
            blocks.append(Image(svg, text[:1].upper() + text[1:], caption, min(1.0, _inches(svg) / part.width)))
    return blocks


def _inches(svg: bytes) -> float:
    """Width of a picture; one without axes is cropped to its content."""
    return float(svg.partition(b' width="')[2].partition(b"pt")[0]) / 72.0


def _table(part: Listing, system: str) -> Table:
    """A listing as a table; numbers of one column have the same decimals."""
    head: list[str] = []
    columns: list[list[str]] = []
    for top, cells in zip(part.head, zip(*part.rows, strict=True), strict=True):
        if isinstance(top, str):
            head.append(top)
            columns.append([words(cell, system) for cell in cells])
        else:
            scale = Scale(top, system)
            head.append(scale.label)
            columns.append(_decimals(scale([float(cell) for cell in cells])))
    rows = list(zip(*columns, strict=True))
    right = range(2 if isinstance(part.head[0], str) else 0, len(head))
    return Table(head, rows, part.title, tuple(right), small=len(head) > MOST_COLUMNS, tight=True)


def _decimals(values: "Sequence[float]") -> "list[str]":
    """Numbers with as many decimals as give the largest so many digits."""
    largest = max((abs(value) for value in values if isfinite(value)), default=0.0)
    places = min(MOST_PLACES, max(0, DIGITS - 1 - floor(log10(largest)))) if largest else 0
    while places and all(round(value, places) == round(value, places - 1) for value in values if isfinite(value)):
        places -= 1
    return [f"{round(value, places) + 0.0:.{places}f}" if isfinite(value) else "–" for value in values]


def _foot(case: "Calculation") -> "list[Block]":
    """Warnings, model and source, and whether the numbers were calculated here."""
    assert case.document is not None
    name = "standard input" if case.source.file == "-" else os.path.basename(case.source.file)
    comparison = "Calculated again: the same" if case.again.same else f"Not the same: {case.again.words}"
    proof = f"{name}, SHA-256 {case.source.digest[:16]}…: dynamics report --full gives every number, bound and formula."
    warnings = [Paragraph(text, small=True) for items in warnings_of(case.document) for text in items.texts]
    return [*warnings, Paragraph(f"{basis(case)} {comparison}. {proof}", small=True)]
