"""`--rows`: a stream of cases, one row out for each row in, in order and in constant memory.

Each row is answered as one command would answer it (`rows.case`). Blocks of many rows go by arrays (`rows.plan`) or by
exact factors (`rows.exact`), which give the same bits; other rows are left to the single call.
"""

import itertools

from dynamics_cli.core.answering.task import Task
from dynamics_cli.core.batch.jobs import spread
from dynamics_cli.core.batch.rows.case import Case
from dynamics_cli.core.batch.rows.heads import split_header, split_suffix, split_title
from dynamics_cli.core.batch.rows.inputs import (
    CsvInput,
    Input,
    JsonInput,
    TextInput,
    decode_line,
    split_csv,
)
from dynamics_cli.core.batch.rows.outputs import OUTPUTS, Output
from dynamics_cli.core.batch.rows.tally import REPORT_IT, Tally
from dynamics_cli.core.batch.text.blocks import Source
from dynamics_cli.core.batch.text.records import cleared, first_record, records, with_commas
from dynamics_cli.core.deadline import Reached, held, reached
from dynamics_cli.core.inputs.settings import Call, Settings
from dynamics_cli.core.output.files import output
from dynamics_cli.errors import DynamicsError, ExitStatus, FaultError, UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence
    from typing import Any

    from dynamics_cli.core.batch.rows.group import Group, Groups
    from dynamics_cli.core.terminal import Terminal

# Below this numpy's import costs more than it saves; once it is there, far fewer rows are worth an array.
FIRST_ARRAY_ROWS = 300
ARRAY_ROWS = 64
# Number of rows searched for bare numbers and uncertain values.
LOOKED_AT = 50
# With more uncertain rows among these, rows are answered one by one: each may take long.
FEW_UNCERTAIN = 5
# Marks of an uncertain value: ±, +/-, .., a distribution's bracket, a list, an object, an earlier result.
UNCERTAIN_MARKS = (b"\xc2\xb1", b"+/-", b"..", b"(", b"[", b"{", b"@", b"\\u")
# Blocks that another process answers at once.
BLOCKS_A_PIECE = 4
# Rows answered one by one may take long: this many are written, or sent to another process, at once.
ROWS_A_PIECE = 64
ONE_A_LINE = 'one object a line, for example {"distance": "60 ft", "friction": 0.7}'
TOO_LONG = UsageError("the row is longer than 16 MB", code="too-long", hint="a row is one line of one case")


def run_rows(task: Task, call: Call, settings: Settings, terminal: "Terminal") -> int:
    """Answer every row of a stream; returns whether all could be answered."""
    form = _format_asked(settings)
    for name in ("explain", "timing", "quantile"):
        if getattr(settings, name):
            raise UsageError(f"--{name} is for one case and --rows for many", parameter=name, code="exclusive")
    case = Case(task, call, settings, terminal)
    source = Source(settings.rows, terminal)
    stream: _Stream | None = None
    try:
        with output(settings.output, terminal) as sink:
            write = held(sink.write) if settings.time_limit else sink.write
            from dynamics_cli.core.batch.rows.progress import Progress

            with Progress(source, terminal) as progress:
                blocks = source.blocks()
                for lines in blocks:
                    lines = _without_blank_head(lines)
                    if lines:
                        lines, blocks = _in_commas(case, lines, blocks)
                        stream, lines = _begin(case, lines, form, terminal)
                        sink.write(stream.output.head())
                        break
                if stream is None:
                    return ExitStatus.DONE
                every = itertools.chain([lines], blocks)
                rows = cleared(records(every) if isinstance(stream.source, CsvInput) else every)
                pieces = _pieces(rows, settings.jobs, singly=stream.singly)
                for block in spread(stream.block, pieces, settings.jobs):
                    stream.take(block)
                    for text in block.texts:
                        write(text)
                    if not settings.output:
                        terminal.stdout.flush()
                    progress.advance(stream.tally.rows)
    except Reached:
        where = f"after {stream.tally.rows if stream else 0} rows" + (
            "; no file was written" if settings.output else ""
        )
        raise reached(settings.time_limit, where) from None
    finally:
        source.close()
    _tell(stream, terminal)
    if stream.tally.failed:
        return ExitStatus.SOME_FAILED
    negative = settings.fail and (any(stream.tally.exceeded.values()) or stream.tally.serious)
    return ExitStatus.VERDICT if negative else ExitStatus.DONE


def _without_blank_head(lines: "list[bytes | None]") -> "list[bytes | None]":
    for start, line in enumerate(lines):
        if line is None or line.strip():
            return lines[start:]
    return []


def _in_commas(
    case: Case, lines: "list[bytes | None]", blocks: "Iterator[list[bytes | None]]"
) -> "tuple[list[bytes | None], Iterator[list[bytes | None]]]":
    """The first rows and the following ones, with commas where the header has semicolons or tabs."""
    first = lines[0] or b""
    for separator in (b";", b"\t"):
        if separator in first and first.lstrip()[:1] != b"{" and not _is_header(case, first):
            changed = with_commas(itertools.chain([lines], blocks), separator)
            if _is_header(case, first.replace(separator, b",")):
                return next(changed), changed
    return lines, blocks


def _pieces(blocks: "Iterator[list[bytes | None]]", jobs: int, *, singly: bool) -> "Iterator[list[bytes | None]]":
    """Rows that are answered and written at once: a few where each is a separate call, else a block.

    For several processes a few blocks, as sending each costs something.
    """
    if singly:
        for block in blocks:
            yield from (block[start : start + ROWS_A_PIECE] for start in range(0, len(block), ROWS_A_PIECE))
        return
    if jobs == 1:
        yield from blocks
        return
    while several := list(itertools.islice(blocks, BLOCKS_A_PIECE)):
        # A line too long to read is a block of its own.
        if all(None not in block for block in several):
            yield [line for block in several for line in block]
        else:
            yield from several


def _format_asked(settings: Settings) -> str:
    if not settings.format_given:
        return ""
    if settings.format in ("table", "markdown"):
        hint = "rows go out as they came in, or as csv or ndjson"
        raise UsageError(
            f"rows cannot be written as {settings.format}", parameter="format", code="exclusive", hint=hint
        )
    return "ndjson" if settings.format == "json" else settings.format


def _begin(
    case: Case, lines: "list[bytes | None]", form: str, terminal: "Terminal"
) -> "tuple[_Stream, list[bytes | None]]":
    """The stream, set up from the first line, and the rows of the first block."""
    source: Input
    first = lines[0]
    if first is None:
        raise UsageError("the first row is longer than 16 MB", parameter="rows", code="too-long")
    start = first.lstrip()[:1]
    if start == b"[":
        hint = f"{ONE_A_LINE}, as from jq -c '.[]'"
        raise UsageError("rows begin with '[': a JSON list is not a stream", parameter="rows", code="json", hint=hint)
    if first.strip() == b"{":
        hint = f"{ONE_A_LINE}, as from jq -c ."
        raise UsageError("the first row is '{' alone", parameter="rows", code="json", hint=hint)
    if b"\r" in first and b'"' not in first:
        message = "the rows' lines end in bare carriage returns"
        hint = "save them with line feeds, or send them through: tr '\\r' '\\n'"
        raise UsageError(message, parameter="rows", code="line-ends", hint=hint)
    head, rest = first_record(lines)
    looked = lines
    if start == b"{":
        source = JsonInput(case, first)
    elif case.task.specification.words and not _is_header(case, head):
        source = TextInput(case)
    else:
        first, lines = head, rest
        source = _csv_input(case, first, terminal)
        looked = next(records([lines]), [])
    _settle_unit(case, source, looked[:LOOKED_AT])
    case.check()
    case.take_spread(_readable(source, looked[:LOOKED_AT], UNCERTAIN_MARKS))
    case.take_limits(_readable(source, looked[:LOOKED_AT]))
    return _Stream(case, source, OUTPUTS[form or source.format](source, case.layout), first), lines


def _settle_unit(case: Case, source: Input, lines: "list[bytes | None]") -> None:
    """Of several units, take the first as that of bare numbers if the rows hold such: `convert mph ft/s --rows -`."""
    for line in lines:
        try:
            if line is not None and case.is_bare(source.read(line)):
                case.take_default_unit()
                return
        except Exception:
            continue  # what is wrong with this row is reported in its place


def _readable(
    source: Input, lines: "list[bytes | None]", marks: "tuple[bytes, ...]" = (b"",)
) -> "Iterator[dict[str, Any]]":
    """The lines that hold one of these marks, read; errors of a line are reported in its place."""
    for line in lines:
        if line is not None and any(mark in line for mark in marks):
            try:
                yield source.read(line)
            except Exception:
                continue


def _is_header(case: Case, line: bytes) -> bool:
    """Whether some cell is the name of a parameter or of an earlier step's result; words are not names."""
    try:
        cells = split_csv(decode_line(line))
    except UsageError:
        return False
    names = [name for cell in cells for name in (split_header(cell)[0].removeprefix("results."), split_title(cell)[0])]
    return any(split_suffix(cell, case)[0] for cell in cells) or any(
        name.partition(".")[0].partition("[")[0].replace("-", "_") in case.names for name in names
    )


def _csv_input(case: Case, first: bytes, terminal: "Terminal") -> CsvInput:
    try:
        source = CsvInput(case, first)
    except UsageError as error:
        error.parameter = "rows"
        raise
    if not source.parameters:
        raise UsageError(
            f"no column of the header {decode_line(first)[:80]!r} is a parameter of {case.task.path}",
            parameter="rows",
            code="header",
            hint="cells are separated by commas, semicolons or tabs; a vector has a column for each component, "
            f"NAME[0], NAME[1] and so on; parameters are {', '.join(sorted(case.names))}",
        )
    _warn(case, [column.name for column in source.columns if not column.path], terminal)
    return source


def _tell(stream: "_Stream", terminal: "Terminal") -> None:
    _warn(stream.case, list(stream.passing), terminal)
    for text in stream.tally.messages(limit.text for limit in stream.case.limits):
        terminal.tell(text)


def _warn(case: Case, names: "list[str]", terminal: "Terminal") -> None:
    """Warn of passed-through names that look like a parameter: a misspelt optional one would go unnoticed."""
    from dynamics_cli.core.units.near_names import nearest_words

    options = {name.replace("-", "_"): ".".join(option.path) for name, option in case.task.options.items()}
    for name in names[:20]:
        near = [] if name in ("error", "results", "id") else nearest_words(name, {*case.names, *options}, 1)
        if near:
            # an object has the parts of a body within it
            meant = options[name] if near == [name] else near[0]
            terminal.tell(
                f"dynamics: {name!r} is not a parameter of {case.task.path} and passes through (not {meant}?)\n"
            )


class _Block:
    """The rows of one block, answered: their texts, their tally, and names that pass through."""

    __slots__ = ("passing", "tally", "texts")

    def __init__(self, texts: "list[bytes]", tally: Tally, passing: "list[str]") -> None:
        self.texts = texts
        self.tally = tally
        self.passing = passing


class _Stream:
    """A stream in progress."""

    def __init__(self, case: Case, source: Input, output: Output, first: bytes) -> None:
        self.case = case
        self.source = source
        self.output = output
        self.tally = Tally(source.format)
        self.passing: dict[str, None] = {}
        # That of the block in progress.
        self._block = Tally(source.format)
        self._first = first
        self._groups: Groups | None = None
        # None: not yet looked at; False: these rows are answered one by one.
        # A verdict needs the warnings of every row, which only single calls have.
        alone = case.settings.bounds or case.settings.fail or case.uncertain_call
        suited = not alone and case.uncertain_rows <= FEW_UNCERTAIN
        self._by_arrays: bool | None = None if suited else False

    @property
    def singly(self) -> bool:
        """Whether it is known that these rows are answered one by one."""
        return self._by_arrays is False

    def take(self, block: _Block) -> None:
        """Count a block that has been answered, here or in another process."""
        self.tally.add(block.tally)
        self.passing.update(dict.fromkeys(block.passing))

    def block(self, lines: "list[bytes | None]") -> _Block:
        """The rows of one block, answered."""
        self._block = Tally(self.source.format)
        texts = self._answered(lines)
        passing = list(self.source.passing) if isinstance(self.source, JsonInput) else []
        self._block.rows, self._block.cautions = len(lines), self.case.cautions
        self._block.serious = self.case.serious
        return _Block(texts, self._block, passing)

    def _answered(self, lines: "list[bytes | None]") -> "list[bytes]":
        if None in lines:
            for _ in lines:
                self._block.refuse(TOO_LONG, b"")
            return [self.output.bad(b"", TOO_LONG) for _ in lines]
        complete: list[bytes] = lines  # type: ignore[assignment]
        if self._wants_arrays(len(complete)):
            import gc

            # Thousands of small lists come and go, none of them in a cycle; looking for cycles doubles their cost. The
            # few cycles of the block before hold its arrays, though.
            gc.collect(0)
            gc.disable()
            try:
                return self._together(complete)
            except Exception:
                # An error of one row must not end the others: each is answered by itself.
                self._by_arrays = False
            finally:
                gc.enable()
            self._block = Tally(self.source.format)
        return [b"".join(map(self._single, complete))]

    def _wants_arrays(self, count: int) -> bool:
        if self._by_arrays is None and count >= FIRST_ARRAY_ROWS:
            import os

            # Rows need no matrix products, and a pool of threads takes memory and time to start.
            os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
            from dynamics_cli.core.batch.rows.groups import groups_of

            self._groups = groups_of(self.source, self.case, self._first)
            self._by_arrays = self._groups is not None
        return bool(self._by_arrays) and count >= ARRAY_ROWS

    def _single(self, line: bytes) -> bytes:
        if line.isspace():
            return b""
        try:
            values = self.case.values(self.source.read(line))
            text = self.output.good(line, values)
            if self.case.limits:
                from dynamics_cli.core.batch.rows.limits import exceeded_limits

                settings = self.case.settings
                self._block.exceed(exceeded_limits(self.case.layout.parts, values, settings.fail_above))
            return text
        except DynamicsError as error:
            failure = error
        except Exception as error:
            failure = FaultError(f"internal error: {type(error).__name__}: {error}", hint=REPORT_IT)
        self._block.refuse(failure, line)
        try:
            return self.output.bad(line, failure)
        except Exception:
            return self.output.bad(b"", failure)

    def _together(self, lines: "list[bytes]") -> "list[bytes]":
        assert self._groups is not None
        groups = self._groups.uniform(lines)
        if groups is None:
            groups = self._groups.sorted(lines)
        rows: list[bytes | None] = [None] * len(lines)
        for group in groups:
            all_rows = range(len(lines)) if group.rows is None else group.rows
            chosen = lines if group.rows is None else [lines[row] for row in all_rows]
            for places, texts in self._group(chosen, group):
                if len(places) == len(lines):
                    return texts
                answers = itertools.chain.from_iterable([text.split(b"\n")[:-1] for text in texts])
                for place, answer_text in zip(places, answers, strict=True):
                    rows[all_rows[place]] = answer_text
        every: list[bytes] = []
        for line, row in zip(lines, rows, strict=True):
            if row is not None:
                every.append(row)
            elif alone := self._single(line):
                every.append(alone[:-1])
        return [b"\n".join([*every, b""])]

    def _group(self, lines: "list[bytes]", group: "Group") -> "Iterator[tuple[Sequence[int], list[bytes]]]":
        """The rows of a group that could be answered together: their indices in it, and their texts."""
        from dynamics_cli.core.batch.text.weaving import Unsuited, in_runs, slices, weave

        plan = group.plan
        if plan.failures > MOST_FAILURES:
            return
        try:
            answered = plan.run(group.columns)
        except Unsuited:
            plan.failures = MOST_FAILURES + 1
            return
        plan.failures += sum(len(part.rows) for part in answered) * 4 < len(lines)
        for part in answered:
            places = list(part.rows)
            complete = len(places) == len(lines)
            answered_lines = lines if complete else [lines[place] for place in places]
            echoes = self._echoes(answered_lines, group, None if complete else places)
            pieces = in_runs(self.output.pieces(echoes, plan.written(part.results, self.output.format)))
            runs = [piece for piece in pieces if isinstance(piece, list)]
            texts = []
            for rows in slices(sum(map(len, runs)), len(places)):
                columns = iter(plan.texts_of([[column[rows] for column in run] for run in runs]))
                woven = [next(columns) if isinstance(piece, list) else piece for piece in pieces]
                texts.append(weave(woven, rows.stop - rows.start))
            if part.signature not in plan.proved:
                if not self._agrees(answered_lines, texts):
                    plan.failures = MOST_FAILURES + 1
                    return
                plan.proved.add(part.signature)
            if self.case.limits:
                from dynamics_cli.core.batch.rows.limits import exceeded_counts

                self._block.exceed(exceeded_counts(part.results, len(places)))
            yield places, texts

    def _echoes(self, lines: "list[bytes]", group: "Group", places: "list[int] | None") -> "list[bytes]":
        if self.output.format != self.source.format:
            return list(map(self.output.echo, lines))
        if group.echoes is None:
            return lines
        return group.echoes if places is None else [group.echoes[place] for place in places]

    def _agrees(self, lines: "list[bytes]", texts: "list[bytes]") -> bool:
        """Whether the first and the last row are the same as from a single call."""
        first, last = texts[0].partition(b"\n")[0], texts[-1][:-1].rpartition(b"\n")[2]
        return self._as_single(lines[0]) == first and self._as_single(lines[-1]) == last

    def _as_single(self, line: bytes) -> bytes:
        try:
            return self.output.good(line, self.case.values(self.source.read(line)))[:-1]
        except DynamicsError:
            return b""


# After this many failures a kind of rows that arrays can hardly answer is not tried again.
MOST_FAILURES = 3
