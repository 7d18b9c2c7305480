"""Exports of a cam at equal deviation: how many lines, arcs or cubics keep a micrometre, and how many a nanometre."""

from functools import partial

from dynamics_cli.accuracy.alternatives.cam.export import FIT, measured, paths

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.measure import Errors
    from dynamics_cli.accuracy.rows import Row
    from dynamics_cli.cam.export.path import Path

    # For each smooth piece of the curve, where its pieces end, and their bulges or handles.
    Pieces = list[tuple[Any, Any]]
    Method = Callable[[Path, float], Pieces]

# The deviation of so many pieces at equal angles tells how many are needed; more than these are not tried.
FIRST, MOST = 2000, 400_000
# Ten thousand pieces take their time to make and to measure.
FEW = 2


def alike(form: str, path: "Path", tolerance: float) -> "Pieces":
    """The program's own: as few pieces as keep the tolerance, all erring alike."""
    from dynamics_cli.numerics.fitting.pieces import fit

    return [(places, shape) for _, places, shape in fit(path, form, FIT * tolerance)]


def equal_angles(path: "Path", tolerance: float) -> "Pieces":
    """Lines between points at equal steps of cam angle, as a table of points is cut."""
    import numpy as np

    def lines(count: int) -> "Pieces":
        made = []
        whole = float((path.ends - path.starts).sum())
        for start, end in zip(path.starts, path.ends, strict=True):
            places = np.linspace(start, end, max(1, round(count * (end - start) / whole)) + 1)
            made.append((places, np.zeros(places.size - 1)))
        return made

    count = FIRST
    for _ in range(4):
        made = lines(count)
        off = deviation(path, "lines", made) / tolerance
        if 0.9 < off <= 1.0:
            return made
        # the height of an arc over its chord goes with the square of its length
        count = int(np.ceil(count * (off / 0.97) ** 0.5))
        if count > MOST:
            raise ArithmeticError
    return lines(count)


def deviation(path: "Path", form: str, pieces: "Pieces") -> float:
    """The largest distance of points of the exact curve from their pieces."""
    return max(measured(path.on(piece), form, places, shape) for piece, (places, shape) in enumerate(pieces))


METHODS = (
    ("cubics that err alike (chosen)", ("cubics", partial(alike, "cubics"))),
    ("arcs that err alike", ("arcs", partial(alike, "arcs"))),
    ("lines that err alike", ("lines", partial(alike, "lines"))),
    ("lines at equal angles", ("lines", equal_angles)),
)


def compare_micrometre(comparing: "Comparing") -> "list[Row]":
    """Pieces for a deviation of a micrometre."""
    return _compared(comparing, 1e-6)


def compare_nanometre(comparing: "Comparing") -> "list[Row]":
    """Pieces for a deviation of a nanometre, for the first two cams only unless there are minutes."""
    return _compared(comparing, 1e-9)


def _compared(comparing: "Comparing", tolerance: float) -> "list[Row]":
    cams = paths(hard=comparing.hard)
    if tolerance < 1e-7 and not comparing.full:
        cams = cams[:FEW]

    def answer(errors: "Errors", case: "Any", way: "tuple[str, Method]", _: int) -> "Callable[[], Pieces]":
        (cam, path, _), (form, function) = case, way
        pieces = function(path, tolerance)
        count = sum(places.size - 1 for places, _ in pieces)
        errors.note(f"{cam}, {count} pieces", deviation(path, form, pieces) / tolerance, None)
        errors.entities = (errors.entities or 0) + count
        return lambda: function(path, tolerance)

    repeats = 3 if comparing.full else 1
    return comparing.rows(METHODS, cams, answer, repeats=repeats, measure="shares of the tolerance")
