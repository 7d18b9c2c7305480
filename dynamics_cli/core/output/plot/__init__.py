"""Pictures of an answer: which ones exist; in a file by matplotlib, or small in the terminal.

Pictures: the task's own; a sweep's results over the swept parameter; with uncertain inputs the distribution of the
first result that varies, and its drivers.
"""

import os

from dynamics_cli.core.answering.task import load
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.core.answering.task import Task
    from dynamics_cli.core.inputs.settings import Settings
    from dynamics_cli.core.terminal import Terminal
    from dynamics_cli.pictures import Picture, Spreads

FORMATS = ("svg", "png", "pdf")
TERMINAL = "-"


def check_asked(task: "Task", settings: "Settings") -> None:
    """Refuse, before anything is calculated, a picture that cannot be made."""
    name = settings.plot
    if name == TERMINAL:
        return
    form = extension(name)
    if form not in FORMATS:
        raise UsageError(
            f"read {name!r}, wanted a file that ends in .svg, .png or .pdf, or - for the terminal",
            parameter="plot",
            code="unknown-choice",
            hint=f"drawings for CAD: --drawing {name}" if form == "dxf" else "for example: --plot picture.svg",
        )
    for other in ("output", "drawing"):
        other_file = getattr(settings, other)
        if other_file and os.path.realpath(other_file) == os.path.realpath(name):
            raise UsageError(
                f"--plot and --{other} name the same file", parameter="plot", code="exclusive", hint="give it two names"
            )
    from dynamics_cli.core.output.plot.library import need

    need()


def own_picture(
    task: "Task", record: "Any", arguments: "tuple[list[Any], dict[str, Any]]", spreads: "Spreads | None" = None
) -> "Picture | None":
    """The task's own picture; one that shows uncertainty takes the spreads of the results."""
    if not task.plot:
        return None
    words, options = arguments
    draws = load(task.plot)
    picture: Picture = draws(record, *words, **options, **with_spreads(draws, spreads))
    return picture


def with_spreads(draws: "Any", spreads: "Spreads | None") -> "dict[str, Any]":
    """Further argument of a picture function: the spreads of the results, if it takes them."""
    return {"spreads": spreads} if "spreads" in (draws.__kwdefaults__ or ()) else {}


def refuse_none(task: "Task") -> UsageError:
    """Refuse a picture that does not exist, with the remedy."""
    return UsageError(
        f"{task.path} has no picture of one certain case",
        parameter="plot",
        code="no-picture",
        hint="sweep a parameter, or make an input uncertain, to get one",
    )


def drawn(picture: "Picture", settings: "Settings") -> "tuple[bytes, dict[str, Any]]":
    """The picture's file and its entry in the document."""
    from dynamics_cli.core.inputs.sources.hashes import entry_of
    from dynamics_cli.core.output.plot.pages import draw

    data = draw(picture, extension(settings.plot), settings.units)
    return data, {**entry_of(settings.plot, data), "written": True}


def show_small(picture: "Picture", settings: "Settings", terminal: "Terminal") -> None:
    """A small picture on standard error, when that is a terminal."""
    if not terminal.shows_progress:
        return
    import shutil

    from dynamics_cli.core.output.plot.small import sketch

    columns, lines = shutil.get_terminal_size((80, 24))
    terminal.tell(sketch(picture, settings.units, columns, lines))


def extension(name: str) -> str:
    """The ending of a file's name."""
    return os.path.splitext(name)[1].lower().removeprefix(".")
