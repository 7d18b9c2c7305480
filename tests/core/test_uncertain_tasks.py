"""Every skid task takes every one of its real inputs uncertain, in each documented example."""

import json
import math
import re
import shlex
from typing import Any

import pytest
from harness import answer, run
from row_helpers import run as rows

from dynamics_cli import cli
from dynamics_cli.core.answering.task import Family, Model, Task
from dynamics_cli.core.uncertainty.model import _FUNCTIONS, TaskModel
from dynamics_cli.numerics.elementary import sqrt
from dynamics_cli.numerics.number import single
from dynamics_cli.numerics.tracked import _RULES
from dynamics_cli.quantities import Ratio
from dynamics_cli.records import record

# How long two parties went before does not move where the sight opens.
IDLE = {"sight first-duration", "sight second-duration"}
CASES = [
    (example, option.name)
    for task in cli.family("skid").tasks.values()
    for example in task.examples
    for option in task.options.values()
    if f"--{option.name} " in example and option.leaf is not None and option.leaf.kind.form in ("scalar", "slope")
    if not re.search(rf"--{option.name} [\"']?0[a-z]", example)
    and f"{task.name} {option.name}" not in IDLE
    # a list is uncertain by its items (tests/skid/test_recorder.py), and a deviation has none itself
    and option.name not in ("speeds", "points", "point-deviation")
]


def test_samples_know_every_function_that_tracked_numbers_know() -> None:
    assert set(_FUNCTIONS) == set(_RULES)


@pytest.mark.parametrize(("example", "name"), CASES, ids=[f"{e.split()[2]} {n}" for e, n in CASES])
def test_every_input_may_be_uncertain(example: str, name: str) -> None:
    argv = shlex.split(example)[1:]
    place = argv.index(f"--{name}") + 1
    written = argv[place]
    pure = written.replace(".", "").isdigit()
    argv[place] = f"{written} ± 0.01" if pure else f"{written} ± {'0.5' if '%' in written else '1'} %"
    outcome = run(*argv, "--json")
    assert outcome.status == 0, outcome.err
    results = outcome.document["results"].values()
    spread = [result for result in results if isinstance(result, dict) and "interval" in result]
    assert spread
    for result in spread:
        low, high = result["interval"]
        assert low <= result["median"] <= high
        assert result["std"] is None or result["std"] >= 0.0


def test_a_result_that_varies_only_by_what_its_solver_may_err_does_not_vary() -> None:
    """The transmission error of exact profiles is rounding; the room between teeth really varies."""
    call = ("gear", "mesh", "--first-teeth", "17", "--second-teeth", "51", "--module", "2 mm")
    results = run(*call, "--centre-distance", "68.1 ± 0.01 mm", "--points", "100", "--json").document["results"]
    assert "interval" not in results["transmission_error"]
    assert results["first_in_second"]["interval"][0] < results["first_in_second"]["interval"][1]


CAR = ("yaw-inertia", "--mass", "1500 kg", "--wheelbase", "3 ± 551 m")
HARDLY_ADMISSIBLE = {
    "one input": ("drop", "--height", "1 m", "--rebound-height", "0 ± 64 m"),
    "a length of no sign": (*CAR, "--length", "4.6 m", "--width", "1.8 m"),
    "three of them": (*CAR, "--length", "4.6 ± 55 m", "--width", "1.8 ± 20 m"),
}


@pytest.mark.parametrize("call", HARDLY_ADMISSIBLE.values(), ids=HARDLY_ADMISSIBLE)
@pytest.mark.filterwarnings("error")
def test_what_is_hardly_ever_admissible_shows_no_nan(call: tuple[str, ...]) -> None:
    document = run("impact", *call, "--json").document
    assert any(warning["code"] == "partly-inadmissible" for warning in document["warnings"])
    for entry in document["sensitivity"].values():
        shares = [row["share"] for row in entry["inputs"]]
        assert all(math.isfinite(share) for share in shares)
        assert len(shares) > 1 or shares == [1.0]
    assert "nan" not in run("impact", *call).out


def test_results_of_one_input_of_which_little_is_admissible_hang_together() -> None:
    """A wheelbase within 0 and the length: both rules rise with it, and so does the gyration radius."""
    made = run("impact", *HARDLY_ADMISSIBLE["a length of no sign"], "--json").document["covariance"]
    names = made["results"]
    assert made["correlation"][names.index("yaw_inertia")][names.index("radius_of_gyration")] > 0.98


def test_a_cut_that_no_line_has_is_no_fault() -> None:
    """Friction between slipping and sticking, and pieces of which none is on a line partly inadmissible."""
    argv = ["--first-mass", "1500 kg", "--first-inertia", "2500 kg*m^2", "--first-velocity", "16.83, -7.31 m/s"]
    argv += ["--first-lever", "0.54, 0.67 m", "--second-mass", "1200 kg", "--second-inertia", "1800 kg*m^2"]
    argv += ["--second-velocity", "0, 0 m/s", "--second-lever", "-1.35, 0.52 m", "--normal", "-30 deg"]
    outcome = run("impact", "planar", *argv, "--friction", "0.1..0.8", "--restitution", "0.15 ± 0.03", "--json")
    assert outcome.status == 0, outcome.err
    assert "energy_lost" in outcome.document["sensitivity"]


def test_rounding_beside_a_naught_or_a_constant_is_no_variation() -> None:
    """Teeth that fit without backlash do so at every module, and the shift that points a tooth is no length."""
    gears = ("--first-teeth", "12", "--second-teeth", "24", "--points", "20", "--json")
    results = run("gear", "mesh", *gears, "--module", "3 ± 0.01 mm").document["results"]
    assert "interval" not in results["backlash"]
    assert results["centre_distance"]["std"] == pytest.approx(18 * 0.01, rel=1e-3)
    spur = run("gear", "spur", "--teeth", "12", "--module", "3 ± 0.01 mm", "--json").document["results"]
    assert "interval" not in spur["pointed_shift"]
    assert spur["reference_diameter"]["std"] == pytest.approx(12 * 0.01, rel=1e-6)


@pytest.mark.parametrize(
    ("argv", "name", "mean"),
    [
        (("skid", "distance", "--speed", "20 m/s", "--friction", "0..0.1"), "distance", False),
        (("skid", "speed", "--distance", "20 m", "--friction", "0.05 ± 0.05"), "time", True),
        (("skid", "speed", "--distance", "20 ± 1 m", "--friction", "0.05 ± 0.05"), "time", True),
    ],
)
def test_tails_without_bound_have_no_deviation(argv: tuple[str, ...], name: str, mean: bool) -> None:
    """Beside zero drag 1/f has no mean and 1/√f no variance: a sample would only tell its own."""
    document = answer(*argv)
    result = document["results"][name]
    assert result["std"] is None
    assert (result["mean"] is not None) is mean
    assert result["interval"][0] < result["value"] < result["interval"][1]
    assert "no-deviation" in [warning["code"] for warning in document["warnings"]]
    shown = run(*argv).out.splitlines()[0 if name == "distance" else 1].split()
    assert float(shown[1]) == pytest.approx(result["value"], rel=0.1)


def test_tails_with_bounds_keep_their_deviation() -> None:
    for friction in ("0.7 ± 0.05", "0.4..0.9", "lognormal(0.7 ± 0.4)"):
        assert answer("skid", "speed", "--distance", "20 m", "--friction", friction)["results"]["time"]["std"] > 0.0


def test_samples_of_a_formula_that_branches_go_side_by_side(monkeypatch: pytest.MonkeyPatch) -> None:
    alone = []
    answers = TaskModel._answers

    def counted(self: TaskModel, cases: Any) -> Any:
        listed = list(cases)
        alone.append(len(listed))
        return answers(self, listed)

    monkeypatch.setattr(TaskModel, "_answers", counted)
    spring = ("--stiffness", "200 N/mm", "--damping-ratio", "0.05 ± 0.01")
    outcome = run("vibration", "forced", "--mass", "50 kg", *spring, "--force", "100 N", "--frequency", "9 Hz")
    assert outcome.status == 0
    # of a million cases those that are refused, and the few at the edges of what is admissible
    assert sum(alone) < 10_000


@record
class Halves:
    half: Ratio
    twice: Ratio | None
    root: Ratio | None


def halved(*, a: Ratio) -> Halves:
    """Twice the number for a single one only; the root of those above two."""
    return Halves(a / 2.0, 2.0 * a if single(a) else None, sqrt(a) if a > 2.0 else None)


def test_a_result_that_physics_gives_to_single_cases_only_is_spread_as_well() -> None:
    task = Task("halved", "A half.", Model("all", "test_uncertain_tasks:halved", source="none"))
    Family("test", "Tests.", task)
    status, out, _ = rows(task, "a\n3 ± 0.1\n".encode(), format="ndjson")
    results = json.loads(out)["results"]
    assert status == 0
    assert results["twice"]["std"] == pytest.approx(0.2, rel=1e-3)
    assert results["half"]["std"] == pytest.approx(0.05, rel=1e-3)
    assert results["root"]["std"] == pytest.approx(0.1 / (2.0 * math.sqrt(3.0)), rel=1e-2)


@pytest.mark.parametrize(
    "call",
    [
        'gear mesh --first-teeth 12 --second-teeth 24 --module "3 mm" --first-profile-shift "0.6 ± 0.006" '
        '--second-profile-shift "0.36 ± 0.004"',
        'pendulum damped --length "1 m" --amplitude "60 ± 0.6 deg" --damping 0.02 --until "20 deg"',
    ],
)
def test_a_task_that_takes_milliseconds_a_case_answers_few(call: str) -> None:
    uncertainty = answer(*shlex.split(call))["numerics"]["uncertainty"]
    assert uncertainty["evaluations"] < 500
    assert max(entry["estimate"] for entry in uncertainty["results"].values()) < 0.02
