"""`--time-limit`: a call ends in time, with what was reached; `--samples` beyond memory are refused."""

import json
import signal
import time
from pathlib import Path
from typing import Any

import pytest
from harness import run

import dynamics_cli
from dynamics_cli.core.deadline import Reached, held, within
from dynamics_cli.core.inputs.uncertain.distributions import Normal
from dynamics_cli.core.uncertainty.propagation import propagate
from dynamics_cli.errors import InadmissibleError

SKID = ("skid", "speed", "--distance", "20 ± 0.5 m", "--friction", "0.7 ± 0.03")
# Half a minute and more: an impact between sticking and slipping, all results of which have kinks.
PLANAR = (
    "impact", "planar", "--first-mass", "1500 kg", "--first-inertia", "2500 kg*m^2", "--first-velocity", "7, -5 m/s",
    "--first-lever", "0.9, 0.5 m", "--second-mass", "1200 kg", "--second-inertia", "1800 kg*m^2", "--second-velocity",
    "0, 0 m/s", "--second-lever", "-0.8, 0.6 m", "--normal", "-13 deg", "--friction", "0.1..0.8", "--restitution",
    "0.15 ± 0.03", "--samples", "90000000",
)  # fmt: skip


class Sleeps:
    """A model that takes for ever from some call on."""

    arrays = True

    def __init__(self, last: float = float("inf")) -> None:
        self.calls = 0
        self.last = last

    def __call__(self, x: dict[str, Any]) -> tuple[dict[str, Any], None]:
        self.calls += 1
        if self.calls >= self.last:
            time.sleep(30.0)
        return {"sum": x["a"] + x["b"], "difference": x["a"] - x["b"] ** 3}, None


INPUTS = {"a": Normal(1.0, 0.1), "b": Normal(3.0, 0.2)}


def asleep() -> Sleeps:
    """Falls asleep at the last call that the last result needs."""
    awake = Sleeps()
    propagate(awake, INPUTS, shares=False)
    return Sleeps(awake.calls)


def test_a_propagation_keeps_what_it_had() -> None:
    model = asleep()
    start = time.monotonic()
    made = within("1 s", lambda: propagate(model, INPUTS, shares=False, partly=True))
    assert time.monotonic() - start < 10.0
    assert made.stopped == ["sum", "difference"]
    assert made.spreads["sum"].std == pytest.approx(0.05**0.5)
    assert "difference" not in made.spreads


def test_without_leave_to_keep_a_part_the_call_fails() -> None:
    model = asleep()
    with pytest.raises(InadmissibleError, match="time limit of 100 ms was reached"):
        within("100 ms", lambda: propagate(model, INPUTS, shares=False))


def test_the_alarm_is_gone_after_the_call() -> None:
    before = signal.getsignal(signal.SIGALRM)
    assert within("1 min", lambda: 5) == 5
    with pytest.raises(InadmissibleError):
        within("1 ms", lambda: time.sleep(10.0))
    assert signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0)
    assert signal.getsignal(signal.SIGALRM) == before


def test_what_is_written_is_not_cut() -> None:
    written = []

    def slowly(data: bytes) -> None:
        time.sleep(0.5)
        written.append(data)

    with pytest.raises(InadmissibleError):
        within("50 ms", lambda: (held(slowly)(b"row"), time.sleep(10.0)))
    assert written == [b"row"]


def test_no_handler_of_errors_takes_it_for_one() -> None:
    assert not issubclass(Reached, Exception)


def test_a_case_ends_with_its_answer_and_what_was_propagated() -> None:
    start = time.monotonic()
    outcome = run(*PLANAR, "--method", "lattice", "--time-limit", "2 s", "--json")
    assert time.monotonic() - start < 20.0
    assert outcome.status == 3
    document = outcome.document
    assert document["results"]["energy_lost"]["value"] > 0.0
    (warning,) = [warning for warning in document["warnings"] if warning["code"] == "time-limit"]
    assert warning["severity"] == "serious"


def test_a_call_that_has_no_answer_yet_is_an_error() -> None:
    outcome = run(*SKID, "--time-limit", "1 us", "--json")
    assert outcome.status == 3
    assert outcome.out == ""
    assert outcome.error["code"] == "time-limit"


def test_time_enough_changes_nothing() -> None:
    assert run(*SKID, "--time-limit", "10 min", "--json").out == run(*SKID, "--json").out


@pytest.mark.parametrize("text", ["30", "-1 s", "0 s", "3 kg", "nan s"])
def test_a_time_limit_is_a_time(text: str) -> None:
    outcome = run(*SKID, "--time-limit", text, "--json")
    assert outcome.status == 2
    assert "time-limit" in outcome.error["parameter"]


def test_a_sweep_ends_with_the_points_that_it_reached() -> None:
    sweep = ("skid", "speed", "--distance", "20 ± 0.5 m", "--friction", "0.7", "--sweep", "friction=0.3:0.9:9000")
    outcome = run(*sweep, "--time-limit", "2 s", "--json")
    assert outcome.status == 3
    found = outcome.document["results"]["sweep"]["speed"]["value"]
    assert found[0] is not None
    assert found[-1] is None


def test_rows_end_after_whole_rows(tmp_path: Path) -> None:
    row = b'{"distance": "20 \xc2\xb1 0.5 m", "friction": 0.7}\n'
    outcome = run("skid", "speed", "--rows", "-", "--time-limit", "2 s", stdin=row * 20_000)
    assert outcome.status == 3
    assert "was reached after" in outcome.err
    lines = outcome.out.splitlines()
    # on a loaded machine the first block may not be through
    assert len(lines) < 20_000
    assert all("results" in json.loads(line) for line in lines)
    file = tmp_path / "out.ndjson"
    again = run("skid", "speed", "--rows", "-", "--output", str(file), "--time-limit", "1 s", stdin=row * 20_000)
    assert again.status == 3
    assert not file.exists()


@pytest.mark.parametrize("method", ["auto", "monte-carlo", "lattice"])
def test_more_samples_than_memory_are_refused_by_name(method: str) -> None:
    outcome = run(*SKID, "--samples", "1000000000", "--method", method, "--json")
    assert outcome.status == 2
    assert outcome.error["parameter"] == "samples"
    assert "100000000" in outcome.error["message"]


def test_a_sample_of_many_results_is_refused_before_it_is_drawn() -> None:
    start = time.monotonic()
    outcome = run(*SKID, "--samples", "90000000", "--method", "monte-carlo", "--json")
    assert outcome.status == 2
    assert outcome.error["parameter"] == "samples"
    assert "41666666" in outcome.error["hint"]
    assert time.monotonic() - start < 10.0


def test_python_callers_and_typer_have_the_limit_too() -> None:
    assert run(*SKID, "--time-limit", "1 us", "--json", route="tree").status == 3
    with pytest.raises(InadmissibleError, match="time limit"):
        dynamics_cli.run("skid speed", distance="20 ± 0.5 m", friction="0.7 ± 0.03", time_limit="1 us")
    document = dynamics_cli.run("skid speed", distance="20 m", friction=0.7, time_limit="10 min")
    assert document["results"]["speed"]["value"] > 0.0
