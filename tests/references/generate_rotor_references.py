"""Writes tests/vibration/rotor.json: whirls and critical speeds of stepped rotors to 40 digits.

Sections are solved exactly: the exponential of their equations carries deflection, slope, moment and force from one
free end to the other, past springs and disks; whirls are the zeros of what is left at the far end. They are looked for
on a grid of doubles and refined in 50 digits. Rigid bearings take an unknown force each.

Run: python tests/references/generate_rotor_references.py [FILE]. The same bytes every time.
"""

import json
import sys
from pathlib import Path
from typing import Any

import numpy as np
from mpmath import expm, findroot, matrix, mp, mpf, nstr, pi
from scipy.linalg import expm as expm_of_doubles

mp.dps = 50
TARGET = Path(__file__).resolve().parents[1] / "vibration" / "rotor.json"
E, RHO, NU = 210e9, 7850.0, "0.3"
# Whirls of each direction, and the grid that they are looked for on: shares of the highest rate.
MODES, GRID = 2, 600

STEPPED = [(0.2, 0.05, 0.0), (0.5, 0.065, 0.02), (0.3, 0.05, 0.0)]
CASES: list[dict[str, Any]] = [
    {"name": "uniform, rigid bearings inside", "sections": [(1.2, 0.06, 0.02)],
     "bearings": [(0.1, None, 0.0), (1.05, None, 0.0)], "disks": [], "speed": 500.0, "highest": 9e3},
    {"name": "stepped, two disks, soft bearings", "sections": STEPPED,
     "bearings": [(0.06, 80e6, 1e4), (0.75, 60e6, 0.0)],
     "disks": [(0.4, 35.0, 0.8, 0.4), (0.97, 12.0, 0.2, 0.11)], "speed": 500.0, "highest": 4e3},
    {"name": "the same, three bearings, one rigid", "sections": STEPPED,
     "bearings": [(0.06, 80e6, 0.0), (0.5, None, 0.0), (0.75, 60e6, 0.0)],
     "disks": [(0.35, 35.0, 0.8, 0.4), (0.97, 12.0, 0.2, 0.11)], "speed": 900.0, "highest": 6e3},
    # the overhung disk stiffens with speed as fast as unbalance turns it where both inertias are alike
    *({"name": f"overhung disk, inertia {polar} about its axis", "sections": [(0.9, 0.04, 0.0)],
       "bearings": [(0.1, None, 0.0), (0.6, 50e6, 0.0)], "disks": [(0.9, 20.0, polar, 0.35)], "speed": 300.0,
       "highest": 5e3} for polar in (0.25, 0.3499, 0.3501, 0.6)),
]  # fmt: skip


class Rotor:
    """The determinant of a rotor that turns at a speed and whirls at a rate, in doubles or in many digits."""

    def __init__(self, case: dict[str, Any]) -> None:
        self.case = case
        self.rigid = [place for place, stiffness, _ in case["bearings"] if stiffness is None]

    def left(self, rate: Any, speed: Any, exact: bool) -> Any:
        """What is left of moment and force at the far end and of deflections at rigid bearings."""
        number = mpf if exact else float
        power = expm if exact else expm_of_doubles
        size = 2 + len(self.rigid)
        # columns: deflection and slope of the left end, force of each rigid bearing
        state = _zeros(4, size, exact)
        state[0, 0] = state[1, 1] = number(1)
        rows, at, held = [], number(0), 0
        events = sorted(
            [(place, "bearing", *rest) for place, *rest in self.case["bearings"]]
            + [(place, "disk", *rest) for place, *rest in self.case["disks"]],
            key=lambda event: event[0],
        )
        end = number(0)
        for length, diameter, bore in self.case["sections"]:
            end += number(length)
            law = _law(rate, speed, number(diameter), number(bore), exact)
            while events and number(events[0][0]) <= end:
                place, kind, *given = events.pop(0)
                state = _product(power(law * (number(place) - at)), state, exact)
                at = number(place)
                if kind == "disk":
                    mass, polar, across = map(number, given)
                    _add(state, 3, 0, -(rate**2) * mass)
                    _add(state, 2, 1, -(rate**2 * across - rate * speed * polar))
                elif given[0] is None:
                    rows.append([state[0, k] for k in range(size)])
                    state[3, 2 + held] += number(1e6)
                    held += 1
                else:
                    _add(state, 3, 0, number(given[0]))
                    _add(state, 2, 1, number(given[1]))
            state = _product(power(law * (end - at)), state, exact)
            at = end
        rows += [[state[k, j] for j in range(size)] for k in (2, 3)]
        return mp.det(matrix(rows)) if exact else float(np.linalg.det(np.array(rows)))


def _zeros(rows: int, columns: int, exact: bool) -> Any:
    return matrix(rows, columns) if exact else np.zeros((rows, columns))


def _product(one: Any, two: Any, exact: bool) -> Any:
    return one * two if exact else one @ two


def _add(state: Any, row: int, of: int, factor: Any) -> None:
    columns = state.cols if hasattr(state, "cols") else state.shape[1]
    for k in range(columns):
        state[row, k] += factor * state[of, k]


def _law(rate: Any, speed: Any, diameter: Any, bore: Any, exact: bool) -> Any:
    round_ = pi if exact else float(pi)
    area, second = round_ / 4 * (diameter**2 - bore**2), round_ / 64 * (diameter**4 - bore**4)
    density, modulus = (mpf(RHO), mpf(E)) if exact else (RHO, E)
    law = _zeros(4, 4, exact)
    law[0, 1], law[1, 2] = 1, 1 / (modulus * second)
    # slope = turn of the section + shear by the coefficient of Cowper, G = E/(2(1 + ν))
    nu = mpf(NU) if exact else float(NU)
    hollow = (bore / diameter) ** 2
    shape = 6 * (1 + nu) * (1 + hollow) ** 2
    shape /= (7 + 6 * nu) * (1 + hollow) ** 2 + (20 + 12 * nu) * hollow
    law[0, 3] = 1 / (shape * modulus / (2 * (1 + nu)) * area)
    law[2, 1], law[2, 3] = -density * second * (rate**2 - 2 * rate * speed), -1
    law[3, 0] = -(rate**2) * density * area
    return law


def zeros(left: Any, highest: float, count: int) -> list[Any]:
    """The lowest rates at which nothing is left."""
    rates = [highest * (k + 0.5) / GRID for k in range(GRID)]
    values = [left(rate, False) for rate in rates]
    found = []
    for low, high, one, other in zip(rates, rates[1:], values, values[1:], strict=False):
        if one * other < 0.0 and len(found) < count:
            size = abs(left(mpf(low), True))
            found.append(findroot(lambda x, s=size: left(x, True) / s, (mpf(low), mpf(high)), solver="anderson",
                                  tol=mpf(10) ** -44))  # fmt: skip
    return found


def results(case: dict[str, Any]) -> dict[str, list[str]]:
    """Whirls at the speed in rad/s, and critical speeds by order."""
    rotor, speed, highest = Rotor(case), case["speed"], case["highest"]
    exact_speed = mpf(speed)

    def whirl(way: int) -> Any:
        return lambda rate, exact: rotor.left(way * rate, exact_speed if exact else speed, exact)

    def critical(way: int, order: int) -> Any:
        return lambda rate, exact: rotor.left(way * rate, rate / order, exact)

    found = {"forward": zeros(whirl(1), highest, MODES), "backward": zeros(whirl(-1), highest, MODES)}
    for order in (1, 2):
        for name, way in (("forward", 1), ("backward", -1)):
            met = zeros(critical(way, order), highest, MODES)
            found[f"{name} {order}"] = [rate / order for rate in met]
    return {name: [nstr(x, 40) for x in values] for name, values in found.items()}


def main() -> None:
    """Write the cases to the file, or to the one named on the command line."""
    lines = ",\n".join(json.dumps({**case, "results": results(case)}, ensure_ascii=False) for case in CASES)
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else TARGET
    target.write_text(f"[\n{lines}\n]\n", encoding="utf-8")


if __name__ == "__main__":
    main()
