"""The cases of cam_forces.json: programs, loads, followers, and why the hard ones are hard."""

from cam_geometry_cases import arm, flat, knife, rocker, roller

RISES = (("90", "cycloidal", "0.02"), ("60", None, "0.02"), ("90", "3-4-5", "0"), ("120", None, "0"))
MODIFIED = (
    ("100", "modified-sine", "0.015"), ("50", None, "0.015"), ("80", "modified-trapezoid", "0"), ("130", None, "0"),
)  # fmt: skip
HIGH = (("110", "4-5-6-7", "0.012"), ("60", None, "0.012"), ("130", "5-6-7-8-9", "0"), ("60", None, "0"))
JUMPS = (("120", "parabolic", "0.02"), ("60", None, "0.02"), ("120", "harmonic", "0"), ("60", None, "0"))
DOUBLE = (("180", "double-harmonic", "0.01"), ("180", "3-4-5", "0"))
STEEP = (("60", "cycloidal", "0.01"), ("60", "cycloidal", "0"), ("240", None, "0"))
SHORT = (("5.72957795e-5", "cycloidal", "1e-9"), ("89.9999427042205", None, "1e-9"), ("270", "3-4-5", "0"))
BELOW = (("90", "cycloidal", "-0.004"), ("90", None, "-0.004"), ("180", "3-4-5", "0"))
SWING = (("120", "3-4-5", "12"), ("60", None, "12"), ("150", "cycloidal", "0"), ("30", None, "0"))
SWING_MS = (("110", "modified-sine", "15"), ("40", None, "15"), ("130", "modified-trapezoid", "0"), ("80", None, "0"))
FAST = (("90", "3-4-5", "20"), ("30", None, "20"), ("40", "3-4-5", "0"), ("200", None, "0"))
INWARD = (("90", "cycloidal", "-4"), ("90", None, "-4"), ("180", "3-4-5", "0"))


def slide(mass, rate="0", preload="0", load="0"):
    return {"record": "Slide", "mass": mass, "spring_rate": rate, "preload": preload, "load": load}


def torsion(inertia, rate="0", preload="0", load="0"):
    given = {"inertia": inertia, "torsion_rate": rate, "preload_torque": preload, "load_torque": load}
    return {"record": "ArmOnTorsionSpring", **given}


def sprung(inertia, radius, rate, preload):
    given = {"inertia": inertia, "spring_radius": radius, "spring_rate": rate, "preload": preload}
    return {"record": "ArmOnSpring", **given}


S, A = slide("0.5", "5000", "60"), torsion("0.002", "10", "2")
ARM = arm("0.03", "0.008", "0.08", "0.1")
CASES = [
    ("slide without a follower's geometry", "", RISES, "50", S, None, 1, False),
    ("slide, offset roller", "", RISES, "50", S, roller("0.04", "0.01", "0.006"), 1, True),
    ("slide, offset roller, clockwise", "", MODIFIED, "60", S, roller("0.04", "0.01", "0.006"), -1, True),
    ("slide, flat face", "", HIGH, "70", S, flat("0.05"), 1, True),
    ("slide, knife-edge", "", HIGH, "40", slide("0.2", "8000", "20", "30"), knife("0.03", "0.005"), 1, False),
    ("acceleration that jumps", "", JUMPS, "45", S, roller("0.05", "0.012"), 1, True),
    ("turn without a dwell", "", DOUBLE, "120", slide("0.3", "9000", "150"), roller("0.03", "0.008"), 1, True),
    ("arm with roller", "", SWING, "50", A, ARM, 1, True),
    ("arm with roller, clockwise", "", SWING_MS, "45", A, ARM, -1, True),
    ("arm on a linear spring", "", SWING_MS, "50", sprung("0.002", "0.05", "4000", "40"), ARM, 1, False),
    ("flat rocker", "", SWING, "40", A, rocker("0.045", "0.12"), 1, True),
    ("flat rocker with offset face, clockwise", "", SWING, "40", A, rocker("0.045", "0.12", "0.006"), -1, True),
    ("a million turns a minute",
        "springs of a hundred newtons are lost beside 1e13 N of "
        "inertia, and decide where the jump is", RISES, "104719.75511965978", S,
     roller("0.04", "0.01"), 1, True),
    ("at rest", "only the spring is left; the stress is that of a dwell", RISES, "0", S,
     roller("0.04", "0.01"), 1, True),
    ("at the jump speed itself", "the least force is what rounding of the speed leaves of 160 N", RISES,
     "76.74172567886146", S, roller("0.04", "0.01"), 1, False),
    ("dip to zero between samples", "0.125 N at the start is less than any sample of the dip to nothing in the rise",
     RISES, "109.51236970071136", slide("1", "34238", "0.125"), None, 1, False),
    ("no preload", "where the follower rests the quotient of the jump is 0/0", RISES, "30", slide("0.5", "5000"),
     None, 1, False),
    ("hardly any preload", "the quotient of the jump has poles a micrometre off the dwell", HIGH, "30",
     slide("0.5", "1000000", "1e-6"), None, 1, False),
    ("no spring rate", "a preload alone: the jump is where it slows down most", MODIFIED, "30", slide("0.5", "0", "60"),
     None, 1, False),
    ("load that nearly takes the preload off",
        "a preload of 100 N less a load of 99.9999999999 N: their sum "
        "keeps four digits, and the jump is at its root", RISES, "30",
     slide("0.5", "5000", "100", "-99.9999999999"), None, 1, False),
    ("rise within a millionth of a radian",
        "accelerations of 1e4 m per radian squared beside lifts of a "
        "nanometre: terms thirteen orders apart", SHORT, "10",
     slide("0.1", "5000", "60"), None, 1, False),
    ("fall below the base circle", "the spring slackens to a millinewton, all that is left to press", BELOW,
     "10", slide("0.5", "5000", "20.001"), roller("0.03", "0.008"), 1, True),
    ("two places of the jump",
        "rise and return leave the cam at one speed: two "
        "minima equal but for rounding", STEEP, "90", S, roller("0.04", "0.01"), 1, False),
    ("offset next to the start radius", "√(Rp² − e²) by squares keeps five digits; 1/cos φ is 1e4 at the start", RISES,
     "20", S, knife("0.03", "0.02999999999997"), 1, False),
    ("metre-sized cam",
        "sizes a thousand times larger, and forces a million: no tolerance may be in metres or newtons",
     (("120", "cycloidal", "20"), ("120", "modified-trapezoid", "0"), ("120", None, "0")), "2",
     slide("500", "5e6", "6e7"), roller("40", "10", "6"), 1, True),
    ("arm next to the line of pivot and axis", "the triangle is 1e-12 m from its limit: the lever begins at 2e-7 m",
     SWING, "30", A, arm("0.022000000000001", "0.008", "0.07", "0.1"), 1, False),
    ("arm stretched beyond the axis",
        "the triangle is 1e-9 m from stretching out: the arm's angle "
        "starts at half a turn less the root of that", INWARD, "30", A,
     arm("0.159999999", "0.01", "0.07", "0.1"), 1, False),
    ("flat rocker as fast as the cam",
        "1 + dψ/dθ falls to a sixteenth, and the lever and the "
        "radius of curvature have it below them", FAST, "20", torsion("0.002", "10", "2"),
     rocker("0.03", "0.2"), 1, False),
    ("swing of a millionth of a degree",
        "all torques of the arm lie within 1e-9 of one another: least and greatest differ in the tenth digit",
     (("120", "3-4-5", "1e-6"), ("60", None, "1e-6"), ("150", "cycloidal", "0"), ("30", None, "0")), "50", A, ARM, 1,
     True),
]  # fmt: skip
