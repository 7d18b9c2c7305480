"""The task `routh`: roots by side of the axis from a characteristic polynomial, with Routh's array."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.exact.polynomial_text import read, whole
from dynamics_cli.numerics.exact.whole_polynomials import trimmed
from dynamics_cli.quantities import Annotated, Count, GrowthRate, Text
from dynamics_cli.records import Advice, Check, Numerics, record
from dynamics_cli.stability.array import MOST_DEGREE, Row, array
from dynamics_cli.stability.counting import MARGINAL, REPEATED, Counts, count, verdict
from dynamics_cli.stability.roots import METHOD, Root, root_bounds, roots

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence


@record
class Routh:
    """What a characteristic polynomial says of stability."""

    verdict: Annotated[Text, "Stable, marginal or unstable."]
    left: Annotated[Count, "Roots in the left half plane."]
    right: Annotated[Count, "Roots in the right half plane."]
    axis: Annotated[Count, "Roots on the imaginary axis."]
    repeated: Annotated[Count | None, "The largest multiplicity of a root on the axis; none where none lies on it."]
    rightmost: Annotated[GrowthRate, "Largest real part of a root [1/s]."]
    roots: Annotated[tuple[Root, ...], "The roots, the rightmost first; of a pair the upper one."]
    array: Annotated[tuple[Row, ...] | None, "Routh's array; none beyond degree 20."]
    numerics: Numerics
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def routh(
    polynomial: Annotated[Text, "In s, or its coefficients from the highest power down, e.g. s^3 + 2s^2 + 5s + 24."], /
) -> Routh:
    """Count the roots of a characteristic polynomial left, right and on the imaginary axis.

    Equation
    --------
    p = g·r with g = gcd(p(s), p(−s)), the roots in pairs ±s; left − right of r from the Cauchy index of its real and
    imaginary parts along the axis; roots of g on the axis by Sturm's chain in s².

    Returns
    -------
    Routh
        The verdict, the counts, the roots and Routh's array.

    Raises
    ------
    UsageError
        When the text is no polynomial in s, or has no s.

    Notes
    -----
    Coefficients are taken as typed: decimals and fractions are exact, and so are the counts. The small number ε in the
    array stands for a zero pivot; the verdict does not depend on it.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 14.7; Gantmacher, The Theory of Matrices,
    volume 2, Chelsea 1959, chapter XV.

    Examples
    --------
    >>> answer = routh("s^6+s^5+3s^4+3s^3+3s^2+2s+1")
    >>> answer.left, answer.right, answer.axis
    (2, 2, 2)
    """
    rows, denominator = whole(read(polynomial))
    p = rows[0]
    require_variable(p, polynomial)
    counts = count(p)
    roots_proved = roots(p)
    return Routh(
        verdict=verdict(counts),
        left=counts.left,
        right=counts.right,
        axis=counts.axis,
        repeated=counts.repeated or None,
        rightmost=roots_proved[0].real,
        roots=roots_proved,
        array=array(p, denominator) if len(p) <= MOST_DEGREE + 1 else None,
        numerics=Numerics(METHOD, root_bounds(roots_proved, "rightmost")),
        checks=(_check(counts, roots_proved),),
        advice=advice_on(counts),
    )


def require_variable(p: "Sequence[int]", text: str) -> None:
    """Refuse a polynomial that is a number."""
    require(len(trimmed(p)) > 1, "{text} has no roots: it has no s", text=repr(text), code="no-variable",
            hint="give the characteristic polynomial, such as s^2 + 2s + 5")  # fmt: skip


def advice_on(counts: Counts) -> "tuple[Advice, ...]":
    """What a verdict on the axis depends on."""
    if verdict(counts) in (MARGINAL, REPEATED):
        message = "roots on the axis are there for the coefficients exactly as typed: the smallest change moves them"
        return (
            Advice("axis", message, remedy="give measured coefficients as ranges to `dynamics stability interval`"),
        )
    return ()


def _check(counts: Counts, roots_proved: "Sequence[Root]") -> Check:
    """The signs of the roots, calculated apart from the counts, must agree with them."""
    by_side = [0, 0, 0]
    for root in roots_proved:
        side = 0 if root.real < 0.0 else 1 if root.real > 0.0 else 2
        by_side[side] += root.multiplicity * (2 if root.pair else 1)
    apart = sum(abs(a - b) for a, b in zip(by_side, (counts.left, counts.right, counts.axis), strict=True))
    return Check("counts agree with the roots", apart == 0, float(apart), 0.0)
