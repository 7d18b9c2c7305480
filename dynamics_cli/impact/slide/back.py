"""The motion at the separation from the rest: three equations for three unknowns, from several starts."""

from dynamics_cli.errors import require
from dynamics_cli.impact.slide.motion import Run, run
from dynamics_cli.impact.slide.wheels import Car, State
from dynamics_cli.numerics.elementary import atan2, cos, hypot, sin, sqrt
from dynamics_cli.quantities import Angle, Length
from dynamics_cli.sampling import drawing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

Triple = tuple[float, float, float]
# Of a car that turns, tyres take about 2/π of what they do sliding along.
ACROSS = 0.6366197723675814
# Rest positions are surveyed to centimetres; a motion found ends nearer than this to them, of a metre.
NEAR = 1e-8
ROUGH = 1e-6
SAME = 1e-4
MOST_ROUNDS = 16
# Courses beside the straight line, in degrees, and spins and speeds beside those of a uniform slowing.
STARTS = ((0.0, 1.0, 1.0), (25.0, 1.0, 1.0), (-25.0, 1.0, 1.0), (0.0, 1.25, 0.6), (0.0, 0.85, 1.4))
# Tried where none of these leads there.
MORE_STARTS = tuple((offset, pace, turning) for offset in (-9.0, 9.0) for pace in (0.6, 1.6) for turning in (0.5, 2.0))
DEGREE = 0.017453292519943295
STEP = 1e-5
TIGHT, LOOSE = 1e-8, 1e-7


class Target:
    """A place of rest and the nose there, from a place of separation and the nose there."""

    def __init__(
        self, begin: "tuple[float, float]", nose: float, rest: "tuple[float, float]", rest_nose: float
    ) -> None:
        self.begin, self.nose, self.rest, self.rest_nose = begin, nose, rest, rest_nose
        self.way = rest[0] - begin[0], rest[1] - begin[1]
        self.distance = hypot(*self.way)
        self.turn = rest_nose - nose


class Root:
    """A motion at the separation, velocity and spin, with the run from it."""

    def __init__(self, unknowns: Triple, car: Car, done: Run) -> None:
        self.unknowns = unknowns
        self.velocity = unknowns[0], unknowns[1]
        self.spin = unknowns[2] / car.gyration
        self.run = done

    def bend(self, target: Target) -> float:
        """Angle between its course and the straight line to rest."""
        (x, y), (a, b) = self.velocity, target.way
        return abs(atan2(x * b - y * a, x * a + y * b))


def roots(car: Car, target: Target) -> "list[Root]":
    """Every motion found that ends at the target, the one nearest to the straight line first.

    Of samples the first start that leads there is enough.
    """
    scale = 1.0 + target.distance
    found: list[Root] = []
    misses: list[Triple] = []
    for index, start in enumerate(_starts(car, target)):
        if found and index >= len(STARTS):
            break
        unknowns, gap, done = _newton(car, target, start, LOOSE, ROUGH * scale)
        if _length(*gap) > ROUGH * scale:
            misses.append(gap)
            continue
        if drawing():
            return [Root(unknowns, car, done)]
        if any(_length(*(a - b for a, b in zip(unknowns, one.unknowns, strict=True))) < SAME * scale for one in found):
            continue
        unknowns, gap, done = _newton(car, target, unknowns, TIGHT, NEAR * scale)
        found.append(Root(unknowns, car, done))
    if not found:
        nearest = min(misses, key=lambda miss: _length(*miss))
        require(
            False,
            "no slide of these wheels ends there: the nearest that was found ends {gap:3} from the rest position, its "
            "nose turned {angle:3} too far",
            code="unreachable",
            hint="check the heading at rest with its whole turns and its sense, the wheels that were locked, and the "
            "friction",
            gap=(hypot(nearest[0], nearest[1]), Length),
            angle=(nearest[2] / car.gyration, Angle),
        )
    return sorted(found, key=lambda one: one.bend(target))


def _starts(car: Car, target: Target) -> "list[Triple]":
    """Velocities and spins to start from: friction along the straight line, and the turn within that time."""
    locked = sum(wheel.load * wheel.share for wheel in car.wheels)
    share = locked + (1.0 - locked) * (ACROSS if abs(target.turn) > 0.3 else 0.3 * abs(target.turn))
    slowing = max(share, 0.02) * car.friction * car.gravity
    distance = max(target.distance, 1e-3)
    # a turn on the spot has its own deceleration
    speed = sqrt(2.0 * slowing * distance)
    time = max(2.0 * distance / speed, sqrt(2.0 * abs(target.turn) * car.gyration / slowing))
    spin = 2.0 * target.turn / time
    course = atan2(target.way[1], target.way[0])
    listed = []
    for offset, pace, turning in (*STARTS, *MORE_STARTS):
        way = course + offset * DEGREE
        listed.append((pace * speed * cos(way), pace * speed * sin(way), turning * car.gyration * spin))
    return listed


def _gap(car: Car, target: Target, unknowns: Triple, tolerance: float) -> "tuple[Triple, Run]":
    vx, vy, turning = unknowns
    done = run(car, State(*target.begin, target.nose, vx, vy, turning / car.gyration), tolerance)
    end = done.end
    turning = car.gyration * (end.nose - target.rest_nose)
    return (end.x - target.rest[0], end.y - target.rest[1], turning), done


def _newton(car: Car, target: Target, start: Triple, tolerance: float, wanted: float) -> "tuple[Triple, Triple, Run]":
    """Newton's method with halved steps, its derivatives by differences, kept up to date by Broyden's rule."""
    import numpy as np

    at = np.array(start)
    gap, done = _gap(car, target, start, tolerance)
    matrix: Any = None
    fresh = False
    for _ in range(MOST_ROUNDS):
        size = _length(*gap)
        if size <= wanted:
            break
        if matrix is None:
            matrix, fresh = _slopes(car, target, at, gap, tolerance), True
        try:
            step = -np.linalg.solve(matrix, np.array(gap))
        except np.linalg.LinAlgError:
            break
        reach = 0.5 * max(float(np.linalg.norm(at)), 0.1)
        length = float(np.linalg.norm(step))
        step = step * min(1.0, reach / length)
        for _ in range(6):
            tried = at + step
            new, its_run = _gap(car, target, (float(tried[0]), float(tried[1]), float(tried[2])), tolerance)
            if _length(*new) < (1.0 - 1e-4) * size:
                break
            step = 0.5 * step
        else:
            if fresh:
                break
            matrix = None
            continue
        moved = np.array(new) - np.array(gap) - matrix @ step
        fast = _length(*new) < 0.3 * size
        matrix = matrix + np.outer(moved, step) / float(step @ step) if fast else None
        fresh = False
        at, gap, done = tried, new, its_run
    return (float(at[0]), float(at[1]), float(at[2])), gap, done


def _slopes(car: Car, target: Target, at: "Any", gap: Triple, tolerance: float) -> "Any":
    """Derivatives of the gap by differences."""
    import numpy as np

    size = max(float(np.linalg.norm(at)), 1e-3)
    columns = []
    for index in range(3):
        moved = at.copy()
        moved[index] += max(STEP, 30.0 * tolerance) * size
        step = float(moved[index] - at[index])
        there, _ = _gap(car, target, (float(moved[0]), float(moved[1]), float(moved[2])), tolerance)
        columns.append([(a - b) / step for a, b in zip(there, gap, strict=True)])
    return np.array(columns).T


def _length(x: float, y: float, z: float) -> float:
    return sqrt(x * x + y * y + z * z)
