"""The task `discrete`: roots of a polynomial in z inside, outside and on the unit circle."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.exact.polynomial_text import read, whole
from dynamics_cli.numerics.exact.whole_polynomials import plus, power, square_free, times, trimmed
from dynamics_cli.quantities import Angle, Annotated, Count, Ratio, Text
from dynamics_cli.records import ErrorBound, Numerics, record
from dynamics_cli.stability.counting import count
from dynamics_cli.stability.roots import LAST, METHOD, bounds_of, circle_discs, relative

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence


# An angle of two doubles.
ANGLE = 4e-16


@record
class CircleRoot:
    """One root in z; of a pair the upper one."""

    real: Annotated[Ratio, "Real part [-]."]
    imaginary: Annotated[Ratio, "Imaginary part [-]."]
    size: Annotated[Ratio, "Distance from the origin: growth by each sample [-]."]
    angle: Annotated[Angle, "Turn by each sample [rad]."]
    multiplicity: Annotated[Count, "How often it is a root."]
    pair: Annotated[bool, "Whether the conjugate is a root too."]


@record
class Discrete:
    """What the characteristic polynomial of a sampled system says of stability."""

    verdict: Annotated[Text, "Stable, marginal or unstable."]
    inside: Annotated[Count, "Roots inside the unit circle."]
    outside: Annotated[Count, "Roots outside the unit circle."]
    circle: Annotated[Count, "Roots on the unit circle."]
    repeated: Annotated[Count | None, "The largest multiplicity of a root on the circle; none where none lies on it."]
    largest: Annotated[Ratio, "Largest size of a root [-]."]
    roots: Annotated[tuple[CircleRoot, ...], "The roots, the largest first; of a pair the upper one."]
    numerics: Numerics


def discrete(
    polynomial: Annotated[Text, "In z, or its coefficients from the highest power down, e.g. z^2 - 1.5z + 0.7."], /
) -> Discrete:
    """Count the roots of a polynomial in z inside, outside and on the unit circle.

    Equation
    --------
    z = (1 + s)/(1 − s) maps the inside of the circle on the left half plane; z = −1 goes to infinity, where the degree
    of the polynomial in s drops.

    Returns
    -------
    Discrete
        The verdict, the counts and the roots.

    Raises
    ------
    UsageError
        When the text is no polynomial in z, or has no z.

    References
    ----------
    Jury, Theory and Application of the z-Transform Method, Wiley 1964, chapter 3.

    Examples
    --------
    >>> discrete("z^2 - 1.5z + 0.7").verdict
    'asymptotically stable'
    """
    p = trimmed(whole(read(polynomial, "z"))[0][0])
    require(len(p) > 1, "{text} has no roots: it has no z", text=repr(polynomial), code="no-variable",
            hint="give the characteristic polynomial, such as z^2 - 1.5z + 0.7")  # fmt: skip
    inside = outside = circle = repeated = 0
    for factor, multiplicity in square_free(p):
        mapped = on_the_plane(factor)
        counts = count(mapped)
        on_circle = counts.axis + len(factor) - len(mapped)
        inside, outside = inside + multiplicity * counts.left, outside + multiplicity * counts.right
        circle += multiplicity * on_circle
        repeated = max(repeated, multiplicity) if on_circle else repeated
    roots_proved = _roots(p)
    return Discrete(
        verdict=_verdict(outside, circle, repeated),
        inside=inside,
        outside=outside,
        circle=circle,
        repeated=repeated or None,
        largest=max(root.size for root in roots_proved),
        roots=roots_proved,
        numerics=Numerics(
            METHOD,
            (
                ErrorBound("largest", LAST),
                *bounds_of("roots", roots_proved, size=LAST, angle=ANGLE),
                *(
                    ErrorBound(f"roots[{nth}].{name}", relative(getattr(root, name), root.size))
                    for nth, root in enumerate(roots_proved)
                    for name in ("real", "imaginary")
                ),
            ),
        ),
    )


def _verdict(outside: int, circle: int, repeated: int) -> str:
    if outside:
        return "unstable"
    if not circle:
        return "asymptotically stable"
    return (
        "marginally stable: simple roots on the circle" if repeated == 1 else "unstable: repeated roots on the circle"
    )


def on_the_plane(p: "Sequence[int]") -> "tuple[int, ...]":
    """The polynomial in s of p(z), z = (1 + s)/(1 − s), times (1 − s)^degree."""
    degree = len(p) - 1
    total: tuple[int, ...] = ()
    for k, c in enumerate(p):
        total = plus(total, times(power((1, 1), k), power((1, -1), degree - k)), c)
    return total


def _roots(p: "Sequence[int]") -> "tuple[CircleRoot, ...]":
    proved = []
    for factor, multiplicity in square_free(p):
        for x, y, size, angle in circle_discs(factor):
            if y >= 0.0:
                proved.append(
                    CircleRoot(real=x, imaginary=y, size=size, angle=angle, multiplicity=multiplicity, pair=y > 0.0)
                )
    return tuple(sorted(proved, key=lambda root: (-root.size, root.angle)))
