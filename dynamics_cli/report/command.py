"""`dynamics report FILE…`: result documents as one Markdown or HTML file, each calculated again from its inputs."""

import os

from dynamics_cli.core.hashes import entry_of
from dynamics_cli.core.loading import DOCUMENT_SCHEMA, decode, read_bytes
from dynamics_cli.core.writing import Beforehand
from dynamics_cli.errors import UsageError
from dynamics_cli.report import FORMS
from dynamics_cli.report.again import Again, calculate
from dynamics_cli.report.blocks import Block, Image, Paragraph, html, markdown
from dynamics_cli.report.front import Source, files, front, named
from dynamics_cli.report.sections import embedded, section

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence
    from typing import Any

    from dynamics_cli.core.task import Family
    from dynamics_cli.core.terminal import Terminal
    from dynamics_cli.core.writing import File

    Document = dict[str, Any]

_ENDINGS = {".md": "markdown", ".markdown": "markdown", ".html": "html", ".htm": "html"}


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
    output, form = options.get("output", ""), _form(options)
    digits = _digits(options.get("digits", ""))
    title = options.get("title") or "Calculations"
    sources = named([one for name in words for one in _read(name, terminal)])
    answers = [_again(one.document, one.file, families, find, terminal) for one in sources]
    drawn = _pictures(answers, terminal) if any(again.picture is not None for again in answers) else {}
    blocks = front(title, options.get("case", ""), options.get("author", ""), sources, answers)
    blocks += _sections(sources, answers, drawn, digits, families, find)
    blocks += embedded([one.document for one in sources])
    blocks += files(sources, {one.digest: nth for nth, one in enumerate(sources, 1)})
    if form == "html":
        _write(html(blocks, title), output, [], terminal)
        return
    stem = os.path.splitext(output)[0]
    beside = [(f"{stem}-{nth + 1}.svg", svg) for nth, svg in drawn.items()] if output else []
    _write(markdown(blocks, [os.path.basename(name) for name, _ in beside]), output, beside, terminal)


def _form(options: "Mapping[str, str]") -> str:
    form = options.get("format", "")
    if form and form not in FORMS:
        raise UsageError(f"read {form!r}, wanted one of {', '.join(FORMS)}", parameter="format", code="unknown-choice")
    return form or _ENDINGS.get(os.path.splitext(options.get("output", ""))[1].lower(), FORMS[0])


def _digits(text: str) -> int:
    if text and not (text.isascii() and text.isdigit() and 1 <= int(text) <= 17):
        raise UsageError(f"read {text!r}, wanted 1 to 17 significant digits", parameter="digits")
    return int(text or 6)


def _read(name: str, terminal: "Terminal") -> "list[tuple[str, Document, str]]":
    """The documents in a file, one or (NDJSON) several, each with the file's name and hash."""
    import json

    data = read_bytes(name, terminal)
    text = decode(data, name)
    digest = entry_of(name, data)["sha256"]
    try:
        found = [json.loads(text)]
    except json.JSONDecodeError:
        try:
            found = [json.loads(line) for line in text.splitlines() if line.strip()]
        except json.JSONDecodeError as error:
            raise UsageError(f"{name!r} is not JSON: {error.msg} at line {error.lineno}", code="json") from None
    for document in found:
        if not isinstance(document, dict) or document.get("schema") != DOCUMENT_SCHEMA:
            raise UsageError(
                f"{name!r} holds no result document",
                code="schema",
                hint="write one with --json --output FILE; rows of --rows are none",
            )
    if not found:
        raise UsageError(f"{name!r} is empty", code="json")
    return [(name, document, digest) for document in found]


def _again(
    document: "Document",
    name: str,
    families: "Mapping[str, tuple[str, str]]",
    find: "Callable[[str], Family]",
    terminal: "Terminal",
) -> Again:
    family, _, task = str(document["command"]).partition(" ")
    found = find(family).tasks.get(task) if family in families else None
    if found is None:
        return Again(f"not calculated again: this version has no command {document['command']!r}")
    folder = "" if name == "-" else os.path.dirname(name)
    return calculate(found, document, folder, terminal)


def _pictures(answers: "list[Again]", terminal: "Terminal") -> "dict[int, bytes]":
    """The pictures by the document's place, if they can be drawn."""
    from dynamics_cli.core.plot.pages import draw

    try:
        return {nth: draw(again.picture, "svg", "si") for nth, again in enumerate(answers) if again.picture is not None}
    except UsageError as error:
        terminal.tell(f"dynamics: the report has no pictures: {error.message}\n  {error.hint}\n")
        return {}


def _sections(
    sources: "list[Source]",
    answers: "list[Again]",
    drawn: "Mapping[int, bytes]",
    digits: int,
    families: "Mapping[str, tuple[str, str]]",
    find: "Callable[[str], Family]",
) -> "list[Block]":
    blocks: list[Block] = []
    for nth, (one, again) in enumerate(zip(sources, answers, strict=True)):
        document = one.document
        explained = {**document, "explanation": (again.document or document).get("explanation", {})}
        blocks += section(nth + 1, one.name, explained, _summary(document, families, find), digits)
        if nth in drawn:
            what = again.picture.title if again.picture is not None else ""
            blocks.append(Image(drawn[nth], f"{one.name}: {what or document['command']}"))
        blocks.append(Paragraph(f"{again.words[:1].upper()}{again.words[1:]}."))
    return blocks


def _summary(document: "Document", families: "Mapping[str, tuple[str, str]]", find: "Callable[[str], Family]") -> str:
    family, _, name = str(document["command"]).partition(" ")
    task = find(family).tasks.get(name) if family in families else None
    return task.summary if task is not None else ""


def _write(text: str, output: str, pictures: "list[tuple[str, bytes]]", terminal: "Terminal") -> None:
    if not output:
        terminal.write(text)
        return
    files: list[File] = [(name, data, "output") for name, data in pictures]
    with Beforehand([*files, (output, text.encode(), "output")]):
        pass
