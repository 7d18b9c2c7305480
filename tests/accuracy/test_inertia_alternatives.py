"""The questions asked of the inertia family: held bounds, honest losers, peers, references that can be made again."""

import sys
from decimal import Decimal
from types import ModuleType, SimpleNamespace
from typing import Any

import pytest
from harness import answer
from inertia_answers import arguments
from peers.inertia import mesh as more_inertia_mesh

from dynamics_cli.accuracy import catalogue
from dynamics_cli.accuracy.alternatives.inertia import mesh as inertia_mesh
from dynamics_cli.accuracy.cases import Case, flat, load
from dynamics_cli.inertia.section.task import section

FILES = ("eigen.json", "inertia_bodies.json", "inertia_mesh.json", "inertia_sections.json")
CHOICES = (
    "inertia body", "principal moments", "mesh moments", "shell moments", "principal axes, by relative gap",
)  # fmt: skip
MESH_WAYS = [*(prepare for _, prepare in inertia_mesh.METHODS), more_inertia_mesh.once, more_inertia_mesh.by_faces]
# Errors below this are of rounding: which of two is the smaller depends on the processor and the order of sums.
ROUNDING = 1e-13


@pytest.fixture(scope="module")
def rows() -> list[dict[str, Any]]:
    return answer("accuracy", "inertia", "--untimed")["results"]["methods"]  # type: ignore[no-any-return]


def test_every_task_that_has_numbers_of_its_own_is_asked_about() -> None:
    tasks = {question.task for question in catalogue.questions("inertia", "")}
    assert tasks == {"shape", "body", "compare", "tensor", "torque", "mesh", "section"}


def test_every_bound_is_stated_and_held(rows: list[dict[str, Any]]) -> None:
    chosen = [row for row in rows if "(chosen)" in row["method"]]
    assert len(chosen) == len(catalogue.questions("inertia", ""))
    # the direction of an axis is no number with a bound
    chosen = [row for row in chosen if not row["question"].startswith("principal axes")]
    assert [row["question"] for row in chosen if row["bound"] != "bound held"] == []
    assert [row["question"] for row in chosen if row["refused"]["value"]] == []


@pytest.mark.parametrize("question", CHOICES)
def test_every_alternative_loses(rows: list[dict[str, Any]], question: str) -> None:
    chosen, *alternatives = [row for row in rows if row["question"] == question]
    assert alternatives
    assert "(chosen)" in chosen["method"]
    for alternative in alternatives:
        lost = max(ROUNDING, 10.0 * chosen["worst"]["value"])
        assert alternative["worst"]["value"] > lost or alternative["refused"]["value"], alternative["method"]


def test_an_even_body_near_its_origin_loses_digits_by_the_textbook_alone(rows: list[dict[str, Any]]) -> None:
    errors = {row["method"]: row["worst"]["value"] for row in rows if row["question"].endswith("32,768 triangles")}
    lost = [method for method, error in errors.items() if error > ROUNDING]
    assert len(errors) == 2
    assert lost == ["about the origin of the file, LAPACK"]


def test_hard_cases_say_what_makes_them_hard() -> None:
    hard = [case for file in FILES for case in load(file) if case.hard]
    assert len(hard) >= 40
    assert [case.name for case in hard if len(case.why.split()) < 5] == []


@pytest.mark.parametrize("case", load("inertia_sections.json"), ids=lambda case: case.name)
def test_bounds_of_sections_hold_and_are_within_reason(case: Case) -> None:
    answer = section(**arguments(case))
    found = flat(answer)
    bounds = {stated.result: stated.bound * abs(found[stated.result]) for stated in answer.numerics.bounds}
    for name, text in case.results.items():
        error = abs(Decimal(found[name]) - Decimal(text))
        bound = Decimal(bounds[name])
        assert error <= bound <= 100 * max(error, Decimal(2.0**-53) * abs(Decimal(text))), name


class TestMeshes:
    def test_the_textbook_loses_a_distant_body_and_the_chosen_one_does_not(self) -> None:
        case = next(case for case in load("inertia_mesh.json") if case.name == "ball at 1e8 sizes")
        true = float(case.results["moments.xx"])
        assert abs(inertia_mesh.about_origin(case)()["moments.xx"] / true - 1.0) > 1e3
        assert inertia_mesh.twice(case)()["moments.xx"].value == pytest.approx(true, rel=2e-15)

    @pytest.mark.parametrize("prepare", MESH_WAYS)
    def test_every_alternative_is_right_where_it_is_easy(self, prepare: Any) -> None:
        """An alternative that is wrong everywhere shows nothing."""
        case = next(case for case in load("inertia_mesh.json") if case.name == "bracket turned")
        found = prepare(case)()
        assert found.keys() == case.results.keys()
        for name, text in case.results.items():
            value = getattr(found[name], "value", found[name])
            assert value == pytest.approx(float(text), rel=1e-9, abs=1e-9), name


class TestPeers:
    """The adapters, with a library of the test's own in place of the peer's."""

    case = next(case for case in load("inertia_mesh.json") if case.name == "ball 1 turned")

    def test_trimesh_is_given_the_corners_and_gives_moments(self, monkeypatch: pytest.MonkeyPatch) -> None:
        seen: list[Any] = []

        def made(vertices: Any, faces: Any, *, process: bool) -> Any:
            seen.append((vertices.shape, faces.shape, process))
            moments = {
                "volume": 2.0,
                "center_mass": [1.0, 2.0, 3.0],
                "inertia": [[3.0, 0, 0], [0, 1.0, 0], [0, 0, 2.0]],
            }
            return SimpleNamespace(mass_properties=moments)

        stand_in = ModuleType("trimesh")
        stand_in.Trimesh = made  # type: ignore[attr-defined]
        monkeypatch.setitem(sys.modules, "trimesh", stand_in)
        found = more_inertia_mesh.by_trimesh(self.case)()
        assert seen == [((96, 3), (32, 3), False)]
        assert (found["volume"], found["centroid[1]"], found["moments.xx"]) == (2.0, 2.0, 3.0)
        assert [found[f"principal_moments.{name}"] for name in ("first", "second", "third")] == [1.0, 2.0, 3.0]

    @pytest.mark.parametrize("peer", ["trimesh", "mujoco"])
    def test_a_peer_that_is_missing_is_named(self, peer: str, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setitem(sys.modules, peer, None)
        document = answer("accuracy", "inertia", "mesh", "--untimed", "--hard", "--peers")
        assert peer in [warning["message"].split()[0] for warning in document["warnings"]]
        methods = [row["method"].lower() for row in document["results"]["methods"]]
        assert not any(method.startswith(peer) for method in methods)

    @pytest.mark.parametrize(("peer", "far"), [("trimesh", 1e-9), ("mujoco", 1e-5)])
    def test_an_installed_peer_agrees_on_an_easy_body(self, peer: str, far: float) -> None:
        pytest.importorskip(peer, reason=f"{peer} is not installed")
        found = getattr(more_inertia_mesh, f"by_{peer}")(self.case)()
        for name, text in self.case.results.items():
            assert found[name] == pytest.approx(float(text), rel=far, abs=far), name
