"""Quadrature for the standard normal density: Gauss–Hermite of any order, and Genz and Keister's embedded rules."""

import math

import numpy as np

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]

# The positive nodes of the Genz–Keister rules in the order 3, 9, 19, 35 points add them, and the weights of each rule
# (node 0 first): tests/references/generate_hermite_tables.py derives them.
GENZ_KEISTER_NODES = (
    1.7320508075688772, 0.7410953499945409, 2.861279576057058, 4.184956017672732, 1.230423634027306,
    2.5960831150492023, 3.2053337944991944, 5.187016039913656, 6.36339449433637, 0.2489922975799606,
    2.2336260616769414, 3.6353185190372783, 4.736433085952297, 5.69817776848811, 7.122106700804617,
    7.980771798590561, 9.016939789890303,
)  # fmt: skip
GENZ_KEISTER_WEIGHTS: "dict[int, tuple[float, ...]]" = {
    1: (1.0,),
    3: (0.6666666666666666, 0.16666666666666666),
    9: (0.25396825396825395, 0.0948509485094851, 0.27007432957793787, 0.007996325470893533, 9.426945755651748e-05),
    19: (
        0.3034671998542059, 0.06409605468680758, 0.20832499164960888, -0.0063372247933737354, 6.012336945984782e-05,
        0.061151730125247675, 0.018085234254798452, 0.002884880436506751, 6.094808731468983e-07, 8.629684602229886e-10,
    ),
    35: (
        0.0005148945080687843, 0.045273685465150516, 0.148070831155216, 0.00231134524035221, 3.57293481989751e-05,
        0.09236472671698631, 0.003155446269187564, 0.0008189539275022649, 2.4676421345798077e-07,
        4.6011760348656186e-10, 0.19176011588804442, 0.01567347375185115, 0.0002752421411678516,
        2.734220680118783e-06, 2.1394194479561105e-08,
        3.097222357606316e-12, 5.45004126506369e-15, 1.0541326582333341e-18,
    ),
}  # fmt: skip

_made: "dict[int, tuple[Array, Array]]" = {}


def gauss_hermite(count: int) -> "tuple[Array, Array]":
    """Nodes and weights with Σ w f(z) = E f(Z) for polynomials of degree 2·count − 1.

    References
    ----------
    G. H. Golub, J. H. Welsch, Calculation of Gauss quadrature rules, Math. Comp. 23 (1969) 221.
    """
    if count not in _made:
        _made[count] = _gauss_hermite(count)
    return _made[count]


def genz_keister(count: int) -> "tuple[Array, Array]":
    """The embedded rule of 1, 3, 9, 19 or 35 points: 0, then pairs ± in the order in which the rules add them.

    References
    ----------
    A. Genz, B. D. Keister, Fully symmetric interpolatory rules for multiple integrals over infinite regions with
    Gaussian weight, J. Comput. Appl. Math. 71 (1996) 299.
    """
    weights = GENZ_KEISTER_WEIGHTS[count]
    nodes = [0.0]
    for node in GENZ_KEISTER_NODES[: count // 2]:
        nodes += [node, -node]
    return np.array(nodes), np.array([weights[0], *np.repeat(weights[1:], 2)])


def tensor(nodes: "Array", weights: "Array", dimensions: int) -> "tuple[Array, Array]":
    """The product rule: points (dimensions, n) and weights (n)."""
    points = np.empty((0, 1))
    products = np.ones(1)
    for _ in range(dimensions):
        points = np.vstack([np.repeat(points, len(nodes), axis=1), np.tile(nodes, products.size)])
        products = np.repeat(products, len(nodes)) * np.tile(weights, products.size)
    return points, products


def _gauss_hermite(count: int) -> "tuple[Array, Array]":
    """Eigenvalues of the Jacobi matrix (Golub & Welsch 1969), sharpened by Newton on the orthonormal polynomial."""
    beside = np.sqrt(np.arange(1.0, count))
    nodes = np.linalg.eigvalsh(np.diag(beside, 1) + np.diag(beside, -1))
    for _ in range(2):
        values, below, _ = _orthonormal(nodes, count)
        nodes = nodes - values / (math.sqrt(count) * below)
    nodes = 0.5 * (nodes - nodes[::-1])
    # Christoffel's formula: positive terms only, so every weight keeps its relative accuracy.
    weights = 1.0 / _orthonormal(nodes, count)[2]
    weights = 0.5 * (weights + weights[::-1])
    return nodes, weights


def _orthonormal(x: "Array", count: int) -> "tuple[Array, Array, Array]":
    """h_count, h_{count−1} and the sum of the squares of h_0 … h_{count−1}; h' of the first is √count · the second."""
    before, now = np.zeros_like(x), np.ones_like(x)
    squares = np.ones_like(x)
    for k in range(1, count + 1):
        before, now = now, (x * now - math.sqrt(k - 1) * before) / math.sqrt(k)
        if k < count:
            squares += now * now
    return now, before, squares


def polynomials(z: "Array", degree: int) -> "Array":
    """Orthonormal Hermite polynomials h_0 … h_degree at `z`, stacked first.

    References
    ----------
    NIST Digital Library of Mathematical Functions, section 18.9: the three-term recurrence, normalised.
    """
    rows = [np.ones_like(z), z]
    for k in range(2, degree + 1):
        rows.append((z * rows[-1] - math.sqrt(k - 1) * rows[-2]) / math.sqrt(k))
    return np.array(rows[: degree + 1])
