"""Rows answered and rows that failed, of a block or of a stream, and what is said of them when it ends."""

from dynamics_cli.core.batch.rows.inputs import CarriedError
from dynamics_cli.core.batch.rows.outputs import error_line
from dynamics_cli.errors import DynamicsError, FaultError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

REPORT_IT = "this is a bug: please report it with the row"
# Of a row or of an error so much is shown.
SHOWN = 200
MOST_CAUTIONS = 3


class Tally:
    """The numbers of rows, of failures, of rows beyond each limit; the first failure and fault; cautions."""

    __slots__ = ("cautions", "exceeded", "failed", "fault", "first", "format", "rows", "serious")

    def __init__(self, form: str) -> None:
        self.format = form
        self.rows = 0
        self.failed = 0
        self.first = ""
        self.fault = ""
        # By the text of the limit; and whether a row has a serious warning.
        self.exceeded: dict[str, int] = {}
        self.serious = False
        self.cautions: dict[str, tuple[str, str]] = {}

    def refuse(self, error: DynamicsError, line: bytes) -> None:
        """Count a row that failed; an earlier step has reported what failed there."""
        self.failed += 1
        if type(error) is FaultError:
            self.fault = self.fault or f"{error.message} in the row {line.decode(errors='replace')[:SHOWN]}"
        elif not self.first and not isinstance(error, CarriedError):
            one = error.all()[0]
            hint = one.hint or ""
            if one.code == "missing-unit" and self.format == "csv":
                hint += f", or name the unit in the header: {one.parameter}[…]"
            self.first = error_line(error)[:SHOWN] + (f"\n  {hint}" if hint else "")

    def exceed(self, counts: "dict[str, int]") -> None:
        """Count rows beyond limits."""
        for limit, count in counts.items():
            self.exceeded[limit] = self.exceeded.get(limit, 0) + count

    def add(self, other: "Tally") -> None:
        """Add those of the next rows."""
        self.exceed(other.exceeded)
        self.serious |= other.serious
        self.rows += other.rows
        self.failed += other.failed
        self.first = self.first or other.first
        self.fault = self.fault or other.fault
        self.cautions = {**other.cautions, **self.cautions}

    def messages(self, limits: "Iterable[str]" = ()) -> "Iterator[str]":
        """What is said at the end of a stream."""
        for limit in limits:
            yield f"dynamics: {limit} in {self.exceeded.get(limit) or 'none'} of {self.rows:,} rows\n"
        if self.first:
            rows = "1 row" if self.failed == 1 else f"{self.failed:,} rows"
            yield f"dynamics: {rows} could not be answered; the first: {self.first}\n"
        for message, remedy in list(self.cautions.values())[:MOST_CAUTIONS]:
            yield f"dynamics: caution for at least one row: {message}\n" + (f"  {remedy}\n" if remedy else "")
        if self.fault:
            yield f"dynamics: {self.fault}\n  {REPORT_IT}; the other rows are answered\n"
