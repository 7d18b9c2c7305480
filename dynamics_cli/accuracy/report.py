"""The work–precision report: every method of every question, its time and its error against references."""

from statistics import median

from dynamics_cli.accuracy import catalogue
from dynamics_cli.accuracy.cases import load
from dynamics_cli.accuracy.comparing import Comparing
from dynamics_cli.accuracy.listing import ReferenceCase, listed
from dynamics_cli.accuracy.machine import Machine, Peer, peer, this_machine, whole_call
from dynamics_cli.accuracy.measure import (
    FEW,
    FEW_METHODS,
    MANY,
    Asked,
    errors_of,
    representative,
    scalar_time,
)  # fmt: skip
from dynamics_cli.accuracy.questions import Comparison
from dynamics_cli.accuracy.rows import CHOSEN, Row, beats, finished, row
from dynamics_cli.core.answering.task import load as imported
from dynamics_cli.core.batch.rows.progress import Progress
from dynamics_cli.core.terminal import Terminal
from dynamics_cli.core.units.near_names import nearest_words
from dynamics_cli.errors import UsageError
from dynamics_cli.quantities import Annotated, Count, Ratio, Text, Time
from dynamics_cli.records import Advice, Check, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from typing import Any

    from dynamics_cli.accuracy.measure import Errors
    from dynamics_cli.accuracy.questions import Question


@record
class Accuracy:
    """The report."""

    methods: Annotated[tuple[Row, ...], "A row for every method of every question."]
    questions: Annotated[Count, "Questions asked."]
    looseness: Annotated[
        Ratio | None, "The program's stated bounds over its true errors: the median over its methods of their medians."
    ]
    machine: Annotated[Machine | None, "The machine that times were measured on."]
    peers: Annotated[
        tuple[Peer, ...] | None, "Libraries of others that answer some of these questions, where they were asked for."
    ]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    cases: Annotated[
        tuple[ReferenceCase, ...] | None, "The reference cases, where they were asked for in place of the measurement."
    ] = None
    call_time: Annotated[
        Time | None, "Time of a whole call of the program in a process of its own, from start to answer."
    ] = None
    most_cases: Annotated[
        Count | None, "Cases of each question at most, its hard ones, where all families were asked for at once."
    ] = None


NO_CHECKOUT = (
    Advice(
        "no-checkout", "further methods and libraries of others are measured from a checkout only", "note",
        "run it in a clone of the repository, installed with the test extra",
    ),
)  # fmt: skip


# Questions whose cases take a tenth of a second each.
SLOW = ("motion chain", "stability equilibrium", "stability gain", "gear mesh", "vibration modes")


class Done:
    """How many of the questions have been answered, as a progress bar counts."""

    def __init__(self, size: int) -> None:
        self.size = size
        self.bytes_read = 0


def accuracy(
    family: Annotated[Text, "Only this family: `dynamics accuracy gear`."] = "",
    task: Annotated[Text, "Only this task of it: `dynamics accuracy gear pair`."] = "",
    /,
    *,
    hard: Annotated[bool, "Only the hard cases: chosen, or found by search, for being difficult."] = False,
    full: Annotated[
        bool,
        "All cases of all families; of one family, more timings and larger problems: takes minutes.",
    ] = False,
    untimed: Annotated[bool, "Errors only, which are the same in every run."] = False,
    peers: Annotated[
        bool,
        "Compare further methods and other people's libraries too (trimesh, GTC, scipy, …); needs a checkout of the "
        "repository, installed with the test extra.",
    ] = False,
    cases: Annotated[
        bool, "List the reference cases, with why each is hard and where it comes from; measures nothing."
    ] = False,
) -> Accuracy:
    """Measure speed against error of the program's methods and of the alternatives, on this machine.

    Errors are against references of 40 digits, given the doubles read; times are medians of repeats.

    Returns
    -------
    Accuracy
        A row for every method; the checks say whether every stated bound held, and the status is 1 if one did not.

    Raises
    ------
    UsageError
        When the family or the task has no references.

    Notes
    -----
    A relative error is |value − reference|/|reference|; a unit in the last place is the distance of doubles at the
    reference. The bound is the one the program states for its own rounding; how loose it is compares it with the true
    error, or with 2⁻⁵³·|reference| where that is larger. Estimates, as quadrature gives them, are not bounds: one that
    falls short is counted, and is no fault.
    """
    asked = catalogue.questions(family, task)
    if not asked:
        tasks = sorted({question.task for question in catalogue.questions(family, "")} - {""})
        known = tasks or sorted({question.family for question in catalogue.questions("", "")})
        message = f"there are no references for {f'{family} {task}'.strip()!r}"
        raise UsageError(message, parameter="task" if tasks else "family", hint=_hint(task if tasks else family, known))
    if cases:
        return Accuracy((), 0, None, None, None, cases=listed(family, task, hard=hard))
    more = (catalogue.peers() or {}) if peers else {}
    libraries = {name: peer(name) for name in _names(asked, more)} if peers else {}
    few = not (family or full or peers)
    thorough = bool(family) and full
    wanted = Asked(hard=hard, full=thorough, timed=not untimed, few=few, libraries=libraries, more=more)
    rows: list[Row] = []
    done = Done(len(asked))
    with Progress(done, Terminal(), "questions") as progress:
        for question in asked:
            rows += finished(_rows(question, wanted), question.family, question.task)
            done.bytes_read += 1
            progress.advance(done.bytes_read)
    loose = sorted(line.looseness for line in rows if line.is_proved and line.looseness is not None)
    return Accuracy(
        tuple(rows),
        len({line.question for line in rows}),
        median(loose) if loose else None,
        None if untimed else this_machine(),
        tuple(libraries.values()) or None,
        _checks(rows),
        (NO_CHECKOUT if peers and catalogue.peers() is None else ())
        + tuple(_missing(library) for library in libraries.values() if not library.installed)
        + (() if few else _beaten(rows)),
        call_time=None if untimed else whole_call(),
        most_cases=MANY if few else None,
    )


def _hint(word: str, known: "Sequence[str]") -> str:
    """What was meant, if it can be guessed, or what there is."""
    near = nearest_words(word, known)
    return f"did you mean {' or '.join(near)}?" if near else f"there are for {', '.join(known)}"


def _names(asked: "Sequence[Question | Comparison]", more: "Mapping[str, Any]") -> "list[str]":
    """The libraries of others that could answer these questions, in the order of the questions."""
    names: dict[str, None] = {}
    for question in asked:
        needed = [] if isinstance(question, Comparison) else [method.needs for method in question.methods]
        further = [method.needs for method in more.get(question.name, ())]
        names.update(dict.fromkeys(name for name in (*needed, *further) if name))
    return list(names)


def _missing(library: Peer) -> Advice:
    how = "cannot be imported" if library.version else "is not installed"
    return Advice("not-installed", f"{library.name} {how} and was left out", "note", f"pip install {library.name}")


def _beaten(rows: "Sequence[Row]") -> "tuple[Advice, ...]":
    """A note for every alternative that is more exact than the method that the program uses."""
    return tuple(
        Advice(
            "alternative-more-exact",
            f"{line.question}: {line.method} is off by {line.worst:.1e} at most, the program's own method by "
            f"{line.own_worst:.1e} over the same results",
            "note",
        )
        for line in rows
        if not line.question.startswith("uncertainty") and beats(line)
    )


def _checks(rows: "Sequence[Row]") -> "tuple[Check, ...]":
    """Whether what the program claims of its own methods held: bounds, and an answer to every reference."""
    chosen = [line for line in rows if line.method.endswith(CHOSEN)]
    proved = [line for line in chosen if line.is_proved]
    checks = []
    if proved:
        broken = sum(line.broken for line in proved)
        checks.append(Check("stated bounds below a true error", broken == 0, float(broken), 0.0))
    refused = sum(line.refused for line in chosen)
    checks.append(Check("references without an answer", refused == 0, float(refused), 0.0))
    return tuple(checks)


def _rows(question: "Question | Comparison", wanted: Asked) -> "list[Row]":
    if not isinstance(question, Comparison):
        return _answered(question, wanted)
    more = [(method.name, method.call()) for method in wanted.peers_of(question.name)]
    return imported(question.function)(Comparing(question.name, wanted, more))  # type: ignore[no-any-return]


def _answered(question: "Question", wanted: Asked) -> "list[Row]":
    cases = [case for case in load(question.file) if case.task == question.cases and (case.hard or not wanted.hard)]
    if not cases:
        return []
    methods = [method for method in question.methods if wanted.takes(method)] + wanted.peers_of(question.name)
    if wanted.few:
        methods = methods[:FEW_METHODS]
        cases = list(representative(cases, FEW if question.name in SLOW else MANY))
    groups = catalogue.groups(question.family)
    scale = imported(question.scale) if question.scale else None
    each = [
        errors_of(method.call(), cases, groups, tracked=method.tracked, foreign=bool(method.needs), scale=scale)
        for method in methods
    ]
    common = [case for index, case in enumerate(cases) if all(index in _answers(errors) for errors in each)]
    rows: list[Row] = []
    for method, errors in zip(methods, each, strict=True):
        time = base = None
        if wanted.timed and errors.cases:
            # times are of the same cases; where no case is everybody's, of those that this method answers
            some = common or [cases[index] for index in sorted(_answers(errors))]
            time = scalar_time(method.call(), some, groups, wanted.pace)
            base = rows[0].time if rows else time
            if rows and not common:
                base = scalar_time(methods[0].call(), some, groups, wanted.pace)
        name = f"{method.name}{CHOSEN}" if method.chosen else method.name
        rows.append(row(question.name, name, errors, time, base, own=each[0] if rows else None))
    return rows


def _answers(errors: "Errors") -> "set[int]":
    """Which of the cases a method has answered."""
    return {int(where.partition(" ")[0]) for where in errors.by_result}
