"""Writes vibration.json: answers of the vibration tasks to 40 digits, for ordinary and hard inputs.

The formulas are others than the program's: free and forced motion by exponentials of the state matrix, steady states as
complex solutions, half-power and isolation as roots of their definitions, peaks as zeros of derivatives, modes and
shafts as eigenvalues of assembled matrices in 120 digits, beams by roots of cos·cosh. Inputs are the doubles given.

Run: python tests/references/generate_vibration_references.py [FILE]. The same bytes every time.
"""

import random
from collections.abc import Iterator
from typing import Any

from case_files import put
from mpmath import (
    arg,
    conj,
    cos,
    cosh,
    diag,
    diff,
    eigsy,
    expm,
    findroot,
    log,
    lu_solve,
    matrix,
    mp,
    mpc,
    mpf,
    nstr,
    pi,
    polyroots,
    sin,
    sqrt,
    tan,
    tanh,
)  # fmt: skip

mp.dps = 120
GRAVITY = mpf(9.80665)


def spring_of(mass: Any, spring: dict[str, Any]) -> tuple[Any, Any]:
    """Stiffness (of a unit mass without one) and mass."""
    m = mpf(mass) if mass is not None else mpf(1)
    if "stiffness" in spring:
        return mpf(spring["stiffness"]), m
    if "natural_frequency" in spring:
        return m * (2 * pi * mpf(spring["natural_frequency"])) ** 2, m
    return m * GRAVITY / mpf(spring["static_deflection"]), m


def damping_of(k: Any, m: Any, damping: dict[str, Any] | None) -> Any:
    if not damping:
        return mpf(0)
    return mpf(damping["damping"]) if "damping" in damping else 2 * mpf(damping["damping_ratio"]) * sqrt(k * m)


def rate_of(k: Any, m: Any, excitation: dict[str, Any]) -> Any:
    natural = sqrt(k / m)
    if "frequency" in excitation:
        return 2 * pi * mpf(excitation["frequency"])
    if "speed" in excitation:
        return mpf(excitation["speed"])
    if "frequency_ratio" in excitation:
        return natural * mpf(excitation["frequency_ratio"])
    return natural * (1 + mpf(excitation["detuning"]))


def free(spring: Any, mass: Any = None, damping: Any = None, displacement: float = 0.0, start_velocity: float = 0.0,
         time: float | None = None) -> dict[str, Any]:  # fmt: skip
    k, m = spring_of(mass, spring)
    if damping and "friction" in damping:
        return dry(k, m, mpf(damping["friction"]), mpf(displacement))
    c = damping_of(k, m, damping)
    out = {"natural_frequency": sqrt(k / m) / (2 * pi), "angular_frequency": sqrt(k / m),
           "damping_ratio": c / (2 * sqrt(k * m))}  # fmt: skip
    roots = [(-c + sign * sqrt(mpc(c * c - 4 * k * m))) / (2 * m) for sign in (1, -1)]
    if roots[0].imag and abs(roots[0].imag) > mpf("1e-6") * abs(roots[0]):
        pace, fall = abs(roots[0].imag), -roots[0].real
        out |= {"damped_frequency": pace / (2 * pi), "period": 2 * pi / pace}
        out["amplitude"] = abs(mpc(displacement, -(mpf(start_velocity) + fall * mpf(displacement)) / pace))
        if c:
            out |= {"decrement": 2 * pi * fall / pace, "cycles_to_half": log(2) / (2 * pi * fall / pace)}
    if time is not None:
        state = expm(matrix([[0, 1], [-k / m, -c / m]]) * mpf(time)) * matrix([mpf(displacement), mpf(start_velocity)])
        out |= {"position": state[0], "velocity": state[1]}
    return out


def dry(k: Any, m: Any, friction: Any, x: Any) -> dict[str, Any]:
    """From rest, half cycle by half cycle: each mirrors the displacement at the edge of the band."""
    band, count = friction * m * GRAVITY / k, 0
    while abs(x) > band:
        edge = band if x > 0 else -band
        x, count = 2 * edge - x, count + 1
    return {"dead_band": band, "rest_position": x, "stop_time": count * pi * sqrt(m / k)}


def forced(mass: float, spring: Any, force: float, excitation: Any, damping: Any = None,
           time: float | None = None) -> dict[str, Any]:  # fmt: skip
    k, m = spring_of(mass, spring)
    c, w, f = damping_of(k, m, damping), rate_of(k, m, excitation), mpf(force)
    out: dict[str, Any] = {}
    if c or m * w * w != k:
        x = f / (k - m * w * w + mpc(0, 1) * w * c)
        out = {"amplitude": abs(x), "phase": arg(conj(x)), "magnification": abs(x) * k / f,
               "ground_force": abs((k + mpc(0, 1) * w * c) * x)}  # fmt: skip
    zeta = c / (2 * sqrt(k * m))
    if 0 < zeta < sin(pi / 8):
        # |H|² as a function of u = r²: its derivative vanishes, and half of its maximum
        peak = findroot(lambda u: diff(lambda v: (1 - v) ** 2 + 4 * zeta * zeta * v, u), 1 - zeta)
        top = (1 - peak) ** 2 + 4 * zeta * zeta * peak
        low, high = sorted(root.real for root in polyroots([1, 4 * zeta * zeta - 2, 1 - 2 * top], maxsteps=500))
        hertz = sqrt(k / m) / (2 * pi)
        out |= {"peak_frequency": sqrt(peak) * hertz, "peak_amplitude": f / k / sqrt(top),
                "lower_frequency": sqrt(low) * hertz, "upper_frequency": sqrt(high) * hertz,
                "bandwidth": (sqrt(high) - sqrt(low)) * hertz}  # fmt: skip
    if time is not None:
        # the force as two more states that turn
        whole = matrix([[0, 1, 0, 0], [-k / m, -c / m, f / m, 0], [0, 0, 0, -w], [0, 0, w, 0]])
        out["position"] = (expm(whole * mpf(time)) * matrix([0, 0, 1, 0]))[0]
    return out


def base(spring: Any, motion: Any, excitation: Any, mass: float | None = None, damping: Any = None) -> dict[str, Any]:
    k, m = spring_of(mass, spring)
    c, w = damping_of(k, m, damping), rate_of(k, m, excitation)
    y = mpf(motion["base_amplitude"]) if "base_amplitude" in motion else mpf(motion["base_acceleration"]) / w**2
    x = (k + mpc(0, 1) * w * c) / (k - m * w * w + mpc(0, 1) * w * c)
    out = {"transmissibility": abs(x), "amplitude": abs(x) * y, "acceleration": abs(x) * y * w * w,
           "phase": arg(conj(x)), "relative_ratio": abs(x - 1), "relative_amplitude": abs(x - 1) * y}  # fmt: skip
    zeta = c / (2 * sqrt(k * m))
    if zeta:
        square = lambda u: (1 + 4 * zeta**2 * u) / ((1 - u) ** 2 + 4 * zeta**2 * u)  # noqa: E731
        # the derivative's numerator, multiplied out
        place = max(root.real for root in polyroots([4 * zeta**2, 2, -2], maxsteps=500, extraprec=400))
        out |= {"peak_frequency": sqrt(place) * sqrt(k / m) / (2 * pi), "peak_transmissibility": sqrt(square(place))}
    return out


def unbalance(mass: float, unbalance: float, spring: Any, excitation: Any, damping: Any = None) -> dict[str, Any]:
    k, m = spring_of(mass, spring)
    c, w, u = damping_of(k, m, damping), rate_of(k, m, excitation), mpf(unbalance)
    x = u * w * w / (k - m * w * w + mpc(0, 1) * w * c)
    return {"amplitude": abs(x), "velocity": abs(x) * w / sqrt(2), "phase": arg(conj(x)), "response": abs(x) * m / u,
            "ground_force": abs((k + mpc(0, 1) * w * c) * x), "critical_speed": sqrt(k / m)}  # fmt: skip


def isolator(excitation: Any, wish: Any, damping_ratio: float = 0.0, mass: float | None = None) -> dict[str, Any]:
    zeta = mpf(damping_ratio)
    hertz = mpf(excitation["frequency"]) if "frequency" in excitation else mpf(excitation["speed"]) / (2 * pi)
    if "static_deflection" in wish:
        r = 2 * pi * hertz * sqrt(mpf(wish["static_deflection"]) / GRAVITY)
    else:
        passed = mpf(wish["transmissibility"]) if "transmissibility" in wish else 1 - mpf(wish["isolation"])
        off = lambda r: abs((1 + 2j * zeta * r) / (1 - r * r + 2j * zeta * r)) ** 2 - passed**2  # noqa: E731
        r = findroot(off, (sqrt(1 + 1 / passed), 3 * sqrt(1 + 1 / passed)), solver="anderson", tol=mpf(10) ** -200)
    out = {"ratio": r, "natural_frequency": hertz / r, "static_deflection": GRAVITY * (r / (2 * pi * hertz)) ** 2}
    return out | ({"stiffness": mpf(mass) * (2 * pi * hertz / r) ** 2} if mass else {})


def decrement(measured: dict[str, Any]) -> dict[str, Any]:
    if "peaks" in measured:
        logs = [log(mpf(one)) for one in measured["peaks"]]
        n = len(logs)
        rows = matrix([[n, sum(range(n))], [sum(range(n)), sum(i * i for i in range(n))]])
        line = lu_solve(rows, matrix([sum(logs), sum(i * one for i, one in enumerate(logs))]))
        delta = -line[1] / int(float(measured.get("every", 1)))
        # x falls by e^−δ while the phase goes through one turn
        zeta = findroot(lambda z: 2 * pi * z / sqrt(1 - z * z) - delta, delta / 7)
        out = {"damping_ratio": zeta, "decrement": delta}
        if n > 2:
            rest = sum((one - line[0] - i * line[1]) ** 2 for i, one in enumerate(logs))
            spread = sum((i - mpf(n - 1) / 2) ** 2 for i in range(n))
            slope = 1 / diff(lambda z: 2 * pi * z / sqrt(1 - z * z), zeta)
            out["deviation"] = sqrt(rest / (n - 2) / spread) * slope / int(float(measured.get("every", 1)))
        return out
    low, high = mpf(measured["lower_frequency"]), mpf(measured["upper_frequency"])

    def off(zeta: Any) -> Any:
        side = 2 * zeta * sqrt(1 - zeta * zeta)
        return (1 - 2 * zeta**2 + side) / (1 - 2 * zeta**2 - side) - (high / low) ** 2

    zeta = findroot(off, (high - low) / (high + low))
    natural = low / sqrt(1 - 2 * zeta**2 - 2 * zeta * sqrt(1 - zeta**2))
    return {"damping_ratio": zeta, "natural_frequency": natural}


def amplitude(mu: Any, f: Any, zeta: Any, r: Any) -> Any:
    """|X₁| of the two equations of motion, of unit machine and force."""
    spring, c = mu * f * f, 2 * mu * zeta * f
    joint = spring + mpc(0, 1) * c * r
    rows = matrix([[1 + joint - r * r, -joint], [-joint, joint - mu * r * r]])
    return abs(lu_solve(rows, matrix([1, 0]))[0])


def peak(mu: Any, f: Any, zeta: Any, start: Any) -> tuple[Any, Any]:
    """Newton's method on the derivative."""
    at = start
    for _ in range(9):
        at -= diff(lambda s: amplitude(mu, f, zeta, s), at) / diff(lambda s: amplitude(mu, f, zeta, s), at, 2)
    return at, amplitude(mu, f, zeta, at)


def fixed_points(mu: Any, f: Any) -> list[Any]:
    """Squares of the frequencies at which damping does not matter; the peaks lie near."""
    middle, root = 1 + f * f * (1 + mu), sqrt((1 + f * f * (1 + mu)) ** 2 - 2 * (2 + mu) * f * f)
    return [(middle - root) / (2 + mu), (middle + root) / (2 + mu)]


def absorber(size: dict[str, Any], tune: dict[str, Any] | None = None) -> dict[str, Any]:
    mp.dps = 50
    mu = mpf(size["mass_ratio"])
    f, zeta = 1 / (1 + mu), sqrt(3 * mu / (8 * (1 + mu)))
    if tune and "frequency_ratio" in tune:
        f, zeta = mpf(tune["frequency_ratio"]), mpf(tune["damping_ratio"])
    elif tune:
        f, zeta = least_peak(mu, f, zeta)
    low, high = (peak(mu, f, zeta, sqrt(u)) for u in fixed_points(mu, f))
    mp.dps = 120
    return {"frequency_ratio": f, "damping_ratio": zeta, "lower_ratio": low[0], "lower_peak": low[1],
            "upper_ratio": high[0], "upper_peak": high[1]}  # fmt: skip


def least_peak(mu: Any, f: Any, zeta: Any) -> tuple[Any, Any]:
    """Both peaks alike, and nothing gained to first order by any change of f and ζ."""
    step = mpf(10) ** -20

    def both(f: Any, zeta: Any) -> list[Any]:
        return [peak(mu, f, zeta, sqrt(u)) for u in fixed_points(mu, f)]

    def off(f: Any, zeta: Any) -> list[Any]:
        (r, low), (s, high) = both(f, zeta)
        slopes = [
            [(amplitude(mu, f + a, zeta + b, at) - amplitude(mu, f - a, zeta - b, at)) / (2 * step) for a, b in
             ((step, 0), (0, step))] for at in (r, s)
        ]  # fmt: skip
        return [low - high, slopes[0][0] * slopes[1][1] - slopes[0][1] * slopes[1][0]]

    x = findroot(off, (f, zeta), tol=mpf(10) ** -34)
    return x[0], x[1]


def line_of(masses: list[float], stiffnesses: list[float]) -> tuple[Any, Any]:
    n, s = len(masses), len(stiffnesses)
    stiffness = matrix(n, n)
    ends = [(i - 1, i) for i in range(0 if s >= n else 1, n)] + ([(n - 1, -1)] if s == n + 1 else [])
    for (i, j), k in zip(ends, stiffnesses, strict=True):
        for a, b, sign in ((i, i, 1), (j, j, 1), (i, j, -1), (j, i, -1)):
            if a >= 0 and b >= 0:
                stiffness[a, b] += sign * mpf(k)
    return [mpf(m) for m in masses], stiffness


def rates(masses: list[Any], stiffness: Any) -> list[Any]:
    root = diag([1 / sqrt(m) for m in masses])
    values = sorted(eigsy(root * stiffness * root, eigvals_only=True))
    return [sqrt(value) if value > mpf("1e-60") else mpf(0) for value in values]


def modes(system: dict[str, Any]) -> dict[str, Any]:
    out = {}
    for nth, value in enumerate(rates(*line_of(system["masses"], system["stiffnesses"]))):
        if value:
            out |= {f"modes[{nth}].angular_frequency": value, f"modes[{nth}].frequency": value / (2 * pi)}
    return out


def shaft(rotors: list[Any], shafts: list[Any], gears: list[Any] | None = None) -> dict[str, Any]:
    """Lagrange's equations in the angles that gears leave free: θ = R·q."""
    names = [one["name"]["word"] for one in rotors]
    of = {name: (name, mpf(1)) for name in names}
    for gear in gears or []:
        driver, driven = gear["driver"]["word"], gear["driven"]["word"]
        turns = mpf(gear["ratio_of"]["ratio"])
        of[driven] = (of[driver][0], -of[driver][1] / turns)
    kept = [name for name in names if of[name][0] == name]
    n = len(kept)
    way = {name: [of[name][1] if of[name][0] == one else mpf(0) for one in kept] for name in names}
    inertia = [sum(mpf(one["inertia"]) * way[name][i] ** 2 for one, name in zip(rotors, names, strict=True))
               for i in range(n)]  # fmt: skip
    stiffness = matrix(n, n)
    for one in shafts:
        twist = [a - b for a, b in zip(way[one["from_"]["word"]], way[one["to"]["word"]], strict=True)]
        for i in range(n):
            for j in range(n):
                stiffness[i, j] += mpf(one["spring"]["stiffness"]) * twist[i] * twist[j]
    moving = [value for value in rates(inertia, stiffness) if value]
    return {f"modes[{nth}].{name}": value / (2 * pi if name == "frequency" else 1)
            for nth, value in enumerate(moving) for name in ("frequency", "speed")}  # fmt: skip


def beam(ends: dict[str, str], length: float, section: Any, elastic_modulus: float = 210e9,
         count: str = "4") -> dict[str, Any]:  # fmt: skip
    width, height, density = mpf(section["width"]), mpf(section["height"]), mpf(section.get("density", 7850.0))
    stiff, heavy = mpf(elastic_modulus) * width * height**3 / 12, density * width * height
    out = {}
    for nth in range(1, 5):
        word = ends["word"]
        if word == "clamped-free":
            root = findroot(lambda z: cos(z) + 1 / cosh(z), (nth - mpf(1) / 2) * pi + (mpf("0.3") if nth == 1 else 0))
        elif word == "pinned-pinned":
            root = nth * pi
        elif word.endswith("pinned"):
            root = findroot(lambda z: tan(z) - tanh(z), (nth + mpf(1) / 4) * pi)
        else:
            root = findroot(lambda z: cos(z) - 1 / cosh(z), (nth + mpf(1) / 2) * pi)
        out |= {f"modes[{nth - 1}].root": root,
                f"modes[{nth - 1}].frequency": root**2 / (2 * pi * mpf(length) ** 2) * sqrt(stiff / heavy)}  # fmt: skip
    return out


def whirl(mass: float, shaft: Any, eccentricity: float, speed: float, damping_ratio: float = 0.0,
          polar_inertia: float | None = None, diametral_inertia: float | None = None,
          orders: list[float] | None = None) -> dict[str, Any]:  # fmt: skip
    m, w, e, zeta = mpf(mass), mpf(speed), mpf(eccentricity), mpf(damping_ratio)
    if "stiffness" in shaft:
        k = mpf(shaft["stiffness"])
    else:
        length, a = mpf(shaft["length"]), mpf(shaft["position"])
        bending = mpf(210e9) * pi / 64 * mpf(shaft["diameter"]) ** 4
        b = length - a
        # flexibility of a simple beam at the load: displacement and slope by force and moment
        flex = matrix([[a**2 * b**2 / (3 * length), a * b * (b - a) / (3 * length)],
                       [a * b * (b - a) / (3 * length), (a**2 - a * b + b**2) / (3 * length)]])  # fmt: skip
        k = bending / flex[0, 0]
    c = 2 * zeta * sqrt(k * m)
    x = m * e * w * w / (k - m * w * w + mpc(0, 1) * c * w)
    out = {"critical_speed": sqrt(k / m), "amplitude": abs(x), "phase": arg(conj(x)), "bearing_force": abs(x) * k}
    if polar_inertia is not None:
        for sign, name in ((-1, "forward_speed"), (1, "backward_speed")):
            moment = mpf(diametral_inertia) + sign * mpf(polar_inertia)  # type: ignore[arg-type]
            # displacement = flexibility · inertia forces: det(1 − x·flex·diag(m, moment)) = 0, x = Ω²
            trace = (flex[0, 0] * m + flex[1, 1] * moment) / bending
            whole = (flex[0, 0] * flex[1, 1] - flex[0, 1] ** 2) * m * moment / bending**2
            found = [root.real for root in polyroots([whole, -trace, 1], maxsteps=500, extraprec=400)]
            out[name] = sqrt(min(root for root in found if root > 0))
        out |= free_whirls(m, w, [part / bending for part in (flex[0, 0], flex[1, 1], flex[0, 1])], polar_inertia,
                           diametral_inertia, orders or [1.0])  # fmt: skip
    return out


def free_whirls(m: Any, w: Any, flex: list[Any], polar: Any, diametral: Any, orders: list[float]) -> dict[str, Any]:
    """det(1 − flex·diag(mλ², I_dλ² − I_pΩλ)) = 0 for λ at the speed, and for Ω where λ = ±hΩ."""
    p, d, whole = mpf(polar), mpf(diametral), flex[0] * flex[1] - flex[2] ** 2
    quartic = [whole * m * d, -whole * m * p * w, -flex[0] * m - flex[1] * d, flex[1] * p * w, 1]
    rates = [root.real for root in polyroots(quartic, maxsteps=500, extraprec=400)]
    ahead, back = sorted(x for x in rates if x > 0), sorted(-x for x in rates if x < 0)
    out = {}
    for nth, rate in enumerate((back[0], ahead[0], back[1], ahead[1])):
        out |= {f"whirls[{nth}].frequency": rate / (2 * pi), f"whirls[{nth}].order": rate / w}
    row = 0
    for h in map(mpf, orders):
        met = []
        for sign in (1, -1):
            moment = d * h * h - sign * p * h
            squares = polyroots([whole * m * h * h * moment, -flex[0] * m * h * h - flex[1] * moment, 1],
                                maxsteps=500, extraprec=400)  # fmt: skip
            met.append(sorted(sqrt(x.real) for x in squares if x.real > 0))
        for mode in (0, 1):
            for speeds in (met[1], met[0]):
                if mode < len(speeds):
                    out |= {f"criticals[{row}].speed": speeds[mode],
                            f"criticals[{row}].frequency": speeds[mode] * h / (2 * pi)}  # fmt: skip
                    row += 1
    return out


TASKS = {
    "free": free, "forced": forced, "base": base, "unbalance": unbalance, "isolator": isolator, "decrement": decrement,
    "absorber": absorber, "modes": modes, "shaft": shaft, "beam": beam, "whirl": whirl,
}  # fmt: skip


def of(record: str, **fields: Any) -> dict[str, Any]:
    return {"record": record, **fields}


def spring(k: float) -> dict[str, Any]:
    return of("Spring", stiffness=k)


def share(zeta: float) -> dict[str, Any]:
    return of("DampingShare", damping_ratio=zeta)


ONE = of("Natural", natural_frequency=1.0)
SOFT = "a soft mount beside stiff springs, which assembled matrices round away"
NEAR = "damping within rounding of critical, where roots of the frequency equation cancel"


def rotor(name: str, inertia: float) -> dict[str, Any]:
    return of("Rotor", name={"word": name}, inertia=inertia)


def piece(one: str, other: str, k: float) -> dict[str, Any]:
    return of("Shaft", from_={"word": one}, to={"word": other}, spring=of("Rate", stiffness=k))


def hard() -> Iterator[tuple[str, str, str, dict[str, Any]]]:
    moving = {"mass": 2.0, "spring": spring(50.0), "displacement": 0.1, "start_velocity": -0.2, "time": 0.7}
    for c, why in ((4.0, ""), (20.00000000001, NEAR), (19.99999999999, NEAR),
                   (400.0, "heavy damping: the slow root is a small difference"),
                   (1e-9, "hardly any damping: decay and phase over many cycles lose digits")):  # fmt: skip
        yield "free", f"damper of {c!r}", why, {**moving, "damping": of("Damper", damping=c)}
    yield (
        "free",
        "a long time, hardly damped",
        "the phase after 1,600 radians has lost three digits of its own",
        {"spring": of("Natural", natural_frequency=8.0), "damping": share(1e-6), "displacement": 0.01, "time": 31.7},
    )
    yield (
        "free",
        "dry friction",
        "what ten bands leave of the start",
        {"mass": 1.0, "spring": spring(200.0), "displacement": 0.05, "damping": of("DryFriction", friction=0.1)},
    )
    unit = {"mass": 1.0, "spring": ONE, "force": 1.0}
    yield (
        "forced",
        "ζ = 1e-8, beside resonance by 1e-9",
        "1 − r² cancels unless the distance itself is given",
        {**unit, "damping": share(1e-8), "excitation": of("AtDetuning", detuning=1e-9)},
    )
    yield "forced", "ζ = 0.05", "", {**unit, "damping": share(0.05), "excitation": of("AtRatio", frequency_ratio=0.8)}
    yield (
        "forced",
        "from rest beside resonance by 1e-10",
        "beside resonance from rest two cosines all but cancel",
        {
            "mass": 2.0,
            "spring": spring(200.0),
            "force": 5.0,
            "excitation": of("AtDetuning", detuning=1e-10),
            "time": 100.0,
        },
    )
    yield (
        "forced",
        "from rest at resonance, ζ = 1e-6",
        "steady and free vibration all but cancel at first",
        {
            "mass": 2.0,
            "spring": spring(200.0),
            "force": 5.0,
            "damping": share(1e-6),
            "excitation": of("AtDetuning", detuning=1e-7),
            "time": 40.0,
        },
    )
    yield (
        "base",
        "ζ = 0.15 at its peak",
        "",
        {
            "spring": ONE,
            "damping": share(0.15),
            "motion": of("Shaking", base_amplitude=0.001),
            "excitation": of("AtRatio", frequency_ratio=0.9791041774103826),
        },
    )
    yield (
        "base",
        "far above resonance, hardly damped",
        "a transmissibility that is a quotient of nearly nothing",
        {
            "spring": ONE,
            "damping": share(1e-4),
            "motion": of("BaseAcceleration", base_acceleration=5.0),
            "excitation": of("AtRatio", frequency_ratio=300.0),
        },
    )
    yield (
        "unbalance",
        "ζ = 0.15 at its peak",
        "",
        {
            "mass": 200.0,
            "unbalance": 0.002,
            "spring": ONE,
            "damping": share(0.15),
            "excitation": of("AtRatio", frequency_ratio=1.0232890201933018),
        },
    )
    yield (
        "isolator",
        "a tenth at 25 Hz",
        "",
        {
            "excitation": of("AtFrequency", frequency=25.0),
            "wish": of("Passing", transmissibility=0.1),
            "damping_ratio": 0.05,
            "mass": 400.0,
        },
    )
    yield (
        "isolator",
        "one part in 1e8",
        "a root far out: the frequency ratio is in the ten thousands",
        {
            "excitation": of("AtFrequency", frequency=25.0),
            "wish": of("Passing", transmissibility=1e-8),
            "damping_ratio": 1e-3,
        },
    )
    yield (
        "decrement",
        "four peaks",
        "logarithms that nearly lie on a line leave little",
        {"measured": of("Peaks", peaks=[12.1, 9.8, 7.9, 6.5])},
    )
    yield (
        "decrement",
        "peaks that hardly fall",
        "logarithms of nearly equal numbers cancel",
        {"measured": of("Peaks", peaks=[1.0, 0.99999999, 0.99999998])},
    )
    yield (
        "decrement",
        "half power, ζ = 0.05",
        "",
        {"measured": of("HalfPower", lower_frequency=9.461105000066637, upper_frequency=10.463627104294146)},
    )
    for mu in (0.05, 0.01, 0.2):
        yield "absorber", f"Den Hartog, μ = {mu}", "", {"size": of("MassRatio", mass_ratio=mu)}
    yield (
        "absorber",
        "least peak, μ = 0.05",
        "",
        {"size": of("MassRatio", mass_ratio=0.05), "tune": of("RuleTuning", tuning={"word": "minimax"})},
    )
    yield (
        "absorber",
        "as wanted",
        "",
        {"size": of("MassRatio", mass_ratio=0.1), "tune": of("ChosenTuning", frequency_ratio=0.92, damping_ratio=0.15)},
    )
    yield (
        "modes",
        "soft mount on a stiff chain",
        SOFT,
        {"system": of("Line", masses=[1.0] * 4, stiffnesses=[1e-3, 1e15, 1e15, 1e15])},
    )
    yield (
        "modes",
        "chain of 1, 1e14 and 1000 N/m",
        SOFT,
        {"system": of("Line", masses=[1.0, 2.0, 3.0], stiffnesses=[1.0, 1e14, 1e3])},
    )
    yield (
        "modes",
        "free line of 1, 1e12 and 1e12",
        SOFT,
        {"system": of("Line", masses=[1.0] * 4, stiffnesses=[1.0, 1e12, 1e12])},
    )
    yield (
        "modes",
        "masses of 1e-6, 1 and 1e6",
        "a light mass beside heavy ones",
        {"system": of("Line", masses=[1e-6, 1.0, 1e6], stiffnesses=[1.0, 2.0, 3.0])},
    )
    yield "modes", "three alike", "", {"system": of("Line", masses=[1.0] * 3, stiffnesses=[1.0] * 3)}
    yield (
        "shaft",
        "geared 20:60",
        "",
        {
            "rotors": [rotor("motor", 0.5), rotor("pinion", 0.01), rotor("wheel", 0.3), rotor("drum", 4.0)],
            "shafts": [piece("motor", "pinion", 2000.0), piece("wheel", "drum", 9000.0)],
            "gears": [
                of("Gear", driver={"word": "pinion"}, driven={"word": "wheel"}, ratio_of=of("BySpeeds", ratio=3.0))
            ],
        },
    )
    yield (
        "shaft",
        "a stiff coupling beside a soft one",
        SOFT,
        {
            "rotors": [rotor("a", 1.0), rotor("b", 1.0), rotor("c", 1.0), rotor("d", 2.0)],
            "shafts": [piece("a", "b", 1e13), piece("b", "c", 0.5), piece("b", "d", 1e13)],
        },
    )
    steel = of("Rectangle", width=0.04, height=0.01)
    for word in ("clamped-free", "pinned-pinned", "clamped-clamped", "clamped-pinned", "free-free", "free-pinned"):
        yield "beam", word, "", {"ends": {"word": word}, "length": 0.8, "section": steel}
    bar = of("Bar", diameter=0.04, length=0.9, position=0.3)
    yield (
        "whirl",
        "a disk that tilts",
        "",
        {
            "mass": 30.0,
            "shaft": bar,
            "eccentricity": 2e-5,
            "speed": 377.0,
            "damping_ratio": 0.02,
            "polar_inertia": 0.5,
            "diametral_inertia": 0.25,
        },
    )
    thick = {"mass": 30.0, "shaft": of("Bar", diameter=0.04, length=0.9, position=0.7), "eccentricity": 2e-5,
             "speed": 1500.0, "polar_inertia": 0.5, "diametral_inertia": 0.75, "orders": [0.5, 1.0, 2.0]}  # fmt: skip
    yield "whirl", "a thick disk and three orders", "", thick
    middle = thick | {"shaft": of("Bar", diameter=0.04, length=0.9, position=0.45)}
    yield "whirl", "a thick disk in the middle, where tilt and shift part", "", middle
    beside = of("Bar", diameter=0.04, length=0.9, position=0.001)
    yield "whirl", "a disk beside a bearing", "k₁₁·k₂₂ − k₁₂² all but cancels", thick | {"shaft": beside}
    fast = thick | {"speed": 1e6}
    yield (
        "whirl",
        "so fast that the gyroscopic moment rules",
        "frequencies six orders apart: the smaller is lost in the sum of both",
        fast,
    )
    yield (
        "whirl",
        "just beside the critical speed",
        "the difference of the two speeds all but cancels",
        {
            "mass": 1.0,
            "shaft": of("Known", stiffness=1e4),
            "eccentricity": 2e-5,
            "speed": 100.00000001,
            "damping_ratio": 1e-9,
        },
    )


def drawn(generator: random.Random) -> Iterator[tuple[str, dict[str, Any]]]:
    def size(low: float, high: float) -> float:
        return float(f"{low * (high / low) ** generator.random():.6g}")

    for _ in range(6):
        m, k, zeta = size(0.1, 1e3), size(1e3, 1e6), size(1e-3, 0.35)
        yield (
            "free",
            {
                "mass": m,
                "spring": spring(k),
                "damping": share(zeta),
                "displacement": size(1e-3, 0.1),
                "start_velocity": -size(1e-2, 1.0),
                "time": size(1e-3, 1.0),
            },
        )
        excitation = of("AtFrequency", frequency=size(1.0, 100.0))
        yield (
            "forced",
            {"mass": m, "spring": spring(k), "damping": share(zeta), "force": size(1.0, 1e3), "excitation": excitation},
        )
        yield (
            "base",
            {
                "mass": m,
                "spring": spring(k),
                "damping": share(zeta),
                "excitation": excitation,
                "motion": of("Shaking", base_amplitude=size(1e-5, 1e-2)),
            },
        )
        yield (
            "unbalance",
            {
                "mass": m,
                "spring": spring(k),
                "damping": share(zeta),
                "unbalance": size(1e-4, 1e-2),
                "excitation": of("AtSpeed", speed=size(10.0, 600.0)),
            },
        )
        yield (
            "isolator",
            {"excitation": excitation, "wish": of("Kept", isolation=size(0.3, 0.98)), "damping_ratio": size(1e-3, 0.2)},
        )
        n = generator.randint(2, 6)
        yield (
            "modes",
            {
                "system": of(
                    "Line", masses=[size(0.1, 100.0) for _ in range(n)], stiffnesses=[size(1e2, 1e6) for _ in range(n)]
                )
            },
        )
        yield (
            "shaft",
            {
                "rotors": [rotor(name, size(0.01, 10.0)) for name in "abcd"],
                "shafts": [piece("a", "b", size(1e3, 1e5)), piece("c", "d", size(1e3, 1e5))],
                "gears": [
                    of(
                        "Gear",
                        driver={"word": "b"},
                        driven={"word": "c"},
                        ratio_of=of("BySpeeds", ratio=size(0.2, 5.0)),
                    )
                ],
            },
        )


def written(tree: Any) -> Any:
    if isinstance(tree, float):
        return repr(tree)
    if isinstance(tree, dict):
        return {name: part if name in ("record", "word") else written(part) for name, part in tree.items()}
    return [written(part) for part in tree]


def case(task: str, kind: str, name: str, why: str, inputs: dict[str, Any]) -> dict[str, Any]:
    results = {key: nstr(mpf(value), 40, min_fixed=1, max_fixed=0) for key, value in TASKS[task](**inputs).items()}
    return {"task": task, "kind": kind, "name": name, **({"why": why} if why else {}), "inputs": written(inputs),
            "results": results}  # fmt: skip


def main() -> None:
    cases = [case(task, "hard" if why else "ordinary", name, why, inputs) for task, name, why, inputs in hard()]
    for nth, (task, inputs) in enumerate(drawn(random.Random(13)), 1):
        cases.append(case(task, "ordinary", f"drawn, {nth}", "", inputs))
    about = "Written by generate_vibration_references.py: inputs are the doubles, results to 40 digits."
    put("vibration", about, cases)


if __name__ == "__main__":
    main()
