"""A call carried out: gathered, read, answered, shown. The one path behind the direct route, typer and `run`."""

from dynamics_cli.core.answer import answer, arguments, call_model
from dynamics_cli.core.call import Call, Settings
from dynamics_cli.core.document import build
from dynamics_cli.core.gather import Gathered, gather
from dynamics_cli.core.shown import Display
from dynamics_cli.core.task import Task, load
from dynamics_cli.errors import ExitStatus, FaultError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.core.bound import Fields
    from dynamics_cli.core.terminal import Terminal
    from dynamics_cli.core.writing import File
    from dynamics_cli.pictures import Picture


def execute(task: Task, call: Call, terminal: "Terminal") -> int:
    """Answer a call on standard output or in a file; the exit status."""
    settings = Settings(call.settings, terminal.environ)
    if settings.rows:
        from dynamics_cli.core.stream import run_rows

        return run_rows(task, call, settings, terminal)
    gathered = gather(task, call, settings, terminal)
    _check_files(task, settings)
    status = ExitStatus.DONE
    if settings.sweep:
        from dynamics_cli.core.sweep import sweep

        document, failed = sweep(task, gathered, settings)
        status = ExitStatus.SOME_FAILED if failed else ExitStatus.DONE
        table = "sweep"
        files, picture = _with_picture(document, [], _picture_of_sweep(document, settings), settings, task)
    else:
        document, files, picture = answered_case(task, gathered, settings)
        table = task.table
    if files:
        from dynamics_cli.core.writing import Beforehand

        with Beforehand(files):
            _write(document, settings, terminal, task, table)
            terminal.flush()
    else:
        _write(document, settings, terminal, task, table)
    if picture is not None and settings.plot == "-":
        from dynamics_cli.core.plot import show_small

        show_small(picture, settings, terminal)
    if task.verdict and not all(check["passed"] for check in document["checks"]):
        return ExitStatus.FAULT
    return status


def document_of(task: Task, gathered: Gathered, settings: Settings) -> "dict[str, Any]":
    """The result document of one case, its files written."""
    _check_files(task, settings)
    document, files, _ = answered_case(task, gathered, settings)
    if files:
        from dynamics_cli.core.writing import Beforehand

        with Beforehand(files):
            pass
    return document


def answered_case(
    task: Task, gathered: Gathered, settings: Settings
) -> "tuple[dict[str, Any], list[File], Picture | None]":
    """The result document of one case, the files it lists that are still to be written, and the picture asked for."""
    reader = gathered.reader
    reader.uncertain = {}
    bound = reader.read(task.specification.fields, gathered.raw)
    start = _clock() if settings.timing else 0.0
    answered = answer(task, bound, settings.model)
    took = _clock() - start if settings.timing else 0.0
    display = Display(settings.units, settings.to)
    document = build(task, bound, answered, display, gathered.reader.notes)
    for check in document["checks"]:
        if not check["passed"] and not task.verdict:
            raise FaultError(
                f"our own check failed: {check['name']} ({check.get('value')} against {check.get('tolerance')})",
                code="check",
                hint="this is a bug: please report it with the inputs",
            )
    spread: Picture | None = None
    if reader.uncertain or settings.correlate:
        from dynamics_cli.core.uncertain.document import add_uncertainty

        start = _clock() if settings.timing else 0.0
        spread = add_uncertainty(document, task, bound, answered, reader, settings, display)
        took += _clock() - start if settings.timing else 0.0
    elif settings.limit:
        from dynamics_cli.core.limits import add_limits

        add_limits(document, task, bound, answered, settings, display)
    if gathered.reader.files:
        from dynamics_cli.core.hashes import once

        document["files"] = once(gathered.reader.files)
    if settings.method and not reader.uncertain:
        from dynamics_cli.core.uncertain.document import read_method

        # Nothing is propagated, but a name that is none is still a wrong call.
        read_method(settings.method)
    if settings.explain:
        from dynamics_cli.core.explain import explanation

        document["explanation"] = explanation(task, document, answered)
    if settings.timing:
        document["timing"] = {"value": took, "unit": "s"}
    if not settings.drawing and not settings.plot:
        return document, [], None
    # writers and pictures take plain numbers
    record = call_model(task, answered.model, bound) if task.tracked else answered.record
    files: list[File] = []
    if settings.drawing:
        from dynamics_cli.core.drawing import files_of

        files, entries = files_of(task, record, arguments(task, bound), settings.drawing, settings.units)
        document["files"] = [*document.get("files", ()), *entries]
    own = _own_picture(task, record, bound) if settings.plot else None
    return document, *_with_picture(document, files, _joined(own, spread), settings, task)


def _check_files(task: Task, settings: Settings) -> None:
    """Refuse, before anything is calculated, files that cannot be written."""
    if settings.drawing:
        from dynamics_cli.core.drawing import check_asked

        check_asked(task, settings.drawing, settings.output)
    if settings.plot:
        from dynamics_cli.core.plot import check_asked as check_picture

        check_picture(task, settings)


def _own_picture(task: Task, record: "Any", bound: "Fields") -> "Picture | None":
    from dynamics_cli.core.plot import own_picture

    return own_picture(task, record, arguments(task, bound))


def _joined(one: "Picture | None", other: "Picture | None") -> "Picture | None":
    """The panels of both pictures under the first one's title."""
    if one is None or other is None:
        return one or other
    from dynamics_cli.pictures import Picture

    return Picture((*one.panels, *other.panels), one.title, one.columns)


def _picture_of_sweep(document: "dict[str, Any]", settings: Settings) -> "Picture | None":
    if not settings.plot:
        return None
    from dynamics_cli.core.plot.made import of_sweep

    return of_sweep(document)


def _with_picture(
    document: "dict[str, Any]", files: "list[File]", picture: "Picture | None", settings: Settings, task: Task
) -> "tuple[list[File], Picture | None]":
    """The files with the picture's among them, which the document then lists."""
    if not settings.plot:
        return files, None
    from dynamics_cli.core.plot import drawn, refuse_none

    if picture is None:
        raise refuse_none(task)
    if settings.plot == "-":
        return files, picture
    data, entry = drawn(picture, settings)
    document["files"] = [*document.get("files", ()), entry]
    return [*files, (settings.plot, data, "plot")], picture


def _clock() -> float:
    from time import perf_counter

    return perf_counter()


def _write(document: "dict[str, Any]", settings: Settings, terminal: "Terminal", task: Task, table: str) -> None:
    from dynamics_cli.core.render import render, to_table

    digits = settings.digits or task.digits
    if task.layout and settings.format == "table" and table != "sweep":
        width = 0 if settings.output else terminal.columns
        layout = load(task.layout)
        text = to_table(document, digits, lambda results: layout(results, digits, width))
    else:
        text = render(document, settings.format, digits, table)
    if settings.output:
        from dynamics_cli.core.writing import WholeFile

        with WholeFile(settings.output) as file:
            file.write(text.encode())
    else:
        terminal.write(text)
