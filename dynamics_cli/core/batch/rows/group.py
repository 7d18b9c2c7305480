"""Groups of rows that one array call can answer, and the plan for it."""

from abc import ABC, abstractmethod

from dynamics_cli.core.batch.rows.case import Case
from dynamics_cli.core.batch.text.conversions import ExactPlan

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from dynamics_cli.core.batch.rows.plan import Plan
    from dynamics_cli.core.batch.text.weaving import Tokens

# Groups smaller than this are cheaper one by one.
SMALLEST_GROUP = 64
# With more kinds of rows than this in a stream, most rows are unique.
MOST_MAKES = 64
MOST_TRIES = 6


class Group:
    """Rows (None: all of the block) with their columns of numbers, their plan, and their echoes where already cut."""

    __slots__ = ("columns", "echoes", "plan", "rows")

    def __init__(
        self,
        plan: "Plan | ExactPlan",
        columns: "Sequence[Tokens]",
        rows: "list[int] | None" = None,
        echoes: "list[bytes] | None" = None,
    ) -> None:
        self.plan = plan
        self.columns = columns
        self.rows = rows
        self.echoes = echoes


def make_plan(
    case: Case, raw: "dict[str, Any]", addresses: "Sequence[str]", units: "Sequence[str | None]"
) -> "Plan | ExactPlan":
    """The plan for rows like this one; raises Unsuited, or the error of this one row."""
    if case.measure[0]:
        return ExactPlan(case, raw, addresses)
    from dynamics_cli.core.batch.rows.plan import Plan

    return Plan(case, raw, addresses, units)


class Groups(ABC):
    """How the rows of one format are grouped."""

    @abstractmethod
    def uniform(self, lines: "list[bytes]") -> "list[Group] | None":
        """All lines as one group like the last one, or None."""

    @abstractmethod
    def sorted(self, lines: "list[bytes]") -> "list[Group]":
        """Groups of the lines that can be answered together."""


def readable(data: bytes) -> bool:
    """Whether bytes are UTF-8."""
    if data.isascii():
        return True
    try:
        data.decode()
    except UnicodeDecodeError:
        return False
    return True
