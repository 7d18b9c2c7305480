"""Execution of a call: gather, read, answer, show. The one path behind the direct route, typer and `run`."""

from dynamics_cli.core.answering.gather import Gathered, gather
from dynamics_cli.core.answering.models import answer, arguments, call_model
from dynamics_cli.core.answering.task import Task, load
from dynamics_cli.core.inputs.settings import Call, Settings
from dynamics_cli.core.output.document import build
from dynamics_cli.core.terminal import encoded, painted_answer
from dynamics_cli.core.units.display import Display
from dynamics_cli.errors import ExitStatus, FaultError, InadmissibleError, UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any

    from dynamics_cli.core.answering.models import Answer
    from dynamics_cli.core.inputs.values import Fields
    from dynamics_cli.core.output.files import File
    from dynamics_cli.core.terminal import Terminal
    from dynamics_cli.pictures import Picture, Spreads


def execute(task: Task, call: Call, terminal: "Terminal") -> int:
    """Answer a call on standard output or in a file; the exit status."""
    if call.settings.get("template"):
        return _write_template(task, terminal)
    settings = Settings(call.settings, terminal.environ)
    if settings.time_limit:
        from dynamics_cli.core.deadline import within

        return within(settings.time_limit, lambda: _execute(task, call, settings, terminal))  # type: ignore[no-any-return]
    return _execute(task, call, settings, terminal)


def _write_template(task: Task, terminal: "Terminal") -> int:
    from dynamics_cli.core.command.template import takes_scene, template

    if not takes_scene(task):
        hint = f"dynamics {task.path} --help"
        raise UsageError(f"{task.path} takes words, which no file holds", parameter="template", hint=hint)
    terminal.write(template(task))
    return ExitStatus.DONE


def _execute(task: Task, call: Call, settings: Settings, terminal: "Terminal") -> int:
    if settings.columns:
        from dynamics_cli.core.batch.cleaning import clean_columns

        return clean_columns(task, call, settings, terminal)
    if settings.rows:
        from dynamics_cli.core.batch.stream import run_rows

        return run_rows(task, call, settings, terminal)
    gathered = gather(task, call, settings, terminal)
    _check_files(task, settings)
    if terminal.shows_progress:
        _show_progress(terminal)
    status = ExitStatus.DONE
    if settings.sweep:
        from dynamics_cli.core.batch.sweep import sweep

        document, failed = sweep(task, gathered, settings)
        status = ExitStatus.SOME_FAILED if failed else ExitStatus.DONE
        table = "sweep"
        files, picture = _with_picture(document, [], _picture_of_sweep(document, settings, task), settings, task)
    else:
        document, files, picture = answered_case(task, gathered, settings)
        table = task.table
    if settings.time_limit:
        from dynamics_cli.core.deadline import stop

        stop()
        if any(warning["code"] == "time-limit" for warning in document["warnings"]):
            status = ExitStatus.INADMISSIBLE
    text = _text(document, settings, terminal, task, table)
    if files or settings.output:
        from dynamics_cli.core.output.files import Files

        output_file = [(settings.output, encoded(text), "output")] if settings.output else []
        with Files([*files, *output_file]):
            if not output_file:
                terminal.write(text)
                terminal.flush()
    else:
        terminal.write(text)
    if picture is not None and settings.plot == "-":
        from dynamics_cli.core.output.plot import show_small

        show_small(picture, settings, terminal)
    if task.verdict and not all(check["passed"] for check in document["checks"]):
        return ExitStatus.FAULT
    return status or _verdict(document, settings)


def _show_progress(terminal: "Terminal") -> None:
    """A bar for a calculation that says how far it is."""
    from dynamics_cli.progress import Going, show

    def counted(size: float, noun: str) -> Going:
        from dynamics_cli.core.batch.rows.progress import Counted

        return Counted(size, noun, terminal)

    show(counted)


def document_of(task: Task, gathered: Gathered, settings: Settings) -> "dict[str, Any]":
    """The result document of one case, or of a sweep, its files written."""
    from dynamics_cli.core.deadline import within

    _check_files(task, settings)
    if settings.sweep:
        from dynamics_cli.core.batch.sweep import sweep

        document, _ = sweep(task, gathered, settings)
        files, _ = _with_picture(document, [], _picture_of_sweep(document, settings, task), settings, task)
    else:
        document, files, _ = within(settings.time_limit, lambda: answered_case(task, gathered, settings))
    if files:
        from dynamics_cli.core.output.files import Files

        with Files(files):
            pass
    return document


def answered_case(
    task: Task, gathered: Gathered, settings: Settings
) -> "tuple[dict[str, Any], list[File], Picture | None]":
    """The result document of one case, the files it lists that are still to be written, and the requested picture."""
    reader = gathered.reader
    reader.uncertain, reader.pointers = {}, task.pointers
    try:
        bound = reader.read(task.specification.fields, gathered.raw)
    except UsageError as error:
        if not gathered.raw and task.examples:
            from dynamics_cli.core.command.task_help import example_lines

            error.example = ["an example:", *example_lines(task.shown_examples[0], 80)]
            if ".toml" in task.shown_examples[0]:
                error.example += ["a file to fill in:", f"  dynamics {task.path} --template > {task.name}.toml"]
        raise
    # by size for people alone: a script that takes one number relies on its unit
    display = Display(settings.units, settings.to, by_size=settings.format == "table" and not settings.only)
    start = _clock(settings)
    try:
        answered = answer(task, bound, settings.model, reader.uncertain, seen=_shows_bounds(settings, reader.uncertain))
    except InadmissibleError as error:
        if error.judged and reader.uncertain:
            from dynamics_cli.core.uncertainty.undetermined import add_intervals

            add_intervals(error, task, bound, reader, settings, display)
        raise
    took = _clock(settings) - start
    document = build(task, bound, answered, display, gathered.reader.notes)
    _require_checks(document, task)
    spread: tuple[Picture | None, Spreads | None] = (None, None)
    if reader.uncertain or settings.correlate:
        from dynamics_cli.core.uncertainty.document import add_uncertainty

        start = _clock(settings)
        spread = add_uncertainty(document, task, bound, answered, reader, settings, display)
        took += _clock(settings) - start
    elif settings.limit or task.limited:
        from dynamics_cli.core.answering.limits import add_limits

        add_limits(document, task, bound, answered, settings, display)
    if gathered.reader.files:
        from dynamics_cli.core.inputs.sources.hashes import once

        document["files"] = once(gathered.reader.files)
    if not reader.uncertain:
        _refuse_spreads(settings)
    if settings.explain:
        from dynamics_cli.core.answering.explain import explanation

        document["explanation"] = explanation(task, document, answered)
    if settings.timing:
        document["timing"] = {"value": took, "unit": "s"}
    return _with_files(document, task, answered, bound, spread, settings)


def _clock(settings: Settings) -> float:
    """The time, where it is asked for."""
    if not settings.timing:
        return 0.0
    from dynamics_cli.core.deadline import clock

    return clock()


def _with_files(
    document: "dict[str, Any]",
    task: Task,
    answered: "Answer",
    bound: "Fields",
    spread: "tuple[Picture | None, Spreads | None]",
    settings: Settings,
) -> "tuple[dict[str, Any], list[File], Picture | None]":
    """The document with the requested drawing and picture, which are still to be written."""
    if not settings.drawing and not settings.plot:
        return document, [], None
    # writers and pictures take plain numbers
    record = call_model(task, answered.model, bound) if task.tracked else answered.record
    files: list[File] = []
    if settings.drawing:
        from dynamics_cli.core.output.drawing import files_of

        files, entries = files_of(task, record, arguments(task, bound), settings.drawing, settings.units, spread[1])
        document["files"] = [*document.get("files", ()), *entries]
    picture = _own_picture(task, record, bound, spread[1]) if settings.plot else None
    # a task's picture that shows the uncertainty needs no second one
    shown = picture is not None and picture.spread
    return document, *_with_picture(document, files, picture if shown else _joined(picture, spread[0]), settings, task)


def _require_checks(document: "dict[str, Any]", task: Task) -> None:
    """A failed check of the calculation is an internal error, unless the checks are the answer."""
    for check in document["checks"]:
        if not check["passed"] and not task.verdict:
            raise FaultError(
                f"an internal check failed: {check['name']} ({check.get('value')} against {check.get('tolerance')})",
                code="check",
                hint="this is a bug: please report it with the inputs",
            )


def _refuse_spreads(settings: Settings) -> None:
    """Refuse options that only apply to uncertain results."""
    if settings.quantile:
        raise UsageError("no input is uncertain: results have no quantiles", parameter="quantile", code="exclusive")
    if settings.method:
        from dynamics_cli.core.uncertainty.document import read_method

        # Nothing is propagated, but an unknown name is still a wrong call.
        read_method(settings.method)


def _check_files(task: Task, settings: Settings) -> None:
    """Refuse, before anything is calculated, files that cannot be written."""
    if settings.drawing:
        from dynamics_cli.core.output.drawing import check_asked

        check_asked(task, settings.drawing, settings.output)
    if settings.plot:
        from dynamics_cli.core.output.plot import check_asked as check_picture

        check_picture(task, settings)


def _own_picture(task: Task, record: "Any", bound: "Fields", spreads: "Spreads | None") -> "Picture | None":
    from dynamics_cli.core.output.plot import own_picture

    return own_picture(task, record, arguments(task, bound), spreads)


def _joined(first: "Picture | None", second: "Picture | None") -> "Picture | None":
    """The panels of both pictures under the first one's title."""
    if first is None or second is None:
        return first or second
    from dynamics_cli.pictures import Picture

    panels = (*first.panels, *second.panels)
    return Picture(
        panels, first.title, first.columns, width=first.width, scene=first.scene, distributions=len(second.panels),
        subtitle=first.subtitle,
    )  # fmt: skip


def _picture_of_sweep(document: "dict[str, Any]", settings: Settings, task: Task) -> "Picture | None":
    if not settings.plot:
        return None
    from dynamics_cli.core.batch.sweep_pictures import of_sweep

    return of_sweep(document, task)


def _with_picture(
    document: "dict[str, Any]", files: "list[File]", picture: "Picture | None", settings: Settings, task: Task
) -> "tuple[list[File], Picture | None]":
    """The files including the picture's, which the document then lists."""
    if not settings.plot:
        return files, None
    from dynamics_cli.core.output.plot import drawn, refuse_none

    if picture is None:
        raise refuse_none(task)
    if settings.plot == "-":
        return files, picture
    data, entry = drawn(picture, settings)
    document["files"] = [*document.get("files", ()), entry]
    return [*files, (settings.plot, data, "plot")], picture


def _shows_bounds(settings: Settings, uncertain: "Mapping[str, Any]") -> bool:
    """Whether bounds are shown, and not only used to decide the digits."""
    short = settings.format == "table" and not settings.output
    more = settings.all or settings.bounds or settings.explain or settings.limit or settings.only or uncertain
    return not short or bool(more)


def _text(document: "dict[str, Any]", settings: Settings, terminal: "Terminal", task: Task, table: str) -> str:
    width = 0 if settings.output else terminal.columns
    digits = settings.digits or task.digits
    laid_out = task.layout if table != "sweep" else ""
    if settings.format == "table" and not (settings.only or settings.table or settings.all or laid_out):
        from dynamics_cli.core.output.answer import to_answer

        text = to_answer(document, task, digits, width or 80, quiet=settings.quiet, asked=bool(settings.digits))
        return painted_answer(text) if terminal.has_colours(width) else text
    from dynamics_cli.core.output.render import only, render, to_full_table, to_verdict, whole_table

    if settings.only:
        return only(document, settings.only, digits, settings.format, asked=bool(settings.digits), width=width)
    if settings.table:
        label = "" if settings.all else dict(task.headline).get(settings.table, "")
        return whole_table(document, settings.table, digits, settings.format, width, label)
    if settings.format != "table":
        listed = task.table if task.listing else ""
        return render(document, settings.format, digits, table if table == "sweep" else listed)
    if laid_out:
        layout = load(laid_out)
        if task.verdict and not settings.all:
            # the status says what passed
            return to_verdict(document, layout(document["results"], digits, width), width or 80)
        return to_full_table(document, digits, lambda results: layout(results, digits, width), width or 80)
    return to_full_table(document, digits, width=width, screen=width)


def _verdict(document: "dict[str, Any]", settings: Settings) -> int:
    """The exit status with --fail: 6 when a limit is exceeded or a verdict is negative."""
    if not settings.fail:
        return ExitStatus.DONE
    exceeded = any(
        entry["probability"] > settings.fail_above if "probability" in entry else entry["beyond"]
        for entry in document.get("limits", ())
    )
    negative = any(not check["passed"] for check in document["checks"]) or any(
        item["severity"] == "serious" for item in document["warnings"]
    )
    return ExitStatus.VERDICT if exceeded or negative else ExitStatus.DONE
