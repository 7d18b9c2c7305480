"""Exports of a cam: how many lines or cubics keep a tolerance, their deviation as measured and as proved.

Deviations are measured at points of the exact curve between those that the fits see.
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

    # For each smooth piece of the curve, which it is, where its pieces end, and their bulges or handles.
    Pieces = list[tuple[int, Any, Any]]

# The deviation of so many pieces at equal angles tells how many are needed; more than these are not tried.
FIRST, MOST = 2000, 400_000
# Ten thousand pieces take their time to make and to measure.
FEW = 2
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

    curves = []
    for name, program, kind, sizes, difficult in CAMS:
        if difficult or not hard:
            geometry = Geometry(getattr(followers, kind)(*sizes))
            path = Path(geometry, motion_of(Program(), program), away=0.0)
            x, y = path.at(np.linspace(0.0, 6.28, 720))[:2]
            curves.append((name, path, float(np.hypot(x, y).max())))
    return curves


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


def alike(form: str, path: "Path", tolerance: float) -> "Pieces":
    """The program's own: as few pieces as keep the tolerance, all erring alike."""
    from dynamics_cli.numerics.fitting.pieces import fit

    return list(fit(path, form, FIT * tolerance))


def proof(form: str, path: "Path", pieces: "Pieces", tolerance: float) -> float:
    """The deviation that the program proves of its pieces as they are written."""
    import numpy as np

    from dynamics_cli.numerics.fitting.deviation import proved
    from dynamics_cli.numerics.fitting.pieces import controls

    bounds = []
    for piece, places, shape in pieces:
        on = path.on(piece)
        points, written = np.stack(on.at(places)[:2], axis=1), shape
        if form == "cubics":
            written = np.stack([inner[:, 1:3] for inner in controls(on, places, shape)], axis=2)
        bounds.append(float(proved(path, piece, places, written, form, points, tolerance).max()))
    return max(bounds)


def equal_angles(_: str, path: "Path", tolerance: float) -> "Pieces":
    """Lines between points at equal steps of cam angle, as a table of points is cut."""
    import numpy as np

    width = path.ends - path.starts

    def lines(count: int) -> "Pieces":
        steps = [max(1, round(count * share)) for share in width / width.sum()]
        places = [np.linspace(path.starts[k], path.ends[k], step + 1) for k, step in enumerate(steps)]
        return [(k, ends, np.zeros(ends.size - 1)) for k, ends in enumerate(places)]

    count = FIRST
    for _try in range(4):
        pieces = lines(count)
        off = deviation("lines", path, pieces) / tolerance
        if 0.9 < off <= 1.0:
            return pieces
        # the height of an arc over its chord goes with the square of its length
        count = int(np.ceil(count * (off / 0.97) ** 0.5))
        if count > MOST:
            raise ArithmeticError
    return lines(count)


def deviation(form: str, path: "Path", pieces: "Pieces") -> float:
    """The largest distance of points of the exact curve from their pieces."""
    return max(measured(path.on(piece), form, places, shape) for piece, places, shape in pieces)


METHODS = (
    ("cubics that err alike (chosen)", ("cubics", alike)),
    ("lines at equal angles", ("lines", equal_angles)),
)


def compare(comparing: "Comparing") -> "list[Row]":
    """Pieces for a deviation of a micrometre; of a nanometre for two cams only, unless there are minutes."""
    tolerance, cams = 1e-6, paths(hard=comparing.hard)
    if comparing.name.endswith("nm"):
        tolerance, cams = 1e-9, cams if comparing.full else cams[:FEW]

    def answer(errors: "Errors", case: "Any", method: "Any", _: int) -> "Callable[[], Pieces]":
        (cam, path, _size), (form, function) = case, method
        pieces = function(form, path, tolerance)
        count = sum(places.size - 1 for _, places, _ in pieces)
        bound = proof(form, path, pieces, tolerance) / tolerance if function is alike else None
        errors.note(f"{cam}, {count} pieces", deviation(form, path, pieces) / tolerance, bound)
        errors.entities = (errors.entities or 0) + count
        return lambda: function(form, path, tolerance)

    repeats = 3 if comparing.full else 1
    return comparing.rows(METHODS, cams, answer, repeats=repeats, measure="shares of the tolerance", bound="proof")
