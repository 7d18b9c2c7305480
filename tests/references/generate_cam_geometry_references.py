"""Write cam_geometry.json: profiles, pressure angles and curvatures of cams to 40 digits, by another construction.

The envelope is not taken from formulas for contact points but from its definition (see cam_envelope.py): the roller is
carried round the cam as a moving circle, a flat face as a moving line, with derivatives by Taylor arithmetic in 90
digits. Curvatures come from differentiating the curve itself. Laws are written out anew (cam_programs.py).

Run: python tests/references/generate_cam_geometry_references.py [FILE]. The same bytes every time.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from cam_envelope import Carried, extreme
from cam_geometry_cases import CASES, FLATS, MM, SIZES
from cam_programs import at, branches, program_text
from case_files import DATA, put_tree
from digits import DOUBLES, MANY, written
from taylor import diff

COUNT = 16
SWINGING = ("OscillatingRoller", "OscillatingFlat", "ConjugateOscillatingRoller")
tan = MANY.library.tan


def turned(segments, *, swing=False):
    """The branches of one turn, in many digits and in doubles: levels are the doubles that the program reads."""
    # it reads decimals of degrees or of millimetres and rounds them to doubles of radians or of metres
    unit = MANY.pi / 180 if swing else MANY.number(1)
    levels = [float(MANY.number(to) * unit) for _, _, to in segments]
    return branches(MANY, segments, [MANY.number(level) for level in levels]), branches(DOUBLES, segments, levels)


def pairs(exact, rough):
    """Branches of both, for extremes."""
    return [(one[:3], two[:3]) for one, two in zip(exact, rough, strict=True)]


def answers(segments, follower, turn, side, swing):
    exact, rough = turned(segments, swing=swing)
    carried, coarse = (Carried(follower, turn, side, field) for field in (MANY, DOUBLES))
    out = {}
    for index in (1, 2, 3, 6, 9, 10, 13):
        theta = MANY.number(index * (2.0 * 3.141592653589793 / COUNT))
        lift = at(exact, theta)
        point, _ = carried.point(lift, theta)
        out[f"points[{index}].x"], out[f"points[{index}].y"] = point.real, point.imag
        out[f"points[{index}].pressure_angle"] = carried.pressure(lift, theta)
    both = pairs(exact, rough)
    out["largest_pressure_angle"] = extreme(carried.pressure, both, 1, coarse.pressure)
    out["least_pressure_angle"] = extreme(carried.pressure, both, -1, coarse.pressure)
    if carried.flat:
        out["least_convex_radius"] = extreme(carried.radius, both, -1, coarse.radius)
    else:
        out["least_convex_radius"] = 1 / extreme(carried.bend, both, 1, coarse.bend) - side * carried.roller
    return out


def size_answers(segments, roller_radius, rise, back, offset):
    both = pairs(*turned(segments))
    c1, c2 = 1 / tan(MANY.double(rise)), 1 / tan(MANY.double(back))
    d1, d2 = float(c1), float(c2)
    a = extreme(lambda s, t: diff(s, t) * c1 - s(t), both, 1, lambda s, t: diff(s, t) * d1 - s(t))
    b = extreme(lambda s, t: -diff(s, t) * c2 - s(t), both, 1, lambda s, t: -diff(s, t) * d2 - s(t))
    if offset is not None:
        e = MANY.double(offset)
        d = max(a - e * c1, b + e * c2)
    else:
        # the nearest of: both feet where they keep the other line, and the apex
        choices = [((a - b) / (c1 + c2), (a * c2 + b * c1) / (c1 + c2))]
        foot = (a * c1 / (1 + c1**2), a / (1 + c1**2))
        if foot[1] - foot[0] * c2 >= b:
            choices.append(foot)
        foot = (-b * c2 / (1 + c2**2), b / (1 + c2**2))
        if foot[1] + foot[0] * c1 >= a:
            choices.append(foot)
        e, d = min(choices, key=lambda pair: pair[0] ** 2 + pair[1] ** 2)
    radius = MANY.sqrt(e**2 + d**2)
    return {"base_radius": radius - MANY.double(roller_radius), "offset": e, "start_radius": radius}


def size_cases():
    for name, why, segments, roller_radius, rise, back, offset in SIZES:
        follower = {"record": "Roller", "roller_radius": roller_radius} | ({} if offset is None else {"offset": offset})
        inputs = {
            "program": program_text(segments, *MM),
            "follower": follower,
            "rise_limit": rise,
            "return_limit": back,
        }
        yield name, why, inputs, size_answers(segments, roller_radius, rise, back, offset)
    for name, why, segments, least in FLATS:
        low = extreme(lambda s, t: s(t) + diff(s, t, 2), pairs(*turned(segments)), -1)
        inputs = {"program": program_text(segments, *MM), "follower": {"record": "FlatFace"}, "least_radius": least}
        yield name, why, inputs, {"base_radius": MANY.double(least) - low}


def case(task, name, why, inputs, results):
    return {
        "task": task,
        "kind": "hard" if why else "ordinary",
        "name": name,
        **({"why": why} if why else {}),
        "inputs": inputs,
        "results": {key: written(value) for key, value in results.items()},
    }


def main():
    cases = [case("size", *parts) for parts in size_cases()]
    for name, why, segments, follower, turn, side in CASES:
        swing = follower["record"] in SWINGING
        inputs = {
            "program": program_text(segments, *(("deg", 1) if swing else MM)),
            "follower": follower,
            "rotation": "counter-clockwise" if turn > 0 else "clockwise",
            "flank": "inner" if side > 0 else "outer",
            "points": COUNT,
        }
        cases.append(case("profile", name, why, inputs, answers(segments, follower, turn, side, swing)))
    about = "Written by generate_cam_geometry_references.py: SI inputs as doubles, results to 40 digits of 90."
    put_tree(DATA / "cam_geometry.json", {"about": about, "cases": cases})


if __name__ == "__main__":
    main()
