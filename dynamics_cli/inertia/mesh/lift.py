"""Integrals in the unit of a file turned into tracked numbers in SI."""

from math import inf

from dynamics_cli.errors import require
from dynamics_cli.inertia.mesh.measured import rows
from dynamics_cli.inertia.principal import principal
from dynamics_cli.inertia.spread import Spread
from dynamics_cli.numerics.residual import residual_bounds
from dynamics_cli.numerics.symmetric import eigen
from dynamics_cli.numerics.tracked import Tracked

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.inertia.mesh.measured import Measured
    from dynamics_cli.inertia.mesh.surface import LengthUnit


class Lift:
    """A mesh's integrals in SI, each with its bound and no slopes."""

    def __init__(self, found: "Measured", unit: "LengthUnit", width: int) -> None:
        self.found = found
        self.moments = found.moments
        self.slopes = (0.0,) * width
        self.ratio = unit.ratio

    def number(self, value: float, error: float, power: int) -> float:
        """A number in the file's unit to some power, as a tracked number in metres to that power."""
        up, down = self.ratio
        tracked = Tracked(float(value), float(error), self.slopes)
        for _ in range(abs(power)):
            up, down = up * self.ratio[0], down * self.ratio[1]
        made: float = _or_unknown(tracked * (up / self.ratio[0]) / (down / self.ratio[1]))
        return made

    def in_file_unit(self, length: "float | None") -> float:
        """A length in the unit of the file; none is zero."""
        up, down = self.ratio
        return float(getattr(length, "value", length) or 0.0) * down / up

    def measure(self) -> float:
        """Volume or area."""
        own = self.moments
        return self.number(abs(own.measure), own.measure_error, 2 if own.shell else 3)

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
        """Principal second moments; their bounds are those of the axes they were integrated in."""
        own = self.moments
        sign = 1.0 if own.measure > 0.0 else -1.0
        matrix = rows(sign * own.second)
        frame = None if own.frame is None else rows(own.frame)
        found, raw = principal(matrix, 0.0, frame), eigen(matrix)
        own_errors = residual_bounds(matrix, raw.values, raw.vectors, rows(own.second_error))
        off = [error + own.spread_error(value) for value, error in zip(raw.values, own_errors, strict=True)]
        require(
            raw.values[2] >= -off[2],
            "second moments come out negative: the surface crosses itself, and parts of it are inside out",
            code="crossing",
            hint="mend the surface; far from the origin single precision alone can do this",
        )
        power = 4 if own.shell else 5
        seconds = []
        for value, own_value, error in zip(found.seconds, raw.values, off, strict=True):
            own_error = error + max(-own_value, 0.0)
            seconds.append(_or_unknown(density * self.number(max(value, 0.0), own_error, power)))
        return Spread(tuple(seconds), found.axes, found.degeneracy)


def _or_unknown(number: "Any") -> "Any":
    """A tracked number; an error without bound, which products make no number of, stays one."""
    return number if number.error < inf else Tracked(number.value, inf, number.slopes)
