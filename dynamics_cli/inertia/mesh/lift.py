"""Integrals in the unit of a file turned into tracked numbers in SI."""

from dynamics_cli.errors import require
from dynamics_cli.inertia.mesh.measured import rows
from dynamics_cli.inertia.principal import principal
from dynamics_cli.inertia.spread import Spread
from dynamics_cli.numerics.symmetric import eigen
from dynamics_cli.numerics.tracked import UNIT_ROUNDOFF, Tracked

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.inertia.mesh.integrals import Moments
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
        return tracked * (up / self.ratio[0]) / (down / self.ratio[1])  # type: ignore[return-value]

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
        """The mass centre, with the rounding of the sum that it is."""
        own = self.moments
        centroid, error = own.centroid, own.centre_error
        if own.frame is not None:
            error = abs(own.frame.T) @ (error + 4.0 * UNIT_ROUNDOFF * abs(own.centre))
        return self.point(centroid, error + UNIT_ROUNDOFF * abs(centroid))

    def second(self, density: float) -> "Any":
        """Second moments in the axes of the file."""
        import numpy as np

        from dynamics_cli.inertia.mesh.frame import departure

        own = self.moments
        matrix, error = own.second, own.second_error
        if own.frame is not None:
            turn, size = abs(own.frame.T), abs(matrix)
            # axes that are not quite across one another do not turn back by their transpose
            apart = abs(departure(own.frame))
            # what weights are off by is told as well by how far the body reaches along the axes of the file
            error = np.minimum(turn @ error @ turn.T, own.terms * np.outer(own.box, own.box))
            error = error + turn @ (8.0 * UNIT_ROUNDOFF * size + apart @ size + size @ apart) @ turn.T
            error = error + UNIT_ROUNDOFF**2 * size.sum()
            matrix = own.frame.T @ matrix @ own.frame
        return self._matrix(matrix, error, density)

    def _matrix(self, matrix: "Any", error: "Any", density: float) -> "Any":
        sign = 1.0 if self.moments.measure > 0.0 else -1.0
        power = 4 if self.moments.shell else 5
        cell = {
            (i, j): density * self.number(sign * matrix[i][j], error[i][j], power)
            for i in range(3)
            for j in range(i + 1)
        }
        return tuple(tuple(cell[max(i, j), min(i, j)] for j in range(3)) for i in range(3))

    def spread(self, density: float) -> Spread:
        """Principal second moments; their bounds are those of the axes they were integrated in."""
        own = self.moments
        sign = 1.0 if own.measure > 0.0 else -1.0
        matrix = rows(sign * own.second)
        errors = own.second_error
        frame = None if own.frame is None else rows(own.frame)
        blur = float(errors.sum(axis=1).max())
        found, raw = principal(matrix, 0.0, frame), eigen(matrix)
        off = [(blur if own.frame is None else _weyl(own, k)) + raw.bounds[k] for k in range(3)]
        require(
            raw.values[2] >= -off[2],
            "second moments come out negative: the surface crosses itself, and parts of it are inside out",
            code="crossing",
            hint="mend the surface; far from the origin single precision alone can do this",
        )
        power = 4 if own.shell else 5
        seconds = []
        for value, own_value, error in zip(found.seconds, raw.values, off, strict=True):
            seconds.append(density * self.number(max(value, 0.0), error + max(-own_value, 0.0), power))
        return Spread(tuple(seconds), found.axes, found.degeneracy)  # type: ignore[arg-type]


def _weyl(own: "Moments", k: int) -> float:
    """How far the k-th second moment may be off: errors of its own row, independent of one another."""
    import numpy as np

    scale = np.sqrt(np.abs(np.diag(own.second)))
    i = np.argsort(-scale)[k]
    shares = np.array([min(1.0, float(scale[i] / scale[j])) if scale[j] else 1.0 for j in range(3)])
    return float(np.hypot.reduce(own.second_error[i] * shares)) + 2.0 * UNIT_ROUNDOFF * float(scale[i] * scale[i])
