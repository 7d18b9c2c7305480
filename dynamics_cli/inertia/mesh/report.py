"""Report of a mesh besides its mass properties: checks, advice, the surface."""

from math import sqrt

from dynamics_cli.inertia.mesh.surface import Surface
from dynamics_cli.numerics.tracked import UNIT_ROUNDOFF
from dynamics_cli.records import Advice, Check

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.inertia.mesh.integrals import Sums
    from dynamics_cli.inertia.mesh.measurement import Measured
    from dynamics_cli.inertia.mesh.tracked_integrals import Lift

# Single precision this coarse against the mean edge is worth a warning.
COARSE = 1e-3
# A volume that single precision leaves uncertain by this share is worth a warning.
BLURRED = 0.1
# A wall thicker than this share of the part's middle dimension is not thin: its own inertia is about its square.
THICK = 0.05


def checks_of(mesh: "Measured", shell: bool) -> tuple[Check, ...]:
    """The proof that a solid is closed; an open one that was allowed is warned of instead."""
    if shell or not mesh.closed:
        return ()
    return (Check("every directed edge has one in the opposite direction", mesh.closed),)


def _closure(sums: "Sums") -> float:
    """The length of the closure vector over the area."""
    x, y, z = (float(part) for part in sums.closure)
    return (x * x + y * y + z * z) ** 0.5 / sums.area if sums.area else 0.0


def quanta(sums: "Sums") -> "Any":
    """Spacing of single precision at the greatest coordinate along each axis."""
    import numpy as np

    return np.spacing(np.maximum(abs(sums.low), abs(sums.high)).astype(np.float32)).astype(float)


def _quantisation(mesh: "Measured") -> "float | None":
    """Standard deviation of the volume when every corner was rounded to single precision, in the file's unit.

    With A_v the area vector around a corner, Σ_v (A_v q)²/12 is twice that sum over triangles, as corners are shared.
    """
    if not mesh.single or mesh.moments.shell:
        return None
    q = quanta(mesh.sums)
    return sqrt(float(mesh.sums.squares @ (q * q)) / 6.0)


def advice_of(mesh: "Measured", *, shell: bool, wall: float = 0.0) -> tuple[Advice, ...]:
    """Warnings of open surfaces, of coarse coordinates, and of walls (in the file's unit) too thick to be thin."""
    out = []
    middle = sorted((mesh.sums.high - mesh.sums.low).tolist())[1]
    if wall > THICK * middle:
        message = f"the wall is {wall / middle:.3g} of the part's middle dimension, but is computed as a thin shell"
        remedy = "model the wall as a solid with an inner surface"
        out.append(Advice("thick-wall", message, "caution" if wall < 5.0 * THICK * middle else "serious", remedy))
    sums = mesh.sums
    if not shell and not mesh.closed:
        text = (
            f"the surface is open: its closure vector is {_closure(sums):.3g} of its area, an indication of how "
            "much is missing; other reference points give other answers"
        )
        out.append(Advice("open-surface", text, "serious", "repair the surface; --diagnose names the faulty edges"))
    if mesh.caution:
        out.append(
            Advice("cut-off", mesh.caution, "caution", "compare the number of triangles with that of the source")
        )
    out += fault_advice(mesh, shell=shell)
    quantisation = _quantisation(mesh)
    if quantisation is not None and quantisation > BLURRED * abs(mesh.moments.measure):
        out.append(
            Advice(
                "blurred-volume",
                f"rounding the corners to single precision alone makes volumes of {quantisation:.2g} cubed units of "
                f"length, and this one is {abs(mesh.moments.measure):.2g}",
                "serious",
                "export the part with more digits, or nearer its origin",
            )
        )
    return (*out, *_coarse_advice(mesh))


def _coarse_advice(mesh: "Measured") -> "list[Advice]":
    """A warning where the resolution of single precision is coarse relative to the mean edge."""
    edge = (mesh.sums.area / mesh.sums.count * 2.3094) ** 0.5
    coarse = float(max(quanta(mesh.sums))) / edge if mesh.single and edge > 0.0 else 0.0
    if coarse <= COARSE:
        return []
    message = f"so far from the origin single precision steps by {coarse:.2g} of the mean edge: the shape is lost"
    remedy = "export the part nearer its origin"
    return [Advice("coarse-coordinates", message, "serious" if coarse > 0.1 else "caution", remedy)]


def fault_advice(mesh: "Measured", *, shell: bool) -> "list[Advice]":
    """Serious warnings about faults that a diagnosis shows and closure does not."""
    faults = mesh.faults
    if faults is None:
        few = f"{mesh.sums.count} triangles were not checked for crossings and overlaps"
        return [] if shell else [Advice("not-examined", few, "note", "--diagnose checks them")]
    counts = [
        (
            "duplicated",
            faults.repeated,
            "triangles are given twice in the same orientation: their volume counts twice",
            "remove the copies",
        )
    ]
    if not shell:
        counts += [
            (
                "crossing",
                faults.crossing,
                "triangles are crossed by edges of others: where the surface overlaps itself, volume counts twice or "
                "negative",
                "unite the parts into one surface",
            ),
            (
                "overlap",
                faults.within,
                "triangles lie inside the volume of others, which counts twice",
                "unite overlapping solids; turn an inner shell so that it faces inwards",
            ),
            (
                "against",
                faults.against,
                "triangles bound the solid from the wrong side: the volume they enclose counts negative",
                "turn the shell so that it faces outwards",
            ),
        ]
    return [Advice(code, f"{count} {words}", "serious", remedy) for code, count, words, remedy in counts if count]


def surface_of(mesh: "Measured", lift: "Lift") -> Surface:
    """The report of the surface."""
    sums = mesh.sums
    quantisation = _quantisation(mesh)
    zero = (0.0, 0.0, 0.0)
    return Surface(
        form=mesh.form,
        triangles=sums.count,
        area=lift.number(sums.area, 8.0 * UNIT_ROUNDOFF * sums.area, 2),
        closed="yes" if mesh.closed else "no",
        closure=_closure(sums),
        low=lift.point(sums.low, zero),
        high=lift.point(sums.high, zero),
        examined="all triangles were checked for crossings and overlaps"
        if mesh.faults is not None
        else f"only closure is checked: crossings and overlaps of {sums.count} triangles need --diagnose",
        quantisation=None if quantisation is None else lift.number(quantisation, quantisation, 3).value,  # type: ignore[attr-defined]
        faults=mesh.faults,
    )
