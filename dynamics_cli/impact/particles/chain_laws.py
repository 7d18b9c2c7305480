"""The laws of a chain in decimal arithmetic of many digits: which pair closes is then decided as in exact arithmetic.

The last bit decides whether balls of equal speed still close, and the answer jumps with it. So many digits are used
that their rounding cannot reach the digits of a double.
"""

from decimal import Context, Decimal, localcontext
from itertools import pairwise

from dynamics_cli.errors import worded
from dynamics_cli.quantities import Energy

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

MOST_COLLISIONS = 20000
MOST_ROUNDS = 2000
# Pairs that keep colliding ever more slowly are stopped at this share of the fastest initial closing speed; of those
# that collide too often to be followed, those slower than the second count as stopped.
STILL = Decimal("1e-32")
STOPPED = Decimal("1e-14")
# Digits in addition to those for the range of masses and speeds.
DIGITS = 80
ZERO = Decimal(0)


class Motion:
    """Result of a law for a chain: changes of velocity, impulses between neighbours, energy lost, collisions.

    `why`: the reason for no answer; `left`: bound of the change of each velocity by omitted collisions, in the norm √(Σ
    m v²).
    """

    __slots__ = ("changes", "collisions", "impulses", "left", "lost", "why")

    def __init__(self, count: int) -> None:
        self.changes = [ZERO] * count
        self.impulses = [ZERO] * (count - 1)
        self.lost = ZERO
        self.collisions = 0
        self.left = ZERO
        self.why = ""


class Chain:
    """A chain before the impact, in exact numbers, and the digits of its calculation."""

    def __init__(self, masses: "Sequence[float]", velocities: "Sequence[float]", ratios: "Sequence[float]") -> None:
        self.masses = [Decimal(mass) for mass in masses]
        self.velocities = [Decimal(velocity) for velocity in velocities]
        self.ratios = [Decimal(ratio) for ratio in ratios]
        closing = [a - b for a, b in pairwise(velocities)]
        self.fastest = Decimal(max(closing))
        self.heavy = max(self.masses).adjusted() - min(self.masses).adjusted()
        moving = [velocity.adjusted() for velocity in self.velocities if velocity]
        # enough digits for the effect of a light body on a heavy one, and for the slowest closing
        self.digits = DIGITS + 2 * self.heavy + max(moving) - min(self.fastest.adjusted(), *moving)

    def closing(self) -> list[Decimal]:
        """Speeds at which neighbours close."""
        return [a - b for a, b in pairwise(self.velocities)]

    def least(self) -> Decimal:
        """Closing slower than this counts as stopped."""
        rounding = max(map(abs, self.velocities)).scaleb(20 - self.digits)
        return max((STILL * self.fastest).scaleb(-self.heavy // 2), rounding)

    def drift(self, closing: Decimal) -> Decimal:
        """How far, in √(Σ m v²), velocities may still change when no pair closes faster than this.

        A collision never increases the distance from any set of ordered velocities, so they end within twice the
        distance from the nearest such set: here each body is moved next to the heaviest.
        """
        heaviest = self.masses.index(max(self.masses))
        spread = sum((mass * (index - heaviest) ** 2 for index, mass in enumerate(self.masses)), ZERO)
        return 2 * max(closing, ZERO) * spread.sqrt()


def _sequential(chain: Chain) -> Motion:
    """One pair at a time, the fastest first; of pairs as fast the first in line."""
    motion = Motion(len(chain.masses))
    closing, least = chain.closing(), chain.least()
    reduced = [one * other / (one + other) for one, other in pairwise(chain.masses)]
    alike = 1 - Decimal(1).scaleb(20 - chain.digits)
    while (fastest := max(closing)) > least:
        if motion.collisions == MOST_COLLISIONS:
            if fastest > STOPPED * chain.fastest:
                motion.why = worded("the pairs go on colliding after {count} collisions", count=MOST_COLLISIONS)
            break
        lowest = alike * fastest
        at = next(index for index, speed in enumerate(closing) if speed >= lowest)
        speed, e = closing[at], chain.ratios[at]
        push = (1 + e) * reduced[at] * speed
        motion.lost += (1 - e) * push * speed / 2
        motion.impulses[at] += push
        back, ahead = push / chain.masses[at], push / chain.masses[at + 1]
        motion.changes[at] -= back
        motion.changes[at + 1] += ahead
        closing[at] = -e * speed
        if at:
            closing[at - 1] += back
        if at + 1 < len(closing):
            closing[at + 1] += ahead
        motion.collisions += 1
    motion.left = chain.drift(fastest)
    return motion


def _simultaneous(chain: Chain) -> Motion:
    """All contacts at one moment, in rounds until no pair closes."""
    motion = Motion(len(chain.masses))
    weights = [1 / mass for mass in chain.masses]
    closing, least = chain.closing(), chain.least()
    size = ZERO
    while (fastest := max(closing)) > least:
        if motion.collisions == MOST_ROUNDS:
            if fastest > STOPPED * chain.fastest:
                motion.why = worded("the pairs still close after {count} rounds", count=MOST_ROUNDS)
            break
        pushes = [(1 + e) * p for e, p in zip(chain.ratios, _plastic(weights, closing), strict=True)]
        opened = _opened(weights, pushes)
        for p, u, o in zip(pushes, closing, opened, strict=True):
            motion.lost += p * (u + u - o) / 2
            size += p * (abs(u) + abs(o))
        motion.impulses = [so_far + more for so_far, more in zip(motion.impulses, pushes, strict=True)]
        closing = [u - o for u, o in zip(closing, opened, strict=True)]
        motion.collisions += 1
    # remaining digits of a sum that is zero
    if abs(motion.lost) <= size.scaleb(20 - chain.digits):
        motion.lost = ZERO
    if motion.lost < 0 and not motion.why:
        motion.why = worded("different restitutions would add {energy} to the bodies", energy=(-motion.lost, Energy))
    ends = zip([ZERO, *motion.impulses], [*motion.impulses, ZERO], weights, strict=True)
    motion.changes = [(behind - ahead) * weight for behind, ahead, weight in ends]
    motion.left = chain.drift(fastest)
    return motion


def _plastic(weights: list[Decimal], closing: list[Decimal]) -> list[Decimal]:
    """Smallest impulses after which no pair closes: an M-matrix, so the set of active contacts only grows."""
    acting = [u > 0 for u in closing]
    while True:
        impulses = _tridiagonal(weights, closing, acting)
        opened = _opened(weights, impulses)
        short = [not a and o < u for a, o, u in zip(acting, opened, closing, strict=True)]
        if not any(short):
            return impulses
        acting = [a or s for a, s in zip(acting, short, strict=True)]


def _opened(weights: list[Decimal], impulses: list[Decimal]) -> list[Decimal]:
    """K p: by how much the impulses open every contact."""
    opened = [(weights[i] + weights[i + 1]) * p for i, p in enumerate(impulses)]
    for i in range(len(impulses) - 1):
        opened[i] -= weights[i + 1] * impulses[i + 1]
        opened[i + 1] -= weights[i + 1] * impulses[i]
    return opened


def _tridiagonal(weights: list[Decimal], wanted: list[Decimal], acting: list[bool]) -> list[Decimal]:
    """K p = wanted on runs of acting contacts, p = 0 elsewhere."""
    impulses = [ZERO] * len(wanted)
    start = 0
    while start < len(wanted):
        if not acting[start]:
            start += 1
            continue
        end = start
        while end < len(wanted) and acting[end]:
            end += 1
        # elimination without subtractions: the diagonal keeps the contribution of the bodies before separate
        right = wanted[start:end]
        owed = weights[start]
        diagonal = [owed + weights[start + 1]]
        for i in range(1, end - start):
            factor = weights[start + i] / diagonal[i - 1]
            owed = factor * owed
            diagonal.append(owed + weights[start + i + 1])
            right[i] += factor * right[i - 1]
        for i in reversed(range(end - start)):
            following = weights[start + i + 1] * impulses[start + i + 1] if start + i + 1 < end else ZERO
            impulses[start + i] = (right[i] + following) / diagonal[i]
        start = end
    return impulses


UNIT_ROUNDOFF = 2.0**-53
SMALLEST = 5e-324


class Bounded:
    """A number as a double with a bound on its error: `left`, and rounding here and in another unit."""

    __slots__ = ("error", "value")

    def __init__(self, number: Decimal, left: Decimal) -> None:
        # numbers indistinguishable from zero are zero
        self.value = 0.0 if abs(number) <= left else float(number)
        self.error = 2.0 * UNIT_ROUNDOFF * abs(self.value) + float(2 * left) + SMALLEST


class Answer:
    """Answer of one law: velocities after and before, impulses, energy lost, collisions; or the reason for none."""

    __slots__ = ("changes", "collisions", "impulses", "lost", "velocities", "why")

    def __init__(self, chain: Chain, law: str) -> None:
        with localcontext(Context(prec=chain.digits)):
            motion = (_sequential if law == "sequential" else _simultaneous)(chain)
            self.why, self.collisions = motion.why, motion.collisions
            # sums of thousands of roundings, magnified where light bodies strike heavy ones
            rounding = Decimal(1).scaleb(20 + chain.heavy - chain.digits)
            energy = sum((m * v * v for m, v in zip(chain.masses, chain.velocities, strict=True)), ZERO)
            mass = sum(chain.masses, ZERO)
            speed = rounding * max(map(abs, chain.velocities))
            ends = [v + change for v, change in zip(chain.velocities, motion.changes, strict=True)]
            left = [motion.left / m.sqrt() + speed for m in chain.masses]
            self.changes = list(map(Bounded, motion.changes, left))
            self.velocities = list(map(Bounded, ends, left))
            self.impulses = [Bounded(push, motion.left * mass.sqrt() + mass * speed) for push in motion.impulses]
            self.lost = Bounded(motion.lost, motion.left * energy.sqrt() + rounding * energy)


def momentum(masses: "Sequence[float]", velocities: "Sequence[float]") -> float:
    """Σ m v, rounded once."""
    with localcontext(Context(prec=1000)):
        return float(sum((Decimal(m) * Decimal(v) for m, v in zip(masses, velocities, strict=True)), ZERO))
