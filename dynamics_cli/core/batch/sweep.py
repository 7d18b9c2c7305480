"""`--sweep`: a task over a range of one parameter or of two; each point equals a single call."""

from dynamics_cli.core.answering.gather import Gathered
from dynamics_cli.core.answering.models import choose
from dynamics_cli.core.answering.task import Task
from dynamics_cli.core.batch.jobs import spread
from dynamics_cli.core.batch.rows.case import Case
from dynamics_cli.core.batch.rows.inputs import nest
from dynamics_cli.core.batch.rows.limits import LimitPart
from dynamics_cli.core.batch.sweep_points import Axis, copied, read_axes, with_list, with_objects, with_polar
from dynamics_cli.core.deadline import Reached, clock, stop
from dynamics_cli.core.inputs.settings import Settings
from dynamics_cli.core.inputs.values import Bound, Fields, Several
from dynamics_cli.core.output.row_layout import Part
from dynamics_cli.core.units.display import Display
from dynamics_cli.errors import DynamicsError, UsageError
from dynamics_cli.records import Measured
from dynamics_cli.version import __version__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.core.answering.task import Model
    from dynamics_cli.core.batch.rows.cautions import Cautions

    Raw = dict[str, Any]
    Single = tuple[int, list[Any] | None, DynamicsError | None, tuple[Model, str] | None]

# Below this numpy's import costs more than it saves.
ARRAY_POINTS = 1000
MOST_POINTS = 1_000_000
# Points that another process answers at once.
POINTS_A_PIECE = 64
# Errors that some points of a range may have and others not.
OF_THE_POINT = ("bounds", "range", "whole")


class _Points(Case):
    """The case of a sweep: every point is the call's own input with other numbers in a few places."""

    def __init__(self, task: Task, gathered: Gathered, settings: Settings, axes: "list[Axis]") -> None:
        self.task = task
        self.asked = settings.model
        self.settings = settings
        self.base = {}
        self.fixed = {}
        self.default_unit = ""
        self.measure = ("", "")
        self.cautions, self.serious = {}, False
        self.limits = ()
        self.reader = gathered.reader
        self.origins = dict(self.reader.origins)
        self.layout = self._layout(Display(settings.units, settings.to))
        self.start = with_objects(gathered.raw, task.specification.fields)
        for axis in axes:
            if isinstance(axis.path[-1], int):
                self.start = with_list(self.start, axis.path[:-1])
            if axis.path[-1] in ("magnitude", "direction"):
                self.start = with_polar(self.start, axis.path[:-1])
        self.axes = axes
        self.count = 1
        self.corners = {0}
        for axis in axes:
            self.count *= axis.count
            self.corners = {corner * axis.count + end for corner in self.corners for end in (0, axis.count - 1)}
        if self.count > MOST_POINTS:
            raise UsageError(f"{self.count} points are too many", parameter="sweep", hint=f"at most {MOST_POINTS}")

    def places(self, index: int) -> "list[int]":
        """Index of a point on each axis; the first axis varies slowest."""
        places = []
        for axis in reversed(self.axes):
            index, place = divmod(index, axis.count)
            places.append(place)
        return places[::-1]

    def point(self, index: int) -> "Raw":
        """The raw input of one point."""
        raw: Raw = copied(self.start)
        for axis, place in zip(self.axes, self.places(index), strict=True):
            nest(raw, axis.path, axis.text(place))
        return raw

    def single(self, place: int) -> "Single":
        """One point as a single call answers it: its values or its error, the model and why."""
        try:
            bound = self.bind(self.point(place), uncertain=True)
            model, why = choose(self.task, bound, self.asked)
            record = self.called(model, bound)
            # With --fail every point is looked at for a serious warning.
            if place in self.corners or self.settings.fail:
                super().note(record, bound)
            return place, self.shown(model, bound, record), None, (model, why)
        except DynamicsError as error:
            return place, None, error, None

    def note(self, record: "Any", bound: Fields) -> None:
        """The corners alone tell the cautions of a sweep, so that arrays and single calls tell the same."""

    @property
    def singly(self) -> bool:
        """Whether every point needs a call of its own."""
        words = any(axis.words for axis in self.axes)
        settings = self.settings
        return words or not self.task.arrays or self.layout.spread or settings.bounds or settings.fail

    def singles(self, places: "list[int]") -> "tuple[list[Single], Cautions]":
        """Several points, and the cautions of their answers."""
        return [self.single(place) for place in places], self.cautions


class _Failures:
    """Why points failed: each reason once, with how often and where first."""

    def __init__(self, points: _Points) -> None:
        self._points = points
        self._found: dict[tuple[str, str | None], list[Any]] = {}

    def add(self, index: int, error: DynamicsError) -> None:
        """Count a point without an answer under its reason; raises that of a misspelt word."""
        first = error.all()[0]
        if first.code == "unknown-choice":
            raise error
        entry = self._found.setdefault((first.code, first.parameter), [0, index, first])
        entry[0] += 1

    def warnings(self) -> "list[dict[str, Any]]":
        """One warning for each reason: how many points, and where first."""
        warnings = []
        for count, index, error in self._found.values():
            places = zip(self._points.axes, self._points.places(index), strict=True)
            where = ", ".join(f"{axis.name} = {axis.text(place)}" for axis, place in places)
            message = f"{count} of {self._points.count} points have no answer, first at {where}: {error.message}"
            warning = {"code": error.code, "severity": "caution", "message": message, "count": count, "first": index}
            warnings.append({**warning, "remedy": error.hint} if error.hint else warning)
        return warnings

    def __bool__(self) -> bool:
        return bool(self._found)


def sweep(task: Task, gathered: Gathered, settings: Settings) -> "tuple[dict[str, Any], bool]":
    """The result document of a sweep, and whether some point has no answer."""
    for name in ("explain", "quantile"):
        if getattr(settings, name):
            raise UsageError(f"--{name} is for one case and --sweep for many", parameter=name, code="exclusive")
    files = list(gathered.reader.files)
    points = _Points(task, gathered, settings, read_axes(task, settings.sweep))
    start = clock()
    template, index = _template(points)
    files += [file for file in gathered.reader.files if file not in files]
    notes = list(gathered.reader.notes)
    points.take_spread((points.point(index),))
    points.take_limits(map(points.point, [index, *range(0, points.count, points.count // 50 + 1)]))
    failures = _Failures(points)
    rows: list[list[Any] | None] = [None] * points.count
    models: dict[str, tuple[Any, str]] = {}
    if template is not None:
        model, why = choose(task, template, settings.model)
        models[model.name] = (model, why)
        if points.count >= ARRAY_POINTS and not points.singly:
            _by_arrays(points, index, rows)
    unanswered = [place for place, row in enumerate(rows) if row is None]
    pieces = [unanswered[start : start + POINTS_A_PIECE] for start in range(0, len(unanswered), POINTS_A_PIECE)]
    late = []
    try:
        for piece, cautions in spread(points.singles, pieces, settings.jobs):
            points.cautions = {**cautions, **points.cautions}
            for place, values, error, chosen in piece:
                rows[place] = values
                if error is not None:
                    failures.add(place, error)
                elif chosen is not None:
                    models.setdefault(chosen[0].name, chosen)
    except Reached:
        stop()
        message = f"the time limit was reached: {rows.count(None)} of {points.count} points have no answer"
        late = [{"code": "time-limit", "severity": "serious", "message": message, "remedy": "raise --time-limit"}]
    document = _document(points, template, rows, models)
    document["warnings"] = failures.warnings() + _warnings(points, notes, models) + late
    if points.limits:
        document["limits"] = _limits(points, rows)
    if files:
        from dynamics_cli.core.inputs.sources.hashes import once

        document["files"] = once(files)
    if points.layout.spread:
        from dynamics_cli.core.inputs.settings import read_coverage

        document["numerics"]["uncertainty"] = {"coverage": read_coverage(settings.coverage), "seed": settings.seed or 1}
    if settings.timing:
        document["timing"] = {"value": clock() - start, "unit": "s"}
    return document, bool(failures)


def _template(points: _Points) -> "tuple[Fields | None, int]":
    """The inputs of a point that can be read, and its index; raises the error that every point has."""
    names = {axis.name for axis in points.axes}
    # The corners of the range show errors that occur at one end of it only.
    tried = sorted({0, points.count - 1, points.count // 2, *range(0, points.count, points.count // 50 + 1)})
    for index in tried:
        try:
            bound = points.bind(points.point(index), uncertain=True)
        except DynamicsError as error:
            for item in error.all():
                if item.parameter not in names or item.code not in OF_THE_POINT:
                    raise
            continue
        for axis in points.axes:
            axis.check(bound)
        return bound, index
    return None, 0


def _by_arrays(points: _Points, index: int, rows: "list[list[Any] | None]") -> None:
    """Fill in the points that one array call can answer; the others stay None."""
    from dynamics_cli.core.batch.rows.plan import Plan
    from dynamics_cli.core.batch.text.columns import column_of
    from dynamics_cli.core.batch.text.weaving import Unsuited

    try:
        plan = Plan(points, points.point(index), [axis.name for axis in points.axes], [None] * len(points.axes))
        columns = [column_of(tokens) for tokens in _tokens(points)]
        answered = plan.run([column for column in columns if column is not None])
    except Unsuited:
        return
    for place in sorted(points.corners):
        points.single(place)
    for group in answered:
        places = group.rows.tolist()
        columns_out = [value.tolist() if how == "each" else [value] * len(places) for _, how, value in group.results]
        rows_out = list(map(list, zip(*columns_out, strict=True)))
        # The array route must equal single calls to the bit; should it ever not, single calls are used.
        if all(points.single(places[nth])[1] == rows_out[nth] for nth in {0, len(rows_out) - 1}):
            for place, row in zip(places, rows_out, strict=True):
                rows[place] = row


def _tokens(points: _Points) -> "list[list[bytes]]":
    """The numbers of every point, axis by axis."""
    after = points.count
    before = 1
    tokens = []
    for axis in points.axes:
        after //= axis.count
        axis_tokens = [axis.number(place).encode() for place in range(axis.count)]
        tokens.append([token for token in axis_tokens for _ in range(after)] * before)
        before *= axis.count
    return tokens


def _document(
    points: _Points, template: "Fields | None", rows: "list[list[Any] | None]", models: "dict[str, tuple[Any, str]]"
) -> "dict[str, Any]":
    task = points.task
    if template is not None:
        for axis in points.axes:
            _remove(template, axis.name)
    model, why = next(iter(models.values()), (task.models[0], ""))
    model_entry: dict[str, Any] = {"name": model.name, "source": model.source, "assumptions": list(model.assumptions)}
    return {
        "schema": "dynamics/2",
        "command": task.path,
        "version": __version__,
        "inputs": {
            **(template.echo() if template is not None else {}),
            "sweep": [axis.echo() for axis in points.axes],
        },
        "results": {"sweep": _table(points, rows)},
        "model": {**model_entry, "why": why} if why else model_entry,
        "numerics": {"method": model.method},
        "checks": [],
        "warnings": [],
    }


def _table(points: _Points, rows: "list[list[Any] | None]") -> "dict[str, Any]":
    table: dict[str, Any] = {}
    after = points.count
    before = 1
    for axis in points.axes:
        after //= axis.count
        values = [value for value in axis.values for _ in range(after)] * before
        before *= axis.count
        table[axis.name] = {"value": values, "unit": axis.unit} if axis.unit else {"value": values}
    limited = {limit.result for limit in points.limits}
    # What was asked for comes first: a screen may not hold all columns.
    for index, part in sorted(enumerate(points.layout.parts), key=lambda item: ".".join(item[1].keys) not in limited):
        column = [None if row is None else row[index] for row in rows]
        # A vector does not fit into a column, and a result that no point has needs none.
        if part.how == "components" or isinstance(part.steps[-1], int) or all(value is None for value in column):
            continue
        name = part.address if part.address not in table else f"results.{part.address}"
        table[name] = _column(part, column)
    return table


def _column(part: Part, column: "list[Any]") -> "dict[str, Any]":
    unit = part.unit
    if part.how == "measured":
        unit = next((value.unit for value in column if isinstance(value, Measured)), "")
        column = [value.value if isinstance(value, Measured) else None for value in column]
    return {"value": column, "unit": unit} if unit else {"value": column}


def _warnings(points: _Points, notes: "list[str]", models: "dict[str, tuple[Any, str]]") -> "list[dict[str, Any]]":
    """Cautions of the points' answers, each once, and notes on how the call was read."""
    warnings: list[dict[str, Any]] = []
    for code, (message, remedy) in points.cautions.items():
        entry = {"code": code, "severity": "caution", "message": f"in this range: {message}"}
        warnings.append({**entry, "remedy": remedy} if remedy else entry)
    warnings += [{"code": "reading", "severity": "note", "message": note} for note in notes]
    if len(models) > 1:
        message = f"the points were answered by several models: {'; '.join(models)}"
        warnings.append({"code": "several-models", "severity": "note", "message": message})
    return warnings


def _limits(points: _Points, rows: "list[list[Any] | None]") -> "list[dict[str, Any]]":
    """Of each limit whether a point exceeds it, or the largest probability that one does."""
    entries = []
    for place, part in enumerate(points.layout.parts):
        if not isinstance(part, LimitPart):
            continue
        verdicts = [row[place] for row in rows if row is not None and row[place] is not None]
        count = sum(part.exceeded(verdict, points.settings.fail_above) for verdict in verdicts)
        message = f"{part.limit.text} at {count or 'none'} of {points.count} points"
        entry = {"result": part.limit.result, "beyond": count > 0, "limit": part.limit.shown, "message": message}
        entries.append({**entry, "probability": max(verdicts, default=0.0)} if part.probable else entry)
    return entries


def _remove(bound: Bound, address: str) -> bool:
    """Take a swept parameter out of the inputs that are shown."""
    items = bound.fields.values() if isinstance(bound, Fields) else bound.items if isinstance(bound, Several) else ()
    if isinstance(bound, Fields):
        for name, item in bound.fields.items():
            if getattr(item, "address", None) == address or (name.rstrip("_") == address and "." not in address):
                del bound.fields[name]
                return True
    return any(_remove(item, address) for item in items)
