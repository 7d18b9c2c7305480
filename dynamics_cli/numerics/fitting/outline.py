"""A curve as an outline of arcs, cubics or lines whose proved deviation keeps a tolerance."""

import numpy as np

from dynamics_cli.errors import require
from dynamics_cli.numerics.fitting.deviation import proved
from dynamics_cli.numerics.fitting.pieces import controls, fit, form_of
from dynamics_cli.outlines import Arc, Cubic, Outline, Points
from dynamics_cli.quantities import Size

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.numerics.fitting.path import Path

TRIES = 5
# Margin between fit and proof: samples miss a little, and cells add a little.
FIT = 0.96


def outlined(path: "Path", form: str, tolerance: float, joints: "Any", name: str) -> Outline:
    """The closed curve as an outline whose proved deviation keeps the tolerance.

    Parameters
    ----------
    path : Path
        The curve.
    form : str
        "arcs", "cubics" or "lines".
    tolerance : Size
        Largest deviation allowed.
    joints : array (n, 2)
        Where each smooth piece begins, as it is written.
    name : str
        Name of the outline.

    Returns
    -------
    Outline
        The outline.

    Raises
    ------
    InadmissibleError
        When the tolerance cannot be kept.
    """
    size = float(np.abs(joints).max())
    require(
        tolerance >= 2e-12 * size,
        "a tolerance of {tolerance} is below the rounding of coordinates of {size}",
        tolerance=(tolerance, Size),
        size=(size, Size),
        least=(2e-12 * size, Size),
        code="too-fine",
        hint="take a tolerance of at least {least:2}",
    )
    aim = FIT * tolerance
    for _ in range(TRIES):
        pieces, bounds = _fitted(path, form, aim, tolerance, joints)
        deviation = float(max(bounds))
        if deviation <= tolerance:
            break
        aim *= 0.8
    require(
        deviation <= tolerance,
        "a deviation of {deviation} could be proved; wanted {tolerance}",
        deviation=(deviation, Size),
        tolerance=(tolerance, Size),
        code="not-proved",
        hint="allow a wider tolerance",
    )
    return Outline(tuple(pieces), True, deviation, name)


def _fitted(path: "Path", form: str, aim: float, tolerance: float, joints: "Any") -> "tuple[list[Any], list[float]]":
    pieces: list[Any] = []
    bounds: list[float] = []
    for index, places, shape in fit(path, form, aim):
        smooth_piece, made_of = path.on(index), form_of(path, index, form)
        points = np.stack(smooth_piece.at(places)[:2], axis=1)
        points[0], points[-1] = joints[index], joints[(index + 1) % len(joints)]
        if made_of == "cubics":
            cx, cy = controls(smooth_piece, places, shape)
            shape = np.stack((cx[:, 1:3], cy[:, 1:3]), axis=2)
        # the proof is for the coordinates as written, to the bit
        bounds.append(float(proved(path, index, places, shape, made_of, points, tolerance).max()))
        ends = points.tolist()
        if made_of == "arcs":
            pieces += [Arc(a, b, bulge) for a, b, bulge in zip(ends, ends[1:], shape.tolist(), strict=False)]
        elif made_of == "cubics":
            inner = shape.tolist()
            pieces += [Cubic(a, p, q, b) for a, b, (p, q) in zip(ends, ends[1:], inner, strict=False)]
        else:
            pieces.append(Points(tuple(map(tuple, ends))))
    return pieces, bounds
