"""The uncertainty references: made again in part, agreed with by samples and by libraries, and the engine on them."""

import math
import sys
from pathlib import Path

import numpy as np
import pytest
from peers.uncertainty import libraries

from dynamics_cli.accuracy.alternatives.uncertainty import propagation as uncertainty
from dynamics_cli.accuracy.alternatives.uncertainty.models import FORMULAS, Arrays
from dynamics_cli.accuracy.cases import Case, load

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "references"))

import uncertainty_numbers as exact
from generate_uncertainty_references import agreed
from mpmath import mp, mpf
from uncertainty_cases import CASES as WANTED

CASES = load("uncertainty.json")
LIBRARIES = {"uncertainties": libraries.by_uncertainties, "GTC": libraries.by_gtc, "mcerp": libraries.by_mcerp}


def wrong(found: tuple[float, ...], case: Case) -> float:
    std = float(case.results["std"])
    names = ("low", "high", "median", "mean", "std")
    return max(abs(value - float(case.results[name])) / std for value, name in zip(found, names, strict=True))


class TestReferences:
    def test_there_are_enough_hard_ones_each_with_its_reason(self) -> None:
        hard = [case for case in CASES if case.hard]
        assert len(hard) >= 40
        assert all(case.why for case in hard)
        assert len({case.name for case in CASES}) == len(CASES)

    def test_they_are_those_that_are_asked_for(self) -> None:
        """That they are made again to the byte is shown with all others, in test_manifest.py."""
        assert [wanted.name for wanted in WANTED] == [case.name for case in CASES]

    def test_all_digits_agree_but_those_of_exact_numbers(self) -> None:
        for case in CASES:
            for name, text in case.results.items():
                digits = text.partition("e")[0].strip("-").replace(".", "").lstrip("0")
                assert len(digits) >= 36 or len(digits) <= 13, (case.name, name)

    def test_only_digits_that_agree_are_written(self) -> None:
        with mp.workdps(50):
            third = mpf(1) / 3
            assert agreed(third, third * (1 + mpf(10) ** -25)).startswith("0.33333333333333333333333")
            assert len(agreed(third, third * (1 + mpf(10) ** -25))) <= 27
            with pytest.raises(ArithmeticError):
                agreed(third, third * (1 + mpf(10) ** -10))

    @pytest.mark.parametrize("case", CASES, ids=[case.name for case in CASES])
    def test_a_sample_agrees_with_every_one(self, case: Case) -> None:
        """Shares of a plain sample below the quantiles: the formula and the reference speak of the same thing."""
        inputs, count = uncertainty.distributions(case), 100_000
        matrix = np.eye(len(inputs))
        for i, j, rho in uncertainty.correlations(case):
            matrix[i, j] = matrix[j, i] = rho
        scores = np.linalg.cholesky(matrix) @ np.random.default_rng(7).normal(size=(len(inputs), count))
        x = [one.at(z) for one, z in zip(inputs, scores, strict=True)]
        with np.errstate(invalid="ignore"):
            found = FORMULAS[case.task](x, Arrays())
        for p, name in ((0.025, "low"), (0.5, "median"), (0.975, "high")):
            # what is inadmissible counts for nothing
            found = found[~np.isnan(found)]
            quantile = float(case.results[name])
            slack = 5.0 * math.sqrt(p * (1.0 - p) / count)
            near = 1e-12 * abs(quantile)
            assert (found < quantile - near).mean() - slack <= p <= (found <= quantile + near).mean() + slack, name


class TestNumbers:
    """The arithmetic of the references against mpmath's own functions and rules."""

    @pytest.mark.parametrize("x", [-40.0, -15.9, -7.3, -1.0, -0.03, 0.0, 0.0625, 0.19, 3.3, 15.99, 16.5])
    def test_the_distribution_function(self, x: float) -> None:
        with exact.precision(60, 1):
            found = mpf(str(exact.phi(exact.number(x))))
            expected = mp.erfc(-mpf(x) / mp.sqrt(2)) / 2
            assert abs(found - expected) < mpf(10) ** -55 * expected

    def test_integrals(self) -> None:
        with exact.precision(50, 1):
            for function, plain, ends in (
                (exact.real.sqrt, mp.sqrt, (0, 1)),
                (lambda x: exact.real.log(x), mp.log, (0, 2)),
                (lambda x: 1 / (1 + x * x), lambda x: 1 / (1 + x * x), (-1, 4)),
            ):
                found = mpf(str(exact.integral(function, [exact.number(end) for end in ends])))
                assert abs(found - mp.quad(plain, ends)) < mpf(10) ** -44

    def test_expectations_under_the_bell(self) -> None:
        with exact.precision(50, 1):
            found = exact.total(w * exact.real.cos(t) for t, w in exact.bell(8, 15))
            assert abs(mpf(str(found)) - mp.exp(-mpf(1) / 2)) < mpf(10) ** -48


SMOOTH = [case for case in CASES if uncertainty.kind_of(case) == "smooth"]


class TestEngine:
    @pytest.mark.parametrize("case", SMOOTH, ids=[case.name for case in SMOOTH])
    def test_smooth_ones_are_answered_as_closely_as_asked(self, case: Case) -> None:
        found, _ = uncertainty.own(case, {})
        assert wrong(found, case) <= 1e-4, case.name

    def test_kinds_hold_all_cases(self) -> None:
        kinds = [uncertainty.kind_of(case) for case in CASES]
        assert all(kinds.count(kind) >= 15 for kind in ("smooth", "bounded", "kinked"))

    def test_every_formula_has_a_case(self) -> None:
        assert {case.task for case in CASES} == set(FORMULAS)

    def test_the_largest_is_the_largest(self) -> None:
        x = np.random.default_rng(3).normal(size=(4, 50))
        assert np.allclose(FORMULAS["largest"](list(x), Arrays()), x.max(axis=0))
        assert np.allclose(FORMULAS["smallest"](list(x), Arrays()), x.min(axis=0))


class TestPeers:
    @pytest.mark.parametrize("name", ["uncertainties", "GTC"])
    def test_first_order_is_exact_for_sums_of_normals(self, name: str) -> None:
        pytest.importorskip(name)
        case = next(case for case in CASES if case.name == "twenty inputs, correlated by 0.99")
        found, estimate = uncertainty.of_library(LIBRARIES[name], case)
        assert estimate is None
        assert wrong(found, case) < 1e-9

    def test_first_order_libraries_agree_with_our_linear_method(self) -> None:
        case = next(case for case in CASES if case.name == "an ordinary skid")
        ours, _ = uncertainty.own(case, {"method": "linear"})
        for name in ("uncertainties", "GTC"):
            pytest.importorskip(name)
            found, _ = uncertainty.of_library(LIBRARIES[name], case)
            assert found == pytest.approx(ours, rel=1e-9)

    def test_mcerp_samples_every_kind_of_input(self) -> None:
        pytest.importorskip("mcerp")
        for kind in ("normal", "uniform", "triangular", "lognormal", "truncated", "readings"):
            case = next(
                case for case in CASES if {one[0] for one in case.inputs["inputs"]} == {kind} and case.task != "step"
            )
            found, _ = uncertainty.of_library(LIBRARIES["mcerp"], case)
            assert all(map(math.isfinite, found))
            assert abs(found[2] - float(case.results["median"])) < 0.05 * float(case.results["std"]), case.name


@pytest.mark.parametrize("case", CASES, ids=[case.name for case in CASES])
def test_no_estimate_is_below_its_error(case: Case) -> None:
    """By the automatic method as users get it: correlations next to one, and moments over lattices, among them."""
    found, estimate = uncertainty.own(case, {})
    assert estimate is not None
    assert wrong(found, case) <= estimate


def test_a_correlation_next_to_one_keeps_its_variance() -> None:
    """1 − ρ² in doubles has ten digits where ρ is 0.999999: the deviation of a difference is its root."""
    from dynamics_cli.core.uncertainty.space import factor

    with mp.workdps(50):
        for rho in (0.999999, -0.999999, 1.0 - 2.0**-30, 0.3):
            made = factor(["a", "b"], {("a", "b"): rho}, {"a", "b"})
            assert made is not None
            exactly = mp.sqrt((1 - mpf(rho)) * (1 + mpf(rho)))
            assert abs(mpf(float(made[1, 1])) - exactly) <= exactly * mpf(2) ** -52
