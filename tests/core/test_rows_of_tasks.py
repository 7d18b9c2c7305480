"""Rows of every task: by lanes of arrays as one by one, to the bit, bad rows among them."""

import sys
from pathlib import Path

import numpy as np
import pytest
from row_helpers import run

from dynamics_cli.core.batch.rows.plan import Plan
from dynamics_cli.core.batch.text.columns import joined_texts, texts
from dynamics_cli.numerics.lanes import Diverged, Lanes, parts, sign_changes
from dynamics_cli.numerics.roots import sign_change

sys.path.insert(0, str(Path(__file__).parents[1] / "benchmarks"))
from rows_of_tasks import Call, calls

COUNT = 60
TASKS = (
    *calls(),
    'coords "4 ft" "30 deg" "0.0003 ft" --from cylindrical --into spherical',
    'impact oblique --first-mass "1 kg" --first-velocity "3, 0.2 m/s" --second-mass "1 kg"'
    ' --second-velocity "-1, 0.4 m/s" --normal "2 deg" --restitution 0.95',
)


def rows_of(call: Call, form: str, folder: Path) -> list[str]:
    lines = call.write(COUNT, folder)[form].read_text().splitlines()
    broken = lines[20].replace("1", "x", 1) if any(c == "1" for c in lines[20]) else lines[20] + ","
    return [*lines[:20], broken, "", *lines[20:40], lines[30].replace(".", "e999", 1), *lines[40:]]


@pytest.mark.parametrize("text", TASKS, ids=[" ".join(text.split()[:2]) for text in TASKS])
def test_rows_equal_single_answers_to_the_bit(text: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    call = Call(text)
    together = []
    plans = []
    honest = Plan.run

    def noted(plan: Plan, columns: object) -> object:
        answered = honest(plan, columns)
        plans.append(plan)
        together.extend(row for one in answered for row in one.rows.tolist())
        return answered

    monkeypatch.setattr(Plan, "run", noted)
    form = ("csv", "ndjson")[len(text) % 2]
    data = "\n".join(rows_of(call, form, tmp_path)).encode()
    fast, single = run(call.task, data), run(call.task, data, arrays=False)
    assert fast[:2] == single[:2]
    assert _failures(fast[2]) == _failures(single[2])
    assert len(together) > 0.6 * COUNT
    # as arrays, and found to agree with single calls
    assert any(plan.lanes and plan.proved for plan in plans)


def _failures(told: str) -> str:
    """What is told of rows without an answer; of cautions, each way tells the first that it meets."""
    return told.partition("dynamics: caution")[0]


def test_numbers_are_written_as_repr_writes_them() -> None:
    """Also those that msgspec writes without an exponent, 0.00005, or with one of one digit."""
    numbers = np.array(
        [0.5, 5e-5, 1e-4, 9e-6, 1e15, 1e16, -7e-5, 1e-9, 2.5e-8, 9.9e-10, 1.5e-17, 1e-100, 5e-324, 1e300]
    )
    random = np.random.default_rng(7)
    spread = random.uniform(-10.0, 10.0, 4000) * 10.0 ** random.integers(-300, 300, 4000)
    for some in (numbers, numbers[:2], numbers[2:], spread):
        assert texts([some]) == [[repr(number).encode() for number in some.tolist()]]
        pairs = [f"{number!r},{2.0 * number!r}".encode() for number in some.tolist()]
        assert joined_texts([some, 2.0 * some]) == pairs


def test_a_branch_parts_the_lanes_and_each_part_takes_the_steps_of_its_case() -> None:
    def formula(x: float) -> float:
        y = x
        while y > 2.0:
            y = y / 3.0
        return y if round(x) % 2 else -y

    numbers = np.linspace(0.1, 40.0, 500)
    made = np.full(500, np.nan)
    for part in parts(lambda given: formula(given["x"]), {"x": numbers}, np.arange(500), lambda error: None):
        made[part.rows] = part.outcome
    wanted = [formula(x) for x in numbers.tolist()]
    known = ~np.isnan(made)
    assert known.sum() > 300
    assert made[known].tolist() == [y for y, kept in zip(wanted, known, strict=True) if kept]


def test_lanes_that_agree_answer_and_others_part() -> None:
    lanes = np.array([1.0, 2.0, 3.0]).view(Lanes)
    assert bool(lanes > 0.0)
    assert not bool(lanes > 5.0)
    assert int(np.array([2.2, 2.8]).view(Lanes)) == 2
    with pytest.raises(Diverged) as parting:
        bool(lanes > 1.5)
    assert parting.value.mask.tolist() == [False, True, True]


def test_a_power_of_lanes_has_the_bits_of_python_s() -> None:
    numbers = np.random.default_rng(5).uniform(0.1, 9.0, 300)
    assert (numbers.view(Lanes) ** 3).tolist() == [x**3 for x in numbers.tolist()]


def test_bisection_lane_by_lane_is_that_of_one_case() -> None:
    targets = np.random.default_rng(7).uniform(0.01, 9.0, 200)
    made = sign_changes(lambda x: targets - x * x * x, 0.0, 5.0)
    wanted = [sign_change(lambda x, target=target: target - x * x * x, 0.0, 5.0) for target in targets.tolist()]
    assert made.tolist() == wanted
