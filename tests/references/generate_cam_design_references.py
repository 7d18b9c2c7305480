"""Write cam_design.json: smallest cams and lifts lost to 40 digits, from conditions solved together.

A corner of an undercut cam is the point that two positions of the follower touch at once, each to first order: four
equations for the point and the two cam angles, written with the follower carried round the cam and differentiated
numerically. The lift lost is greatest where the follower, resting on the corner, falls behind its program no faster.
A size under a curvature is where curvature, its derivative by cam angle and the condition of the least start radius
hold at once, or where two constraints meet; that no other angle is sharper is looked for on a grid. Rough places are
given here to four digits; the solutions do not depend on them.

Run: python tests/references/generate_cam_design_references.py
"""

import json
import sys
from pathlib import Path

from generate_cam_geometry_references import (
    CYCLE,
    MM,
    RISES,
    STEEP,
    SWING,
    Carried,
    Lift,
    extreme,
    flat,
    program_text,
    rocker,
    roller,
    smooth_zones,
    written,
)  # fmt: skip
from mpmath import diff, exp, findroot, hypot, mp, mpc, mpf, pi, sqrt, tan

DATA = Path(__file__).resolve().parents[2] / "dynamics_cli" / "accuracy" / "data"
DIGITS = 50
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


def lift_of(segments, swing):
    scale = pi / 180 if swing else mpf(1)
    values = [mpf(float(mpf(to) * scale)) for _, _, to in segments]
    return Lift([(span, law, to) for (span, law, _), to in zip(segments, values, strict=True)])


def touching(carried, inner, point, theta):
    """How far a point is from being touched, and how that changes with the cam angle."""

    def away(t):
        if carried.kind in ("FlatFace", "OscillatingFlat"):
            normal, level = carried.face(inner(t))
            return (point * (normal * carried.back(t)).conjugate()).real - level
        return abs(point - carried.centre(inner(t)) * carried.back(t)) ** 2 - carried.roller**2

    return away(theta), diff(away, theta)


def corner_loss(segments, follower, turn, side, first, second, at):
    swing = follower["record"] in ("OscillatingRoller", "OscillatingFlat")
    lift, carried = lift_of(segments, swing), Carried(follower, turn, side)
    zone = lambda t: lift.within(lift.zone(t))  # noqa: E731
    one, two, lost = (zone(mpf(angle)) for angle in (first, second, at))
    start = carried.point(one, mpf(first))[0] / 2 + carried.point(two, mpf(second))[0] / 2

    def both(x, y, a, b):
        point = mpc(x, y)
        return [*touching(carried, one, point, a), *touching(carried, two, point, b)]

    x, y, _, _ = findroot(both, (start.real, start.imag, mpf(first), mpf(second)), tol=1e-80, maxsteps=60)
    point = mpc(x, y)

    def rest(level, t):
        """Whether the follower at a level touches the corner."""
        return touching(carried, lambda _: level, point, t)[0]

    def worst(level, t):
        # along the rest the level changes by -∂t/∂level; the program changes as fast
        by_level = diff(lambda one: rest(one, t), level)
        by_angle = diff(lambda one: rest(level, one), t)
        return [rest(level, t), by_angle + by_level * diff(lost, t)]

    # the level where the follower rests: a secant from a little below the program, above on an outer flank
    way = mpf(side)
    near = findroot(
        lambda level: rest(level, mpf(at)), (lost(mpf(at)) * (1 - way / 50), lost(mpf(at)) * (1 - way / 30))
    )
    level, theta = findroot(worst, (near, mpf(at)), tol=1e-80, maxsteps=60)
    key = "swing_lost" if swing else "lift_lost"
    return {key: way * (lost(theta) - level)}


def corner_cases():
    for name, why, segments, follower, turn, side, *places in CORNERS:
        mp.dps = DIGITS
        swing = follower["record"] in ("OscillatingRoller", "OscillatingFlat")
        inputs = {
            "program": program_text(segments, *(("deg", 1) if swing else MM)),
            "follower": follower,
            "rotation": "counter-clockwise" if turn > 0 else "clockwise",
            "flank": "inner" if side > 0 else "outer",
        }
        print(name)
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


def bend(inner, e, d, theta):
    """Curvature of a roller's path, from two derivatives of the centre carried round."""

    def carried(t):
        return mpc(e, d + inner(t)) * exp(-1j * t)

    c1, c2 = diff(carried, theta), diff(carried, theta, 2)
    return -(c1.conjugate() * c2).imag / abs(c1) ** 3


def offset_size(segments, radius, rise, back, least, start, offset):
    lift = lift_of(segments, False)
    zones = list(smooth_zones(lift))
    wanted = mpf(float(least)) + mpf(float(radius))
    e, d = mpf(offset), sqrt(mpf(start) ** 2 - mpf(offset) ** 2)
    c1, c2 = 1 / tan(mpf(float(rise))), 1 / tan(mpf(float(back)))
    a = extreme(lambda s, t: diff(s, t) * c1 - s(t), zones, 1)
    b = extreme(lambda s, t: -diff(s, t) * c2 - s(t), zones, 1)
    lines = [line for line in ((c1, a), (-c2, b)) if abs(d + e * line[0] - line[1]) < mpf("1e-6")]
    peaks = []
    for low, high, inner in zones:
        mp.dps = 20
        grid = [low + (high - low) * k / 100 for k in range(101)]
        values = [bend(inner, e, d, t) for t in grid[1:-1]]
        index = max(range(99), key=values.__getitem__)
        mp.dps = DIGITS
        if values[index] * wanted > 1 - mpf("2e-4"):
            peaks.append((inner, grid[index + 1], 0 < index < 98, low if index == 0 else high))
    mp.dps = DIGITS
    print(len(lines), "pressure angles and", len(peaks), "peaks of curvature bind")
    assert len(lines) + len(peaks) <= 2

    def equations(e, d, *angles):
        found = [d + e * slope - level for slope, level in lines]
        for (inner, _, inside, end), t in zip(peaks, angles, strict=True):
            found.append(bend(inner, e, d, t) * wanted - 1)
            found.append(diff(lambda u, inner=inner: bend(inner, e, d, u), t) if inside else t - end)
        if len(lines) + len(peaks) == 1:
            inner, t = peaks[0][0], angles[0]
            by_e = diff(lambda u: bend(inner, u, d, t), e)
            by_d = diff(lambda u: bend(inner, e, u, t), d)
            found.append(e * by_d - d * by_e)
        return found

    root = findroot(equations, (e, d, *(peak[1] for peak in peaks)), tol=1e-70, maxsteps=40)
    e, d = root[0], root[1]
    for low, high, inner in zones:
        # no angle of a grid is sharper
        assert all(bend(inner, e, d, low + (high - low) * k / 400) * wanted < 1 + mpf("1e-12") for k in range(1, 400))
    start = hypot(e, d)
    return {"base_radius": start - mpf(float(radius)), "offset": e, "start_radius": start}


def offset_cases():
    for name, why, segments, radius, rise, back, least, start, offset in OFFSETS:
        mp.dps = DIGITS
        inputs = {
            "program": program_text(segments, *MM),
            "follower": {"record": "Roller", "roller_radius": radius},
            "rise_limit": rise,
            "return_limit": back,
            "least_radius": least,
        }
        print(name)
        yield name, why, inputs, offset_size(segments, radius, rise, back, least, start, offset)


ROCKERS = [
    ("flat rocker", "", SWING, "0.09", "0", "0.005"),
    ("flat rocker with offset face", "", LEVER, "0.11", "0.006", "0.01"),
    (
        "flat rocker with its face beyond the pivot",
        "the radius of curvature gains what the face loses",
        LEVER, "0.1", "-0.005", "0.002",
    ),
]  # fmt: skip


def rocker_size(segments, pivot, back, least):
    lift = lift_of(segments, True)
    c, f, wanted = mpf(float(pivot)), mpf(float(back)), mpf(float(least))

    def radius(inner, start, t):
        # the support function h of the face, ρ = h + h″ by the angle of its normal, which turns by 1 + ψ′
        level = lambda u: c * mp.sin(start + inner(u)) - f  # noqa: E731
        rate = 1 + diff(inner, t)
        first = lambda u: diff(level, u) / (1 + diff(inner, u))  # noqa: E731
        return level(t) + diff(first, t) / rate

    zones = list(smooth_zones(lift))

    def sharpest(start):
        best = None
        for low, high, inner in zones:
            for k in range(1, 80):
                t = low + (high - low) * k / 80
                value = radius(inner, start, t)
                if best is None or value < best[0]:
                    best = value, inner, t
        return best

    mp.dps = 20
    low, high = mpf("0.01"), mpf("1.2")
    for _ in range(16):
        middle = (low + high) / 2
        low, high = (middle, high) if sharpest(middle)[0] < wanted else (low, middle)
    _, inner, place = sharpest(high)
    mp.dps = DIGITS
    start, _ = findroot(
        lambda start, t: [radius(inner, start, t) - wanted, diff(lambda u: radius(inner, start, u), t)],
        (high, place), tol=1e-60, maxsteps=40,
    )  # fmt: skip
    return {"base_radius": c * mp.sin(start) - f, "arm_start_angle": start}


def rocker_cases():
    for name, why, segments, pivot, back, least in ROCKERS:
        mp.dps = DIGITS
        inputs = {
            "program": program_text(segments, "deg", 1),
            "follower": {"record": "OscillatingFlat", "pivot_distance": pivot, "face_offset": back},
            "least_radius": least,
        }
        print(name)
        yield name, why, inputs, rocker_size(segments, pivot, back, least)


PAIRS = [
    ("conjugate pair in line", "", CYCLE, "0.006", "0", "0.5", "0.6"),
    ("conjugate pair with offset", "", RISES, "0.008", "0.004", "0.45", "0.4"),
]


def pair_size(segments, radius, offset, rise, back):
    zones = list(smooth_zones(lift_of(segments, False)))
    e, r = mpf(float(offset)), mpf(float(radius))
    c1, c2 = 1 / tan(mpf(float(rise))), 1 / tan(mpf(float(back)))
    # tan φ = (s′ − e)/(d + s) above the axis, (e − s′)/(d₂ − s) below it
    first = max(
        extreme(lambda s, t: (diff(s, t) - e) * c1 - s(t), zones, 1),
        extreme(lambda s, t: (e - diff(s, t)) * c2 - s(t), zones, 1),
    )
    second = max(
        extreme(lambda s, t: (e - diff(s, t)) * c1 + s(t), zones, 1),
        extreme(lambda s, t: (diff(s, t) - e) * c2 + s(t), zones, 1),
    )
    return {"base_radius": hypot(e, first) - r, "roller_distance": first + second}


def pair_cases():
    for name, why, segments, radius, offset, rise, back in PAIRS:
        mp.dps = DIGITS
        inputs = {
            "program": program_text(segments, *MM),
            "follower": {"record": "ConjugateRoller", "roller_radius": radius, "offset": offset},
            "rise_limit": rise,
            "return_limit": back,
        }
        print(name)
        yield name, why, inputs, pair_size(segments, radius, offset, rise, back)


def main():
    sizes = [*offset_cases(), *rocker_cases(), *pair_cases()]
    cases = [written("check", *case) for case in corner_cases()] + [written("size", *case) for case in sizes]
    about = "Written by generate_cam_design_references.py: SI inputs as doubles, results to 40 digits of 50."
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else DATA / "cam_design.json"
    text = json.dumps({"about": about, "cases": cases}, indent=1, ensure_ascii=False)
    target.write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
