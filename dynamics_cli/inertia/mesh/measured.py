"""A mesh read, proved closed and integrated, in the unit of its file."""

import os

from dynamics_cli.errors import require
from dynamics_cli.inertia.principal import principal

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.inertia.mesh.integrals import Moments
    from dynamics_cli.inertia.mesh.stl import Source
    from dynamics_cli.inertia.mesh.surface import Faults

# A body this much thinner one way than another is integrated once more in its principal axes; small files always are,
# as it costs them nothing that can be felt.
GRADED = 1e-4
SMALL = 100_000
# Up to this many triangles whole numbers take at most half as long again as two passes do.
FEW = 128


class Measured:
    """A mesh read, proved and integrated, in the unit of its file."""

    def __init__(self, source: "Source", *, shell: bool, diagnosed: bool = False) -> None:
        from dynamics_cli.inertia.mesh.integrals import first_pass, second_pass
        from dynamics_cli.inertia.mesh.whole import WholeMoments

        self.form = source.form
        self.single = source.single
        self.moments: Moments | WholeMoments
        self.sums, first = first_pass(source, shell=shell, prove=True)
        self.moments = first
        self.way = "once"
        self.faults: Faults | None = None
        if diagnosed:
            from dynamics_cli.inertia.mesh.diagnosis import diagnose

            self.faults = diagnose(source)
        if self.sums.count <= FEW:
            self.moments = WholeMoments(source, shell=shell)
            self.way = "whole"
        elif first.measure:
            found = principal(rows(first.second if first.measure > 0.0 else -first.second))
            if self.sums.count <= SMALL or found.seconds[2] < GRADED * found.seconds[0]:
                self.moments = second_pass(source, self.sums, first, array(found.axes))
                self.way = "again"

    @property
    def closed(self) -> bool:
        """Whether every edge is met by one the other way."""
        return self.sums.boundary is not None and self.sums.boundary.empty


# The last file integrated: the trials of an uncertain density do not read it again.
_LAST: "dict[tuple[Any, ...], Measured]" = {}


def measured(name: str, *, shell: bool, diagnosed: bool = False) -> Measured:
    """Integrate over a file, unless it was the last one and has not changed."""
    state = os.stat(name)
    key = (name, state.st_mtime_ns, state.st_size, shell, diagnosed)
    if key not in _LAST:
        from dynamics_cli.inertia.mesh.opening import open_mesh

        made = Measured(open_mesh(name), shell=shell, diagnosed=diagnosed)
        _LAST.clear()
        _LAST[key] = made
    return _LAST[key]


def require_closed(found: Measured, *, allowed: bool, part: str = "") -> None:
    """Refuse surfaces that enclose nothing definite, or enclose it from the wrong side; `part` says of which part."""
    places = ""
    if found.faults is not None:
        kept = found.faults
        places = (
            f": {kept.open_edges} open edges, {kept.clashing_edges} clashing edges, {kept.flipped} flipped, "
            f"{kept.duplicated} duplicated and {kept.degenerate} degenerate triangles"
            + "".join("; " + place for place in kept.places)
        )
    require(
        found.closed or allowed,
        "the surface {2}of {0} triangles is not closed: not every edge is met by one the other way{1}",
        found.sums.count,
        places,
        f"of {part}, " if part else "",
        code="open",
        hint="mend the surface; dynamics inertia mesh FILE --diagnose names the faulty edges"
        if part
        else "mend the surface, or give --allow-open"
        if found.faults is not None
        else "--diagnose names the faulty edges; --allow-open answers all the same",
    )
    require(
        found.moments.measure >= 0.0 or not found.closed,
        "the surface {1}is inside out: it encloses {0:.6g} cubed units of length",
        found.moments.measure,
        f"of {part} " if part else "",
        code="inverted",
        hint="turn all triangles round (swap two corners of each)",
    )


def rows(matrix: "Any") -> "Any":
    """A matrix as rows of floats."""
    return tuple(tuple(row) for row in matrix.tolist())


def array(rows: "Any") -> "Any":
    """Rows of floats as a matrix."""
    import numpy as np

    return np.array(rows)
