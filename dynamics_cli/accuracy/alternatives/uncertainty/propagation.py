"""Uncertainty: every method of propagation on distributions that are known in closed form or by simple integrals.

Errors are the worst of both ends of the 95 % interval, median, mean and deviation, in deviations of the result.
"""

from functools import cache, partial
from statistics import median

from dynamics_cli.accuracy.alternatives.uncertainty.models import FORMULAS, Arrays
from dynamics_cli.accuracy.cases import Case
from dynamics_cli.accuracy.measure import Errors, Pace, seconds
from dynamics_cli.accuracy.questions import Comparison
from dynamics_cli.accuracy.rows import ESTIMATE, row
from dynamics_cli.errors import DynamicsError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
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
QUESTIONS = tuple(
    Comparison("uncertainty", "", f"uncertainty, {name}", f"{HERE}compare_{name.split()[0]}")
    for name in ("smooth", "bounded", "kinked or folded")
)
MEASURE = "deviations of the result"
RESULTS = ("low", "high", "median", "mean", "std")
# Points that one case may take, unless there are minutes: the program itself allows ten times as many.
FEW_POINTS = 300_000


def own_methods(kind: str, *, full: bool) -> "list[tuple[str, dict[str, Any]]]":
    """The engine's methods; the classical ones need points only for an estimate of their error."""
    few: dict[str, Any] = {} if full else {"samples": FEW_POINTS}
    many = 1_000_000 if full else 100_000
    made: list[tuple[str, dict[str, Any]]] = [
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
        made.append(("automatic, asked for 1e-10", {"accuracy": 1e-10, **few}))
    return made


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
    from dynamics_cli.core.inputs.uncertain.distributions import KINDS

    made: list[Distribution] = []
    for kind, *spelled in case.inputs["inputs"]:
        numbers = [float(text) for text in spelled]
        cls: Callable[..., Distribution] = KINDS[kind]
        made.append(cls(numbers) if kind == "readings" else cls(*numbers))
    return made


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


def compare_smooth(comparing: "Comparing") -> "list[Row]":
    """Models with derivatives of inputs without bounds."""
    return _compared(comparing, "smooth")


def compare_bounded(comparing: "Comparing") -> "list[Row]":
    """Inputs between bounds, and steps."""
    return _compared(comparing, "bounded")


def compare_kinked(comparing: "Comparing") -> "list[Row]":
    """Kinks, atoms, branches that meet."""
    return _compared(comparing, "kinked")


def _compared(comparing: "Comparing", kind: str) -> "list[Row]":
    cases = [case for case in comparing.cases("uncertainty.json") if kind_of(case) == kind]
    options = own_methods(kind, full=comparing.full)
    methods: list[tuple[str, Method]] = [(title, partial(own, options=option)) for title, option in options]
    methods += [(title, partial(of_library, library)) for title, library in comparing.more]
    rows: list[Row] = []
    base: float | None = None
    for title, method in methods:
        foreign = method.func is of_library  # type: ignore[attr-defined]
        errors = _errors(method, cases, Exception if foreign else (DynamicsError, ArithmeticError))
        time = _time(method, cases, comparing.pace) if comparing.timed and errors.cases else None
        base = base or time
        rows.append(row(comparing.name, title, errors, time, base, bound=ESTIMATE, measure=MEASURE))
    return rows


def _errors(method: "Method", cases: "Sequence[Case]", refusals: "Any") -> Errors:
    import warnings

    errors = Errors()
    for case in cases:
        try:
            with warnings.catch_warnings():
                # what another library says to its users is not for ours
                warnings.simplefilter("ignore")
                found, estimate = method(case)
        except refusals:
            errors.refused += 1
            continue
        std = float(case.results["std"])
        apart = [abs(value - float(case.results[key])) / std for value, key in zip(found, RESULTS, strict=True)]
        if not all(one < float("inf") for one in apart):
            errors.refused += 1
            continue
        errors.cases += 1
        worst = max(apart)
        errors.note(f"{case.name}: {RESULTS[apart.index(worst)]}", worst, estimate)
    return errors


def _time(method: "Method", cases: "Sequence[Case]", pace: Pace) -> "float | None":
    """The median over some cases, spread over all."""
    import warnings

    times = []
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for case in cases[:: max(1, len(cases) // pace.timed_cases)]:
            try:
                method(case)
            except Exception:
                continue
            times.append(seconds(lambda: method(case), repeats=3, least=pace.least))  # noqa: B023
    return median(times) if times else None
