"""No stated bound of a cam is below the true error, from whatever start inputs are disturbed (longer on demand)."""

import json
import random
from collections.abc import Iterator
from typing import Any

import cam_search
import cam_search_cases as drawn
import pytest
from cam_search import QUESTIONS
from cam_search_compared import Compared
from cam_search_contact import Looking, extreme
from cam_search_laws import JERKY, MOVING, RESTING, law_of
from cam_search_motion import Turn, read, written
from mpmath import mp, mpf
from precise import Exact, many_bits
from references import generate_cam_motion_references as references
from search_length import EVALUATIONS

from dynamics_cli.accuracy.cases import DATA

ROOM = 100.0
FOUND: dict[str, cam_search.Findings] = {}


def found(task: str) -> cam_search.Findings:
    """What the search finds; once."""
    if task not in FOUND:
        FOUND[task] = cam_search.search(task, EVALUATIONS, 20)
    return FOUND[task]


@pytest.mark.parametrize("task", QUESTIONS)
def test_no_bound_is_below_the_error(task: str) -> None:
    made = found(task)
    assert made.broken == []
    assert made.evaluations >= EVALUATIONS
    assert made.compared >= made.evaluations


@pytest.mark.parametrize("task", QUESTIONS)
def test_bounds_are_tight_in_the_median(task: str) -> None:
    made = found(task)
    assert 0.0 < made.median <= ROOM
    for name, value in made.medians().items():
        assert value <= LOOSE.get(name, ROOM), name


# Results whose own median is above the room, and what it may be.
LOOSE: dict[str, float] = {}


def shipped(file: str, task: str) -> Iterator[dict[str, Any]]:
    """The cases of a file that are of a task."""
    for case in json.loads((DATA / file).read_text(encoding="utf-8"))["cases"]:
        if case["task"] == task:
            yield case


@pytest.mark.parametrize(
    ("task", "file", "least"),
    [
        ("cam force", "cam_forces.json", 200),
        ("cam profile", "cam_geometry.json", 70),
        ("cam size", "cam_geometry.json", 20),
        ("cam check", "cam_design.json", 4),
    ],
)
def test_what_is_exact_here_is_what_the_references_say(
    task: str, file: str, least: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Two constructions in many digits, written apart: mpmath's derivatives there, jets of 240 bits here."""
    many_bits()
    # some references are humps that rise 1e-18 above the end beside them
    shares, steps = Looking.fine
    monkeypatch.setattr(Looking, "shares", shares)
    monkeypatch.setattr(Looking, "steps", steps)
    checked = 0
    for case in shipped(file, task.split()[1]):
        given = drawn.fitted(random.Random(1), case["inputs"], QUESTIONS[task].draw, QUESTIONS[task].keys)
        if file == "cam_forces.json" and "contact" not in case["inputs"]:
            given.pop("contact", None)
        for one in QUESTIONS[task].compare(given):
            if one.name in case["results"] and "[" not in one.name:
                reference = Exact(case["results"][one.name])
                room = Exact(10) ** -28 * max(abs(reference), Exact(10) ** -20)
                assert abs(one.exact - reference) <= room, (case["name"], one.name)
                checked += 1
    assert checked >= least


def test_the_worst_that_was_found_holds_its_bounds() -> None:
    many_bits()
    compared = 0
    for task in ("force", "profile", "motion"):
        for case in shipped("cam_found.json", task):
            given = {"points": 5, **case["inputs"]}
            for one in cam_search.answered(QUESTIONS[f"cam {task}"], given):
                assert one.error <= one.bound, (case["name"], one.name)
                compared += one.name in case["results"]
    assert compared >= 35


@pytest.mark.parametrize("name", [*RESTING, *JERKY, *MOVING, "modified-constant-velocity"])
def test_laws_are_those_of_the_references(name: str) -> None:
    many_bits()
    branches = law_of(name)
    with mp.workprec(240):
        for share in (0.0625, 0.1875, 0.3, 0.4375, 0.6, 0.71875, 0.9, 0.999):
            branch = next(one for one in branches if Exact(share) <= one.high)
            own = branch.at(Exact(share), 3)
            for value, reference in zip(own, references.LAWS[name](mpf(share)), strict=True):
                assert abs(value - Exact(mp.nstr(reference, 80))) < Exact(10) ** -60


def test_an_extreme_between_samples_is_found() -> None:
    """The greatest velocity of 3-4-5 is 15/8 of the mean, however short the rise."""
    many_bits()
    turn = Turn("dwell 100 deg; rise 1 mm in 0.0001 deg 3-4-5; dwell 50 deg; return in 90 deg cycloidal; dwell")
    width = turn.zones[1].end - turn.zones[1].start
    top = extreme(turn, lambda s, s1, s2: s1, 1)
    assert abs(top * width / Exact(0.001) - Exact(15) / 8) < Exact(10) ** -28


def test_programs_are_read_and_written_alike() -> None:
    rng = random.Random(5)
    for _ in range(200):
        text = drawn.program(rng, swing=rng.random() < 0.5, jumps=True)
        assert written(read(text)) == text


def test_a_bound_that_is_too_small_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    whole = QUESTIONS["cam profile"]

    def tightened(case: dict[str, Any]) -> Iterator[Compared]:
        for one in whole.compare(case):
            yield one._replace(bound=0.01 * one.bound) if one.stated else one

    monkeypatch.setitem(QUESTIONS, "tightened", whole._replace(compare=tightened))
    made = cam_search.search("tightened", 300, 1)
    assert len(made.broken) > 5


def test_a_wrong_value_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    """One point of a table that is off by a millionth of a millionth of the cam, where no bound is stated."""
    import cam_search_tables

    whole = cam_search_tables.profile

    def shifted(*given: Any, **more: Any) -> Any:
        answer = whole(*given, **more)
        answer.points.arrays["x"][2] += 1e-12 * answer.largest_radius
        return answer

    monkeypatch.setattr(cam_search_tables, "profile", shifted)
    made = cam_search.search("cam profile", 300, 1)
    assert any(line.startswith("points[2].x") for line in made.broken)


def test_the_search_is_the_same_every_time() -> None:
    first, second = (cam_search.search("cam motion", 200, 3) for _ in range(2))
    assert first.nearest == second.nearest
    assert first.looseness == second.looseness
