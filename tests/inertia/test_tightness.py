"""Every stated bound of every shipped case of the family: never below the error, and no more than 100 times it.

The error counts as half a last bit of the result at least, or of the size that errors are shares of where the result
may pass through zero: the largest coordinate, the moments, what a difference is of.
"""

from collections.abc import Callable
from decimal import Decimal
from typing import Any

import pytest
from inertia_answers import FUNCTIONS, arguments, section
from mpmath import mp, mpf

from dynamics_cli.accuracy.alternatives.inertia import eigen, mesh
from dynamics_cli.accuracy.alternatives.inertia.bodies import scale
from dynamics_cli.accuracy.cases import flat, leaves, load
from dynamics_cli.accuracy.comparing import Comparing
from dynamics_cli.accuracy.measure import Asked, Errors
from dynamics_cli.core.answering.tightening import tighten
from dynamics_cli.numerics.tracked import Tracked

ROOM = 100.0
HALF_ULP = 2.0**-53


def of_bodies(task: str) -> Callable[..., Any]:
    """Results of a task as the program gives them: bounds that come out loose are measured in many digits."""

    def compare(*_: Any, **__: Any) -> None:
        for case in (case for case in load("inertia_bodies.json") if case.task == task):
            numbers = list(leaves(case.inputs))

            def call(given: Any, case: Any = case) -> Any:
                return FUNCTIONS[task](**arguments(case, given))

            answer = call(Tracked.inputs(numbers))
            tighten(answer, numbers, call)
            found = flat(answer)
            stated = answer.numerics.bounds if getattr(answer, "numerics", None) else ()
            angle = {one.result: Tracked(found[one.result], one.bound, ()) for one in stated if one.result in found}
            note(case, found | angle)

    return compare


def note(case: Any, found: dict[str, Any]) -> None:
    """Note the errors of a case's results as shares of their sizes, with their bounds."""
    true = {name: mpf(text) for name, text in case.results.items()}
    sizes = {name: abs(Decimal(text)) for name, text in case.results.items()}
    for name, reference in true.items():
        own, size = found[name], mpf(str(scale(name, sizes)))
        error = abs(mpf(getattr(own, "value", own)) - reference) - abs(reference) * mpf(10) ** -39
        bound = getattr(own, "error", None)
        shares = float(max(error, mpf(0)) / size), None if bound is None else float(mpf(bound) / size)
        Errors().note(f"{case.name}: {name}", *shares)


def of_sections(*_: Any, **__: Any) -> None:
    for case in load("inertia_sections.json"):
        note(case, section(case))


def of_matrices(*_: Any, **__: Any) -> None:
    for case in load("eigen.json"):
        values = eigen.jacobi(rows=tuple(tuple(map(float, row)) for row in case.inputs["rows"]))
        for name, own in values.items():
            Errors().add(f"{case.name}: {name}", own.value, case.results[name], own.error)


def of_meshes(name: str) -> Callable[..., Any]:
    def compare(*_: Any, **__: Any) -> None:
        mesh.compare(Comparing(name, Asked(hard=False, full=False, timed=False, few=False, libraries={}, more={})))

    return compare


# A question, and how many results of it carry a bound at least.
QUESTIONS: list[tuple[str, Callable[..., Any], int]] = [
    ("shape", of_bodies("shape"), 1800),
    ("body", of_bodies("body"), 300),
    ("compare", of_bodies("compare"), 300),
    ("tensor", of_bodies("tensor"), 60),
    ("torque", of_bodies("torque"), 25),
    ("mesh", of_meshes("mesh moments"), 700),
    ("large mesh", of_meshes("mesh moments, 32,768 triangles"), 20),
    ("overlapping mesh", of_meshes("mesh moments, faces that overlap"), 10),
    ("shell", of_meshes("shell moments"), 130),
    ("section", of_sections, 850),
    ("eigen", of_matrices, 100),
]


def stated(compare: Callable[..., Any], patch: pytest.MonkeyPatch) -> list[tuple[str, float, float]]:
    """Case and result, error and bound of the program's own method, as shares of the result or of its size."""
    kept: list[tuple[str, float, float]] = []

    def of_size(own: Errors, where: str, error: float, bound: float | None) -> None:
        own.relative.append(error)
        if bound is not None:
            kept.append((where, error, bound))

    def of_itself(own: Errors, where: str, value: float, text: str, bound: float | None, key: str = "") -> None:
        reference = mpf(text)
        size = abs(reference) or mpf(1)
        error = max(abs(mpf(value) - reference) - abs(reference) * mpf(10) ** -39, mpf(0))
        of_size(own, where, float(error / size), None if bound is None else float(bound / size))

    patch.setattr(Errors, "note", of_size)
    patch.setattr(Errors, "add", of_itself)
    # the report's rows are of errors that it has noted
    patch.setattr("dynamics_cli.accuracy.comparing.row", lambda *_, **__: None)
    mp.dps = 60
    compare()
    return kept


@pytest.mark.parametrize(("compare", "least"), [one[1:] for one in QUESTIONS], ids=[one[0] for one in QUESTIONS])
def test_every_bound_is_between_the_error_and_a_hundred_times_it(
    compare: Callable[..., Any], least: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    kept = stated(compare, monkeypatch)
    assert len(kept) >= least
    assert [one for one in kept if one[2] < one[1]] == []
    assert [one for one in kept if one[2] > ROOM * max(one[1], HALF_ULP)] == []
