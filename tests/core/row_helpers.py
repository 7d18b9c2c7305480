"""A task with every form of input and result that rows can carry, and how to run streams in memory."""

import io
from contextlib import ExitStack
from unittest.mock import patch

from dynamics_cli.core.answering.task import Family, Model, Task
from dynamics_cli.core.batch import stream
from dynamics_cli.core.batch.text import cells, objects
from dynamics_cli.core.batch.text import words as pairs
from dynamics_cli.core.inputs.settings import Call, Settings
from dynamics_cli.core.terminal import Terminal
from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import sqrt, where
from dynamics_cli.quantities import (
    Angle,
    Count,
    Distance,
    Friction,
    Length,
    Position,
    Ratio,
    RoadSpeed,
    Slope,
    Temperature,
)
from dynamics_cli.records import Check, Choice, record


class Surface(Choice):
    names = ("dry", "wet")


DRY = Surface("dry")


@record
class Mark:
    distance: Distance
    friction: Friction = 0.5


@record
class Radius:
    radius: Length


@record
class Chord:
    chord: Length
    middle: Length

    @property
    def radius(self):
        return (self.chord * self.chord / 4.0 + self.middle * self.middle) / (2.0 * self.middle)


@record
class Inner:
    mean: Ratio
    moved: Position


@record
class Table:
    own: Distance


@record
class Probe:
    speed: RoadSpeed
    warm: Temperature
    turn: Angle
    slope: Slope
    inner: Inner
    inverse: Ratio | None
    fast: bool
    surface: Surface
    total: Count
    rows: tuple[Table, ...]
    checks: tuple[Check, ...] = ()


def probe(
    *,
    marks: Mark | tuple[Mark, ...],
    path: Radius | Chord | None = None,
    temperature: Temperature = 293.15,
    angle: Angle = 0.0,
    grade: Slope = 0.0,
    count: Count = 1,
    surface: Surface = DRY,
    at: Position = (0.0, 0.0, 0.0),
    invert: Ratio | None = None,
) -> Probe:
    several = marks if isinstance(marks, tuple) else (marks,)
    work = 0.0
    for mark in several:
        require(mark.friction < 5.0, "friction {0:.3g} is glue", mark.friction, code="glue")
        work = work + mark.distance * mark.friction * 9.80665
    if path is not None:
        require(path.radius > 0.0, "the radius {0:.3g} is not positive", path.radius, code="radius")
        work = work + path.radius
    speed = sqrt(2.0 * work)
    return Probe(
        speed=speed,
        warm=temperature + 1.0,
        turn=angle * 3.0,
        slope=grade + 0.0,
        inner=Inner(mean=speed / count, moved=(at[0] + speed, at[1] * 2.0, at[2])),
        inverse=None if invert is None else 1.0 / (1.0 / invert),
        fast=speed > 20.0,
        surface=surface,
        total=count * 2,
        rows=(Table(own=where(speed > 1.0, speed, 1.0)),),
    )


PROBE = Task("probe", "Everything.", Model("all", "row_helpers:probe", source="none"))
FAMILY = Family("test", "Tests.", PROBE)


@record
class Sum:
    speed: RoadSpeed


def small(*, a: Ratio, b: Ratio = 2.0) -> Sum:
    """Enough where `b` is left alone."""
    return Sum(speed=a * b)


def large(*, a: Ratio, b: Ratio = 2.0) -> Sum:
    return Sum(speed=a * b + 1.0)


def enough(*, a: Ratio, b: Ratio = 2.0) -> str | None:
    return "a is small" if a < 0.5 else None


def without_b(*, a: Ratio, b: Ratio | None = None) -> str | None:
    return "b is not given" if b is None else None


MODELS = Task(
    "models",
    "Chosen by value.",
    Model("small", "row_helpers:small", source="none", suffices="row_helpers:enough"),
    Model("large", "row_helpers:large", source="none"),
)
NAMED = Task(
    "named",
    "Chosen by what is given.",
    Model("small", "row_helpers:small", source="none", suffices="row_helpers:without_b"),
    Model("large", "row_helpers:large", source="none"),
)
FAMILY_TOO = Family("test", "Tests.", MODELS, NAMED)


class Slow(io.RawIOBase):
    """A pipe that gives a few bytes at a time."""

    def __init__(self, data: bytes, size: int) -> None:
        self._data = io.BytesIO(data)
        self._size = size

    def readable(self) -> bool:
        return True

    def read(self, size: int = -1) -> bytes:
        return self._data.read(self._size if size < 0 else min(size, self._size))


def run(task, data, *words, stdin=None, environ=None, arrays=True, **options):
    """Status, standard output and standard error of a stream; `arrays=False` forces the single route."""
    call = Call()
    call.words = list(words)
    settings = {"rows": "-"}
    for name, value in options.items():
        name = name.replace("_", "-")
        (call.options if name in task.options else settings)[name] = value
    call.settings.update(settings)
    out, err = io.BytesIO(), io.BytesIO()
    terminal = Terminal(stdin or io.BytesIO(data), out, err, environ or {})
    made = Settings(call.settings, terminal.environ)
    with ExitStack() as patches:
        patches.enter_context(patch.object(stream, "FIRST_ARRAY_ROWS", 1 if arrays else 10**9))
        patches.enter_context(patch.object(stream, "ARRAY_ROWS", 1))
        for module in (cells, objects, pairs):
            patches.enter_context(patch.object(module, "SMALLEST_GROUP", 4))
        status = stream.run_rows(task, call, made, terminal)
    return status, out.getvalue(), err.getvalue().decode()
