"""Impacts in the accuracy report: alternatives that answer what they claim to, hard cases with reasons, a peer."""

import json
from typing import Any

import pytest
from harness import answer, run
from peers.impact import bodies as more_impact_bodies

from dynamics_cli.accuracy import catalogue
from dynamics_cli.accuracy.alternatives.impact import reconstruction
from dynamics_cli.accuracy.cases import DATA, build, leaves, load
from dynamics_cli.accuracy.measure import errors_of, stated_by
from dynamics_cli.accuracy.questions import Question

FILES = ("impact_particles.json", "impact_rigid.json", "impact_spatial.json")
EVERY = [case for file in FILES for case in load(file)]
GROUPS = catalogue.groups("impact")


@pytest.fixture(scope="module")
def rows() -> list[dict[str, Any]]:
    return answer("accuracy", "impact", "--untimed")["results"]["methods"]


class TestCases:
    def test_inputs_hold_words_vectors_and_groups(self) -> None:
        tree = {
            "body": {"record": "SquarePlate", "plate_mass": "2", "side": "1", "spin": "3", "seized": {"word": "edge"}},
            "matrix": [["1", "2"], ["3", "4"]],
            "flag": True,
        }
        assert list(leaves(tree)) == [2.0, 1.0, 3.0, 1.0, 2.0, 3.0, 4.0]
        made = build(tree, leaves(tree), GROUPS)
        assert (made["body"].plate_mass, made["body"].seized) == (2.0, "edge")
        assert made["matrix"] == ((1.0, 2.0), (3.0, 4.0))
        assert made["flag"] is True

    def test_there_are_hard_cases_that_say_why(self) -> None:
        hard = [case for case in EVERY if case.hard]
        assert len(hard) >= 200
        assert all(len(case.why.split()) >= 3 for case in hard), [case.name for case in hard if not case.why]
        assert sum("found by search" in case.why for case in hard) >= 20
        assert len({case.name + case.task for case in EVERY}) == len(EVERY)

    @pytest.mark.parametrize("file", FILES)
    def test_results_have_forty_digits(self, file: str) -> None:
        lengths = []
        for case in json.loads((DATA / file).read_text(encoding="utf-8"))["cases"]:
            for text in case["results"].values():
                digits = text.lstrip("-").partition("e")[0].replace(".", "").lstrip("0")
                lengths.append(len(digits))
        # others end in zeros, or are zero
        assert sum(length >= 37 for length in lengths) > 0.8 * len(lengths)
        assert max(lengths) == 40

    def test_every_task_with_references_is_a_question(self) -> None:
        asked = {question.cases for question in catalogue.questions("impact", "") if isinstance(question, Question)}
        assert asked == {case.task for case in EVERY} - {"path", "keller"}

    @pytest.mark.parametrize(("file", "task"), [("impact_particles.json", "chain"), ("impact_spatial.json", "spatial")])
    def test_bounds_of_solvers_are_held_against_their_errors(self, file: str, task: str) -> None:
        question = next(one for one in catalogue.questions("impact", task) if isinstance(one, Question))
        cases = [case for case in load(file) if case.task == task]
        errors = errors_of(question.methods[0].call(), cases, GROUPS, tracked=False)
        assert errors.bounded >= 3 * len(cases)
        assert errors.broken == 0
        stated = stated_by(question.methods[0].call()(**build(cases[0].inputs, leaves(cases[0].inputs), GROUPS)))
        assert all(bound.bound < 1e-10 for bound in stated.values())


class TestReport:
    def test_bounds_hold_and_nothing_is_refused(self, rows: list[dict[str, Any]]) -> None:
        own = [row for row in rows if "(chosen)" in row["method"]]
        assert len(own) == 14
        assert {row["bound"] for row in own} == {"bound held"}
        assert all(row["refused"]["value"] == 0 for row in own)

    def test_the_chosen_methods_are_the_most_exact(self, rows: list[dict[str, Any]]) -> None:
        chosen, other = [row["worst"]["value"] for row in rows if row["question"] == "momentum, speeds before"]
        assert chosen < 2e-15
        assert other > 1e-12

    def test_differences_lose_what_the_impulse_keeps(self, rows: list[dict[str, Any]]) -> None:
        for name in ("impact central", "impact planar", "impact oblique", "impact step"):
            _, *alternatives = [row for row in rows if row["question"] == name]
            assert alternatives
            for alternative in alternatives:
                assert alternative["worst"]["value"] > 1e3 * alternative["own_worst"]["value"], alternative["method"]

    def test_times_are_of_one_impact(self) -> None:
        rows = answer("accuracy", "impact", "planar")["results"]["methods"]
        chosen, *alternatives = rows
        assert chosen["slower"]["value"] == 1.0
        for alternative in alternatives:
            ratio = alternative["time"]["value"] / chosen["time"]["value"]
            assert alternative["slower"]["value"] == pytest.approx(ratio, rel=1e-12), alternative["method"]


class TestMomentum:
    def test_all_methods_agree_where_nothing_is_small(self) -> None:
        cases = [case for case in load("impact_particles.json") if case.task == "approach" and not case.hard]
        for function in (reconstruction.cross_products, reconstruction.by_cramer):
            errors = errors_of(function, cases, GROUPS, tracked=False)
            assert errors.cases == len(cases)
            assert max(errors.relative) < 1e-13


class TestPycrash:
    def test_the_peer_answers_the_same_cases(self) -> None:
        pytest.importorskip("pycrash", reason="pycrash is not installed: give it a venv of its own")
        rows = answer("accuracy", "impact", "planar", "--untimed", "--peers")["results"]["methods"]
        peer = next(row for row in rows if row["method"].startswith("pycrash"))
        assert peer["cases"]["value"] >= 5
        # constants of four digits on the way, so no better than this
        assert 1e-9 < peer["median_ulp"]["value"] * 2.0**-52 < 1e-3

    def test_an_absent_peer_is_named(self, monkeypatch: pytest.MonkeyPatch) -> None:
        import sys

        monkeypatch.setitem(sys.modules, "pycrash", None)
        outcome = run("accuracy", "impact", "planar", "--untimed", "--peers", "--json")
        assert outcome.status == 0
        warnings = json.loads(outcome.out)["warnings"]
        assert any(one["code"] == "not-installed" and "pycrash" in one["message"] for one in warnings)

    def test_what_it_has_no_law_for_is_left_to_others(self) -> None:
        case = next(one for one in load("impact_rigid.json") if one.task == "planar" and one.name.endswith("stronge"))
        with pytest.raises(ArithmeticError):
            more_impact_bodies.planar_by_pycrash(**build(case.inputs, leaves(case.inputs), GROUPS))
