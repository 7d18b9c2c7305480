"""How many roots of a polynomial lie left, right and on the imaginary axis, counted exactly."""

from dynamics_cli.numerics.exact.whole_polynomials import (
    chain,
    changes_at,
    changes_far,
    common_divisor,
    derivative,
    mirrored,
    quotient,
    square_free,
)
from dynamics_cli.quantities import Annotated, Count
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence


@record
class Counts:
    """Roots by side of the axis, each as often as its multiplicity."""

    left: Annotated[Count, "Roots on the left."]
    right: Annotated[Count, "Roots on the right."]
    axis: Annotated[Count, "Roots on the axis."]
    repeated: Annotated[Count, "The largest multiplicity of a root on the axis."]


ASYMPTOTIC = "asymptotically stable"
MARGINAL = "marginally stable: simple roots on the axis"
REPEATED = "unstable: repeated roots on the axis"
UNSTABLE = "unstable"


def count(p: "Sequence[int]") -> Counts:
    """The roots of p by side of the imaginary axis.

    Each square-free factor is parted into its factor s, its roots in pairs ±s, which are shared with p(−s), and the
    rest. On the axis there are the negative roots in s² of the pairs, which Sturm's chain counts; the other pairs
    lie one on each side. The rest has no root on the axis, and the Cauchy index of its parts along the axis tells left
    less right.
    """
    left = right = axis = repeated = 0
    for factor, multiplicity in square_free(p):
        on_left, on_right, on_axis = _count_simple(factor)
        left, right, axis = (
            left + multiplicity * on_left,
            right + multiplicity * on_right,
            axis + multiplicity * on_axis,
        )
        if on_axis:
            repeated = max(repeated, multiplicity)
    return Counts(left=left, right=right, axis=axis, repeated=repeated)


def verdict(counts: Counts) -> str:
    """What the counts say of a linear system."""
    if counts.right:
        return UNSTABLE
    if not counts.axis:
        return ASYMPTOTIC
    return MARGINAL if counts.repeated == 1 else REPEATED


def parted(p: "Sequence[int]") -> "tuple[int, tuple[int, ...], tuple[int, ...]]":
    """A square-free polynomial as s^k (k is 0 or 1), its roots in pairs ±s as a polynomial in s², and the rest."""
    at_zero = int(p[0] == 0)
    body = tuple(p[at_zero:])
    pairs = common_divisor(body, mirrored(body))
    return at_zero, pairs[::2], quotient(body, pairs)


def _count_simple(p: "Sequence[int]") -> "tuple[int, int, int]":
    at_zero, pairs, rest = parted(p)
    negative = 0
    if len(pairs) > 1:
        sturm = chain(pairs, derivative(pairs))
        negative = changes_far(sturm, -1) - changes_at(sturm, (0, 1))
    beside = len(pairs) - 1 - negative
    degree = len(rest) - 1
    excess = left_less_right(rest)
    return (degree + excess) // 2 + beside, (degree - excess) // 2 + beside, at_zero + 2 * negative


def left_less_right(p: "Sequence[int]") -> int:
    """Roots on the left less roots on the right of a polynomial without roots in pairs ±s.

    As ω runs along the axis the argument of p(iω) grows by π for each root on the left and falls by π for each on the
    right; the Cauchy index of its real and imaginary parts counts these half turns.
    """
    if len(p) < 2:
        return 0
    turned = (1, 1, -1, -1)
    real = tuple(turned[k % 4] * c if k % 2 == 0 else 0 for k, c in enumerate(p))
    imaginary = tuple(turned[k % 4] * c if k % 2 else 0 for k, c in enumerate(p))
    odd = (len(p) - 1) % 2
    sturm = chain(imaginary, real) if odd else chain(real, imaginary)
    index = changes_far(sturm, -1) - changes_far(sturm, 1)
    return index if odd else -index
