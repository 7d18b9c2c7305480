"""Straight slip of an impact in space: where friction is a constant share of the normal impulse.

Slip is straight once it keeps its direction: from rest along the one exit direction, and where friction holds the
contact. Everything is then linear in the normal impulse, and the end of compression and of the impact are roots in
closed form. All of it takes doubles and decimals.
"""

from dynamics_cli.errors import require
from dynamics_cli.impact.spatial.arithmetic import fused, root
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    Vector = tuple[float, float, float]
    Matrix = tuple[Vector, Vector, Vector]
    Pair = tuple[float, float]

# Digits of a double.
DOUBLE = 16
# u_t, u_n, p_n, p_t, normal work, heat of friction
X, Y, V, P, FX, FY, W, H = range(8)


class Slip:
    """The state while the contact slips, and the end of compression."""

    __slots__ = ("compression", "restoring", "state", "steps", "stopped", "work")

    def __init__(self, state: "list[float]") -> None:
        self.state = state
        self.steps = 0
        self.stopped = False
        self.compression: float | None = None
        self.work = type(state[V])(0)
        self.restoring = False

    def compressed(self) -> None:
        """Note the end of compression."""
        self.compression = self.state[P]
        self.work = -self.state[W]
        self.restoring = True


def _difference(a: float, b: float, c: float, d: float) -> float:
    """a·b − c·d to about one rounding, however much cancels (Kahan)."""
    product = c * d
    return fused(a, b, -product) - fused(c, d, -product)


def stick_ratio(k: "Matrix") -> "tuple[float, float]":
    """Friction per normal impulse that keeps the contact from slipping, −K_tt⁻¹ k_tn."""
    (k11, k12, k13), (_, k22, k23), _ = k
    det = _difference(k11, k22, k12, k12)
    return _difference(k12, k23, k22, k13) / det, _difference(k12, k13, k11, k23) / det


def way_out(k: "Matrix", friction: float) -> "tuple[float, float]":
    """Direction in which slip starts from rest if friction cannot hold: −μ K_tt ŝ + k_tn = g ŝ with g > 0.

    (g + μ K_tt) ŝ = k_tn with |ŝ| = 1: the size of ŝ = (g + μ K_tt)⁻¹ k_tn falls with g, and 1/|ŝ| is concave, nearly
    a line (Moré and Sorensen, 1983): Newton's method on it rises to the one such g from below.
    """
    (k11, k12, k13), (_, k22, k23), _ = k
    if friction == 0:
        size = root(k13 * k13 + k23 * k23)
        return (k13 / size, k23 / size) if size > 0 else (1 + k13, k23)
    a, b, d, growth = friction * k11, friction * k12, friction * k22, type(k13)(0)
    for _ in range(400):
        along, across = growth + a, growth + d
        det = _difference(along, across, b, b)
        x, y = _difference(across, k13, b, k23) / det, _difference(along, k23, b, k13) / det
        square = x * x + y * y
        # ŝ·(g + μ K_tt)⁻¹ ŝ
        slope = (across * x * x - 2 * b * x * y + along * y * y) / det
        higher = growth + (root(square) - 1) * square / slope
        if not higher > growth:
            break
        growth = higher
    size = root(square)
    return x / size, y / size


def settled(k: "Matrix", friction: float, slip: Slip, digits: int = DOUBLE) -> "Pair | None":
    """The direction that the slip has settled to within the digits, and to which neighbouring directions turn.

    With ŝ the direction and r = k_tn − μ K_tt ŝ it turns at n̂·r/|u_t|, whose slope in the angle is −ŝ·r − μ n̂·K_tt
    n̂.
    """
    (k11, k12, k13), (_, k22, k23), _ = k
    x, y = slip.state[X], slip.state[Y]
    if y == 0 and k12 == 0 and k23 == 0:
        # nothing acts across it
        return x / abs(x), y
    size = root(x * x + y * y)
    c, d = x / size, y / size
    a, b = k13 - friction * (k11 * c + k12 * d), k23 - friction * (k12 * c + k22 * d)
    slope = -(a * c + b * d) - friction * (k11 * d * d - 2 * k12 * c * d + k22 * c * c)
    if not slope < 0:
        return None
    across = a * d - b * c
    rounding = abs(k13) + abs(k23) + friction * (k11 + k22)
    # its turning is below rounding, and the direction is near
    number = type(size)
    if (
        abs(across) > number(f"2e-{digits if digits == DOUBLE else digits + 1}") * rounding
        or abs(across) > number(f"1e-{digits // 2 + 1}") * -slope
    ):
        return None
    aside = across / slope
    return c - aside * d, d + aside * c


def restitution_of(slip: Slip, speed: float, slope: float, approach: float, restitution: float, law: str) -> "Pair":
    """Impulse still to come in restitution, infinite where it never ends so, and the normal velocity at its end.

    A contact that jams while it slips may press the bodies together again: then `slope` or `speed` is negative.
    """
    inf = type(slope)("inf")
    if law == "newton":
        after = -restitution * approach
        return ((after - speed) / slope, after) if slope > 0 else (inf, after)
    if law == "poisson":
        rest = (1 + restitution) * slip.compression - slip.state[P]  # type: ignore[operator]
        return rest, speed + slope * rest
    work_left = max(restitution * restitution * slip.work - (slip.state[W] + slip.work), type(slope)(0))
    square = speed * speed + 2 * slope * work_left
    if square < 0:
        return inf, type(slope)(0)
    after = root(square)
    if speed < 0:
        return ((after - speed) / slope, after) if slope > 0 else (inf, after)
    return (2 * work_left / (speed + after) if after > 0 else type(slope)(0)), after


def rates_along(k: "Matrix", way: "Pair", friction: float) -> "tuple[Pair, float, float]":
    """Friction, growth of the slip and of the normal velocity per normal impulse, while slip keeps a direction."""
    (k11, k12, k13), (_, k22, k23), (_, _, k33) = k
    ratio = -friction * way[0], -friction * way[1]
    growth = way[0] * (k13 + k11 * ratio[0] + k12 * ratio[1]) + way[1] * (k23 + k12 * ratio[0] + k22 * ratio[1])
    return ratio, growth, k33 + k13 * ratio[0] + k23 * ratio[1]


def glide(k: "Matrix", slip: Slip, way: "Pair", friction: float, approach: float, restitution: float, law: str) -> bool:
    """Slip along one direction until it stops or the law ends it; returns whether the impact has ended."""
    state = slip.state
    speed = state[X] * way[0] + state[Y] * way[1]
    ratio, growth, slope = rates_along(k, way, friction)
    inf = type(speed)("inf")
    impulse_left = -speed / growth if growth < 0 else inf

    def ahead(more: float) -> None:
        """Advance by a normal impulse."""
        nonlocal speed, impulse_left
        state[W] += more * (state[V] + slope * more / 2)
        state[H] += friction * more * (speed + growth * more / 2)
        state[V] += slope * more
        state[P] += more
        state[FX] += ratio[0] * more
        state[FY] += ratio[1] * more
        speed += growth * more
        impulse_left -= more
        state[X], state[Y] = speed * way[0], speed * way[1]

    if not slip.restoring:
        more = -state[V] / slope if slope > 0 else inf
        if more > impulse_left:
            ahead(impulse_left)
            slip.stopped = True
            return False
        ahead(more)
        state[V] = type(slope)(0)
        slip.compressed()
        if restitution == 0:
            return True
    more, after = restitution_of(slip, state[V], slope, approach, restitution, law)
    if more > impulse_left:
        ahead(impulse_left)
        slip.stopped = True
        return False
    ahead(more)
    state[V] = after
    return True


@record
class End:
    """The end of an impact in space, in the frame of the contact."""

    velocity: "Vector"
    impulse: "Vector"
    compression: float
    work: float
    work_back: float
    heat: float
    history: str
    slip_impulse: float
    steps: int = 0


def end_of(slip: Slip, history: str, slip_impulse: float | None = None) -> End:
    """The end from the state; the slip lasted to the end unless its impulse is given."""
    state = slip.state
    return End(
        velocity=(state[X], state[Y], state[V]),
        impulse=(state[FX], state[FY], state[P]),
        compression=type(state[V])(0) if slip.compression is None else slip.compression,
        work=slip.work,
        work_back=state[W] + slip.work,
        heat=state[H],
        history=history,
        slip_impulse=state[P] if slip_impulse is None else slip_impulse,
        steps=slip.steps,
    )


def from_rest(
    k: "Matrix", slip: Slip, approach: float, friction: float, restitution: float, law: str, at_rest: bool
) -> End:
    """After the slip has stopped, or if there was none: p_t = c p_n with a constant c."""
    (_, _, k13), (_, _, k23), (_, _, k33) = k
    state = slip.state
    ratio = stick_ratio(k)
    sticks = ratio[0] * ratio[0] + ratio[1] * ratio[1] <= friction * friction
    growth = type(k13)(0), type(k13)(0)
    if not sticks:
        out = way_out(k, friction)
        ratio = -friction * out[0], -friction * out[1]
        growth = tuple(row[0] * ratio[0] + row[1] * ratio[1] + row[2] for row in k[:2])  # type: ignore[assignment]
    slope = k33 + k13 * ratio[0] + k23 * ratio[1]
    require(
        slope > 0,
        "to the accuracy of doubles the bodies give way at the contact in one direction only: the impulse is not "
        "determined",
        code="singular",
        hint="check levers and inertias: the lever is very long beside the radius of gyration",
    )
    begin, work = state[P], state[W]
    words = ("slip from rest", "stick") if at_rest else ("slip, slip anew", "slip, stick")
    more, speed = type(slope)(0), state[V]
    if not slip.restoring:
        more = -speed / slope
        state[P], state[W] = begin + more, work + more * speed / 2
        slip.compressed()
        speed = type(slope)(0)
    rest, after = restitution_of(slip, speed, slope, approach, restitution, law)
    more += rest
    state[W] += (speed + after) * rest / 2
    state[H] += friction * more * more * root(growth[0] * growth[0] + growth[1] * growth[1]) / 2
    before = (state[X], state[Y]) if at_rest else (type(slope)(0), type(slope)(0))
    state[X], state[Y], state[V] = before[0] + growth[0] * more, before[1] + growth[1] * more, after
    state[FX], state[FY], state[P] = state[FX] + ratio[0] * more, state[FY] + ratio[1] * more, begin + more
    if friction > 0:
        return end_of(slip, words[sticks], begin)
    return end_of(slip, "slip without friction")
