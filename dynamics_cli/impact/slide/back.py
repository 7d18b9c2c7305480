"""The motion at the separation from the rest: three equations for three unknowns, from a grid of starts."""

from dynamics_cli.errors import require
from dynamics_cli.impact.slide.motion import TOLERANCE, Run, run
from dynamics_cli.impact.slide.wheels import Car, State
from dynamics_cli.numerics.elementary import atan2, cos, hypot, sin, sqrt
from dynamics_cli.quantities import Angle, Length
from dynamics_cli.sampling import drawing, kept

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.impact.slide.lanes import Lanes

    Array = NDArray[Any]

Triple = tuple[float, float, float]
# Rest positions are surveyed to centimetres; a motion found ends nearer than this to them, of a metre.
NEAR = 1e-8
ROUGH = 1e-6
# The grid of starts: courses beside the straight line, speeds between all wheels sliding and the car rolling all the
# way, spins beside that of a uniform slowing; and how many of them are followed, those that end nearest.
COURSES = (-0.9, -0.6, -0.35, -0.15, 0.0, 0.15, 0.35, 0.6, 0.9)
PACES = (0.0, 0.15, 0.3, 0.45, 0.6, 0.75, 0.9, 1.0)
SPINS = (0.0, 0.4, 0.7, 1.0, 1.4, 2.0, 3.0)
FOLLOWED = 8
# Digits of the grid and of the search, and steps of the grid: what needs more is no start.
ROUGHEST, COARSE, FEW_STEPS = 1e-3, 1e-4, 60
DIFFERENCE = 1e-4
MOST_ROUNDS, LAST_ROUNDS = 12, 10
# A search has ended where its step is this small beside the motion, or hopeless when this little of one is possible;
# none goes further than this share of the motion. After so many rounds, one motion found is enough.
SMALL, LEAST_SHARE, REACH, ENOUGH = 1e-2, 3e-3, 0.5, 4
# Motions as near to each other as this, beside their size, are one.
SAME = 0.03


class Target:
    """A place of rest and the nose there, from a place of separation and the nose there."""

    def __init__(
        self, begin: "tuple[float, float]", nose: float, rest: "tuple[float, float]", rest_nose: float
    ) -> None:
        self.begin, self.nose, self.rest, self.rest_nose = begin, nose, rest, rest_nose
        self.way = rest[0] - begin[0], rest[1] - begin[1]
        self.distance = hypot(*self.way)
        self.turn = rest_nose - nose

    def wanted(self, lanes: "Lanes") -> "Array":
        """The rest as lanes have it (3, 1)."""
        import numpy as np

        return np.array([[self.rest[0]], [self.rest[1]], lanes.gyration * self.rest_nose])


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


class Start:
    """Where the motions of samples start from: that of an earlier one, with its derivatives."""

    def __init__(self, target: Target, unknowns: "Array", slopes: "Array") -> None:
        self.target, self.unknowns, self.slopes = target, unknowns, slopes

    def apart(self, target: Target) -> float:
        """How different its rest is from another."""
        way, other = self.target.way, target.way
        return _length(way[0] - other[0], way[1] - other[1], self.target.turn - target.turn)


def roots(car: Car, target: Target) -> "list[Root]":
    """Every motion found that ends at the target, the one nearest to the straight line first; of samples one."""
    import numpy as np

    from dynamics_cli.impact.slide.lanes import Lanes

    scale = 1.0 + target.distance
    starts: list[Start] = kept().setdefault(Start, []) if drawing() else []
    if starts:
        # vehicles of one calculation have starts of their own
        near = min(starts, key=lambda one: one.apart(target))
        unknowns, gap, done = _settled(car, target, near.unknowns, near.slopes, scale)
        if _length(*gap) <= ROUGH * scale:
            return [Root(unknowns, car, done)]
    lanes = Lanes(car, target.begin, target.nose)
    at, left, slopes = search(lanes, target.wanted(lanes), _starts(lanes, target, _grid(car, target)))
    found: list[tuple[Root, Array]] = []
    misses: list[Triple] = []
    for index in np.argsort(left).tolist():
        if left[index] > SMALL and (found or misses):
            break
        start = at[:, index]
        if any(_same(start, one.unknowns) for one, _ in found):
            continue
        unknowns, gap, done = _settled(car, target, start, slopes[index], scale)
        if _length(*gap) > ROUGH * scale:
            misses.append(gap)
        elif not any(_same(np.array(unknowns), one.unknowns) for one, _ in found):
            found.append((Root(unknowns, car, done), slopes[index]))
    if not found:
        _refuse(min(misses, key=lambda miss: _length(*miss)), car)
    found.sort(key=lambda one: one[0].bend(target))
    starts.append(Start(target, np.array(found[0][0].unknowns), found[0][1]))
    return [one for one, _ in found]


def _same(one: "Array", other: Triple) -> bool:
    return _length(*(one - other).tolist()) < SAME * _length(*other)


def _refuse(nearest: Triple, car: Car) -> None:
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


def _grid(car: Car, target: Target) -> "Array":
    """Velocities and spins to start from (3, n)."""
    import numpy as np

    locked = max(sum(wheel.load * wheel.share for wheel in car.wheels), 0.02)
    grip = car.friction * car.gravity
    distance = max(target.distance, 1e-3)
    slow, fast = sqrt(2.0 * locked * grip * distance), sqrt(2.0 * grip * distance)
    course = atan2(target.way[1], target.way[0])
    listed = []
    for offset in COURSES:
        way = course + offset
        for pace in PACES:
            speed = slow ** (1.0 - pace) * fast**pace
            # a turn on the spot has its own deceleration
            time = max(min(2.0 * distance / speed, 4.0), sqrt(2.0 * abs(target.turn) * car.gyration / grip))
            spin = 2.0 * target.turn / time
            listed += [(speed * cos(way), speed * sin(way), turning * car.gyration * spin) for turning in SPINS]
    return np.array(listed).T


def _starts(lanes: "Lanes", target: Target, grid: "Array") -> "Array":
    """Those of a grid that end nearest to the target, apart from each other."""
    import numpy as np

    gaps = gaps_of(lanes, target.wanted(lanes), grid, ROUGHEST, 1, FEW_STEPS)
    gaps[:2] *= 3.0 / (1.0 + target.distance)
    order = np.argsort((gaps * gaps).sum(axis=0))
    chosen: list[int] = []
    for index in order.tolist():
        apart = np.abs(grid[:, chosen] - grid[:, [index]]).max(axis=0)
        if not chosen or float(apart.min()) > 0.1 * float(np.abs(grid[:, index]).max()):
            chosen.append(index)
        if len(chosen) == FOLLOWED:
            break
    return grid[:, chosen]


def gaps_of(
    lanes: "Lanes", wanted: "Array", unknowns: "Array", tolerance: float, group: int = 1, steps: int = 1000
) -> "Array":
    """Where motions end less where they should (3, n) or (3, 1): places, and gyration times the nose."""
    gaps = lanes.ends(unknowns, tolerance, group, steps)[:3]
    gaps[2] *= lanes.gyration
    gaps -= wanted
    return gaps


def sloped(lanes: "Lanes", wanted: "Array", unknowns: "Array", tolerance: float) -> "tuple[Array, Array]":
    """Gaps (3, n) of motions, and their derivatives (n, 3, 3)."""
    import numpy as np

    count = unknowns.shape[1]
    step = DIFFERENCE * (np.sqrt((unknowns * unknowns).sum(axis=0)) + 1e-3)
    moved = np.repeat(unknowns, 4, axis=1).reshape(3, count, 4)
    for index in range(3):
        moved[index, :, index + 1] += step
    fourfold = lanes.some(np.repeat(np.arange(count), 4))
    ends = gaps_of(fourfold, np.zeros((3, 1)), moved.reshape(3, -1), tolerance, 4).reshape(3, count, 4)
    slopes = (ends[:, :, 1:] - ends[:, :, :1]) / step[:, None]
    return ends[:, :, 0] - wanted, slopes.transpose(1, 0, 2)


def search(lanes: "Lanes", wanted: "Array", starts: "Array") -> "tuple[Array, Array, Array]":
    """Where damped Newton steps lead from each start: unknowns, the step that is left, and derivatives of the gaps.

    A step is good when what the same derivatives would step next is shorter (Deuflhard's natural test): of a car that
    rolls, motions that end almost alike form a narrow curved valley, along which the gap itself rises at first.
    """
    import numpy as np

    at = starts.copy()
    gaps, slopes = sloped(lanes, wanted, at, COARSE)
    steps, lengths = newton(slopes, gaps)
    shares = np.ones(at.shape[1])
    for round_ in range(MOST_ROUNDS):
        sizes = _sizes(at)
        found = lengths < SMALL * sizes
        open_ = np.flatnonzero(~found & (shares > LEAST_SHARE))
        if not open_.size or (round_ >= ENOUGH and found.any()):
            break
        reach = REACH * np.maximum(sizes[open_], 0.1) / lengths[open_]
        shares[open_] = np.minimum(shares[open_], reach)
        tried = at[:, open_] + shares[open_] * steps[:, open_]
        new, by = sloped(lanes, wanted, tried, COARSE)
        _, following = newton(slopes[open_], new)
        good = following <= (1.0 - 0.25 * shares[open_]) * lengths[open_]
        shares[open_] = np.where(good, np.minimum(4.0 * shares[open_], 1.0), 0.25 * shares[open_])
        moved = open_[good]
        at[:, moved], gaps[:, moved], slopes[moved] = tried[:, good], new[:, good], by[good]
        steps[:, moved], lengths[moved] = newton(by[good], new[:, good])
    left = lengths / _sizes(at)
    return at + np.where(left < SMALL, 1.0, 0.0) * steps, left, slopes


def followed(
    lanes: "Lanes", wanted: "Array", at: "Array", off_of: "Callable[[Array], Array]", close: float, tolerance: float
) -> "tuple[Array, Array, Array, Array]":
    """Solutions near starts, each for a rest of its own: motions, gaps left, derivatives, and how far off they end.

    Derivatives are kept as long as steps with them lessen the gap enough.
    """
    import numpy as np

    gaps, slopes = sloped(lanes, wanted, at, tolerance)
    off = off_of(gaps)
    shares = np.ones(off.size)
    for _ in range(MOST_ROUNDS):
        open_ = np.flatnonzero((off > close) & (shares > 0.05))
        if not open_.size:
            break
        steps, _ = newton(slopes[open_], gaps[:, open_])
        tried = at[:, open_] + shares[open_] * steps
        new = gaps_of(lanes.some(open_), wanted[:, open_], tried, tolerance)
        beyond = off_of(new)
        better = beyond < off[open_]
        slow = open_[~(beyond < 0.3 * off[open_])]
        shares[open_] = np.where(better, 1.0, 0.4 * shares[open_])
        moved = open_[better]
        at[:, moved], gaps[:, moved], off[moved] = tried[:, better], new[:, better], beyond[better]
        slow = slow[off[slow] > close]
        if slow.size:
            gaps[:, slow], slopes[slow] = sloped(lanes.some(slow), wanted[:, slow], at[:, slow], tolerance)
    return at, gaps, slopes, off


def _sizes(unknowns: "Array") -> "Array":
    import numpy as np

    sizes: Array = np.sqrt((unknowns * unknowns).sum(axis=0))
    return sizes


def newton(slopes: "Array", gaps: "Array") -> "tuple[Array, Array]":
    """Steps (3, n), and their lengths."""
    import numpy as np

    size = np.abs(slopes).max(axis=(1, 2), initial=1e-300)
    steps = -np.linalg.solve(slopes + (1e-12 * size)[:, None, None] * np.eye(3), gaps.T[:, :, None])[:, :, 0].T
    return steps, _sizes(steps)


def _gap(car: Car, target: Target, unknowns: "Array") -> "tuple[Triple, Run]":
    vx, vy, turning = unknowns.tolist()
    done = run(car, State(*target.begin, target.nose, vx, vy, turning / car.gyration), TOLERANCE)
    end = done.end
    return (end.x - target.rest[0], end.y - target.rest[1], car.gyration * (end.nose - target.rest_nose)), done


def _settled(car: Car, target: Target, at: "Array", slopes: "Array", scale: float) -> "tuple[Triple, Triple, Run]":
    """The last steps in full accuracy, with the derivatives of the search kept up to date by Broyden's rule."""
    import numpy as np

    gap, done = _gap(car, target, at)
    for _ in range(LAST_ROUNDS):
        size = _length(*gap)
        if size <= NEAR * scale:
            break
        step = -np.linalg.lstsq(slopes, np.array(gap), rcond=1e-9)[0]
        new, there = _gap(car, target, at + step)
        slopes = slopes + np.outer(np.array(new) - np.array(gap) - slopes @ step, step) / float(step @ step)
        slower = _length(*new) > 0.5 * size
        if _length(*new) < size:
            at, gap, done = at + step, new, there
        if slower and size <= ROUGH * scale:
            break
    return (float(at[0]), float(at[1]), float(at[2])), gap, done


def _length(x: float, y: float, z: float) -> float:
    return sqrt(x * x + y * y + z * z)
