"""The work–precision report: every method of every question, its time and its error against references."""

from dynamics_cli.accuracy import catalogue
from dynamics_cli.accuracy.cases import load
from dynamics_cli.accuracy.measure import Pace, array_time, errors_of, scalar_time
from dynamics_cli.accuracy.questions import Comparison
from dynamics_cli.accuracy.rows import Row, row
from dynamics_cli.core.task import load as imported
from dynamics_cli.errors import UsageError
from dynamics_cli.quantities import Count, Text
from dynamics_cli.records import Advice, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.accuracy.cases import Case
    from dynamics_cli.accuracy.questions import Method, Question


@record
class Accuracy:
    """The report.

    Parameters
    ----------
    methods : tuple of Row
        A row for every method of every question.
    questions : Count
        Questions asked.
    """

    methods: tuple[Row, ...]
    questions: Count
    advice: tuple[Advice, ...] = ()


def accuracy(
    family: Text = "",
    task: Text = "",
    /,
    *,
    hard: bool = False,
    full: bool = False,
    untimed: bool = False,
    peers: bool = False,
) -> Accuracy:
    """Measure speed against error of the program's methods and of their rivals, on this machine.

    Errors are against references of 40 digits, given the doubles read; times are medians of repeats.

    Parameters
    ----------
    family : Text
        Only this family.
    task : Text
        Only this task of it.
    hard : bool
        Only the hard cases.
    full : bool
        More repeats and larger problems: minutes rather than seconds.
    untimed : bool
        Errors only: the same on every machine and in every run.
    peers : bool
        Other people's libraries too, as far as they are installed.

    Returns
    -------
    Accuracy
        A row for every method.

    Raises
    ------
    UsageError
        When the family or the task has no references.

    Notes
    -----
    A relative error is |value − reference|/|reference|; a unit in the last place is the distance of doubles at the
    reference. The bound is the one the program states for its own rounding.
    """
    asked = catalogue.questions(family, task)
    if not asked:
        known = ", ".join(sorted({question.family for question in catalogue.questions("", "")}))
        message = f"there are no references for {f'{family} {task}'.strip()!r}"
        raise UsageError(message, parameter="family", hint=f"there are for {known}")
    pace = Pace(full=full)
    rows: list[Row] = []
    missing: dict[str, None] = {}
    for question in asked:
        if isinstance(question, Comparison):
            rows += _compared(question, missing, hard=hard, full=full, timed=not untimed, peers=peers)
        else:
            rows += _answered(question, pace, missing, hard=hard, timed=not untimed, peers=peers)
    advice = tuple(
        Advice("not-installed", f"{name} is not installed and was left out", "note", f"pip install {name}")
        for name in missing
    )
    return Accuracy(tuple(rows), len(asked), advice)


def _compared(
    question: "Comparison", missing: "dict[str, None]", *, hard: bool, full: bool, timed: bool, peers: bool
) -> "list[Row]":
    options: dict[str, Any] = {"hard": hard, "full": full, "timed": timed}
    if question.peers:
        options["peers"] = tuple(name for name in question.peers if peers and _installed(name, missing))
    return imported(question.function)(question.name, **options)  # type: ignore[no-any-return]


def _answered(
    question: "Question", pace: Pace, missing: "dict[str, None]", *, hard: bool, timed: bool, peers: bool
) -> "list[Row]":
    cases = [case for case in load(question.file) if case.task == question.cases and (case.hard or not hard)]
    if not cases:
        return []
    rows: list[Row] = []
    base: float | None = None
    for method in question.methods:
        if method.needs and not (peers and _installed(method.needs, missing)):
            continue
        row = _row(question, method, cases, pace, base, timed=timed)
        base = base or row.time
        rows.append(row)
    return rows


def _installed(name: str, missing: "dict[str, None]") -> bool:
    """Whether a library can be imported: one that is there but broken is as good as none."""
    from contextlib import redirect_stdout
    from importlib import import_module
    from io import StringIO

    try:
        # some print when they are imported
        with redirect_stdout(StringIO()):
            import_module(name)
    except ImportError:
        missing[name] = None
        return False
    return True


def _row(
    question: "Question", method: "Method", cases: "list[Case]", pace: Pace, base: "float | None", *, timed: bool
) -> Row:
    function = method.call()
    groups = catalogue.groups(question.family)
    errors = errors_of(function, cases, groups, tracked=method.tracked)
    time = scalar_time(function, cases, groups, pace) if timed else None
    many = array_time(function, cases, groups, pace) if timed and method.arrays else None
    name = f"{method.name} (chosen)" if method.chosen else method.name
    return row(question.name, name, errors, time, base or time, array_time=many)
