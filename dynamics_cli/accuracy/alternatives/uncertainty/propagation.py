"""Uncertainty: every method of propagation on distributions that are known in closed form or by simple integrals.

Errors are the worst of both ends of the 95 % interval, median, mean and deviation, in deviations of the result.
"""

from functools import cache, partial

from dynamics_cli.accuracy.alternatives.uncertainty.models import FORMULAS, Arrays
from dynamics_cli.accuracy.cases import Case
from dynamics_cli.accuracy.measure import Errors
from dynamics_cli.accuracy.questions import Comparison
from dynamics_cli.accuracy.rows import ESTIMATE

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.rows import Row
    from dynamics_cli.core.inputs.uncertain.distributions import Distribution

    # Both ends of the interval, median, mean and deviation.
    Found = tuple[float, float, float, float, float]
    # These, and an estimate of their error, if any.
    Answer = tuple[Found, float | None]
    Method = Callable[[Case], Answer]

HERE = "dynamics_cli.accuracy.alternatives.uncertainty.propagation:"
KINDS = {
    "uncertainty, smooth": "smooth", "uncertainty, bounded": "bounded", "uncertainty, kinked or folded": "kinked",
}  # fmt: skip
QUESTIONS = tuple(Comparison("uncertainty", "", name, HERE + "compare") for name in KINDS)
MEASURE = "deviations of the result"
RESULTS = ("low", "high", "median", "mean", "std")
# Points that one case may take, unless there are minutes: the program itself allows ten times as many.
FEW_POINTS = 300_000


def own_methods(kind: str, *, full: bool) -> "list[tuple[str, dict[str, Any]]]":
    """The engine's methods; the classical ones need points only for an estimate of their error."""
    few: dict[str, Any] = {} if full else {"samples": FEW_POINTS}
    many = 1_000_000 if full else 100_000
    methods: list[tuple[str, dict[str, Any]]] = [
        ("automatic (chosen)" if full else "automatic, 3e5 points at most (chosen)", few),
        ("linear", {"method": "linear", "samples": 20_000}),
        ("second order", {"method": "second-order", "samples": 20_000}),
        ("unscented", {"method": "unscented", "samples": 20_000}),
        ("shifted lattices", {"method": "lattice", **few}),
        ("Monte Carlo, 1e4", {"method": "monte-carlo", "samples": 10_000}),
        (f"Monte Carlo, 1e{len(str(many)) - 1}", {"method": "monte-carlo", "samples": many}),
    ]
    if kind == "smooth":
        # where it converges quickly: what asking for more costs
        methods.append(("automatic, asked for 1e-10", {"accuracy": 1e-10, **few}))
    return methods


# Models with a kink, or with several branches that meet within the inputs.
FOLDED = ("absolute", "positive", "apart", "largest", "smallest", "square", "squares", "radius", "sine")
BOUNDED = ("uniform", "triangular", "truncated")


def kind_of(case: Case) -> str:
    """What a case is hard for: folded by its model, bounded by an input, or smooth."""
    kinds = {spelled[0] for spelled in case.inputs["inputs"]}
    about_zero = case.name == "product about zero"
    if case.task in FOLDED or about_zero:
        return "kinked"
    return "bounded" if kinds & set(BOUNDED) or case.task in ("step", "root") else "smooth"


def distributions(case: Case) -> "list[Distribution]":
    """A case's inputs."""
    from dynamics_cli.core.inputs.uncertain.distributions import KINDS as CLASSES

    inputs: list[Distribution] = []
    for kind, *spelled in case.inputs["inputs"]:
        numbers = [float(text) for text in spelled]
        cls: Callable[..., Distribution] = CLASSES[kind]
        inputs.append(cls(numbers) if kind == "readings" else cls(*numbers))
    return inputs


def correlations(case: Case) -> "list[tuple[int, int, float]]":
    """Which inputs are correlated, by place."""
    return [(i, j, float(rho)) for i, j, rho in case.inputs.get("correlation", ())]


@cache
def _arrays() -> Arrays:
    return Arrays()


def own(case: Case, options: "dict[str, Any]") -> "Answer":
    """The program's engine by one of its methods."""
    from dynamics_cli.core.uncertainty.propagation import propagate

    inputs = distributions(case)
    names = [f"x{i}" for i in range(len(inputs))]
    formula = FORMULAS[case.task]

    def model(x: "dict[str, Any]") -> "tuple[dict[str, Any], Any]":
        return {"y": formula([x[name] for name in names], _arrays())}, None

    pairs = {(names[i], names[j]): rho for i, j, rho in correlations(case)}
    spread = propagate(model, dict(zip(names, inputs, strict=True)), pairs, shares=False, **options).spreads["y"]
    return (*spread.interval, spread.median, spread.mean, spread.std), spread.estimate


def of_library(library: "Callable[..., Found]", case: Case) -> "Answer":
    """A library of others."""
    return library(distributions(case), correlations(case), FORMULAS[case.task]), None


def compare(comparing: "Comparing") -> "list[Row]":
    """Models with derivatives of inputs without bounds; inputs between bounds, and steps; kinks and folds."""
    import warnings

    kind = KINDS[comparing.name]
    cases = [case for case in comparing.cases("uncertainty.json") if kind_of(case) == kind]
    methods = [(title, partial(own, options=option)) for title, option in own_methods(kind, full=comparing.full)]
    libraries = [(title, partial(of_library, library)) for title, library in comparing.more]
    comparing.more = ()

    def answer(errors: Errors, case: Case, method: "Any", _: int) -> "Callable[[], Answer]":
        try:
            values, estimate = method(case)
        except Exception as failure:
            # another library may fail in any way it likes
            if method.func is of_library:
                raise ArithmeticError from failure
            raise
        std = float(case.results["std"])
        apart = [abs(value - float(case.results[key])) / std for value, key in zip(values, RESULTS, strict=True)]
        if not all(share < float("inf") for share in apart):
            raise ArithmeticError
        errors.note(f"{case.name}: {RESULTS[apart.index(max(apart))]}", max(apart), estimate)
        return lambda: method(case)

    with warnings.catch_warnings():
        # what another library says to its users is not for ours
        warnings.simplefilter("ignore")
        return comparing.rows(
            [*methods, *libraries], cases, answer, most=comparing.pace.timed_cases, repeats=3, bound=ESTIMATE,
            measure=MEASURE,
        )  # fmt: skip
