"""Calls of `dynamics vibration`: refusals, verdicts, uncertainty, rows, files."""

import json
import math
import random
import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest
from harness import answer, run

from dynamics_cli import cli

ONE = '--mass "2 kg" --stiffness "50 N/m"'
LINE = '--masses "1, 1 kg" --stiffnesses "10, 10 N/m"'
LOOP = (
    '--rotor "name=a, inertia=1 kg*m^2" --rotor "name=b, inertia=1 kg*m^2" --rotor "name=c, inertia=1 kg*m^2" '
    '--shaft "from=a, to=c, stiffness=5 N*m/rad" --gear "driver=a, driven=b, ratio=2" '
)

REFUSED = {
    "growing": (f'free {ONE} --damping "-3 N*s/m"', "negative-damping"),
    "growing by its ratio": ("free --natural-frequency '3 Hz' --damping-ratio -0.01", "negative-damping"),
    "divergence": ('free --mass "2 kg" --stiffness "-50 N/m"', "divergence"),
    "no mass": ('free --stiffness "50 N/m"', "no-mass"),
    "no spring": ('free --mass "2 kg" --stiffness "0 N/m"', "no-stiffness"),
    "resonance": (f'forced {ONE} --force "1 N" --frequency-ratio 1', "resonance"),
    "unbalance in resonance": (f'unbalance {ONE} --unbalance "1 g*mm" --frequency-ratio 1', "resonance"),
    "no isolation": ('isolator --frequency "9 Hz" --transmissibility 1.2', "no-isolation"),
    "rising peaks": ("decrement --peaks 1,1.2,1.5", "rising"),
    "one peak": ("decrement --peaks 1", "too-few"),
    "band upside down": ('decrement --lower-frequency "9 Hz" --upper-frequency "8 Hz"', "half-power"),
    "no duration": ("transient --natural-frequency '9 Hz' --base-acceleration '1 g' --shape ramp", "no-duration"),
    "a force without a mass": ("transient --natural-frequency '9 Hz' --force '1 N' --shape step", "no-mass"),
    "a step has no spectrum": ("shock --shape step --base-acceleration '1 g' --duration '1 s'", "no-pulse"),
    "overdamped spectrum": (
        "shock --shape sawtooth --base-acceleration '1 g' --duration '1 s' --damping-ratio 1", "overdamped"),
    "singular mass": ('modes --mass-matrix "1,0;0,0" --stiffness-matrix "2,-1;-1,2"', "singular-mass"),
    "dependent masses": ('modes --mass-matrix "1,1;1,1" --stiffness-matrix "2,-1;-1,2"', "singular-mass"),
    "diverging matrix": ('modes --mass-matrix "1,0;0,1" --stiffness-matrix "1,-2;-2,1"', "divergence"),
    "energy from dampers": (
        'modes --mass-matrix "1,0;0,1" --stiffness-matrix "2,-1;-1,2" --damping-matrix "-1,0;0,1"',
        "negative-damping",
    ),
    "not symmetric": ('modes --mass-matrix "1,0;0,1" --stiffness-matrix "2,-1;1,2"', "symmetry"),
    "counts": ('modes --masses "1, 1 kg" --stiffnesses "1, 2, 3, 4 N/m"', "count"),
    "floating massless": (
        'modes --body "name=a, mass=1 kg" --body "name=b, mass=0 kg" --coupling "from=a, to=ground, stiffness=1 N/m"',
        "singular-mass",
    ),
    "unknown body": ('modes --body "name=a, mass=1 kg" --coupling "from=a, to=floor, stiffness=1 N/m"', "names"),
    "both dampings": (f'modes {LINE} --dampings "1, 2 N*s/m" --damping-ratio 0.1', "both"),
    "undamped response": (f"response {LINE} --force-at 1 --read-at 2", "undamped"),
    "locked": ("shaft " + LOOP + '--gear "driver=b, driven=c, ratio=2"', "locked"),
    "bore": (
        'shaft --rotor "name=a, inertia=1 kg*m^2" --shaft "from=a, to=ground, diameter=20 mm, bore=20 mm, length=1 m"',
        "bore",
    ),
    "absorber without damping": ("absorber --mass-ratio 0.1 --frequency-ratio 0.9 --damping-ratio 0", "undamped"),
    "one peak left": ("absorber --mass-ratio 0.01 --frequency-ratio 0.9 --damping-ratio 3", "one-peak"),
    "beam of nothing": ('beam --ends free-free --length "1 m" --width "0 mm" --height "1 mm"', "section"),
    "a diagram without tilting": (
        'whirl --mass "1 kg" --stiffness "1 N/m" --eccentricity "1 um" --speed "2 rad/s" --highest-speed "9 rad/s"',
        "missing"),
    "whirl in resonance": (
        'whirl --mass "1 kg" --stiffness "1 N/m" --eccentricity "1 um" --speed "1 rad/s"', "resonance"),
    "one inertia": (
        'whirl --mass "1 kg" --stiffness "1 N/m" --eccentricity "1 um" --speed "2 rad/s" --polar-inertia "1 kg*m^2"',
        "missing",
    ),
    "head down": ('nonlinear --law pendulum --swing "180 deg"', "at-top"),
    "softened away": ("nonlinear --law duffing --cubic -1.5", "no-return"),
    "undamped branches": (
        "nonlinear --law forced-duffing --cubic 1 --damping-ratio 0 --force 1 --frequency-ratio 1", "undamped"),
}  # fmt: skip


@pytest.mark.parametrize("name", REFUSED)
def test_refusals(name: str) -> None:
    command, code = REFUSED[name]
    outcome = run("vibration", *shlex.split(command), "--json")
    assert outcome.status == 3, outcome.out or outcome.err
    assert outcome.error["code"] == code
    assert re.search(r"\bnan\b", outcome.err.lower()) is None
    assert "None" not in outcome.err


def results(command: str) -> dict[str, object]:
    made: dict[str, object] = answer("vibration", *shlex.split(command))["results"]
    return made


def test_critical_damping_is_neither_under_nor_over() -> None:
    for mass, stiffness, damping, motion in (
        (0.2, 0.45, 0.6, "critically damped"), (2.0, 50.0, 20.0, "critically damped"),
        (2.0, 50.0, 20.00000000001, "overdamped, does not swing"), (2.0, 50.0, 19.99999999999, "underdamped"),
    ):  # fmt: skip
        made = results(f'free --mass "{mass} kg" --stiffness "{stiffness} N/m" --damping "{damping} N*s/m"')
        assert made["motion"] == motion or made["motion"]["value"] == motion  # type: ignore[index]


def test_a_mode_lost_in_a_matrix_is_null_and_said() -> None:
    document = answer("vibration", "modes", "--mass-matrix", "1,0;0,1", "--stiffness-matrix", "1e20,-1e20;-1e20,1e20")
    assert document["results"]["modes"][0].get("frequency") in (None, {"value": None, "unit": "Hz"})
    assert "lost" in [one["code"] for one in document["warnings"]]


def test_massless_bodies_are_condensed_and_named() -> None:
    """Two springs in a row with a massless joint are one of half their stiffness."""
    document = answer(
        "vibration", "modes", "--body", "name=joint, mass=0 kg", "--body", "name=block, mass=2 kg",
        "--coupling", "from=ground, to=joint, stiffness=100 N/m",
        "--coupling", "from=joint, to=block, stiffness=100 N/m",
    )  # fmt: skip
    mode = document["results"]["modes"][0]
    assert mode["angular_frequency"]["value"] == pytest.approx(5.0, rel=1e-15)
    assert mode["shape"]["value"] == pytest.approx([0.5, 1.0], rel=1e-15)
    assert "joint has no mass" in document["warnings"][0]["message"]


def test_repeated_frequencies_are_said() -> None:
    document = answer("vibration", "modes", "--mass-matrix", "1,0;0,1", "--stiffness-matrix", "4,0;0,4")
    assert "repeated" in [one["code"] for one in document["warnings"]]


def test_rows_are_the_single_answers() -> None:
    table = (
        "mass[kg],stiffness[N/m],damping[N*s/m],displacement[mm],time[s]\n1,100,0,1,1\n1,100,500,1,1\n1,100,20,1,1\n"
    )
    lines = run("vibration", "free", "--rows", "-", "--format", "ndjson", stdin=table).out.splitlines()
    for line, row in zip(lines, table.splitlines()[1:], strict=True):
        m, k, c, x, t = row.split(",")
        alone = results(
            f'free --mass "{m} kg" --stiffness "{k} N/m" --damping "{c} N*s/m" --displacement "{x} mm" --time "{t} s"'
        )
        assert json.loads(line)["results"]["position"]["value"] == alone["position"]["value"]  # type: ignore[index]


def test_uncertain_stiffness_reaches_the_frequency() -> None:
    made = results('free --mass "2 kg" --stiffness "50 ± 1 N/m"')
    frequency: dict[str, float] = made["natural_frequency"]  # type: ignore[assignment]
    assert frequency["std"] == pytest.approx(0.01 * frequency["value"], rel=0.02)


def test_damping_from_a_record(tmp_path: Path) -> None:
    """A recorded decay of known damping, on an offset."""
    zeta, omega = 0.03, 2.0 * math.pi * 5.0
    rows = [
        (0.002 * i, 0.4 + math.exp(-zeta * omega * 0.002 * i) * math.cos(omega * math.sqrt(1 - zeta**2) * 0.002 * i))
        for i in range(3000)
    ]
    file = tmp_path / "decay.csv"
    file.write_text("t[s],x[mm]\n" + "".join(f"{t!r},{x!r}\n" for t, x in rows))
    made = answer("vibration", "decrement", "--file", str(file))["results"]
    assert made["damping_ratio"]["value"] == pytest.approx(zeta, rel=5e-4)
    assert made["natural_frequency"]["value"] == pytest.approx(5.0, rel=1e-4)


def test_a_recorded_shock_is_read_between_its_samples(tmp_path: Path) -> None:
    """A rectangle of 5 samples a cycle: its largest response is 2 exactly, the largest sample 1.81."""
    file = tmp_path / "step.csv"
    rows = [(0.0, 0.0), (1e-9, 1.0), *((0.01 * i, 1.0) for i in range(1, 30)), (0.29 + 1e-9, 0.0)]
    file.write_text("t[s],a[g]\n" + "".join(f"{t!r},{a!r}\n" for t, a in rows))
    spectrum = answer(
        "vibration", "shock", "--file", str(file), "--lowest", "20 Hz", "--highest", "40 Hz", "--per-octave", "1",
        "--damping-ratio", "0",
    )["results"]["spectrum"]  # fmt: skip
    assert spectrum["primary"]["value"][0] / 9.80665 == pytest.approx(2.0, rel=1e-6)


def test_modes_below_are_counted() -> None:
    more = '--rotor "name=d, inertia=1 kg*m^2" --shaft "from=b, to=d, stiffness=5 N*m/rad" --below "1 Hz"'
    made = results(f"shaft {LOOP} {more}")
    below = made["modes_below"]
    count = below["value"] if isinstance(below, dict) else below
    rows: list[dict[str, dict[str, float]]] = made["modes"]  # type: ignore[assignment]
    assert count == sum(row["frequency"]["value"] < 1.0 for row in rows) > 0


LIGHT = """
import sys
sys.path.insert(0, {root!r})
from dynamics_cli.cli import main
sys.argv = ["dynamics", *{argv!r}]
status = main()
print(*sorted(set(sys.modules) & {heavy!r}), file=sys.stderr)
sys.exit(status)
"""
SCALAR = ("free", "forced", "base", "unbalance", "isolator", "decrement", "absorber", "beam", "whirl")


@pytest.mark.parametrize("task", SCALAR)
def test_closed_forms_start_without_numpy(task: str) -> None:
    argv = shlex.split(cli.family("vibration").tasks[task].examples[0])[1:]
    heavy = {"numpy", "scipy", "typing", "re", "csv", "dataclasses", "fractions"}
    code = LIGHT.format(root=str(Path(cli.__file__).parents[1]), argv=argv, heavy=heavy)
    done = subprocess.run([sys.executable, "-I", "-S", "-c", code], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr.strip()) == (0, "")


def test_a_trapezoid_beside_a_numerical_integration() -> None:
    """By solve_ivp at rtol 1e-10: 40 g over 11 ms, rise and fall of 1.1 ms, 50 Hz, 5 %."""
    typed = '--natural-frequency "50 Hz" --damping-ratio 0.05 --base-acceleration "40 g" --duration "11 ms"'
    made = answer("vibration", "transient", *shlex.split(typed), "--shape", "trapezoid")["results"]
    assert made["peak"]["value"] == pytest.approx(7.341901152781612, rel=1e-6)


def test_damping_from_a_record_that_ends_before_the_motion_does(tmp_path: Path) -> None:
    """Nine cycles of 3 %, an eighth of the amplitude left: the mean of the end is not the place of rest."""
    zeta, omega = 0.03, 2.0 * math.pi * 5.0
    rows = [
        (0.005 * i, 0.2 + math.exp(-zeta * omega * 0.005 * i) * math.sin(omega * math.sqrt(1 - zeta**2) * 0.005 * i))
        for i in range(430)
    ]
    file = tmp_path / "decay.csv"
    file.write_text("t[s],x[mm]\n" + "".join(f"{t!r},{x!r}\n" for t, x in rows))
    made = answer("vibration", "decrement", "--file", str(file))["results"]
    assert made["damping_ratio"]["value"] == pytest.approx(zeta, rel=1e-3)


def test_damping_from_a_noisy_record(tmp_path: Path) -> None:
    """Noise of 0.2 % makes many small maxima, near the peaks and near the place of rest: one a swing counts."""
    drawn, omega = random.Random(1), 2.0 * math.pi * 8.0
    rows = [
        (
            0.002 * i,
            3.0 + 5.0 * math.exp(-0.02 * omega * 0.002 * i) * math.cos(omega * 0.002 * i) + drawn.gauss(0, 0.01),
        )
        for i in range(1000)
    ]
    file = tmp_path / "decay.csv"
    file.write_text("t[s],x[mm]\n" + "".join(f"{t!r},{x!r}\n" for t, x in rows))
    made = answer("vibration", "decrement", "--file", str(file))["results"]
    assert made["damping_ratio"]["value"] == pytest.approx(0.02, rel=0.03)
    assert made["natural_frequency"]["value"] == pytest.approx(8.0, rel=2e-3)


@pytest.mark.parametrize(("noise", "zeta"), [(0.01, 0.02), (0.03, 0.02), (0.005, 0.05)])
def test_damping_of_a_decay_that_sinks_into_the_noise(noise: float, zeta: float, tmp_path: Path) -> None:
    """Before it begins and long after it has ended there is noise alone, whose peaks do not count."""
    drawn, omega = random.Random(2), 2.0 * math.pi * 5.0
    times = [i / 300.0 for i in range(-60, int(300 * 8.0 / (zeta * omega)))]
    rows = [
        (t - times[0], 0.5 + (t >= 0.0) * math.exp(-zeta * omega * t) * math.cos(omega * t) + drawn.gauss(0.0, noise))
        for t in times
    ]
    file = tmp_path / "decay.csv"
    file.write_text("t[s],x[mm]\n" + "".join(f"{t!r},{x!r}\n" for t, x in rows))
    made = answer("vibration", "decrement", "--file", str(file))["results"]
    assert made["damping_ratio"]["value"] == pytest.approx(zeta, rel=0.15)
    assert made["natural_frequency"]["value"] == pytest.approx(5.0, rel=0.03)


def test_a_critical_speed_alone_needs_no_speed() -> None:
    """√(48·E·I/L³/m) of a disk in the middle."""
    made = answer("vibration", "whirl", *shlex.split('--mass "10 kg" --diameter "25 mm" --length "600 mm"'))["results"]
    stiffness = 48.0 * 210e9 * math.pi / 64.0 * 0.025**4 / 0.6**3
    assert made["critical_speed"]["value"] == pytest.approx(math.sqrt(stiffness / 10.0) * 30.0 / math.pi)
    assert "amplitude" not in made


def test_a_vehicle_over_waves_is_shaken_once_a_wavelength() -> None:
    """Of 20 km/h over 6 m, r = 2π·(20/3.6)/6/√(k/m)."""
    vehicle = '--mass "1200 kg" --stiffness "400 kN/m" --damping-ratio 0.5 --base-amplitude "50 mm"'
    words = shlex.split(f'base {vehicle} --road-speed "20 km/h" --wavelength "6 m"')
    results = answer("vibration", *words)["results"]
    r = 2.0 * math.pi * 20.0 / 3.6 / 6.0 / math.sqrt(4e5 / 1200.0)
    shaken = 50.0 * math.sqrt((1.0 + r * r) / ((1.0 - r * r) ** 2 + r * r))
    assert results["amplitude"]["value"] == pytest.approx(shaken)
