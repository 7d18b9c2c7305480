"""Gears: the questions asked of them."""

from dynamics_cli.accuracy.questions import Comparison, Method, Question

RIVALS = "dynamics_cli.accuracy.rivals."
INVOLUTE, ROOT, GEOMETRY, BOOK, SIZED, MEASURE = (
    RIVALS + name
    for name in ("gear_involute:", "gear_root:", "gear_geometry:", "gear_book:", "gear_sizes:", "gear_measure:")
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
        Method("Brent, bracketed", INVOLUTE + "brent_inverse"),
        Method("scipy brentq", INVOLUTE + "by_brentq", needs="scipy"),
    ),
    Question(
        "gear", "pair", "involute function", SIZES, "inv",
        Method("series below 0.98 rad", INVOLUTE + "chosen_involute", chosen=True, tracked=True, arrays=True),
        Method("tan φ − φ", INVOLUTE + "textbook_involute"),
        Method("power series, five terms", INVOLUTE + "power_series"),
    ),
    Question(
        "gear", "profile", "undercut junction", TRAINS, "root",
        Method("bracketed, of differences", ROOT + "chosen", chosen=True, tracked=True),
        Method("Newton on half angles", ROOT + "newton"),
        Method("Newton for two unknowns", ROOT + "newton_of_two"),
        Method("halving on half angles", ROOT + "halving"),
    ),
    Comparison("gear", "ratio", "gear ratio", RIVALS + "gear_ratio:compare"),
    *(
        _sizes(
            task, SIZES,
            Method("textbook: tan α − α, secant", BOOK + "spur"),
            Method("the same by halving", BOOK + "spur_by_radii"),
            Method("involutes of six decimals", BOOK + "spur_by_table"),
        )
        for task in ("spur", "helical")
    ),
    _sizes(
        "pair", SIZES,
        Method("textbook: tan α − α, Newton", BOOK + "pair"),
        Method("the same by Brent", BOOK + "pair_by_brent"),
        Method("involutes of six decimals", BOOK + "pair_by_table"),
        Method("py_gearworks, distance only", GEOMETRY + "pair_by_py_gearworks", needs="py_gearworks"),
    ),
    _sizes(
        "bevel", SIZES,
        Method("textbook: second angle as a difference", SIZED + "bevel_by_book"),
        Method("Brent on z₁·sin δ₂ = z₂·sin δ₁", SIZED + "bevel_by_brent"),
        Method("the textbook's in 32 bits", SIZED + "bevel_single"),
    ),
    _sizes(
        "worm", SIZES,
        Method("textbook: efficiencies as printed", SIZED + "worm_by_book"),
        Method("tangents of angles added", SIZED + "worm_by_angles"),
        Method("the textbook's in 32 bits", SIZED + "worm_single"),
    ),
    _sizes(
        "crossed", SIZES,
        Method("textbook: tan α − α, Newton", SIZED + "crossed_by_book"),
        Method("the same by Brent", SIZED + "crossed_by_brent"),
    ),
    _sizes(
        "measure", TRAINS,
        Method("textbook: tan α − α, Newton", MEASURE + "by_newton"),
        Method("the same by Brent", MEASURE + "by_brent"),
    ),
    Question(
        "gear", "mesh", "gear mesh", MESHES, "mesh",
        Method("closed forms, edges placed by Newton", PROFILES + "mesh", chosen=True),
        Method("tan α − α and arc cosines, three sizes only", PROFILES + "mesh_by_book"),
        Method("distances between points, external only", PROFILES + "mesh_by_polygons"),
    ),
    Question(
        "gear", "identify", "gear identify", MESHES, "identify",
        Method("closed form", PROFILES + "identify", chosen=True, tracked=True),
        Method("textbook: tan α − α, spur, best shift only", PROFILES + "identify_by_book"),
        Method("involutes of six decimals, likewise", PROFILES + "identify_by_table"),
    ),
    Question(
        "gear", "data-block", "gear data-block", MESHES, "data_block",
        Method("closed forms, rounded last", PROFILES + "data_block", chosen=True),
        Method("textbook: tan α − α, external, some only", PROFILES + "block_by_book"),
        Method("involutes of six decimals, likewise", PROFILES + "block_by_table"),
    ),
    Question(
        "gear", "profile", "gear profile", MESHES, "profile",
        Method("closed forms, junction bracketed", PROFILES + "profile", chosen=True),
        Method("textbook: end of the rack's flank, external", PROFILES + "profile_by_book"),
        Method("trochoid and involute by halving, external", PROFILES + "profile_by_halving"),
    ),
)  # fmt: skip
