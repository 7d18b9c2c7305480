"""The rows of the work–precision report."""

from statistics import median

from dynamics_cli.quantities import Annotated, Count, EvaluationTime, Ratio, Text
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from dynamics_cli.accuracy.measure import Errors

CHOSEN = " (chosen)"
# Stated errors that are proved; an estimate is not, and may fall short of a few cases.
ESTIMATE = "estimate"
# Errors within this factor of one another are a tie: which is less depends on the last bits.
TIE = 2.0
# A few last bits, below which methods are alike.
LAST_BITS = 1e-15


@record
class Row:
    """One method of one question."""

    family: Annotated[Text, "The family whose calculation it is."]
    task: Annotated[Text, "The task of it, where the question is of one."]
    question: Annotated[Text, "What is calculated."]
    method: Annotated[Text, "By which method; the one that the program uses is marked."]
    cases: Annotated[Count, "Cases answered."]
    refused: Annotated[Count, "Cases that the method has no answer to, where the reference has one."]
    time: Annotated[EvaluationTime | None, "Time of one evaluation: the median of repeats."]
    slower: Annotated[Ratio | None, "Time over the time of the chosen method."]
    worst: Annotated[Ratio, "Largest error, in the row's measure."]
    median: Annotated[Ratio, "Median error, in the row's measure."]
    worst_ulp: Annotated[Ratio | None, "Largest error in units in the last place of the reference."]
    median_ulp: Annotated[Ratio | None, "Median error in units in the last place."]
    own_worst: Annotated[Ratio | None, "The chosen method's largest error over the very results that this method gave."]
    measure: Annotated[
        Text,
        "What errors are measured in: shares of the reference (absolute where that is zero; below the normal "
        "doubles, shares of the smallest one), or what the question says.",
    ]
    bound: Annotated[Text, "Whether the bound that the program states was never below the true error."]
    stated: Annotated[Count, "Results with a stated bound."]
    broken: Annotated[Count, "Those whose bound was below the true error."]
    looseness: Annotated[
        Ratio | None,
        "The stated bound over the true error, in the median; an error below half a last bit counts as that.",
    ]
    worst_case: Annotated[Text, "The case and the result with the largest error."]
    worst_reference: Annotated[
        Text, "The true value of the worst result, in SI units: where it all but vanishes, a share of it says little."
    ] = ""
    share: Annotated[
        Ratio | None, "How many of the chosen method's results it gives, over the cases that it answers."
    ] = None
    loosest: Annotated[
        Ratio | None, "The stated bound over the true error where that is largest, counted as in the median."
    ] = None
    counts: Annotated[bool, "Whether all results are whole numbers, which are right or wrong."] = False

    @property
    def is_proved(self) -> bool:
        """Whether it is the program's own method with bounds, which estimates are not."""
        return self.method.endswith(CHOSEN) and self.stated > 0 and not self.bound.startswith(ESTIMATE)


def row(
    question: str,
    method: str,
    errors: "Errors",
    time: "float | None",
    base: "float | None",
    *,
    bound: str = "bound",
    measure: str = "relative",
    own: "Errors | None" = None,
) -> Row:
    """A method's row; `base` is the chosen method's time, `own` its errors, `bound` what stated errors are called."""
    stated = ""
    if errors.bounded:
        stated = f"{bound} held" if not errors.broken else f"{bound} short {errors.broken} of {errors.bounded} times"
    return Row(
        "",
        "",
        question,
        method,
        errors.cases,
        errors.refused,
        time,
        time / base if time and base else None,
        max(errors.relative, default=0.0),
        median(errors.relative) if errors.relative else 0.0,
        max(errors.ulps) if errors.ulps else None,
        median(errors.ulps) if errors.ulps else None,
        max((own.by_result[where] for where in errors.by_result if where in own.by_result), default=None)
        if own
        else None,
        measure,
        stated,
        errors.bounded,
        errors.broken,
        median(errors.looseness) if errors.looseness else None,
        errors.worst[0],
        worst_reference="" if errors.worst_reference is None else f"{errors.worst_reference:.3g}",
        share=_share(errors, own) if own else None,
        loosest=max(errors.looseness, default=None),
        counts=0 < errors.whole == len(errors.relative),
    )


def _share(errors: "Errors", own: "Errors") -> "float | None":
    """The part of the chosen method's results that another gives, in the cases that it answers."""
    cases = {where.partition(" ")[0] for where in errors.by_result}
    total = sum(where.partition(" ")[0] in cases for where in own.by_result)
    return min(len(errors.by_result) / total, 1.0) if total else None


def finished(rows: "Sequence[Row]", family: str, task: str) -> "list[Row]":
    """The rows of one question with their family and task."""
    return [Row(**{**line.__dict__, "family": family, "task": task}) for line in rows]


def compared_worst(line: Row, rows: "Sequence[Row]") -> float:
    """The error by which a method stands beside the others: the program's own, over results that another gives too."""
    if not line.method.endswith(CHOSEN):
        return line.worst
    return max((other.own_worst for other in rows if other.own_worst is not None), default=line.worst)


def beats(line: Row) -> bool:
    """Whether an alternative that answers every case is clearly more exact than our own method over the same results.

    An error of one and more says that no digit is right, however large it is.
    """
    if line.own_worst is None or line.refused or line.measure != "relative":
        return False
    return min(line.own_worst, 1.0) > max(TIE * line.worst, LAST_BITS)
