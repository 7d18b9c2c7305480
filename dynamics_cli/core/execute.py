"""A call carried out: gathered, read, answered, shown. The one path behind the direct route, typer and `run`."""

from dynamics_cli.core.answer import answer, call_model
from dynamics_cli.core.call import Call, Settings
from dynamics_cli.core.document import build
from dynamics_cli.core.gather import Gathered, gather
from dynamics_cli.core.shown import Display
from dynamics_cli.core.task import Task
from dynamics_cli.errors import ExitStatus, FaultError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.core.drawing import File
    from dynamics_cli.core.terminal import Terminal


def execute(task: Task, call: Call, terminal: "Terminal") -> int:
    """Answer a call on standard output or in a file; the exit status."""
    settings = Settings(call.settings, terminal.environ)
    if settings.rows:
        from dynamics_cli.core.stream import run_rows

        return run_rows(task, call, settings, terminal)
    gathered = gather(task, call, settings, terminal)
    status = ExitStatus.DONE
    files: list[File] = []
    if settings.sweep:
        from dynamics_cli.core.sweep import sweep

        document, failed = sweep(task, gathered, settings)
        status = ExitStatus.SOME_FAILED if failed else ExitStatus.DONE
        table = "sweep"
    else:
        document, files = _answered(task, gathered, settings)
        table = task.table
    if not files:
        _write(document, settings, terminal, task, table)
        return status
    from dynamics_cli.core.writing import Beforehand

    with Beforehand(files, "drawing"):
        _write(document, settings, terminal, task, table)
        terminal.flush()
    return status


def document_of(task: Task, gathered: Gathered, settings: Settings) -> "dict[str, Any]":
    """The result document of one case, its files written."""
    document, files = _answered(task, gathered, settings)
    if files:
        from dynamics_cli.core.writing import Beforehand

        with Beforehand(files, "drawing"):
            pass
    return document


def _answered(task: Task, gathered: Gathered, settings: Settings) -> "tuple[dict[str, Any], list[File]]":
    """The result document of one case, and the files it lists that are still to be written."""
    if settings.drawing:
        from dynamics_cli.core.drawing import check_asked

        check_asked(task, settings.drawing, settings.output)
    reader = gathered.reader
    reader.uncertain = {}
    bound = reader.read(task.specification.fields, gathered.raw)
    start = _clock() if settings.timing else 0.0
    answered = answer(task, bound, settings.model)
    took = _clock() - start if settings.timing else 0.0
    display = Display(settings.units, settings.to)
    document = build(task, bound, answered, display, gathered.reader.notes)
    for check in document["checks"]:
        if not check["passed"]:
            raise FaultError(
                f"our own check failed: {check['name']} ({check.get('value')} against {check.get('tolerance')})",
                code="check",
                hint="this is a bug: please report it with the inputs",
            )
    if reader.uncertain or settings.correlate:
        from dynamics_cli.core.uncertain.document import add_uncertainty

        start = _clock() if settings.timing else 0.0
        add_uncertainty(document, task, bound, answered, reader.uncertain, settings, display)
        took += _clock() - start if settings.timing else 0.0
    elif settings.limit:
        from dynamics_cli.core.limits import add_limits

        add_limits(document, task, bound, answered, settings, display)
    if gathered.reader.files:
        from dynamics_cli.core.hashes import once

        document["files"] = once(gathered.reader.files)
    if settings.explain:
        from dynamics_cli.core.explain import explanation

        document["explanation"] = explanation(task, document, answered)
    if settings.timing:
        document["timing"] = {"value": took, "unit": "s"}
    if not settings.drawing:
        return document, []
    from dynamics_cli.core.drawing import files_of

    # writers take plain numbers
    record = call_model(task, answered.model, bound) if task.tracked else answered.record
    files, entries = files_of(task, record, settings.drawing, settings.units)
    document["files"] = [*document.get("files", ()), *entries]
    return document, files


def _clock() -> float:
    from time import perf_counter

    return perf_counter()


def _write(document: "dict[str, Any]", settings: Settings, terminal: "Terminal", task: Task, table: str) -> None:
    from dynamics_cli.core.render import render

    digits = settings.digits or task.digits
    text = render(document, settings.format, digits, table)
    if settings.output:
        from dynamics_cli.core.writing import WholeFile

        with WholeFile(settings.output) as file:
            file.write(text.encode())
    else:
        terminal.write(text)
