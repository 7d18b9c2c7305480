"""Every skid task takes every one of its real inputs uncertain, in each documented example."""

import shlex

import pytest
from harness import run

from dynamics_cli import cli
from dynamics_cli.core.uncertain.model import _FUNCTIONS
from dynamics_cli.numerics.tracked import _RULES

CASES = [
    (example, option.name)
    for task in cli.family("skid").tasks.values()
    for example in task.examples
    for option in task.options.values()
    if f"--{option.name} " in example and option.leaf is not None and option.leaf.kind.form in ("scalar", "slope")
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


def test_rounding_beside_a_naught_or_a_constant_is_no_variation() -> None:
    """Teeth that fit without backlash do so at every module, and the shift that points a tooth is no length."""
    gears = ("--first-teeth", "12", "--second-teeth", "24", "--points", "20", "--json")
    results = run("gear", "mesh", *gears, "--module", "3 ± 0.01 mm").document["results"]
    assert "interval" not in results["backlash"]
    assert results["centre_distance"]["std"] == pytest.approx(18 * 0.01, rel=1e-3)
    spur = run("gear", "spur", "--teeth", "12", "--module", "3 ± 0.01 mm", "--json").document["results"]
    assert "interval" not in spur["pointed_shift"]
    assert spur["reference_diameter"]["std"] == pytest.approx(12 * 0.01, rel=1e-6)
