"""The normal distribution for one number at a time: lower and upper tail, density and quantile, without numpy.

Both tails keep their relative accuracy out to where they underflow; for arrays see `normal_arrays`.
"""

import math

ROOT_TWO = 1.4142135623730951
# √2 is ROOT_TWO plus this.
_ROOT_TWO_REST = -9.667293313452913e-17
_DENSITY_AT_ZERO = 0.3989422804014327
# Veltkamp's constant splits a double into two halves of 26 bits.
_SPLITTER = 134217729.0


def upper(z: float) -> float:
    """P(Z > z) of a standard normal Z.

    References
    ----------
    P(Z > z) = ½ erfc(z/√2): NIST Digital Library of Mathematical Functions, section 7.18.
    """
    x = z / ROOT_TWO
    if abs(x) < 1.0:
        return 0.5 * math.erfc(x)
    if x > 30.0:
        return 0.0
    # A relative error ε of x becomes 2x²ε of its tail: the rounding of the division is corrected to first order.
    rest = _quotient_rest(z, x)
    tail = math.erfc(x)
    return 0.5 * (tail - rest * 1.1283791670955126 * math.exp(-x * x))


def lower(z: float) -> float:
    """P(Z ≤ z) of a standard normal Z."""
    return upper(-z)


def density(z: float) -> float:
    """The standard normal density."""
    if abs(z) > 39.0:
        return 0.0
    high = math.floor(z * 16.0 + 0.5) / 16.0
    return _DENSITY_AT_ZERO * math.exp(-0.5 * high * high) * math.exp(-0.5 * (z - high) * (z + high))


def quantile(p: float) -> float:
    """The z below which a standard normal variable is with probability p, 0 < p < 1; near 1 use −quantile(1 − p).

    References
    ----------
    M. J. Wichura, Algorithm AS 241, Appl. Statist. 37 (1988) 477, and one Newton step.
    """
    if not 0.0 < p < 1.0:
        if p in (0.0, 1.0):
            return -math.inf if p == 0.0 else math.inf
        raise ValueError(f"{p} is not a probability between 0 and 1")
    z = _first_quantile(p)
    if abs(p - 0.5) < 0.425:
        return z
    # One step of Newton on the logarithm of the tail, which is nearly a parabola.
    tail, target = (lower(z), p) if z < 0.0 else (upper(z), 1.0 - p)
    if target < 1e-300:
        return z
    step = (tail - target) / density(z)
    return z - step if z < 0.0 else z + step


def _quotient_rest(z: float, x: float) -> float:
    """The rounding error of x = z/ROOT_TWO against z/√2."""
    big = _SPLITTER * x
    high = big - (big - x)
    low = x - high
    product = x * ROOT_TWO
    split = _SPLITTER * ROOT_TWO
    head = split - (split - ROOT_TWO)
    tail = ROOT_TWO - head
    lost = low * tail - (((product - high * head) - low * head) - high * tail)
    return ((z - product) - lost - x * _ROOT_TWO_REST) / ROOT_TWO


# Wichura's algorithm AS 241, PPND16 (Applied Statistics 37, 1988): rational functions within 1e-16 of the quantile.
CENTRE = (
    (3.3871328727963666080e0, 1.3314166789178437745e2, 1.9715909503065514427e3, 1.3731693765509461125e4,
     4.5921953931549871457e4, 6.7265770927008700853e4, 3.3430575583588128105e4, 2.5090809287301226727e3),
    (1.0, 4.2313330701600911252e1, 6.8718700749205790830e2, 5.3941960214247511077e3,
     2.1213794301586595867e4, 3.9307895800092710610e4, 2.8729085735721942674e4, 5.2264952788528545610e3),
)  # fmt: skip
NEAR = (
    (1.42343711074968357734e0, 4.63033784615654529590e0, 5.76949722146069140550e0, 3.64784832476320460504e0,
     1.27045825245236838258e0, 2.41780725177450611770e-1, 2.27238449892691845833e-2, 7.74545014278341407640e-4),
    (1.0, 2.05319162663775882187e0, 1.67638483018380384940e0, 6.89767334985100004550e-1,
     1.48103976427480074590e-1, 1.51986665636164571966e-2, 5.47593808499534494600e-4, 1.05075007164441684324e-9),
)  # fmt: skip
FAR = (
    (6.65790464350110377720e0, 5.46378491116411436990e0, 1.78482653991729133580e0, 2.96560571828504891230e-1,
     2.65321895265761230930e-2, 1.24266094738807843860e-3, 2.71155556874348757815e-5, 2.01033439929228813265e-7),
    (1.0, 5.99832206555887937690e-1, 1.36929880922735805310e-1, 1.48753612908506148525e-2,
     7.86869131145613259100e-4, 1.84631831751005468180e-5, 1.42151175831644588870e-7, 2.04426310338993978564e-15),
)  # fmt: skip


def _first_quantile(p: float) -> float:
    q = p - 0.5
    if abs(q) <= 0.425:
        return q * _ratio(CENTRE, 0.180625 - q * q)
    r = math.sqrt(-math.log(p if q < 0.0 else 1.0 - p))
    z = _ratio(NEAR, r - 1.6) if r <= 5.0 else _ratio(FAR, r - 5.0)
    return -z if q < 0.0 else z


def _ratio(rational: "tuple[tuple[float, ...], tuple[float, ...]]", x: float) -> float:
    over, under = rational
    numerator = denominator = 0.0
    for a, b in zip(reversed(over), reversed(under), strict=True):
        numerator = numerator * x + a
        denominator = denominator * x + b
    return numerator / denominator
