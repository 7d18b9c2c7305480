"""Rise laws, polynomials and motions against 40-digit references."""

import json
from functools import cache
from typing import Any

import numpy as np
import pytest
from mpmath import mp, mpf

from dynamics_cli.accuracy.cases import DATA
from dynamics_cli.cam.laws.names import LawName
from dynamics_cli.cam.laws.normalised import law_named
from dynamics_cli.cam.laws.peaks import extremes
from dynamics_cli.cam.laws.polynomials import polynomial
from dynamics_cli.cam.laws.rise import rise
from dynamics_cli.cam.program.reading import Program, motion_of

FILE = DATA / "cam_motion.json"
NAMES = ("lift", "velocity", "acceleration", "jerk")
LIMITS = (1e-15, 1e-15, 5e-15, 1e-14)


@cache
def cases(task: str) -> list[dict[str, Any]]:
    return [case for case in json.loads(FILE.read_text(encoding="utf-8"))["cases"] if case["task"] == task]


def named(task: str) -> Any:
    return pytest.mark.parametrize("case", cases(task), ids=[case["name"] for case in cases(task)])


def relative_errors(values: Any, case: dict[str, Any], peaks: list[float]) -> list[float]:
    mp.dps = 50
    return [
        float(abs(mpf(float(value)) - mpf(case["results"][name])) / mpf(peak))
        for name, value, peak in zip(NAMES, values, peaks, strict=True)
    ]


def peaks_of(inputs: dict[str, Any]) -> list[float]:
    """Greatest values of the law, finite parts, in the units of the case."""
    shares = tuple(float(x) for x in inputs.get("shares", ())) or None
    law = law_named(inputs["law"], shares, float(inputs["constant"]) if "constant" in inputs else None)
    lift, span = float(inputs["lift"]), float(inputs["span"])
    tops = [max(abs(value) for _, value in extremes(law, order)) or 1.0 for order in range(4)]
    return [lift * top / span**order for order, top in enumerate(tops)]


@named("rise")
def test_a_rise_is_right_to_its_target(case: dict[str, Any]) -> None:
    inputs = case["inputs"]
    given = {key: float(inputs[key]) for key in ("lift", "span")}
    point = rise(
        law=LawName(inputs["law"]),
        at=(float(inputs["at"]),),
        shares=tuple(float(x) for x in inputs.get("shares", ())),
        constant=float(inputs["constant"]) if "constant" in inputs else None,
        **given,
    ).points[0]
    errors = relative_errors([getattr(point, name) for name in NAMES], case, peaks_of(inputs))
    assert all(error <= limit for error, limit in zip(errors, LIMITS, strict=True)), errors


@named("rise")
def test_lift_keeps_its_digits_at_the_start(case: dict[str, Any]) -> None:
    inputs = case["inputs"]
    if float(inputs["at"]) > 1e-6 * float(inputs["span"]):
        return
    shares = tuple(float(x) for x in inputs.get("shares", ())) or None
    law = law_named(inputs["law"], shares, float(inputs["constant"]) if "constant" in inputs else None)
    found = float(inputs["lift"]) * law.at(float(inputs["at"]) / float(inputs["span"]))[0]
    assert abs(found / mpf(case["results"]["lift"]) - 1) < 4e-15


@named("polynomial")
def test_a_free_polynomial_is_right(case: dict[str, Any]) -> None:
    conditions = [(float(x), k, float(v)) for x, k, v in case["inputs"]["conditions"]]
    law = polynomial(conditions)
    peaks = [max(abs(value) for _, value in extremes(law, order)) or 1.0 for order in range(4)]
    errors = relative_errors(law.at(float(case["inputs"]["at"])), case, peaks)
    assert all(error <= limit for error, limit in zip(errors, LIMITS, strict=True)), errors


@named("motion")
def test_a_motion_is_right_to_its_target_at_the_very_angle(case: dict[str, Any]) -> None:
    inputs = case["inputs"]
    motion = motion_of(Program(), inputs["program"])
    theta = float(inputs["theta"])
    peaks = peaks_of(inputs)
    single = motion.at(theta)
    many = [column[0] for column in motion.at(np.array([theta, theta + 1e-3]))]
    for values in (single, many):
        errors = relative_errors(values, case, peaks)
        assert all(error <= limit for error, limit in zip(errors, LIMITS, strict=True)), errors


def test_there_are_hard_cases_enough() -> None:
    hard = [case for task in ("rise", "polynomial", "motion") for case in cases(task) if case["kind"] == "hard"]
    assert len(hard) >= 60
    assert all(case["why"] for case in hard)
