"""Write cam_design.json: smallest cams and lifts lost to 40 digits, from conditions solved together.

A corner of an undercut cam is the point that two positions of the follower touch at once, each to first order: four
equations for the point and the two cam angles, written with the follower carried round the cam (cam_envelope.py). The
lift lost is greatest where the follower, resting on the corner, falls behind its program no faster. A size under a
curvature is where curvature, its derivative by cam angle and the condition of the least start radius hold at once, or
where two constraints meet; that no other angle is sharper is looked for on a grid. Rough places are given here to four
digits; the solutions do not depend on them.

Run: python tests/references/generate_cam_design_references.py [FILE]. The same bytes every time.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import numpy as np
from cam_envelope import Carried, extreme
from cam_geometry_cases import CYCLE, MM, RISES, STEEP, SWING, flat, rocker, roller
from cam_programs import at, program_text
from case_files import DATA, put_tree
from digits import DOUBLES, MANY, solved
from generate_cam_geometry_references import case, pairs, turned
from taylor import Plane, circle, diff, expanded, sqrt

number, tan = MANY.number, MANY.library.tan
MERGED = (("60", "3-4-5", "0.02"), ("10", None, "0.02"), ("60", "cycloidal", "0"), ("230", None, "0"))
QUICK = (("60", "cycloidal", "25"), ("60", None, "25"), ("70", "3-4-5", "0"), ("170", None, "0"))
LEVER = (("90", "cycloidal", "18"), ("40", None, "18"), ("80", "3-4-5", "0"), ("150", None, "0"))

# name, why, program, follower, turn, side, and to four digits the two angles of the corner and that of the loss
CORNERS = [
    ("roller on a steep cam", "", STEEP, roller("0.015", "0.015"), 1, 1, "0.4596", "0.7813", "0.6144"),
    ("offset roller, clockwise", "", STEEP, roller("0.013", "0.014", "0.004"), -1, 1, "2.3366", "2.717", "2.5344"),
    ("smaller undercut", "", STEEP, roller("0.0152", "0.015"), 1, 1, "0.4615", "0.7795", "0.6145"),
    (
        "flat face, two undercuts run into one",
        "both contacts at the corner are beyond the other stretch, so that neither has a corner of its own",
        MERGED, flat("0.004"), 1, 1, "0.1292", "2.125", "1.2815",
    ),
    (
        "flat rocker, clockwise",
        "the corner takes away most of a rise, far from where the envelope runs backwards",
        QUICK, rocker("0.02", "0.1", "0.004"), -1, 1, "0.239", "1.8137", "0.8252",
    ),
    (
        "outer flank of a track",
        "the wall is hollow where the roller turns, and the follower overshoots in place of falling back",
        STEEP, roller("0.015", "0.016"), 1, -1, "0.0022", "0.2515", "0.1349",
    ),
    (
        "undercut of a micrometre",
        "a loop of a nanometre between any samples: the loss is four picometres",
        STEEP, roller("0.02498948", "0.015"), 1, 1, "0.618829", "0.621844", "0.620336",
    ),
]  # fmt: skip


def touching(carried, inner, point, theta):
    """How far a point is from being touched."""
    if carried.flat:
        normal, level = carried.face(inner(theta))
        return (point * (normal * carried.back(theta)).conjugate()).real - level
    return (point - carried.carried(inner)(theta)).square() - carried.roller**2


def corner_loss(segments, follower, turn, side, first, second, place):
    swing = follower["record"] in ("OscillatingRoller", "OscillatingFlat")
    exact, _ = turned(segments, swing=swing)
    carried = Carried(follower, turn, side)
    one, two, lost = (at(exact, number(angle)) for angle in (first, second, place))
    start = (carried.point(one, number(first))[0] + carried.point(two, number(second))[0]) * 0.5

    def both(x, y, a, b):
        point = Plane(x, y)
        return [
            *expanded(lambda t: touching(carried, one, point, t), a, 1),
            *expanded(lambda t: touching(carried, two, point, t), b, 1),
        ]

    x, y, _, _ = solved(both, (start.real, start.imag, first, second))
    point = Plane(x, y)

    def rest(level, t):
        """Whether the follower at a level touches the corner."""
        return touching(carried, lambda _: level, point, t)

    def worst(level, t):
        # along the rest the level changes by -∂t/∂level; the program changes as fast
        by_level = diff(lambda one: rest(one, t), level)
        by_angle = diff(lambda one: rest(level, one), t)
        return [rest(level, t), by_angle + by_level * diff(lost, t)]

    # the level where the follower rests is a little below the program, above on an outer flank
    programmed = lost(number(place))
    (near,) = solved(lambda level: [rest(level, number(place))], (programmed * (1 - number(side) / 40),))
    level, theta = solved(worst, (near, place))
    key = "swing_lost" if swing else "lift_lost"
    return {key: side * (lost(theta) - level)}


def corner_cases():
    for name, why, segments, follower, turn, side, *places in CORNERS:
        swing = follower["record"] in ("OscillatingRoller", "OscillatingFlat")
        inputs = {
            "program": program_text(segments, *(("deg", 1) if swing else MM)),
            "follower": follower,
            "rotation": "counter-clockwise" if turn > 0 else "clockwise",
            "flank": "inner" if side > 0 else "outer",
        }
        yield name, why, inputs, corner_loss(segments, follower, turn, side, *places)


# name, why, program, roller radius, limits, least radius, and the start radius and offset to six digits
OFFSETS = [
    ("curvature and return limit meet", "", CYCLE, "0.006", "0.5", "0.5", "0.02", "0.031704748", "0.0066931117"),
    (
        "curvature and rise limit meet",
        "the best offset is far to the left, where both constraints cross at a small angle",
        RISES, "0.006", "0.4", "0.4", "0.1", "0.10862091", "-0.030023662",
    ),
    (
        "two peaks of curvature in balance",
        "the least start radius is where a rise and a return are equally sharp",
        CYCLE, "0.006", "0.7", "0.7", "0.05", "0.064074737", "0.028117353",
    ),
]  # fmt: skip


def bend(field, lift, e, d, theta):
    """Curvature of a roller's path, from two derivatives of the centre carried round."""

    def carried(t):
        c, s = circle(field, t)
        return Plane(e, d + lift(t)) * Plane(c, -s)

    _, c1, c2 = expanded(carried, theta, 2)
    square = c1.square()
    return -(c1.conjugate() * c2).imag / (square * sqrt(field, square))


def limits(both, rise, back):
    """Cotangents of the limits of pressure, and the greatest of s′ cot φ − s for each."""
    c1, c2 = 1 / tan(MANY.double(rise)), 1 / tan(MANY.double(back))
    return c1, c2, farthest(both, c1, -1), farthest(both, -c2, -1)


def farthest(both, slope, way, offset=0):
    """The greatest of (s′ − e)·slope + way·s."""

    def reached(c, e):
        return lambda s, t: (diff(s, t) - e) * c + way * s(t)

    return extreme(reached(slope, offset), both, 1, reached(float(slope), float(offset)))


def offset_size(segments, radius, rise, back, least, start, offset):
    both = pairs(*turned(segments))
    wanted = MANY.double(least) + MANY.double(radius)
    e = number(offset)
    d = MANY.sqrt(number(start) ** 2 - e**2)
    c1, c2, a, b = limits(both, rise, back)
    lines = [line for line in ((c1, a), (-c2, b)) if abs(d + e * line[0] - line[1]) < 1e-6]
    peaks = []
    for (low, high, lift), (begin, end, rough) in both:
        grid = begin + (end - begin) * np.arange(1, 100) / 100
        values = bend(DOUBLES, rough, float(e), float(d), grid) + 0 * grid
        index = int(np.argmax(values))
        if values[index] * float(wanted) > 1 - 2e-4:
            place = low + (high - low) * (index + 1) / 100
            peaks.append((lift, place, 0 < index < 98, low if index == 0 else high))
    assert len(lines) + len(peaks) == 2

    def equations(e, d, *angles):
        found = [d + e * slope - level for slope, level in lines]
        for (lift, _, inside, end), t in zip(peaks, angles, strict=True):
            curvature, slope = expanded(lambda u, lift=lift: bend(MANY, lift, e, d, u), t, 1)
            found.append(curvature * wanted - 1)
            found.append(slope if inside else t - end)
        return found

    e, d, *_ = solved(equations, (e, d, *(peak[1] for peak in peaks)))
    for (low, high, lift), _ in both:
        # no angle of a grid is sharper
        shares = (low + (high - low) * k / 400 for k in range(1, 400))
        assert all(bend(MANY, lift, e, d, t) * wanted < 1 + 1e-12 for t in shares)
    start = MANY.sqrt(e * e + d * d)
    return {"base_radius": start - MANY.double(radius), "offset": e, "start_radius": start}


def offset_cases():
    for name, why, segments, radius, rise, back, least, start, offset in OFFSETS:
        inputs = {
            "program": program_text(segments, *MM),
            "follower": {"record": "Roller", "roller_radius": radius},
            "rise_limit": rise,
            "return_limit": back,
            "least_radius": least,
        }
        yield name, why, inputs, offset_size(segments, radius, rise, back, least, start, offset)


ROCKERS = [
    ("flat rocker", "", SWING, "0.09", "0", "0.005"),
    ("flat rocker with offset face", "", LEVER, "0.11", "0.006", "0.01"),
    (
        "flat rocker with its face beyond the pivot",
        "the face lies beyond the pivot: its offset is negative, and lever and radius of curvature change sides",
        LEVER, "0.1", "-0.005", "0.002",
    ),
]  # fmt: skip


def rocker_size(segments, pivot, back, least):
    both = pairs(*turned(segments, swing=True))
    wanted = MANY.double(least)

    def radius(field, lift, start, t):
        # the support function h of the face, ρ = h + h″ by the angle of its normal, which turns by 1 + ψ′
        c, f = field.double(pivot), field.double(back)

        def level(u):
            return c * circle(field, start + lift(u))[1] - f

        def first(u):
            return diff(level, u) / (1 + diff(lift, u))

        return level(t) + diff(first, t) / (1 + diff(lift, t))

    def sharpest(start):
        best = None
        for (low, high, lift), (begin, end, rough) in both:
            values = radius(DOUBLES, rough, start, begin + (end - begin) * np.arange(1, 80) / 80)
            k = int(np.argmin(values))
            if best is None or values[k] < best[0]:
                best = values[k], lift, low + (high - low) * (k + 1) / 80
        return best

    low, high = 0.01, 1.2
    for _ in range(16):
        middle = (low + high) / 2
        low, high = (middle, high) if sharpest(middle)[0] < float(wanted) else (low, middle)
    _, lift, place = sharpest(high)

    def equations(start, t):
        value, slope = expanded(lambda u: radius(MANY, lift, start, u), t, 1)
        return [value - wanted, slope]

    start, _ = solved(equations, (high, place))
    return {"base_radius": MANY.double(pivot) * MANY.sin(start) - MANY.double(back), "arm_start_angle": start}


def rocker_cases():
    for name, why, segments, pivot, back, least in ROCKERS:
        inputs = {
            "program": program_text(segments, "deg", 1),
            "follower": {"record": "OscillatingFlat", "pivot_distance": pivot, "face_offset": back},
            "least_radius": least,
        }
        yield name, why, inputs, rocker_size(segments, pivot, back, least)


PAIRS = [
    ("conjugate pair in line", "", CYCLE, "0.006", "0", "0.5", "0.6"),
    ("conjugate pair with offset", "", RISES, "0.008", "0.004", "0.45", "0.4"),
]


def pair_size(segments, radius, offset, rise, back):
    both = pairs(*turned(segments))
    e, r = MANY.double(offset), MANY.double(radius)
    c1, c2 = 1 / tan(MANY.double(rise)), 1 / tan(MANY.double(back))
    # tan φ = (s′ − e)/(d + s) above the axis, (e − s′)/(d₂ − s) below it
    first = max(farthest(both, c1, -1, e), farthest(both, -c2, -1, e))
    second = max(farthest(both, -c1, 1, e), farthest(both, c2, 1, e))
    return {"base_radius": MANY.sqrt(e * e + first * first) - r, "roller_distance": first + second}


def pair_cases():
    for name, why, segments, radius, offset, rise, back in PAIRS:
        inputs = {
            "program": program_text(segments, *MM),
            "follower": {"record": "ConjugateRoller", "roller_radius": radius, "offset": offset},
            "rise_limit": rise,
            "return_limit": back,
        }
        yield name, why, inputs, pair_size(segments, radius, offset, rise, back)


def main():
    sizes = [*offset_cases(), *rocker_cases(), *pair_cases()]
    cases = [case("check", *parts) for parts in corner_cases()] + [case("size", *parts) for parts in sizes]
    about = "Written by generate_cam_design_references.py: SI inputs as doubles, results to 40 digits of 90."
    put_tree(DATA / "cam_design.json", {"about": about, "cases": cases})


if __name__ == "__main__":
    main()
