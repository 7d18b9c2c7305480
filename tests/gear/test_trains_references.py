"""Measuring sizes and root form radii against 40-digit references: their errors, and the bounds stated for them."""

import json
from typing import Any

import pytest
from mpmath import mp, mpf

from dynamics_cli.accuracy.cases import DATA
from dynamics_cli.errors import InadmissibleError
from dynamics_cli.gear.measure.measurement import measure
from dynamics_cli.gear.pitch import NormalModule
from dynamics_cli.gear.single.trochoid import Cutter, root
from dynamics_cli.numerics.tracked import Tracked

FILE = "gear_trains.json"
WANTED = 1e-13
ROOT_WANTED = 1e-14
# What heights and differences lose is put to the inputs: their condition is not 1.
DIFFERENCES = ("chordal.height", "constant_chord.height", "ideal_over")


def flat(result: Any, prefix: str = "") -> dict[str, Any]:
    out: dict[str, Any] = {}
    for name in result.fields:
        value = getattr(result, name)
        if name in ("checks", "advice") or value is None or isinstance(value, (bool, int, str)):
            continue
        if hasattr(value, "fields"):
            out |= flat(value, f"{prefix}{name}.")
        else:
            out[prefix + name] = value
    return out


def answers(case: dict[str, Any]) -> tuple[dict[str, float], dict[str, Any], list[float]]:
    """Plain results, tracked ones, and the doubles that went in."""
    numbers = {name: float(text) for name, text in case["inputs"].items() if isinstance(text, str)}
    rest = {name: value for name, value in case["inputs"].items() if not isinstance(value, str)}
    tracked = dict(zip(numbers, Tracked.inputs(list(numbers.values())), strict=True))
    if case["task"] == "root":
        plain, twin = (root(Cutter(**rest, **values)) for values in (numbers, tracked))
        return {"form_radius": plain.form_radius}, {"form_radius": twin.form_radius}, list(numbers.values())
    asked = dict(rest)
    if asked["internal"] and numbers["helix_angle"]:
        asked.pop("over")

    def call(values: dict[str, Any]) -> dict[str, Any]:
        own = dict(values)
        module = own.pop("module")
        return flat(measure(pitch=NormalModule(module), **asked, **own))

    return call(numbers), call(tracked), list(numbers.values())


CASES = [(case["name"], case) for case in json.loads((DATA / FILE).read_text(encoding="utf-8"))["cases"]]


@pytest.mark.parametrize("case", [case for _, case in CASES], ids=[name for name, _ in CASES])
def test_errors_and_bounds(case: dict[str, Any]) -> None:
    mp.dps = 60
    plain, tracked, numbers = answers(case)
    for name, text in case["results"].items():
        reference = mpf(text)
        own = tracked[name]
        own = own if isinstance(own, Tracked) else Tracked(own, 0.0, (0.0,) * len(numbers))
        assert own.value == plain[name], name
        error = abs(mpf(plain[name]) - reference)
        error = max(error - abs(reference) * mpf(10) ** -39, mpf(0))
        assert error <= own.error, (name, float(error), own.error)
        reach = sum(abs(slope * number) for slope, number in zip(own.slopes, numbers, strict=True))
        size = max(abs(float(reference)), reach if name in DIFFERENCES or "ideal" in name else 0.0)
        wanted = ROOT_WANTED if case["task"] == "root" else WANTED
        assert error <= wanted * size, (name, float(error / size))


def test_bounds_are_not_idle() -> None:
    """The bound is within a thousand roundings of the result and what one rounding of the inputs does to it."""
    for _, case in CASES:
        _, tracked, numbers = answers(case)
        for name in case["results"]:
            own = tracked[name]
            if isinstance(own, Tracked):
                reach = sum(abs(slope * number) for slope, number in zip(own.slopes, numbers, strict=True))
                if name == "pins.ideal_pin":  # a difference of places on the pitch circle
                    reach = max(reach, 0.5 * case["inputs"]["teeth"] * float(case["inputs"]["module"]))
                assert own.error <= 2000 * 2.0**-53 * max(abs(own.value), reach), (case["name"], name)


def test_there_are_hard_cases_and_each_says_why() -> None:
    hard = [case for _, case in CASES if case["kind"] == "hard"]
    assert len(hard) >= 20
    assert all(len(case["why"]) > 8 for case in hard)
    assert len({case["why"] for case in hard}) >= 20


def test_a_case_that_cannot_be_measured_says_so() -> None:
    with pytest.raises(InadmissibleError, match="below the form circle"):
        measure(teeth=24, pitch=NormalModule(0.003), over=1)
