"""The longest part of a coupler curve that is straight within a deviation."""

import math

import numpy as np

from dynamics_cli.linkage.fourbar.circuit import FULL, Circuit
from dynamics_cli.linkage.fourbar.curve import angle_at
from dynamics_cli.linkage.fourbar.records import Straight

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

PLACES = 1440
# Fewer places are straight in any case.
FEWEST = 4
# Steps of the search for the narrowest strip, and the share of its width within which it has settled.
STEPS, SETTLED = 60, 1e-6


def straightest(circuit: Circuit, point: complex, within: float) -> "Straight | None":
    """The longest part, none where even four neighbouring places depart farther from a line.

    A part that reaches farther back departs at least as much: its ends move on one after the other.
    """
    u = np.arange(PLACES) * (FULL / PLACES)
    x, y = circuit.place(u, point)
    curve = np.tile(x.parts[0] + 1j * y.parts[0], 2)
    best = (0.0, 0, FEWEST)
    end = FEWEST
    for start in range(PLACES):
        end = max(end, start + FEWEST)
        while end < start + PLACES and _strip(curve[start : end + 1], within)[0] <= within:
            end += 1
        lengths = np.abs(curve[start + FEWEST : end] - curve[start])
        if lengths.size and (longest := float(lengths.max())) > best[0]:
            best = (longest, start, start + FEWEST + int(lengths.argmax()))
    length, start, end = best
    departure, line, middle = _strip(curve[start : end + 1], 0.0)
    if departure > within:
        return None
    angles = [float(angle_at(circuit, u[k % PLACES])) for k in (start, end)]
    first, last = (middle + line * np.real(np.conj(line) * (z - middle)) for z in (curve[start], curve[end]))
    ends = [(float(z.real), float(z.imag)) for z in (first, last)]
    direction = math.atan2(ends[1][1] - ends[0][1], ends[1][0] - ends[0][0])
    return Straight(length, angles[0], angles[1], departure, direction, ends[0], ends[1])


def _strip(points: "Any", enough: float) -> "tuple[float, complex, complex]":
    """Half the width of the narrowest strip that holds the points, its direction, and a point on its middle line.

    The width over the slope of the strip is convex: supporting lines on both sides of the smallest one meet below it.
    The search ends early with a strip that is narrow enough, or where none can be.
    """
    centre = points.mean()
    arms = points - centre
    line = complex(np.sqrt(np.sum(arms * arms)))
    line = line / abs(line) if line else 1.0 + 0j
    arms = np.conj(line) * arms
    along, across = arms.real, arms.imag

    def width(slope: float) -> "tuple[float, float, float, float]":
        off = across - slope * along
        high, low = int(off.argmax()), int(off.argmin())
        return slope, float(off[high] - off[low]), float(along[low] - along[high]), 0.5 * float(off[high] + off[low])

    steepest = 2.0 * float(np.ptp(across)) / (float(np.ptp(along)) or 1.0)
    before, after, best = width(-steepest), width(steepest), width(0.0)
    for _ in range(STEPS):
        if best[2] < 0.0:
            before = best
        else:
            after = best
        if before[2] == after[2]:
            break
        slope = (before[1] - after[1] + after[2] * after[0] - before[2] * before[0]) / (after[2] - before[2])
        least = before[1] + before[2] * (slope - before[0])
        if best[1] <= 2.0 * enough or least > 2.0 * enough > 0.0 or best[1] - least <= SETTLED * best[1]:
            break
        best = width(slope)
    slope, size, _, middle = best
    stretch = math.hypot(1.0, slope)
    return 0.5 * size / stretch, line * complex(1.0, slope) / stretch, centre + 1j * line * middle
