"""Data blocks and unknown gears in exact numbers: arcs of the base circle unrolled, balls by roots of tan α − α."""

from typing import Any

from gear_exact import Exact, Tooth, atan, cos, involute, involute_angle, pi, sin, sqrt, tan

PRESSURE_ANGLES = ("20", "14.5", "15", "17.5", "22.5", "25", "30")
# As ISO 54 and the trade have them: mm, and diametral pitches.
MODULES = [
    *"0.1 0.12 0.15 0.2 0.25 0.3 0.4 0.5 0.6 0.7 0.75 0.8 0.9 1 1.25 1.5 2 2.5 3 4 5 6 8 10 12 16 20 25".split(),  # noqa: SIM905
    *"32 40 50 1.125 1.375 1.75 2.25 2.75 3.5 4.5 5.5 6.5 7 9 11 14 18 22 28 36 45".split(),  # noqa: SIM905
]  # fmt: skip
DIAMETRAL = [
    *"1 1.25 1.5 1.75 2 2.25 2.5 2.75 3 3.5 4 5 6 7 8 9 10 11 12 14 16 18 20 22 24 26 28 30 32 36 40 44 48 56".split(),  # noqa: SIM905
    *"64 72 80 96 120".split(),  # noqa: SIM905
]


def fraction(decimal: str) -> Any:
    """A decimal as it is written."""
    whole, _, part = decimal.partition(".")
    return Exact(int(whole + part)) / 10 ** len(part)


def exact_size(name: str) -> Any:
    """A standard size in metres, by the words it is ordered by."""
    kind, _, number = name.partition(" ") if name.startswith("module") else ("", "", name.removesuffix(" DP"))
    return fraction(number) / 1000 if kind else Exact(254) / 10000 / fraction(number)


# ---- data blocks ----


def data_block(tooth: Tooth, over: int | None, pin: Any, upper: Any, lower: Any) -> dict[str, Any]:
    """The numbers of a data block in mm and degrees, by their symbols."""
    degree, mm = 180 / pi(), 1000
    way = -1 if tooth.internal else 1
    thick = tooth.m * (pi() / 2 + 2 * tooth.x * tan(tooth.alpha))
    out = {
        "m_n": mm * tooth.m,
        "α_n": degree * tooth.alpha,
        "β": degree * tooth.beta,
        "x": tooth.x,
        "d": 2 * mm * tooth.r,
        "d_b": 2 * mm * tooth.rb,
        "d_a": 2 * mm * tooth.tip,
        "d_f": 2 * mm * tooth.root,
        "h": mm * way * (tooth.tip - tooth.root),
        "s_n": mm * thick,
    }
    if not tooth.internal:
        out["d_Ff"] = 2 * mm * tooth.form
    given = {"E_sns": upper, "E_sni": lower, "D_M": pin}
    out |= {name: mm * Exact(value) for name, value in given.items() if value is not None}
    if tooth.beta:
        out["p_z"] = mm * 2 * pi() * tooth.r / tan(tooth.beta)
    allowances = {"": Exact(0)} | {k: Exact(v) for k, v in (("s", upper), ("i", lower)) if v is not None}
    for key, allowance in allowances.items():
        # the allowance thickens the normal section of the tooth; a ring's space gets what its tooth loses
        solid = tooth.solid + way * allowance / (tooth.m * tooth.z)
        if over is not None:
            out["W_k" + (f",{key}" if key else "")] = mm * unrolled(tooth, solid, over)
        if pin is not None:
            out["M_d" + (f",{key}" if key else "")] = mm * over_balls(tooth, solid, Exact(pin))
    return out


def base_helix_cosine(tooth: Tooth) -> Any:
    """cos β_b by tan β_b = tan β cos α_t."""
    lean = tan(tooth.beta) * cos(tooth.at)
    return 1 / sqrt(1 + lean * lean)


def unrolled(tooth: Tooth, solid: Any, over: int) -> Any:
    """The base circle unrolled over the teeth (or spaces) spanned, seen square to the helix."""
    return tooth.rb * (2 * solid + (over - 1) * 2 * pi() / tooth.z) * base_helix_cosine(tooth)


def over_balls(tooth: Tooth, solid: Any, pin: Any) -> Any:
    """Size over two balls in the spaces: a ball's centre is on the involute half a ball away from the flank."""
    away = pin / 2 / (tooth.rb * base_helix_cosine(tooth))
    value = solid - away if tooth.internal else away + solid - pi() / tooth.z
    if value <= 0:
        raise ArithmeticError("no ball touches")
    centre = tooth.rb / cos(involute_angle(value))
    across = 2 * centre * (cos(pi() / (2 * tooth.z)) if tooth.z % 2 else 1)
    return across - pin if tooth.internal else across + pin


# ---- unknown gears ----


def candidate(
    name: str, degrees: str, *, teeth: int, spans: list[tuple[int, float]], tip: float | None, beta: float,
    reading: float,
) -> dict[str, Any]:  # fmt: skip
    """What a standard gear would have to be for these readings, and how far off it is."""
    m, alpha = exact_size(name), fraction(degrees) * pi() / 180
    ordered = sorted(spans)
    mean = sum(Exact(length) for _, length in spans) / len(spans)
    counts = Exact(sum(over for over, _ in spans)) / len(spans)
    tangent = tan(alpha) / cos(Exact(beta))
    at = atan(tangent)
    rb = teeth * m / (2 * cos(Exact(beta))) * cos(at)
    lean = tan(Exact(beta)) * cos(at)
    cosine = 1 / sqrt(1 + lean * lean)
    # W = r_b (2ψ + (k − 1) 2π/z) cos β_b gives the tooth at the base, that the thickness, and that the shift
    solid = (mean / (rb * cosine) - (counts - 1) * 2 * pi() / teeth) / 2
    shift = ((solid - involute(at)) * teeth - pi() / 2) / (2 * tan(alpha))
    out = {"module": m, "pressure_angle": alpha, "profile_shift": shift}
    off = shift * shift / 5 + 25 * max(abs(shift) - 1, Exact(0)) ** 2
    if len(spans) > 1:
        steps = ordered[-1][0] - ordered[0][0]
        pitch = (Exact(ordered[-1][1]) - Exact(ordered[0][1])) / steps
        out["base_pitch_error"] = pitch - pi() * m * cos(alpha)
        off += (out["base_pitch_error"] * steps / (2 * Exact(reading))) ** 2
    if tip is not None:
        addendum = Exact(tip) / (2 * m) - teeth / (2 * cos(Exact(beta))) - shift
        known = 3 * Exact(reading) / (2 * m * sin(alpha)) + fraction("0.02")
        # a tooth thinned for backlash, by up to 0.06 of a shift, has this much addendum too many
        beyond = [addendum - nominal for nominal in (Exact(1), fraction("0.8"))]
        full, stub = ((excess if excess < 0 else max(excess - fraction("0.06"), Exact(0))) for excess in beyond)
        off += min((full / known) ** 2, (stub / known) ** 2 + Exact(0.25))
        out["addendum_factor"] = addendum
    rare = {"20": "0", "14.5": "0.05", "25": "0.05"}.get(degrees, "0.2")
    out["disagreement"] = sqrt(off + fraction(rare))
    return out


def all_candidates(read: dict[str, Any]) -> list[tuple[Any, str, str]]:
    """Every standard gear within the limits of the search, best first: disagreement, size, pressure angle."""
    found = []
    names = [f"module {one}" for one in MODULES] + [f"{one} DP" for one in DIAMETRAL]
    room = 2 * Exact(read["reading"])
    if len(read["spans"]) > 1:
        overs = [over for over, _ in read["spans"]]
        room = room / (max(overs) - min(overs))
    for name in names:
        for degrees in PRESSURE_ANGLES:
            one = candidate(name, degrees, **read)
            error = one.get("base_pitch_error", Exact(0))
            if abs(error) <= 6 * room and abs(one["profile_shift"]) <= 2.5 and one["disagreement"] < 100:
                found.append((one["disagreement"], name, degrees))
    return sorted(found)
