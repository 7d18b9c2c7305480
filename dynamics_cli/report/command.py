"""`dynamics report FILE…`: result documents as one Markdown or HTML file, each calculated again from its inputs."""

import os

from dynamics_cli.core.hashes import entry_of
from dynamics_cli.core.loading import DOCUMENT_SCHEMA, decode, read_bytes
from dynamics_cli.core.writing import Beforehand
from dynamics_cli.errors import UsageError
from dynamics_cli.report import FORMS
from dynamics_cli.report.again import Again, calculate
from dynamics_cli.report.blocks import Block, Code, Heading, Image, Items, Paragraph, html, markdown
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
    read = [one for name in words for one in _read(name, terminal)]
    answers = [_again(document, name, families, find, terminal) for name, document, _ in read]
    images = [again.picture is not None for again in answers]
    drawn = _pictures(answers, terminal) if any(images) else {}
    blocks = _blocks(title, read, answers, drawn, digits, families, find)
    if form == "html":
        _write(html(blocks, title), output, [], terminal)
        return
    stem = os.path.splitext(output)[0]
    files = [(f"{stem}-{nth + 1}.svg", svg) for nth, svg in drawn.items()] if output else []
    _write(markdown(blocks, [os.path.basename(name) for name, _ in files]), output, files, terminal)


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
                f"{name!r} holds no result document", code="schema", hint="write one with --json --output FILE"
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


def _blocks(
    title: str,
    read: "list[tuple[str, Document, str]]",
    answers: "list[Again]",
    drawn: "Mapping[int, bytes]",
    digits: int,
    families: "Mapping[str, tuple[str, str]]",
    find: "Callable[[str], Family]",
) -> "list[Block]":
    blocks: list[Block] = [Heading(1, title)]
    lines = [f"{nth}. dynamics {document['command']}" for nth, (_, document, _) in enumerate(read, 1)]
    blocks.append(Items(lines))
    for nth, ((name, document, digest), again) in enumerate(zip(read, answers, strict=True)):
        explained = {**document, "explanation": (again.document or document).get("explanation", {})}
        blocks += section(nth + 1, explained, _summary(document, families, find), digits)
        if nth in drawn:
            blocks.append(Image(drawn[nth], f"Picture of dynamics {document['command']}"))
        shown = "standard input" if name == "-" else os.path.basename(name)
        blocks.append(Paragraph(f"{again.words[:1].upper()}{again.words[1:]}. Read from {shown}, SHA-256:"))
        blocks.append(Code(digest))
    return blocks + embedded([document for _, document, _ in read])


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
