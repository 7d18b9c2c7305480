"""Drawings written to files: the writer for a file name, the file's content, and its entry in the document."""

import os

from dynamics_cli.core.answering.task import load
from dynamics_cli.core.inputs.sources.hashes import entry_of
from dynamics_cli.core.inputs.specification import Leaf, Many
from dynamics_cli.errors import InadmissibleError, UsageError
from dynamics_cli.outlines import Drawing, Outline, Points
from dynamics_cli.pictures import Plan

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.core.answering.task import Task
    from dynamics_cli.core.inputs.specification import Field
    from dynamics_cli.core.output.files import File
    from dynamics_cli.pictures import Spreads

FORMATS = ("dxf", "svg", "csv")
# inspect.CO_VARKEYWORDS, which costs an import
TAKES_KEYWORDS = 8


def write_drawing(drawing: Drawing, name: str, units: str = "si") -> "list[dict[str, Any]]":
    """Write a drawing to a file, whole or not at all; the entries of the files written."""
    from dynamics_cli.core.output.files import Files

    form = _extension(name)
    if form not in FORMATS:
        raise _unknown(name, FORMATS)
    data, entry = _drawn(drawing, form, name, units)
    with Files([(name, data, "drawing")]):
        pass
    return [entry]


def check_asked(task: "Task", name: str, output: str) -> None:
    """Refuse, before anything is calculated, a file that this task cannot write."""
    forms = [*(FORMATS if drawing_fields(task) else ()), *task.writers]
    if not forms:
        hint = task.pointers.get("drawing")
        raise UsageError(f"{task.path} has no drawing", parameter="drawing", code="no-drawing", hint=hint)
    form = _extension(name)
    if form not in forms:
        raise _unknown(name, forms, task.pointers.get("drawing", ""))
    if output and os.path.realpath(output) == os.path.realpath(name):
        raise UsageError(
            "--drawing and --output name the same file", parameter="drawing", code="exclusive", hint="give it two names"
        )
    if form == "dxf":
        from dynamics_cli.core.output.drawing.dxf import need

        need()


def files_of(
    task: "Task",
    record: "Any",
    call_arguments: "tuple[list[Any], dict[str, Any]]",
    name: str,
    units: str,
    spreads: "Spreads | None" = None,
) -> "tuple[list[File], list[dict[str, Any]]]":
    """The files of one case, still to be written, and their entries in the document."""
    form = _extension(name)
    if form in task.writers:
        from dynamics_cli.core.output.plot import with_spreads

        writer = load(task.writers[form])
        code = writer.__code__
        # one of the record alone takes nothing else
        words, options = call_arguments if code.co_argcount > 1 or code.co_flags & TAKES_KEYWORDS else ([], {})
        text = writer(record, *words, **options, **with_spreads(writer, spreads))
        entry: dict[str, Any] = {"written": True}
        if isinstance(text, Plan):
            from dynamics_cli.core.output.drawing.plan import write_plan

            data, entry["holds"] = write_plan(text, form, units)
        else:
            data = text.encode() if isinstance(text, str) else bytes(text)
        entry = {**entry_of(name, data), **entry}
    else:
        data, entry = _drawn(_gathered(task, record), form, name, units)
    return [(name, data, "drawing")], [entry]


def drawing_fields(task: "Task") -> "list[Field]":
    """The results that are drawings."""
    drawings = []
    for field in task.specification.result.fields:
        item = field.node.item if isinstance(field.node, Many) else field.node
        if isinstance(item, Leaf) and item.kind.form == "drawing":
            drawings.append(field)
    return drawings


def _gathered(task: "Task", record: "Any") -> Drawing:
    """Every outline of a record, as one drawing."""
    outlines: list[Outline] = []
    construction: list[Outline] = []
    title = ""
    fields = drawing_fields(task)
    for field in fields:
        value = getattr(record, field.name)
        for outline in value if isinstance(value, tuple | list) else () if value is None else (value,):
            outlines.extend(outline.outlines if isinstance(outline, Drawing) else (outline,))
            construction.extend(getattr(outline, "construction", ()))
            title = title or getattr(outline, "title", "")
    if not outlines:
        names = {field.key for field in fields}
        advice = [item.message for item in getattr(record, "advice", ()) if item.result in names]
        raise InadmissibleError("this case has no drawing", code="no-drawing", hint="; ".join(advice) or None)
    return Drawing(tuple(outlines), title or f"dynamics {task.path}", tuple(construction))


def _drawn(drawing: Drawing, form: str, name: str, units: str) -> "tuple[bytes, dict[str, Any]]":
    from dynamics_cli.core.output.drawing.scaled import FILE_UNITS, quartered, scaled

    unit = FILE_UNITS[units]
    inside = scaled(drawing, unit)
    if form == "dxf":
        from dynamics_cli.core.output.drawing.dxf import write
    elif form == "svg":
        from dynamics_cli.core.output.drawing.svg import write

        inside = quartered(inside)
    else:
        from dynamics_cli.core.output.drawing.table import write
    data = write(inside, unit)
    deviation = {"value": inside.deviation, "unit": unit.name}
    return data, {**entry_of(name, data), "written": True, "holds": _pieces(drawing), "deviation": deviation}


def _pieces(drawing: Drawing) -> str:
    """The pieces of a drawing: "43 arcs, closed"."""
    counts: dict[str, int] = {}
    for outline in drawing.outlines:
        for piece in outline.pieces:
            name = "line" if isinstance(piece, Points) else type(piece).__name__.lower()
            counts[name] = counts.get(name, 0) + (len(piece.points) - 1 if isinstance(piece, Points) else 1)
    pieces = " and ".join(f"{count} {name}{'' if count == 1 else 's'}" for name, count in counts.items())
    outlines = f" in {len(drawing.outlines)} outlines" if len(drawing.outlines) > 1 else ""
    return pieces + outlines + (", closed" if all(outline.closed for outline in drawing.outlines) else "")


def _extension(name: str) -> str:
    return os.path.splitext(name)[1].lower().removeprefix(".")


def _unknown(name: str, known: "list[str] | tuple[str, ...]", pointer: str = "") -> UsageError:
    names = ", ".join(f".{form}" for form in known[:-1]) + (" or " if len(known) > 1 else "") + f".{known[-1]}"
    return UsageError(
        f"read {name!r}, wanted a file that ends in {names}",
        parameter="drawing",
        code="unknown-choice",
        hint=pointer or f"for example: --drawing shape.{known[0]}",
    )
