"""Writes stability_roots.json: counts, roots, critical gains, delays, eigenvalues and equilibria to 40 digits.

Polynomials are products of factors whose roots mpmath's simultaneous iteration finds one by one, and are counted by
their real parts; the program counts by chains of Sturm and finds roots of what was multiplied out. Critical gains come
from Im(p(iω)·q(−iω)) = 0, delays from Newton's method on p(iω) + q(iω)·e^(−iωτ) = 0, eigenvalues from QR, equilibria
from Newton's method with slopes derived by hand.
Run: python tests/references/generate_stability_roots_references.py [FILE]. The same bytes every time.
"""

import random
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise, zip_longest
from typing import Any

from case_files import Case, write
from mpmath import acos, arg, cos, exp, findroot, im, matrix, mp, mpc, mpf, nstr, pi, polyroots, polyval, re, sin, sqrt
from stability_cases import CIRCLES, DELAYS, GAINS, MATRICES, PIECES, POLYNOMIALS, Factor, Rows

mp.dps = 110
ABOUT = (
    "Written by generate_stability_roots_references.py: coefficients exact as typed, elements as doubles, results to "
    "40 digits from 110-digit arithmetic."
)
RANDOM = random.Random(1877)
# Of 110 digits, what is left of a zero.
NONE = mpf("1e-60")


def exact(text: str) -> Any:
    return mpf(float(text))


def fractions(text: str) -> list[Fraction]:
    return [Fraction(part.strip()) for part in text.split(",")]


def mpfs(numbers: Sequence[Fraction]) -> list[Any]:
    return [mpf(x.numerator) / x.denominator for x in numbers]


def multiplied(one: Sequence[Fraction], two: Sequence[Fraction]) -> list[Fraction]:
    out = [Fraction(0)] * (len(one) + len(two) - 1)
    for i, a in enumerate(one):
        for j, b in enumerate(two):
            out[i + j] += a * b
    return out


def product(factors: Sequence[Factor]) -> list[Fraction]:
    out = [Fraction(1)]
    for text, times in factors:
        for _ in range(times):
            out = multiplied(out, fractions(text))
    return out


def typed(numbers: Sequence[Fraction]) -> dict[str, str]:
    return {"word": ", ".join(map(str, numbers))}


def clean(z: Any) -> Any:
    return mpc(*(mpf(0) if abs(part) < NONE * (1 + abs(z)) else part for part in (re(z), im(z))))


def roots_of(numbers: Sequence[Fraction]) -> list[Any]:
    with mp.workdps(160):
        return [clean(z) for z in polyroots(mpfs(numbers), maxsteps=5000, extraprec=4000)]


def with_times(factors: Sequence[Factor]) -> list[tuple[Any, int]]:
    """The roots of a product, each with its multiplicity, the rightmost first; of pairs the upper one."""
    pairs = [(z, times) for text, times in factors for z in roots_of(fractions(text))]
    return sorted(pairs, key=lambda pair: (-mpf(nstr(re(pair[0]), 60)), im(pair[0])))


def sides(pairs: Sequence[tuple[Any, int]], size: Any = re) -> tuple[int, int, int]:
    left = sum(times for z, times in pairs if size(z) < 0)
    right = sum(times for z, times in pairs if size(z) > 0)
    return left, right, sum(times for _, times in pairs) - left - right


def listed(name: str, roots: Sequence[Any]) -> dict[str, Any]:
    upper = [z for z in roots if im(z) >= 0]
    return {
        f"{name}[{k}].{part}": value
        for k, z in enumerate(upper)
        for part, value in (("real", re(z)), ("imaginary", im(z)))
    }


def counted(pairs: Sequence[tuple[Any, int]]) -> dict[str, Any]:
    return dict(zip(("left", "right", "axis"), map(mpf, sides(pairs)), strict=True))


def polynomials() -> Iterator[Case]:
    drawn = []
    for nth in range(16):
        chosen = RANDOM.sample(PIECES, RANDOM.randint(2, 5))
        why = "" if nth < 8 else "a factor comes twice: double roots, which rounding parts"
        drawn.append((f"drawn {nth}", [(piece, 2 if why and not k else 1) for k, piece in enumerate(chosen)], why))
    for name, factors, why in [*POLYNOMIALS, *drawn]:
        pairs = with_times(factors)
        top = [z for z, _ in pairs]
        results = {**counted(pairs), "rightmost": re(top[0]), **listed("roots", top)}
        yield "routh", name, why, {"polynomial": typed(product(factors))}, results


def samples() -> Iterator[Case]:
    pieces = ("1, -1.5, 0.7", "1, 0.4", "1, -1.25", "1, 0.2, 0.9", "1, 0", "2, 1", "1, -1, 1.3")
    drawn = []
    for nth in range(6):
        chosen = RANDOM.sample(pieces, RANDOM.randint(2, 4))
        drawn.append((f"drawn {nth}", [(piece, 1) for piece in chosen], ""))
    for name, factors, why in [*CIRCLES, *drawn]:
        pairs = with_times(factors)

        def beyond(z: Any) -> Any:
            off = abs(z) - 1
            return mpf(0) if abs(off) < NONE else off

        inside, outside, circle = sides(pairs, beyond)
        results = {"inside": mpf(inside), "outside": mpf(outside), "circle": mpf(circle)}
        results["largest"] = 1 + max(beyond(z) for z, _ in pairs)
        yield "discrete", name, why, {"polynomial": typed(product(factors))}, results


def intervals() -> Iterator[Case]:
    cases = [
        ("third order", "1, 2..3, 3..4, 1..5", ""), ("too wide", "1, 2..3, 3..4, 1..7", ""),
        ("fourth order", "1, 3..4, 5..6, 4..5, 1..2", ""), ("fifth order", "1, 2..3, 6..7, 4..5, 3..4, 0.5..1", ""),
        ("at the limit", "1, 2..3, 3..4, 1..6", "one of the four has a pair on the axis: 2·3 = 6"),
        ("past the limit", "1, 2..3, 3..4, 1..6.0000000001", "one of the four polynomials is unstable by 1e-11"),
    ]  # fmt: skip
    for name, text, why in cases:
        ends = [fractions(part.strip().replace("..", ",")) for part in text.split(",")][::-1]
        results: dict[str, Any] = {}
        rights = []
        for k, pattern in enumerate(("llhh", "hhll", "hllh", "lhhl")):
            corner = [pair[0 if pattern[i % 4] == "l" else -1] for i, pair in enumerate(ends)]
            counts = counted([(z, 1) for z in roots_of(corner[::-1])])
            rights.append(counts["right"])
            results |= {f"corners[{k}].{side}": count for side, count in counts.items()}
        yield "interval", name, why, {"coefficients": {"word": text}}, {**results, "worst_right": max(rights)}


def at_gain(p: Sequence[Fraction], q: Sequence[Fraction], gain: Any) -> list[tuple[Any, int]]:
    mixed = [a + gain * b for a, b in zip_longest(mpfs(p)[::-1], mpfs(q)[::-1], fillvalue=mpf(0))][::-1]
    while not abs(mixed[0]) > NONE:
        mixed.pop(0)
    with mp.workdps(160):
        return [(clean(z), 1) for z in polyroots(mixed, maxsteps=5000, extraprec=4000)]


def criticals(p: Sequence[Fraction], q: Sequence[Fraction]) -> dict[Any, Any]:
    """Frequencies by critical gain: where p(iω)/q(iω) is real."""
    # over ω: the coefficient of ω^k is that of s^k times i^k
    turn = (1, 1, -1, -1)
    parts = [
        [c * turn[k % 4] * (k % 2 == odd) for k, c in enumerate(reversed(numbers))][::-1]
        for numbers in (p, q)
        for odd in (0, 1)
    ]
    one, two = multiplied(parts[1], parts[2]), multiplied(parts[0], parts[3])
    width = max(len(one), len(two))
    numbers = [
        a - b
        for a, b in zip([0] * (width - len(one)) + one, [0] * (width - len(two)) + two, strict=True)
    ]  # fmt: skip
    while not numbers[0]:
        numbers.pop(0)
    found: dict[Any, Any] = {}
    for root in roots_of(numbers):
        if im(root) or re(root) < 0:
            continue
        below = polyval(mpfs(q), mpc(0, re(root)))
        if abs(below) > NONE:
            gain = re(-polyval(mpfs(p), mpc(0, re(root))) / below)
            found[gain if abs(gain) > NONE else mpf(0)] = re(root)
    return found


def gains() -> Iterator[Case]:
    for name, text, over, under, why in GAINS:
        p, q = product(over), product(under)
        found = sorted(criticals(p, q).items())
        results: dict[str, Any] = {}
        marks = [gain for gain, _ in found]
        for k, (gain, frequency) in enumerate(found):
            results |= {f"critical[{k}].gain": gain, f"critical[{k}].frequency": frequency}
        between = [marks[0] - 1, *((a + b) / 2 for a, b in pairwise(marks)), marks[-1] + 1]
        for k, gain in enumerate(between):
            left, right, axis = sides(at_gain(p, q, gain))
            results |= {f"ranges[{k}].left": mpf(left), f"ranges[{k}].right": mpf(right)}
            assert not axis
        yield "gain", name, why, {"polynomial": {"word": text}}, results


def delays() -> Iterator[Case]:
    for name, first, second, why in DELAYS:
        p, q = mpfs(fractions(first)), mpfs(fractions(second))

        def loop(omega: Any, delay: Any, p: list[Any] = p, q: list[Any] = q) -> list[Any]:
            z = mpc(0, omega)
            value = polyval(p, z) + polyval(q, z) * exp(-z * delay)
            return [re(value), im(value)]

        def size(x: Any, p: list[Any] = p, q: list[Any] = q) -> Any:
            return abs(polyval(p, mpc(0, x))) ** 2 - abs(polyval(q, mpc(0, x))) ** 2

        # signs over a fine range of frequencies, then both equations at once
        close = "touching" in name
        steps = [mpf("0.95") + mpf(k) / 100000 if close else mpf(k) / 200 for k in range(1, 1500)]
        with mp.workdps(30):
            signs = [size(x) > 0 for x in steps]
        found = []
        for k, (before, after) in enumerate(pairwise(signs)):
            if before != after:
                omega = findroot(size, (steps[k], steps[k + 1]), solver="anderson", tol=mpf("1e-80"))
                z = mpc(0, omega)
                start = arg(-polyval(q, z) / polyval(p, z)) / omega
                omega, delay = findroot(loop, (omega, start), tol=mpf("1e-150"))
                found.append((omega, delay + (0 if delay > 0 else 2 * pi / omega)))
        results = {"first_unstable": min(delay for _, delay in found)}
        for k, (omega, delay) in enumerate(reversed(found)):
            results |= {f"crossings[{k}].frequency": omega, f"crossings[{k}].first": delay}
            results[f"crossings[{k}].spacing"] = 2 * pi / omega
        inputs = {"polynomial": {"word": first}, "delayed": {"word": second}}
        yield "delay", name, why, inputs, results


def drawn_rows(size: int) -> Rows:
    return [[repr(round(RANDOM.uniform(-3, 3) - 2 * (i == j), 2)) for j in range(size)] for i in range(size)]


def first_order(given: dict[str, Rows]) -> Any:
    rows = {name: matrix([[exact(cell) for cell in row] for row in cells]) for name, cells in given.items()}
    if "matrix" in rows:
        return rows["matrix"]
    size = rows["mass"].rows
    rates = rows.get("damping", matrix(size)) + rows.get("gyroscopic", matrix(size))
    whole = matrix(2 * size)
    for i in range(size):
        whole[i, size + i] = 1
        for j in range(size):
            # the mass matrices are diagonal
            whole[size + i, j] = -rows["stiffness"][i, j] / rows["mass"][i, i]
            whole[size + i, size + j] = -rates[i, j] / rows["mass"][i, i]
    return whole


def matrices() -> Iterator[Case]:
    drawn = [(f"drawn {n} by {n}, {k}", {"matrix": drawn_rows(n)}, "") for n in (2, 3, 4, 5) for k in range(2)]
    for name, given, why in [*MATRICES, *drawn]:
        found = [clean(z) for z in mp.eig(first_order(given), left=False, right=False)]
        found = sorted(found, key=lambda z: (-mpf(nstr(re(z), 60)), im(z)))
        results = {**counted([(z, 1) for z in found]), "rightmost": re(found[0]), **listed("roots", found)}
        yield "matrix", name, why, dict(given), results


def flow(name: str, why: str, rates: dict[str, str], places: list[tuple[list[Any], list[list[Any]]]]) -> Case:
    """Equilibria with the slopes there, as derived by hand."""
    results: dict[str, Any] = {}
    for nth, (at, slopes) in enumerate(sorted(places, key=lambda place: place[0])):
        found = [clean(z) for z in mp.eig(matrix(slopes), left=False, right=False)]
        found = sorted(found, key=lambda z: (-mpf(nstr(re(z), 60)), im(z)))
        results |= {f"points[{nth}].at[{k}]": mpf(x) for k, x in enumerate(at)}
        results |= {f"points[{nth}].rightmost": re(found[0]), **listed(f"points[{nth}].roots", found)}
    states = [{"record": "State", "name": {"word": key}, "rate": {"word": text}} for key, text in rates.items()]
    return "equilibrium", name, why, {"states": states}, results


def double(text: str) -> Any:
    return mpf(float(text))


def flows() -> Iterator[Case]:
    damping = double("0.2")
    duffing = [([mpf(x), mpf(0)], [[0, 1], [1 - 3 * x * x, -damping]]) for x in (-1, 0, 1)]
    yield flow("double well", "", {"x": "v", "v": "x - x^3 - 0.2*v"}, duffing)
    small = double("0.000001")
    r = sqrt(small)
    fork = [([x, mpf(0)], [[0, 1], [small - 3 * x * x, -1]]) for x in (-r, mpf(0), r)]
    why = "just past a pitchfork: three equilibria within a thousandth"
    yield flow("pitchfork", why, {"x": "v", "v": "0.000001*x - x^3 - v"}, fork)
    root = sqrt(double("0.0001"))
    fold = [([x, mpf(0)], [[0, 1], [2 * x, -1]]) for x in (-root, root)]
    why = "just past a fold: two equilibria still close together"
    yield flow("fold", why, {"x": "v", "v": "x^2 - 0.0001 - v"}, fold)
    light = double("0.000000001")
    slow = [([mpf(0), mpf(0)], [[0, 1], [-4, -light]])]
    yield flow(
        "hardly damped", "a decay of 5e-10 beside a frequency of 2 rad/s", {"x": "v", "v": "-4*x - 0.000000001*v"}, slow
    )
    meeting = [([mpf(0), mpf(0)], [[-1, 1], [double("0.0000000000001"), -1]])]
    why = "slopes whose two roots all but meet"
    yield flow("all but defective", why, {"x": "y - x", "y": "0.0000000000001*x - y"}, meeting)
    yield from transcendental()


def transcendental() -> Iterator[Case]:
    """Places by Newton's method, and Lorenz's, whose z is 1 here."""
    third = mpf(8) / 3
    c = sqrt(third)
    lorenz = [([x, x, x * x / third], [[-10, 10, 0], [2 - x * x / third, -1, -x], [x, x, -third]]) for x in (-c, 0, c)]
    yield flow("Lorenz", "", {"x": "10*(y - x)", "y": "x*(2 - z) - y", "z": "x*y - 8/3*z"}, lorenz)
    light = double("0.05")
    angle = findroot(lambda x: sin(x) - x / 3, 2.2)
    held = [([x, mpf(0)], [[0, 1], [3 * cos(x) - 1, -light]]) for x in (-angle, mpf(0), angle)]
    yield flow("pendulum on a spring", "", {"x": "y", "y": "3*sin(x) - x - 0.05*y"}, held)
    level, share = double("0.3"), double("0.1")
    places = []
    for start in (-0.4, 0.9, 3.0):
        x = findroot(lambda x: x**2 * exp(-x) - level, start)
        slope = (2 * x - x * x) * exp(-x)
        places.append(([x, level], [[slope, -1], [slope * share, 1 - share]]))
    reactor = {"x": "x^2*exp(-x) - y", "y": "y - 0.3 - 0.2*(y - 0.3)^2 + 0.1*(x^2*exp(-x) - y)"}
    yield flow("reactor", "", reactor, places)


def hoops() -> Iterator[Case]:
    """A bead on a turning hoop: V = −m·g·r·cos θ − m·r²·w²·sin²θ/2 with m·g·r = 1 and m·r²·w² = c, inertia 1."""
    cases = [("1.5", ""), ("4", ""), ("1.000001", "just past the speed at which the bead leaves the bottom")]
    for text, why in cases:
        c = double(text)
        angle = acos(1 / c)
        places = [(-angle, True), (mpf(0), False), (angle, True), (pi, False)]
        results: dict[str, Any] = {"stable": mpf(2), "unstable": mpf(2)}
        for k, (at, stable) in enumerate(places):
            bend = cos(at) - c * (2 * cos(at) ** 2 - 1)
            results |= {f"places[{k}].angle": at, f"places[{k}].curvature": bend}
            results[f"places[{k}].energy"] = -cos(at) - c * (1 - cos(at) ** 2) / 2
            results[f"places[{k}].{'frequency' if stable else 'growth'}"] = (
                sqrt(bend) / (2 * pi) if stable else sqrt(-bend)
            )
        formula = {"record": "Formula", "text": {"word": f"-cos(theta) - {text}*sin(theta)^2/2"}, "factor": 1.0,
                   "unit": {"word": "J"}}  # fmt: skip
        yield "equilibrium", f"hoop {text}", why, {"potential": formula, "inertia": "1.0"}, results


def every() -> Iterator[Case]:
    for part in (polynomials, samples, intervals, gains, delays, matrices, flows, hoops):
        yield from part()


if __name__ == "__main__":
    write("stability_roots", ABOUT, every())
