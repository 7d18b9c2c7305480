"""Scenes: the model chosen, both sides of every choice, agreement of the models, refusals; envelopes."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from harness import answer, run

from dynamics_cli.impact.planar.envelope import envelope
from dynamics_cli.impact.planar.impact import planar
from dynamics_cli.impact.planar.laws import Law

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"

BALL: dict[str, Any] = {"mass": "1 kg", "velocity": "3, 0, 0 m/s"}
SOLID = {**BALL, "moment": "0.4 kg*m^2", "lever": "1, 0, 0 m"}
OTHER = {"mass": "2 kg"}


def solved(first: dict[str, Any], second: dict[str, Any], contact: dict[str, Any], *more: str) -> dict[str, Any]:
    scene = {"first": first, "second": second, "contact": {"normal": "1, 0, 0", "restitution": 0.5, **contact}}
    return answer("impact", "solve", "--input", "-", *more, stdin=json.dumps(scene))


def model(*scene: Any) -> str:
    return solved(*scene)["model"]["name"].split(",")[0]


class TestChoice:
    def test_on_the_line(self) -> None:
        assert model(BALL, OTHER, {}) == "central"
        assert model(BALL, OTHER, {"friction": 0.5}) == "central"
        assert model(SOLID, {"fixed": True}, {"friction": 0.5}) == "central"

    def test_across_the_line(self) -> None:
        assert model({**BALL, "velocity": "3, 1, 0 m/s"}, OTHER, {}) == "oblique"
        assert model({**SOLID, "yaw_rate": "1 rad/s"}, {"fixed": True}, {}) == "oblique"

    def test_friction_or_levers(self) -> None:
        assert model({**SOLID, "velocity": "3, 1, 0 m/s"}, {"fixed": True}, {"friction": 0.1}) == "planar"
        assert model({**SOLID, "lever": "1, 0.1, 0 m"}, {"fixed": True}, {}) == "planar"
        assert model({**SOLID, "lever": "1, 0.1, 0 m"}, {"fixed": True}, {"friction": 0.1}) == "planar"

    def test_out_of_the_plane(self) -> None:
        body = {"mass": "1 kg", "inertia": "[[0.3, 0, 0], [0, 0.4, 0], [0, 0, 0.5]] kg*m^2", "lever": "1, 0.1, 0.2 m"}
        moving = {**body, "velocity": "3, 1, 0 m/s"}
        assert model(moving, {"fixed": True}, {"friction": 0.1}) == "spatial"
        # without friction the way of the slip does not matter
        assert model(moving, {"fixed": True}, {}) == "planar"
        # in the plane of lever and normal the slip stays on one line
        along = {**body, "inertia": "[[0.5, 0, 0], [0, 0.5, 0], [0, 0, 0.5]] kg*m^2", "velocity": "3, 1, 2 m/s"}
        assert model(along, {"fixed": True}, {"friction": 0.1}) == "planar"

    def test_it_says_why(self) -> None:
        document = solved(BALL, OTHER, {})
        assert "along the normal" in document["model"]["why"]

    def test_examples(self) -> None:
        for name, chosen in (("corner_strike", "planar"), ("thrown_block", "spatial")):
            document = answer("impact", "solve", str(EXAMPLES / f"{name}.toml"))
            assert document["model"]["name"].startswith(chosen)
            assert list(document["files"][0]) >= ["sha256"] or "sha256" in document["files"][0]


class TestAgreement:
    def compare(self, scene: tuple[Any, ...], models: tuple[str, ...]) -> None:
        found = [solved(*scene, "--model", name)["results"] for name in models]
        for other in found[1:]:
            assert other["normal_impulse"]["value"] == pytest.approx(found[0]["normal_impulse"]["value"], rel=1e-13)
            for side in ("first", "second"):
                one, two = found[0][side]["velocity"]["value"], other[side]["velocity"]["value"]
                assert two == pytest.approx(one, rel=1e-12, abs=1e-13)
            assert other["energy_lost"]["value"] == pytest.approx(found[0]["energy_lost"]["value"], rel=1e-12)

    def test_larger_models_agree_where_a_smaller_suffices(self) -> None:
        self.compare((BALL, OTHER, {}), ("central", "oblique", "planar", "spatial"))
        self.compare(({**BALL, "velocity": "3, 1, 0 m/s"}, OTHER, {}), ("oblique", "planar", "spatial"))
        block = {"mass": "1 kg", "inertia": "[[0.3, 0, 0], [0, 0.4, 0], [0, 0, 0.5]] kg*m^2", "lever": "1, 0.4, 0 m"}
        for velocity in ("3, 1, 0 m/s", "3, -9, 0 m/s", "3, 0, 0 m/s", "3, -0.1, 0 m/s"):
            for friction in (0.05, 0.4, 0.9):
                scene = ({**block, "velocity": velocity}, {"fixed": True}, {"friction": friction})
                self.compare(scene, ("planar", "spatial"))

    def test_the_planar_command_agrees(self) -> None:
        document = answer("impact", "solve", str(EXAMPLES / "corner_strike.toml"), "--units", "base")["results"]
        words = [
            "--first-weight", "3400 lbf", "--first-inertia", "2400 kg*m^2", "--first-velocity", "15, 0 m/s",
            "--first-lever", "2.1, -0.5 m", "--second-mass", "1250 kg", "--second-inertia", "1900 kg*m^2",
            "--second-velocity", "0, 9 m/s", "--second-lever", "-0.8, 1.6 m", "--normal", "0.19739555984988078 rad",
            "--friction", "0.5", "--restitution", "0.1", "--units", "base",
        ]  # fmt: skip
        other = answer("impact", "planar", *words)["results"]
        assert document["normal_impulse"]["value"] == pytest.approx(other["normal_impulse"]["value"], rel=1e-13)
        assert document["first"]["pdof"]["value"] == pytest.approx(
            other["first"]["delta_v"]["pdof"]["value"], rel=1e-12
        )

    def test_a_model_too_small_says_what_it_leaves_out(self) -> None:
        document = solved({**SOLID, "lever": "1, 0.3, 0 m"}, {"fixed": True}, {"friction": 0.3}, "--model", "central")
        assert document["warnings"][0]["code"] == "model-too-small"
        assert "friction" in document["warnings"][0]["message"]


class TestRefusals:
    @pytest.mark.parametrize(
        ("first", "second", "contact", "status", "code"),
        [
            (BALL, OTHER, {"normal": "-1, 0, 0"}, 3, "no-impact"),
            (BALL, OTHER, {"normal": "0, 1, 0"}, 3, "no-impact"),
            (BALL, OTHER, {"normal": "0, 0, 0"}, 3, "no-normal"),
            ({**BALL, "lever": "1, 0, 0 m"}, OTHER, {}, 2, "no-inertia"),
            ({**BALL, "moment": "1 kg*m^2"}, OTHER, {}, 2, "no-lever"),
            ({**SOLID, "moment": "0 kg*m^2"}, OTHER, {}, 3, "no-inertia"),
            ({**BALL, "moment": "1 kg*m^2", "centre": "0, 0, 0 m"}, OTHER, {}, 2, "no-contact-point"),
            ({**SOLID, "lever": "1, 0.1, 0.2 m", "velocity": "3, 1, 0 m/s"}, OTHER, {"friction": 0.3}, 3, "one-moment"),
            ({"fixed": True}, {"fixed": True}, {}, 3, "no-mass"),
            ({**BALL, "mass": "3 m"}, OTHER, {}, 2, None),
            ({**SOLID, "centre": "0, 0, 0 m"}, OTHER, {}, 2, None),
            (BALL, OTHER, {"restitution": 1.2}, 2, None),
        ],
    )
    def test_scenes_that_do_not_fit(self, first: Any, second: Any, contact: Any, status: int, code: str | None) -> None:
        scene = {"first": first, "second": second, "contact": {"normal": "1, 0, 0", "restitution": 0.5, **contact}}
        outcome = run("impact", "solve", "--input", "-", "--json", stdin=json.dumps(scene))
        assert outcome.status == status, outcome.err
        if code:
            assert outcome.error["code"] == code

    def test_a_missing_normal(self) -> None:
        scene = {"first": BALL, "second": OTHER, "contact": {"restitution": 0.5}}
        outcome = run("impact", "solve", "--input", "-", "--json", stdin=json.dumps(scene))
        assert outcome.status == 2
        assert outcome.error["parameter"] == "contact.normal"


def crash() -> dict[str, Any]:
    from dynamics_cli.impact.conventions import ByMass, ByVelocity
    from dynamics_cli.impact.planar.bodies import ByInertia, Lever, RigidBody, RigidTarget

    return {
        "first": RigidBody(ByMass(1500.0), ByInertia(2500.0), Lever((2.0, -0.4)), ByVelocity((15.0, 0.0))),
        "second": RigidTarget(ByMass(1200.0), ByInertia(1800.0), Lever((-0.8, 0.5)), ByVelocity((0.0, 10.0))),
        "normal": 0.17,
    }


class TestEnvelope:
    @pytest.mark.parametrize("law", ["stronge", "newton", "poisson", "brach", "kudlich-slibar"])
    def test_every_point_is_the_planar_impact(self, law: str) -> None:
        from dynamics_cli.impact.conventions import Restituted

        found = envelope(**crash(), law=Law(law), restitution_points=20, friction_points=20, map_points=4,
                         greatest_restitution=0.9)  # fmt: skip
        for e, mu, one, lost in zip(
            *(found.map.arrays[name] for name in ("restitution", "friction", "first_delta_v", "energy_lost")),
            strict=True,
        ):
            hit = planar(**crash(), friction=float(mu), contact=Restituted(float(e)), law=Law(law))
            assert one == pytest.approx(hit.first.delta_v.magnitude, rel=1e-13)
            assert lost == pytest.approx(hit.energy_lost, rel=1e-11, abs=1e-6)

    def test_extremes_are_those_of_all_points(self) -> None:
        from dynamics_cli.impact.conventions import Restituted

        found = envelope(**crash(), restitution_points=7, friction_points=9, map_points=9)
        every = [
            planar(**crash(), friction=float(mu), contact=Restituted(float(e)))
            for mu in np.linspace(0.0, 1.0, 9) for e in np.linspace(0.0, 1.0, 7)
        ]  # fmt: skip
        sizes = [hit.first.delta_v.magnitude for hit in every]
        assert found.first_delta_v.least == pytest.approx(min(sizes), rel=1e-13)
        assert found.first_delta_v.greatest == pytest.approx(max(sizes), rel=1e-13)
        spins = [hit.second.spin_change for hit in every]
        assert found.second_spin_change.least == pytest.approx(min(spins), rel=1e-12)
        assert found.second_spin_change.greatest == pytest.approx(max(spins), rel=1e-12)
        full = sum(abs(hit.impulse_ratio) >= mu * (1.0 - 1e-14) for hit, mu in
                   zip(every, np.repeat(np.linspace(0.0, 1.0, 9), 7), strict=True))  # fmt: skip
        assert found.slip_share == pytest.approx(full / 63.0)

    def test_points_that_gain_energy_are_left_out(self) -> None:
        from dynamics_cli.impact.conventions import ByMass, ByVelocity, Fixed
        from dynamics_cli.impact.planar.bodies import ByInertia, Lever, RigidBody, RigidTarget

        rod = RigidBody(ByMass(1.0), ByInertia(1.0 / 12.0), Lever((0.25, -0.433)), ByVelocity((-0.5, -1.0)))
        given = {"first": rod, "second": RigidTarget(Fixed(True)), "normal": -1.5707963267948966}
        found = envelope(**given, law=Law("newton"), restitution_points=50, friction_points=50)
        assert 0 < found.refused < 2500
        assert found.least_energy_lost >= -1e-12
        assert found.advice[0].code == "law-inadmissible"
        assert envelope(**given, restitution_points=50, friction_points=50).refused == 0

    def test_a_million_points_take_no_time(self) -> None:
        found = envelope(**crash())
        assert found.points == 1_000_000

    @pytest.mark.parametrize(
        "change",
        [
            ("--law", "all"),
            ("--least-friction", "2"),
            ("--restitution-points", "0"),
            ("--friction-points", "1000000"),
            ("--first-speed", "1e160 m/s"),
        ],
    )
    def test_refusals(self, change: tuple[str, str]) -> None:
        words = [
            "impact", "envelope", "--first-mass", "1 kg", "--first-inertia", "1 kg*m^2", "--first-lever", "1, 0 m",
            "--second-fixed", "--normal", "0 deg", *change,
        ]  # fmt: skip
        if change[0] != "--first-speed":
            words += ["--first-velocity", "1, 0 m/s"]
        assert run(*words).status == 3


def test_one_point_does_not_cover_a_side_of_an_envelope() -> None:
    from dynamics_cli.errors import InadmissibleError

    for side in ("restitution_points", "friction_points", "map_points"):
        with pytest.raises(InadmissibleError, match="one point along"):
            envelope(**crash(), **{side: 1})
    line = {"least_restitution": 0.2, "greatest_restitution": 0.2, "restitution_points": 1}
    found = envelope(**crash(), **line, friction_points=9)
    assert found.points == 9
    assert len(found.map.arrays["restitution"]) == 5


def test_a_normal_that_passes_a_mass_centre_by_turns_the_body_though_nothing_couples() -> None:
    from dynamics_cli.impact.conventions import ByMass, Fixed
    from dynamics_cli.impact.spatial.impact import LeverInSpace
    from dynamics_cli.impact.spatial.scene import (
        central_suffices,
        oblique_suffices,
        planar_suffices,
        solve,
        solve_planar,
    )
    from dynamics_cli.impact.spatial.scene_records import ByComponents, ByTensor, Scene, SceneBody, SceneContact

    tensor = ((40.0, 0.0, 0.0), (0.0, 40.0, 0.0), (0.0, 0.0, 30.0))
    block = SceneBody(ByMass(250.0), ByTensor(tensor), LeverInSpace((0.5, 0.0, 0.0)), ByComponents((0.0, 0.0, -1.0)))
    scene = Scene(block, SceneBody(Fixed(True)), SceneContact((0.0, 0.0, -1.0), 0.5))
    assert central_suffices(scene) is None
    assert oblique_suffices(scene) is None
    assert planar_suffices(scene)
    # k_n = 1/m + r²/J
    impulse = 1.5 / (1.0 / 250.0 + 0.25 / 40.0)
    for found in (solve_planar(scene), solve(scene)):
        assert found.normal_impulse == pytest.approx(impulse, rel=1e-15)
        assert found.first.spin == pytest.approx((0.0, -0.5 * impulse / 40.0, 0.0), rel=1e-15)
