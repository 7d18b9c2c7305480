"""Tooth numbers chosen stage by stage."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from fractions import Fraction


def greedy(target: "tuple[int, int]", stages: int, teeth: "tuple[int, int]") -> "Fraction":
    """Stage by stage: the pair nearest to the root of what is left, and the last pair nearest to the rest."""
    from fractions import Fraction

    low, high = teeth
    left = Fraction(*target)
    product = Fraction(1)
    for remaining in range(stages, 0, -1):
        aim = left if remaining == 1 else Fraction(float(left) ** (1.0 / remaining))
        pairs = (Fraction(min(max(round(aim * gear), low), high), gear) for gear in range(low, high + 1))
        pair = min(pairs, key=lambda one: abs(one - aim))
        product *= pair
        left /= pair
    return product
