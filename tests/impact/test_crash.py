"""impact crash: equal to its single steps, to motions driven forward in 40 digits, and to the example's numbers."""

import json
import re
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.impact.conventions import Axes, ByMass
from dynamics_cli.impact.crash.agreement import MOST_DEVIATIONS
from dynamics_cli.impact.crash.scene import (
    CrashScene,
    CrashVehicle,
    ImpactLink,
    NamedSurface,
    PhaseBefore,
    SegmentAfter,
    SlideAfter,
)
from dynamics_cli.impact.crash.solve import crash, crash_with_energy, energy_suffices
from dynamics_cli.impact.reconstruction.momentum import momentum
from dynamics_cli.impact.reconstruction.momentum_records import CrushEnergies, Vehicle
from dynamics_cli.numerics.road.phases import Kind, Phase
from dynamics_cli.skid.braking import Segment, speed
from dynamics_cli.skid.timing.timeline import EndSpeed, timeline
from tests.harness import answer, run

REFERENCE = json.loads((Path(__file__).parent / "crash.json").read_text(encoding="utf-8"))
SCENE = Path(__file__).parents[2] / "examples" / "crash_scene" / "crash.toml"
DEGREE = 0.017453292519943295
# Doubles through a root, four sines and a root again.
DIGITS = 1e-13


def example(friction: float = 0.72, **more: Any) -> CrashScene:
    first = CrashVehicle(
        ByMass(1500.0), 90 * DEGREE, exit_heading=48 * DEGREE, before=(PhaseBefore(distance=12.4, surface="road"),),
        after=(SegmentAfter(6.5, "road"), SegmentAfter(4.2, "grass")), name="Ford",
    )  # fmt: skip
    second = CrashVehicle(
        ByMass(1150.0), 0.0, exit_heading=53 * DEGREE, after=(SegmentAfter(11.6, "road", braking=0.75),)
    )
    surfaces = (NamedSurface("road", friction), NamedSurface("grass", 0.45))
    return CrashScene(first, second, surfaces, axes=Axes("compass"), **more)


def changed(scene: CrashScene, side: str, **fields: Any) -> CrashScene:
    vehicle = CrashVehicle(**{**getattr(scene, side).__dict__, **fields})
    return CrashScene(**{**scene.__dict__, side: vehicle})


def test_the_example_as_one_model() -> None:
    """Against the same crash by a linear system in 45 digits."""
    made, reference = crash(example()), REFERENCE["example"]
    assert [made.first.exit_speed, made.second.exit_speed] == pytest.approx(
        list(map(float, reference["exits"])), DIGITS
    )
    approaches = list(map(float, reference["approaches"]))
    assert [made.first.approach_speed, made.second.approach_speed] == pytest.approx(approaches, DIGITS)
    assert made.first.start is not None
    assert made.first.start.speed == pytest.approx(float(reference["start"]), DIGITS)


@pytest.mark.parametrize("case", REFERENCE["cases"])
def test_a_motion_driven_forward_is_found_again(case: dict[str, Any]) -> None:
    sides = {}
    for side, vehicle in case["given"]["vehicles"].items():
        last = float(case["read"][side]["last_distance"])
        slides = [[*part, last] if len(part) == 3 else part for part in vehicle["after"]]
        sides[side] = CrashVehicle(
            ByMass(float(vehicle["mass"])), float(vehicle["heading"]) * DEGREE,
            exit_heading=float(case["read"][side]["exit_heading"]),
            before=tuple(
                PhaseBefore(friction=float(f), grade=float(g), braking=float(b), distance=float(d))
                for f, g, b, d in vehicle["before"]
            ),
            after=tuple(
                SegmentAfter(friction=float(f), grade=float(g), braking=float(b), distance=float(d))
                for f, g, b, d in slides
            ),
        )  # fmt: skip
    made = crash(CrashScene(sides["first"], sides["second"]))
    for side in ("first", "second"):
        course, wanted = getattr(made, side), case["answers"][side]
        assert course.approach_speed == pytest.approx(float(wanted["approach"]), 1e-12)
        assert course.exit_speed == pytest.approx(float(wanted["exit"]), 1e-12)
        assert course.delta_v.magnitude == pytest.approx(float(wanted["delta_v"]), 1e-12)
        if course.start is not None:
            assert course.start.speed == pytest.approx(float(wanted["start"]), 1e-12)
    assert made.energy.impact == pytest.approx(float(case["answers"]["energy_lost"]), 1e-11)
    assert all(check.passed for check in made.checks)
    assert len(made.checks) >= 6


def test_it_equals_its_single_steps_to_the_bit() -> None:
    scene = example()
    exits = [
        speed(segments=(Segment(6.5, 0.72), Segment(4.2, 0.45))).speed,
        speed(segments=Segment(11.6, 0.72, braking=0.75)).speed,
    ]
    met = [
        Vehicle(one.bulk, None, one.approach_heading, exit_speed, one.exit_heading)
        for one, exit_speed in zip((scene.first, scene.second), exits, strict=True)
    ]
    impact = momentum(first=met[0], second=met[1], axes=Axes("compass"))
    before = timeline(
        phases=Phase(Kind("braking"), distance=12.4, friction=0.72), known=EndSpeed(impact.first.approach_speed)
    )
    made = crash(scene)
    assert [made.first.exit_speed, made.second.exit_speed] == exits
    assert made.first.approach_speed == impact.first.approach_speed
    assert made.second.approach_speed == impact.second.approach_speed
    assert made.first.delta_v.pdof == impact.first.delta_v.pdof
    assert made.energy.impact == impact.energy_lost
    assert made.first.start is not None
    assert made.first.start.speed == before.start_speed
    skid = speed(segments=Segment(12.4, 0.72), end_speed=impact.first.approach_speed).speed
    assert made.first.start.speed == pytest.approx(skid, 1e-15)


def test_one_road_is_one_friction() -> None:
    """First order: 0.6929 m/s with one friction; as three independent ones it was 0.5611."""
    document = answer("impact", "crash", str(SCENE), "--method", "linear", "--to", "first.start.speed=m/s")
    assert document["results"]["first"]["start"]["speed"]["std"] == pytest.approx(0.69287343804668619055, 1e-6)
    inputs = [row["input"] for row in document["sensitivity"]["first.start.speed"]["inputs"]]
    assert inputs[0] == "surfaces[0].friction"
    assert sum("friction" in name for name in inputs) == 2


def test_named_tables_are_a_list_with_names(tmp_path: Path) -> None:
    scene, listed = tmp_path / "listed.toml", tmp_path / "plain.toml"
    plain = re.sub(r" ± [0-9.]+", "", SCENE.read_text(encoding="utf-8")).replace("60..90", "75")
    listed.write_text(plain, encoding="utf-8")
    again = plain.replace("[surfaces.road]", '[[surfaces]]\nname = "road"')
    scene.write_text(again.replace("[surfaces.grass]", '[[surfaces]]\nname = "grass"'), encoding="utf-8")
    one, other = (answer("impact", "crash", str(path)) for path in (listed, scene))
    assert one["results"] == other["results"]
    assert one["inputs"] == other["inputs"]


def test_energy_closes_and_the_weakest_link_is_named() -> None:
    made = crash(example())
    energy = made.energy
    spent = energy.before + energy.impact + energy.after + energy.remaining
    assert spent == pytest.approx(energy.start, 1e-13)
    assert made.weakest == "impact, the second"
    assert {one.link for one in made.links} == {
        "slide of Ford", "slide of the second", "impact, Ford", "impact, the second", "braking of Ford"
    }  # fmt: skip


def test_a_slide_that_grade_almost_carries_is_the_weakest_link() -> None:
    downhill = (SegmentAfter(11.6, friction=0.12, grade=-0.11),)
    made = crash(changed(example(), "second", after=downhill))
    link = next(one for one in made.links if one.link == "slide of the second")
    assert link.verdict == "undetermined"
    assert made.weakest == "slide of the second"


def test_phases_back_to_perception_and_the_limit() -> None:
    before = (
        PhaseBefore(Kind("reaction"), duration=1.2),
        PhaseBefore(Kind("build-up"), duration=0.2),
        PhaseBefore(distance=12.4, surface="road"),
    )
    scene = changed(example(speed_limit=15.0), "first", before=before)
    start = crash(scene).first.start
    assert start is not None
    assert start.speed == start.braking_speed
    assert start.speed == pytest.approx(20.170127872641837 + 0.5 * 0.72 * 9.80665 * 0.2, 1e-12)
    assert start.time - start.braking_time == pytest.approx(1.2)  # type: ignore[operator]
    assert start.position == pytest.approx((-start.distance, 0.0), abs=1e-9)
    squares = start.speed**2 - crash(scene).first.approach_speed ** 2
    assert start.impact_speed_at_limit == pytest.approx(max(15.0**2 - squares, 0.0) ** 0.5, 1e-9)
    slow = crash(CrashScene(**{**scene.__dict__, "speed_limit": 10.0})).first.start
    assert slow is not None
    assert slow.impact_speed_at_limit == 0.0


def test_vehicles_on_one_line_by_momentum_and_energy() -> None:
    scene = CrashScene(
        CrashVehicle(ByMass(1000.0), 0.0, exit_heading=0.0, exit_speed=5.0),
        CrashVehicle(ByMass(1000.0), 0.0, exit_heading=0.0, exit_speed=5.0),
        impact=ImpactLink(damage=CrushEnergies(20000.0, 5000.0)),
    )
    assert energy_suffices(scene) is not None
    assert energy_suffices(example()) is None
    made = crash_with_energy(scene)
    assert (made.first.approach_speed, made.second.approach_speed) == (10.0, 0.0)
    assert made.energy.remaining == 25000.0


def test_the_rest_position_gives_the_exit_heading() -> None:
    found = crash(example()).first.rest_position
    assert found is not None
    made = crash(changed(example(), "first", exit_heading=None, rest=found))
    assert made.first.approach_speed == pytest.approx(15.222566012296452, 1e-12)
    assert made.agreements[0].distance_gap == pytest.approx(0.0, abs=1e-9)


def uncertain(tmp_path: Path, line: str) -> Any:
    scene = tmp_path / "scene.toml"
    text = SCENE.read_text(encoding="utf-8").replace('name = "Ford"', f'name = "Ford"\n{line}')
    scene.write_text(text, encoding="utf-8")
    return run("impact", "crash", str(scene), "--json", "--method", "linear")


def test_links_that_contradict_each_other_are_refused_by_name(tmp_path: Path) -> None:
    """The speed into the impact has a deviation of 2.5 km/h: 54.8 against 66 is beyond three, against 60 within."""
    refused = uncertain(tmp_path, 'recorded_speed = "66 ± 1 km/h"')
    assert refused.status == 3
    for word in ("momentum", "record", "54.8", "66"):
        assert word in refused.error["message"]
    assert "without first.recorded_speed" in refused.error["hint"]
    told, *_ = uncertain(tmp_path, 'recorded_speed = "60.5 ± 1 km/h"').document["warnings"]
    assert "standard deviations" in told["message"]
    assert "give the uncertainties" not in told["remedy"]
    kept = uncertain(tmp_path, 'recorded_speed = "60 ± 1 km/h"')
    assert kept.status == 0
    (entry,) = kept.document["results"]["agreements"]
    assert 1.0 < entry["normalised"]["value"] < MOST_DEVIATIONS
    assert uncertain(tmp_path, 'rest = "7.9 ± 0.3, 7.2 ± 0.3 m"').status == 0
    assert uncertain(tmp_path, 'rest = "14 ± 0.3, 7.2 ± 0.3 m"').status == 3


def test_exact_inputs_that_differ_are_told_not_refused() -> None:
    made = crash(changed(example(), "first", recorded_speed=20.0))
    assert [note.code for note in made.advice] == ["links-differ"]
    assert crash(changed(example(), "first", recorded_speed=15.5)).advice == ()


@pytest.mark.parametrize(
    ("side", "fields", "words"),
    [
        ("first", {"after": (SegmentAfter(6.5, "gravel"),)}, "no surface 'gravel'"),
        ("first", {"after": (SegmentAfter(6.5),)}, "neither a surface nor a friction"),
        ("first", {"after": (SegmentAfter(6.5, "road", 0.7),)}, "are both given"),
        ("first", {"exit_speed": 11.0}, "determines it too"),
        ("first", {"exit_heading": None, "rest": (0.0, 0.0)}, "at the point of impact"),
        ("first", {"exit_heading": None, "approach_heading": None}, "unknowns"),
        ("second", {"after": (SegmentAfter(5.0, "road", grade=-0.8),)}, "second.after[0]: the drag factor"),
    ],
)
def test_what_cannot_be_is_refused_with_its_place(side: str, fields: dict[str, Any], words: str) -> None:
    with pytest.raises(InadmissibleError, match=words.replace("[", r"\[")):
        crash(changed(example(), side, **fields))


@settings(max_examples=20, deadline=None)
@given(st.floats(0.3, 0.9), st.floats(-3.0, 3.0))
def test_turning_the_scene_changes_no_speed(friction: float, turn: float) -> None:
    scene = example(friction)
    turned = scene
    for side in ("first", "second"):
        vehicle = getattr(scene, side)
        headings = {"approach_heading": vehicle.approach_heading + turn, "exit_heading": vehicle.exit_heading + turn}
        turned = changed(turned, side, **headings)
    one, other = crash(scene), crash(turned)
    assert other.first.approach_speed == pytest.approx(one.first.approach_speed, 1e-12)
    assert other.second.delta_v.pdof == pytest.approx(one.second.delta_v.pdof, 1e-9)


@settings(max_examples=20, deadline=None)
@given(st.floats(0.3, 0.9))
def test_a_mirror_turns_only_what_has_a_side(friction: float) -> None:
    scene = example(friction)
    mirrored = scene
    for side in ("first", "second"):
        vehicle = getattr(scene, side)
        headings = {"approach_heading": -vehicle.approach_heading, "exit_heading": -vehicle.exit_heading}
        mirrored = changed(mirrored, side, **headings)
    one, other = crash(scene), crash(mirrored)
    assert other.second.approach_speed == pytest.approx(one.second.approach_speed, 1e-12)
    assert other.first.delta_v.pdof == pytest.approx(-one.first.delta_v.pdof, 1e-12)


def test_the_report_of_a_scene_calculates_it_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    plain = re.sub(r" ± [0-9.]+", "", SCENE.read_text(encoding="utf-8")).replace("60..90", "75")
    Path("scene.toml").write_text(plain, encoding="utf-8")
    document = run("impact", "crash", "scene.toml", "--json")
    Path("crash.json").write_text(document.out, encoding="utf-8")
    assert run("report", "crash.json", "--output", "report.md").status == 0
    page = Path("report.md").read_text(encoding="utf-8")
    assert "1 of 1 calculation gave the same results" in page
    assert "Ford" in page


def test_the_picture_has_the_marks_and_every_outline_to_scale() -> None:
    from dynamics_cli.impact.crash import pictures
    from dynamics_cli.pictures import Curve

    scene = example()
    panel = pictures.crash(crash(scene), scene).panels[0]
    marks = [item for item in panel.items if isinstance(item, Curve) and item.style == "track"]
    assert sum(item.x[1] - item.x[0] == pytest.approx(12.4) for item in marks) == 2
    bodies = [item for item in panel.items if isinstance(item, Curve) and item.style == "filled" and len(item.x) == 9]
    assert len(bodies) == 5


WHEELS: dict[str, Any] = {
    "front_axle": 1.2, "rear_axle": 1.5, "track": 1.5, "radius_of_gyration": 1.35, "braking": 0.05, "left_front": 1.0,
}  # fmt: skip


def spinning(friction: float = 0.72, rest: tuple[float, float] = (7.9, 7.2), nose: float = 230 * DEGREE) -> CrashScene:
    slide = SlideAfter(nose, surface="road", **WHEELS)
    return changed(example(friction), "first", exit_heading=None, after=(), rest=rest, slide=slide)


def test_a_slide_with_spin_is_that_of_impact_slide() -> None:
    from dynamics_cli.impact.slide.records import AtRest
    from dynamics_cli.impact.slide.task import slide

    made = crash(spinning())
    alone = slide(motion=AtRest((7.9, 7.2), 230 * DEGREE), friction=0.72, nose=90 * DEGREE, axes=Axes("compass"),
                  **WHEELS)  # fmt: skip
    assert made.first.exit_speed == pytest.approx(alone.speed, 1e-6)
    assert made.first.exit_heading == pytest.approx(alone.course, abs=1e-6)
    assert made.first.exit_spin == pytest.approx(alone.spin, abs=1e-5)
    assert made.first.rest_position == (7.9, 7.2)
    assert [row.what for row in made.courses if row.vehicle == "Ford"][-1] == "slide with spin, road"
    assert all(check.passed for check in made.checks)


def test_derivatives_and_samples_of_a_slide_with_spin() -> None:
    """Derivatives against differences of the solved slide; a grid over samples against the slide itself."""
    import numpy as np

    from dynamics_cli.core.uncertainty.model import Sampled
    from dynamics_cli.impact.slide.separation import separation
    from dynamics_cli.numerics.tracked import Tracked
    from dynamics_cli.sampling import Drawing

    body = (1.2, 1.5, 1.5, 1.35, 0.1, 1.0, 0.05, 0.05, 0.05)
    numbers = (10.7, 0.74, -2.44)
    tracked = separation(body, *Tracked.inputs(numbers))
    for index in range(3):
        # wide enough that what the solver leaves is small beside it
        ends = [separation(body, *(n + sign * 1e-3 * (k == index) for k, n in enumerate(numbers))) for sign in (1, -1)]
        for result in range(3):
            slope = (ends[0][result] - ends[1][result]) / 2e-3
            assert tracked[result].slopes[index] == pytest.approx(slope, rel=0.03, abs=0.003)  # type: ignore[attr-defined]
    rng = np.random.default_rng(1)
    drawn = rng.standard_normal((3, 40)) * np.array([[0.3], [0.03], [0.14]])
    places = (np.array(numbers)[:, None] + drawn).view(Sampled)
    # the brakes of three wheels vary with the places
    share = rng.uniform(0.03, 0.07, 40).view(Sampled)
    with Drawing() as samples:
        many = np.array(separation((*body[:6], share, share, share), *places))[:, ::3]  # type: ignore[arg-type]
        rows = zip(share.tolist()[::3], places.T.tolist()[::3], strict=True)
        single = np.array([separation((*body[:6], one, one, one), *place) for one, place in rows]).T
    spread = single.std(axis=1)
    # a kink of the map, where another wheel stands at last, is rounded off
    off = np.sqrt(((many - single) ** 2).mean(axis=1)) / spread
    assert (off < 0.01).all()
    assert 0.0 < samples.missed < 0.01


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"rest": None}, "first.slide: the slide goes to the rest position"),
        ({"exit_heading": 0.8}, "the exit heading and a slide with spin"),
        ({"after": (SegmentAfter(6.5, "road"),)}, "stretches after the impact and a slide with spin"),
        ({"slide": SlideAfter(4.0, surface="gravel", **WHEELS)}, "no surface 'gravel'"),
        ({"slide": SlideAfter(4.0, **WHEELS)}, "neither a surface nor a friction"),
    ],
)
def test_a_slide_with_spin_refuses_what_contradicts_it(fields: dict[str, Any], words: str) -> None:
    with pytest.raises(InadmissibleError, match=words):
        crash(changed(spinning(), "first", **fields))


def test_the_speed_limit_of_a_scene_is_a_limit_of_every_vehicle() -> None:
    """Its speed at the start where that is known, otherwise into the impact; --limit replaces it."""
    scene = "impact", "crash", str(SCENE), "--method", "linear"
    limits = answer(*scene)["limits"]
    assert [entry["result"] for entry in limits] == ["first.start.speed", "second.approach_speed"]
    assert [entry["probability"] for entry in limits] == pytest.approx([0.85, 0.0], abs=0.02)
    assert run(*scene, "-q", "--fail").status == 6
    asked = answer(*scene, "--limit", "second.approach_speed=50 km/h")["limits"]
    assert [entry["result"] for entry in asked] == ["second.approach_speed"]
