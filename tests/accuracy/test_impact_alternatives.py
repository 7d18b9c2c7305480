"""Impacts in the accuracy report: alternatives that answer what they claim to, hard cases with reasons, a peer."""

import json
from functools import partial
from typing import Any

import pytest
from harness import answer, run
from peers.impact import bodies as more_impact_bodies
from peers.impact import paths as more_impact_paths
from peers.impact import space as more_impact_space
from peers.impact.march import own, scipy

from dynamics_cli.accuracy import catalogue
from dynamics_cli.accuracy.alternatives.impact import paths as impact_paths
from dynamics_cli.accuracy.alternatives.impact import reconstruction
from dynamics_cli.accuracy.cases import DATA, Case, build, leaves, load
from dynamics_cli.accuracy.measure import errors_of, stated_by
from dynamics_cli.accuracy.questions import Question

FILES = ("impact_particles.json", "impact_rigid.json", "impact_spatial.json")
EVERY = [case for file in FILES for case in load(file)]
PATHS = [case for case in load("impact_rigid.json") if case.task == "path"]
SPACE = [case for case in load("impact_spatial.json") if case.task == "keller"]
GROUPS = catalogue.groups("impact")


@pytest.fixture(scope="module")
def rows() -> list[dict[str, Any]]:
    return answer("accuracy", "impact", "--untimed")["results"]["methods"]


def error(prepare: Any, case: Case) -> float:
    names = impact_paths.PLANE if case.task == "path" else impact_paths.SPACE
    return impact_paths.share(case, prepare(case)(), names)


def named(case: str, cases: list[Case]) -> Case:
    return next(one for one in cases if one.name == case)


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
        assert len(own) == 16
        assert {row["bound"] for row in own} == {"bound held"}
        assert all(row["refused"]["value"] == 0 for row in own)

    def test_the_chosen_methods_are_the_most_exact(self, rows: list[dict[str, Any]]) -> None:
        for name in ("planar path, by its impulse", "path in space, by its impulse", "momentum, speeds before"):
            chosen, *alternatives = [row["worst"]["value"] for row in rows if row["question"] == name]
            assert alternatives
            assert chosen < 2e-15
            # the nearest in space is the same series in doubles, as exact but for rounding
            lost = [alternative for alternative in alternatives if alternative > 1e-12]
            assert lost == alternatives or "space" in name, (name, alternatives)

    def test_differences_lose_what_the_impulse_keeps(self, rows: list[dict[str, Any]]) -> None:
        for name in ("impact central", "impact planar", "impact oblique", "impact step"):
            _, *alternatives = [row for row in rows if row["question"] == name]
            assert alternatives
            for alternative in alternatives:
                assert alternative["worst"]["value"] > 1e3 * alternative["own_worst"]["value"], alternative["method"]

    def test_times_are_of_one_impact(self) -> None:
        rows = answer("accuracy", "impact", "planar")["results"]["methods"]
        chosen, *alternatives = [row for row in rows if row["question"].startswith("planar path")]
        assert chosen["slower"]["value"] == 1.0
        for alternative in alternatives:
            ratio = alternative["time"]["value"] / chosen["time"]["value"]
            assert alternative["slower"]["value"] == pytest.approx(ratio, rel=1e-12), alternative["method"]


class TestPaths:
    def test_the_textbook_is_right_where_slip_lasts_or_sticks_at_once(self) -> None:
        right = [case.name for case in PATHS if error(impact_paths.two_cases, case) < 1e-14]
        assert len(right) >= 20
        assert "slip turns round, newton" not in right

    @pytest.mark.parametrize("case", ["rod 1, stronge", "rod 1, newton", "rod 1, poisson", "sticks, newton"])
    def test_steps_err_as_their_length(self, case: str) -> None:
        ways = (more_impact_paths.steps(count) for count in (100, 1000))
        coarse, fine = (error(way, named(case, PATHS)) for way in ways)
        assert 1e-7 < fine < 0.01
        assert fine < 0.3 * coarse

    def test_steps_of_order_five_are_right_to_their_tolerance(self) -> None:
        march = more_impact_paths.by_dormand_prince
        for law in ("stronge", "newton", "poisson"):
            for name in ("rod 1", "slip turns round", "sticks"):
                assert error(march, named(f"{name}, {law}", PATHS)) < 1e-11

    def test_a_spring_is_stronges_law(self) -> None:
        spring = more_impact_paths.by_spring
        assert error(spring, named("rod 0, stronge", PATHS)) < 0.01
        with pytest.raises(ArithmeticError):
            spring(named("rod 0, newton", PATHS))

    def test_integration_with_events_is_right_to_its_tolerance(self) -> None:
        pytest.importorskip("scipy", reason="scipy is not installed")
        integrated = more_impact_paths.by_scipy
        for law in ("stronge", "newton", "poisson"):
            for name in ("rod 1", "slip turns round", "sticks"):
                assert error(integrated, named(f"{name}, {law}", PATHS)) < 1e-9


class TestSpace:
    @pytest.mark.parametrize("name", ["random 3, stronge", "random 7, newton", "random 5, poisson", "elastic, stronge"])
    def test_runge_kutta_errs_with_the_fourth_power_of_its_step_while_slip_lasts(self, name: str) -> None:
        case = named(name, SPACE)
        few, many = (more_impact_space.steps(more_impact_space._rk4, count) for count in (20, 80))
        ratio = error(few, case) / error(many, case)
        assert ratio == pytest.approx(256.0, rel=0.15)

    def test_euler_errs_with_its_step(self) -> None:
        case = named("random 0, stronge", SPACE)
        few, many = (more_impact_space.steps(more_impact_space._euler, count) for count in (100, 1000))
        ratio = error(few, case) / error(many, case)
        assert 5.0 < ratio < 20.0

    def test_lower_orders_of_the_march_err_more(self) -> None:
        found = [
            max(error(partial(impact_paths.taylor, order=order, stride=0.1353), case) for case in SPACE[:12])
            for order in (6, 10, 14, 24)
        ]
        assert found[0] > 100.0 * found[1] > 1e4 * found[2] > 1e5 * found[3]

    def test_dop853_is_right_to_its_tolerance(self) -> None:
        pytest.importorskip("scipy", reason="scipy is not installed")
        for case in (SPACE[0], named("slip stops and sticks, poisson", SPACE)):
            assert error(more_impact_space.integrated(scipy("DOP853", 1e-12)), case) < 1e-8

    def test_steps_of_order_five_err_with_their_tolerance(self) -> None:
        for case in (SPACE[0], named("slip stops and sticks, poisson", SPACE)):
            coarse, fine = (error(more_impact_space.integrated(own(limit)), case) for limit in (1e-6, 1e-10))
            assert fine < 1e-8
            assert fine < coarse < 1e-4


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
