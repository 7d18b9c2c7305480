"""Every bound that the cam tasks state, on every reference case shipped: never below the error, and within a hundred
times it, or half a last bit of the size that errors are measured in.
"""

import json
from functools import cache
from typing import Any

import pytest
from geometry_cases import NOTHING, follower_of
from mpmath import mp, mpf

from dynamics_cli.accuracy.alternatives.cam.forces import _radius_share, certified, given
from dynamics_cli.accuracy.alternatives.cam.laws import (
    motion_bounds,
    motion_peaks,
    peaks,
    polynomial_bounds,
    polynomial_peaks,
)
from dynamics_cli.accuracy.cases import DATA, load
from dynamics_cli.cam.forces.check import check
from dynamics_cli.cam.geometry.followers import Flank, Rotation
from dynamics_cli.cam.geometry.profile import profile
from dynamics_cli.cam.laws.names import LawName
from dynamics_cli.cam.laws.polynomials import polynomial
from dynamics_cli.cam.laws.rise import rise
from dynamics_cli.cam.program.reading import motion_of
from dynamics_cli.cam.sizing import records, size

HALF_ULP = mpf(2) ** -53
LOOSE = 100
NAMES = ("lift", "velocity", "acceleration", "jerk")
SMALL_ANGLE = 1e-3


@cache
def cases(file: str, task: str) -> tuple[dict[str, Any], ...]:
    found = json.loads((DATA / file).read_text(encoding="utf-8"))["cases"]
    return tuple(case for case in found if case["task"] == task)


def every(file: str, task: str) -> Any:
    found = cases(file, task)
    return pytest.mark.parametrize("case", found, ids=[case["name"] for case in found])


def held(value: float, text: str, bound: float, scale: float) -> None:
    """The bound is true, and tight in a size."""
    with mp.workdps(60):
        error = abs(mpf(float(value)) - mpf(text))
        # the reference has 40 digits
        assert error <= mpf(float(bound)) + abs(mpf(text)) * mpf(10) ** -39, (float(error), bound)
        assert mpf(float(bound)) <= LOOSE * max(error, HALF_ULP * abs(mpf(scale))), (float(error), bound, scale)


def stated(answer: Any) -> dict[str, float]:
    """Absolute bounds by address."""
    found = {}
    for one in answer.numerics.bounds:
        value = getattr(answer, one.result, 1.0)
        found[one.result] = one.bound * abs(value) if one.relative else one.bound
    return found


def loaded(file: str, case: dict[str, Any]) -> Any:
    return next(one for one in load(file) if one.name == case["name"] and one.inputs == case["inputs"])


@every("cam_motion.json", "rise")
def test_rises(case: dict[str, Any]) -> None:
    inputs = case["inputs"]
    answer = rise(
        law=LawName(inputs["law"]),
        lift=float(inputs["lift"]),
        span=float(inputs["span"]),
        at=(float(inputs["at"]),),
        shares=tuple(float(share) for share in inputs.get("shares", ())),
        constant=float(inputs["constant"]) if "constant" in inputs else None,
    )
    bounds = stated(answer)
    for name, peak in zip(NAMES, peaks(loaded("cam_motion.json", case)), strict=True):
        held(getattr(answer.points[0], name), case["results"][name], bounds[f"points.{name}"], peak)


@every("cam_motion.json", "polynomial")
def test_polynomials(case: dict[str, Any]) -> None:
    conditions = [(float(x), order, float(value)) for x, order, value in case["inputs"]["conditions"]]
    values = polynomial(conditions).at(float(case["inputs"]["at"]))
    own = loaded("cam_motion.json", case)
    for name, value, bound, peak in zip(NAMES, values, polynomial_bounds(own), polynomial_peaks(own), strict=True):
        held(value, case["results"][name], bound, peak)


@every("cam_motion.json", "motion")
def test_motions(case: dict[str, Any]) -> None:
    own = loaded("cam_motion.json", case)
    values = motion_of(NOTHING, case["inputs"]["program"]).at(float(case["inputs"]["theta"]))
    for name, value, bound, peak in zip(NAMES, values, motion_bounds(own), motion_peaks(own), strict=True):
        held(value, case["results"][name], bound, peak)


@every("cam_geometry.json", "profile")
def test_pressure_angles_and_curvature(case: dict[str, Any]) -> None:
    inputs = case["inputs"]
    answer = profile(
        NOTHING,
        program=inputs["program"],
        follower=follower_of(inputs["follower"]),
        rotation=Rotation(inputs["rotation"]),
        flank=Flank(inputs["flank"]),
        points=4,
    )
    bounds = stated(answer)
    for name in ("largest_pressure_angle", "least_pressure_angle"):
        text, value = case["results"][name], getattr(answer, name)
        if not value:
            # a face square to its way: exactly nothing, which the reference's own rounding is beside
            assert name not in bounds
            assert abs(float(text)) < 1e-50
            continue
        held(value, text, bounds[name], max(abs(float(text)), SMALL_ANGLE))
    text = case["results"]["least_convex_radius"]
    if answer.least_convex_radius is not None:
        follower = follower_of(inputs["follower"])
        size_ = abs(float(text)) + getattr(follower, "roller_radius", follower.base_radius)
        held(answer.least_convex_radius, text, bounds["least_convex_radius"], size_)


def sizes() -> list[dict[str, Any]]:
    return [*cases("cam_geometry.json", "size"), *cases("cam_design.json", "size")]


@pytest.mark.parametrize("case", sizes(), ids=[case["name"] for case in sizes()])
def test_sizes(case: dict[str, Any]) -> None:
    inputs, tree, results = case["inputs"], case["inputs"]["follower"], case["results"]
    follower = getattr(records, tree["record"])(**{key: float(text) for key, text in tree.items() if key != "record"})
    limits = {key: float(text) for key, text in inputs.items() if key.endswith(("_limit", "_radius"))}
    answer = size.size(NOTHING, program=inputs["program"], follower=follower, **limits)
    scale = abs(float(results.get("start_radius", results["base_radius"])))
    held(answer.base_radius, results["base_radius"], stated(answer)["base_radius"], scale)


@pytest.mark.parametrize("case", load("cam_forces.json"), ids=lambda case: case.name)
def test_forces(case: Any) -> None:
    found = certified(given(case))
    for name, text in case.results.items():
        scale = abs(float(text))
        for end, other in (("least_", "greatest_"), ("greatest_", "least_")):
            if name.startswith(end):
                scale = max(scale, abs(float(case.results[name.replace(end, other, 1)])))
        if name == "stress":
            # a stress tells the radius that is left of a larger one
            scale /= _radius_share(case, scale)
        value, bound = found[name]
        assert bound is not None, name
        held(value, text, bound, scale)


@every("cam_design.json", "check")
def test_lift_lost(case: dict[str, Any]) -> None:
    inputs, follower = case["inputs"], follower_of(case["inputs"]["follower"])
    answer = check(
        NOTHING,
        program=inputs["program"],
        follower=follower,
        rotation=Rotation(inputs["rotation"]),
        flank=Flank(inputs["flank"]),
    )
    for name, text in case["results"].items():
        # the difference of a lift and of a place on the cam is told in shares of the cam, or of a swing of a radian
        cam = follower.base_radius + getattr(follower, "roller_radius", 0.0)
        held(getattr(answer, name), text, stated(answer)[name], max(cam, abs(float(text))))
