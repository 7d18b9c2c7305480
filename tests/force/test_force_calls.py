"""Calls of `dynamics force`: refusals, verdicts, pictures."""

import shlex
from pathlib import Path

import pytest
from harness import answer, run

PARALLEL = " ".join(f'--support "type=roller, at={x}, 0 m"' for x in (5, 6, 7))
DOWN = '--load "force=0, -1000 N, at=2, 0 m"'
SIDE = '--load "force=300, 0 N, at=4, 1 m"'
PIN, ROLLER = '--support "type=pin, at=0, 0 m"', '--support "type=roller, at=5, 0 m"'
REFUSED = {
    "nothing": ("resultant", "missing"),
    "a length": ('resultant --force "10, 0 m" --at "0, 0 m"', "kind"),
    "no direction": ('resultant --force "10 N" --at "0, 0 m"', "no-direction"),
    "couple as a number": ('resultant --moment "5"', "kind"),
    "axis of a couple": ('equivalent --moment "5 N*m" --form wrench', "couple"),
    "axis without direction": ('moment --force "1, 0 N" --at "0, 1 m" --axis "0, 0, 0"', "zero-vector"),
    "spring of no length": (
        'spring --first-end "1, 0 m" --second-end "1, 0 m" --free-length "1 m" --stiffness "1 N/m"',
        "no-length",
    ),
    "damper without rate": (
        'spring --length "1 m" --free-length "1 m" --stiffness "1 N/m" --damping "1 N*s/m"',
        "missing",
    ),
    "springs of no group": ('spring --length "1 m" --free-length "1 m" --stiffness "1, 2 N/m"', "group"),
    "group of one": ('spring --length "1 m" --free-length "1 m" --stiffness "1 N/m" --group series', "group"),
    "group with none": ('spring --length "1 m" --free-length 1m --stiffness "1, 0 N/m" --group series', "no-stiffness"),
    "wedge that jams": ('wedge --load "1 kN" --angle "60 deg" --friction 1', "jams"),
    "wedge without load": ('wedge --load "0 kN" --angle "6 deg" --friction 1', "no-load"),
    "thread that jams": (
        'screw --load "1 kN" --flank-angle 60deg --mean-diameter 8mm --pitch 20mm --friction 0.7', "jams"),
    "lead for a pitch": ('screw --load "1 kN" --thread tr --diameter "8 mm" --pitch "10 mm" --friction 0.1', "pitch"),
    "flank of no thread": (
        'screw --load "1 kN" --flank-angle 90deg --mean-diameter 8mm --pitch 2mm --friction 0.1', "angle"),
    "flank and nominal diameter": (
        'screw --load "1 kN" --flank-angle 3deg --diameter 8mm --pitch 2mm --friction 0.1', "mean-diameter"),
    "collar without diameter": (
        'screw --load 1kN --thread tr --diameter 8mm --pitch 2mm --friction 0.1 --collar-friction 0.1', "collar"),
    "screw without load": ('screw --load "0 N" --thread tr --diameter 8mm --pitch 2mm --friction 0.1', "zero"),
    "no wedge": ('wedge --load "1 kN" --angle "0 deg" --friction 1', "angle"),
    "no mass": ('first-moment --mass "0 kg" --at "1, 0 m"', "no-mass"),
    "underground": ('gravity --mass "1 kg" --altitude "-1 m"', "altitude"),
    "one place": ('gravity --mass "1 kg" --other-mass "1 kg" --distance "0 m"', "distance"),
    "a wall": (
        'friction --mass "1 kg" --angle "90 deg" --friction 1 --width "1 m" --centre-height "1 m" --push-height "1 m"',
        "angle",
    ),
    "half a block": ('friction --mass "1 kg" --friction 0.3 --width "1 m"', "missing"),
    "one pin": (f"equilibrium {DOWN} {PIN}", "mechanism"),
    "rollers in parallel": (f"equilibrium {SIDE} {PARALLEL}", "mechanism"),
    "two pins": (f"equilibrium {DOWN} {PIN} {PIN.replace('at=0', 'at=5')}", "indeterminate"),
    "pin in space": ('equilibrium --force "0, 0, 1 N" --at "1, 0, 0 m" --support "type=pin, at=0, 0 m"', "space"),
    "load without length": (
        f'equilibrium --distributed "5 N/m down, from=1 m, to=1 m" {PIN} {ROLLER}', "no-length"),
    "force for a force per length": (f'equilibrium --distributed "5 N down from 0 m to 1 m" {PIN} {ROLLER}', "kind"),
    "link without direction": (f'equilibrium {DOWN} --support "type=link, at=0, 0 m"', "no-direction"),
}  # fmt: skip


@pytest.mark.parametrize("name", REFUSED)
def test_refusals(name: str) -> None:
    call, code = REFUSED[name]
    out = run(*shlex.split("force " + call), "--json")
    assert out.status in (2, 3), out.err
    assert out.error["code"] == code


def test_a_mechanism_is_refused_with_the_motion_that_is_free() -> None:
    out = run(*shlex.split(f"force equilibrium {DOWN} {PIN}"))
    assert "turns about the point 0 m, 0 m" in out.err
    call = 'force equilibrium --force "0, 0, 1 N" --at "1, 0, 0 m" --support "type=ball, at=0, 0, 0 m"'
    assert "about the axis through 0 m, 0 m, 0 m along y" in run(*shlex.split(call)).err


def test_decimals_in_any_unit_are_exact() -> None:
    loads = " ".join(f'--load "force={x}, 0 lbf, at=0, {y} in"' for x, y in (("0.1", 0), ("0.2", 1), ("-0.3", 2)))
    made = answer(*shlex.split(f"force resultant {loads} --units us"))
    assert made["results"]["system"] == "couple"
    assert made["results"]["moment"]["value"][2] == pytest.approx(0.4 / 12, rel=1e-15)


def test_forces_at_angles_that_cancel() -> None:
    loads = " ".join(f'--load "force=10 N @ {angle} deg, at=0, 0 m"' for angle in (0, 120, 240))
    assert answer(*shlex.split(f"force resultant {loads}"))["results"]["system"] == "zero: in equilibrium"


def test_a_cable_in_compression_is_said_and_not_clipped() -> None:
    call = 'force equilibrium --force "0, 500 N" --at "1, 0 m" --support "type=pin, at=0, 0 m"'
    made = answer(*shlex.split(call + ' --support "type=cable, at=2, 0 m, direction=0, 1"'))
    assert [warning["code"] for warning in made["warnings"]] == ["slack"]


def test_a_body_without_loads_is_said_to_have_none() -> None:
    made = answer(*shlex.split(f"force equilibrium {PIN} {ROLLER}"))
    assert [warning["code"] for warning in made["warnings"]] == ["no-load"]


def test_a_body_that_only_these_loads_leave_at_rest() -> None:
    made = answer(*shlex.split(f"force equilibrium {DOWN} {ROLLER} {ROLLER.replace('5', '0')}"))
    assert made["results"]["verdict"] == "held for these loads alone"
    assert [warning["code"] for warning in made["warnings"]] == ["partial"]


BLOCK = 'force friction --mass "80 kg" --friction 0.4 --width "0.5 m" --centre-height "0.6 m"'


@pytest.mark.parametrize(
    ("more", "verdict"),
    [
        ('--push "200 N" --push-height "1 m"', "tips uphill"),
        ('--push "-200 N" --push-height "1 m"', "tips downhill"),
        ('--push "190 N" --push-height "1 m"', "holds"),
        ('--push "320 N" --push-height "0.2 m"', "slides up"),
        ('--push "0 N" --push-height "0.2 m" --angle "22 deg"', "slides down"),
        ('--push "0 N" --push-height "0 m" --angle "21 deg"', "holds"),
        ('--push "0 N" --push-height "0 m" --angle "23 deg"', "tips downhill"),
    ],
)
def test_blocks(more: str, verdict: str) -> None:
    """Sliding sets in at 21.8 degrees, tipping at 22.6."""
    assert answer(*shlex.split(f"{BLOCK} {more}"))["results"]["verdict"] == verdict


def test_uncertain_forces() -> None:
    made = answer(*shlex.split(f'force equilibrium --load "force=0, -1000±50 N, at=2, 0 m" {PIN} {ROLLER}'))
    assert made["results"]["load"]["std"][1] == pytest.approx(50.0, rel=0.05)


@pytest.mark.parametrize(
    "call",
    [
        f"resultant {DOWN} {SIDE}",
        'resultant --load "force=10, -4, 3 N, at=1, 2, -1 m" --load "force=-6, 8, 2 N, at=-2, 0.5, 3 m"',
        'resultant --moment "5 N*m"',
        'moment --force "200 N @ -60 deg" --at "0.3, 0.1 m"',
        'moment --force "10, -4, 30 N" --at "6, 2, 0 m" --axis "0, 1, 0"',
        f"equilibrium {DOWN} {SIDE} {PIN} {ROLLER}",
        'equilibrium --force "0, -5 N" --at "8, 0 m" --support "type=fixed, at=0, 0 m"',
    ],
)
def test_pictures(call: str, tmp_path: Path) -> None:
    target = tmp_path / "picture.svg"
    assert run(*shlex.split("force " + call), "--plot", str(target)).status == 0
    assert target.stat().st_size > 5000


def test_a_wedge_holds_by_itself_up_to_the_sum_of_its_angles_of_friction() -> None:
    call = ("force", "wedge", "--load", "1 kN", "--friction", "0.2", "--ground-friction", "0.1")
    limit = answer(*call, "--angle", "5 deg")["results"]["limit_angle"]["value"]
    for off, verdict in ((-1e-6, "holds by itself"), (1e-6, "slips out when it is let go")):
        made = answer(*call, "--angle", f"{limit + off} deg")["results"]
        assert made["verdict"] == verdict
        assert (made["release"]["value"] > 0.0) == (off < 0.0)


def test_a_screw_holds_by_itself_from_its_friction_on() -> None:
    call = ("force", "screw", "--load", "1 kN", "--thread", "trapezoidal", "--diameter", "20 mm", "--pitch", "4 mm")
    call += ("--starts", "3")
    limit = answer(*call, "--friction", "0.1")["results"]["locking_friction"]["value"]
    for off, verdict in ((1e-9, "holds by itself"), (-1e-9, "runs back by itself")):
        result = answer(*call, "--friction", str(limit + off))
        assert result["results"]["verdict"] == verdict
        assert (result["results"]["lowering_torque"]["value"] >= 0.0) == (off > 0.0)
        assert ([warning["code"] for warning in result["warnings"]] == ["only-just"]) == (off > 0.0)
    more = ("--collar-diameter", "30 mm", "--friction", str(limit - 1e-3))
    assert answer(*call, *more)["results"]["verdict"] == "holds by the friction of its collar alone"


def test_a_screw_without_friction_loses_nothing() -> None:
    call = "force screw --load 1kN --thread square --mean-diameter 20mm --pitch 4mm --friction 0"
    results = answer(*shlex.split(call))["results"]
    assert results["efficiency"]["value"] == pytest.approx(1.0 if "unit" not in results["efficiency"] else 100.0)
    assert results["raising_torque"]["value"] == pytest.approx(-results["lowering_torque"]["value"])


def test_springs_of_a_group_share_stretch_or_force() -> None:
    call = ("force", "spring", "--length", "120 mm", "--free-length", "100 mm", "--stiffness", "20, 30 N/mm", "--group")
    series, parallel = (answer(*call, group)["results"] for group in ("series", "parallel"))
    assert series["stiffness"]["value"] == pytest.approx(12.0)
    assert parallel["stiffness"]["value"] == pytest.approx(50.0)
    assert sum(row["stretch"]["value"] for row in series["members"]) == pytest.approx(series["stretch"]["value"])
    assert sum(row["force"]["value"] for row in parallel["members"]) == pytest.approx(parallel["tension"]["value"])
    for made in (series, parallel):
        assert sum(row["energy"]["value"] for row in made["members"]) == pytest.approx(made["energy"]["value"])


@pytest.mark.parametrize(
    "support",
    ["type=fixed, at=0, 0 m", "type=guide, at=0, 0 m, direction=0, 1", "type=cable, at=0, 1 m, direction=0, 1"],
)
def test_supports_are_drawn(support: str, tmp_path: Path) -> None:
    picture = tmp_path / "picture.svg"
    more = () if "fixed" in support else ("--support", "type=link, at=1, 0 m, direction=1, 0")
    more += ("--support", "type=roller, at=2, 0 m") if "cable" in support else ()
    call = ("--load", "force=0, -3 N, at=1, 1 m", "--support", support, *more, "--plot", str(picture))
    outcome = run("force", "equilibrium", *call)
    assert "<svg" in picture.read_text(encoding="utf-8"), outcome.err


def test_a_resultant_of_a_scene_with_supports_leaves_them_out() -> None:
    for task in ("resultant", "equivalent"):
        result = answer(*shlex.split(f"force {task} {DOWN} {SIDE} {PIN} {ROLLER}"))
        assert [warning["code"] for warning in result["warnings"]] == ["supports"]
        assert result["results"] == answer(*shlex.split(f"force {task} {DOWN} {SIDE}"))["results"]


def test_uncertain_loads_spread_the_largest_reaction() -> None:
    words = 'equilibrium --load "force=0, -1000 ± 50 N, at=2, 0 m" ' + " ".join((PIN, ROLLER))
    assert "largest reaction 600 N 95 %: 541 to 659" in " ".join(run("force", *shlex.split(words)).out.split())
    document = answer("force", *shlex.split(words))
    assert "interval" in document["results"]["load"]
    assert not document["warnings"]


def test_loads_and_supports_in_short() -> None:
    short = 'force equilibrium --load "500 N down at 2 m" --support "pinned at 0" --support "rocker at 5 m, name=R"'
    long = (
        'force equilibrium --load "force=0, -500 N, at=2, 0 m" --support "type=pin, at=0, 0 m" '
        '--support "type=roller, at=5, 0 m, name=R"'
    )
    first, second = (answer(*shlex.split(call))["results"] for call in (short, long))
    assert first == second


def test_a_hinge_in_the_plane_is_a_pin() -> None:
    hinge, pin = (
        answer(*shlex.split(f'force equilibrium {DOWN} --support "{kind} at 0, 0 m" --support "roller at 5 m"'))
        for kind in ("hinge", "pin")
    )
    assert hinge["results"] == pin["results"]


def test_distributed_loads_have_the_moments_of_their_integrals() -> None:
    # from 200 N/m to 500 N/m over an inclined line of 5 m, against Simpson's rule, exact for polynomials of degree 3
    start, end, low, high = (1.0, 2.0), (4.0, 6.0), (0.0, -200.0), (300.0, -500.0)
    force, moment = [0.0, 0.0], 0.0
    for share, weight in ((0.0, 1.0), (0.5, 4.0), (1.0, 1.0)):
        x, y = (a + share * (b - a) for a, b in zip(start, end, strict=True))
        fx, fy = (5.0 / 6.0 * weight * (a + share * (b - a)) for a, b in zip(low, high, strict=True))
        force = [force[0] + fx, force[1] + fy]
        moment += x * fy - y * fx
    call = 'force resultant --distributed "0, -200 N/m, from=1, 2 m, to=4, 6 m, end_force=300, -500 N/m"'
    results = answer(*shlex.split(call))["results"]
    assert results["force"]["value"] == pytest.approx([*force, 0.0], rel=1e-12)
    assert results["moment"]["value"] == pytest.approx([0.0, 0.0, moment], rel=1e-12)
    # a growing load of 3 kN/m over 6 m: its whole at two thirds of the length
    call = 'force equilibrium --distributed "0 kN/m down, end_force=3 kN/m down, from=0 m, to=6 m" '
    reactions = answer(*shlex.split(call + '--support "pin at 0 m" --support "roller at 6 m"'))["results"]["reactions"]
    assert [one["force"]["value"][1] for one in reactions] == [3000, 6000]


def test_a_block_without_dimensions_is_judged_for_sliding_alone() -> None:
    plain = answer(*shlex.split('force friction --mass "50 kg" --angle "30 deg" --friction 0.4 --push "150 N"'))
    low = answer(
        *shlex.split(
            'force friction --mass "50 kg" --angle "30 deg" --friction 0.4 --push "150 N" --width "9 m" '
            '--centre-height "1 mm" --push-height "1 mm"'
        )
    )
    assert plain["results"].pop("pressure_point", None) is None
    low["results"].pop("pressure_point")
    assert plain["results"] == low["results"]
