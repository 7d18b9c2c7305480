"""Further ways beside those of `alternatives/gear/ratio`."""

from dynamics_cli.accuracy.alternatives.gear.ratio import Wanted

TYPE_CHECKING = False
if TYPE_CHECKING:
    from fractions import Fraction


def greedy(wanted: Wanted) -> "Fraction":
    """Stage by stage: the pair nearest to the root of what is left, and the last pair nearest to the rest."""
    from fractions import Fraction

    low, high = wanted.teeth
    left = Fraction(*wanted.target)
    made = Fraction(1)
    for remaining in range(wanted.stages, 0, -1):
        aim = left if remaining == 1 else Fraction(float(left) ** (1.0 / remaining))
        pairs = (Fraction(min(max(round(aim * own), low), high), own) for own in range(low, high + 1))
        pair = min(pairs, key=lambda one: abs(one - aim))
        made *= pair
        left /= pair
    return made
