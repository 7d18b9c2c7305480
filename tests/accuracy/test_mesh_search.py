"""Bounds of meshes against sums of whole numbers, and these against shipped references (longer on demand)."""

import json
import random
from functools import cache

import mesh_search
import pytest
from climbing import Findings, bits, search
from precise import Exact, many_bits
from search_length import EVALUATIONS

from dynamics_cli.accuracy.alternatives.inertia.solids import triangles
from dynamics_cli.accuracy.cases import DATA


@cache
def found() -> Findings:
    """What the search finds; once."""
    return search(mesh_search.question(), EVALUATIONS, 20)


def test_no_bound_is_below_the_error() -> None:
    made = found()
    assert made.broken == []
    assert made.evaluations >= EVALUATIONS
    assert made.compared == 13 * made.evaluations


def test_bounds_are_tight_in_the_median() -> None:
    assert 0.0 < found().median <= 100.0


def test_solids_and_shells_are_asked() -> None:
    assert set(found().kinds) == {"solid", "shell", "solid, doubles", "shell, doubles"}
    assert min(found().kinds.values()) >= 0.05 * EVALUATIONS


def test_the_exact_side_is_that_of_the_references() -> None:
    many_bits()
    seen = set()
    for case in json.loads((DATA / "inertia_mesh.json").read_text(encoding="utf-8"))["cases"]:
        given = case["inputs"]
        if given["solid"] in ("ball 2", "ball 6"):
            continue
        recipe = {key: list(map(float, part)) if isinstance(part, list) else part for key, part in given.items()}
        tree = {**mesh_search.surface(triangles(recipe)), "shell": recipe["shell"], "unit": {"word": "m"}}
        seen.add(recipe["shell"])
        with bits(mesh_search.BITS):
            made = mesh_search.exact(tree)
            sizes = {name: abs(Exact(text)) for name, text in case["results"].items()}
            for name, text in case["results"].items():
                # shells of needles lose some of the references' 90 digits
                assert abs(Exact(made[name]) - Exact(text)) <= sizes[name] * 1e-36, (case["name"], name)
    assert seen == {False, True}


def test_units_are_exact() -> None:
    many_bits()
    tree = mesh_search.draw(random.Random(4)) | {"shell": False}
    with bits(mesh_search.BITS):
        metres, inches = (mesh_search.exact({**tree, "unit": {"word": unit}}) for unit in ("m", "in"))
        assert inches["volume"] / metres["volume"] == mesh_search.Share(254, 10000) ** 3
        assert inches["moments.xx"] / metres["moments.xx"] == mesh_search.Share(254, 10000) ** 5


@pytest.mark.parametrize("values", [(3, 2, 1), (2, 2, 1), (2, 1, 1), (1, 1, 1)])
def test_roots_are_found_where_two_or_all_are_equal(values: tuple[int, int, int]) -> None:
    many_bits()
    with bits(mesh_search.BITS):
        rows = [[Exact(values[i]) if i == j else Exact(0) for j in range(3)] for i in range(3)]
        made = mesh_search.roots(rows)
    assert all(abs(own - wanted) < 1e-60 for own, wanted in zip(made, values, strict=True))
