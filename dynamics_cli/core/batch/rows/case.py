"""One row answered as one command would answer it; every faster route must agree with this one."""

from dynamics_cli.core.answering.gather import gather, keys_of, merge, put, read_words
from dynamics_cli.core.answering.models import call_model, choose, result_leaves
from dynamics_cli.core.answering.task import Task
from dynamics_cli.core.inputs.settings import Call, Settings
from dynamics_cli.core.inputs.specification import Field, Leaf, Many
from dynamics_cli.core.inputs.values import Fields
from dynamics_cli.core.output.row_layout import Layout, SpreadPart
from dynamics_cli.core.units.display import Display
from dynamics_cli.errors import DynamicsError, InadmissibleError, ManyErrors, UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator
    from typing import Any

    from dynamics_cli.core.answering.task import Model
    from dynamics_cli.core.batch.rows.limits import Limit
    from dynamics_cli.core.inputs.reader import Reader
    from dynamics_cli.core.terminal import Terminal
    from dynamics_cli.quantities import Kind

    Raw = dict[str, Any]


class Case:
    """Settings common to all rows of a stream: the task, the parameters fixed by the call, the display of results."""

    # Whether what the call fixes is uncertain, and how many of the first rows are.
    uncertain_call = False
    uncertain_rows = 0

    def __init__(self, task: Task, call: Call, settings: Settings, terminal: "Terminal") -> None:
        self.task = task
        self.asked = settings.model
        gathered = gather(task, call, settings, terminal, rows=True)
        self.base: Raw = gathered.raw
        self.reader: Reader = gathered.reader
        if not settings.references:
            # The call itself may refer to files where its rows may not.
            self.reader.references = tuple(_references(self.base))
        self.origins = dict(self.reader.origins)
        # Options on the command line override the rows; values from its files do not.
        self.fixed, _ = read_words(task.specification.fields, call.words, rows=True)
        for name, value in call.options.items():
            put(self.fixed, task.options[name].path, value)
        self.measure = self._measure()
        # Cautions of the rows' answers, the first of each code.
        self.cautions: dict[str, tuple[str, str]] = {}
        # Whether a serious warning was among them.
        self.serious = False
        self.default_unit = ""
        self.settings = settings
        self.limits: tuple[Limit, ...] = ()
        # Settings that ask for distributions before any row is seen.
        spread = bool(settings.coverage or settings.method or settings.samples or settings.seed or settings.correlate)
        display = Display(settings.units, settings.to)
        self.layout = self._layout(display, self.fixed.get(self.measure[1]), spread=spread and not self.measure[0])

    def _layout(self, display: Display, targets: "list[str] | None" = None, *, spread: bool = False) -> Layout:
        # Of an exact conversion the words are those of its ratio.
        words = not self.measure[0]
        layout = Layout(self.task.specification.result, display, targets, spread=spread, words=words)
        if self.settings.only:
            layout.narrow([*self.settings.only, *(limit.result for limit in self.limits)])
        if self.limits:
            from dynamics_cli.core.batch.rows.limits import with_limits

            layout.parts = list(with_limits(layout.parts, self.limits, probable=spread))
        if self.settings.bounds:
            from dynamics_cli.core.batch.rows.bounds import BoundPart

            layout.parts.append(BoundPart())
        return layout

    def check(self) -> None:
        """Refuse at once errors of every row: an unknown model, a fixed parameter that cannot be read."""
        if self.asked:
            choose(self.task, Fields(None, {}), self.asked)
        try:
            self.bind({}, uncertain=True)
        except DynamicsError as error:
            wrong = [item for item in error.all() if item.code != "missing"]
            if wrong:
                raise (ManyErrors(wrong) if len(wrong) > 1 else wrong[0]) from None

    def _measure(self) -> "tuple[str, str]":
        """The names of an exact quantity and of its units, where the task's words are those; else empty."""
        words = self.task.specification.words
        if len(words) == 2 and _form(words[0]) == "exact" and _form(words[1]) == "unit":
            return words[0].key, words[1].key
        return "", ""

    def take_default_unit(self) -> None:
        """Read the first of several fixed units as that of bare numbers."""
        name = self.measure[1]
        targets = self.fixed.get(name, [])
        if len(targets) > 1 and self.measure[0] not in self.fixed:
            self.default_unit = targets[0]
            self.fixed = {**self.fixed, name: targets[1:]}
            self.base = {**self.base, name: targets[1:]}
            self.layout = self._layout(self.layout.display, targets[1:])

    def take_limits(self, rows: "Iterable[Raw]") -> None:
        """Read the limits, and give each a column; the first of these rows with an answer shows for which result."""
        if not self.settings.limit:
            return
        if self.measure[0]:
            raise UsageError("--limit is not for conversions", parameter="limit", code="exclusive")
        from dynamics_cli.core.batch.rows.limits import read_limits

        self.limits = read_limits(self.settings.limit, self.layout.parts, self._present(rows))
        self.layout = self._layout(self.layout.display, spread=self.layout.spread)

    def _present(self, rows: "Iterable[Raw]") -> "dict[str, Kind]":
        """The kinds of the results of the first row with an answer."""
        for row in rows:
            try:
                bound = self.bind(row, uncertain=True)
                record = self.called(choose(self.task, bound, self.asked)[0], bound)
            except (DynamicsError, ArithmeticError, ValueError):
                continue
            return {name: kind for name, kind, _ in result_leaves(record, self.task.specification.result)}
        return {}

    def take_spread(self, rows: "Iterable[Raw]") -> None:
        """Let rows show distributions if the parameters that the call fixes, or one of these rows, are uncertain."""
        for row in () if self.measure[0] else ({}, *rows):
            try:  # noqa: SIM105  contextlib would have to be imported
                self.bind(row, uncertain=True)
            except Exception:
                pass  # reported with the row, a bug too; the distributions read before the error count
            if self.reader.uncertain:
                self.uncertain_rows += 1
                self.uncertain_call = self.uncertain_call or not row
                if not self.layout.spread:
                    self.layout = self._layout(self.layout.display, spread=True)

    @property
    def names(self) -> "set[str]":
        """The names a row may give at its top."""
        return {name for field in self.task.specification.fields for name in keys_of(field)}

    def raw(self, row: "Raw") -> "Raw":
        """A row's parameters over those of `--input`, the command line over both."""
        if self.default_unit:
            row = self._with_unit(row)
        if not self.base:
            return row
        merged = merge(self.task, self.base, row)
        return merge(self.task, merged, self.fixed) if self.fixed else merged

    def is_bare(self, row: "Raw") -> bool:
        """Whether a row gives the exact quantity as a number without a unit."""
        value = row.get(self.measure[0])
        if isinstance(value, dict):
            value = value.get("value") if not value.get("unit") else None
        return isinstance(value, str) and value.strip()[-1:] in tuple("0123456789.")

    def _with_unit(self, row: "Raw") -> "Raw":
        if not self.is_bare(row):
            return row
        value = row[self.measure[0]]
        number = value["value"] if isinstance(value, dict) else value
        return {**row, self.measure[0]: f"{number} {self.default_unit}"}

    def bind(self, row: "Raw", *, uncertain: bool = False) -> Fields:
        """The row's inputs as read; distributions are left with the reader."""
        reader = self.reader
        reader.uncertain = {} if uncertain else None
        reader.errors, reader.notes, reader.files = [], [], []
        reader.origins = dict(self.origins)
        return reader.read(self.task.specification.fields, self.raw(row))

    def values(self, row: "Raw") -> "list[Any]":
        """The results of the row; raises the errors of a single call."""
        bound = self.bind(row, uncertain=True)
        model, _ = choose(self.task, bound, self.asked)
        record = self.called(model, bound)
        if getattr(record, "advice", True):
            self.note(record, bound)
        return self.shown(model, bound, record)

    def note(self, record: "Any", bound: Fields) -> None:
        """Keep the cautions of an answer, to be reported when the stream ends."""
        from dynamics_cli.core.batch.rows.cautions import note_cautions

        self.serious |= note_cautions(self.cautions, record, bound)

    def called(self, model: "Model", bound: Fields) -> "Any":
        """The model's record; a judgement about uncertain inputs gets the intervals that remain."""
        try:
            return call_model(self.task, model, bound)
        except InadmissibleError as error:
            if error.judged and self.reader.uncertain:
                from dynamics_cli.core.uncertainty.undetermined import add_intervals

                add_intervals(error, self.task, bound, self.reader, self.settings, self.layout.display)
            raise

    def shown(self, model: "Model", bound: Fields, record: "Any") -> "list[Any]":
        """Columns of a row from a record: results, largest bound, distributions of uncertain results."""
        values = self.layout.values(record)
        if self.settings.bounds:
            from dynamics_cli.core.batch.rows.bounds import bound_of

            values[-1] = bound_of(self.task, bound, self.asked, self.layout.display, self.layout.parts)
        if not self.reader.uncertain:
            return values
        if not self.layout.spread:
            raise UsageError(
                "this row has an uncertain value, and the rows before it had none",
                code="uncertain",
                hint="give --coverage '95 %', so that every row has columns for the distribution",
            )
        from dynamics_cli.core.batch.rows.limits import LimitPart
        from dynamics_cli.core.uncertainty.document import spread_of

        only = tuple(part.of_result for part in self.layout.parts if isinstance(part, SpreadPart))
        limits: dict[str, list[float]] = {}
        for limit in self.limits:
            limits.setdefault(limit.result, []).append(limit.value)
        spreads = spread_of(
            self.task, model, bound, record, self.reader, self.settings, only=only if self.settings.only else (),
            more={"limits": limits},
        )  # fmt: skip
        vary = spreads.varying()
        for place, part in enumerate(self.layout.parts):
            if isinstance(part, SpreadPart) and part.of_result.partition("[")[0] in vary:
                values[place] = part.shown_value(spreads.spreads[part.of_result].number(part.which))
            elif isinstance(part, LimitPart) and part.limit.result in spreads.spreads:
                beyond = spreads.spreads[part.limit.result].beyond
                values[place] = next(chance for limit, chance in beyond if limit == part.limit.value)
        return values

    def words(self, words: "list[str]") -> "Raw":
        """The parameters given by a line of words: the positional ones that the call does not fix."""
        free = tuple(field for field in self.task.specification.words if field.key not in self.fixed)
        raw, scene = read_words(free, words, rows=False)
        if scene:
            raise UsageError("a row cannot name a scene", code="unexpected")
        return raw


def _references(raw: "Any") -> "Iterator[str]":
    """The texts within raw input that refer to files."""
    if isinstance(raw, str):
        if "@" in raw:
            yield raw
    elif isinstance(raw, dict | list):
        for item in raw.values() if isinstance(raw, dict) else raw:
            yield from _references(item)


def _form(field: Field) -> str:
    node = field.node
    leaf = node.item if isinstance(node, Many) else node
    return leaf.kind.form if isinstance(leaf, Leaf) and leaf.choice is None else ""
