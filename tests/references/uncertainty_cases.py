"""The cases of uncertainty.json: what is calculated from which inputs, why it is hard, and its law in mathematics."""

from collections.abc import Callable, Sequence
from typing import Any

from mpmath import mp, mpf
from uncertainty_laws import (
    Input,
    Law,
    Lognormal,
    Normal,
    Readings,
    Triangular,
    Truncated,
    Uniform,
    by_survival,
    integral,
    lognormal,
    normal,
    phi,
    rising,
    root,
    sum_of_uniforms,
)

G2 = 2 * mpf(9.80665)
KINDS: dict[str, Callable[..., Input]] = {
    "normal": Normal, "uniform": Uniform, "triangular": Triangular, "lognormal": Lognormal, "truncated": Truncated,
    "readings": Readings,
}  # fmt: skip
Spelled = tuple[str, ...]


class Wanted:
    """A model on inputs, and the law of its result as a function of the inputs in multiple precision."""

    def __init__(
        self, name: str, why: str, model: str, inputs: Sequence[Spelled], law: Callable[..., Law],
        correlation: Sequence[tuple[int, int, str]] = (),
    ) -> None:  # fmt: skip
        self.name = name
        self.why = why
        self.model = model
        self.inputs = [list(one) for one in inputs]
        self.correlation = [list(one) for one in correlation]
        self._law = law

    def law(self) -> Law:
        """The law, at the precision that is set."""
        made = [KINDS[kind](*rest) for kind, *rest in self.inputs]
        return self._law(*made, *(mpf(float(rho)) for _, _, rho in self.correlation))


def skid(mu: Input, d: Input) -> Law:
    """√(2gμd): P = E(P(μ ≤ w²/(2gd))); expectations of roots multiply."""

    def cdf(w: Any) -> Any:
        # a bounded friction bends where w²/(2gd) leaves its interval, or passes its mode
        ends = (mu.low, getattr(mu, "mode", mu.low), mu.high)
        kinks = [w * w / (G2 * end) for end in sorted(set(ends)) if 0 < end < mp.inf]
        return d.expect(lambda x: mu.cdf(w * w / (G2 * x)), kinks)

    def moments() -> tuple[Any, Any]:
        def positive(x: Any) -> Any:
            return mp.sqrt(max(x, mpf(0)))

        first = mp.sqrt(G2) * mu.expect(positive) * d.expect(positive)
        return first, G2 * mu.expect(lambda x: x) * d.expect(lambda x: x)

    return Law(cdf, (mpf(2), mpf(40)), moments)


def skid_of_normals(mu: Normal, d: Normal, rho: Any = 0) -> Law:
    """The same with normal inputs, correlated or not: friction given the length is normal."""
    rest = mp.sqrt(1 - rho * rho)

    def given(t: Any) -> Any:
        return mu.mean + rho * mu.std * t

    unit = Normal("0", "1")

    def below(w: Any, t: Any) -> Any:
        length = d.mean + d.std * t
        return phi((w * w / (G2 * length) - given(t)) / (mu.std * rest)) if length > 0 else mpf(0)

    def cdf(w: Any) -> Any:
        return unit.expect(lambda t: below(w, t))

    def moments() -> tuple[Any, Any]:
        inner = mu.std * rest

        def of_roots(t: Any) -> Any:
            length = mp.sqrt(max(d.mean + d.std * t, mpf(0)))
            return length * unit.expect(lambda u: mp.sqrt(max(given(t) + inner * u, mpf(0)))) if rho else length

        mean_product = mu.mean * d.mean + rho * mu.std * d.std
        first = unit.expect(of_roots)
        if not rho:
            first *= mu.expect(lambda x: mp.sqrt(max(x, mpf(0))))
        return mp.sqrt(G2) * first, G2 * mean_product

    return Law(cdf, (mpf(2), mpf(40)), moments)


def products(*made: Any) -> Law:
    """The product of lognormals; correlated alike, if the last argument is a number."""
    rho = made[-1] if not isinstance(made[-1], Lognormal) else mpf(0)
    factors = [one for one in made if isinstance(one, Lognormal)]
    widths = mp.fsum(one.width for one in factors)
    squares = mp.fsum(one.width**2 for one in factors)
    return lognormal(mp.fsum(one.centre for one in factors), squares + rho * (widths**2 - squares))


def skid_of_lognormals(mu: Lognormal, d: Lognormal, rho: Any = 0) -> Law:
    """√(2gμd) of lognormals is lognormal."""
    variance = mu.width**2 + d.width**2 + 2 * rho * mu.width * d.width
    return lognormal((mp.log(G2) + mu.centre + d.centre) / 2, variance / 4)


def largest(*made: Input) -> Law:
    """P(max ≤ w) is the product of the distribution functions."""
    low = max(one.mean - 15 * one.std if isinstance(one, Normal) else one.low for one in made)
    high = max(one.mean + 15 * one.std if isinstance(one, Normal) else one.high for one in made)

    def cdf(w: Any) -> Any:
        return mp.fprod(one.cdf(w) for one in made)

    inside = sorted(x for one in made for x in (one.low, one.high) if low < x < high)
    step = (high - low) / 8
    places = [low, *inside, high] if inside else [low + k * step for k in range(9)]
    return Law(cdf, (low, high), by_survival(cdf, places))


def largest_of_normals(a: Normal, b: Normal, rho: Any) -> Law:
    """Clark's moments; P = E(Φ(w given the other)) over the part of it below w."""
    rest = mp.sqrt(1 - rho * rho)

    def cdf(w: Any) -> Any:
        def given(x: Any) -> Any:
            return phi(((w - b.mean) / b.std - rho * (x - a.mean) / a.std) / rest)

        top = (w - a.mean) / a.std
        places = [mpf(-14), top - 1, top] if top > -13 else [mpf(-14), top]
        return integral(lambda t: mp.npdf(t) * given(a.mean + a.std * t), places)

    def moments() -> tuple[Any, Any]:
        spread = mp.sqrt(a.std**2 + b.std**2 - 2 * rho * a.std * b.std)
        k = (a.mean - b.mean) / spread
        first = a.mean * phi(k) + b.mean * phi(-k) + spread * mp.npdf(k)
        second = (a.mean**2 + a.std**2) * phi(k) + (b.mean**2 + b.std**2) * phi(-k)
        return first, second + (a.mean + b.mean) * spread * mp.npdf(k)

    return Law(cdf, (mpf(-8), mpf(12)), moments)


def smallest(*made: Uniform) -> Law:
    """P(min ≤ w) is one less the product of what lies above."""
    low, high = min(one.low for one in made), min(one.high for one in made)

    def cdf(w: Any) -> Any:
        return 1 - mp.fprod(1 - one.cdf(w) for one in made)

    places = sorted({low, high, *(one.low for one in made if low < one.low < high)})
    return Law(cdf, (low, high), by_survival(cdf, places))


def apart(a: Normal, b: Normal) -> Law:
    """|a − b| is folded normal."""
    return folded(a.mean - b.mean, mp.sqrt(a.std**2 + b.std**2))


def folded(mean: Any, std: Any) -> Law:
    """The absolute value of a normal number."""
    first = std * mp.sqrt(2 / mp.pi) * mp.exp(-((mean / std) ** 2) / 2) + mean * (1 - 2 * phi(-mean / std))
    return Law(
        lambda w: phi((w - mean) / std) - phi((-w - mean) / std),
        (mpf(0), abs(mean) + 10 * std),
        lambda: (first, mean**2 + std**2),
    )


def positive_part(x: Normal) -> Law:
    """max(x, 0): an atom at zero."""
    m, s = x.mean, x.std
    k = m / s
    return Law(
        lambda w: x.cdf(w),
        (mpf(0), m + 10 * s),
        lambda: (m * phi(k) + s * mp.npdf(k), (m * m + s * s) * phi(k) + m * s * mp.npdf(k)),
        lambda p: max(x.quantile(p), mpf(0)),
    )


def square(x: Normal) -> Law:
    """x²: two branches that meet at zero."""
    m, s = x.mean, x.std
    return Law(
        lambda w: phi((mp.sqrt(w) - m) / s) - phi((-mp.sqrt(w) - m) / s),
        (mpf(0), (abs(m) + 10 * s) ** 2),
        lambda: (m * m + s * s, m**4 + 6 * m * m * s * s + 3 * s**4),
    )


def squares(*made: Normal) -> Law:
    """The sum of squares of n equal centred normals is s² times chi-squared."""
    n, s2 = mpf(len(made)), made[0].std ** 2
    return Law(
        lambda w: mp.gammainc(n / 2, 0, w / (2 * s2), regularized=True),
        (mpf(0), 20 * n * s2),
        lambda: (n * s2, (n * n + 2 * n) * s2**2),
    )


def radius(*made: Normal) -> Law:
    """The length of a centred isotropic normal vector."""
    n, s = mpf(len(made)), made[0].std
    return Law(
        lambda w: mp.gammainc(n / 2, 0, (w / s) ** 2 / 2, regularized=True),
        (mpf(0), 12 * s),
        lambda: (s * mp.sqrt(2) * mp.gamma((n + 1) / 2) / mp.gamma(n / 2), n * s * s),
    )


def rice(x: Normal, y: Normal) -> Law:
    """The length of (x, y) about a point away from the origin, both of one deviation."""
    v, s = mp.sqrt(x.mean**2 + y.mean**2), x.std

    u = v * v / (2 * s * s)

    def cdf(w: Any) -> Any:
        # Poisson's mixture of chi-squared distributions
        terms = (
            u**k / mp.factorial(k) * mp.gammainc(k + 1, 0, w * w / (2 * s * s), regularized=True) for k in range(80)
        )
        return mp.exp(-u) * mp.fsum(terms)

    bessel = (1 + u) * mp.besseli(0, u / 2) + u * mp.besseli(1, u / 2)
    first = s * mp.sqrt(mp.pi / 2) * mp.exp(-u / 2) * bessel
    return Law(cdf, (mpf(0), v + 10 * s), lambda: (first, v * v + 2 * s * s))


def product_of_uniforms(*made: Uniform) -> Law:
    """−ln of a product of n uniforms on (0, 1) is Gamma of order n."""
    n = len(made)
    return Law(
        lambda w: mp.gammainc(n, -mp.log(w), mp.inf, regularized=True) if w > 0 else mpf(0),
        (mpf(0), mpf(1)),
        lambda: (mpf(2) ** -n, mpf(3) ** -n),
        lambda p: mp.exp(-root(lambda t: mp.gammainc(n, 0, t, regularized=True) - (1 - p), (mpf(0), mpf(60)))),
    )


def quotient_of_uniforms(a: Uniform, b: Uniform) -> Law:
    """Lengths of chords: P(a ≤ w·b) = E(F(w·b)), a piecewise rational function."""

    def cdf(w: Any) -> Any:
        return b.expect(lambda x: a.cdf(w * x), [a.low / w, a.high / w])

    mean, square = (a.low + a.high) / 2, (a.low**2 + a.low * a.high + a.high**2) / 3
    inverse = mp.log(b.high / b.low) / (b.high - b.low)
    return Law(cdf, (a.low / b.high, a.high / b.low), lambda: (mean * inverse, square / (b.low * b.high)))


def sum_of_two(a: Input, b: Input) -> Law:
    """P = E(P(a ≤ w − b)), b the one of bounds."""

    def cdf(w: Any) -> Any:
        return b.expect(lambda x: a.cdf(w - x), [w - end for end in (a.low, a.high) if abs(end) < mp.inf])

    def moments() -> tuple[Any, Any]:
        first = [one.expect(lambda x: x) for one in (a, b)]
        second = [one.expect(lambda x: x * x) for one in (a, b)]
        return first[0] + first[1], second[0] + second[1] + 2 * first[0] * first[1]

    low = (a.low if a.low > -mp.inf else a.quantile(mpf(10) ** -20)) + b.low
    high = (a.high if a.high < mp.inf else a.quantile(1 - mpf(10) ** -20)) + b.high
    return Law(cdf, (low, high), moments)


def product_of_two(a: Normal, b: Input) -> Law:
    """P = E(P(a ≤ w/b)), b above zero."""

    def moments() -> tuple[Any, Any]:
        first, second = b.expect(lambda x: x), b.expect(lambda x: x * x)
        return a.mean * first, (a.mean**2 + a.std**2) * second

    middle = [b.quantile(mpf(1) / 2)]
    return Law(lambda w: b.expect(lambda x: a.cdf(w / x), middle), (mpf(-50), mpf(50)), moments)


def product_about_zero(a: Normal, b: Normal) -> Law:
    """The product of centred normals, infinitely dense at zero: P(> w) = (1/π)·∫ exp(−w·cosh t)/cosh t dt, t > 0."""
    scale = a.std * b.std

    def upper(w: Any) -> Any:
        return integral(lambda t: mp.exp(-w / scale * mp.cosh(t)) / mp.cosh(t), [mpf(0), mpf(3), mpf(9)]) / mp.pi

    def quantile(p: Any) -> Any:
        if p == mpf(1) / 2:
            return mpf(0)
        tail = min(p, 1 - p)
        found = root(lambda w: tail - upper(w), (mpf(0.1) * scale, 9 * scale))
        return found if p > tail else -found

    return Law(lambda w: None, (0, 0), lambda: (mpf(0), scale**2), quantile)


def quotient(a: Normal, b: Truncated) -> Law:
    """P(a ≤ w·b) = E(F(w·b)), the divisor bounded away from zero."""

    def moments() -> tuple[Any, Any]:
        return a.mean * b.expect(lambda x: 1 / x), (a.mean**2 + a.std**2) * b.expect(lambda x: 1 / x**2)

    return Law(lambda w: b.expect(lambda x: a.cdf(w * x)), (mpf(-20), mpf(20)), moments)


def sum_of_normals(*made: Any) -> Law:
    """Normal; all pairs correlated alike, if the last argument is a number."""
    terms = [one for one in made if isinstance(one, Normal)]
    rho = made[-1] if not isinstance(made[-1], Normal) else mpf(0)
    total, squares_ = mp.fsum(one.std for one in terms), mp.fsum(one.std**2 for one in terms)
    return normal(mp.fsum(one.mean for one in terms), squares_ + rho * (total**2 - squares_))


def difference_of_normals(a: Normal, b: Normal, rho: Any) -> Law:
    """Nearly all of the variance cancels."""
    return normal(a.mean - b.mean, (a.std - b.std) ** 2 + 2 * (1 - rho) * a.std * b.std)


def sine_of_half_turn(x: Uniform) -> Law:
    """sin x over half a turn: two branches that meet at the greatest value."""
    return Law(
        lambda w: 2 * mp.asin(w) / x.high,
        (mpf(0), mpf(1)),
        lambda: ((1 - mp.cos(x.high)) / x.high, (x.high / 2 - mp.sin(2 * x.high) / 4) / x.high),
        lambda p: mp.sin(p * x.high / 2),
    )


def identity(x: Any) -> Any:
    """x itself."""
    return x


def readings(x: Readings) -> Law:
    """Student's t, shifted and scaled."""
    return Law(lambda w: None, (0, 0), lambda: (x.mean, x.mean**2 + x.moment(2)), x.quantile)


def square_of_readings(x: Readings) -> Law:
    """x² of Student's t about zero."""
    return Law(
        lambda w: x.cdf(mp.sqrt(w)) - x.cdf(-mp.sqrt(w)),
        (mpf(0), (60 * x.scale) ** 2),
        lambda: (x.moment(2), x.moment(4)),
    )


def _alike(count: int, *spelled: str) -> list[Spelled]:
    return [spelled] * count


def _pairs(count: int, rho: str) -> list[tuple[int, int, str]]:
    """Every pair alike; the law is told once."""
    return [(i, j, rho) for j in range(count) for i in range(j)]


N, U, T, L, TR, R = "normal", "uniform", "triangular", "lognormal", "truncated", "readings"
N01, U01 = (N, "0", "1"), (U, "0", "1")
_SKID = [
    ("an ordinary skid", "", ("0.7", "0.05", "18", "0.5")),
    ("friction known badly", "nine deviations from no friction, the root bends", ("0.45", "0.05", "30", "1")),
    ("one input decides", "the length hardly matters", ("0.6", "0.05", "25", "0.001")),
    ("both matter alike", "no axis is the right one to integrate along", ("0.5", "0.05", "10", "1")),
]
_MORE = [
    Wanted(
        f"{name} by {rho}", why, "skid", [(N, *values[:2]), (N, *values[2:])],
        lambda mu, d, rho: skid_of_normals(mu, d, rho), [(0, 1, rho)],
    )
    for name, rho, why, values in (
        ("friction and length correlated", "0.9", "both axes lean", ("0.7", "0.05", "18", "1")),
        ("friction and length correlated", "-0.9", "what one adds the other takes away", ("0.7", "0.05", "18", "1")),
    )
]  # fmt: skip

CASES: list[Wanted] = [
    *(
        Wanted(name, why, "skid", [(N, *values[:2]), (N, *values[2:])], skid_of_normals)
        for name, why, values in _SKID
    ),
    Wanted("lognormal inputs", "", "skid", [(L, "0.7", "0.05"), (L, "18", "0.5")], skid_of_lognormals),
    Wanted("wide lognormal inputs", "half the mean for a deviation", "skid",
           [(L, "0.5", "0.25"), (L, "20", "10")], skid_of_lognormals),
    *_MORE,
    Wanted("nearly one input", "correlated by 0.999999: next to singular", "skid", [(L, "0.7", "0.1"), (L, "18", "3")],
           lambda mu, d, rho: skid_of_lognormals(mu, d, rho), [(0, 1, "0.999999")]),
    Wanted("nearly no variation", "correlated by −0.9999: what one adds the other takes away", "skid",
           [(L, "0.7", "0.07"), (L, "18", "1.8")], lambda mu, d, rho: skid_of_lognormals(mu, d, rho),
           [(0, 1, "-0.9999")]),
    Wanted("friction and length anywhere between bounds", "two bounds each, and corners between", "skid",
           [(U, "0.6", "0.8"), (U, "15", "20")], skid),
    Wanted("friction uniform, length normal", "bounded in one input only", "skid",
           [(U, "0.4", "0.9"), (N, "20", "1")], skid),
    Wanted("friction cut off, length uniform", "one tail cut at a deviation, the other far away", "skid",
           [(TR, "0.7", "0.1", "0.6", "1.1"), (U, "18", "19")], skid),
    Wanted("friction triangular, length lognormal", "a corner in the density", "skid",
           [(T, "0.5", "0.7", "0.75"), (L, "20", "3")], skid),
    # one input: what its own transformation does
    Wanted("e to a normal number", "wide lognormal tail", "exp", [N01], lambda x: rising(x, mp.exp)),
    Wanted("e to two deviations", "the mean lies above the 84th percentile", "exp", [(N, "0", "2")],
           lambda x: rising(x, mp.exp)),
    Wanted("lognormal three times as wide as its mean", "heavy tail: the deviation is ruled by rare cases", "same",
           [(L, "1", "3")], lambda x: rising(x, identity)),
    Wanted("reciprocal of a lognormal", "falls, and bends all the way", "reciprocal", [(L, "1", "1")],
           lambda x: rising(x, lambda v: 1 / v, sign=-1)),
    Wanted("square two deviations from zero", "two branches that meet within the inputs", "square",
           [(N, "1", "0.5")], square),
    Wanted("square about zero", "the gradient is zero at the centre", "square", [N01], square),
    Wanted("cube about zero", "a point of inflection at the centre: gradient and curvature are zero", "cube", [N01],
           lambda x: rising(x, lambda v: v**3)),
    Wanted("absolute value", "a kink within a third of a deviation", "absolute", [(N, "0.3", "1")],
           lambda x: folded(x.mean, x.std)),
    Wanted("positive part", "an atom: three cases of ten are exactly zero", "positive", [(N, "0.5", "1")],
           positive_part),
    Wanted("positive part, rarely at zero", "an atom of one in forty at the very end of the interval", "positive",
           [(N, "1.95996398454", "1")], positive_part),
    Wanted("square root down to zero", "infinite slope at the bound", "root", [U01],
           lambda x: rising(x, mp.sqrt)),
    Wanted("reciprocal near its pole", "the steep end is a thousandth of the interval from the pole", "reciprocal",
           [(U, "0.001", "1")], lambda x: rising(x, lambda v: 1 / v, sign=-1)),
    Wanted("sine over half a turn", "rises and falls: the greatest value lies inside", "sine",
           [(U, "0", "3.141592653589793")], sine_of_half_turn),
    Wanted("tangent near its poles", "slopes of one and of 200 in one interval", "tangent", [(U, "-1.5", "1.5")],
           lambda x: rising(x, mp.tan)),
    Wanted("logarithm near zero", "triangular, the density's corner next to the pole", "logarithm",
           [(T, "0.001", "0.002", "1")], lambda x: rising(x, mp.log)),
    Wanted("nearly a step", "all of the rise within a thousandth of a deviation", "step", [(N, "0.0001", "1")],
           lambda x: rising(x, lambda v: mp.atan(1000 * v), [mpf(-1) / 100, mpf(0), mpf(1) / 100])),
    Wanted("a tail alone", "normal beyond two deviations: next to exponential", "same",
           [(TR, "0", "1", "2", "5")], lambda x: rising(x, identity)),
    Wanted("a tail far out", "beyond seven deviations: probabilities of 1e-12 divided by one another", "same",
           [(TR, "0", "1", "7", "12")], lambda x: rising(x, identity)),
    Wanted("cut to next to uniform", "the bounds are all that matters", "square",
           [(TR, "0.6", "1", "0.2", "0.8")], lambda x: rising(x, lambda v: v * v)),
    Wanted("five readings", "Student's t of four degrees of freedom: fourth moment infinite", "same",
           [(R, "9.7", "10.1", "10.4", "9.9", "10.2")], readings),
    Wanted("square of six readings about zero", "heavy tails, folded at the centre", "square",
           [(R, "-1", "-0.5", "-0.25", "0.25", "0.5", "1")], square_of_readings),
    # two inputs
    Wanted("two uniform tolerances", "a triangle: corners where bounds meet", "total", [U01, U01], sum_of_uniforms),
    Wanted("a wide and a narrow tolerance", "a trapezoid of sides a thousandth long", "total",
           [U01, (U, "0", "0.001")], sum_of_uniforms),
    Wanted("product of uniforms", "logarithmic singularity of the density at zero", "product", [U01, U01],
           product_of_uniforms),
    Wanted("quotient of uniforms", "a density of three branches", "quotient", [(U, "1", "2"), (U, "0.5", "2")],
           quotient_of_uniforms),
    Wanted("a normal and a wide uniform", "steps softened by a tenth of their width", "total",
           [(N, "0", "0.1"), U01], sum_of_two),
    Wanted("a lognormal and a triangular", "three densities of different kinds, corners and a tail", "total",
           [(L, "1", "0.5"), (T, "0", "0.2", "2")], sum_of_two),
    Wanted("normal by lognormal", "wide product of mixed kinds", "product", [(N, "2", "0.5"), (L, "1", "0.8")],
           product_of_two),
    Wanted("product about zero", "a saddle: gradient zero, density infinite at the median", "product", [N01, N01],
           product_about_zero),
    Wanted("quotient with a divisor cut off", "the divisor comes within a fifth of its mean to zero", "quotient",
           [(N, "1", "0.3"), (TR, "1", "0.5", "0.2", "3")], quotient),
    Wanted("difference of nearly the same", "correlated by 0.999999: all but a thousandth cancels", "difference",
           [(N, "5", "1"), (N, "4", "1")], difference_of_normals, [(0, 1, "0.999999")]),
    Wanted("distance of two numbers", "a kink across the middle", "apart", [(N, "0.2", "1"), (N, "0", "0.5")], apart),
    Wanted("larger of two alike", "a kink through the centre, along no axis", "largest", [N01, N01], largest),
    Wanted("larger of two correlated", "a kink, and axes that lean", "largest", [N01, (N, "0.5", "2")],
           largest_of_normals, [(0, 1, "0.7")]),
    Wanted("smaller of two uniforms", "a kink between bounds", "smallest", [U01, (U, "0.3", "0.9")], smallest),
    Wanted("length of a centred vector", "the gradient does not exist at the centre", "radius", [N01, N01], radius),
    Wanted("length of a vector two deviations long", "level lines are circles about a near centre", "radius",
           [(N, "1", "0.5"), (N, "0", "0.5")], rice),
    # more inputs
    Wanted("four tolerances", "bounds in four inputs, smooth to the second derivative only", "total",
           _alike(4, *U01), sum_of_uniforms),
    Wanted("four tolerances, each half of the one before", "corners everywhere", "total",
           [U01, (U, "0", "0.5"), (U, "0", "0.25"), (U, "0", "0.125")], sum_of_uniforms),
    Wanted("eight tolerances", "256 corners", "total", _alike(8, *U01), sum_of_uniforms),
    Wanted("length in space", "no gradient at the centre, in three dimensions", "radius", _alike(3, *N01), radius),
    Wanted("four squares", "gradient zero in all directions alike", "squares", _alike(4, *N01), squares),
    Wanted("eight squares", "the same in eight dimensions", "squares", _alike(8, *N01), squares),
    Wanted("largest of four", "six kinks that meet at the centre", "largest", _alike(4, *N01), largest),
    Wanted("largest of eight uniforms", "28 kinks, and the bound of all", "largest", _alike(8, *U01), largest),
    Wanted("product of six lognormals, correlated", "a correlation in every pair", "product", _alike(6, L, "1", "0.4"),
           lambda *made: products(*made[:6], made[6]), _pairs(6, "0.5")),
    Wanted("product of ten uniforms", "five decades of range", "product", _alike(10, *U01), product_of_uniforms),
    Wanted("twenty inputs, correlated by 0.99", "next to singular in nineteen directions", "total",
           _alike(20, N, "1", "0.1"), lambda *made: sum_of_normals(*made[:20], made[20]), _pairs(20, "0.99")),
]  # fmt: skip
