"""The rows of the work–precision report."""

from statistics import median

from dynamics_cli.quantities import Count, EvaluationTime, Ratio, Text
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.accuracy.measure import Errors


@record
class Row:
    """One method of one question.

    Parameters
    ----------
    question : Text
        What is calculated.
    method : Text
        By which method; the one that the program uses is marked.
    cases : Count
        Cases answered.
    refused : Count
        Cases that the method has no answer to, where the reference has one.
    time : EvaluationTime
        Time of one evaluation: the median of repeats.
    slower : Ratio
        Time over the time of the chosen method.
    worst : Ratio
        Largest relative error (absolute where the reference is zero; below the normal doubles, of the smallest one).
    worst_ulp : Ratio
        Largest error in units in the last place of the reference.
    median_ulp : Ratio
        Median error in units in the last place.
    bound : Text
        Whether the bound that the program states was never below the true error.
    worst_case : Text
        The case and the result with the largest error.
    array_time : EvaluationTime
        Time for each case of a call on arrays, where the method takes arrays.
    """

    question: Text
    method: Text
    cases: Count
    refused: Count
    time: EvaluationTime | None
    slower: Ratio | None
    worst: Ratio
    worst_ulp: Ratio | None
    median_ulp: Ratio | None
    bound: Text
    worst_case: Text
    array_time: EvaluationTime | None


def row(
    question: str,
    method: str,
    errors: "Errors",
    time: "float | None",
    base: "float | None",
    *,
    array_time: "float | None" = None,
    bound: str = "bound",
) -> Row:
    """A method's row; `base` is the chosen method's time, `bound` what the stated errors are called."""
    stated = ""
    if errors.bounded:
        stated = f"{bound} held" if not errors.broken else f"{bound} short {errors.broken} of {errors.bounded} times"
    return Row(
        question,
        method,
        errors.cases,
        errors.refused,
        time,
        time / base if time and base else None,
        max(errors.relative, default=0.0),
        max(errors.ulps) if errors.ulps else None,
        median(errors.ulps) if errors.ulps else None,
        stated,
        errors.worst[0],
        array_time,
    )
