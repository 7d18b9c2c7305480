"""Integrals in the unit of a file turned into tracked numbers in SI."""

from math import inf

from dynamics_cli.errors import require
from dynamics_cli.inertia.bodies.mass_moments import each
from dynamics_cli.inertia.bodies.principal import principal
from dynamics_cli.inertia.bodies.principal_tracked import Spread
from dynamics_cli.inertia.mesh.measurement import rows
from dynamics_cli.numerics.eigen3.jacobi import eigen
from dynamics_cli.numerics.eigen3.residual import UNIT_ROUNDOFF, residual_bounds, tilt_bounds
from dynamics_cli.numerics.tracked import Tracked
from dynamics_cli.quantities import Ratio

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.inertia.mesh.measurement import Measured
    from dynamics_cli.inertia.mesh.surface import LengthUnit

# Second moments below this would leave the range of a double on their way to SI.
SMALLEST = 1e-270


class Lift:
    """A mesh's integrals in SI, each with its bound and no slopes."""

    def __init__(self, mesh: "Measured", unit: "LengthUnit", width: int) -> None:
        self.mesh = mesh
        self.moments = mesh.moments
        self.slopes = (0.0,) * width
        self.ratio = unit.ratio

    def number(self, value: float, error: float, power: int) -> float:
        """A number in the file's unit to some power, as a tracked number in metres to that power."""
        up, down = self.ratio
        tracked = Tracked(float(value), float(error), self.slopes)
        for _ in range(abs(power)):
            up, down = up * self.ratio[0], down * self.ratio[1]
        lifted: float = _or_unknown(tracked * (up / self.ratio[0]) / (down / self.ratio[1]))
        return lifted

    def in_file_unit(self, length: "float | None") -> float:
        """A length in the unit of the file; none is zero."""
        up, down = self.ratio
        return float(getattr(length, "value", length) or 0.0) * down / up

    def measure(self) -> float:
        """Volume or area."""
        moments = self.moments
        return self.number(abs(moments.measure), moments.measure_error, 2 if moments.shell else 3)

    def point(self, values: "Any", errors: "Any") -> "tuple[float, float, float]":
        """A point."""
        return tuple(self.number(value, error, 1) for value, error in zip(values, errors, strict=True))  # type: ignore[return-value]

    def centroid(self) -> "tuple[float, float, float]":
        """The mass centre."""
        return self.point(self.moments.centroid, self.moments.centroid_error)

    def second(self, density: float) -> "Any":
        """Second moments in the axes of the file."""
        return self._matrix(*self.moments.in_file(), density)

    def _matrix(self, matrix: "Any", error: "Any", density: float) -> "Any":
        sign = 1.0 if self.moments.measure > 0.0 else -1.0
        power = 4 if self.moments.shell else 5
        cell = {
            (i, j): _or_unknown(density * self.number(sign * matrix[i][j], error[i][j], power))
            for i in range(3)
            for j in range(i + 1)
        }
        return tuple(tuple(cell[max(i, j), min(i, j)] for j in range(3)) for i in range(3))

    def spread(self, density: float) -> Spread:
        """Principal second moments, with the bounds of the axes in which they were integrated."""
        moments = self.moments
        sign = 1.0 if moments.measure > 0.0 else -1.0
        matrix = rows(sign * moments.second)
        frame = None if moments.frame is None else rows(moments.frame)
        raw, errors = eigen(matrix), rows(moments.second_error)
        own_errors = residual_bounds(matrix, raw.values, raw.vectors, errors)
        off = [error + moments.spread_error(value) for value, error in zip(raw.values, own_errors, strict=True)]
        axes = principal(matrix, (off[0], off[1], off[2]), frame)
        require(
            raw.values[2] >= -off[2],
            "a second moment is negative: the surface crosses itself, and parts of it are inside out",
            code="crossing",
            hint="repair the surface; far from the origin single precision alone can do this",
        )
        require(
            raw.values[0] > SMALLEST,
            "the second moments are below the range of a double: the part is {size:3} of its unit of length in size",
            code="range",
            hint="check the unit of the file; give its numbers in a smaller unit",
            size=(float((self.mesh.sums.high - self.mesh.sums.low).max()), Ratio),
        )
        power = 4 if moments.shell else 5
        seconds = []
        for value, own_value, error in zip(axes.seconds, raw.values, off, strict=True):
            own_error = error + max(-own_value, 0.0)
            seconds.append(_or_unknown(density * self.number(max(value, 0.0), own_error, power)))
        more = [moments.spread_error(matrix[k][k]) for k in range(3)]
        errors = tuple(tuple(errors[i][j] + more[i] + more[j] for j in range(3)) for i in range(3))
        # seen in the axes of the file, every component is rounded
        tilts = each(lambda tilt: tilt + 4.0 * UNIT_ROUNDOFF, tilt_bounds(matrix, axes.vectors, errors))
        return Spread(tuple(seconds), axes.axes, axes.degeneracy, tilts)


def _or_unknown(number: "Any") -> "Any":
    """A tracked number; an error without bound, which products make no number of, stays one."""
    return number if number.error < inf else Tracked(number.value, inf, number.slopes)
