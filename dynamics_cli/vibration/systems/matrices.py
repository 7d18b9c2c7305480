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
# A static deflection of a load, as a frequency of no digits, is none.
LOST = 0.01


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
    values = np.linalg.eigvalsh(_scaled(arrays[0]))
    require(
        values[0] > 4.0 * n * UNIT * values[-1],
        "the mass matrix is not positive definite: a coordinate, or a combination of some, has no mass",
        code="singular-mass",
        hint="give masses and springs (--body, --coupling): massless bodies are condensed there",
    )
    if arrays[2] is not None:
        low = np.linalg.eigvalsh(arrays[2])
        require(
            low[0] >= -SYMMETRIC * max(abs(low).max(), 1e-300),
            "the damping matrix feeds energy in: its lowest eigenvalue is {low}",
            low=(float(low[0]), Ratio),
            code="negative-damping",
        )
    return arrays[0], arrays[1], arrays[2]


def _scaled(mass: "Any") -> "Any":
    """The mass matrix with a unit diagonal, so that units do not decide."""
    diagonal = np.diag(mass)
    require(bool((diagonal > 0.0).all()), "a mass on the diagonal of the mass matrix is not above zero",
            code="singular-mass", hint="leave out coordinates without mass, or condense them")  # fmt: skip
    root = np.sqrt(diagonal)
    return mass / root[:, None] / root[None, :]


def symmetric_modes(mass: "Any", stiffness: "Any") -> "tuple[Any, Any, Any]":
    """Angular frequencies, shapes of unit modal mass in columns, and what rounding leaves to each, relatively."""
    from scipy.linalg import eigh

    root = np.sqrt(np.diag(mass))
    scaled_mass, scaled = mass / root[:, None] / root[None, :], stiffness / root[:, None] / root[None, :]
    squares, vectors = eigh(scaled, scaled_mass)
    n = len(root)
    room = 4.0 * n * UNIT * float(np.linalg.norm(scaled, 2)) / float(np.linalg.eigvalsh(scaled_mass)[0])
    require(
        squares[0] >= -room,
        "the stiffness matrix has a negative eigenvalue, ω² = {square}: the system moves away from rest (divergence)",
        square=(float(squares[0]), Ratio),
        code="divergence",
    )
    omega = np.sqrt(np.maximum(squares, 0.0))
    with np.errstate(all="ignore"):
        errors = np.where(squares > room, 0.5 * room / np.maximum(squares, 1e-300), math.inf)
    return omega, vectors / root[:, None], errors


def proportional(mass: "Any", damping: "Any", stiffness: "Any") -> bool:
    """Whether the damping leaves the undamped modes apart: C·M⁻¹·K is symmetric (Caughey & O'Kelly 1965)."""
    product = damping @ np.linalg.solve(mass, stiffness)
    return bool(abs(product - product.T).max() <= SYMMETRIC * abs(product).max())


def complex_modes(mass: "Any", damping: "Any", stiffness: "Any") -> "tuple[Any, Any, Any, Any]":
    """Eigenvalues of the motion with Im ≥ 0 by size, their shapes, and all pairs for sums over modes."""
    from scipy.linalg import eig

    n = len(mass)
    root = np.sqrt(np.diag(mass))
    scaled_mass = mass / root[:, None] / root[None, :]
    inverse = np.linalg.inv(scaled_mass)
    pace = math.sqrt(float(abs(stiffness / root[:, None] / root[None, :]).max())) or 1.0
    top = np.hstack([np.zeros((n, n)), np.eye(n)])
    below = np.hstack(
        [-inverse @ (stiffness / root[:, None] / root[None, :]) / pace**2,
         -inverse @ (damping / root[:, None] / root[None, :]) / pace]
    )  # fmt: skip
    values, vectors = eig(np.vstack([top, below]))
    values = values * pace
    shapes = vectors[:n] / root[:, None]
    chosen = [i for i in range(2 * n) if values[i].imag > 1e-9 * abs(values[i])]
    real = [i for i in range(2 * n) if abs(values[i].imag) <= 1e-9 * abs(values[i])]
    order = sorted(chosen, key=lambda i: abs(values[i]))
    return values[order], shapes[:, order], values, values[real].real
