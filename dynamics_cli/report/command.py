"""`dynamics report FILE…`: result documents as one file, each calculated again from its inputs."""

import os
from math import isfinite

from dynamics_cli.core.inputs.settings import named_file
from dynamics_cli.core.inputs.sources.files import READABLE_SCHEMAS, decode, read_bytes
from dynamics_cli.core.inputs.sources.hashes import entry_of
from dynamics_cli.core.output.files import Files
from dynamics_cli.core.output.plot.axes import words as written
from dynamics_cli.core.output.plot.pages import draw
from dynamics_cli.errors import UsageError
from dynamics_cli.pictures import Picture
from dynamics_cli.report import FORMS, PAPERS
from dynamics_cli.report.appendix import appendices
from dynamics_cli.report.blocks import Image, images
from dynamics_cli.report.calculation import Calculation, Source
from dynamics_cli.report.front import description, front, intervals, own_picture
from dynamics_cli.report.html import html
from dynamics_cli.report.markdown import markdown
from dynamics_cli.report.recalculation import Again, calculate, system_of
from dynamics_cli.report.sections import section
from dynamics_cli.report.sheet import file_title, sheets
from dynamics_cli.version import __version__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence
    from typing import Any

    from dynamics_cli.core.answering.task import Family, Task
    from dynamics_cli.core.output.files import File
    from dynamics_cli.core.terminal import Terminal
    from dynamics_cli.report.blocks import Block

    Document = dict[str, Any]

# Inches of the picture on the first page, so that its words are as large as those beside it.
FRONT = 4.6
SMALL = 4.2
# Where the picture stands that takes the whole width of the first page.
ACROSS = -1
_ENDINGS = {".md": "markdown", ".markdown": "markdown", ".html": "html", ".htm": "html", ".pdf": "pdf"}


def carry_out(
    words: "Sequence[str]",
    options: "Mapping[str, str]",
    families: "Mapping[str, tuple[str, str]]",
    find: "Callable[[str], Family]",
    terminal: "Terminal",
) -> None:
    """Write the report of the documents named."""
    if not words:
        hint = "for example: dynamics report skid.json crash.json"
        raise UsageError("no document is named", code="missing", hint=hint)
    output = named_file(options.get("output", ""))
    form, paper = _form(options), options.get("paper", "") or PAPERS[0]
    if paper not in PAPERS:
        raise UsageError(f"read {paper!r}, wanted one of {', '.join(PAPERS)}", parameter="paper", code="unknown-choice")
    if form == "pdf":
        from dynamics_cli.report.typst import need

        need()
        if not output:
            raise UsageError("a PDF is written to a file", parameter="output", hint="for example: --output report.pdf")
    digits = _digits(options.get("digits", ""))
    cases: list[Calculation] = []
    for source in _named([item for name in words for item in _read(name, terminal)]):
        task = _task(source.document, families, find)
        recalculated = _again(source, task, terminal)
        cases.append(Calculation(len(cases) + 1, source, recalculated, task, tuple(cases)))
        cases[-1].digits = digits
    blocks, title = _blocks(cases, options, terminal)
    if form == "pdf":
        from dynamics_cli.report.typst import pdf

        _write(pdf(blocks, title, options.get("author", ""), paper), output, [])
    elif form == "html":
        _put(html(blocks, title), output, [], terminal)
    else:
        stem = os.path.splitext(output)[0]
        beside = [(f"{stem}-{nth}.svg", item.svg) for nth, item in enumerate(images(blocks), 1)] if output else []
        _put(markdown(blocks, [os.path.basename(name) for name, _ in beside]), output, beside, terminal)


def _blocks(
    cases: "list[Calculation]", options: "Mapping[str, str]", terminal: "Terminal"
) -> "tuple[list[Block], str]":
    """The report and its title: data sheets where every result has one, else sections and appendices."""
    given_title = options.get("title", "")
    if "full" not in options and all(case.again.sheet is not None for case in cases):
        try:
            return sheets(cases, given_title, _facts(options)), given_title or file_title(cases)
        except UsageError as error:
            if error.code != "not-installed":
                raise
    title = given_title or (cases[0].about if len(cases) == 1 else "Calculations")
    pictures = _drawn(cases, terminal)
    blocks = front(title, _facts(options), cases, pictures.pop(0, []), pictures.pop(ACROSS, []))
    for case in cases:
        blocks += section(case, pictures.get(case.section, ()))
    return [*blocks, *appendices(cases)], title


def _facts(options: "Mapping[str, str]") -> "list[str]":
    """The lines of the title block."""
    from datetime import date

    day = options.get("date", "")
    if not day:
        today = date.today()
        day = f"{today.day} {today:%B} {today.year}"
    named = [
        f"{word}: {options[key]}" for word, key in (("Case", "case"), ("Prepared by", "author")) if options.get(key)
    ]
    return [*named, day, f"dynamics {__version__}"]


def _named(read: "Sequence[tuple[str, Document, str]]") -> "list[Source]":
    """The documents with names for their sections: their files', numbered where a file holds several."""
    named = []
    for nth, (file, document, digest) in enumerate(read):
        stem = "standard input" if file == "-" else os.path.splitext(os.path.basename(file))[0]
        same = [other for other, (name, _, _) in enumerate(read) if name == file]
        named.append(Source(file, document, digest, stem if len(same) == 1 else f"{stem} {same.index(nth) + 1}"))
    return named


def _task(
    document: "Document", families: "Mapping[str, tuple[str, str]]", find: "Callable[[str], Family]"
) -> "Task | None":
    family, _, name = document["command"].partition(" ")
    return find(family).tasks.get(name) if family in families else None


def _again(source: Source, task: "Task | None", terminal: "Terminal") -> Again:
    if task is None:
        return Again(f"not calculated again: this version has no command {source.document['command']!r}")
    folder = "" if source.file == "-" else os.path.dirname(source.file)
    return calculate(task, source.document, folder, terminal)


def _drawn(cases: "Sequence[Calculation]", terminal: "Terminal") -> "dict[int, list[Image]]":
    """The pictures of each section, and of the first page (0) one of them and the intervals of the findings.

    Without the drawing library there are none.
    """
    pictured = [(case, picture) for case in cases if (picture := own_picture(case)) is not None]
    chosen = next((pair for pair in pictured if pair[1].scene), pictured[-1] if pictured else None)
    images: dict[int, list[Image]] = {}
    try:
        for case, picture in pictured:
            # columns side by side need the whole width of their section
            narrow = picture.scene or min(picture.columns, len(picture.panels)) == 1
            front = narrow and chosen is not None and case is chosen[0]
            first, rest = picture.panels, picture.panels
            if front:
                first, rest = (first[:1], rest[1:]) if picture.scene else (first, ())
                # in a wide scene drawn small beside the findings, labels would overlap
                wide = picture.scene and first[0].wide
                front_picture = Picture(first, "", picture.columns, width=picture.width if wide else FRONT)
                images[ACROSS if wide else 0] = [_image(case, picture, front_picture, 1.0)]
            if rest:
                columns = min(picture.columns, len(rest))
                width = SMALL if columns == 1 else 0.0
                part = Picture(rest, "", columns, width=width)
                images[case.section] = [_image(case, picture, part, 0.36 if width else 0.85)]
        spread = intervals(cases, FRONT)
        if spread is not None:
            image = Image(draw(spread, "svg", "si"), "Results with intervals and limits", description(spread, "si"))
            images.setdefault(0, []).append(image)
    except UsageError as error:
        terminal.tell(f"dynamics: the report has no pictures: {error.message}\n  {error.hint}\n")
        return {}
    return images


def _image(case: Calculation, picture: Picture, part: Picture, width: float) -> Image:
    system = system_of(case.source.document)
    title = written(picture.title, system).replace("\n", "; ") or case.source.document["command"]
    text = f"Section {case.section}, {case.name}: {title}"
    return Image(draw(part, "svg", system), text, description(part, system), width)


def _form(options: "Mapping[str, str]") -> str:
    form, ending = options.get("format", ""), os.path.splitext(options.get("output", ""))[1].lower()
    if form and form not in FORMS:
        raise UsageError(f"read {form!r}, wanted one of {', '.join(FORMS)}", parameter="format", code="unknown-choice")
    if ending and not form and ending not in _ENDINGS:
        hint = "endings are .md .html .pdf; --format writes one of these under any name"
        raise UsageError(f"a report cannot be written as {ending}", parameter="output", code="format", hint=hint)
    return form or _ENDINGS.get(ending, FORMS[0])


def _digits(text: str) -> int:
    if text and not (text.isascii() and text.isdigit() and 1 <= int(text) <= 17):
        raise UsageError(f"read {text!r}, wanted 1 to 17 significant digits", parameter="digits")
    return int(text or 6)


def _read(name: str, terminal: "Terminal") -> "list[tuple[str, Document, str]]":
    """The documents in a file, one or (NDJSON) several, each with the file's name and hash."""
    data = read_bytes(name, terminal)
    text = decode(data, name)
    digest = entry_of(name, data)["sha256"]
    try:
        documents = [_parsed(text)]
    except ValueError:
        try:
            documents = [_parsed(line) for line in text.split("\n") if line.strip()]
        except ValueError as error:
            hint = "a report gathers results: write them with --json --output FILE"
            raise UsageError(f"{name!r} is not JSON: {error}", code="json", hint=hint) from None
    for document in documents:
        if not _is_document(document):
            raise UsageError(
                f"{name!r} holds no result document",
                code="schema",
                hint="write one with --json --output FILE",
            )
    if not documents:
        raise UsageError(f"{name!r} is empty", code="json")
    return [(name, document, digest) for document in documents]


def _parsed(text: str) -> "Any":
    import json

    def finite(number: str) -> float:
        if not isfinite(float(number)):
            raise ValueError(f"{number[:20]} is not a finite number")
        return float(number)

    return json.loads(text, parse_float=finite, parse_constant=finite)


def _is_document(document: "Any") -> bool:
    return (
        isinstance(document, dict)
        and document.get("schema") in READABLE_SCHEMAS
        and isinstance(document.get("command"), str)
        and all(isinstance(document.get(part), dict) for part in ("inputs", "results"))
    )


def _put(text: str, output: str, pictures: "list[tuple[str, bytes]]", terminal: "Terminal") -> None:
    if output:
        _write(text.encode(), output, pictures)
    else:
        terminal.write(text)


def _write(data: bytes, output: str, pictures: "list[tuple[str, bytes]]") -> None:
    files: list[File] = [(name, picture, "output") for name, picture in pictures]
    with Files([*files, (output, data, "output")]):
        pass
