"""The cases of cam_geometry.json: programs, followers, and why the hard ones are hard."""

MM = ("mm", 1000)
CYCLE = (("90", "modified-sine", "0.01"), ("90", None, "0.01"), ("90", "cycloidal", "0"), ("90", None, "0"))
RISES = (("120", "3-4-5", "0.02"), ("60", None, "0.02"), ("150", "4-5-6-7", "0"), ("30", None, "0"))
STEEP = (("45", "cycloidal", "0.02"), ("90", None, "0.02"), ("45", "cycloidal", "0"), ("180", None, "0"))
ROUND = (("180", "cycloidal", "0.01"), ("180", "cycloidal", "0"))
TINY = (("0.0001", "3-4-5", "1e-9"), ("179.9999", None, "1e-9"), ("180", "cycloidal", "0"))
SHORT = (("0.01", "cycloidal", "1e-8"), ("89.99", None, "1e-8"), ("270", "3-4-5", "0"))
SWING = (("120", "3-4-5", "12"), ("60", None, "12"), ("150", "cycloidal", "0"), ("30", None, "0"))
FAST = (("90", "3-4-5", "20"), ("30", None, "20"), ("95", "3-4-5", "0"), ("145", None, "0"))
BELOW = (("90", "cycloidal", "-0.004"), ("90", None, "-0.004"), ("180", "3-4-5", "0"))


def roller(base, radius, offset="0"):
    return {"record": "Roller", "base_radius": base, "roller_radius": radius, "offset": offset}


def knife(base, offset="0"):
    return {"record": "KnifeEdge", "base_radius": base, "offset": offset}


def flat(base):
    return {"record": "FlatFace", "base_radius": base}


def arm(base, radius, length, pivot):
    return {
        "record": "OscillatingRoller",
        "base_radius": base,
        "roller_radius": radius,
        "arm": length,
        "pivot_distance": pivot,
    }


def rocker(base, pivot, offset="0"):
    return {"record": "OscillatingFlat", "base_radius": base, "pivot_distance": pivot, "face_offset": offset}


def mate(base, radius, distance, offset="0"):
    return {
        "record": "ConjugateRoller",
        "base_radius": base,
        "roller_radius": radius,
        "roller_distance": distance,
        "offset": offset,
    }


def mate_arm(base, radius, length, pivot, angle):
    return {
        "record": "ConjugateOscillatingRoller",
        "base_radius": base,
        "roller_radius": radius,
        "arm": length,
        "pivot_distance": pivot,
        "arm_angle": angle,
    }


CASES = [
    ("the cam of the work-precision table", "", CYCLE, roller("0.025", "0.006"), 1, 1),
    ("knife-edge in line", "", RISES, knife("0.04"), 1, 1),
    ("knife-edge offset", "", RISES, knife("0.04", "0.01"), 1, 1),
    ("roller offset to the left", "", CYCLE, roller("0.03", "0.008", "-0.012"), 1, 1),
    ("roller, clockwise", "", RISES, roller("0.035", "0.008", "0.009"), -1, 1),
    ("outer flank of a track", "", CYCLE, roller("0.04", "0.01"), 1, -1),
    ("outer flank, clockwise", "", RISES, roller("0.06", "0.012", "0.005"), -1, -1),
    ("flat face", "", CYCLE, flat("0.05"), 1, 1),
    ("flat face, clockwise", "", RISES, flat("0.06"), -1, 1),
    ("arm with roller", "", SWING, arm("0.03", "0.008", "0.08", "0.1"), 1, 1),
    ("arm with roller, clockwise", "", SWING, arm("0.03", "0.008", "0.08", "0.1"), -1, 1),
    ("flat rocker", "", SWING, rocker("0.03", "0.09"), 1, 1),
    ("flat rocker with offset face, clockwise", "", SWING, rocker("0.03", "0.09", "0.006"), -1, 1),
    ("second cam on a slide", "", CYCLE, mate("0.03", "0.008", "0.09", "0.004"), 1, 1),
    ("second cam on a rocker", "", SWING, mate_arm("0.03", "0.008", "0.08", "0.1", "1.1"), 1, 1),
    (
        "offset a millionth of a millionth short of the radius",
        "the offset is 1e-12 short of the start radius: √(Rp² − e²) by squares keeps five digits",
        CYCLE,
        knife("0.03", "0.02999999999997"),
        1,
        1,
    ),
    (
        "offset a billionth short of the start radius, roller",
        "the offset is 1e-9 short of the start radius: the start height is 1.4 µm, the root of what is left",
        CYCLE,
        roller("0.025", "0.006", "0.030999999969"),
        1,
        1,
    ),
    (
        "offset equal to the start radius",
        "the start height is zero and the pressure angle a right angle there",
        CYCLE,
        roller("0.025", "0.005", "-0.0299999999"),
        -1,
        1,
    ),
    (
        "base circle of a nanometre",
        "a nanometre of cam beside a roller of centimetres: seven digits of pitch radius less roller cancel",
        CYCLE,
        roller("1e-9", "0.02"),
        1,
        1,
    ),
    (
        "base circle of a micrometre under a knife-edge",
        "the pressure angle comes near a right angle where the rise begins",
        RISES,
        knife("1e-6"),
        1,
        1,
    ),
    (
        "base circle zero",
        "a base circle of zero: the curve goes through the axis, where no polar angle is",
        CYCLE,
        roller("0", "0.02"),
        1,
        1,
    ),
    (
        "roller a billionth short of a cusp",
        "1 − R κ is 1e-9 at the worst place and the radius is a difference",
        STEEP,
        roller("0.0187149094", "0.0112850906"),
        1,
        1,
    ),
    (
        "undercut roller",
        "the roller is larger than the pitch curve's radius: the envelope runs backwards, 1 − R κ is below zero",
        STEEP,
        roller("0.015", "0.015"),
        1,
        1,
    ),
    (
        "large roller on a small cam",
        "a roller of twenty base radii: each point is a pitch radius less a roller that nearly cancel",
        CYCLE,
        roller("0.002", "0.04"),
        1,
        1,
    ),
    (
        "arm a picometre inside the triangle limit",
        "1e-12 m from the triangle's limit: the arc cosine of the start angle keeps half the digits",
        SWING,
        arm("0.012000000001", "0.008", "0.08", "0.1"),
        1,
        1,
    ),
    (
        "arm stretched out",
        "arm and pivot are nearly in one line at the start: the triangle is 1e-10 m from stretching out",
        (("180", "cycloidal", "-12"), ("180", "3-4-5", "0")),
        arm("0.1719999999", "0.008", "0.08", "0.1"),
        1,
        1,
    ),
    (
        "arm of the pivot's distance",
        "the arm is as long as the pivot is far: |c − L| is zero, and so is the least start radius",
        SWING,
        arm("0.03", "0.008", "0.1", "0.1"),
        1,
        1,
    ),
    (
        "flat rocker nearly as fast as the cam",
        "1 + ψ′ falls to a few hundredths and ρ has its cube below",
        FAST,
        rocker("0.04", "0.11"),
        1,
        1,
    ),
    (
        "flat rocker clockwise, rising fast",
        "1 − ψ′ is what counts when the cam turns the other way",
        FAST,
        rocker("0.04", "0.11"),
        -1,
        1,
    ),
    (
        "flat face at the edge of undercut",
        "R + s + s″ is left over from centimetres where the curve is sharpest: it all but vanishes",
        CYCLE,
        flat("0.0164263127864"),
        1,
        1,
    ),
    (
        "rise of a nanometre in 0.0001 deg",
        "a span of 1.7e-6 rad: derivatives of the law are 1e12 times the lift",
        TINY,
        roller("0.025", "0.006"),
        1,
        1,
    ),
    (
        "rise of ten nanometres in 0.01 deg",
        "curvature changes its sign twice within 0.01 deg, where s″ is 1e8 times the lift",
        SHORT,
        roller("0.025", "0.006"),
        1,
        1,
    ),
    (
        "flat face, rise in 0.01 deg",
        "the contact runs out along the face and back within 0.01 deg: its way is s′, ten thousand times the lift",
        SHORT,
        flat("0.03"),
        1,
        1,
    ),
    (
        "fall below the base circle",
        "the lift is negative: the pitch curve lies within its start circle, and pressure angles change sides",
        BELOW,
        roller("0.025", "0.006", "0.003"),
        1,
        1,
    ),
    (
        "metre-sized cam",
        "sizes a thousand times larger: no tolerance may be in metres",
        CYCLE,
        roller("25", "6", "4"),
        1,
        1,
    ),
    (
        "micrometre-sized follower",
        "a roller of a micrometre on a cam of centimetres: curve and pitch curve agree in four digits",
        CYCLE,
        roller("0.025", "1e-6"),
        1,
        1,
    ),
    (
        "second roller close to the axis",
        "the second cam's own base circle is a difference of its rollers' distance and the first cam's size",
        CYCLE,
        mate("0.03", "0.008", "0.0575"),
        1,
        1,
    ),
    (
        "outer flank where the pitch curve is hollow",
        "on the outer flank the roller's radius subtracts from the hollow pitch curve's, and little is left",
        STEEP,
        roller("0.015", "0.012"),
        1,
        -1,
    ),
]

SIZES = [
    ("two limits", "", CYCLE, "0.006", "0.5", "0.5", None),
    ("unequal limits", "", RISES, "0.008", "0.35", "0.6", None),
    ("in line", "", CYCLE, "0.006", "0.5", "0.4", "0"),
    ("offset given", "", RISES, "0.006", "0.5", "0.4", "0.004"),
    (
        "wide limits that differ",
        "the nearest point may be a foot in place of the apex",
        RISES,
        "0.0001",
        "1.5",
        "1.3",
        None,
    ),
    (
        "limits of a tenth of a degree",
        "the cam is hundreds of times its lift: its size is a cotangent near its pole",
        CYCLE,
        "0.006",
        "0.0017",
        "0.0017",
        None,
    ),
    (
        "a rise of a nanometre beside one of millimetres",
        "the steepest place lies within 1.7e-6 rad, between any samples of the turn",
        TINY,
        "0.0001",
        "0.5",
        "0.5",
        None,
    ),
    (
        "fall below the base circle",
        "the lift is negative: the least radius of the floor decides, not that of the base circle",
        BELOW,
        "0.001",
        "0.6",
        "0.6",
        None,
    ),
]
FLATS = [
    ("flat face", "", CYCLE, "0.004"),
    ("flat face, steep", "", STEEP, "0.001"),
    (
        "flat face without a least radius",
        "no radius is left at the sharpest place: the size is where R + s + s″ vanishes",
        RISES,
        "0",
    ),
    (
        "flat face, rise in 0.01 deg",
        "s″ is two metres where the lift is ten nanometres: the size is that of a rise nobody sees",
        SHORT,
        "0.002",
    ),
]
