"""A report vouches for nothing that it has not calculated: documents that were altered, and documents that are none."""

import json
import sys
from copy import deepcopy
from pathlib import Path
from typing import Any

import pytest
from harness import run

SPEED = ("skid", "speed", "--distance", "60 ± 2 ft", "--friction", "0.7 ± 0.05", "--limit", "35 mph", "--units", "us")
CERTAIN = ("skid", "speed", "--distance", "60 ft", "--friction", "0.7", "--limit", "35 mph", "--explain")
SAME = "1 of 1 calculation gave the same results"
FORGED = "certified by the court"
OTHERS: tuple[Any, ...] = (None, 5, -1.5, True, "x", [], {}, [1, [2]], {"value": "x"}, {"value": [1, 2], "unit": 7})


@pytest.fixture(autouse=True)
def without_pictures(monkeypatch: pytest.MonkeyPatch) -> None:
    """They take most of the time and say nothing here."""
    monkeypatch.setitem(sys.modules, "matplotlib", None)


@pytest.fixture(scope="module")
def genuine() -> dict[str, Any]:
    return run(*SPEED, "--json").document


def reported(document: Any) -> str:
    outcome = run("report", "-", stdin=json.dumps(document))
    assert outcome.status == 0, outcome.err
    return outcome.out


def test_what_is_genuine_comes_out_the_same(genuine: dict[str, Any]) -> None:
    assert SAME in reported(genuine)


@pytest.mark.parametrize(
    ("path", "forged"),
    [
        (("numerics", "error_bound", "speed", "relative"), 1e-300),
        (("numerics", "method"), FORGED),
        (("numerics", "uncertainty", "results", "speed", "method"), FORGED),
        (("model", "source"), FORGED),
        (("model", "name"), FORGED),
        (("model", "assumptions"), [FORGED]),
        (("model", "why"), FORGED),
        (("checks", 0, "name"), FORGED),
        (("checks", 0, "value"), 0.125),
        (("checks",), []),
        (("warnings",), [{"code": "x", "severity": "note", "message": FORGED}]),
        (("limits", 0, "message"), FORGED),
        (("limits", 0, "probability"), 0.125),
        (("sensitivity", "speed", "inputs", 0, "share"), 0.125),
        (("results", "note"), FORGED),
        (("seal",), FORGED),
    ],
    ids=str,
)
def test_a_claim_is_never_shown_as_found(genuine: dict[str, Any], path: tuple[Any, ...], forged: Any) -> None:
    document = deepcopy(genuine)
    node = document
    for step in path[:-1]:
        node = node[step]
    node[path[-1]] = forged
    text = reported(document)
    assert SAME not in text
    # Where anything of the claim stands, there stands what was found instead.
    said = [line for line in text.splitlines() if "certified by" in line or "1e-300" in line or "0.125" in line]
    assert all(", now " in line for line in said)
    (told,) = {line for line in text.splitlines() if line.startswith("Calculated again")}
    assert any(str(step).replace("_", "\\_") in told for step in path)
    fresh = reported(genuine)
    own = text.partition("## 1.")[2].partition("Calculated again")[0]
    assert own == fresh.partition("## 1.")[2].partition("Calculated again")[0]


def test_a_generous_estimate_lets_no_figure_pass(genuine: dict[str, Any]) -> None:
    document = deepcopy(genuine)
    document["results"]["speed"]["interval"][0] += 3.0
    document["numerics"]["uncertainty"]["results"]["speed"]["estimate"] = 1e9
    assert "these differ: speed, interval\\[0] was" in reported(document)


def test_what_another_version_says_is_shown_as_data_alone(genuine: dict[str, Any]) -> None:
    text = reported({**genuine, "command": "skid leap"})
    assert "not calculated here" in text
    assert "1. Standard input: not calculated again: this version has no command 'skid leap'" in text
    assert "0 of 1 calculation gave the same results" in text


def places(node: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """Every part of a document."""
    keys = list(node) if isinstance(node, dict) else range(len(node)) if isinstance(node, list) else ()
    return [one for key in keys for one in ((*path, key), *places(node[key], (*path, key)))]


@pytest.mark.parametrize(("argv", "every"), [(CERTAIN, 1), (SPEED, 7)], ids=["certain", "uncertain"])
def test_a_document_malformed_anywhere_is_told_as_such(argv: tuple[str, ...], every: int) -> None:
    """Part after part replaced: a report is written, or the document refused, and the fault is never ours."""
    genuine = run(*argv, "--json").document
    for nth, path in enumerate(places(genuine)[::every]):
        document = deepcopy(genuine)
        node = document
        for step in path[:-1]:
            node = node[step]
        other = OTHERS[nth % len(OTHERS)]
        if node[path[-1]] == other:
            continue
        node[path[-1]] = other
        outcome = run("report", "-", stdin=json.dumps(document))
        assert outcome.status in (0, 2), (path, other, outcome.err)
        free = path[0] in ("inputs", "version") or path[-1] == "evaluations"
        assert free or SAME not in outcome.out, (path, other)


@pytest.mark.parametrize(
    "text",
    ['{"schema": "dynamics/1"}', '{"schema": "dynamics/1", "command": 5, "inputs": {}, "results": {}}',
     '{"schema": "dynamics/1", "command": "skid speed", "inputs": [], "results": {}}',
     '{"schema": "dynamics/1", "command": "skid speed", "inputs": {"distance": NaN}, "results": {}}',
     '{"schema": "dynamics/1", "command": "skid speed", "inputs": {"distance": 1e999}, "results": {}}',
     '{"schema": "dynamics/1", "command": "skid speed", "inputs": {"distance": ' + "9" * 5000 + '}, "results": {}}',
     "[" * 100_000, "\ufeff", "null"],
    ids=lambda text: text[:90],
)  # fmt: skip
def test_what_is_no_document_is_refused(text: str) -> None:
    outcome = run("report", "-", stdin=text)
    assert outcome.status == 2
    assert "fault" not in outcome.err


def test_a_file_that_changed_since_is_told(tmp_path: Path) -> None:
    mesh = tmp_path / "a.stl"
    facets = [((0, 0, 0), (0, 1, 0), (1, 0, 0)), ((0, 0, 0), (1, 0, 0), (0, 0, 1)), ((0, 0, 0), (0, 0, 1), (0, 1, 0)),
              ((1, 0, 0), (0, 1, 0), (0, 0, 1))]  # fmt: skip
    lines = ["solid a"]
    for facet in facets:
        lines += ["facet normal 0 0 0", "outer loop", *("vertex {} {} {}".format(*corner) for corner in facet),
                  "endloop", "endfacet"]  # fmt: skip
    mesh.write_text("\n".join([*lines, "endsolid a"]) + "\n")
    document = tmp_path / "a.json"
    argv = ("inertia", "mesh", str(mesh), "--length-unit", "mm", "--density", "1 kg/m^3", "--json")
    assert run(*argv, "--output", str(document)).status == 0
    assert SAME in run("report", str(document)).out
    mesh.write_text(mesh.read_text().replace("solid a", "solid b"))
    told = run("report", str(document)).out
    assert SAME not in told
    assert "SHA-256 of" in told
