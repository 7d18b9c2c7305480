"""Modes from given matrices: symmetric ones with the digits that rounding leaves, complex ones of any damping."""

import math

import numpy as np

from dynamics_cli.errors import require
from dynamics_cli.quantities import Ratio

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# What rounding leaves of the symmetry of a matrix, or of a product.
SYMMETRIC = 1e-12
UNIT = 2.0**-53


def checked(mass: "Any", stiffness: "Any", damping: "Any") -> "tuple[Any, Any, Any]":
    """The matrices as arrays, symmetric, of one size, the mass matrix positive definite."""
    arrays = [None if one is None else np.array(one, dtype=float) for one in (mass, stiffness, damping)]
    n = len(arrays[0])  # type: ignore[arg-type]
    for name, array in zip(("mass", "stiffness", "damping"), arrays, strict=True):
        if array is None:
            continue
        require(
            array.shape == (n, n),
            "the {name} matrix has {rows} rows of {columns}; the mass matrix has {n}",
            name=name, rows=str(array.shape[0]), columns=str(array.shape[1]), n=str(n), code="shape",
        )  # fmt: skip
        off = abs(array - array.T).max()
        require(off <= SYMMETRIC * abs(array).max(), "the {name} matrix is not symmetric", name=name, code="symmetry",
                hint="a gyroscopic or follower term does not belong here")  # fmt: skip
    cholesky(arrays[0])
    if arrays[2] is not None:
        low = np.linalg.eigvalsh(arrays[2])
        require(
            low[0] >= -SYMMETRIC * max(abs(low).max(), 1e-300),
            "the damping matrix feeds energy in: its lowest eigenvalue is {low}",
            low=(float(low[0]), Ratio),
            code="negative-damping",
        )
    return arrays[0], arrays[1], arrays[2]


def _roots(mass: "Any") -> "Any":
    """Square roots of the diagonal of the mass matrix: scaled by them, units do not decide."""
    diagonal = np.diag(mass)
    require(bool((diagonal > 0.0).all()), "a mass on the diagonal of the mass matrix is not above zero",
            code="singular-mass", hint="leave out coordinates without mass, or condense them")  # fmt: skip
    return np.sqrt(diagonal)


def cholesky(mass: "Any") -> "tuple[Any, Any, float]":
    """Scale, the inverse of the factor of the scaled mass matrix, and a limit of the norm of that matrix's inverse."""
    from scipy.linalg.lapack import dpotrf, dtrtri

    root, n = _roots(mass), len(mass)
    factor, info = dpotrf(mass / root[:, None] / root, lower=True)
    inverse = dtrtri(factor, lower=True)[0] if info == 0 else factor
    # ‖L⁻¹‖₂² ≤ ‖L⁻¹‖₁·‖L⁻¹‖∞
    room = float(abs(inverse).sum(axis=0).max() * abs(inverse).sum(axis=1).max())
    require(
        info == 0 and 4.0 * n * UNIT * room < 1.0,
        "the mass matrix is not positive definite: a coordinate, or a combination of some, has no mass",
        code="singular-mass",
        hint="give masses and springs (--body, --coupling): massless bodies are condensed there",
    )
    return root, inverse, room


def symmetric_modes(mass: "Any", stiffness: "Any") -> "tuple[Any, Any, Any]":
    """Angular frequencies, shapes of unit modal mass in rows, and what rounding leaves to each, relatively."""
    from scipy.linalg import eigh

    root, inverse, limit = cholesky(mass)
    n, scaled = len(root), stiffness / root[:, None] / root
    squares, vectors = eigh(inverse @ scaled @ inverse.T, driver="evd", check_finite=False)
    # ‖K‖₂ is below either norm, and below λ·‖M‖
    size = min(float(np.linalg.norm(scaled)), float(abs(scaled).sum(axis=1).max()))
    room = 4.0 * n * UNIT * size * limit
    require(
        squares[0] >= -room,
        "the stiffness matrix has a negative eigenvalue, ω² = {square}: the system moves away from rest (divergence)",
        square=(float(squares[0]), Ratio),
        code="divergence",
    )
    omega = np.sqrt(np.maximum(squares, 0.0))
    with np.errstate(all="ignore"):
        errors = np.where(squares > room, 0.5 * room / np.maximum(squares, 1e-300), math.inf)
    return omega, vectors.T @ inverse / root, errors


def proportional(mass: "Any", damping: "Any", stiffness: "Any") -> bool:
    """Whether the damping leaves the undamped modes apart: C·M⁻¹·K is symmetric (Caughey & O'Kelly 1965)."""
    product = damping @ np.linalg.solve(mass, stiffness)
    return bool(abs(product - product.T).max() <= SYMMETRIC * abs(product).max())


def complex_modes(mass: "Any", damping: "Any", stiffness: "Any") -> "tuple[Any, Any, Any]":
    """Eigenvalues of the motions that swing, Im > 0, by size; their shapes in rows; the rates of the others."""
    from scipy.linalg import eig

    n, root = len(mass), _roots(mass)
    mass, damping, stiffness = (one / root[:, None] / root for one in (mass, damping, stiffness))
    pace = math.sqrt(float(abs(stiffness).max())) or 1.0
    below = -np.linalg.solve(mass, np.hstack([stiffness / pace**2, damping / pace]))
    values, vectors = eig(np.vstack([np.eye(n, 2 * n, n), below]))
    values = values * pace
    swings = abs(values.imag) > 1e-9 * abs(values)
    order = sorted(np.flatnonzero(swings & (values.imag > 0.0)), key=lambda i: abs(values[i]))
    return values[order], vectors[:n, order].T / root, values[~swings].real
