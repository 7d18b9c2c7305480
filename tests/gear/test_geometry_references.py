"""Gears, pairs, bevels, worms and screws against 40-digit references: true error within the stated bound."""

import json
from collections.abc import Iterator
from typing import Any

import pytest
from mpmath import mp, mpf

from dynamics_cli.accuracy.cases import DATA
from dynamics_cli.gear.crossing.bevel import bevel
from dynamics_cli.gear.crossing.bevel_records import Kind
from dynamics_cli.gear.crossing.crossed import Screw, crossed
from dynamics_cli.gear.crossing.worm import AxialModule, WormDiameter, worm
from dynamics_cli.gear.pair.pair import pair
from dynamics_cli.gear.pair.records import Mate
from dynamics_cli.gear.pair.shift_split import Tips
from dynamics_cli.gear.pitch import NormalModule
from dynamics_cli.gear.single.cylindrical import helical, spur
from dynamics_cli.numerics.involute import inverse_involute, involute
from dynamics_cli.numerics.tracked import Tracked

FILE = DATA / "gear_geometry.json"
CASES = json.loads(FILE.read_text(encoding="utf-8"))["cases"]
RECORDS = {record.__name__: record for record in (NormalModule, Mate, AxialModule, WormDiameter, Screw)}
CHOICES = {"tips": Tips, "kind": Kind, "internal": bool}
TASKS: dict[str, Any] = {
    "spur": spur,
    "helical": helical,
    "pair": pair,
    "bevel": bevel,
    "worm": worm,
    "crossed": crossed,
    "inv": lambda phi: {"value": involute(phi)},
    "inverse": lambda value: {"phi": inverse_involute(value)},
}
ROUNDOFF = 2.0**-53


def build(tree: dict[str, Any], numbers: Iterator[Any]) -> Any:
    parts = {}
    for name, part in tree.items():
        if name == "record":
            continue
        if isinstance(part, dict):
            parts[name] = build(part, numbers)
        else:
            parts[name] = next(numbers) if isinstance(part, str) else part
    return RECORDS[tree["record"]](**parts) if "record" in tree else parts


def leaves(tree: dict[str, Any]) -> Iterator[float]:
    for name, part in tree.items():
        if isinstance(part, dict):
            yield from leaves(part)
        elif isinstance(part, str) and name != "record":
            yield float(part)


def picked(answer: Any, name: str) -> Any:
    """A result by its address, or by the words of these references."""
    if isinstance(answer, dict):
        return answer[name]
    if name == "nominal":
        return answer.nominal_contact_ratio or answer.transverse_contact_ratio
    if name == "margin":
        return answer.verdicts[0].margin
    if name == "first_sliding_at_start":
        return answer.points[0].first_sliding
    if name == "second_sliding_at_end":
        return answer.points[-1].second_sliding
    for part in name.split("."):
        answer = getattr(answer, part)
    return answer


def skipped(name: str, plain: Any) -> bool:
    """Sliding at the ends holds only where the path is not cut by a root form circle."""
    return name.endswith(("_at_start", "_at_end")) and plain.nominal_contact_ratio is not None


@pytest.mark.parametrize("case", CASES, ids=[f"{case['task']} {case['name']}" for case in CASES])
def test_error_within_bound(case: dict[str, Any]) -> None:
    mp.dps = 60
    numbers = list(leaves(case["inputs"]))
    choices = {name: CHOICES[name](value) for name, value in case["choices"].items()}
    function = TASKS[case["task"]]
    plain = function(**build(case["inputs"], iter(numbers)), **choices)
    tracked = function(**build(case["inputs"], iter(Tracked.inputs(numbers))), **choices)
    for name, text in case["results"].items():
        if not isinstance(plain, dict) and skipped(name, plain):
            continue
        value, own = picked(plain, name), picked(tracked, name)
        bound = own.error if isinstance(own, Tracked) else 0.0
        assert value == (own.value if isinstance(own, Tracked) else own), name
        reference = mpf(text)
        error = abs(mpf(value) - reference) - abs(reference) * mpf(10) ** -39
        assert error <= bound, (name, float(error), bound)
        reach = sum(abs(slope * number) for slope, number in zip(own.slopes, numbers, strict=True)) if bound else 0.0
        # a difference of large terms carries the rounding of its terms, which no condition number of the inputs shows
        room = max(
            300.0 * max(float(error), ROUNDOFF * abs(value), ROUNDOFF * reach),
            5e-13 * abs(value),
            1e-13 * (value == 0.0),
        )
        assert bound <= room, (name, bound, room)


def test_lengths_and_angles_of_pairs_to_thirteen_digits() -> None:
    """Where the problem is well-conditioned, as the references' condition numbers say."""
    worst = 0.0
    mp.dps = 60
    for case in CASES:
        if case["task"] != "pair" or any(word in case["name"] for word in ("α_w", "tiny")):
            continue
        choices = {name: CHOICES[name](value) for name, value in case["choices"].items()}
        plain = pair(**build(case["inputs"], leaves(case["inputs"])), **choices)
        for name in ("centre_distance", "working_pressure_angle", "nominal"):
            reference = mpf(case["results"][name])
            worst = max(worst, float(abs(mpf(picked(plain, name)) / reference - 1)))
    assert 0.0 < worst <= 1e-13


def test_there_are_hard_cases_and_each_says_why() -> None:
    hard = [case for case in CASES if case["kind"] == "hard"]
    assert len(hard) >= 40
    assert all(case["why"] for case in hard)
