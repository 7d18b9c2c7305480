"""Rounding bounds of a mesh: carried through its closed forms, or measured in many digits."""

import math

from dynamics_cli.gear.rounding import bare, error_of, in_digits, measured, share, width
from dynamics_cli.numerics.elementary import sqrt
from dynamics_cli.numerics.tracked import UNIT_ROUNDOFF
from dynamics_cli.records import ErrorBound, Numerics

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Any

    from dynamics_cli.gear.mesh.profile_contact import Path

# Results with relative bounds; the others are differences, with bounds as lengths.
SHARES = ("centre_distance", "working_pressure_angle", "contact_ratio", "nominal_contact_ratio")
# Effect of the place of a minimum distance, in half units in the last place of the module.
PLACED = 1e-2
# For up to this many points shown the bounds are measured one by one.
MEASURED = 64
COLUMNS = ("along", "first_diameter", "second_diameter")


def mesh_numerics(known: "Any", exact: "Any", turning: float, columns: "dict[str, Any]", shares: "Any") -> Numerics:
    """The bounds of a mesh's numbers; of points at `shares` (whole numbers of a whole) of the path as columns.

    `known` carries bounds, `exact` is the same in many digits, or None; `turning` is the maximum angular error.
    """
    results = known.results.items()
    bounds = [share(name, value) if name in SHARES else width(name, value) for name, value in results]
    placed = PLACED * UNIT_ROUNDOFF * bare(known.first.module)
    gaps = {"first_in_second": known.inward, "second_in_first": known.outward}
    bounds += [width(name, gap, placed) for name, gap in gaps.items() if gap is not None]
    along: tuple[float, ...] = _column_bounds(known, bare(known.path))
    steps, picks = shares
    if exact is not None and len(picks) <= MEASURED:
        rows = in_digits(lambda: [tuple(_row(exact, pick, steps)) for pick in picks])
        along = tuple(
            max(measured(float(value), row[place], most) for value, row in zip(columns[name], rows, strict=True))
            for place, (name, most) in enumerate(zip(COLUMNS, along, strict=True))
        )
    bounds += [ErrorBound(f"path.{name}", bound, relative=False) for name, bound in zip(COLUMNS, along, strict=True)]
    # involutes of one base pitch turn uniformly at any distance: the computed deviation is all rounding
    bounds += [ErrorBound(name, turning, relative=False) for name in ("transmission_error", "path.error")]
    return Numerics("closed forms that carry rounding bounds; profiles turned point by point", tuple(bounds))


def _column_bounds(known: "Any", plain: "Path") -> tuple[float, float, float]:
    """Bounds of places and both diameters: points are equally spaced from the start of contact to its end."""
    path, first, second = known.path, known.first, known.second
    ends = max(error_of(path.start), error_of(path.end)) + 4.0 * UNIT_ROUNDOFF * max(abs(plain.start), abs(plain.end))
    longest = plain.total + plain.end if second.internal else plain.total - plain.start
    other = ends + error_of(path.total) + UNIT_ROUNDOFF * longest
    pitch_point = error_of(known.pitch_point) + UNIT_ROUNDOFF * max(plain.end, bare(known.pitch_point))
    return (
        ends + pitch_point,
        _diameter_bound(first.base, plain.end, ends),
        _diameter_bound(second.base, longest, other),
    )


def _diameter_bound(base: float, length: float, error: float) -> float:
    """Of 2·√(r_b² + l²), by the largest l, of which it grows by 2 l/d."""
    radius = math.hypot(bare(base), length)
    return 2.0 * (error_of(base) + error * abs(length) / radius + 1.5 * UNIT_ROUNDOFF * radius)


def _row(exact: "Any", pick: int, steps: int) -> "Iterator[Any]":
    """Place and diameters of a point of contact, in many digits."""
    path = exact.path
    first_length = path.start + (path.end - path.start) * pick / steps
    second_length = first_length + path.total if exact.second.internal else path.total - first_length
    yield first_length - exact.pitch_point
    for base, length in ((exact.first.base, first_length), (exact.second.base, second_length)):
        yield 2.0 * sqrt(base * base + length * length)
