"""Jacobi's rotations of many matrices side by side: those whose element is small already stay as they are."""

import numpy as np

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

UNIT_ROUNDOFF = 2.0**-53


def rotate(a: "list[list[Any]]", axes: "list[list[Any]]", p: int, q: int, r: int) -> bool:
    """One rotation of every lane, to the bits of `jacobi`; whether any lane turned."""
    off = a[p][q]
    kind = type(off)
    off = np.asarray(off)
    with np.errstate(all="ignore"):
        negligible = abs(off) <= 0.25 * UNIT_ROUNDOFF * np.sqrt(abs(a[p][p])) * np.sqrt(abs(a[q][q]))
        turning = (off != 0.0) & ~np.asarray(negligible)
        theta = (a[q][q] - a[p][p]) / (2.0 * off)
        t = np.where(
            abs(theta) < 1e150,
            np.where(theta >= 0.0, 1.0, -1.0) / (abs(theta) + np.sqrt(1.0 + theta * theta)),
            0.5 / theta,
        )
        c = 1.0 / np.sqrt(1.0 + t * t)
        s = c * t
        tau = s / (1.0 + c)

        def where(turned: "Any", still: "Any") -> "Any":
            return np.where(turning, turned, still).view(kind)

        a[p][p] = where(a[p][p] - t * off, a[p][p])
        a[q][q] = where(a[q][q] + t * off, a[q][q])
        a[p][q] = a[q][p] = np.zeros_like(off).view(kind)
        x, y = a[r][p], a[r][q]
        a[r][p] = a[p][r] = where(x - s * (y + tau * x), x)
        a[r][q] = a[q][r] = where(y + s * (x - tau * y), y)
        for k in range(3):
            x, y = axes[p][k], axes[q][k]
            axes[p][k], axes[q][k] = where(x - s * (y + tau * x), x), where(y + s * (x - tau * y), y)
    return bool(turning.any())
