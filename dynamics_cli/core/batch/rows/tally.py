"""Rows answered and rows that failed, of a block or of a stream, and what is said of them when it ends."""

from dynamics_cli.core.batch.rows.inputs import CarriedError
from dynamics_cli.core.batch.rows.outputs import error_line
from dynamics_cli.errors import DynamicsError, FaultError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator

REPORT_IT = "this is a bug: please report it with the row"
# Of a row or of an error so much is shown.
SHOWN = 200
MOST_CAUTIONS = 3


class Tally:
    """The numbers of rows and of failures, the first row that failed, the first mistake of the program, cautions."""

    __slots__ = ("cautions", "failed", "fault", "first", "format", "rows")

    def __init__(self, form: str) -> None:
        self.format = form
        self.rows = 0
        self.failed = 0
        self.first = ""
        self.fault = ""
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

    def add(self, other: "Tally") -> None:
        """Add those of the next rows."""
        self.rows += other.rows
        self.failed += other.failed
        self.first = self.first or other.first
        self.fault = self.fault or other.fault
        self.cautions = {**other.cautions, **self.cautions}

    def messages(self) -> "Iterator[str]":
        """What is said at the end of a stream."""
        if self.first:
            rows = "1 row" if self.failed == 1 else f"{self.failed:,} rows"
            yield f"dynamics: {rows} could not be answered; the first: {self.first}\n"
        for message, remedy in list(self.cautions.values())[:MOST_CAUTIONS]:
            yield f"dynamics: caution for at least one row: {message}\n" + (f"  {remedy}\n" if remedy else "")
        if self.fault:
            yield f"dynamics: {self.fault}\n  {REPORT_IT}; the other rows are answered\n"
