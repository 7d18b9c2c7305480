"""Calls of `dynamics human`: published and computed numbers, refusals, files, pictures."""

import math
import shlex
from pathlib import Path
from typing import Any

import pytest
from harness import answer, run
from shell import ROOT

from dynamics_cli.human.joints.walking import smooth

WORKER = f"--input {ROOT}/examples/lifting/worker.toml"
STRIDE = f"{ROOT}/examples/stride"
G = '--gravity "9.81 m/s^2"'
LIFT = (
    "--shank-inclination 80deg --thigh-inclination 120deg --trunk-inclination 40deg --head-inclination 50deg "
    "--forearm-inclination -80deg"
)
FLEXED = (
    "--ankle-flexion 10deg --knee-flexion 40deg --hip-flexion 80deg --neck-flexion -10deg --shoulder-flexion 50deg "
    "--elbow-flexion 10deg"
)
FALL = f'fall --centre-height "1 m" --gyration 0.5477225575051661m {G}'
# What is left of sixteen digits after a sum of eight segments.
FEW = 4e-15


def results(call: str) -> Any:
    return answer(*shlex.split("human " + call))["results"]


def near(value: Any, expected: float, tolerance: float = FEW) -> None:
    number = value["value"] if isinstance(value, dict) else value
    assert number == pytest.approx(expected, rel=tolerance, abs=0.0)


def test_the_thigh_of_a_man() -> None:
    rows = results('segments --mass "75 kg" --sex male')["segments"]
    near(next(row for row in rows if row["name"] == "thigh")["mass"], 10.62)


def test_standing_and_arms_up() -> None:
    standing = results(f"posture {WORKER}")
    near(standing["centre"]["value"][0], 0.001501246, 1e-9)
    near(standing["height"], 0.9998563594, 1e-10)
    near(standing["inertia"], 12.079127860811843673)
    up = results(f"posture {WORKER} --shoulder-flexion 180deg")
    near(up["height"], 1.0585806642, 1e-10)
    near(up["inertia"], 15.609470001500004177)


@pytest.mark.parametrize("pose", [LIFT, FLEXED])
def test_a_lift(pose: str) -> None:
    body = results(f"posture {WORKER} {pose}")
    near(body["centre"]["value"][0], 0.08319691223164274361879632)
    near(body["height"], 0.8707894091001367998951724)
    near(body["inertia"], 9.314653729413508772990741)
    made = results(f'moments {WORKER} {pose} {G} --load 15kg --muscle "joint=back, lever=5 cm"')
    moments = {row["name"]: row["moment"]["value"] for row in made["joints"]}
    near(moments["elbow"], 10.10780712936570421027066)
    near(moments["shoulder"], 10.10780712936570421027066, 1e-14)
    near(moments["hip"], 193.1744713182456404535143)
    near(-moments["knee"], 43.29762289624564045351434, 1e-14)
    near(moments["ankle"], 105.6263848672056662118666)
    near(made["pressure_centre"], 0.1208867670310405099239626)
    near(made["muscle_force"], 3863.489426364912809070286)
    near(made["compression"], 4243.158420181125096209951)
    near(made["shear"], 452.4718873770998781704488)
    words = {row["name"]: row["muscles"] for row in made["joints"]}
    assert words["hip"] == "extensors"
    assert words["knee"] == "flexors"
    assert words["ankle"] == "plantar flexors"
    near(results(f"moments {WORKER} {pose} {G}")["largest"], 127.7416744987573072175951)


def test_a_measured_force_of_the_ground() -> None:
    free = results(f"moments {WORKER} {LIFT} --load 15kg")
    at, up = free["pressure_centre"]["value"], free["ground_force"]["value"][1]
    same = results(f'moments {WORKER} {LIFT} --load 15kg --ground-force "0, {up} N" --ground-at "{at} m"')
    assert abs(same["residual_force"]["value"]) < 1e-9
    assert abs(same["residual_moment"]["value"]) < 1e-9
    off = results(f'moments {WORKER} {LIFT} --load 15kg --ground-force "0, {up + 10} N" --ground-at "{at} m"')
    near(off["residual_force"], 10.0, 1e-9)


def test_motion_of_segments_adds_their_inertia() -> None:
    """All segments and the load accelerated upwards as one weigh more."""
    names = ("foot", "shank", "thigh", "trunk", "head", "upper arm", "forearm", "hand")
    lift = " ".join(f'--segment-motion "segment={name}, acceleration=0, 1.19 m/s^2"' for name in names)
    moving = results(f"moments {WORKER} {LIFT} {G} --load 15kg --load-acceleration 1.19m/s^2 {lift}")
    heavier = results(f'moments {WORKER} {LIFT} --gravity "11 m/s^2" --load 15kg')
    near(moving["largest"], heavier["largest"]["value"], 1e-13)


def test_one_leg_of_a_stride() -> None:
    made = results(f"limb --input {STRIDE}/stance.toml {G}")
    expected = {
        "ankle": (60.411, -700.125725, -44.2951647), "knee": (64.308, -669.242, -46.7863312),
        "hip": (84.486, -562.4048, -77.8023868),
    }  # fmt: skip
    for row in made["joints"]:
        forward, up, moment = expected[row["name"]]
        near(row["force"]["value"][0], forward, 1e-13)
        near(row["force"]["value"][1], up, 1e-13)
        near(row["moment"], moment, 3e-9)


@pytest.mark.parametrize(
    ("start", "time"),
    [
        ("0.1", 1.274741174855313711305016), ("0.01", 2.11256199216349049463276),
        ("1e-6", 5.465392945530238123553197),
    ],
)  # fmt: skip
def test_tripping(start: str, time: float) -> None:
    near(results(f'{FALL} --start "{start} rad"')["time"], time)


def test_a_falling_rod_slips_where_textbooks_say() -> None:
    """A slender rod needs most friction near 35 degrees, 0.371, and slips forward later."""
    made = results('fall --centre-height "1 m" --gyration "0.5773502691896257 m" --start "1e-5 deg" --friction 1')
    near(made["friction_needed"], 0.370573, 1e-4)
    near(made["friction_angle"], 35.1, 2e-3)
    assert made["slip"].endswith("slips forward")
    # 3·sin θ·(3·cos θ − 2)/(1 − 3·cos θ)² = −1
    low, high = 0.9, 1.2
    for _ in range(60):
        middle = 0.5 * (low + high)
        ratio = 3.0 * math.sin(middle) * (3.0 * math.cos(middle) - 2.0) / (1.0 - 3.0 * math.cos(middle)) ** 2
        low, high = (middle, high) if ratio > -1.0 else (low, middle)
    near(made["slip_angle"], math.degrees(low), 1e-9)


def test_solids() -> None:
    frustum = 'solid frustum --length "42 cm" --density "1050 kg/m^3"'
    made = results(f'{frustum} --base-radius "9 cm" --top-radius "6 cm"')
    near(made["mass"], 7.897021453328663263523547)
    near(made["centroid"], 0.1823684210526315789473684)
    near(made["axial"], 0.02367859537874389190120718)
    near(made["about_width"], 0.1231180645223039228437674)
    cylinder = results(f'{frustum} --base-radius "9 cm" --top-radius "9 cm"')
    near(cylinder["mass"], 1050.0 * math.pi * 0.09**2 * 0.42)
    near(cylinder["centroid"], 0.21)
    r, t, density = 0.08, 0.07, 1000.0
    girth, width = 2.0 * math.pi * r + 4.0 * t, 2.0 * (r + t)
    made = results(
        f'solid stadium --length "1 m" --base-girth "{girth!r} m" --base-width "{width!r} m" --density "1 g/cm^3"'
    )
    near(made["mass"], density * 0.04250619298297467672616092)
    near(made["axial"], density * (7.995657543942614942852413e-5 + 2.62850254389335398720046e-4))


def test_the_filter_keeps_what_is_slow_and_has_no_lag() -> None:
    step, slow, fast = 0.01, 1.0, 30.0
    times = [step * k for k in range(200)]
    made = smooth([math.sin(2 * math.pi * slow * t) + math.sin(2 * math.pi * fast * t) for t in times], step, 6.0)
    middle = range(60, 140)
    assert max(abs(made[k] - math.sin(2 * math.pi * slow * times[k])) for k in middle) < 0.01
    assert smooth([2.0, 4.0, 6.0, 8.0, 10.0], step, 6.0) == pytest.approx([2.0, 4.0, 6.0, 8.0, 10.0])


@pytest.mark.parametrize("samples_a_cycle", [25.0, 25.0 / 6.0, 25.0 / 9.0])
def test_the_filter_halves_the_power_at_its_cutoff(samples_a_cycle: float) -> None:
    step = 0.02
    wave = [math.sin(2.0 * math.pi * k / samples_a_cycle) for k in range(600)]
    filtered = smooth(wave, step, 1.0 / (samples_a_cycle * step))
    # whole cycles in the middle, far from the ends
    amplitude = 2.0 * sum(filtered[k] * wave[k] for k in range(250, 350)) / 100.0
    assert amplitude == pytest.approx(math.sqrt(0.5), rel=1e-9)


def test_a_leg_at_rest_over_time_is_the_leg_at_an_instant(tmp_path: Path) -> None:
    """Joint centres that do not move leave weights and the force of the ground."""
    row = "-0.1,0.9,-0.05,0.5,0,0.08,-0.06,0,0.2,0,-30,700,0.05"
    head = "time[s],hip_x[m],hip_y,knee_x,knee_y,ankle_x,ankle_y,heel_x,heel_y,toe_x,toe_y,force_x[N],force_y,at[m]"
    head = head.replace("_y,", "_y[m],").replace("force_y[m]", "force_y[N]").replace("knee_x", "knee_x[m]")
    head = head.replace("ankle_x", "ankle_x[m]").replace("heel_x", "heel_x[m]").replace("toe_x", "toe_x[m]")
    (tmp_path / "still.csv").write_text("\n".join([head, *(f"{0.01 * k:g},{row}" for k in range(8))]))
    made = results(f'gait {tmp_path}/still.csv --mass "75 kg" --sex male {G}')
    at_ankle = (0.05 - 0.0) * 700.0 - (0.0 - 0.08) * -30.0
    foot = 0.0137 * 75.0 * 9.81 * (-0.06 + 0.4415 * 0.26)
    near(made["peaks"][0]["largest"], at_ankle - foot, 1e-9)
    assert made["braking_friction"]["value"] == pytest.approx(30.0 / 700.0)


REFUSED = {
    "a table for two sexes": ('segments --mass "75 kg"', "missing"),
    "a trunk between no points": ('segments --mass "75 kg" --sex male --trunk "60 cm"', "ends"),
    "a woman by a table of men": ('segments --mass "60 kg" --sex female --segment-table dempster', "sex"),
    "no height": ('segments --mass "60 kg" --segment-table zatsiorsky', "missing"),
    "a length below zero": ('segments --mass "60 kg" --sex male --thigh "-1 cm"', None),
    "no such segment": (
        'segments --mass 60kg --sex male --height 1.7m --proportion "segment=tail, share=0.2"', "segment"),
    "a height for lengths": ('posture --mass "75 kg" --sex male --height "1.75 m"', "missing"),
    "a knee that bends backwards": (f"posture {WORKER} --knee-flexion -40deg", "range"),
    "another trunk": (f"posture {WORKER} --trunk-ends shoulder-hip", "ends"),
    "too few joint centres": (
        'posture --mass 75kg --sex male --joint-centre "name=vertex, at=0, 0, 1.7 m"', "missing"),
    "toppling": (f"moments {WORKER} --hip-flexion 90deg --shoulder-flexion 100deg --load 15kg", "topples"),
    "hands on a rail": (f"moments {WORKER} {LIFT} --rail", "undetermined"),
    "two muscles": (
        f'moments {WORKER} --muscle "joint=back, lever=5 cm" --muscle "joint=hip, lever=3 cm"', "undetermined"),
    "upright at rest": (f"{FALL}", "never-falls"),
    "an end before the start": (f"{FALL} --start 50deg --end 40deg", "end"),
    "an impossible body": (
        'fall --centre-height 1m --support-inertia "50 kg*m^2" --mass 75kg --start 5deg', "impossible-body"),
    "too wide for its girth": (
        'solid stadium --length 15cm --base-girth 78cm --base-width 45cm --mass 7kg', "stadium"),
    "too narrow for its girth": (
        'solid stadium --length 15cm --base-girth 78cm --base-width 20cm --mass 7kg', "stadium"),
    "a cutoff too high": (f'gait {STRIDE}/stride.csv --mass 75kg --sex male --cutoff "60 Hz"', "cutoff"),
}  # fmt: skip


@pytest.mark.parametrize("name", REFUSED)
def test_refusals(name: str) -> None:
    call, code = REFUSED[name]
    out = run(*shlex.split("human " + call), "--json")
    assert out.status in (2, 3), out.err
    if code:
        assert out.error["code"] == code


def test_any_posture_and_verdicts() -> None:
    assert results(f"posture {WORKER} --knee-flexion -40deg --any-posture")["balance"]
    out = run(*shlex.split(f"human posture {WORKER} --hip-flexion 90deg --shoulder-flexion 130deg"))
    assert "topples forward" in out.out or "over the feet" in out.out


def test_measured_joint_centres_give_what_the_side_view_gives(tmp_path: Path) -> None:
    """The joints of a side view, moved apart to both sides, weigh and turn the same about the left-right axis."""
    flat = results(f"posture {WORKER} {LIFT} --hip-width 0.17m --shoulder-width 0.36m")
    lines = ["name,at_x[m],at_y[m],at_z[m]"]
    for joint in flat["joints"]:
        x, _, z = joint["at"]["value"]
        if joint["name"] in ("vertex", "neck"):
            lines.append(f"{joint['name']},{x!r},0,{z!r}")
            continue
        arm = joint["name"] in ("shoulder", "elbow", "wrist", "knuckle")
        lines += [
            f"{side} {joint['name']},{x!r},{sign * (0.18 if arm else 0.085)},{z!r}"
            for side, sign in (("left", 1), ("right", -1))
        ]
    (tmp_path / "joints.csv").write_text("\n".join(lines))
    made = results(f'posture --mass "75 kg" --sex male --joint-centre @{tmp_path}/joints.csv')
    near(made["inertia"], flat["inertia"]["value"], 1e-12)
    for row, other in zip(made["tensor"]["value"], flat["tensor"]["value"], strict=True):
        assert row == pytest.approx(other, abs=1e-12)


@pytest.mark.parametrize(
    "call",
    [f"posture {WORKER} {LIFT}", f"moments {WORKER} {LIFT} --load 15kg", f"{FALL} --start 5deg --friction 0.3",
     f"gait {STRIDE}/stride.csv --mass 75kg --sex male", f'moments {WORKER} --hand-force "-40, 0 N"'],
)  # fmt: skip
def test_pictures(call: str, tmp_path: Path) -> None:
    out = run(*shlex.split(f"human {call} --plot {tmp_path}/picture.svg"))
    assert out.status == 0, out.err
    assert (tmp_path / "picture.svg").stat().st_size > 5000


def test_moments_of_rounding_are_zero_and_no_muscle_works() -> None:
    out = run(*shlex.split(f"human moments {WORKER} --load 15kg"))
    rows = [
        line.split() for line in out.out.splitlines() if line.strip().startswith(("neck", "shoulder", "knee", "hip"))
    ]
    assert len(rows) == 4
    assert all(row[1:4] == ["0", "0", "none"] for row in rows), rows


def test_the_muscle_of_the_other_side_pulls_too() -> None:
    document = answer(*shlex.split(f'human moments {WORKER} {LIFT} --load 15kg --muscle "joint=knee, lever=4 cm"'))
    knee = document["results"]["muscles"][0]
    moment = next(row for row in document["results"]["joints"] if row["name"] == "knee")["moment"]["value"]
    assert moment < 0.0
    near(knee["force"], -moment / 0.04)
    assert knee["muscles"] == "flexors"
    assert knee["compression"]["value"] > knee["force"]["value"]
    assert "flexors" in document["warnings"][0]["message"]


def test_a_posture_gives_what_a_fall_takes() -> None:
    body = results(f"posture {WORKER}")
    near(body["gyration"], math.sqrt(12.079127860811843673 / 75.0))


def test_the_whole_table_of_masses_is_shown_without_another_source() -> None:
    call = 'human segments --mass "75 kg" --sex male --segment-table zatsiorsky --height "1.75 m"'
    text = run(*shlex.split(call)).out
    assert "rows more" not in text
    assert "Leva" not in text
    assert "lengths" not in text
