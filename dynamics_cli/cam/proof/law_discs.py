"""Proved discs that hold lift and derivatives of many parts of laws at many places, roundings included.

Bounds around a place come from `cam.proof.law_enclosures`, those at the place from `cam.proof.law_rounding`.
"""

from dynamics_cli.cam.proof.law_enclosures import UP, U, spreads
from dynamics_cli.cam.proof.law_rounding import HALVES, HALVES_OF_FLOATS
from dynamics_cli.cam.proof.law_rounding import slips as running_slips

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from dynamics_cli.numerics.discs import Disc

# so many places are computed one by one, by the more exact functions of the C library
SINGLE = 256
# and so many are followed one by one
SCALARS = 6


class Parts:
    """Parts of a motion as arrays, from which their discs are calculated.

    `parts`: parts of a motion, as `Motion.parts_of` gives them.
    """

    __slots__ = ("base", "ends", "inner", "members", "off", "scales", "span")

    def __init__(self, parts: "Sequence[Any]") -> None:
        import numpy as np

        laws = [part.law_piece for part in parts]
        self.base, self.off, self.span = (
            np.array([getattr(part, name) for part in parts]) for name in ("base", "off", "span")
        )
        self.scales = np.array([part.scales for part in parts])
        self.ends = np.array([(0.0, 0.0) if law is None else law.ends for law in laws])
        self.inner = np.array([law is not None and min(law.ends) > 0.0 for law in laws])
        shapes: dict[int, list[int]] = {}
        for index, law in enumerate(laws):
            shapes.setdefault(id(None if law is None else law.shape), []).append(index)
        # a dwell has no shape
        self.members = []
        for members_of_shape in shapes.values():
            among = np.zeros(len(laws), dtype=bool)
            among[members_of_shape] = True
            law = laws[members_of_shape[0]]
            self.members.append((None if law is None else law.shape, among))


def discs(
    parts: "Parts", which: "Any", t: "Any", radius: "Any", derivatives: int, *, shares: bool = False,
    exact: bool = False, singly: int = SINGLE,
) -> "tuple[Disc, ...]":  # fmt: skip
    """Discs of lift and derivatives by cam angle, each row of places by its part of the motion.

    `parts`: parts of a motion; `which`: the part of each row; `t`: places in the parts' own coordinates, within their
    ends; `radius`: how far about the places, as cam angles [rad]; k may differ from n where one of them is 1;
    `derivatives`: how many derivatives, 0 to 4; `shares`: whether places come from shares of a zone, whose ends are
    exact, and not from cam angles; `exact`: whether places are exact, except the rounded ends of parts; `singly`: so
    many places (m,) are computed one by one where they are what they are, by the more exact functions of the C library;
    others where it is more than usual. Returns s, ds/dθ, …: centres as computed, radii with all roundings in them.

    A part is one analytic function, so that discs may reach over its ends.

    Examples
    --------
    >>> import numpy as np
    >>> from dynamics_cli.cam.program.reading import Program, motion_of
    >>> motion = motion_of(Program(), "rise 20 mm in 90 deg cycloidal; return in 270 deg cycloidal")
    >>> first = np.zeros(1, dtype=int)
    >>> lift = discs(Parts(motion.parts_of(0)), first, np.array([0.5]), np.array([0.1]), 0)[0]
    >>> float(lift.centre[0]), bool(0.002 < lift.radius[0] < 0.003)
    (0.01, True)
    """
    import numpy as np

    from dynamics_cli.numerics.discs import Disc

    column = (-1, *([1] * (t.ndim - 1)))
    centres = np.zeros((derivatives + 1, *t.shape))
    only = not radius.any()
    radii = np.zeros((derivatives + 1, *np.broadcast_shapes(t.shape, radius.shape)))
    for shape, among in parts.members:
        rows = np.flatnonzero(among[which])
        indices = which[rows]
        if not indices.size:
            continue
        base, off_base = parts.base[indices].reshape(column), parts.off[indices].reshape(column)
        if shape is None:
            centres[0, rows], radii[0, rows] = base, off_base
            continue
        places, scales = t[rows], parts.scales[indices]
        single = (exact or singly > SINGLE) and t.ndim == 1 and rows.size <= singly
        values = _one_by_one(shape, places, derivatives) if single else shape(places, derivatives)
        reach = None if only else radius[rows] / parts.span[indices].reshape(column) * UP
        wide = [0.0] * 5 if only else spreads(shape, places, reach, derivatives)
        offset = np.where(parts.inner[indices] | (not shares), 3.0, 0.0)
        near = np.abs(places)
        off = U * (5.0 * near + offset.reshape(column))
        if exact:
            low, high = (end.reshape(column) for end in parts.ends[indices].T)
            off = np.where((low == places) | (high == places), 2.0 * U * near, 0.0)
        # the lift's factor and its product count two roundings, each division by the span two more
        roundings = [
            rounding + (2.0 + 2.0 * order) * U * np.abs(value)
            for order, (rounding, value) in enumerate(
                zip(_running(shape, places, off, derivatives, single=single), values, strict=True)
            )
        ]
        # an error of a segment's ends is an error of its lift
        scale_size = np.abs(scales[:, 0].reshape(column))
        base_error = off_base / np.where(scale_size > 0.0, scale_size, 1.0)
        for order in range(derivatives + 1):
            scale = scales[:, order].reshape(column)
            centre = scale * values[order]
            centres[order, rows] = centre + base if order == 0 else centre
            size = off_base + np.where(base, U * np.abs(centres[0, rows]), 0.0) if order == 0 else 0.0
            rounding = roundings[order] + base_error * np.abs(values[order])
            radii[order, rows] = (np.abs(scale) * (wide[order] + rounding) + size) * UP
    return tuple(Disc(centre, wide) for centre, wide in zip(centres, radii, strict=True))


def _running(shape: "Any", t: "Any", off: "Any", derivatives: int, *, single: bool) -> "Any":
    """Running bounds at places (n,): a few are followed one by one, which takes floats a tenth of the time."""
    import numpy as np

    halves = HALVES_OF_FLOATS if single else HALVES
    if t.ndim > 1 or not 0 < t.size <= SCALARS:
        return running_slips(shape, t, off, derivatives, halves)
    pairs = zip(t.tolist(), off.tolist(), strict=True)
    return np.array([running_slips(shape, place, place_error, derivatives, halves) for place, place_error in pairs]).T


def _one_by_one(shape: "Any", t: "Any", derivatives: int) -> "Any":
    import numpy as np

    return np.array([shape(place, derivatives) for place in t.tolist()]).T
