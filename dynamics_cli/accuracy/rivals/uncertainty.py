"""Uncertainty: every method of propagation on distributions that are known by one-dimensional integrals."""

from dynamics_cli.accuracy.cases import Case, load
from dynamics_cli.accuracy.measure import Errors, Pace, seconds
from dynamics_cli.accuracy.questions import Comparison
from dynamics_cli.accuracy.rows import row

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.accuracy.rows import Row

QUESTIONS = (Comparison("uncertainty", "", "uncertain skid", "dynamics_cli.accuracy.rivals.uncertainty:compare"),)
METHODS: "tuple[tuple[str, dict[str, Any]], ...]" = (
    ("gradient quadrature, 1e-10 (chosen)", {"accuracy": 1e-10}),
    ("gradient quadrature, 1e-4", {"accuracy": 1e-4}),
    ("linear", {"method": "linear"}),
    ("second order", {"method": "second-order"}),
    ("unscented", {"method": "unscented"}),
    ("shifted lattices, 1e-4", {"method": "lattice", "accuracy": 1e-4}),
    ("Monte Carlo, 1e4", {"method": "monte-carlo", "samples": 10_000}),
    ("Monte Carlo, 1e6", {"method": "monte-carlo", "samples": 1_000_000}),
)


def skid(inputs: "dict[str, Any]") -> "tuple[dict[str, Any], Any]":
    """Speed from friction and length."""
    import numpy as np

    return {"speed": np.sqrt(2.0 * 9.80665 * inputs["friction"] * inputs["length"])}, None


def _inputs(case: Case) -> "dict[str, Any]":
    from dynamics_cli.core.uncertain.distributions import Lognormal, Normal

    mean, std, length, width = (float(case.inputs[key]) for key in ("mean", "std", "length", "width"))
    make = Normal if case.inputs["shape"] == "normal" else Lognormal
    return {"friction": make(mean, std), "length": make(length, width)}


def compare(name: str, *, hard: bool, full: bool, timed: bool) -> "list[Row]":
    """Every method over every case; errors in standard deviations of the result."""
    from dynamics_cli.core.uncertainty import propagate

    pace = Pace(full=full)
    cases = [case for case in load("uncertainty.json") if case.hard or not hard]
    made: list[Row] = []
    base: float | None = None
    for method, options in METHODS:
        errors = Errors()
        for case in cases:
            spread = propagate(skid, _inputs(case), shares=False, **options).spreads["speed"]
            errors.cases += 1
            std = float(case.results["std"])
            apart = max(
                abs(value - float(case.results[key]))
                for key, value in zip(
                    ("low", "high", "median", "mean", "std"),
                    (*spread.interval, spread.median, spread.mean, spread.std),
                    strict=True,
                )
            )
            errors.note(f"{case.name}", apart / std, spread.estimate)
        time = None
        if timed:
            inputs = _inputs(cases[0])
            time = seconds(
                lambda: propagate(skid, inputs, shares=False, **options),  # noqa: B023
                repeats=pace.repeats,
                least=pace.least,
            )
        base = base or time
        made.append(row(name, method, errors, time, base, bound="estimate"))
    return made
