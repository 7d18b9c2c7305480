"""Further ways beside those of `alternatives/cam/export`."""

from dynamics_cli.accuracy.alternatives.cam.export import _shares, measured

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.cam.export.path import Path

    # number of pieces, deviation as measured, deviation as proved
    Made = tuple[int, float, "float | None"]


def hermite(path: "Path", count: int) -> "Made":
    """Cubics of points and derivatives (Hermite's) at equal steps of cam angle."""
    import numpy as np

    worst, total = 0.0, 0
    for piece, places in _shares(path, count, still=True):
        on = path.on(piece)
        speed = np.abs(on.at(places)[4])
        handles = np.stack((speed[:-1], speed[1:]), axis=1) * (np.diff(places) / 3.0)[:, None]
        worst = max(worst, measured(on, "cubics", places, handles))
        total += places.size - 1
    return total, worst, None
