"""Spans, pins and chords as handbooks print them: tan α − α, its inverse by iteration, heights by 1 − cos."""

from math import acos, atan, cos, pi, sin, sqrt, tan

from dynamics_cli.accuracy.alternatives.gear.involute import newton

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    Inverse = Callable[[float], dict[str, float]]


class Teeth:
    """A toothing by its angles; of an internal gear the shift is that of its spaces."""

    def __init__(self, given: "dict[str, Any]") -> None:
        self.teeth: int = given["teeth"]
        self.internal: bool = given["internal"]
        self.module, self.alpha, self.beta = given["module"], given["pressure_angle"], given["helix_angle"]
        self.shift = -given["profile_shift"] if self.internal else given["profile_shift"]
        self.transverse = atan(tan(self.alpha) / cos(self.beta))
        self.pitch = self.teeth * self.module / cos(self.beta)
        self.base = self.pitch * cos(self.transverse)
        self.involute = tan(self.transverse) - self.transverse
        # half a quarter turn's tooth, and what the shift adds
        self.quarter, self.more = pi / (2 * self.teeth), 2 * self.shift * tan(self.alpha) / self.teeth
        self.base_helix = sqrt(1 - (sin(self.beta) * cos(self.alpha)) ** 2)


def by_newton(**given: "Any") -> "dict[str, float]":
    """W = m·cos α·(π·(k − ½) + z·inv α_t) + 2·x·m·sin α, pins by Newton on tan α − α, chords by sines."""
    return _measured(given, newton)


def _measured(given: "dict[str, Any]", inverse: "Inverse") -> "dict[str, float]":
    t = Teeth(given)
    own = -t.shift if t.internal else t.shift
    thickness = t.module * (pi / 2 + 2 * own * tan(t.alpha))
    measured = {"normal_thickness": thickness} | _chords(t, thickness, given.get("tip_diameter"))
    if given.get("pin") is not None:
        measured |= _pins(t, given["pin"], inverse)
    if given.get("over") and not (t.internal and t.beta):
        base = t.module * cos(t.alpha) * (pi * (given["over"] - 0.5) + t.teeth * t.involute)
        span = base + 2 * t.shift * t.module * sin(t.alpha)
        measured |= {"span.span": span, "span.contact_diameter": sqrt(t.base**2 + (span * t.base_helix) ** 2)}
        if t.beta:
            measured["span.least_face_width"] = span * abs(sin(t.beta)) * cos(t.alpha)
    return measured


def _chords(t: Teeth, thickness: float, tip: "float | None") -> "dict[str, float]":
    """s̄ = d_v·sin(s/d_v), h̄ = h_a + d_v·(1 − cos(s/d_v))/2 with d_v = z·m/cos³β; s·cos²α, h_a − s/2·sin α·cos α."""
    virtual = t.teeth * t.module / cos(t.beta) ** 3
    chords = {"chordal.thickness": virtual * sin(thickness / virtual)}
    if not t.internal:
        chords["constant_chord.thickness"] = thickness * cos(t.alpha) ** 2
    if tip is not None:
        rise = virtual / 2 * (1 - cos(thickness / virtual))
        high = (tip - t.pitch) / 2
        chords["chordal.height"] = -high - rise if t.internal else high + rise
        if not t.internal:
            chords["constant_chord.height"] = high - thickness / 2 * sin(t.alpha) * cos(t.alpha)
    return chords


def _pins(t: Teeth, pin: float, inverse: "Inverse") -> "dict[str, float]":
    """Inv α_K = D/(z·m·cos α) − π/2z + inv α_t + 2·x·tan α/z, d_K = d_b/cos α_K, M = d_K·(cos 90°/z) + D."""
    sign = -1.0 if t.internal else 1.0
    share = pin / (t.teeth * t.module * cos(t.alpha))
    angle = inverse(sign * (share - sign * t.quarter + t.involute + t.more) if not t.internal else
                    t.quarter + t.involute + t.more - share)["phi"]  # fmt: skip
    centre = t.base / cos(angle)
    across = centre * cos(pi / (2 * t.teeth)) if t.teeth % 2 else centre
    reach = t.base * tan(angle) - sign * pin * t.base_helix
    pins = {
        "pins.pin": pin, "pins.centre_diameter": centre, "pins.size": across + sign * pin,
        "pins.contact_diameter": sqrt(t.base**2 + reach**2),
    }  # fmt: skip
    if not t.beta:
        # the pin that touches at d + 2·x·m: its centre lies at φ = tan α' ± η, η half the space
        touch = acos(t.base / (t.pitch + 2 * t.shift * t.module))
        half = t.quarter - sign * (t.involute + t.more)
        at = tan(touch) + sign * half
        pins["pins.ideal_pin"] = t.teeth * t.module * cos(t.alpha) * (sign * (tan(at) - at) + half)
    return pins
