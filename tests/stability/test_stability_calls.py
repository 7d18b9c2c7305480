"""Calls of `dynamics stability`: refusals, verdicts, pictures."""

import shlex
from pathlib import Path

import numpy as np
import pytest
from harness import answer, run

RANGE = '--lowest "-1 m" --highest "1 m"'
REFUSED = {
    "zero": ('routh "0, 0"', "zero-polynomial"),
    "number": ("routh 7", "no-variable"),
    "other letters": ('routh "s^2 + x"', "polynomial"),
    "division": ('routh "s^2 + 1/s"', "polynomial"),
    "open bracket": ('routh "s(s+1"', "polynomial"),
    "power": ('routh "s^99"', "polynomial"),
    "uncertain": ('routh "s^2 + 3 ± 0.1"', "polynomial"),
    "long number": ('routh "s + 1e999"', "polynomial"),
    "no gain": ('gain "s^2 + s + 1"', "no-gain"),
    "two gains": ('gain "s^2 + Ks + L"', "polynomial"),
    "pairs at every gain": ('gain "s^2 + K"', "symmetric"),
    "no pair": ('gain "s(s+1)(s+2) + K" --damping-ratio 1.5', "damping-ratio"),
    "no such pair": ('gain "s + 1 + K" --damping-ratio 0.5', "no-design"),
    "squared gain": ('gain "s^2 + s + K^2" --damping-ratio 0.5', "gain-degree"),
    "degree of gains": ('gain "s^17 + K"', "degree"),
    "leading range": ('interval "-1..1, 2"', "degree"),
    "words": ('interval "1, two"', "polynomial"),
    "open range": ('interval "1, [2, 3, 4"', "syntax"),
    "advanced": ('delay "s" --delayed "s^2"', "advanced"),
    "neutral": ('delay "s" --delayed "s + 1"', "neutral"),
    "not square": ('matrix "1, 2; 3"', "matrix"),
    "sizes": ('matrix --mass "1" --stiffness "1, 0; 0, 1"', "sizes"),
    "singular": ('matrix --mass "1, 1; 1, 1" --stiffness "1, 0; 0, 1"', "singular"),
    "not skew": ('matrix --mass "1, 0; 0, 1" --stiffness "1, 0; 0, 1" --gyroscopic "0, 1; 1, 0"', "gyroscopic"),
    "nothing": ("matrix", "missing"),
    "both": ('matrix "1" --mass "1"', "ambiguous"),
    "two coordinates": ('equilibrium --potential "x + theta J"', "coordinate"),
    "no range": ('equilibrium --potential "x^2 J"', "missing"),
    "slope": (f'equilibrium --potential "x J" {RANGE}', "no-equilibrium"),
    "pole": (f'equilibrium --potential "1/x J" {RANGE}', "no-equilibrium"),
    "constant": (f'equilibrium --potential "0*x J" {RANGE}', "constant"),
    "turned range": ('equilibrium --potential "x^2 J" --lowest "1 m" --highest "-1 m"', "range"),
    "potential and states": ('equilibrium --potential "x^2 J" --state "name=x, rate=x"', "ambiguous"),
    "neither": ("equilibrium", "missing"),
    "unknown name in a rate": ('equilibrium --state "name=x, rate=x + q"', "expression"),
    "a line of equilibria": ('equilibrium --state "name=x, rate=0*x" --state "name=y, rate=-y"', "no-equilibrium"),
    "no rest": ('equilibrium --state "name=x, rate=1 + x^2"', "no-equilibrium"),
    "corner": ('equilibrium --state "name=x, rate=x - 1 + 0*sqrt(x - 1)"', "no-equilibrium"),
    "turned range of a state": ('equilibrium --state "name=x, rate=x, low=1, high=-1"', "range"),
    "no z": ('discrete "s^2 + 1"', "polynomial"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_refusals(name: str) -> None:
    call, code = REFUSED[name]
    out = run(*shlex.split("stability " + call), "--json")
    assert out.status in (2, 3)
    assert out.error["code"] == code


@pytest.mark.parametrize(
    "call",
    [
        'routh "(s^2+1)^2(s+1)"',
        'gain "s(s+1)(s+2) + K"',
        'gain "(1+K)s^2 + s + 1"',
        'interval "1, 2..3, 3..4, 1..7"',
        'delay "s^2 + 0.4s + 1" --delayed 0.5',
        'delay "s + 2" --delayed 1',
        'matrix "0, 1; -4, -0.2"',
        'discrete "1, -1.2, 0.11, 0.147"',
        'equilibrium --potential "cos(theta) J"',
        f'equilibrium --potential "x^4 - x^2 J" {RANGE}',
    ],
)
def test_pictures(call: str, tmp_path: Path) -> None:
    target = tmp_path / "picture.svg"
    assert run(*shlex.split("stability " + call), "--plot", str(target)).status == 0
    assert target.stat().st_size > 5000


def test_decimals_and_fractions_are_taken_as_typed() -> None:
    """0.1·3 is 0.3 here, so that the pair is on the axis; with doubles it is not."""
    made = answer("stability", "routh", "(s^2 + 0.3)(s + 0.1) + s(0.1*3 - 0.3)")
    assert made["results"]["axis"]["value"] == 2


def test_superscripts_and_signs_of_print() -> None:
    one = answer("stability", "routh", "s³ + 2·s² − 5s + 1")
    other = answer("stability", "routh", "1, 2, -5, 1")
    assert one["results"]["right"] == other["results"]["right"]


def test_matrices_from_files(tmp_path: Path) -> None:
    """Documents of modes, matrices of a document by address, text with names above the rows."""
    system = ("--masses", "1, 2 kg", "--stiffnesses", "100, 50 N/m", "--damping-ratio", "0.02")
    modes = tmp_path / "modes.json"
    modes.write_text(run("vibration", "modes", *system, "--json").out)
    made = answer("stability", "matrix", "--file", str(modes))["results"]
    assert made["verdict"] == "asymptotically stable"
    assert [row["damping"]["value"] for row in made["roots"]] == pytest.approx([0.02, 0.02], rel=1e-12)
    parts = {"mass": "mass_matrix", "damping": "damping_matrix", "stiffness": "stiffness_matrix"}
    typed = [word for name, key in parts.items() for word in (f"--{name}", f"@{modes}:{key}")]
    by_parts = answer("stability", "matrix", *typed)["results"]
    assert by_parts["rightmost"]["value"] == pytest.approx(made["rightmost"]["value"], rel=1e-12)
    spinning = answer("stability", "matrix", "--file", str(modes), "--gyroscopic", "0, 3; -3, 0")["results"]
    assert spinning["without_gyroscopic"] == "asymptotically stable"

    modes.write_text(run("vibration", "modes", "--masses", "1, 1 kg", "--stiffnesses", "0.1 N/m", "--json").out)
    free = answer("stability", "matrix", "--file", str(modes))["results"]
    assert (free["verdict"], free["axis"]["value"]) == ("unstable: repeated roots on the axis", 4)
    modes.write_text(run("motion", "modes", "--lengths", "0.5, 0.5 m", "--masses", "1 kg", "--json").out)
    assert answer("stability", "matrix", "--file", str(modes))["results"]["axis"]["value"] == 4

    text = tmp_path / "matrices.txt"
    text.write_text("M\n1, 0\n0, 1\nK:\n-1 0\n0 -2  # pushes away\nG\n0 -3\n3 0\n")
    held = answer("stability", "matrix", "--file", str(text))["results"]
    assert (held["verdict"], held["without_gyroscopic"]) == (
        "marginally stable: simple roots on the axis", "unstable",
    )  # fmt: skip
    for content, more, code in (
        ("0, 1\n-4, -1/5\n", (), None), ("0, 1\n-4, x\n", (), "number"), ("M\n1\nM\n1\n", (), "matrix"),
        ("0, 1\n-4, -1/5\n", ("1",), "ambiguous"), ("", (), "matrix"), ("1, 2\n3\n", (), "matrix"),
        ("{}", (), "matrix"),
        ('{"modes": [{"number": 1}]}', (), "matrix"),
    ):  # fmt: skip
        text.write_text(content)
        out = run("stability", "matrix", *more, "--file", str(text), "--json")
        assert (out.error["code"] if code else out.status) == (code or 0), content


def test_growth_decay_and_frequency_are_spread_over_uncertain_inputs() -> None:
    (spread,) = (
        answer("stability", "equilibrium", "--state", "name=x, rate=k*x, low=-1, high=1", "--let", "k=-2 ± 0.1")[
            "results"
        ][name]
        for name in ("decay",)
    )
    assert spread["interval"] == pytest.approx([1.804, 2.196], abs=2e-3)
    well = (
        "--potential",
        "k*x^2 J",
        "--lowest",
        "-1 m",
        "--highest",
        "1.1 m",
        "--mass",
        "2 kg",
        "--let",
        "k=100 ± 1 N/m",
    )
    assert answer("stability", "equilibrium", *well)["results"]["frequency"]["std"] == pytest.approx(0.00796, rel=1e-2)


def test_messages_name_the_matrices_as_they_are_typed() -> None:
    for typed, words in (
        (("--mass", "1, 0; 0, 1", "--stiffness", "1"), "--stiffness is 1 by 1, wanted 2 by 2 as --mass"),
        (("0, 1; -4, 1", "--mass", "1"), "MATRIX and --mass are both given"),
        (("--mass", "1, 0; 0", "--stiffness", "1"), "row 2 has 1, row 1 has 2"),
        ((), "neither MATRIX nor --mass and --stiffness are given"),
    ):
        assert words in run("stability", "matrix", *typed).err


def test_a_range_with_a_hyphen_and_a_small_k_are_told_how_they_are_written() -> None:
    hyphen = run("stability", "interval", "1, 2-3, 3..4", "--json").error
    assert (hyphen["code"], hyphen["hint"]) == ("range", "write 2..3")
    assert run("stability", "interval", "1, 2e-3, 3..4").status == 0
    assert "write a capital K" in run("stability", "gain", "s(s+1)(s+2) + k").err
    assert "'a' has no value" in run("stability", "routh", "s^3 + 2s + a").err


@pytest.mark.parametrize(
    ("loop", "closed"),
    [
        ("K/(s(s+1)(s+2))", "s(s+1)(s+2) + K"),
        ("1 + K(s+1)/(s^2(s+5))", "s^2(s+5) + K(s+1)"),
        ("K(1 + 2/s + 0.1s)/((s+1)(s+2)(s+3))", "s(s+1)(s+2)(s+3) + K(s + 2 + 0.1s^2)"),
        ("K(1/s + 2/s^2)/(s+1)^3", "s^2(s+1)^3 + K(s+2)"),
        ("K s/(s(s+1))", "s(s+1) + K s"),  # what cancels stays a root of the loop
        ("K (s+1) / s / (s-1)", "s(s-1) + K(s+1)"),
    ],
)
def test_an_open_loop_stands_for_its_closed_one(loop: str, closed: str) -> None:
    made = answer("stability", "gain", loop)
    assert made["results"] == answer("stability", "gain", closed)["results"]
    assert ("open-loop" in str(made["warnings"])) is not loop.startswith("1")


def test_coefficients_as_other_programs_write_them() -> None:
    assert (
        answer("stability", "routh", "[1 2 3 10]")["results"] == answer("stability", "routh", "1, 2, 3, 10")["results"]
    )
    wanted = answer("stability", "interval", "1, 2..3, 3..4, 1..7")["results"]
    for typed in ("[1, [2, 3], 3.5 ± 0.5, [1, 7]]", "1, 2.5 +/- 0.5, 3..4, [1,7]"):
        assert answer("stability", "interval", typed)["results"] == wanted


@pytest.mark.parametrize("zeta", [0.1, 0.5, 0.8])
@pytest.mark.parametrize(
    ("typed", "open_loop", "zeros"),
    [("s(s+1)(s+2) + K", [1, 3, 2, 0], [1]), ("K(s+1.5)/(s(s+1)(s+10))", [1, 11, 10, 0], [1, 1.5])],
)
def test_gains_for_a_damping_ratio_put_a_pair_there(
    typed: str, open_loop: list[float], zeros: list[float], zeta: float
) -> None:
    rows = answer("stability", "gain", typed, "--damping-ratio", str(zeta))["results"]["designs"]
    assert rows
    for row in rows:
        whole = np.polyadd(open_loop, row["gain"]["value"] * np.array(zeros))
        pairs = [root for root in np.roots(whole) if root.imag > 0.0]
        pair = min(pairs, key=lambda root: abs(-root.real / abs(root) - zeta))
        assert -pair.real / abs(pair) == pytest.approx(zeta, rel=1e-9)
        assert abs(pair) == pytest.approx(row["natural"]["value"], rel=1e-9)
        stable = all(root.real < 0.0 for root in np.roots(whole))
        assert (row["verdict"] == "asymptotically stable") == stable
