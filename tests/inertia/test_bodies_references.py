"""Shapes, assemblies, tensors and torques against 40-digit references: errors within bounds, bounds within reason."""

import json
import subprocess
import sys
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from mpmath import mp, mpf
from references.inertia_bodies_tasks import answers, by_address

from dynamics_cli.numerics.tracked import Tracked

FILE = Path(__file__).parents[1] / "references" / "inertia_bodies.json"
CASES: list[dict[str, Any]] = json.loads(FILE.read_text(encoding="utf-8"))["cases"]
UNIT_ROUNDOFF = mpf(2) ** -53


@cache
def measured(index: int) -> list[tuple[str, Any, Any, Any]]:
    """Address, reference, true error and stated bound of every result of a case."""
    mp.dps = 60
    case = CASES[index]
    bare, tracked = answers(case["task"], case["inputs"])
    found = []
    for address, text in case["results"].items():
        own, plain = by_address(tracked, address), by_address(bare, address)
        value = getattr(own, "value", own)
        assert value == getattr(plain, "value", plain), address
        reference = mpf(text)
        error = max(abs(mpf(value) - reference) - abs(reference) * mpf(10) ** -39, mpf(0))
        found.append((address, reference, error, mpf(own.error) if isinstance(own, Tracked) else mpf(0)))
    return found


EVERY = pytest.mark.parametrize("index", range(len(CASES)), ids=[f"{c['task']} {c['name']}" for c in CASES])


@EVERY
def test_every_bound_holds(index: int) -> None:
    wrong = [(a, float(error), float(bound)) for a, _, error, bound in measured(index) if error > bound]
    assert wrong == []


@EVERY
def test_no_bound_is_more_than_a_hundred_times_the_error_or_a_rounding(index: int) -> None:
    """Products, coordinates and differences are measured by the rounding of the largest result of their kind."""
    rows = measured(index)
    for address, reference, error, bound in rows:
        kind = address.split(".")[0].split("[")[0]
        scale = abs(reference)
        if kind in ("products", "centroid", "inertia_torque", "slack"):
            kin = ("products", "moments") if kind == "products" else (kind,)
            scale = max(abs(r) for a, r, _, _ in rows if a.split(".")[0].split("[")[0] in kin)
        if kind == "slack":
            scale = mpf(1)
        if CASES[index]["name"].startswith(("ball less ball", "points on a line")):
            # a difference of large numbers: what rounding the inputs alone does to it
            scale = max(scale, max(error * 2**53 for _, _, error, _ in rows), mpf(1))
        if CASES[index]["task"] == "body":
            # a sum over n parts is n roundings, each of the running total
            scale *= max(1, len(json.dumps(CASES[index]["inputs"]).split('"mass"')) / 4)
        assert bound <= 100 * max(error, UNIT_ROUNDOFF * scale), (address, float(bound), float(error))


def test_there_are_enough_hard_cases_and_every_shape() -> None:
    from dynamics_cli.inertia.shapes import Shape

    assert sum(case["kind"] == "hard" for case in CASES) >= 20
    assert all(case["why"] for case in CASES if case["kind"] == "hard")
    named = {case["inputs"]["shape"] for case in CASES if case["task"] == "shape"}
    assert named == {cls.tag[1] for cls in Shape.__args__}  # type: ignore[attr-defined]


@pytest.mark.parametrize(
    ("start", "address", "limit"),
    [
        ("needle 1e6 turned", "principal_moments", 2e-15),
        ("plate 1e6 turned", "principal_moments", 2e-15),
        ("two needles", "principal_moments", 2e-15),
        ("assembly at", "principal_moments", 2e-15),
        ("assembly at", "moments", 2e-15),
    ],
)
def test_hard_bodies_keep_their_digits(start: str, address: str, limit: float) -> None:
    chosen = [i for i, case in enumerate(CASES) if case["name"].startswith(start)]
    assert chosen
    for index in chosen:
        for name, reference, error, _ in measured(index):
            if name.startswith(address):
                assert error <= limit * abs(reference), (CASES[index]["name"], name, float(error / abs(reference)))


def test_thin_walls_are_good_to_5e_16() -> None:
    chosen = [i for i, case in enumerate(CASES) if ", wall 1e" in case["name"] and case["task"] == "shape"]
    assert len(chosen) >= 24
    worst = max(
        (float(error / abs(reference)), CASES[index]["name"], name)
        for index in chosen
        for name, reference, error, _ in measured(index)
        if reference
    )
    assert worst[0] <= 5e-16, worst


def test_the_references_are_what_their_generator_writes(tmp_path: Path) -> None:
    made = tmp_path / "made.json"
    generator = FILE.parent / "generate_inertia_bodies_references.py"
    subprocess.run([sys.executable, str(generator), str(made)], check=True)
    assert made.read_bytes() == FILE.read_bytes()
