"""Planar impacts in bulk: the closed-form path of `path` on whole arrays, in blocks that stay in the cache.

The same path with plain sums where the single case rounds as if in twice the precision; so rows of a stream use
`path`, and maps and Python calls that want speed use this.
"""

import numpy as np

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[np.float64]

BLOCK = 16384
INFINITY = float("inf")


def planar_impacts(
    tangential: "Any",
    coupling: "Any",
    normal: "Any",
    slip: "Any",
    approach: "Any",
    friction: "Any",
    restitution: "Any",
    *,
    law: str = "stronge",
    determinant: "Any" = None,
) -> "tuple[Array, Array]":
    """Normal and tangential impulses of many planar impacts, NaN where the bodies do not approach.

    `tangential`, `coupling`, `normal`: k_t, k_x, k_n of the contact [1/kg]; `slip`, `approach`: u_t and u_n before; an
    impact has u_n < 0 [m/s]; `friction`, `restitution`: μ and e [-]; `law`: stronge, newton or poisson; `determinant`:
    k_t k_n − k_x² where it is known better than from this difference [1/kg²]. Returns p_n and p_t on body 1 [N·s], of
    the shape that the inputs broadcast to. Raises ValueError when the law has no path.

    Rounding is a few 1e-16 of the impulse where k_t k_n is not nearly k_x².

    Equation
    --------
    As `dynamics_cli.impact.planar.path.travel`.

    References
    ----------
    J. B. Keller, Impact with friction, J. Appl. Mech. 53 (1986); W. J. Stronge, Impact Mechanics (2000).

    Examples
    --------
    >>> p_n, p_t = planar_impacts(1.0, 0.0, 1.0, 3.0, -2.0, 0.1, [0.0, 0.5])
    >>> p_n.tolist(), p_t.round(12).tolist()
    ([2.0, 3.0], [-0.2, -0.3])
    """
    if law not in ("stronge", "newton", "poisson"):
        raise ValueError(f"{law} has no path")
    if determinant is None:
        determinant = np.asarray(tangential) * normal - np.asarray(coupling) * coupling
    inputs = (tangential, coupling, normal, determinant, slip, approach, friction, restitution)
    arrays = np.broadcast_arrays(*(np.asarray(value, dtype=float) for value in inputs))
    shape = arrays[0].shape
    flat = [array.ravel() for array in arrays]
    across, along = np.empty(flat[0].size), np.empty(flat[0].size)
    for start in range(0, flat[0].size, BLOCK):
        part = slice(start, start + BLOCK)
        across[part], along[part] = impulses(*(array[part] for array in flat), law=law)
    return across.reshape(shape), along.reshape(shape)


def impulses(
    kt: "Any", kx: "Any", kn: "Any", det: "Any", ut: "Any", un: "Any", mu: "Any", e: "Any", *, law: str
) -> "tuple[Array, Array]":
    """p_n and p_t of one block; arrays may broadcast, so that quantities of friction alone are calculated once."""
    with np.errstate(all="ignore"):
        ratio = -mu * np.sign(ut)
        slope = kn + kx * ratio
        first = -ut / (kx + kt * ratio)
        # never stops: infinite; and where nothing slips or would slip, both phases are the same
        first = np.where(first >= 0.0, first, INFINITY)
        size = np.abs(kx)
        later = (det + size * np.maximum(size - mu * kt, 0.0)) / kt
        late_ratio = -np.clip(kx / kt, -mu, mu)
        turned = un + slope * first
        inside = turned >= 0.0
        straight = -un / slope
        total = (1.0 + e) * straight
        ended = inside & (total <= first)
        bent = first - turned / later
        if law == "newton":
            beyond = (-e * un - turned) / later
        elif law == "poisson":
            beyond = np.where(inside, total, (1.0 + e) * bent) - first
        else:
            final = e * un
            square_left = (final - turned) * (final + turned) / slope
            crossing = square_left / (turned + np.sqrt(turned * turned + later * square_left))
            work = turned * (turned / later) - (un + turned) * first
            beyond = np.where(inside, crossing, e * np.sqrt(work / later) - turned / later)
        along = np.where(ended, total, first)
        beyond = np.where(ended, 0.0, np.maximum(beyond, 0.0))
        across = np.where(un < 0.0, along + beyond, np.nan)
        return across, ratio * along + late_ratio * beyond


def ratio_impulses(
    kt: "Any", kx: "Any", kn: "Any", det: "Any", ut: "Any", un: "Any", mu: "Any", e: "Any", *, law: str
) -> "tuple[Array, Array]":
    """p_n and p_t by Brach's impulse ratio (without moment) or by Kudlich and Slibar; NaN where p_n pulls."""
    with np.errstate(all="ignore"):
        grown = 1.0 + e
        rise = -(grown if law == "brach" else 1.0) * un
        along = kn * -ut - kx * rise
        across = kt * rise + kx * ut
        holds = np.abs(along) <= mu * across
        ratio = mu * np.where(along < 0.0, -1.0, 1.0) * np.where(across < 0.0, -1.0, 1.0)
        slid = rise / (kn + kx * ratio)
        pn = np.where(holds, across / det, slid)
        pt = np.where(holds, along / det, ratio * slid)
        if law != "brach":
            pn, pt = grown * pn, grown * pt
        return np.where((pn > 0.0) & (un < 0.0), pn, np.nan), pt
