"""Vibration and stability beside other people's libraries: errors, what each does at the hard cases, and speeds.

Run where they are installed, with this project on the path, for example from an environment of its own:
    pip install numpy scipy mpmath control opentorsion vibration-toolbox
    OPENBLAS_NUM_THREADS=1 PYTHONPATH=. python tests/benchmarks/vibration_peers.py [--write]
`--write` puts the tables into docs/vibration.md and docs/stability.md. A missing library leaves its cells empty.
Speeds are processor time of one thread, the best of several, as ratios in one run.
"""

import contextlib
import importlib
import io
import math
import sys
import time
import warnings
from collections.abc import Callable
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np
from mpmath import diag, eigsy, matrix, mp, mpf, sqrt
from scipy.linalg import eigh
from scipy.signal import lsim

from dynamics_cli.stability.delay import delay
from dynamics_cli.stability.gain import gain
from dynamics_cli.stability.routh import routh
from dynamics_cli.vibration.shocks.shock import shock
from dynamics_cli.vibration.shocks.transient import transient
from dynamics_cli.vibration.systems.inputs import Line, System
from dynamics_cli.vibration.systems.modal import Modal
from dynamics_cli.vibration.systems.modes import modes

DOCS = Path(__file__).resolve().parents[2] / "docs"
mp.dps = 80
NONE = "–"
CHAINS = {
    "4 × 1 kg, a mount of 1e-3 N/m, springs of 1e15": ((1.0,) * 4, (1e-3, 1e15, 1e15, 1e15)),
    "1, 2, 3 kg, springs 1, 1e14, 1000 N/m": ((1.0, 2.0, 3.0), (1.0, 1e14, 1e3)),
    "free, 4 × 1 kg, springs 1, 1e12, 1e12 N/m": ((1.0,) * 4, (1.0, 1e12, 1e12)),
    "ordinary: 1, 2, 3 kg, springs 100, 200, 50 N/m": ((1.0, 2.0, 3.0), (100.0, 200.0, 50.0)),
}
ROOTS = {
    "s⁶+s⁵+3s⁴+3s³+3s²+2s+1 (2 on the axis)": ("s^6+s^5+3s^4+3s^3+3s^2+2s+1", [1, 1, 3, 3, 3, 2, 1]),
    "(s²+1)²(s+1) (4 on the axis)": ("(s^2+1)^2(s+1)", [1, 1, 2, 2, 1, 1]),
    "((s+1e-6)²+1)³(s+1)": ("((s+1e-6)^2+1)^3(s+1)", np.polymul(np.poly1d([1, 2e-6, 1 + 1e-12]) ** 3, [1, 1])),
    "((s−1e-12)²+1)(s²+3s+7)": ("((s-1e-12)^2+1)(s^2+3s+7)", np.polymul([1, -2e-12, 1 + 1e-24], [1, 3, 7])),
    "s⁴+4": ("s^4+4", [1, 0, 0, 0, 4]),
}


def module(name: str) -> Any:
    """A library, or nothing; one that asks for a style that matplotlib has dropped is given another."""
    try:
        if name == "vibration_toolbox":
            import matplotlib.style

            matplotlib.style.use = lambda *_: None
        with contextlib.redirect_stdout(io.StringIO()):
            return importlib.import_module(name)
    except ImportError:
        return None


def tried(call: Callable[..., Any], *given: Any) -> Any:
    """An answer, or the name of what was raised."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            return call(*given)
        except Exception as error:  # any refusal is one of a library's answers here
            return type(error).__name__


def table(title: str, heads: "list[str]", rows: "list[list[str]]") -> str:
    lines = [f"| {title} | " + " | ".join(heads) + " |", "|---|" + "---:|" * len(heads)]
    return "\n".join([*lines, *("| " + " | ".join(row) + " |" for row in rows)])


# ---- modes ----


def assembled(masses: Any, springs: Any) -> "tuple[Any, Any]":
    n = len(masses)
    stiffness = np.zeros((n, n), dtype=object)
    first = 0 if len(springs) == n else 1
    for nth, k in enumerate(springs):
        i, j = nth + first - 1, nth + first
        for a, b, sign in ((i, i, 1), (j, j, 1), (i, j, -1), (j, i, -1)):
            if a >= 0 and b >= 0:
                stiffness[a, b] += sign * k
    return np.diag(np.array(masses, dtype=object)), stiffness


def true_rates(masses: Any, springs: Any) -> "list[Any]":
    mass, stiffness = assembled([mpf(m) for m in masses], [mpf(k) for k in springs])
    root = diag([1 / sqrt(m) for m in np.diag(mass)])
    values = sorted(eigsy(root * matrix(stiffness.tolist()) * root, eigvals_only=True))
    return [sqrt(abs(value)) if abs(value) > mpf("1e-50") else mpf(0) for value in values]


def mode_rates(name: str, masses: Any, springs: Any) -> Any:
    mass, stiffness = (part.astype(float) for part in assembled(masses, springs))
    if name == "dynamics":
        return [mode.angular_frequency for mode in modes(system=Line(masses, springs)).modes]
    if name == "scipy eigh":
        return np.sqrt(abs(eigh(stiffness, mass, eigvals_only=True)))
    if name == "inv(M) @ K":
        return np.sort(np.sqrt(abs(np.linalg.eigvals(np.linalg.inv(mass) @ stiffness))))
    if name == "opentorsion":
        torsion = module("opentorsion")
        if torsion is None or len(springs) == len(masses):
            return None
        shafts = [torsion.Shaft(i, i + 1, L=None, odl=None, k=k, I=0.0) for i, k in enumerate(springs)]
        line = torsion.Assembly(shafts, disk_elements=[torsion.Disk(i, I=m) for i, m in enumerate(masses)])
        return np.sort(np.asarray(line.modal_analysis()[0]))[::2]
    toolbox = module("vibration_toolbox")
    if toolbox is None:
        return None
    return np.sort(np.asarray(toolbox.modes_system_undamped(mass, stiffness)[0]))


def mode_table() -> str:
    names = ["dynamics", "scipy eigh", "inv(M) @ K", "opentorsion", "vibration_toolbox"]
    rows = []
    for title, (masses, springs) in CHAINS.items():
        true = true_rates(masses, springs)
        cells = [title]
        for name in names:
            rates = tried(mode_rates, name, masses, springs)
            if rates is None or isinstance(rates, str):
                cells.append(rates or NONE)
                continue
            pairs = list(zip(rates, true, strict=True))
            worst = max(abs(float(x) / float(w) - 1.0) for x, w in pairs if w)
            rigid = [float(x) for x, w in pairs if not w]
            cells.append(f"{worst:.0e}" + (f", rigid mode {max(rigid):.2g} rad/s" if rigid else ""))
        rows.append(cells)
    return table("worst error of a frequency", names, rows)


# ---- records ----


def record_table(folder: Path) -> str:
    """The largest displacement under a recorded force, the samples at n to a cycle of the oscillator."""
    from dynamics_cli.vibration.shocks.transient import Recorded
    from dynamics_cli.vibration.single.oscillator import DampingShare, Natural

    rows = []
    for n in (5, 10, 20):
        times = np.arange(0.0, 2.0 + 1e-9, 1.0 / n)
        loads = np.zeros(len(times))
        loads[1:3] = 1.0, 0.382  # two samples whose ringing peaks midway between later ones, at five to a cycle
        file = folder / "record.csv"
        file.write_text(
            "t[s],a[m/s^2]\n" + "".join(f"{t!r},{a!r}\n" for t, a in zip(times.tolist(), loads.tolist(), strict=True))
        )
        omega, zeta = 2.0 * math.pi, 0.05
        system = ([[0.0, 1.0], [-(omega**2), -2.0 * zeta * omega]], [[0.0], [-1.0]], [[1.0, 0.0]], [[0.0]])
        fine = np.linspace(0.0, times[-1], 200 * (len(times) - 1) + 1)
        true = abs(lsim(system, np.interp(fine, times, loads), fine)[1]).max()
        ours = abs(transient(spring=Natural(1.0), damping=DampingShare(zeta), load=Recorded(str(file))).peak)
        sampled = abs(lsim(system, loads, times)[1]).max()
        rows.append([f"{n} samples a cycle", f"{abs(ours / true - 1):.0e}", f"{abs(sampled / true - 1):.0e}"])
    return table("largest response to a record: error", ["dynamics transient", "scipy lsim, largest sample"], rows)


# ---- stability ----


def root_table() -> str:
    control = module("control")
    rows = []
    for title, (text, given) in ROOTS.items():
        coefficients = np.poly1d(given).coeffs.astype(float)
        made = routh(text)
        found = np.roots(coefficients)
        cells = [title, f"{made.left}, {made.right}, {made.axis}", _sides(found)]
        cells.append(NONE if control is None else _sides(tried(lambda c: control.tf([1.0], c).poles(), coefficients)))
        rows.append(cells)
    return table("roots left, right, on the axis", ["dynamics routh", "numpy.roots", "control poles"], rows)


def _sides(found: Any) -> str:
    left, right = int((found.real < 0.0).sum()), int((found.real > 0.0).sum())
    return f"{left}, {right}, {len(found) - left - right}"


def margin_table() -> str:
    control = module("control")
    loop, plant = "s(s+4)(s+6)(s^2+1.4s+1) + K(s^2+2s+4)", "s² + 0.4s + 1 + 0.5·e^(−sτ)"
    ours, late = gain(loop).stable, delay("s^2 + 0.4s + 1", delayed="0.5").stable
    theirs = [NONE, NONE]
    if control is not None:
        open_loop = control.tf([1, 2, 4], np.polymul(np.polymul([1, 4, 0], [1, 6]), [1, 1.4, 1]))
        low = tried(control.margin, 20 * open_loop)
        high = tried(control.margin, 100 * open_loop)
        theirs[0] = f"gain margin {low[0]:.4g} at K = 20, {high[0]:.4g} at K = 100; one end each"
        _, phase, _, at = tried(control.margin, control.tf([0.5], [1, 0.4, 1]))
        theirs[1] = (
            f"phase margin {phase:.4g}° at {at:.5g} rad/s: a delay of {math.radians(phase) / at:.5g} s, no second range"
        )
    rows = [[f"`{loop}`", ours, theirs[0]], [plant, late, theirs[1]]]
    return table("where the loop is stable", ["dynamics gain, delay", "control margin"], rows)


# ---- speeds ----


def fastest(call: Callable[[], Any], rounds: int = 7) -> float:
    best = math.inf
    for _ in range(rounds):
        start = time.process_time()
        call()
        best = min(best, time.process_time() - start)
    return best


def speed_table(folder: Path) -> str:
    from dynamics_cli.vibration.shafts.line import Rate, Rotor, Shaft
    from dynamics_cli.vibration.shafts.shaft import shaft
    from dynamics_cli.vibration.shocks.shock import Recorded

    generator = np.random.default_rng(1)
    masses, springs = generator.uniform(1.0, 5.0, 200).tolist(), generator.uniform(1e3, 1e5, 200).tolist()
    line = Line(tuple(masses), tuple(springs))
    mass, stiffness, _ = System(line).matrices()
    whole, plain = fastest(lambda: modes(system=line)), fastest(lambda: eigh(stiffness, mass))
    rows = [["modes of 200 masses, the whole answer", f"{whole / plain:.1f} × `eigh(K, M)`", "1.3"]]

    rotors = tuple(Rotor(str(i), 1.0 + 0.1 * i) for i in range(20))
    shafts = tuple(Shaft(str(i), str(i + 1), Rate(1e4 + 100.0 * i)) for i in range(19))
    rows.append(
        [
            "torsional line of 20",
            f"{1e3 * fastest(lambda: shaft(rotors=rotors, shafts=shafts)):.1f} ms",
            "5 ms",
        ]
    )

    of, rates = Modal(System(Line(tuple(masses[:50]), tuple(springs[:50]))), 0.02), np.linspace(1.0, 300.0, 2000)
    rows.append(
        [
            "frequency response, 50 masses, 2000 points",
            f"{1e3 * fastest(lambda: of.curve(rates, of.shapes[:, 0], 49)):.1f} ms",
            "10 ms",
        ]
    )

    ways = np.geomspace(1e-3, 3.0, 1_000_000)
    zeta = 0.05
    curve = fastest(lambda: 1.0 / np.hypot((1.0 - ways) * (1.0 + ways), 2.0 * zeta * ways))
    from dynamics_cli.vibration.single.base import transmitted

    share = fastest(lambda: transmitted((1.0 - ways) * (1.0 + ways), ways, zeta), 3)
    rows.append(
        [
            "transmissibility of 1e6 rows with its lag, bit for bit as single answers",
            f"{share / fastest(lambda: np.sin(ways)):.1f} × `np.sin`, {share / curve:.1f} × the formula in numpy",
            "1.5",
        ]
    )

    times = np.arange(100_000) * 1e-4
    file = folder / "long.csv"
    pulse = generator.normal(size=100_000)
    file.write_text("t[s],a[g]\n" + "".join(f"{t:.4f},{a:.6f}\n" for t, a in zip(times, pulse, strict=True)))
    read = fastest(lambda: np.loadtxt(file, delimiter=",", skiprows=1), 2)
    spectrum = fastest(lambda: shock(input_=Recorded(str(file)), per_octave=26), 1)
    rows.append(
        [
            "shock spectrum, 1e5 samples × 200 oscillators",
            f"{spectrum:.1f} s, {spectrum / read:.0f} × reading the file",
            "100 passes",
        ]
    )

    eight = "s^8+3s^7+10s^6+24s^5+48s^4+96s^3+128s^2+192s+128"
    rows.append(["`routh` of degree 8 with its roots", f"{1e3 * fastest(lambda: routh(eight)):.1f} ms", "2 ms"])
    return table("speed, processor time of one thread", ["measured", "wanted"], rows)


def main(write: bool) -> None:
    import tempfile

    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        pages = {"vibration": [mode_table(), record_table(folder), speed_table(folder)],
                 "stability": [root_table(), margin_table()]}  # fmt: skip
    names = ("numpy", "scipy", "control", "opentorsion", "vibration-toolbox")
    peers = ", ".join(f"{name} {version(name)}" for name in names if module(name.replace("-", "_")))
    for page, tables in pages.items():
        text = "\n\n".join([*tables, f"Measured with {peers}."])
        print(text, end="\n\n")
        if write:
            path = DOCS / f"{page}.md"
            before, _, rest = path.read_text(encoding="utf-8").partition("<!-- peers -->")
            after = rest.partition("<!-- /peers -->")[2]
            path.write_text(f"{before}<!-- peers -->\n\n{text}\n\n<!-- /peers -->{after}", encoding="utf-8")


if __name__ == "__main__":
    main("--write" in sys.argv[1:])
