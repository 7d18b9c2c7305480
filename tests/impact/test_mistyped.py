"""Slips of the pen in reconstructions: what is refused or pointed out, each with the number that decides."""

import math
from pathlib import Path

import pytest
from harness import answer, run
from mpmath import mp, mpf

EXAMPLES = Path(__file__).parents[2] / "examples"
PAIR = "impact momentum --first-mass 1500kg --first-approach-heading 0deg --second-mass 1200kg"
AFTER = " --first-exit-speed 8m/s --first-exit-heading 40deg --second-exit-speed 9m/s --second-exit-heading 37deg"
CROSSING = PAIR + " --second-approach-heading 90deg" + AFTER
BOTH = "impact inverse --first-mass 1500kg --first-approach-heading 0deg --second-mass 1200kg"
EXITS = BOTH + " --second-approach-heading 90deg --second-exit-velocity 4.9,9.9m/s --first-exit-velocity"
CAR = "--front-axle 1.2m --rear-axle 1.4m --track 1.5m --radius-of-gyration 1.35m --friction 0.7 --braking 100%"
SLIDE = "impact slide --speed 12m/s --course 30deg --spin 3rad/s " + CAR
RECORD = "impact record --first-mass 1500kg --second-mass 1200kg --first-delta-v-longitudinal"
PLACED = RECORD + " -44.6km/h --first-approach-speed 29km/h --second-approach-heading"
BARRIER = "impact planar --first-mass 1500kg --first-inertia 2500kg*m^2 --first-velocity 15,0m/s --first-lever 2,-0.4m"
CRUSHED = "impact crush --first-mass 1500kg --first-stiffness-a 600N/cm --first-stiffness-b 45N/cm^2"

REFUSED = {
    "no unit of mass": (CROSSING.replace("1500kg", "1500"), 2, "'1500' has no unit", "1500 kg"),
    "negative mass": (CROSSING.replace("1500kg", "-1500kg"), 2, "must be at least 0 kg", "1500 kg"),
    "mass of zero": (CROSSING.replace("1500kg", "0kg"), 3, "mass of the first vehicle must be above zero", ""),
    "no unit of a heading": (CROSSING.replace("40deg", "40"), 2, "'40' has no unit", "40 deg"),
    "no unit of a speed": (CROSSING.replace("8m/s", "8"), 2, "'8' has no unit", "write for example 22 mph"),
    "exit turned round": (CROSSING.replace("40deg", "220deg"), 3, "first would be -0.3782 m/s", "directions of travel"),
    "energy from nowhere": (
        CROSSING.replace("8m/s", "80km/h").replace("37deg", "190deg"), 3, "given 185.7 kJ to the vehicles",
        "the speeds after",
    ),
    "paths on one line": (
        CROSSING.replace("90deg", "3deg").replace("40deg", "1deg").replace("37deg", "2deg"), 3,
        "angle condition is 38.19, above 12", "crush energies",
    ),
    "no headings": (PAIR.replace(" --first-approach-heading 0deg", "") + AFTER, 3, "4 unknowns", "give the missing"),
    "exits that no approach gives": (EXITS + " -11.2,0.2m/s", 3, "driven backwards at 7.28 m/s", "are directions"),
    "spin without unit": (SLIDE.replace("3rad/s", "3"), 2, "'3' has no unit", "170 deg/s"),
    "spin in the wrong unit": (SLIDE.replace("3rad/s", "500rad/s"), 3, "still turns at 338 rad/s", "check the spin"),
    "gyration in centimetres": (SLIDE.replace("1.35m", "135m"), 3, "135 m is not between zero and 2.6 m", "its unit"),
    "no drag": (SLIDE.replace("100%", "0%"), 3, "no wheel brakes", "--braking 2%"),
    "no slide": (SLIDE.replace("12m/s", "0m/s").replace("3rad/s", "0rad/s"), 3, "neither moves nor turns", ""),
    "record without restitution": (RECORD + " -27km/h", 3, "0.1 of which is 9 %", "--least-restitution 0"),
    "record turned round": (PLACED + " 82deg --second-exit-heading 140deg", 3, "backwards at 42.3 km/h", "signs of ΔV"),
    "record that kept its way": (PLACED + " 140deg --second-exit-heading 140deg", 3, "kept its direction", "normal"),
    "normal turned round": (
        PLACED + " 140deg --normal 192deg --least-restitution 0 --greatest-restitution 0.2", 3,
        "from the second to the first is -0.978", "from the first vehicle to the second",
    ),
    "restitutions exchanged": (
        RECORD + " -27km/h --least-restitution 0.5 --greatest-restitution 0.2", 3, "lowest restitution is above", "",
    ),
    "barrier behind": (
        BARRIER + " --second-fixed --normal 190deg --friction 0.5 --restitution 0.1", 3,
        "closing speed is -14.7721 m/s", "turn it by 180 degrees",
    ),
    "restitution above one": (
        BARRIER + " --second-fixed --normal 10deg --friction 0.5 --restitution 1.5", 2, "must be at most 1", "",
    ),
    "wheelbase exchanged": (
        "impact yaw-inertia --mass 1500kg --wheelbase 4.6m --length 2.7m", 3, "2.7 m is not longer than its wheelbase",
        "not exchanged",
    ),
    "all bounce": (
        "impact crush --first-mass 1500kg --first-energy 62kJ --second-mass 1200kg --second-ees 30km/h --restitution 1",
        3, "leaves no energy for damage", "0 to 0.3",
    ),
}  # fmt: skip

POINTED_OUT = {
    "mass in tonnes as kilograms": (CROSSING.replace("1500kg", "1.5kg"), "first of 20723 km/h", "check the masses"),
    "friction in tenths": (SLIDE.replace("0.7 ", "7 "), "friction of 7 is more than tyres", "write 0.7 or 70 %"),
    "stations in metres": (
        CRUSHED + " --first-stations 10,25,30,12m --first-width 150cm", "deeper than cars allow", "",
    ),
    "pulse cut off": ("impact pulse --longitudinal 0,-10,-20,-30km/h", "ΔV still changed by 20 km/h", "final-change"),
    "pulse that jumps": ("impact pulse --longitudinal 0,-1,-4,-9,-60,-22km/h", "still changed by 13 km/h", ""),
}  # fmt: skip


@pytest.mark.parametrize("name", REFUSED)
def test_a_slip_is_refused_with_its_number(name: str) -> None:
    call, status, words, remedy = REFUSED[name]
    outcome = run(*call.split(), "--json")
    assert outcome.status == status
    said = outcome.error.get("errors", [outcome.error])
    assert any(words in one["message"] for one in said), said
    assert any(remedy in (one.get("hint") or "") for one in said), said


@pytest.mark.parametrize("name", POINTED_OUT)
def test_a_slip_is_pointed_out(name: str) -> None:
    call, words, remedy = POINTED_OUT[name]
    found = [one for one in answer(*call.split())["warnings"] if words in one["message"]]
    assert found, name
    assert remedy in found[0].get("remedy", "")


def test_whole_turns_of_a_heading_change_nothing() -> None:
    straight = answer(*CROSSING.split())["results"]["first"]["approach_speed"]["value"]
    turned = answer(*CROSSING.replace("40deg", "400deg").split())["results"]["first"]["approach_speed"]["value"]
    assert turned == pytest.approx(straight, rel=1e-12)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('"12.9, 0.8 m"', '"-12.9, 0.8 m"', "the Ford rest position along x is off by 26 standard deviations"),
        ('"12.9, 0.8 m"', '"120.9, 90.8 m"', "with a probability below 0.0001 %"),
    ],
)
def test_rest_positions_that_nothing_reaches(tmp_path: Path, old: str, new: str, words: str) -> None:
    scene = (EXAMPLES / "exit_motion" / "rests.toml").read_text()
    assert old in scene
    (tmp_path / "rests.toml").write_text(scene.replace(old, new))
    outcome = run("impact", "inverse", "--input", str(tmp_path / "rests.toml"), "--json")
    assert outcome.status == 3
    assert words in outcome.error["message"]


def test_a_car_along_a_wall() -> None:
    """A corner that slides all along a wall: the smooth and the rubbing part of the loss by hand, to 40 digits."""
    wall = "--second-fixed --normal -90deg --friction 0.4 --restitution 0.1"
    car = "--first-mass 1500kg --first-inertia 2500kg*m^2 --first-speed 60km/h --first-heading -15deg"
    call = f"impact planar {car} --first-contact-on-body 2.2,-0.8m {wall}"
    found = answer(*call.split(), "--units", "base")["results"]
    with mp.workdps(40):
        mass, inertia, friction, bounce, tilt = mpf(1500), mpf(2500), mpf("0.4"), mpf("0.1"), mp.radians(-15)
        x, y = (
            mpf("2.2") * mp.cos(tilt) + mpf("0.8") * mp.sin(tilt),
            mpf("2.2") * mp.sin(tilt) - mpf("0.8") * mp.cos(tilt),
        )
        speed = mpf(60) / mpf("3.6")
        # the wall pushes up by p and drags back by friction times p, all the while
        closing = -speed * mp.sin(tilt)
        per_push = 1 / mass + x * (x + friction * y) / inertia
        push = (1 + bounce) * closing / per_push
        u, v = speed * mp.cos(tilt) - friction * push / mass, speed * mp.sin(tilt) + push / mass
        spin = push * (x + friction * y) / inertia
        lost = (mass * (speed**2 - u**2 - v**2) - inertia * spin**2) / 2
        wanted = [mp.sqrt(u * u + v * v), spin, lost, mp.sqrt(2 * lost / mass)]
    names = found["first"]["speed"], found["first"]["spin"], found["energy_lost"], found["equivalent_barrier_speed"]
    for one, value in zip(names, wanted, strict=True):
        assert one["value"] == pytest.approx(float(value), rel=1e-13)
    assert found["equivalent_barrier_speed"]["value"] * 3.6 == pytest.approx(20.2599, abs=5e-5)
    smooth = answer(*call.replace("0.4", "0").replace("0.1", "1").split())["results"]
    assert smooth["equivalent_barrier_speed"]["value"] == pytest.approx(0.0, abs=1e-6)
    assert math.isfinite(smooth["first"]["speed"]["value"])
