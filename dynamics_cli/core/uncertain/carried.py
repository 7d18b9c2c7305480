"""Correlations that come with the results of earlier documents: two of one document are seldom independent."""

from itertools import combinations

import numpy as np

from dynamics_cli.core.uncertain.space import positive

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from typing import Any

    # By input address: the document, the result's address in it, and the document's covariance entry.
    Origins = Mapping[str, tuple[str, str, Any]]

# Documents carry six digits of a correlation, which may leave a matrix a little short of positive definite.
SHRINKAGE = (0.0, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2)


def carried(origins: "Origins", known: "Sequence[str]") -> "dict[tuple[str, str], float]":
    """The correlations of uncertain inputs that are results of one document, as that document states them."""
    found: dict[tuple[str, str], float] = {}
    for one, other in combinations([name for name in known if name in origins], 2):
        (document, result, covariance), (second, other_result, _) = origins[one], origins[other]
        if document != second:
            continue
        rho = 1.0 if result == other_result else _stated(covariance, result, other_result)
        if rho:
            found[one, other] = rho
    if not found:
        return {}
    names = list(known)
    for shrunk in SHRINKAGE:
        matrix = np.eye(len(names))
        for (one, other), rho in found.items():
            i, j = names.index(one), names.index(other)
            matrix[i, j] = matrix[j, i] = rho * (1.0 - shrunk)
        if positive(matrix):
            return {pair: rho * (1.0 - shrunk) for pair, rho in found.items()}
    return {}


def _stated(covariance: "Any", one: str, other: str) -> float:
    try:
        names, same = covariance["results"], covariance.get("same", {})
        one, other = same.get(one, one), same.get(other, other)
        return 1.0 if one == other else float(covariance["correlation"][names.index(one)][names.index(other)])
    except (AttributeError, KeyError, IndexError, TypeError, ValueError):
        return 0.0
