"""What an undercut costs: where the cutter takes away what the follower needs, and the lift that is lost there."""

from math import inf

import numpy as np

from dynamics_cli.cam.contact import Geometry
from dynamics_cli.cam.followers import FlatFace, OscillatingFlat
from dynamics_cli.cam.pieces import over_pieces, pieces, sample, turning_places, within
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

TURN = 2.0 * np.pi
COARSE = 1440
GOLDEN = 0.6180339887498949


@record
class Loss:
    """What an undercut costs.

    Parameters
    ----------
    lift : float
        Greatest lift lost [m, or rad for an arm].
    at : float
        Cam angle there [rad].
    stretches : tuple of pairs
        Cam angles between which the envelope runs backwards.
    exact : bool
        Whether the loss is at a corner found exactly; else it is from samples.
    """

    lift: float
    at: float
    stretches: tuple[tuple[float, float], ...]
    exact: bool


def backward_stretches(geometry: Geometry, motion: "Any") -> "tuple[tuple[float, float], ...]":
    """Where the envelope runs backwards: certified, from every turning place of its speed.

    Parameters
    ----------
    geometry : Geometry
        The follower in place.
    motion : Motion
        The program.

    Returns
    -------
    tuple of pairs
        Cam angles; a stretch may end beyond a full turn.
    """

    def speed(s: "Any", s1: "Any", s2: "Any") -> "Any":
        return geometry.touch(s, s1, s2).run[None]

    made = over_pieces(motion, speed)
    if turning_places(motion, made).smallest()[0] > 0.0:
        return ()
    found = turning_places(motion, made, every=True)
    starts, ends = pieces(motion)
    stretches: list[list[float]] = []
    for index in range(found.places.size):
        if found.values[index] > 0.0:
            continue
        piece = int(found.owner[index])
        own = np.flatnonzero(found.owner == piece)
        place = found.places[index]
        low = _edge(geometry, motion, piece, place, found, own[own <= index][::-1], starts, ends)
        high = _edge(geometry, motion, piece, place, found, own[own >= index], starts, ends)
        if stretches and low <= stretches[-1][1] + 1e-12:
            stretches[-1][1] = max(stretches[-1][1], high)
        elif high > low:
            stretches.append([low, high])
    if len(stretches) > 1 and stretches[0][0] + TURN <= stretches[-1][1] + 1e-12:
        stretches[-1][1] = stretches.pop(0)[1] + TURN
    return tuple((low, high) for low, high in stretches)


def _edge(
    geometry: Geometry, motion: "Any", piece: int, place: float, found: "Any", others: "Any", starts: "Any", ends: "Any"
) -> float:
    """Where the speed passes zero between a backward place and the next forward one; the end of the piece if none."""
    ahead = [k for k in others if found.values[k] > 0.0]
    if not ahead:
        return float(found.places[others[-1]])
    bad, good = place, float(found.places[ahead[0]])
    start, width = starts[piece], ends[piece] - starts[piece]
    bad, good = (bad - start) / width, (good - start) / width
    for _ in range(60):
        middle = 0.5 * (bad + good)
        s, s1, s2 = within(motion, np.array([[middle]]), np.array([piece]))
        if geometry.touch(s, s1, s2).run[0, 0] > 0.0:
            good = middle
        else:
            bad = middle
    return float(start + width * bad)


def _curve(geometry: Geometry, motion: "Any", theta: "Any") -> "tuple[Any, Any, Any, Any]":
    """Points of the cam's curve and their velocities."""
    s, s1, s2 = sample(motion, theta, 2)
    touch = geometry.touch(s, s1, s2)
    x, y = geometry.turned(touch.point, theta)
    nx, ny = geometry.turned(touch.normal, theta)
    speed = geometry.turn * touch.run
    return x, y, speed * ny, -speed * nx


def _corner(geometry: Geometry, motion: "Any", low: float, high: float) -> "tuple[float, float] | None":
    """The two cam angles at which the curve passes through the corner that is left: Newton from the swallowtail."""
    middle, half = 0.5 * (low + high), 0.5 * (high - low)
    for reach in (1.7320508075688772, 1.3, 2.2, 3.0, 4.5):
        pair = np.array([middle - reach * half, middle + reach * half])
        for _ in range(40):
            x, y, dx, dy = _curve(geometry, motion, pair)
            ex, ey = x[1] - x[0], y[1] - y[0]
            # x0 + dx0 a = x1 + dx1 b
            cross = dx[0] * dy[1] - dy[0] * dx[1]
            if cross == 0.0:
                break
            a, b = (ex * dy[1] - ey * dx[1]) / cross, (ex * dy[0] - ey * dx[0]) / cross
            most = 0.5 * half
            step = np.clip(np.array([a, b]), -most, most)
            pair = pair + step
            if np.max(np.abs(step)) <= 4e-16 * max(1.0, abs(middle)):
                break
        x, y, _, _ = _curve(geometry, motion, pair)
        size = float(np.max(np.abs(x) + np.abs(y)))
        if (
            pair[0] < low
            and pair[1] > high
            and np.hypot(x[1] - x[0], y[1] - y[0]) <= 1e-13 * size
            and pair[1] - pair[0] < TURN
        ):
            return float(pair[0]), float(pair[1])
    return None


def seat(geometry: Geometry, theta: "Any", x: "Any", y: "Any") -> "Any":
    """The lift at which the follower rests on a point of the cam, the second of a pair its negative.

    Parameters
    ----------
    geometry : Geometry
        The follower in place.
    theta : array
        Cam angles.
    x, y : array
        Points in the cam's frame, broadcast against `theta`.

    Returns
    -------
    array
        Lifts [m or rad].
    """
    f, start, roller = geometry.follower, geometry.start, geometry.roller
    cos, sin = np.cos(theta), geometry.turn * np.sin(theta)
    px, py = x * cos - y * sin, x * sin + y * cos
    with np.errstate(invalid="ignore"):
        if isinstance(f, FlatFace):
            return py - start
        if isinstance(f, OscillatingFlat):
            far = np.hypot(px - f.pivot_distance, py)
            return np.arctan2(py, f.pivot_distance - px) + np.arcsin(f.face_offset / far) - start
        if not geometry.oscillating:
            away = px - f.offset  # type: ignore[union-attr]
            rise = np.sqrt((roller - away) * (roller + away))
            found = py + rise - start if geometry.way > 0.0 else start - (py - rise)
        else:
            far = np.hypot(px - f.pivot_distance, py)  # type: ignore[union-attr]
            beta = np.arctan2(py, f.pivot_distance - px)  # type: ignore[union-attr]
            arm = f.arm  # type: ignore[union-attr]
            cosine = (arm * arm + far * far - roller * roller) / (2.0 * arm * far)
            opening = np.arccos(cosine)
            found = beta + opening - start if geometry.way > 0.0 else start - (beta - opening)
    return np.where(np.isnan(found), -np.inf, found)


def lift_lost(geometry: Geometry, motion: "Any") -> "Loss | None":
    """The greatest lift that an undercut costs, or None where there is no undercut.

    The cut cam is what no position of the follower has taken away. Put back on it, the follower rests on the corner
    where the curve cuts itself (or on what is left of the curve), lower than the program has it.

    Parameters
    ----------
    geometry : Geometry
        The follower in place, on the inner flank.
    motion : Motion
        The program.

    Returns
    -------
    Loss | None
        The lift lost.

    Notes
    -----
    Corners are found to rounding by Newton's method, whatever their size. Where undercuts run into each other so that
    no corner of one of them is left, the loss comes from 1440 points of what is left, high by up to their spacing.
    """
    stretches = backward_stretches(geometry, motion)
    if not stretches:
        return None
    corners = [_corner(geometry, motion, low, high) for low, high in stretches]
    best = (0.0, stretches[0][0])
    if None not in corners:
        for pair in corners:
            best = max(best, _at_corner(geometry, motion, *pair))  # type: ignore[misc]
        if _survive(geometry, motion, [pair for pair in corners if pair is not None]):
            return Loss(best[0], best[1] % TURN, stretches, True)
    lift, place = _sampled(geometry, motion)
    return Loss(lift, place % TURN, stretches, False)


def _at_corner(geometry: Geometry, motion: "Any", low: float, high: float) -> tuple[float, float]:
    x, y, _, _ = _curve(geometry, motion, np.array([low, high]))
    px, py = 0.5 * (x[0] + x[1]), 0.5 * (y[0] + y[1])

    def lost(theta: "Any") -> "Any":
        level = geometry.way * sample(motion, theta, 0)[0]
        return level - seat(geometry, theta, px, py)

    theta = np.linspace(low, high, 513)
    values = lost(theta)
    index = int(np.argmax(values))
    a, b = theta[max(index - 1, 0)], theta[min(index + 1, 512)]
    for _ in range(48):
        p, q = b - GOLDEN * (b - a), a + GOLDEN * (b - a)
        at = lost(np.array([p, q]))
        a, b = (a, q) if at[0] > at[1] else (p, b)
    place = 0.5 * (a + b)
    return max(float(lost(np.array([place]))[0]), float(values[index]), 0.0), place


def _survive(geometry: Geometry, motion: "Any", corners: "list[tuple[float, float]]") -> bool:
    """Whether every corner is really left: no position of the follower elsewhere takes it away."""
    theta = np.linspace(0.0, TURN, COARSE, endpoint=False)
    level = geometry.way * sample(motion, theta, 0)[0]
    for low, high in corners:
        x, y, _, _ = _curve(geometry, motion, np.array([low, high]))
        over = seat(geometry, theta, x[0], y[0]) - level
        outside = ((theta - low) % TURN) > (high - low)
        if bool((over[outside] > 1e-9 * (np.abs(x).max() + np.abs(y).max())).any()):
            return False
    return True


def _sampled(geometry: Geometry, motion: "Any") -> tuple[float, float]:
    """The loss from points of the curve that no position takes away."""
    theta = np.linspace(0.0, TURN, COARSE, endpoint=False)
    x, y, _, _ = _curve(geometry, motion, theta)
    level = geometry.way * sample(motion, theta, 0)[0]
    over = seat(geometry, theta[:, None], x[None, :], y[None, :]) - level[:, None]
    tiny = 1e-9 * (np.abs(x).max() + np.abs(y).max())
    left = over.max(axis=0) <= tiny
    if not left.any():
        return inf, 0.0
    lost = -over[:, left].max(axis=1)
    index = int(np.argmax(lost))
    return max(float(lost[index]), 0.0), float(theta[index])
