"""`dynamics multibody`: published trees and hard cases, against numbers of 25 digits and exact fractions.

The branched tree, the gimbal, the universal joint and the free base: mass matrix from partial velocities, solved by
elimination, in mpmath at 50 digits.
"""

from math import cos, sin
from typing import Any

import pytest
from harness import answer, run

ROUNDING = 4e-14
MAN = "0,1,2,3,4,5,3,7,3,9,10,1,12,13,1,15,16"
PLAIN = ("--gravity", "9.81 m/s^2")


def diagonal(*moments: float) -> str:
    return ", ".join(map(str, moments)) + " kg*m^2"


BRANCHED: list[dict[str, Any]] = [
    {"name": "b4", "parent": "b2", "joint": "ball", "position": "0, 0, -0.5 m", "mass": "1 kg",
     "centroid": "0.02, 0.03, -0.2 m", "moments": diagonal(0.02, 0.015, 0.01), "orientation": "0.8, 0.4, -0.2, 0.4",
     "speed": "0.3, -1.1, 0.6 rad/s", "torque": "0.1, 0.2, -0.1 N*m"},
    {"name": "b1", "joint": "pin", "mass": "4 kg", "centroid": "0.1, 0, 0.2 m",
     "tensor": "[[0.3, 0, 0.02], [0, 0.25, 0], [0.02, 0, 0.2]] kg*m^2", "angle": "0.4 rad", "speed": "1.2 rad/s",
     "torque": "2 N*m"},
    {"name": "b3", "parent": "b1", "joint": "slide", "axis": "1, 0, 0", "position": "-0.2, 0, 0.1 m",
     "mass": "1.5 kg", "centroid": "0.1, 0.05, 0 m", "moments": diagonal(0.01, 0.02, 0.03), "slide": "0.15 m",
     "velocity": "0.5 m/s", "force": "-3 N"},
    {"name": "b2", "parent": "b1", "axis": "0, 1, 0", "position": "0.3, 0, 0.4 m", "mass": "2 kg",
     "centroid": "0, 0, -0.25 m", "moments": diagonal(0.05, 0.06, 0.02), "angle": "-0.7 rad", "speed": "-0.8 rad/s",
     "torque": "1 N*m"},
]  # fmt: skip


def values(rows: list[dict[str, Any]], key: str) -> dict[str, float]:
    return {row["name"]: row[key]["value"] for row in rows}


def passed(document: dict[str, Any]) -> dict[str, Any]:
    assert all(check["passed"] for check in document["checks"]), document["checks"]
    return document["results"]  # type: ignore[no-any-return]


def test_the_seventeen_bodies_of_a_man() -> None:
    results = answer("multibody", "topology", "--lower-bodies", MAN)["results"]
    powers = [[int(k) for k in row["array"].split()] for row in results["powers"]]
    assert powers[2] == [0, 0, 1, 2, 3, 4, 2, 3, 2, 3, 9, 0, 1, 12, 0, 1, 15]
    assert powers[3] == [0, 0, 0, 1, 2, 3, 1, 2, 1, 2, 3, 0, 0, 1, 0, 0, 1]
    assert {k: n for k, n in enumerate(powers[4], 1) if n} == {5: 1, 6: 2, 8: 1, 10: 1, 11: 2}
    assert {k: n for k, n in enumerate(powers[5], 1) if n} == {6: 1, 11: 1}
    assert len(powers) == 7
    assert not any(powers[6])
    assert (results["ends"], results["branching"]) == ("6, 8, 11, 14, 17", "1, 3")


def test_a_circle_of_bodies_is_refused() -> None:
    outcome = run("multibody", "topology", "--lower-bodies", "2,3,1")
    assert outcome.status == 2
    assert "1 on 2 on 3 on 1" in outcome.err
    outcome = run("multibody", "topology", "--lower-bodies", "1")
    assert outcome.status == 2
    assert "1 on 1" in outcome.err
    assert answer("multibody", "topology", "--lower-bodies", "0,0")["results"]["depth"]["value"] == 1


def test_accelerations_of_the_branched_tree_in_any_order_of_its_bodies(scene: Any) -> None:
    results = passed(answer("multibody", "accelerations", scene(*BRANCHED), *PLAIN))
    assert values(results["accelerations"], "acceleration") == pytest.approx({
        "b1": 2.72889970260539115240963, "b2": 15.79237936850504168219447, "b3": -1.791555014869730442379518,
        "b4 ωx": -33.73195163692259075341806, "b4 ωy": 18.43412360718901574027261,
        "b4 ωz": -1.420476560808999399127631,
    }, rel=ROUNDING)  # fmt: skip
    reactions = {row["joint"]: row for row in results["reactions"]}
    assert reactions["b4"]["force"]["value"] == pytest.approx(
        (-2.476545883642976791440293, -2.110475201303610646596338, 1.314778664034712576076726), rel=ROUNDING
    )
    assert reactions["b1"]["moment"]["value"] == pytest.approx(
        (4.826530931575133939268374, -12.23035446276398790317594, 2.0), rel=ROUNDING
    )
    assert results["kinetic_energy"]["value"] == pytest.approx(1.302619985309253842012214, rel=ROUNDING)
    assert results["potential_energy"]["value"] == pytest.approx(12.81627298424374238795798, rel=ROUNDING)


def test_efforts_undo_accelerations(scene: Any) -> None:
    found = answer("multibody", "accelerations", scene(*BRANCHED))["results"]["accelerations"]
    rates = [row["acceleration"]["value"] for row in found]
    bodies = [{**body} for body in BRANCHED]
    order = {"b1": [0], "b3": [1], "b2": [2], "b4": [3, 4, 5]}
    names = [row["name"].split()[0] for row in found]
    for body in bodies:
        numbers = [rate for rate, name in zip(rates, names, strict=True) if name == body["name"]]
        assert len(numbers) == len(order[body["name"]])
        sliding = body["name"] == "b3"
        body["acceleration" if sliding else "angular_acceleration"] = (
            ", ".join(map(repr, numbers)) + (" m/s^2" if sliding else " rad/s^2"))  # fmt: skip
    results = passed(answer("multibody", "efforts", scene(*bodies)))
    assert values(results["efforts"], "effort") == pytest.approx(
        {"b1": 2.0, "b2": 1.0, "b3": -3.0, "b4 ωx": 0.1, "b4 ωy": 0.2, "b4 ωz": -0.1}, rel=1e-12)  # fmt: skip
    for row in results["efforts"]:
        parts = sum(row[part]["value"] for part in ("weight", "inertia", "velocity", "loads", "springs"))
        assert parts == pytest.approx(row["effort"]["value"], abs=1e-12)


def test_mass_matrix_and_bias_of_the_branched_tree(scene: Any) -> None:
    results = passed(answer("multibody", "mass-matrix", scene(*BRANCHED), *PLAIN))
    matrix = {row["name"]: [entry["value"] for entry in row["values"]] for row in results["matrix"]}
    names = [row["name"] for row in results["matrix"]]
    assert matrix["b1"][names.index("b1")] == pytest.approx(1.237965494045464141903841, rel=ROUNDING)
    assert matrix["b1"][names.index("b2")] == pytest.approx(0.08712577489955912608686118, rel=ROUNDING)
    assert matrix["b2"][names.index("b2")] == pytest.approx(0.54950784, rel=ROUNDING)
    weight, velocity = (values(results["forces"], part) for part in ("weight", "velocity"))
    bias = {"b1": 1.015722295662536080634964, "b2": -5.709215800995440382598156, "b3": -0.108,
            "b4 ωx": 0.2676042173051239781937455, "b4 ωy": -1.862974205082702550261229,
            "b4 ωz": -0.2588286519516596087389308}  # fmt: skip
    assert {name: weight[name] + velocity[name] for name in names} == pytest.approx(bias, rel=1e-13)


def test_a_universal_joint_is_a_massless_cross(scene: Any) -> None:
    body = {"name": "bob", "joint": "universal", "axis": "1, 0, 0", "mass": "2 kg", "centroid": "0, 0, -0.5 m",
            "moments": diagonal(0.25, 0.25, 0.125), "angle": "0.5, 0.25 rad", "speed": "1, -2 rad/s"}  # fmt: skip
    results = passed(answer("multibody", "accelerations", scene(body), *PLAIN))
    assert list(values(results["accelerations"], "acceleration").values()) == pytest.approx(
        [-7.244504305700006635020966, -3.039656238113110074319215], rel=ROUNDING
    )


def test_a_free_base_with_an_arm_conserves_momentum(scene: Any) -> None:
    bodies = [
        {"name": "base", "joint": "free", "mass": "10 kg", "moments": diagonal(1, 2, 2.5)},
        {"name": "arm", "parent": "base", "axis": "0, 1, 0", "position": "0.5, 0, 0 m", "mass": "2 kg",
         "centroid": "0.4, 0, 0 m", "moments": diagonal(0.01, 0.1, 0.1), "angle": "0.6 rad", "speed": "1.5 rad/s",
         "torque": "3 N*m"},
    ]  # fmt: skip
    results = passed(answer("multibody", "accelerations", scene(*bodies), "--up", "none"))
    rates = values(results["accelerations"], "acceleration")
    assert (rates["base vx"], rates["base vz"]) == pytest.approx(
        (0.4934743821623928967887051, 0.273645248185225980000785), rel=ROUNDING)  # fmt: skip
    assert rates["base ωy"] == pytest.approx(-2.184113120463064950001962, rel=ROUNDING)
    assert rates["arm"] == pytest.approx(12.00468252529004674930761, rel=ROUNDING)
    assert all(abs(rates[name]) < 1e-14 for name in ("base vy", "base ωx", "base ωz"))
    assert all(abs(x) < 1e-12 for x in results["reactions"][0]["force"]["value"])


def gimbal(angle: str) -> list[dict[str, Any]]:
    return [
        {"name": "outer", "axis": "0, 0, 1", "angle": "0.1 rad"},
        {"name": "inner", "parent": "outer", "axis": "0, 1, 0", "angle": angle},
        {"name": "wheel", "parent": "inner", "axis": "1, 0, 0", "moments": diagonal(1, 2, 3), "speed": "5 rad/s"},
    ]


def test_axes_in_line_and_bodies_without_inertia_are_refused(scene: Any) -> None:
    passed(answer("multibody", "accelerations", scene(*gimbal("0.5 rad"))))
    outcome = run("multibody", "accelerations", scene(*gimbal("1.5707963 rad")))
    assert outcome.status == 3
    assert "joint of outer" in outcome.err
    assert "ball joint" in outcome.err
    hand = {"name": "hand", "parent": "arm"}
    arm = {"name": "arm", "mass": "1 kg", "rod": "1, 0, 0 m", "axis": "0, 1, 0"}
    outcome = run("multibody", "accelerations", scene(hand, arm))
    assert outcome.status == 3
    assert "joint of hand" in outcome.err


def test_the_heavy_top_precesses_steadily(scene: Any) -> None:
    """Steady precession: A·φ̇²·cos θ − C·ω₃·φ̇ + m·g·l = 0 leaves no acceleration but that of the turning axes."""
    tilt = 0.5
    for precession in (1.350694400119602990525887, 41.3803278745509890962239):
        spin = 150.0 - precession * cos(tilt)
        top = {
            "name": "top", "joint": "ball", "mass": "1 kg", "centroid": "0, 0, 0.1 m",
            "moments": diagonal(0.02 - 0.01, 0.02 - 0.01, 0.005),
            "orientation": f"{cos(tilt / 2)!r}, {sin(tilt / 2)!r}, 0, 0",
            "speed": f"0, {precession * sin(tilt)!r}, 150 rad/s",
        }  # fmt: skip
        results = passed(answer("multibody", "accelerations", scene(top), *PLAIN))
        rates = values(results["accelerations"], "acceleration")
        # of ω = (θ̇, φ̇ sin θ, ω₃) in axes that spin on by `spin`, at this instant along the body's
        assert rates["top ωx"] == pytest.approx(spin * precession * sin(tilt), rel=1e-12)
        assert abs(rates["top ωy"]) < 1e-10
        assert abs(rates["top ωz"]) < 1e-10


@pytest.mark.parametrize(
    ("change", "word"),
    [
        ({"parent": "b9"}, "b9"),
        ({"angle": "1, 2 rad"}, "takes 1"),
        ({"axis": "0, 0, 0"}, "zero vector"),
        ({"tensor": "[[1, 0, 0], [0, 1, 0], [0, 0, 3]] kg*m^2"}, "no body has the tensor of b1"),
        ({"orientation": "1, 0, 0, 0"}, "takes none"),
        ({"moments": "1, 1, 1 kg*m^2"}, "together"),
    ],
)
def test_refusals_name_the_body(scene: Any, change: dict[str, str], word: str) -> None:
    bodies = [{**body, **change} if body["name"] == "b1" else body for body in BRANCHED]
    outcome = run("multibody", "accelerations", scene(*bodies))
    assert outcome.status in (2, 3)
    assert "b1" in outcome.err
    assert word in outcome.err


def test_quaternions_are_scaled_and_that_is_said(scene: Any) -> None:
    bodies = [{**BRANCHED[0], "orientation": "1.6, 0.8, -0.4, 0.8"}, *BRANCHED[1:]]
    document = answer("multibody", "accelerations", scene(*bodies), *PLAIN)
    assert any("b4" in warning["message"] and "2" in warning["message"] for warning in document["warnings"])
    assert values(document["results"]["accelerations"], "acceleration")["b1"] == pytest.approx(2.728899702605391)


def test_springs_and_loads_of_a_joint(scene: Any) -> None:
    arm = {"name": "arm", "axis": "0, 1, 0", "mass": "3 kg", "rod": "1, 0, 0 m", "torsion_stiffness": "10 N*m/rad",
           "free_angle": "0.2 rad", "torsion_damping": "2 N*m*s/rad", "speed": "0.5 rad/s"}  # fmt: skip
    load = {"body": "arm", "force": "0, 0, 4 N", "at": "1, 0, 0 m"}
    results = passed(answer("multibody", "accelerations", scene(arm, loads=[load]), "--up", "none"))
    # I = 1; 10·0.2 − 2·0.5 from the spring and the damper, −4 from the load, which lifts
    assert values(results["accelerations"], "acceleration")["arm"] == pytest.approx(-3.0, rel=ROUNDING)


def test_uncertain_inputs_spread(scene: Any) -> None:
    """The weight's moment on an arm of 1 m is m·g/2, its inertia m/3: 10 % of the mass is 10 % of the effort."""
    arm = {
        "name": "arm",
        "axis": "0, 1, 0",
        "mass": "3 ± 0.3 kg",
        "rod": "1, 0, 0 m",
        "angular_acceleration": "3 rad/s^2",
    }
    document = answer("multibody", "efforts", scene(arm), "--of", "arm")
    effort = document["results"]["effort"]
    assert effort["value"] == pytest.approx(3.0 - 1.5 * 9.80665)
    deviation = effort["std"]
    assert deviation == pytest.approx(0.1 * abs(effort["value"]), rel=0.02)
    outcome = run("multibody", "efforts", scene(arm), "--of", "leg")
    assert outcome.status == 3
    assert "speeds are arm" in outcome.err


def test_partial_velocities_of_a_point(scene: Any) -> None:
    results = passed(answer("multibody", "kinematics", scene(*BRANCHED), "--of", "b4", "--point", "0, 0, -0.2 m"))
    speeds = {"b1": 1.2, "b2": -0.8, "b3": 0.5, "b4 ωx": 0.3, "b4 ωy": -1.1, "b4 ωz": 0.6}
    total = [sum(speeds[row["speed"]] * row["velocity"]["value"][k] for row in results["partials"]) for k in range(3)]
    assert total == pytest.approx(results["point_velocity"]["value"], rel=1e-12)


@pytest.mark.parametrize(
    ("joint", "field", "value", "remedy"),
    [
        ("pin", "stiffness", "2 N/mm", "give torsion_stiffness"),
        ("pin", "damping", "3 N*s/m", "give torsion_damping"),
        ("slide", "torsion_stiffness", "2 N*m/rad", "give stiffness"),
        ("slide", "rotor_inertia", "4 kg*m^2", "leave out rotor_inertia"),
        ("ball", "damping", "3 N*s/m", "give torsion_damping"),
        ("pin", "second_axis", "0, 1, 0", "leave out second_axis"),
    ],
)
def test_what_a_joint_has_no_use_for_is_refused(scene: Any, joint: str, field: str, value: str, remedy: str) -> None:
    body = {"name": "bar", "joint": joint, "mass": "2 kg", "rod": "1, 0, 0 m", field: value}
    out = run("multibody", "efforts", scene(body))
    assert out.status == 3
    assert field in out.err
    assert remedy in out.err


def test_a_mass_matrix_without_couplings_says_so(scene: Any) -> None:
    text = run("multibody", "mass-matrix", scene({"name": "bar", "mass": "2 kg", "rod": "1, 0, 0 m"})).out
    assert "none" in text
    assert "|" not in text
