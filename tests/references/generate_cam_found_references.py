"""Write cam_found.json: the worst cams that the search for broken bounds has found, to 40 digits.

The values are those of the search's exact side (tests/accuracy/cam_search_*.py): laws integrated from their
accelerations in reals of 240 bits, followers carried round the cam, forces by statics, extremes climbed from fine
samples of every branch of every law, plates by Gauss's rule of 40 nodes on fine steps. It is held against the
constructions of the other generators by tests/accuracy/test_cam_search.py.

Run: python tests/references/generate_cam_found_references.py
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "accuracy"))
sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

import cam_search
from cam_search_contact import Looking
from case_files import DATA, put_tree
from mpmath import mp, mpf, nstr
from precise import many_bits

PRESSURE = ("largest_pressure_angle", "least_pressure_angle", "least_convex_radius")
ENDS = tuple(f"{end}_{name}" for name in ("force", "torque", "contact_force") for end in ("least", "greatest"))
CUSP = {
    "program": "rise 10.0 mm in 60 deg cycloidal; return 10.0 mm in 60 deg cycloidal; dwell 240 deg",
    "shaft_speed": "60",
    "train": {"record": "Slide", "mass": "0.2827765606209663", "spring_rate": "5000", "preload": "60", "load": "0"},
    "follower": {
        "record": "Roller", "base_radius": "0.013507682925229208", "roller_radius": "0.016492317074770793",
        "offset": "0",
    },
    "rotation": "counter-clockwise",
    "contact": {"width": "0.012"},
}  # fmt: skip
METRES = {
    "program": "rise 20000.0 mm in 120.00000000047079 deg cycloidal; return 20000.0 mm in 120.0 deg "
    "modified-trapezoid; dwell",
    "shaft_speed": "2",
    "train": {"record": "Slide", "mass": "500", "spring_rate": "5e6", "preload": "6e7", "load": "0"},
    "follower": {"record": "Roller", "base_radius": "40", "roller_radius": "10", "offset": "6"},
    "rotation": "counter-clockwise",
    "contact": {"width": "0.012"},
}
NANOMETRES = {
    "program": "dwell 0.223521 deg; rise 0.000252 mm in 37.8 deg freudenstein-1-3-5; return 0.000252 mm in 83.0 deg "
    "freudenstein-1-3; dwell",
    "shaft_speed": "1.0596360907502496",
    "train": {
        "record": "Slide", "mass": "0.012021952347223266", "spring_rate": "0.0", "preload": "138.38732760309415",
        "load": "0.0",
    },
    "follower": {"record": "FlatFace", "base_radius": "0.039013805766879434"},
    "rotation": "counter-clockwise",
    "contact": {"width": "0.012"},
}  # fmt: skip
SPIKE = {
    "program": "dwell 31.0 deg; rise 17.18 mm in 0.002698 deg 5-6-7-8-9; return 17.18 mm in 98.768 deg "
    "modified-constant-velocity 0.4375; dwell",
    "follower": {
        "record": "ConjugateRoller", "base_radius": "0.04788239814458341", "roller_radius": "0.006111147996642145",
        "roller_distance": "0.1028987943219607", "offset": "-0.004166279531074944",
    },
    "rotation": "clockwise",
    "flank": "inner",
}  # fmt: skip
ROCKER = {
    "program": "rise 11.48 deg in 96.0 deg freudenstein-1-3-5; return 11.48 deg 5-6-7-8-9",
    "follower": {
        "record": "ConjugateOscillatingRoller", "base_radius": "0.03342962481706107",
        "roller_radius": "0.013833586614377993", "arm": "0.10394869174247313",
        "pivot_distance": "0.11675390023595963", "arm_angle": "1.1552186604117507",
    },
    "rotation": "counter-clockwise",
    "flank": "inner",
}  # fmt: skip
CASES = [
    ("force", "found largest, roller a hair off a cusp",
     "found by search: the stress is off by 1.5 million ulps, for 1 − R κ is left over from terms that agree in "
     "nearly all digits",
     CUSP, (*ENDS, "jump_speed", "stress")),
    ("force", "found nearest, metres and nearly equal spans",
     "found by search: the greatest contact force is off by a quarter of its bound; forces of 1e8 N are sums of four "
     "terms, and two spans differ by their last digits",
     METRES, (*ENDS, "jump_speed", "stress")),
    ("force", "found loosest, a quarter of a micrometre",
     "found by search: the bound of jump_speed was 2,500 times its error; a preload alone holds accelerations of "
     "micrometres, and towards the dwells they vanish",
     NANOMETRES, (*ENDS, "jump_speed", "stress")),
    ("profile", "found largest, out and back in 0.0027 deg",
     "found by search: area and centroid by Gauss's rule on pieces of 7.5 degrees were off by a hundredth, for the "
     "curve goes out by 17 mm within 0.0027 degrees",
     SPIKE, PRESSURE),  # its plate is undercut: tests/cam/test_plates.py weighs what is left
    ("profile", "found loosest, second cam on a rocker",
     "found by search: the bound of the largest pressure angle was 326 times its error; the second arm's angle is "
     "a difference, and the acceleration has three sines",
     ROCKER, (*PRESSURE, "area", "perimeter")),
    ("motion", "found largest, three sines squared",
     "found by search: the root mean square by Gauss's rule of 16 nodes was off by 34,000 ulps, for the square of "
     "sin 10πx turns ten times in a rise",
     {"program": "return 4.5775 mm in 64.0 deg freudenstein-1-3-5; dwell 29.054 deg; rise 4.5775 mm in 60.5 deg "
      "modified-constant-velocity 0.109375; dwell"},
     ("rms_acceleration", "velocity.greatest", "acceleration.greatest", "jerk.greatest")),
    ("motion", "found nearest, a span a ten-thousandth of where it ends",
     "found by search: velocities divided by the difference of two rounded joints were off by 47 ulps: the span is "
     "0.0015 degrees and ends at 43",
     {"program": "dwell 43.0 deg; rise 19.93 mm in 0.001518 deg gutman-1-3; return 19.93 mm in 28.0 deg cycloidal; "
      "dwell"},
     ("rms_acceleration", "velocity.greatest", "acceleration.greatest", "jerk.greatest")),
]  # fmt: skip


def values(task, inputs, names):
    """The exact values of some results, looked for finely."""
    question = cam_search.QUESTIONS[f"cam {task}"]
    found = {one.name: one.exact for one in question.compare({"points": 5, **inputs})}
    return {name: found[name] for name in names}


def main():
    many_bits()
    Looking.shares, Looking.steps = Looking.fine
    mp.dps = 80
    cases = []
    for task, name, why, inputs, names in CASES:
        results = values(task, inputs, names)
        cases.append({
            "task": task, "kind": "hard", "name": name, "why": why, "inputs": inputs,
            "results": {key: nstr(mpf(str(value)), 40, min_fixed=1, max_fixed=0) for key, value in results.items()},
        })  # fmt: skip
        print(name, flush=True)
    about = "Written by generate_cam_found_references.py: SI inputs as doubles, results to 40 digits of 70."
    put_tree(DATA / "cam_found.json", {"about": about, "cases": cases})


if __name__ == "__main__":
    main()
