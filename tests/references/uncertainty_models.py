"""The laws of results: what is known of each model's distribution, from the laws of its inputs."""

from math import factorial, inf, prod
from typing import Any

from uncertainty_laws import (
    Input,
    Law,
    Lognormal,
    Normal,
    Readings,
    Truncated,
    Uniform,
    by_survival,
    lognormal,
    normal,
    root,
)
from uncertainty_numbers import density, integral, number, phi, pi, real, score, special, total

G2 = 2 * number(9.80665)


def skid(mu: Input, d: Input) -> Law:
    """√(2gμd): P = E(P(μ ≤ w²/(2gd))); expectations of roots multiply."""

    def cdf(w: Any) -> Any:
        # a bounded friction bends where w²/(2gd) leaves its interval, or passes its mode
        ends = (mu.low, getattr(mu, "mode", mu.low), mu.high)
        kinks = [w * w / (G2 * end) for end in sorted(set(ends)) if 0 < end < inf]
        return d.expect(lambda x: mu.cdf(w * w / (G2 * x)), kinks)

    def moments() -> tuple[Any, Any]:
        def positive(x: Any) -> Any:
            return real.sqrt(max(x, number(0)))

        first = real.sqrt(G2) * mu.expect(positive) * d.expect(positive)
        return first, G2 * mu.expect(lambda x: x) * d.expect(lambda x: x)

    return Law(cdf, (number(2), number(40)), moments)


def root_of(x: Normal) -> Any:
    """E√max(x, 0), by a parabolic cylinder function."""
    k = x.mean / x.std
    cylinder = special("pcfd", number(-1.5), -k)
    return real.sqrt(x.std) * real.exp(-k * k / 4) * special("gamma", 1.5) / real.sqrt(2 * pi()) * cylinder


def root_where_it_is(x: Normal) -> Law:
    """√x of what is not negative: the law of the admissible cases."""
    none = phi(-x.mean / x.std)
    there = 1 - none
    return Law(
        lambda w: None,
        (0, 0),
        lambda: (root_of(x) / there, part_of(x) / there),
        lambda p: real.sqrt(x.mean + x.std * score(none + p * there)),
    )


def part_of(x: Normal) -> Any:
    """E max(x, 0)."""
    return x.mean * phi(x.mean / x.std) + x.std * density(x.mean / x.std)


def skid_of_normals(mu: Normal, d: Normal, rho: Any = 0) -> Law:
    """The same with normal inputs, correlated or not, none of them below zero: friction given the length is normal."""
    rest = real.sqrt(1 - number(rho) * rho)

    def given(t: Any) -> Any:
        return mu.mean + rho * mu.std * t

    unit = Normal("0", "1")

    def below(w: Any, t: Any) -> Any:
        length = d.mean + d.std * t
        return phi((w * w / (G2 * length) - given(t)) / (mu.std * rest)) if length > 0 else number(1)

    def cdf(w: Any) -> Any:
        return unit.expect(lambda t: below(w, t), finer=2)

    def moments() -> tuple[Any, Any]:
        if not rho:
            return real.sqrt(G2) * root_of(mu) * root_of(d), G2 * part_of(mu) * part_of(d)
        inner = mu.std * rest

        def of_roots(t: Any) -> Any:
            length = real.sqrt(max(d.mean + d.std * t, number(0)))
            return length * unit.expect(lambda u: real.sqrt(max(given(t) + inner * u, number(0))))

        return real.sqrt(G2) * unit.expect(of_roots), G2 * (mu.mean * d.mean + rho * mu.std * d.std)

    return Law(cdf, (number(2), number(40)), moments)


def products(*made: Any) -> Law:
    """The product of lognormals; correlated alike, if the last argument is a number."""
    rho = made[-1] if not isinstance(made[-1], Lognormal) else number(0)
    factors = [one for one in made if isinstance(one, Lognormal)]
    widths = total(one.width for one in factors)
    squares = total(one.width**2 for one in factors)
    return lognormal(total(one.centre for one in factors), squares + rho * (widths**2 - squares))


def skid_of_lognormals(mu: Lognormal, d: Lognormal, rho: Any = 0) -> Law:
    """√(2gμd) of lognormals is lognormal."""
    variance = mu.width**2 + d.width**2 + 2 * rho * mu.width * d.width
    return lognormal((real.log(G2) + mu.centre + d.centre) / 2, variance / 4)


def largest(*made: Input) -> Law:
    """P(max ≤ w) is the product of the distribution functions."""
    low = max(one.mean - 15 * one.std if isinstance(one, Normal) else one.low for one in made)
    high = max(one.mean + 15 * one.std if isinstance(one, Normal) else one.high for one in made)

    def cdf(w: Any) -> Any:
        return prod(one.cdf(w) for one in made)

    inside = sorted(x for one in made for x in (one.low, one.high) if low < x < high)
    step = (high - low) / 8
    places = [low, *inside, high] if inside else [low + k * step for k in range(9)]
    return Law(cdf, (low, high), by_survival(cdf, places))


def largest_of_normals(a: Normal, b: Normal, rho: Any) -> Law:
    """Clark's moments; P by Plackett's identity, an integral over correlations up to this one."""

    def cdf(w: Any) -> Any:
        h, k = (w - a.mean) / a.std, (w - b.mean) / b.std

        def grown(theta: Any) -> Any:
            c, s = real.cos(theta), real.sin(theta)
            return real.exp((h * k * s - (h * h + k * k) / 2) / (c * c))

        return phi(h) * phi(k) + integral(grown, [number(0), real.asin(rho)]) / (2 * pi())

    def moments() -> tuple[Any, Any]:
        spread = real.sqrt(a.std**2 + b.std**2 - 2 * rho * a.std * b.std)
        k = (a.mean - b.mean) / spread
        first = a.mean * phi(k) + b.mean * phi(-k) + spread * density(k)
        second = (a.mean**2 + a.std**2) * phi(k) + (b.mean**2 + b.std**2) * phi(-k)
        return first, second + (a.mean + b.mean) * spread * density(k)

    return Law(cdf, (number(-8), number(12)), moments)


def smallest(*made: Uniform) -> Law:
    """P(min ≤ w) is one less the product of what lies above."""
    low, high = min(one.low for one in made), min(one.high for one in made)

    def cdf(w: Any) -> Any:
        return 1 - prod(1 - one.cdf(w) for one in made)

    places = sorted({low, high, *(one.low for one in made if low < one.low < high)})
    return Law(cdf, (low, high), by_survival(cdf, places))


def apart(a: Normal, b: Normal) -> Law:
    """|a − b| is folded normal."""
    return folded(a.mean - b.mean, real.sqrt(a.std**2 + b.std**2))


def folded(mean: Any, std: Any) -> Law:
    """The absolute value of a normal number."""
    first = std * real.sqrt(2 / pi()) * real.exp(-((mean / std) ** 2) / 2) + mean * (1 - 2 * phi(-mean / std))
    return Law(
        lambda w: phi((w - mean) / std) - phi((-w - mean) / std),
        (number(0), abs(mean) + 10 * std),
        lambda: (first, mean**2 + std**2),
    )


def positive_part(x: Normal) -> Law:
    """max(x, 0): an atom at zero."""
    m, s = x.mean, x.std
    k = m / s
    return Law(
        lambda w: x.cdf(w),
        (number(0), m + 10 * s),
        lambda: (m * phi(k) + s * density(k), (m * m + s * s) * phi(k) + m * s * density(k)),
        lambda p: max(x.quantile(p), number(0)),
    )


def square(x: Normal) -> Law:
    """x²: two branches that meet at zero."""
    m, s = x.mean, x.std
    return Law(
        lambda w: phi((real.sqrt(w) - m) / s) - phi((-real.sqrt(w) - m) / s),
        (number(0), (abs(m) + 10 * s) ** 2),
        lambda: (m * m + s * s, m**4 + 6 * m * m * s * s + 3 * s**4),
    )


def squares(*made: Normal) -> Law:
    """The sum of squares of n equal centred normals is s² times chi-squared."""
    n, s2 = number(len(made)), made[0].std ** 2
    return Law(
        lambda w: special("gammainc", n / 2, 0, w / (2 * s2), regularized=True),
        (number(0), 20 * n * s2),
        lambda: (n * s2, (n * n + 2 * n) * s2**2),
    )


def radius(*made: Normal) -> Law:
    """The length of a centred isotropic normal vector."""
    n, s = number(len(made)), made[0].std
    return Law(
        lambda w: special("gammainc", n / 2, 0, (w / s) ** 2 / 2, regularized=True),
        (number(0), 12 * s),
        lambda: (s * real.sqrt(2) * special("gamma", (n + 1) / 2) / special("gamma", n / 2), n * s * s),
    )


def rice(x: Normal, y: Normal) -> Law:
    """The length of (x, y) about a point away from the origin, both of one deviation."""
    v, s = real.sqrt(x.mean**2 + y.mean**2), x.std

    u = v * v / (2 * s * s)

    def cdf(w: Any) -> Any:
        # Poisson's mixture of chi-squared distributions
        terms = (
            u**k / factorial(k) * special("gammainc", k + 1, 0, w * w / (2 * s * s), regularized=True)
            for k in range(80)
        )
        return real.exp(-u) * total(terms)

    bessel = (1 + u) * special("besseli", 0, u / 2) + u * special("besseli", 1, u / 2)
    first = s * real.sqrt(pi() / 2) * real.exp(-u / 2) * bessel
    return Law(cdf, (number(0), v + 10 * s), lambda: (first, v * v + 2 * s * s))


def product_of_uniforms(*made: Uniform) -> Law:
    """−ln of a product of n uniforms on (0, 1) is Gamma of order n."""
    n = len(made)
    return Law(
        lambda w: special("gammainc", n, -real.log(w), inf, regularized=True) if w > 0 else number(0),
        (number(0), number(1)),
        lambda: (number(2) ** -n, number(3) ** -n),
        lambda p: real.exp(
            -root(lambda t: special("gammainc", n, 0, t, regularized=True) - (1 - p), (number(0), number(60)))
        ),
    )


def quotient_of_uniforms(a: Uniform, b: Uniform) -> Law:
    """Lengths of chords: P(a ≤ w·b) = E(F(w·b)), a piecewise rational function."""

    def cdf(w: Any) -> Any:
        return b.expect(lambda x: a.cdf(w * x), [a.low / w, a.high / w])

    mean, square = (a.low + a.high) / 2, (a.low**2 + a.low * a.high + a.high**2) / 3
    inverse = real.log(b.high / b.low) / (b.high - b.low)
    return Law(cdf, (a.low / b.high, a.high / b.low), lambda: (mean * inverse, square / (b.low * b.high)))


def sum_of_two(a: Input, b: Input) -> Law:
    """P = E(P(a ≤ w − b)), b the one of bounds."""

    def cdf(w: Any) -> Any:
        return b.expect(lambda x: a.cdf(w - x), [w - end for end in (a.low, a.high) if abs(end) < inf])

    def moments() -> tuple[Any, Any]:
        first = [one.expect(lambda x: x) for one in (a, b)]
        second = [one.expect(lambda x: x * x) for one in (a, b)]
        return first[0] + first[1], second[0] + second[1] + 2 * first[0] * first[1]

    low = (a.low if a.low > -inf else a.quantile(number(10) ** -20)) + b.low
    high = (a.high if a.high < inf else a.quantile(1 - number(10) ** -20)) + b.high
    return Law(cdf, (low, high), moments)


def product_of_two(a: Normal, b: Input) -> Law:
    """P = E(P(a ≤ w/b)), b above zero."""

    def moments() -> tuple[Any, Any]:
        first, second = b.expect(lambda x: x), b.expect(lambda x: x * x)
        return a.mean * first, (a.mean**2 + a.std**2) * second

    return Law(lambda w: b.expect(lambda x: a.cdf(w / x)), (number(-50), number(50)), moments)


def product_about_zero(a: Normal, b: Normal) -> Law:
    """The product of centred normals, infinitely dense at zero: P(> w) = (1/π)·∫ exp(−w·cosh t)/cosh t dt, t > 0."""
    scale = a.std * b.std

    def upper(w: Any) -> Any:
        return (
            integral(lambda t: real.exp(-w / scale * real.cosh(t)) / real.cosh(t), [number(0), number(3), number(9)])
            / pi()
        )

    def quantile(p: Any) -> Any:
        if p == number(1) / 2:
            return number(0)
        tail = min(p, 1 - p)
        found = root(lambda w: tail - upper(w), (number(0.1) * scale, 9 * scale))
        return found if p > tail else -found

    return Law(lambda w: None, (0, 0), lambda: (number(0), scale**2), quantile)


def quotient(a: Normal, b: Truncated) -> Law:
    """P(a ≤ w·b) = E(F(w·b)), the divisor bounded away from zero."""

    def moments() -> tuple[Any, Any]:
        return a.mean * b.expect(lambda x: 1 / x), (a.mean**2 + a.std**2) * b.expect(lambda x: 1 / x**2)

    return Law(lambda w: b.expect(lambda x: a.cdf(w * x)), (number(-20), number(20)), moments)


def sum_of_normals(*made: Any) -> Law:
    """Normal; all pairs correlated alike, if the last argument is a number."""
    terms = [one for one in made if isinstance(one, Normal)]
    rho = made[-1] if not isinstance(made[-1], Normal) else number(0)
    together, squares_ = total(one.std for one in terms), total(one.std**2 for one in terms)
    return normal(total(one.mean for one in terms), squares_ + rho * (together**2 - squares_))


def difference_of_normals(a: Normal, b: Normal, rho: Any) -> Law:
    """Nearly all of the variance cancels."""
    return normal(a.mean - b.mean, (a.std - b.std) ** 2 + 2 * (1 - rho) * a.std * b.std)


def sine_of_half_turn(x: Uniform) -> Law:
    """sin x over half a turn: two branches that meet at the greatest value."""
    return Law(
        lambda w: 2 * real.asin(w) / x.high,
        (number(0), number(1)),
        lambda: ((1 - real.cos(x.high)) / x.high, (x.high / 2 - real.sin(2 * x.high) / 4) / x.high),
        lambda p: real.sin(p * x.high / 2),
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
        lambda w: x.cdf(real.sqrt(w)) - x.cdf(-real.sqrt(w)),
        (number(0), (60 * x.scale) ** 2),
        lambda: (x.moment(2), x.moment(4)),
    )
