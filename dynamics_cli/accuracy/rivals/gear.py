"""Gears: the questions asked of them."""

from dynamics_cli.accuracy.questions import Comparison, Method, Question

RIVALS = "dynamics_cli.accuracy.rivals."
INVOLUTE, ROOT, GEOMETRY, BOOK = (
    RIVALS + name for name in ("gear_involute:", "gear_root:", "gear_geometry:", "gear_sizes:")
)
SIZES, TRAINS, MESHES = "gear_geometry.json", "gear_trains.json", "gear_meshes.json"
PROFILES = RIVALS + "gear_meshes:"


def _sizes(task: str, file: str = SIZES, *rivals: Method) -> Question:
    own = Method("closed form", GEOMETRY + task, chosen=True, tracked=True)
    return Question("gear", task, f"gear {task}", file, task, own, *rivals)


QUESTIONS = (
    Question(
        "gear", "pair", "inverse involute", SIZES, "inverse",
        Method("series", INVOLUTE + "chosen_inverse", chosen=True, tracked=True, arrays=True),
        Method("Newton on tan φ − φ", INVOLUTE + "newton"),
        Method("Newton in tan φ", INVOLUTE + "newton_in_tangent"),
        Method("halving", INVOLUTE + "bisection"),
        Method("Ridders, bracketed", INVOLUTE + "ridders"),
        Method("scipy brentq", INVOLUTE + "by_brentq", needs="scipy"),
    ),
    Question(
        "gear", "pair", "involute function", SIZES, "inv",
        Method("series below 0.98 rad", INVOLUTE + "chosen_involute", chosen=True, tracked=True, arrays=True),
        Method("tan φ − φ", INVOLUTE + "textbook_involute"),
    ),
    Question(
        "gear", "profile", "undercut junction", TRAINS, "root",
        Method("bracketed, of differences", ROOT + "chosen", chosen=True, tracked=True),
        Method("Newton on half angles", ROOT + "newton"),
        Method("Newton for two unknowns", ROOT + "newton_of_two"),
        Method("halving on half angles", ROOT + "halving"),
    ),
    Comparison("gear", "ratio", "gear ratio", RIVALS + "gear_ratio:compare"),
    _sizes(
        "spur", SIZES,
        Method("tan α − α, five sizes only", GEOMETRY + "spur_by_book"),
        Method("involutes of six decimals", GEOMETRY + "spur_by_table"),
    ),
    _sizes(
        "helical", SIZES,
        Method("tan α − α, five sizes only", GEOMETRY + "spur_by_book"),
        Method("involutes of six decimals", GEOMETRY + "spur_by_table"),
    ),
    _sizes(
        "pair", SIZES,
        Method("tan α − α and Newton, three sizes only", GEOMETRY + "pair_by_book"),
        Method("involutes of six decimals", GEOMETRY + "pair_by_table"),
        Method("py_gearworks, distance only", GEOMETRY + "pair_by_py_gearworks", needs="py_gearworks"),
    ),
    _sizes(
        "bevel", SIZES,
        Method("second angle as a difference, cones only", BOOK + "bevel_by_book"),
        Method("the same in 32 bits", BOOK + "bevel_single"),
    ),
    _sizes(
        "worm", SIZES,
        Method("efficiencies as printed, axial module", BOOK + "worm_by_book"),
        Method("the same in 32 bits", BOOK + "worm_single"),
    ),
    _sizes("crossed", SIZES, Method("virtual spur gears, working angle only", BOOK + "crossed_by_book")),
    _sizes("measure", TRAINS, Method("tan α − α and Newton, external only", BOOK + "span_by_book")),
    Question(
        "gear", "mesh", "gear mesh", MESHES, "mesh",
        Method("closed forms, edges placed by Newton", PROFILES + "mesh", chosen=True),
        Method("tan α − α and arc cosines, three sizes only", PROFILES + "mesh_by_book"),
        Method("distances between points, external only", PROFILES + "mesh_by_polygons"),
    ),
    Question(
        "gear", "identify", "gear identify", MESHES, "identify",
        Method("closed form", PROFILES + "identify", chosen=True, tracked=True),
        Method("involutes of six decimals, spur, best shift only", PROFILES + "identify_by_table"),
    ),
    Question(
        "gear", "data-block", "gear data-block", MESHES, "data_block",
        Method("closed forms, rounded last", PROFILES + "data_block", chosen=True),
        Method("involutes of six decimals, external, some only", PROFILES + "block_by_table"),
    ),
    Question(
        "gear", "profile", "gear profile", MESHES, "profile",
        Method("closed forms, junction bracketed", PROFILES + "profile", chosen=True),
        Method("end of the rack's flank, external only", PROFILES + "profile_by_book"),
    ),
)  # fmt: skip
