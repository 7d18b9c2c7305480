"""Exports of a cam: deviation for as many pieces, of the program's arcs and cubics and of simpler ways to place them.

Deviations are measured at points of the exact curve between those that the fits see; what is stated is the proof.
"""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from dynamics_cli.accuracy.comparing import Comparing
    from dynamics_cli.accuracy.measure import Errors
    from dynamics_cli.accuracy.rows import Row
    from dynamics_cli.cam.export.path import Path
    from dynamics_cli.numerics.fitting.path import OnPiece

    # number of pieces, deviation as measured, deviation as proved
    Made = tuple[int, float, "float | None"]

TOLERANCE = 1e-6
FIT = 0.96
BETWEEN = 53
DWELLS = "rise 10 mm in 90 deg modified-sine; dwell 90 deg; return in 90 deg cycloidal; dwell"
LONG = "rise 8 mm in 120 deg 4-5-6-7; dwell 40 deg; return in 120 deg 3-4-5; dwell"
SWING = "rise 15 deg in 120 deg 3-4-5; dwell 60 deg; return in 120 deg 3-4-5; dwell"
STEEP = "rise 12 mm in 50 deg 5-6-7-8-9; dwell 100 deg; return in 60 deg cycloidal; dwell"
TINY = "rise 0.01 mm in 1 deg cycloidal; dwell 100 deg; return in 200 deg harmonic; dwell"
CAMS: "tuple[tuple[str, str, str, tuple[float, ...], bool], ...]" = (
    ("roller", DWELLS, "Roller", (0.025, 0.006), False),
    ("flat face", LONG, "FlatFace", (0.04,), False),
    ("arm", SWING, "OscillatingRoller", (0.03, 0.008, 0.08, 0.1), False),
    ("steep rise on an offset roller", STEEP, "Roller", (0.04, 0.005, 0.01), True),
    ("a hundredth of a millimetre in a degree", TINY, "Roller", (0.03, 0.004), True),
)


def paths(*, hard: bool) -> "list[tuple[str, Path, float]]":
    """The cams' curves and their sizes."""
    import numpy as np

    from dynamics_cli.cam.export.path import Path
    from dynamics_cli.cam.geometry import followers
    from dynamics_cli.cam.geometry.contact import Geometry
    from dynamics_cli.cam.program.reading import Program, motion_of

    found = []
    for name, program, kind, sizes, difficult in CAMS:
        if difficult or not hard:
            geometry = Geometry(getattr(followers, kind)(*sizes))
            path = Path(geometry, motion_of(Program(), program), away=0.0)
            x, y = path.at(np.linspace(0.0, 6.28, 720))[:2]
            found.append((name, path, float(np.hypot(x, y).max())))
    return found


def measured(path: "OnPiece", form: str, places: "Any", shape: "Any") -> float:
    """The largest distance of points of the exact curve from their pieces."""
    import numpy as np

    from dynamics_cli.numerics.fitting.pieces import circle_distance, controls, foot

    between = (np.arange(BETWEEN) + 0.5) / BETWEEN
    theta = places[:-1, None] + np.diff(places)[:, None] * between
    px, py = path.at(theta)[:2]
    if form == "cubics":
        cx, cy = controls(path, places, shape)
        start = np.broadcast_to(between, px.shape)
        return float(foot(cx[:, :, None], cy[:, :, None], px, py, start, rounds=8)[1].max())
    x, y = path.at(places)[:2]
    ends = (x[:-1, None], y[:-1, None], x[1:, None], y[1:, None])
    return float(np.abs(circle_distance(*ends, shape[:, None], px, py)[0]).max())


def own(form: str) -> "Callable[[Path, int], Made]":
    """The program's own: as few pieces as keep the tolerance, all erring alike, and the proof of it."""

    def made(path: "Path", _: int) -> "Made":
        import numpy as np

        from dynamics_cli.numerics.fitting.deviation import proved
        from dynamics_cli.numerics.fitting.pieces import controls, fit

        count, worst, bound = 0, 0.0, 0.0
        for piece, places, shape in fit(path, form, FIT * TOLERANCE):
            on = path.on(piece)
            points = np.stack(on.at(places)[:2], axis=1)
            written = shape
            if form == "cubics":
                written = np.stack([inner[:, 1:3] for inner in controls(on, places, shape)], axis=2)
            bound = max(bound, float(proved(path, piece, places, written, form, points, TOLERANCE).max()))
            worst = max(worst, measured(on, form, places, shape))
            count += places.size - 1
        return count, worst, bound

    return made


def _shares(path: "Path", count: int, *, still: bool) -> "list[tuple[int, Any]]":
    """Equal steps of cam angle on the pieces of the motion, so many in all; dwells only where they need them."""
    import numpy as np

    width = path.ends - path.starts
    moving = [index for index in range(width.size) if still or not path.still[index]]
    whole = float(width[moving].sum())
    return [
        (index, np.linspace(path.starts[index], path.ends[index], max(1, round(count * width[index] / whole)) + 1))
        for index in moving
    ]


def equal_lines(path: "Path", count: int) -> "Made":
    """Lines between points of the curve at equal steps of cam angle."""
    import numpy as np

    worst, total = 0.0, 0
    for piece, places in _shares(path, count, still=True):
        worst = max(worst, measured(path.on(piece), "lines", places, np.zeros(places.size - 1)))
        total += places.size - 1
    return total, worst, None


def equal_arcs(path: "Path", count: int) -> "Made":
    """Pairs of arcs at equal steps of cam angle, tangent to the curve; dwells are arcs anyway."""
    import numpy as np

    from dynamics_cli.numerics.fitting.pieces import _pairs

    worst, total = 0.0, int(path.still.sum())
    for piece, places in _shares(path, (count - total) // 2, still=False):
        on = path.on(piece)
        (middle, bulges), _ = _pairs(on, places)
        both = np.empty(2 * places.size - 1)
        both[::2], both[1::2] = places, middle
        worst = max(worst, measured(on, "arcs", both, bulges.reshape(-1)))
        total += both.size - 1
    return total, worst, None


ARCS: "tuple[tuple[str, Callable[[Path, int], Made]], ...]" = (
    ("arcs that err alike (chosen)", own("arcs")),
    ("arcs at equal angles", equal_arcs),
    ("lines at equal angles", equal_lines),
)
CUBICS: "tuple[tuple[str, Callable[[Path, int], Made]], ...]" = (
    ("cubics that err alike (chosen)", own("cubics")),
    ("arcs at equal angles", equal_arcs),
    ("lines at equal angles", equal_lines),
)


def compare_arcs(comparing: "Comparing") -> "list[Row]":
    """Arcs and what takes as many pieces; deviations in shares of the cam's largest radius."""
    return _compared(comparing, ARCS)


def compare_cubics(comparing: "Comparing") -> "list[Row]":
    """Cubics and what takes as many pieces."""
    return _compared(comparing, CUBICS)


def _compared(comparing: "Comparing", methods: "tuple[tuple[str, Callable[[Path, int], Made]], ...]") -> "list[Row]":
    counts: dict[str, int] = {}

    def answer(errors: "Errors", case: "Any", function: "Callable[[Path, int], Made]", _: int) -> "Callable[[], Made]":
        cam, path, size = case
        count, worst, bound = function(path, counts.get(cam, 0))
        counts.setdefault(cam, count)
        errors.note(f"{cam}, {count} pieces", worst / size, None if bound is None else bound / size)
        return lambda: function(path, counts[cam])

    return comparing.rows(methods, paths(hard=comparing.hard), answer, repeats=3, bound="proof")
