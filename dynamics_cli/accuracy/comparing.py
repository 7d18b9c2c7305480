"""A comparison that is asked for: its cases, and a row for every method over them."""

from dynamics_cli.accuracy.cases import Case, load
from dynamics_cli.accuracy.measure import FEW_METHODS, Errors, representative, seconds
from dynamics_cli.accuracy.rows import Row, row
from dynamics_cli.errors import DynamicsError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence
    from typing import Any

    from dynamics_cli.accuracy.measure import Asked

    # Counts a method's answer to a case, the nth, and gives the call to be timed.
    Answer = Callable[[Errors, Any, Any, int], Callable[[], Any]]


class Comparing:
    """The question's name, what of the report is wanted, and further methods as pairs of a name and a function.

    With `few`, some of the cases and the first two methods take part.
    """

    def __init__(self, name: str, wanted: "Asked", more: "Sequence[tuple[str, Any]]" = ()) -> None:
        self.name = name
        self.hard, self.full, self.few, self.timed = wanted.hard, wanted.full, wanted.few, wanted.timed
        self.pace = wanted.pace
        self.more = tuple(more)

    def cases(self, *files: str, task: str = "") -> "list[Case]":
        """The cases of files, of one task or all."""
        every = [case for file in files for case in load(file) if task in ("", case.task)]
        return [case for case in every if case.hard or not self.hard]

    def rows(
        self,
        methods: "Iterable[tuple[str, Any]]",
        cases: "Sequence[Any]",
        answer: "Answer",
        *,
        most: int = 1,
        shared: bool = False,
        repeats: int = 0,
        **options: "Any",
    ) -> "list[Row]":
        """A row for every method; `most` cases are timed, and where answers are `shared` all stand beside the first."""
        rows: list[Row] = []
        base: float | None = None
        first: Errors | None = None
        methods = [*methods, *self.more]
        if self.few:
            methods, cases = methods[:FEW_METHODS], representative(cases)
        for name, method in methods:
            errors, calls = Errors(), []
            for index, case in enumerate(cases):
                try:
                    call = answer(errors, case, method, index)
                except (DynamicsError, ArithmeticError, ValueError):
                    errors.refused += 1
                    continue
                errors.cases += 1
                calls.append(call)
            time, timed = None, calls[:: max(1, len(calls) // most)]
            if self.timed and timed:
                many = repeats or self.pace.repeats
                time = seconds(lambda: [call() for call in timed], repeats=many, least=self.pace.least) / len(timed)  # noqa: B023
            base = base or time
            rows.append(row(self.name, name, errors, time, base, own=first, **options))
            first = (first or errors) if shared else None
        return rows
