"""Keller's equations of impact in space in many digits, by another way than the program: Gragg–Bulirsch–Stoer.

Steps of τ (dp_n = |u_t| dτ) are extrapolated from eleven midpoint rules; ends are found by secants within a step.
"""

from mpmath import mp, mpf, sqrt


def rates(k, mu, y):
    """d/dτ of u_1, u_2, u_n, p_1, p_2, p_n, normal work."""
    s = sqrt(y[0] * y[0] + y[1] * y[1])
    c = (-mu * y[0], -mu * y[1], s)
    u = [row[0] * c[0] + row[1] * c[1] + row[2] * c[2] for row in k]
    return [*u, *c, y[2] * s]


def midpoint(k, mu, y, h, parts):
    step = h / parts
    before, here = y, [a + step * b for a, b in zip(y, rates(k, mu, y), strict=True)]
    for _ in range(parts - 1):
        before, here = here, [a + 2 * step * b for a, b in zip(before, rates(k, mu, here), strict=True)]
    last = rates(k, mu, here)
    return [(a + b + step * c) / 2 for a, b, c in zip(before, here, last, strict=True)]


def step(k, mu, y, h, levels=11):
    """One extrapolated step."""
    table = []
    for level in range(1, levels + 1):
        row = [midpoint(k, mu, y, h, 2 * level)]
        for j in range(1, level):
            weight = (mpf(level) / (level - j)) ** 2 - 1
            row.append([a + (a - b) / weight for a, b in zip(row[-1], table[-1][j - 1], strict=True)])
        table.append(row)
    return table[-1][-1]


def march(k, mu, y, index, target, size):
    """Until y[index] reaches the target, or slip has stopped; whether it stopped."""
    # eleven midpoint rules at this step agree to more than twenty digits
    h = mpf(3) / 4 / (max(abs(x) for row in k for x in row) * (1 + mu))
    for _ in range(100000):
        if sqrt(y[0] * y[0] + y[1] * y[1]) < size * mpf(10) ** -21:
            return y, True
        new = step(k, mu, y, h)
        if new[index] >= target:
            low, high, part = mpf(0), h, h
            # secant within the step, from its start each time
            a, fa = mpf(0), y[index] - target
            b, fb = h, new[index] - target
            for _ in range(60):
                part = b - fb * (b - a) / (fb - fa)
                if not low <= part <= high:
                    part = (low + high) / 2
                new = step(k, mu, y, part)
                f = new[index] - target
                if f > 0:
                    high = part
                else:
                    low = part
                a, fa, b, fb = b, fb, part, f
                if abs(f) <= mpf(10) ** -24 * (abs(target) + abs(y[2])) or a == b or fa == fb:
                    return new, False
            raise AssertionError("no root")
        y = new
    raise AssertionError("no end")


def straight(k, mu, e, law, y, u0, compression, work, restoring):
    """From where slip has stopped."""
    det = k[0][0] * k[1][1] - k[0][1] ** 2
    c = ((k[0][1] * k[1][2] - k[1][1] * k[0][2]) / det, (k[0][1] * k[0][2] - k[0][0] * k[1][2]) / det)
    if c[0] ** 2 + c[1] ** 2 > mu**2:
        # the way out: the direction that its own rate keeps, by iterating the hodograph outward from rest
        g = mp.findroot(lambda g: _outward(k, mu, g)[2], (mpf("1e-6"), sqrt(k[0][2] ** 2 + k[1][2] ** 2)),
                        solver="anderson", tol=mpf(10) ** -55)  # fmt: skip
        x, z, _ = _outward(k, mu, g)
        c = -mu * x, -mu * z
    n = k[2][2] + k[0][2] * c[0] + k[1][2] * c[1]
    p, un, w = y[5], y[2], y[6]
    if not restoring:
        more = -un / n
        w = w + un * more / 2
        work, compression, p, un = -w, p + more, p + more, mpf(0)
    if law == "newton":
        rest = (-e * u0 - un) / n
    elif law == "poisson":
        rest = (1 + e) * compression - p
    else:
        left = e * e * work - (w + work)
        rest = (-un + sqrt(un * un + 2 * n * left)) / n
    total = p + rest - y[5]
    return (y[3] + c[0] * total, y[4] + c[1] * total, p + rest), compression


def _outward(k, mu, g):
    a, b, d = g + mu * k[0][0], mu * k[0][1], g + mu * k[1][1]
    det = a * d - b * b
    x, z = (d * k[0][2] - b * k[1][2]) / det, (a * k[1][2] - b * k[0][2]) / det
    return x, z, x * x + z * z - 1


def impact(k, u, mu, e, law):
    """Impulse in the frame of the contact, and p_n at the greatest compression."""
    k = [[mpf(x) for x in row] for row in k]
    mu, e = mpf(mu), mpf(e)
    y = [*map(mpf, u), mpf(0), mpf(0), mpf(0), mpf(0)]
    u0 = y[2]
    size = max(abs(u0), sqrt(y[0] ** 2 + y[1] ** 2))
    if y[0] == 0 and y[1] == 0:
        return straight(k, mu, e, law, y, u0, None, None, False)
    y, stopped = march(k, mu, y, 2, mpf(0), size)
    if stopped:
        return straight(k, mu, e, law, y, u0, None, None, False)
    compression, work = y[5], -y[6]
    if e == 0:
        return (y[3], y[4], y[5]), compression
    index, target = {"newton": (2, -e * u0), "poisson": (5, (1 + e) * compression)}.get(law, (6, (e * e - 1) * work))
    y, stopped = march(k, mu, y, index, target, size)
    if stopped:
        return straight(k, mu, e, law, y, u0, compression, work, True)
    return (y[3], y[4], y[5]), compression
