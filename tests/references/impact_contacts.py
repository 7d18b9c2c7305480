"""Contacts in their own frame for impact_rigid.json: K, velocities, friction and restitution, without bodies."""

import math
import random
from typing import Any

from mpmath import mp
from references.impact_events import follow

NAMES = ("tangential", "coupling", "normal", "slip", "approach", "friction", "restitution")
Contact = tuple[float, ...]
# Where random search, then climbing by small changes of all inputs, found the program's largest errors.
FOUND: dict[str, tuple[Contact, ...]] = {
    "stronge": (
        (0.004551811617258788, 0.002855932962663667, 0.004727104676240121, -8.514978400501315, -8.648243162958194,
         1.0981947149698488, 0.058279012801332054),
        (3.351733124917368, 1.2347269673569523, 1.6482668750826326, 5.909473775412724e-12, -0.12501681907496548,
         1.1548253368937393, 0.5026628908148715),
        (0.00264247742862598, 0.0002178556805593246, 0.002370592497959503, -2.124284672858212, -2.3059346650371725e-12,
         0.08315648678496618, 0.050840432140113134),
    ),
    "newton": (
        (0.004655248394132283, 0.002809209079905645, 0.0030972539943927265, -8.723217544687373, -4.127319206328046,
         1.1342427716154888, 0.8258143906362192),
        (3.9688924188622114, 0.30389975618470483, 1.031107581137789, 0.013326456766620254, -3.276031733625504e-11,
         0.048742719159671655, 0.9695765059218046),
        (1.5873160827199195, -1.1902941859931757, 3.4126885643449154, 1.9605555651849806, -2.30498383167392,
         1.1594196091107396, 0.3454309790012564),
    ),
    "poisson": (
        (3.7496343324272026, -0.8297075416371659, 1.2503658247327076, 9.842249918189563e-07, -0.6032535129997448,
         0.1573444866181846, 0.6037169315059193),
        (3.3552803808389755, -1.2322724821233633, 1.6447196191927953, 2.224497713770417, -1.521128601427579,
         1000000.0000098901, 0.8184711610762933),
        (3.999853538847208, 0.020960963897455102, 1.000146461152793, 0.0, -20.777368857636084, 0.9909674139566325,
         0.0052693566447171705),
    ),
}  # fmt: skip


def rod(lean: float) -> tuple[float, float, float]:
    """A rod of unit mass and length on its end."""
    s, c = 0.5 * math.sin(lean), 0.5 * math.cos(lean)
    return 1.0 + 12.0 * s * s, -12.0 * s * c, 1.0 + 12.0 * c * c


def contacts() -> list[tuple[str, str, str, Contact]]:
    """Law, name, why (of hard ones), and the numbers in the order of NAMES."""
    r = random.Random(1877)
    found = []
    for law in FOUND:
        for index in range(8):
            lean, slip = r.uniform(0.1, 3.0), r.uniform(-6.0, 6.0)
            given = (*rod(lean), slip, -r.uniform(0.5, 5.0), r.uniform(0.05, 1.0), r.uniform(0.0, 1.0))
            found.append((law, f"rod {index}", "", given))
        k = 2.0, -1.0, 3.0
        for name, why, given in (
            ("slip turns round", "friction stops the slip and cannot hold it: it comes back before the impact is over",
             (*k, 0.4, -1.5, 0.25, 0.6)),
            ("slip turns round in restitution",
                "slip stops in restitution and comes back: the work is that of three stretches of different slope",
             (*k, 1.6, -1.5, 0.25, 0.9)),
            ("sticks",
                "slip stops in compression and sticks: the impulse's two "
                "slopes meet at a root of the slip", (*k, 0.7, -1.5, 0.6, 0.6)),
            ("threshold of stick", "friction is |k_x|/k_t: stick or reversed slip by the last bit",
             (*k, 0.7, -1.5, 0.5, 0.6)),
            ("threshold of stick, below",
                "friction is one rounding short of what holds: reversed slip in "
                "place of stick, with a slope next to zero",
             (*k, 0.7, -1.5, math.nextafter(0.5, 0.0), 0.6)),
            ("jam", "friction drives the bodies together while the first slip lasts: u_n falls",
             (4.0, -6.0, 10.0, -8.0, -1.0, 2.0, 0.5)),
            ("nearly a jam", "the slope of u_n is a last bit of k_n: compression takes as much longer",
             (4.0, -5.0, 10.0, -1e17, -1.0, math.nextafter(2.0, 0.0), 0.5)),
            ("no coupling",
                "k_x is zero: no way out of stick, and |k_x|/k_t ≤ μ "
                "must hold for any friction, even none", (2.0, 0.0, 3.0, 0.5, -1.0, 0.4, 0.5)),
            ("coupling 1e-20",
                "k_x is lost in any sum with k_t, but its sign "
                "decides which way reversed slip goes", (2.0, 1e-20, 3.0, 0.5, -1.0, 0.4, 0.5)),
            ("no friction",
                "no friction: nothing acts across at any slip, losses "
                "across are zeros and not small", (*k, 0.4, -1.5, 0.0, 0.6)),
            ("friction without bound",
                "friction without bound: slip stops at an impulse that all but vanishes", (*k, 0.4, -1.5, 1e12, 0.6)),
            ("grazing",
                "slip is twelve orders above the approach: it lasts to the "
                "end, and its change is below its last place", (*k, 20.0, -2e-11, 0.3, 0.5)),
            ("hardly any slip",
                "slip is sixteen orders below the approach: it stops "
                "within one rounding of the impulse", (*k, 1e-16, -1.0, 0.3, 0.5)),
            ("plastic",
                "no restitution: the work to be given back is zero, and the "
                "root of a difference is that of rounding", (*k, 0.4, -1.5, 0.25, 0.0)),
            ("elastic",
                "elastic: restitution's work equals compression's, "
                "whose difference is all rounding", (*k, 0.4, -1.5, 0.25, 1.0)),
            ("long lever",
                "k_t k_n exceeds k_x² by a millionth: the "
                "determinant of K keeps ten digits", (1.0, -0.9999995, 1.0, 0.3, -1.0, 0.4, 0.5)),
            ("grains",
                "mobilities of 1e22 per kilogram: their "
                "products are 1e44, impulses 1e-22", (2e22, -1e22, 3e22, 0.4, -1.5, 0.25, 0.6)),
            ("planets",
                "mobilities of 1e-22 per kilogram: their "
                "products are 1e-44, impulses 1e22", (2e-22, -1e-22, 3e-22, 0.4, -1.5, 0.25, 0.6)),
        ):  # fmt: skip
            found.append((law, name, why, given))
        for index, given in enumerate(FOUND[law]):
            found.append(
                (law, f"found {index}", "found by search: an error among the largest of random contacts", given)
            )
    return found


def cases() -> list[dict[str, Any]]:
    """The cases as they are written."""
    made = []
    for law, name, why, given in contacts():
        end = follow(*given, law)
        case = {"task": "path", "kind": "hard" if why else "ordinary", "name": f"{name}, {law}"}
        inputs = {key: repr(value) for key, value in zip(NAMES, given, strict=True)} | {"law": {"word": law}}
        results = {key: mp.nstr(end[key] + 0, 40, strip_zeros=True) for key in ("normal", "tangential", "compression")}
        made.append({**case, **({"why": why} if why else {}), "inputs": inputs, "results": results})
    return made
