"""Planar impacts followed event by event in many digits: an account of the path that knows no closed form.

The march knows nothing of phases: from the present velocity it asks which way the contact slips or whether friction
can hold it, goes straight to the next event (slip stops, compression ends, the law's end is reached), and asks again.
Doubles become mpmath's numbers; those of gmpy2 stay what they are.
"""

from math import inf

from mpmath import mpf


def exactly(*numbers):
    """The numbers in many digits."""
    return [mpf(number) if isinstance(number, (int, float)) else number for number in numbers]


def friction_ratio(kt, kx, ut, mu):
    """dp_t/dp_n now."""
    if ut > 0:
        return -mu
    if ut < 0:
        return mu
    if abs(kx) <= mu * kt:
        return -kx / kt
    return -mu if kx > 0 else mu


def follow(kt, kx, kn, ut, un, mu, e, law):
    """The whole impact; a dictionary of its end."""
    kt, kx, kn, ut, un, mu, e = exactly(kt, kx, kn, ut, un, mu, e)
    u0, zero = un, 0 * un
    p = pt = work = rubbed = restoring = zero
    compression = first_slip = None
    phase = "compression"
    states = []
    if ut == 0:
        first_slip = p
    for _ in range(12):
        c = friction_ratio(kt, kx, ut, mu)
        # what sticks stays: the rounding of k_x/k_t is no slip
        held = ut == 0 and abs(kx) <= mu * kt
        dn, dt = kn + kx * c, zero if held else kt * c + kx
        way = "stick" if ut == 0 and dt == 0 else ("+" if ut > 0 or (ut == 0 and dt > 0) else "-")
        if not states or states[-1] != way:
            states.append(way)
        slip_left = -ut / dt if ut * dt < 0 else inf
        if phase == "compression":
            ahead = -un / dn if dn > 0 else inf
        elif law == "newton":
            ahead = (-e * u0 - un) / dn if dn > 0 else inf
        elif law == "poisson":
            ahead = (1 + e) * compression - p
        else:
            left = e * e * work - restoring
            square = un * un + 2 * dn * left
            ahead = inf if square < 0 or (dn <= 0 and un <= 0) else zero
            if left > 0 and ahead == 0:
                ahead = 2 * left / (un + square**0.5)
        step = min(slip_left, ahead)
        if step == inf:
            raise ArithmeticError("no event is ahead")
        done = step * (un + dn * step / 2)
        rub = -c * step * (ut + dt * step / 2)
        rubbed += rub
        if phase == "compression":
            work -= done
        else:
            restoring += done
        p, pt = p + step, pt + c * step
        un, ut = un + dn * step, (zero if step == slip_left else ut + dt * step)
        if step == slip_left:
            if first_slip is None:
                first_slip = p
            if step != ahead:
                continue
        if phase == "compression":
            un, compression, phase = zero, p, "restitution"
            if e == 0:
                break
        else:
            break
    else:
        raise AssertionError("no end")
    return {
        "normal": p, "tangential": pt, "compression": compression,
        "normal_after": un, "tangential_after": ut, "compression_work": work, "restitution_work": restoring,
        "friction_work": rubbed, "states": states,
        "slip_impulse": p if first_slip is None or mu == 0 else first_slip,
    }  # fmt: skip


def solve2(a, b, c, d, x, y):
    """Solve [[a, b], [c, d]] (p, q) = (x, y)."""
    det = a * d - b * c
    return (d * x - b * y) / det, (a * y - c * x) / det


def brach(kt, kx, kn, ut, un, mu, e):
    """Impulse ratio capped at μ; None where the ratio leaves no push."""
    kt, kx, kn, ut, un, mu, e = exactly(kt, kx, kn, ut, un, mu, e)
    pt, pn = solve2(kt, kx, kx, kn, -ut, -(1 + e) * un)
    if abs(pt) > mu * pn or pn <= 0:
        ratio = mu if (pt >= 0) == (pn >= 0) else -mu
        pn = -(1 + e) * un / (kn + kx * ratio)
        pt = ratio * pn
    return pt, pn


def kudlich_slibar(kt, kx, kn, ut, un, mu, e):
    """One ratio for both components, the sliding impact at the limit of friction."""
    kt, kx, kn, ut, un, mu, e = exactly(kt, kx, kn, ut, un, mu, e)
    pt, pn = solve2(kt, kx, kx, kn, -ut, -un)
    if abs(pt) > mu * pn or pn <= 0:
        ratio = mu if (pt >= 0) == (pn >= 0) else -mu
        pn = -un / (kn + kx * ratio)
        pt = ratio * pn
    return (1 + e) * pt, (1 + e) * pn
