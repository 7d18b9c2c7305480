"""Calls of `dynamics balance`: refusals, warnings, uncertainty, pictures."""

import math
import shlex
from pathlib import Path

import numpy as np
import pytest
from harness import answer, run

from dynamics_cli.balance.pictures import _polar
from dynamics_cli.pictures import Label
from dynamics_cli.quantities import Unbalance

ONE = '--first-trial-mass "1 g" --first-trial-angle "0 deg"'
TWO = ONE + ' --second-trial-mass "1 g" --second-trial-angle "0 deg"'
CRANK = '--reciprocating-mass "0.5 kg" --crank-radius "43 mm" --rod-length "150 mm" --speed "3000 rpm"'

FOUR = 'four-runs --initial "6 mm/s" --third "7.5 mm/s" --trial-mass "10 g" '

OTTO = (
    'turning --preset inline-4 --bore "80 mm" --diagram "angle=0 deg, pressure=20 bar" '
    '--diagram "angle=20 deg, pressure=50 bar" --diagram "angle=180 deg, pressure=1 bar" '
    '--diagram "angle=720 deg, pressure=20 bar" '
) + CRANK

REFUSED = {
    "impossible firing order": (OTTO + " --firing-order 1-2-3-4", "firing-order"),
    "incomplete firing order": (OTTO + " --firing-order 1-2-3", "firing-order"),
    "half a cycle": (OTTO.replace("720", "700"), "cycle"),
    "open diagram": (OTTO.replace("720 deg, pressure=20", "720 deg, pressure=21"), "open"),
    "beyond doubles": (OTTO.replace("80 mm", "1e300 mm"), "range"),
    "odd step": (OTTO + ' --step "7 deg"', "step"),
    "far offset": ("engine --preset inline-4 --offset '110 mm' " + CRANK, "rod"),
    "circles too small": (FOUR + '--first "1 mm/s" --second "2 mm/s"', "no-circles"),
    "circles apart": (FOUR + '--first "4 mm/s" --second "3 mm/s"', "no-circles"),
    "circles within": (FOUR + '--first "1 mm/s" --second "19 mm/s"', "no-circles"),
    "phase": (FOUR + '--first "4 mm/s @ 3 deg" --second "9 mm/s"', "phase"),
    "four kinds": (FOUR + '--first "4 um" --second "9 mm/s"', "mixed-kinds"),
    "same angle": (FOUR + '--first "4 mm/s" --second "9 mm/s" --second-angle "0 deg"', "same-angle"),
    "no phase": ('trial --sensor "initial=170 um, first=235 um @ 94 deg" ' + ONE, "no-phase"),
    "kinds": ('trial --sensor "initial=170 um @ 3 deg, first=2 mm/s @ 94 deg" ' + ONE, "mixed-kinds"),
    "no response": ('trial --sensor "initial=170 um @ 3 deg, first=170 um @ 3 deg" ' + ONE, "no-response"),
    "too few": ('trial --sensor "initial=2 um @ 3 deg, first=3 um @ 3 deg, second=4 um @ 9 deg" ' + TWO, "too-few"),
    "second missing": (
        'trial --sensor "initial=1 um @ 0 deg, first=2 um @ 0 deg" --sensor "initial=1 um @ 0 deg, first=3 um @ 0 deg" '
        + TWO, "missing",
    ),
    "dependent": (
        'trial --sensor "initial=1 um @ 0 deg, first=2 um @ 0 deg, second=2 um @ 0 deg" '
        '--sensor "initial=1 um @ 0 deg, first=2 um @ 0 deg, second=2.00000000000001 um @ 0 deg" ' + TWO,
        "dependent-planes",
    ),
    "still": ('trial --sensor "initial=0 um @ 0 deg, first=2 um @ 0 deg" ' + ONE, "nothing-to-balance"),
    "same plane": (
        'planes --amount "3 g*mm" --angle "0 deg" --position "1 m" --first-plane "1 m" --second-plane "1 m"',
        "same-plane",
    ),
    "one bearing": (
        'planes --amount "3 g*mm" --angle "0 deg" --position "1 m" --first-plane "1 m" --second-plane "2 m" '
        '--first-bearing "0 m"', "missing",
    ),
    "one line": ('split --mass "1 g" --angle "9 deg" --first-angle "0 deg" --second-angle "180 deg"', "one-line"),
    "outside": ('split --mass "1 g" --angle "99 deg" --first-angle "0 deg" --second-angle "60 deg"', "outside"),
    "two holes": ('split --mass "1 g" --angle "9 deg" --holes 2', "holes"),
    "at rest": ('grade --grade "6.3 mm/s" --speed "0 rpm" --mass "3 kg"', "at-rest"),
    "short rod": ("engine --preset inline-4 " + CRANK.replace("150 mm", "40 mm"), "rod"),
    "engine at rest": ("engine --preset inline-4 " + CRANK.replace("3000", "0"), "at-rest"),
    "no engine": ("engine " + CRANK, "engine"),
    "bank of a line": ('engine --preset inline-4 --bank-angle "60 deg" ' + CRANK, "no-bank"),
    "odd order": ("lanchester --order 3 " + CRANK, "order"),
    "open cycle": (
        'flywheel --point "angle=0 deg, torque=1 N*m" --point "angle=9 deg, torque=5 N*m" '
        '--point "angle=19 deg, torque=2 N*m" --speed "3 rpm"', "open",
    ),
    "angles back": (
        'flywheel --point "angle=0 deg, torque=1 N*m" --point "angle=9 deg, torque=5 N*m" '
        '--point "angle=8 deg, torque=1 N*m" --speed "3 rpm"', "order",
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", REFUSED)
def test_refusals(name: str) -> None:
    command, code = REFUSED[name]
    outcome = run("balance", *shlex.split(command), "--json")
    assert outcome.status == 3
    assert outcome.error["code"] == code
    assert "nan" not in outcome.err.lower()
    assert "None" not in outcome.err


def test_planes_told_apart_poorly_are_warned_of_and_answered() -> None:
    sensors = (
        '--sensor "initial=1 um @ 0 deg, first=2 um @ 0 deg, second=2 um @ 0 deg" '
        '--sensor "initial=1 um @ 0 deg, first=2 um @ 0 deg, second=2.1 um @ 0 deg" '
    )
    document = answer("balance", "trial", *shlex.split(sensors + TWO))
    assert "condition" in [one["code"] for one in document["warnings"]]
    assert document["results"]["condition"]["value"] > 10.0


def test_a_weak_trial_weight_is_warned_of() -> None:
    document = answer("balance", "trial", *shlex.split('--sensor "initial=9 um @ 0 deg, first=9.1 um @ 0 deg" ' + ONE))
    assert [one["code"] for one in document["warnings"]] == ["weak-trial"]


def test_slow_roll_is_taken_off() -> None:
    plain = '--sensor "initial=5 um @ 0 deg, first=6 um @ 90 deg" '
    with_roll = (
        '--sensor "initial=7 um @ 0 deg, first=6.324555320336759 um @ 71.56505117707799 deg, runout=2 um @ 0 deg" '
    )
    masses = [
        answer("balance", "trial", *shlex.split(rows + ONE))["results"]["first_mass"]["value"]
        for rows in (plain, with_roll)
    ]
    assert masses[0] == pytest.approx(masses[1], rel=1e-13)


def test_uncertain_readings_reach_the_correction() -> None:
    rows = '--sensor "initial=6 ± 0.1 um @ 40 ± 2 deg, first=8 um @ 110 deg" '
    document = answer("balance", "trial", *shlex.split(rows + ONE))
    mass, angle = document["results"]["first_mass"], document["results"]["first_angle"]
    assert mass["std"] > 0.016 * mass["value"]
    assert angle["std"] > 1.0


@pytest.mark.parametrize(
    "command",
    [
        'trial --sensor "initial=6 um @ 40 deg, first=8 um @ 110 deg" ' + ONE,
        'planes --amount "3 g*mm" --angle "0 deg" --position "1 m" --first-plane "0 m" --second-plane "2 m"',
        'engine --preset v6 --spacing "90 mm" ' + CRANK,
        "engine --preset inline-4 " + CRANK,
        'flywheel --point "angle=0 deg, torque=1 N*m" --point "angle=9 deg, torque=5 N*m" '
        '--point "angle=19 deg, torque=1 N*m" --speed "3 rpm"',
    ],
)
def test_pictures_are_drawn(command: str, tmp_path: Path) -> None:
    picture = tmp_path / "picture.svg"
    outcome = run("balance", *shlex.split(command), "--plot", str(picture))
    assert outcome.status == 0, outcome.err
    assert "<svg" in picture.read_text(encoding="utf-8")


def test_couples_are_not_counted_without_places() -> None:
    document = answer("balance", "engine", "--preset", "inline-3", *shlex.split(CRANK))
    assert document["results"].get("primary_couple") is None
    assert [one["code"] for one in document["warnings"]] == ["no-spacing"]
    assert answer("balance", "engine", "--preset", "radial-3", *shlex.split(CRANK))["results"]["primary_couple"] == {
        "value": 0.0, "unit": "N·m"
    }  # fmt: skip


def test_a_turning_moment_goes_to_the_flywheel(tmp_path: Path) -> None:
    table = tmp_path / "diagram.csv"
    table.write_text("# of one cylinder\nangle[deg],pressure[bar]\n0,20\n20,50\n180,1\n720,20\n")
    command = OTTO.partition("--diagram")[0] + f'--diagram "@{table}" ' + CRANK
    document = answer("balance", *shlex.split(command + ' --step "1 deg"'))
    assert document["results"]["firing_order"] == "1-3-4-2"
    assert document["results"] == answer("balance", *shlex.split(OTTO + ' --step "1 deg"'))["results"]
    file = tmp_path / "turning.json"
    assert run("balance", *shlex.split(command + ' --step "1 deg"'), "--output", str(file)).status == 0
    made = answer("balance", "flywheel", "--point", f"@{file}:torque", "--speed", "3000 rpm")["results"]
    assert made["mean_torque"]["value"] == pytest.approx(document["results"]["mean_torque"]["value"], rel=2e-4)


def test_a_rod_without_end_leaves_the_inertia_torque_without_a_mean() -> None:
    made = answer("balance", *shlex.split(OTTO.replace("inline-4", "inline-3").replace("150 mm", "9e99 mm")))
    assert {row["order"]["value"] for row in made["results"]["orders"] if row["inertia"]["value"] > 1e-9} <= {3.0, 6.0}


def test_the_picture_of_four_runs_speaks_in_the_units_of_the_answer(tmp_path: Path) -> None:
    readings = ("--initial", "6 mm/s", "--first", "4 mm/s", "--second", "9 mm/s", "--third", "7.5 mm/s")
    picture = tmp_path / "runs.svg"
    assert run("balance", "four-runs", *readings, "--trial-mass", "10 g", "--plot", str(picture)).status == 0
    assert "where to add 12.56 g, at 337.8 deg" in picture.read_text()


def test_what_dependent_planes_do_together_is_corrected_on_demand() -> None:
    """Against a truncated singular value decomposition of the columns scaled to length 1."""
    readings = [(170, 112, 235, 94, 236, 93.8), (53, 78, 58, 68, 58.2, 68.3), (90, 12, 75, 30, 75.5, 29.5)]
    names = ("initial", "first", "second")
    typed = [
        word
        for row in readings
        for word in (
            "--sensor",
            ", ".join(f"{name}={row[2 * k]} um @ {row[2 * k + 1]} deg" for k, name in enumerate(names)),
        )
    ] + shlex.split(TWO)
    refused = run("balance", "trial", *typed, "--json").error
    assert refused["code"] == "dependent-planes"
    document = answer("balance", "trial", *typed, "--drop-dependent")

    runs = np.array(
        [
            [size * np.exp(1j * np.radians(angle)) for size, angle in zip(row[::2], row[1::2], strict=True)]
            for row in readings
        ]
    )
    influence = runs[:, 1:] - runs[:, :1]
    lengths = np.linalg.norm(influence, axis=0)
    left, sizes, right = np.linalg.svd(influence / lengths)
    masses = -right[0].conj() * (left[:, 0].conj() @ runs[:, 0]) / sizes[0] / lengths
    made = document["results"]
    for name, mass in zip(("first", "second"), masses, strict=True):
        assert made[f"{name}_mass"]["value"] == pytest.approx(abs(mass), rel=1e-10)
        assert made[f"{name}_angle"]["value"] == pytest.approx(np.degrees(np.angle(mass)) % 360.0, rel=1e-10)
    share = np.linalg.norm(runs[:, 0] + influence @ masses) / np.linalg.norm(runs[:, 0])
    assert f"{100 * share:.4g} %" in refused["hint"]
    assert document["warnings"][0]["code"] == "dependent-planes"
    alike = [
        word.replace("236 um @ 93.8", "235 um @ 94")
        .replace("58.2 um @ 68.3", "58 um @ 68")
        .replace("75.5 um @ 29.5", "75 um @ 30")
        for word in typed
    ]
    same = answer("balance", "trial", *alike, "--drop-dependent")["results"]
    assert same["first_mass"]["value"] == pytest.approx(same["second_mass"]["value"], rel=1e-12)
    assert "condition" not in same


def test_four_runs_say_which_of_them_is_off() -> None:
    """Readings made from one unbalance, one of them read wrong: the others miss by less."""
    agree = [abs(6.0 + 4.0 * np.exp(1j * np.radians(turn - 50.0))) for turn in (0.0, 120.0, 240.0)]
    typed = [
        word
        for name, size in zip(("first", "second", "third"), agree, strict=True)
        for word in (f"--{name}", f"{size} mm/s")
    ]
    made = answer("balance", "four-runs", "--initial", "6 mm/s", *typed, "--trial-mass", "10 g")["results"]
    assert all(abs(row["miss"]["value"]) < 1e-12 for row in made["runs"])
    text = run("balance", "four-runs", "--initial", "6 mm/s", *typed, "--trial-mass", "10 g", "--explain").out
    assert "along" not in text


def test_the_size_of_the_outer_ring_keeps_clear_of_the_angles_around() -> None:
    arrow = ((0.0, 0.0), (1.0, 0.5), "1", 0)
    labels = {item.text: item for item in _polar([arrow], Unbalance, "").items if isinstance(item, Label)}
    lowest = min(item.y for text, item in labels.items() if "°" not in text)
    assert lowest - labels["300°"].y > 0.1 * math.hypot(1.0, 0.5)


@pytest.mark.parametrize("grade", ["G6.3", "G 6.3", "g6.3 mm/s", "6.3"])
def test_grades_are_read_as_designated(grade: str) -> None:
    given = ("balance", "grade", "--speed", "3000 rpm", "--mass", "120 kg", "--only", "unbalance")
    assert run(*given, "--grade", grade).out == run(*given, "--grade", "6.3 mm/s").out


def test_a_stroke_stands_for_its_crank_radius() -> None:
    rest = '--preset inline-4 --reciprocating-mass "0.5 kg" --rod-length "140 mm" --speed "6000 rpm"'
    by_radius, by_stroke = (
        answer("balance", "engine", *shlex.split(f'{rest} {crank} "{size} mm"'))["results"]
        for crank, size in (("--crank-radius", 43), ("--stroke", 86))
    )
    assert by_radius == by_stroke


def test_half_the_reciprocating_mass_on_the_crank_leaves_the_part_that_turns_back() -> None:
    """A single cylinder at 50 % balance; a shaft that turns back with as much leaves nothing of order 1."""
    half = "unbalance=10750 g*mm, angle=180 deg"  # half of 0.5 kg at 43 mm
    fitted = shlex.split('--preset inline-1 --reciprocating-mass "0.5 kg" --stroke "86 mm" --rod-length "140 mm"')
    fitted += ["--speed", "6000 rpm", "--counterweight", half]
    row = answer("balance", "engine", *fitted)["results"]["orders"][0]
    assert row["forward"]["value"] == pytest.approx(0.0, abs=1e-9)
    assert row["backward"]["value"] == pytest.approx(0.01075 * (200.0 * math.pi) ** 2)
    made = answer("balance", "engine", *fitted, "--counterweight", half + ", turns=against")["results"]
    assert made["primary_force"]["value"] == pytest.approx(0.0, abs=1e-9)


def test_a_trim_adds_to_the_weights_on_the_rotor() -> None:
    """One gram reads 3 um at 90 degrees: a reading of 1 um is cancelled by a third of a gram opposite."""
    rows = (
        '--sensor "initial=6 um @ 0 deg, first=6.7082039324993690892 um @ 26.565051177077989351 deg, now=1 um @ 90 deg"'
    )
    radii = '--first-trial-radius "100 mm" --first-trial-correction-radius "200 mm"'
    made = answer("balance", "trial", *shlex.split(rows), *shlex.split(ONE), *shlex.split(radii))["results"]
    assert made["first_mass"]["value"] == pytest.approx(1.0 / 6.0)
    assert made["first_unbalance"]["value"] == pytest.approx(100.0 / 3.0)
    assert made["first_angle"]["value"] == pytest.approx(180.0)
