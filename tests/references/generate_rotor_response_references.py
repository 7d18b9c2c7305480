"""Writes tests/vibration/rotor_response.json: rotors on bearings of eight coefficients to 40 digits.

Sections are solved exactly in z = x + iy and w = x − iy, which turn apart from one another on a round shaft: the
exponential of their equations carries both from end to end past disks, unbalances and bearings; bearings alone join
them. The response solves what is left at the far end; free whirls are zeros of its determinant, found by Muller's
method near the rates that a case names.

Run: python tests/references/generate_rotor_response_references.py [FILE]. The same bytes every time.
"""

import json
import sys
from pathlib import Path
from typing import Any

from generate_rotor_references import STEPPED, _law
from mpmath import arg, e, expm, findroot, lu_solve, matrix, mp, mpc, mpf, nstr, pi

mp.dps = 50
TARGET = Path(__file__).resolve().parents[1] / "vibration" / "rotor_response.json"

# bearings: place, kxx, kyy, cxx, cyy, kxy, kyx, cxy, cyx, swirl; disks: place, mass, polar, diametral inertia
CASES: list[dict[str, Any]] = [
    {"name": "anisotropic, damped", "sections": STEPPED,
     "bearings": [[0.06, 80e6, 140e6, 4e4, 6e4, 0, 0, 0, 0, 0], [0.75, 60e6, 100e6, 3e4, 5e4, 0, 0, 0, 0, 0]],
     "disks": [[0.4, 35.0, 0.8, 0.4], [0.97, 12.0, 0.2, 0.11]],
     "unbalances": [[0.4, 5e-4, 0.0], [0.97, 3e-4, 2.0]], "read": [0.4, 0.97], "speeds": [150.0, 560.0, 700.0],
     "free": 300.0, "near": [[-3, 519], [-3, 585]]},
    {"name": "eight coefficients, cross-coupled", "sections": [[1.2, 0.08, 0.0]],
     "bearings": [[0.1, 30e6, 60e6, 8e4, 1.2e5, 1e7, -2.5e7, -1e4, -1e4, 0],
                  [1.1, 30e6, 60e6, 8e4, 1.2e5, 1e7, -2.5e7, -1e4, -1e4, 0]],
     "disks": [[0.5, 60.0, 1.2, 0.7]], "unbalances": [[0.5, 1e-3, 1.0], [0.9, 4e-4, -1.0]], "read": [0.5],
     "speeds": [200.0, 420.0, 600.0], "free": 400.0, "near": [[-41, 467], [-24, 491]]},
    {"name": "oil film that swirls, and a rigid bearing", "sections": [[1.0, 0.05, 0.02]],
     "bearings": [[0.0, None, None, 0, 0, 0, 0, 0, 0, 0], [0.9, 2e7, 3e7, 3e4, 3e4, 0, 0, 0, 0, 0.48]],
     "disks": [[0.6, 20.0, 0.3, 0.15]], "unbalances": [[0.6, 2e-4, 0.5]], "read": [0.6, 0.9],
     "speeds": [100.0, 350.0, 500.0], "free": 1200.0, "near": [[-6, 411], [3, 427]]},
]  # fmt: skip


def bearing(given: list[Any], s: Any, speed: Any) -> Any:
    """Force on the bearing in z and w per deflection in z and w: T·(K + sC)·T⁻¹."""
    _, kxx, kyy, cxx, cyy, kxy, kyx, cxy, cyx, swirl = (mpf(str(each)) for each in given)
    damping = matrix([[cxx, cxy], [cyx, cyy]])
    # the speed against the film, whose own is swirl·speed: ẋ + swirl·speed·y, ẏ − swirl·speed·x
    against = matrix([[s, swirl * speed], [-swirl * speed, s]])
    turn = matrix([[1, mpc(0, 1)], [1, mpc(0, -1)]])
    return turn * (matrix([[kxx, kxy], [kyx, kyy]]) + damping * against) * turn**-1


def solved(case: dict[str, Any], s: Any, speed: Any) -> tuple[Any, Any, dict[float, Any], list[Any]]:
    """What is left, per unknown and by the unbalances, and the states where they are read."""
    rigid = [each[0] for each in case["bearings"] if each[1] is None]
    size = 4 + 2 * len(rigid)
    # columns: deflection and slope of the left end in z and w, forces of rigid bearings, the unbalances
    state = matrix(8, size + 1)
    for row, column in ((0, 0), (1, 1), (4, 2), (5, 3)):
        state[row, column] = 1
    events = sorted(
        [(each[0], kind, each) for kind in ("bearings", "disks", "unbalances") for each in case[kind]]
        + [(place, "read", None) for place in case["read"]],
        key=lambda event: (event[0], event[1]),
    )  # fmt: skip
    rows, forces, read = [], [], {}
    at = end = mpf(0)
    rate, held = mpc(0, -1) * s, 4
    for length, diameter, bore in case["sections"]:
        end += mpf(str(length))
        laws = [_law(rate, turning, mpf(str(diameter)), mpf(str(bore)), True) for turning in (speed, -speed)]

        def carried(state: Any, along: Any, laws: Any = laws) -> Any:
            parts = [expm(law * along) for law in laws]
            return matrix([
                [sum(parts[i // 4][i % 4, k] * state[4 * (i // 4) + k, j] for k in range(4)) for j in range(size + 1)]
                for i in range(8)
            ])  # fmt: skip

        while events and mpf(str(events[0][0])) <= end:
            place, kind, given = events.pop(0)
            state = carried(state, mpf(str(place)) - at)
            at = mpf(str(place))
            columns = range(size + 1)
            if kind == "disks":
                mass, polar, across = (mpf(str(each)) for each in given[1:])
                for base, turning in ((0, speed), (4, -speed)):
                    for j in columns:
                        state[base + 3, j] -= rate**2 * mass * state[base, j]
                        state[base + 2, j] -= (rate**2 * across - rate * turning * polar) * state[base + 1, j]
            elif kind == "unbalances":
                size_, angle = mpf(str(given[1])), mpf(str(given[2]))
                # x = Re u, y = Re(−iu): z is driven by 2u beside e^{iΩt}, w by nothing
                state[3, size] -= 2 * size_ * e ** mpc(0, angle) * speed**2
            elif kind == "bearings" and given[1] is None:
                for base, column in ((0, held), (4, held + 1)):
                    rows.append([state[base, j] for j in columns])
                    state[base + 3, column] += mpf(10) ** 6
                forces.append(("rigid", held))
                held += 2
            elif kind == "bearings":
                dynamic = bearing(given, s, speed)
                taken = [[dynamic[i, 0] * state[0, j] + dynamic[i, 1] * state[4, j] for j in columns] for i in (0, 1)]
                for j in columns:
                    state[3, j] += taken[0][j]
                    state[7, j] += taken[1][j]
                forces.append(("soft", taken))
            else:
                read[place] = [[state[i, j] for j in columns] for i in (0, 4)]
        state = carried(state, end - at)
        at = end
    rows += [[state[i, j] for j in range(size + 1)] for i in (2, 3, 6, 7)]
    return matrix([row[:-1] for row in rows]), matrix([-row[-1] for row in rows]), read, forces


def xy(z: Any, w: Any) -> list[Any]:
    """Amplitude and lag behind the mark, horizontal and vertical."""
    x, y = (z + w) / 2, (z - w) / mpc(0, 2)
    return [abs(x), -arg(x) % (2 * pi), abs(y), -arg(mpc(0, 1) * y) % (2 * pi)]


def results(case: dict[str, Any]) -> dict[str, Any]:
    """Orbits and forces at the speeds; free whirls."""
    found: dict[str, Any] = {"orbits": [], "forces": [], "whirls": []}
    for speed in map(mpf, case["speeds"]):
        left, right, read, forces = solved(case, mpc(0, speed), speed)
        unknown = [*lu_solve(left, right), mpf(1)]
        for place in case["read"]:
            z, w = (sum(a * b for a, b in zip(row, unknown, strict=True)) for row in read[place])
            found["orbits"].append([nstr(each, 40) for each in xy(z, w)])
        for kind, given in forces:
            if kind == "rigid":
                z, w = (mpf(10) ** 6 * unknown[given + k] for k in (0, 1))
            else:
                z, w = (sum(a * b for a, b in zip(row, unknown, strict=True)) for row in given)
            found["forces"].append([nstr(xy(z, w)[k], 40) for k in (0, 2)])
    for real, imaginary in case["near"]:
        start = mpc(real, imaginary)
        scale = abs(mp.det(solved(case, start, mpf(case["free"]))[0]))
        root = findroot(lambda s, size=scale: mp.det(solved(case, s, mpf(case["free"]))[0]) / size,
                        (start, start * mpf("1.001"), start + 1), solver="muller", tol=mpf(10) ** -42)  # fmt: skip
        found["whirls"].append([nstr(root.real, 40), nstr(root.imag, 40)])
    return found


def main() -> None:
    """Write the cases to the file, or to the one named on the command line."""
    lines = ",\n".join(json.dumps({**case, "results": results(case)}, ensure_ascii=False) for case in CASES)
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else TARGET
    target.write_text(f"[\n{lines}\n]\n", encoding="utf-8")


if __name__ == "__main__":
    main()
