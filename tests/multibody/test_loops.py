"""Loops of a tree of bodies: the four-bar released, its change point, loops that do not close.

Reference: the four-bar by Lagrange multipliers, by an orthogonal complement and by sums of reactions, in mpmath at 50
digits, which agree.
"""

from typing import Any

import pytest
from harness import answer, run

ROUNDING = 1e-13
PLAIN = ("--gravity", "9.81 m/s^2")
PIN = "0, 1, 0"


def closed(scene: Any, bodies: list[dict[str, Any]], loops: list[dict[str, Any]]) -> Any:
    return scene(*bodies, loops=loops)


def four_bar(**crank: str) -> tuple[list[dict[str, Any]], list[dict[str, Any]]]:
    bodies = [
        {"name": "rocker", "axis": PIN, "position": "1, 0, 0 m", "mass": "1.5 kg", "rod": "0.2, 0, 0.7 m"},
        {"name": "coupler", "parent": "crank", "axis": PIN, "position": "0.3, 0, 0.4 m", "mass": "2 kg",
         "rod": "0.9, 0, 0.3 m"},
        {"name": "crank", "axis": PIN, "mass": "1 kg", "rod": "0.3, 0, 0.4 m", **crank},
    ]  # fmt: skip
    loop = {"first": "coupler", "second": "rocker", "first_at": "0.9, 0, 0.3 m", "second_at": "0.2, 0, 0.7 m"}
    return bodies, [{**loop, "axis": PIN}]


def rates(document: dict[str, Any]) -> dict[str, float]:
    assert all(check["passed"] for check in document["checks"]), document["checks"]
    return {row["name"]: row["acceleration"]["value"] for row in document["results"]["accelerations"]}


def test_the_four_bar_released(scene: Any) -> None:
    document = answer("multibody", "accelerations", closed(scene, *four_bar()), *PLAIN)
    assert rates(document) == pytest.approx({
        "crank": 12.17657109355370054998744, "coupler": -14.95368379910103576314247,
        "rocker": 5.767849465367542365783523,
    }, rel=ROUNDING)  # fmt: skip
    forces = {(row["joint"], row["by"]): row["force"]["value"] for row in document["results"]["reactions"]}
    expected = {
        ("coupler", "rocker"): (1.92631382785672408498283, 0.0, 7.026998939110527932103074),
        ("crank", "ground"): (9.417123454032775901058098, 0.0, 15.76997417571679834724588),
        ("rocker", "ground"): (4.95443479717468381702918, 0.0, 20.87682151930539657723555),
        ("coupler", "crank"): (6.98180923532203579106061, 0.0, 7.786459839749853429743991),
    }
    assert forces.keys() == expected.keys()
    for joint, force in expected.items():
        assert forces[joint] == pytest.approx(force, rel=ROUNDING, abs=ROUNDING)
    # a planar loop of pins in space holds three components more than it needs
    assert {row["undetermined"] for row in document["results"]["reactions"]} == {"Fy, Mx, Mz"}


def test_the_four_bar_moving(scene: Any) -> None:
    document = answer("multibody", "accelerations", closed(scene, *four_bar(speed="1 rad/s")), *PLAIN)
    assert rates(document) == pytest.approx({
        "crank": 12.70014267297247228896498, "coupler": -16.02011657089700675878302,
        "rocker": 5.403036916628404888980007,
    }, rel=ROUNDING)  # fmt: skip
    speeds = {row["name"]: row["speed"]["value"] for row in document["results"]["accelerations"]}
    assert speeds == pytest.approx(
        {"crank": 1.0, "coupler": -1.22807017543859649122807, "rocker": 0.4736842105263157894736842}, rel=ROUNDING
    )
    assert document["results"]["kinetic_energy"]["value"] == pytest.approx(0.2480540166204986149584488, rel=ROUNDING)


def test_a_crank_angle_moves_the_others(scene: Any) -> None:
    document = answer("multibody", "accelerations", closed(scene, *four_bar(angle="10 deg")))
    assert any(warning["code"] == "moved" for warning in document["warnings"])


def parallelogram(angle: str) -> tuple[list[dict[str, Any]], list[dict[str, Any]]]:
    back = f"-{angle}"
    bodies = [
        {"name": "crank", "axis": PIN, "mass": "1 kg", "rod": "0.3, 0, 0 m", "angle": angle},
        {"name": "coupler", "parent": "crank", "axis": PIN, "position": "0.3, 0, 0 m", "mass": "1 kg",
         "rod": "0.5, 0, 0 m", "angle": back},
        {"name": "rocker", "axis": PIN, "position": "0.5, 0, 0 m", "mass": "1 kg", "rod": "0.3, 0, 0 m",
         "angle": angle},
    ]  # fmt: skip
    loop = {"first": "coupler", "second": "rocker", "first_at": "0.5, 0, 0 m", "second_at": "0.3, 0, 0 m"}
    return bodies, [{**loop, "axis": PIN}]


def test_a_change_point_is_refused(scene: Any) -> None:
    assert rates(answer("multibody", "accelerations", closed(scene, *parallelogram("0.001 rad"))))
    outcome = run("multibody", "accelerations", closed(scene, *parallelogram("0 rad")))
    assert outcome.status == 3
    assert "change point" in outcome.err


def test_a_loop_that_cannot_close_is_refused_with_its_gap(scene: Any) -> None:
    bodies, loops = four_bar()
    outcome = run("multibody", "accelerations", closed(scene, bodies, [{**loops[0], "first_at": "3, 0, 0 m"}]))
    assert outcome.status == 3
    # 3 m less crank, rocker and ground: 3 − 0.5 − √0.53 − 1
    assert "a gap of 0.772 m remains" in outcome.err


def test_a_ball_joint_closes_a_loop_in_space(scene: Any) -> None:
    """A rod held at both ends by ball joints spins about its line alone, and falls not at all."""
    rod = {"name": "rod", "joint": "ball", "mass": "3 kg", "centroid": "0.5, 0, 0 m", "moments": "0.1, 0.3, 0.3 kg*m^2"}
    loop = {"first": "rod", "first_at": "1, 0, 0 m", "second_at": "1, 0, 0 m"}
    document = answer("multibody", "accelerations", scene(rod, loops=[loop]), *PLAIN)
    assert all(abs(rate) < 1e-13 for rate in rates(document).values())
    forces = [row["force"]["value"][2] for row in document["results"]["reactions"]]
    assert forces == pytest.approx([14.715, 14.715], rel=ROUNDING)
    assert document["results"]["reactions"][0]["undetermined"] == "Fx"


def test_other_tasks_refuse_loops(scene: Any) -> None:
    outcome = run("multibody", "efforts", closed(scene, *four_bar()))
    assert outcome.status == 3
    assert "multibody accelerations" in outcome.err
    results = answer("multibody", "topology", closed(scene, *four_bar()))["results"]
    assert (results["constraints"]["value"], results["least_freedoms"]["value"]) == (5, 0)
