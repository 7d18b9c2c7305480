"""Derives the Chebyshev coefficients of dynamics_cli/numerics/distributions/normal_arrays.py with 60 digits.

With t = (x − K)/(x + K), the function (1 + 2x)·R(x), R(x) = Q(x)·exp(x²/2) the upper tail over its Gaussian factor, is
analytic on −1 ≤ t ≤ 1 (Shepherd & Laframboise 1981 do so for erfc), so one short polynomial in t serves every x ≥ 0.

    python tests/references/generate_normal_tables.py
"""

import mpmath as mp

mp.mp.dps = 60
K = mp.mpf("4.5")
TERMS = 80


def scaled_tail(x):
    """(1 + 2x) Q(x) exp(x²/2); its limit is 2/√(2π)."""
    if x > 60:
        series, term, k = mp.mpf(1), mp.mpf(1), 0
        while abs(term) > mp.mpf(10) ** -50 and k < 200:
            k += 1
            term *= -(2 * k - 1) / x**2
            series += term
        return (1 + 2 * x) / x * series / mp.sqrt(2 * mp.pi)
    return (1 + 2 * x) * mp.erfc(x / mp.sqrt(2)) / 2 * mp.exp(x * x / 2)


def chebyshev():
    nodes = [mp.cos(mp.pi * (2 * k + 1) / (2 * TERMS)) for k in range(TERMS)]
    values = [scaled_tail(K * (1 + t) / (1 - t)) for t in nodes]
    made = []
    for j in range(TERMS):
        total = sum(v * mp.cos(mp.pi * j * (2 * k + 1) / (2 * TERMS)) for k, v in enumerate(values))
        made.append(total * (2 if j else 1) / TERMS)
    return made


def monomials(coefficients):
    """The same polynomial by powers of t, converted with all digits kept."""
    before, now = [mp.mpf(1)], [mp.mpf(0), mp.mpf(1)]
    total = [mp.mpf(0)] * len(coefficients)
    for j, c in enumerate(coefficients):
        basis = before if j == 0 else now
        for i, b in enumerate(basis):
            total[i] += c * b
        if j >= 1:
            after = [mp.mpf(0)] + [2 * b for b in now]
            for i, b in enumerate(before):
                after[i] -= b
            before, now = now, after
    return total


if __name__ == "__main__":
    cheb = chebyshev()
    keep = next(j for j in range(TERMS) if max(abs(c) for c in cheb[j:]) < mp.mpf("3e-18"))
    print("terms", keep)
    for c in monomials(cheb[:keep]):
        print(f"    {float(c)!r},")
