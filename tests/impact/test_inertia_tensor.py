"""Tensors that a body can have, by their principal moments; refused alike wherever one comes in."""

from decimal import Decimal
from typing import Any

import numpy as np
import pytest
from harness import run

from dynamics_cli.impact.inertia_tensor import possible
from dynamics_cli.numerics.tracked import Tracked

TURNED = "[[0.02, 0, 0], [0, 0.03, 0.024], [0, 0.024, 0.04]] kg*m^2"


def bodies(generator: Any, excess: float) -> Any:
    """A tensor in random axes whose largest moment is the sum of the others times 1 + excess."""
    one, two = generator.uniform(0.0, 1.0, 2) * 10.0 ** generator.uniform(-6.0, 6.0)
    turn, _ = np.linalg.qr(generator.normal(size=(3, 3)))
    return turn @ np.diag([one, two, (one + two) * (1.0 + excess)]) @ turn.T


def rows(matrix: Any, number: Any = float) -> Any:
    upper = np.triu(matrix) + np.triu(matrix, 1).T
    return tuple(tuple(number(float(cell)) for cell in row) for row in upper)


def test_the_verdict_is_that_of_the_principal_moments() -> None:
    generator = np.random.default_rng(16)
    for _ in range(300):
        for excess, expected in ((-1e-3, True), (0.0, True), (1e-13, True), (1e-7, False), (0.1, False)):
            matrix = bodies(generator, excess)
            assert bool(possible(rows(matrix))) is expected
            assert bool(possible(rows(matrix, Decimal))) is expected
            assert bool(possible(rows(matrix, lambda cell: Tracked(cell, 0.0, (1.0,))))) is expected


def test_arrays_are_judged_row_by_row() -> None:
    generator = np.random.default_rng(17)
    kept = [bodies(generator, excess) for excess in (-0.1, 0.1, 0.0, 1.0)] + [np.diag([1.0, -1.0, 1.0])]
    cells = np.array([rows(matrix) for matrix in kept]).transpose(1, 2, 0)
    assert possible(cells).tolist() == [True, False, True, False, False]  # type: ignore[arg-type, attr-defined]


@pytest.mark.parametrize("needle", [1e-300, 1.0, 1e300])
def test_needles_and_plates_are_bodies(needle: float) -> None:
    assert possible(((0.0, 0.0, 0.0), (0.0, needle, 0.0), (0.0, 0.0, needle)))
    assert possible(((needle / 2, 0.0, 0.0), (0.0, needle / 2, 0.0), (0.0, 0.0, needle)))
    assert not possible(((0.0, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, needle)))


@pytest.mark.parametrize(
    "call",
    [
        ["impact", "spatial", "--first-mass", "1 kg", "--first-inertia", TURNED, "--first-lever", "0.1, 0, 0.1 m",
         "--first-velocity", "0, 0, 5 m/s", "--second-fixed", "--normal", "0, 0, 1", "--restitution", "0.5",
         "--friction", "0.3"],
        ["impact", "seize", "--mass", "1 kg", "--inertia", TURNED, "--velocity", "0, 0, 5 m/s", "--angular-velocity",
         "0, 0, 1 rad/s", "--point", "0.1, 0, 0 m"],
    ],
)  # fmt: skip
def test_a_tensor_whose_moments_fit_only_along_its_axes_is_refused(call: list[str]) -> None:
    """Its principal moments are 0.0105, 0.02 and 0.0595 kg·m²: no body has them."""
    outcome = run(*call, "--json")
    assert (outcome.status, outcome.error["code"]) == (3, "no-body"), outcome.err
