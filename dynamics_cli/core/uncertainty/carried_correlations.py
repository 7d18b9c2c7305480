"""Correlations carried over from earlier documents: two results of one document are seldom independent."""

from itertools import combinations

import numpy as np

from dynamics_cli.core.uncertainty.space import positive
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from typing import Any

    # By input address: the document, the result's address in it, and the document's covariance entry.
    Origins = Mapping[str, tuple[str, str, Any]]

# Documents state correlations to six digits, which may leave a matrix slightly short of positive definite.
SHRINKAGE = (0.0, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2)


def carried(origins: "Origins", known: "Sequence[str]") -> "dict[tuple[str, str], float]":
    """The correlations of uncertain inputs that are results of one document, as that document states them."""
    correlations: dict[tuple[str, str], float] = {}
    for one, other in combinations([name for name in known if name in origins], 2):
        (document, result, covariance), (second, other_result, _) = origins[one], origins[other]
        if document != second:
            continue
        rho = 1.0 if result == other_result else _stated(document, covariance, result, other_result)
        if rho:
            correlations[one, other] = rho
    if not correlations:
        return {}
    names = list(known)
    for shrunk in SHRINKAGE:
        matrix = np.eye(len(names))
        for (one, other), rho in correlations.items():
            i, j = names.index(one), names.index(other)
            matrix[i, j] = matrix[j, i] = rho * (1.0 - shrunk)
        if positive(matrix):
            return {pair: rho * (1.0 - shrunk) for pair, rho in correlations.items()}
    raise _unreadable(next(iter(origins.values()))[0], "its correlations contradict each other")


def _stated(document: str, covariance: "Any", one: str, other: str) -> float:
    """The correlation of two results in a document's covariance entry; 0 of results that it does not name."""
    if covariance is None:
        return 0.0
    try:
        names, same = covariance["results"], covariance.get("same", {})
        one, other = same.get(one, one), same.get(other, other)
        rows = [[float(number) for number in row] for row in covariance.get("correlation", [])]
    except (AttributeError, KeyError, TypeError, ValueError):
        raise _unreadable(document, "wanted names under results and rows of numbers under correlation") from None
    if not isinstance(names, list) or ((rows or len(names) > 1) and {len(names)} != {len(rows), *map(len, rows)}):
        raise _unreadable(document, "wanted a row and a column of correlations for each of its results")
    if not all(abs(number) <= 1.0 for row in rows for number in row):
        raise _unreadable(document, "wanted correlations from -1 to 1")
    if one == other:
        return 1.0
    return rows[names.index(one)][names.index(other)] if one in names and other in names else 0.0


def _unreadable(document: str, why: str) -> UsageError:
    return UsageError(
        f"the covariance of {document!r} cannot be used: {why}", parameter="covariance", code="covariance"
    )
