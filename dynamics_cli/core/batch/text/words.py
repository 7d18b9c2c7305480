"""Lines of a number, its unit and the units wanted, grouped by the text after the number."""

from dynamics_cli.core.batch.rows.case import Case
from dynamics_cli.core.batch.rows.group import SMALLEST_GROUP, Group, Groups
from dynamics_cli.core.batch.text.conversions import ExactPlan
from dynamics_cli.core.batch.text.numbers import is_number
from dynamics_cli.core.batch.text.weaving import Tokens, Unsuited
from dynamics_cli.errors import DynamicsError

MOST_PLANS = 2048


class WordGroups(Groups):
    """Lines of a number, its unit and the units wanted."""

    def __init__(self, case: Case) -> None:
        self.case = case
        self.plans: dict[bytes, ExactPlan | None] = {}

    def _plan(self, rest: bytes, token: bytes) -> "ExactPlan | None":
        """The plan for lines that end like this one, or None when they are answered one by one."""
        if rest not in self.plans:
            if len(self.plans) >= MOST_PLANS:
                self.plans.clear()
            try:
                if b"'" in rest or b'"' in rest:
                    raise Unsuited("quotes may join words")
                raw = self.case.words((token + b" " + rest).decode().split())
                flags = self.case.settings.format_given
                self.plans[rest] = ExactPlan(self.case, raw, [self.case.measure[0]], flags=flags)
            except (Unsuited, DynamicsError, UnicodeDecodeError):
                self.plans[rest] = None
        return self.plans[rest]

    def uniform(self, lines: "list[bytes]") -> "list[Group] | None":
        """Bare numbers, all in the unit that the call fixes."""
        plan = self._plan(b"", b"1")
        return [Group(plan, [Tokens(lines)])] if plan is not None and _may_be_numbers(lines) else None

    def sorted(self, lines: "list[bytes]") -> "list[Group]":
        """Groups by the text after the number."""
        parts = [line.partition(b" ") for line in lines]
        rows: list[int] | None = None
        if not _may_be_numbers([part[0] for part in parts]):
            rows = [row for row, part in enumerate(parts) if is_number(part[0])]
            parts = [parts[row] for row in rows]
        groups: dict[bytes, list[int]] = {}
        for place, part in enumerate(parts):
            groups.setdefault(part[2], []).append(place)
        result = []
        for rest, places in groups.items():
            if len(places) < SMALLEST_GROUP // 4:
                continue
            plan = self._plan(rest, parts[places[0]][0])
            if plan is not None:
                tokens = Tokens([parts[place][0] for place in places])
                result.append(Group(plan, [tokens], places if rows is None else [rows[place] for place in places]))
        return result


def _may_be_numbers(texts: "list[bytes]") -> bool:
    """Whether texts have no other characters than numbers; those that are none all the same are refused one by one."""
    return not b"\n".join(texts).translate(None, b"0123456789.+-eE \n")
