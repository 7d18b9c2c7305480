"""What is said of a mesh beside its mass properties: checks, advice, the surface."""

from math import sqrt

from dynamics_cli.inertia.mesh.surface import Surface
from dynamics_cli.numerics.tracked import UNIT_ROUNDOFF
from dynamics_cli.records import Advice, Check

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.inertia.mesh.integrals import Sums
    from dynamics_cli.inertia.mesh.lift import Lift
    from dynamics_cli.inertia.mesh.measured import Measured

# Single precision this coarse against the mean edge is worth a warning.
COARSE = 1e-3
# A wall of this share of the part's middle dimension is no longer thin: its own inertia is about that much squared.
THICK = 0.05


def checks_of(found: "Measured", shell: bool) -> tuple[Check, ...]:
    """The proof that a solid is closed; an open one that was allowed is warned of instead."""
    if shell or not found.closed:
        return ()
    return (Check("every directed edge is met by one the other way", found.closed),)


def _closure(sums: "Sums") -> float:
    """The length of the closure vector over the area."""
    x, y, z = (float(part) for part in sums.closure)
    return (x * x + y * y + z * z) ** 0.5 / sums.area if sums.area else 0.0


def quanta(sums: "Sums") -> "Any":
    """Spacing of single precision at the greatest coordinate along each axis."""
    import numpy as np

    return np.spacing(np.maximum(abs(sums.low), abs(sums.high)).astype(np.float32)).astype(float)


def _quantisation(found: "Measured") -> "float | None":
    """Standard deviation of the volume when every corner was rounded to single precision, in the file's unit.

    With A_v the area vector around a corner, Σ_v (A_v q)²/12 is twice that sum over triangles, as corners are shared.
    """
    if not found.single or found.moments.shell:
        return None
    q = quanta(found.sums)
    return sqrt(float(found.sums.squares @ (q * q)) / 6.0)


def advice_of(found: "Measured", *, shell: bool, wall: float = 0.0) -> tuple[Advice, ...]:
    """Warnings of open surfaces, of coarse coordinates, and of walls (in the file's unit) too thick to be thin."""
    out = []
    middle = sorted((found.sums.high - found.sums.low).tolist())[1]
    if wall > THICK * middle:
        out.append(
            Advice(
                "thick-wall",
                f"the wall is {wall / middle:.3g} of the part's middle dimension: a shell takes it for thin",
                "caution" if wall < 5.0 * THICK * middle else "serious",
                "model the wall as a solid with an inner surface",
            )
        )
    sums = found.sums
    if not shell and not found.closed:
        out.append(
            Advice(
                "open-surface",
                f"the surface is open: its closure vector is {_closure(sums):.3g} of its area, which indicates how "
                "much is missing but bounds nothing; other reference points give other answers",
                "serious",
                "mend the surface; --diagnose names the faulty edges",
            )
        )
    if found.faults is not None and found.faults.duplicated:
        out.append(
            Advice(
                "duplicated",
                f"{found.faults.duplicated} triangles have the corners of an earlier one: what is given twice the same "
                "way round counts twice",
                "serious",
                "remove the copies",
            )
        )
    edge = (sums.area / sums.count * 2.3094) ** 0.5
    if found.single and edge > 0.0:
        coarse = float(max(quanta(sums))) / edge
        if coarse > COARSE:
            out.append(
                Advice(
                    "coarse-coordinates",
                    f"so far from the origin single precision is {coarse:.2g} of the mean edge: shape is lost",
                    "serious" if coarse > 0.1 else "caution",
                    "export the part nearer its origin",
                )
            )
    return tuple(out)


def surface_of(found: "Measured", lift: "Lift") -> Surface:
    """The surface as it is reported."""
    sums = found.sums
    quantisation = _quantisation(found)
    zero = (0.0, 0.0, 0.0)
    return Surface(
        form=found.form,
        triangles=sums.count,
        area=lift.number(sums.area, 8.0 * UNIT_ROUNDOFF * sums.area, 2),
        closed="yes" if found.closed else "no",
        closure=_closure(sums),
        low=lift.point(sums.low, zero),
        high=lift.point(sums.high, zero),
        quantisation=None if quantisation is None else lift.number(quantisation, quantisation, 3).value,  # type: ignore[attr-defined]
        faults=found.faults,
    )
