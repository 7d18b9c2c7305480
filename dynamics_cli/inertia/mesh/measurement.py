"""A mesh read, proved closed and integrated, in the unit of its file."""

import os

from dynamics_cli.errors import UsageError, require
from dynamics_cli.inertia.bodies.principal import principal
from dynamics_cli.inertia.mesh.surface import LengthUnit
from dynamics_cli.quantities import Ratio

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.inertia.mesh.integrals import Moments
    from dynamics_cli.inertia.mesh.stl import Source
    from dynamics_cli.inertia.mesh.surface import Faults

# A body this much thinner in one direction than another is integrated again in its principal axes; small files always
# are, as the cost is imperceptible.
GRADED = 1e-4
SMALL = 100_000
# Up to this many triangles whole numbers take at most half as long again as two passes do.
FEW = 128
# A diagnosis of so many triangles, of which so many pairs are near each other, takes up to 0.3 s on a laptop core and
# is always made.
DIAGNOSED, DIAGNOSED_PAIRS = 20_000, 1_500_000


class Measured:
    """A mesh read, proved and integrated, in the unit of its file."""

    def __init__(self, source: "Source", *, shell: bool, diagnosed: bool = False) -> None:
        from dynamics_cli.inertia.mesh.exact_integrals import WholeMoments
        from dynamics_cli.inertia.mesh.passes import first_pass, second_pass

        self.form = source.form
        self.unit = source.unit
        self.single = source.single
        self.moments: Moments | WholeMoments
        self.sums, first = first_pass(source, shell=shell, prove=True)
        self.caution = source.caution
        self.moments = first
        self.way = "once"
        self.faults: Faults | None = None
        if diagnosed or self.sums.count <= DIAGNOSED:
            from dynamics_cli.inertia.mesh.faults.diagnosis import diagnose

            self.faults = diagnose(source, closed=self.closed, most=None if diagnosed else DIAGNOSED_PAIRS)
        if self.sums.count <= FEW:
            self.moments = WholeMoments(source, shell=shell)
            self.way = "whole"
        elif first.measure:
            axes = principal(rows(first.second if first.measure > 0.0 else -first.second))
            if self.sums.count <= SMALL or axes.seconds[2] < GRADED * axes.seconds[0]:
                self.moments = second_pass(source, self.sums, first, array(axes.axes))
                self.way = "again"

    @property
    def known(self) -> bool:
        """Whether the volume exceeds the possible effect of rounding its corners to doubles."""
        import numpy as np

        sums = self.sums
        spacings = np.spacing(np.maximum(abs(sums.low), abs(sums.high)))
        projected = np.sqrt(sums.count * sums.squares)
        return bool(abs(self.moments.measure) > 0.5 * float(projected @ spacings))

    @property
    def closed(self) -> bool:
        """Whether every edge is met by one the other way."""
        return bool(self.sums.closed)


# Cache of the last files: trials of an uncertain density do not read them again.
KEPT = 16
_LAST: "dict[tuple[Any, ...], Measured]" = {}


def measured(name: str, *, shell: bool, diagnosed: bool = False) -> Measured:
    """Integrate over a file, unless it was the last one and has not changed."""
    state = os.stat(name)
    key = (name, state.st_mtime_ns, state.st_size, shell, diagnosed)
    if key not in _LAST:
        from dynamics_cli.inertia.mesh.opening import open_mesh

        mesh = Measured(open_mesh(name), shell=shell, diagnosed=diagnosed)
        if len(_LAST) >= KEPT:
            _LAST.clear()
        _LAST[key] = mesh
    return _LAST[key]


def unit_of(source: "Measured | Source", stated_unit: "LengthUnit | None", part: str = "") -> "LengthUnit":
    """The unit of a file's numbers: as stated in the file, else as given."""
    of_part = f" of {part}" if part else ""
    if not source.unit:
        if stated_unit is None:
            raise UsageError(
                f"length_unit is missing: the file{of_part} does not say its unit of length",
                code="missing",
                parameter=None if part else "length_unit",
                hint='length_unit = "mm", for example' if part else "for example --length-unit mm",
            )
        return stated_unit
    require(
        stated_unit is None or stated_unit == source.unit,
        "the file{of_part} says that its lengths are in {unit}, and {given} was given",
        code="unit",
        hint="leave out the length unit",
        unit=source.unit,
        given=stated_unit,
        of_part=of_part,
    )
    return LengthUnit(source.unit)


def require_closed(mesh: Measured, *, allowed: bool, flip: bool = False, part: str = "") -> None:
    """Refuse surfaces that enclose nothing definite, or enclose it from the wrong side; `part` names the part."""
    places = ""
    if mesh.faults is not None:
        faults = mesh.faults
        places = (
            f": {faults.open_edges} open edges, {faults.clashing_edges} clashing edges, {faults.flipped} flipped, "
            f"{faults.duplicated} duplicated and {faults.degenerate} degenerate triangles"
            + "".join("; " + place for place in faults.places)
        )
    require(
        mesh.closed or allowed,
        "the surface {of_part}of {triangles} triangles is not closed: an edge has no neighbour{places}",
        code="open",
        hint="repair the surface; dynamics inertia mesh FILE --diagnose names the faulty edges"
        if part
        else "repair the surface, or give --allow-open"
        if mesh.faults is not None
        else "--diagnose names the faulty edges; --allow-open calculates nevertheless",
        triangles=mesh.sums.count,
        places=places,
        of_part=f"of {part}, " if part else "",
    )
    inverted = mesh.moments.measure < 0.0 and mesh.closed
    require(
        flip or not inverted,
        "the surface {of_part}is inside out: it encloses {volume:6} cubed units of length",
        code="inverted",
        hint="turn the triangles round in the file" if part else "--flip turns all triangles round",
        volume=(mesh.moments.measure, Ratio),
        of_part=f"of {part} " if part else "",
    )
    require(
        inverted or not flip,
        "the surface is not inside out: --flip is not needed",
        code="inverted",
        hint="leave out --flip",
    )


def require_extent(mesh: Measured, *, shell: bool, part: str = "") -> None:
    """Refuse triangles without area, and surfaces whose volume is within the rounding of their corners."""
    of_part = f" of {part}" if part else ""
    require(
        mesh.moments.measure != 0.0 and (shell or mesh.known),
        "the triangles{of_part} {lack}",
        code="no-volume",
        hint="check the file; a shell needs --thickness or an areal density",
        of_part=of_part,
        lack="have no area" if shell else "enclose no volume beyond the rounding of their corners",
    )


def rows(matrix: "Any") -> "Any":
    """A matrix as rows of floats."""
    return tuple(tuple(row) for row in matrix.tolist())


def array(rows: "Any") -> "Any":
    """Rows of floats as a matrix."""
    import numpy as np

    return np.array(rows)
