"""Free motion of one mass from a displacement and a velocity, whatever its damping, and the response to a force."""

from dynamics_cli.numerics.elementary import absolute, cos, cosh, exp, sin, sinh, sqrt

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# Below this size of w·t² cosine and sine of √w·t are taken from one series, which needs no root of w.
SMALL, TERMS = 0.25, 9
# Beyond this e^(−2z) is lost beside one.
LARGE = 18.0


def cosine_and_sine(w: "Any", t: "Any") -> "tuple[Any, Any]":
    """cos(√w·t) and sin(√w·t)/√w for w of either sign."""
    u = w * t * t
    if absolute(u) < SMALL:
        c: Any = 1.0
        s: Any = 1.0
        for k in range(TERMS, 0, -1):
            c = 1.0 - u * c / float((2 * k - 1) * (2 * k))
            s = 1.0 - u * s / float(2 * k * (2 * k + 1))
        return c, t * s
    if w > 0.0:
        root = sqrt(w)
        return cos(root * t), sin(root * t) / root
    root = sqrt(0.0 - w)
    return cosh(root * t), sinh(root * t) / root


def free_motion(x: "Any", v: "Any", omega: "Any", zeta: "Any", room: "Any", t: "Any") -> "tuple[Any, Any]":
    """Displacement and velocity after a time; `room` is 1 − ζ²."""
    sigma, w = zeta * omega, room * omega * omega
    if w < 0.0 and 0.0 - w * t * t > SMALL:
        root = sqrt(0.0 - w)
        # the slow rate is never a difference
        slow = 0.0 - omega * omega / (sigma + root)
        z = root * t
        fast = exp(-2.0 * z) if z < LARGE * LARGE else 0.0 * z
        start = v - slow * x
        decay = exp(slow * t)
        part = (exp(0.0 - z) * sinh(z) if z < 1.0 else 0.5 * (1.0 - fast)) / root
        place = decay * (x + start * part)
        return place, slow * place + decay * start * fast
    c, s = cosine_and_sine(w, t)
    decay = exp(0.0 - sigma * t)
    return decay * (x * c + (v + sigma * x) * s), decay * (v * c - (sigma * v + omega * omega * x) * s)


def from_rest(omega: "Any", drive: "Any", gap: "Any", zeta: "Any", room: "Any", t: "Any") -> "Any":
    """∫h(t − τ)cos(ωτ)dτ of unit mass: the response to a cosine force from rest, resonance included.

    With λ = −σ + iω_d it is Re{(G₁ − G₂)/(iω − λ̄)}, G₁ = (e^{iωt} − e^{λt})/(iω − λ), G₂ = e^{−σt}·sin(ω_d·t)/ω_d.
    """
    if zeta == 0.0:
        half = 0.5 * t
        apart = gap * omega * omega / (omega + drive)
        return 0.5 * t * t * _over(sin, half * apart) * _over(sin, half * (omega + drive))
    sigma, damped = zeta * omega, omega * sqrt(room)
    # ω_n − ω = gap·ω_n²/(ω_n + ω); ω_d = ω_n − ζ²ω_n/(1 + √(1 − ζ²))
    apart = zeta * zeta * omega / (1.0 + sqrt(room)) - gap * omega * omega / (omega + drive)
    a, b = 0.5 * sigma * t, 0.5 * apart * t
    real, imaginary = sinh(a) * cos(b), cosh(a) * sin(b)
    size = sigma * sigma + apart * apart
    # G₁ = 2·e^{λt + δt/2}·sinh(δt/2)/δ with δ = σ + i·apart
    p, q = (real * sigma + imaginary * apart) / size, (imaginary * sigma - real * apart) / size
    turn = damped * t + b
    decay = 2.0 * exp(a - sigma * t)
    g = decay * (p * cos(turn) - q * sin(turn)) - exp(0.0 - sigma * t) * sin(damped * t) / damped
    h = decay * (p * sin(turn) + q * cos(turn))
    over = drive + damped
    return (g * sigma + h * over) / (sigma * sigma + over * over)


def _over(function: "Any", z: "Any") -> "Any":
    """sin(z)/z, one at zero."""
    return 1.0 + 0.0 * z if z == 0.0 else function(z) / z
