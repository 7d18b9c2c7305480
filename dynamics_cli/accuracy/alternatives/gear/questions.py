"""Gears: the questions asked of them, and the alternatives; further own methods are those of the tasks."""

from dynamics_cli.accuracy.questions import Comparison, Method, Question

HERE = "dynamics_cli.accuracy.alternatives.gear."
INVOLUTE, ROOT, OWN, BOOK, SIZED, MEASURE, PROFILES = (
    HERE + name for name in ("involute:", "root:", "own:", "book:", "sizes:", "measure:", "meshes:")
)
SIZES, TRAINS, MESHES = "gear_geometry.json", "gear_trains.json", "gear_meshes.json"


def _task(task: str, file: str, *methods: Method, cases: str = "") -> Question:
    return Question("gear", task, f"gear {task}", file, cases or task.replace("-", "_"), *methods)


QUESTIONS = (
    Question(
        "gear", "pair", "inverse involute", SIZES, "inverse",
        Method("series", INVOLUTE + "chosen_inverse", chosen=True, tracked=True, arrays=True),
        Method("Newton on tan φ − φ", INVOLUTE + "newton"),
        Method("Newton in tan φ", INVOLUTE + "newton_in_tangent"),
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
        Method("halving on half angles", ROOT + "halving"),
    ),
    Comparison("gear", "ratio", "gear ratio", HERE + "ratio:compare"),
    _task("spur", SIZES, Method("textbook: tan α − α, secant", BOOK + "spur")),
    _task("helical", SIZES, Method("textbook: tan α − α, secant", BOOK + "spur")),
    _task(
        "pair", SIZES,
        Method("closed form", OWN + "pair", chosen=True, tracked=True),
        Method("textbook: tan α − α, Newton", BOOK + "pair"),
    ),
    _task("bevel", SIZES, Method("textbook: second angle as a difference", SIZED + "bevel_by_book")),
    _task("worm", SIZES, Method("textbook: efficiencies as printed", SIZED + "worm_by_book")),
    _task("crossed", SIZES, Method("textbook: tan α − α, Newton", SIZED + "crossed_by_book")),
    _task(
        "measure", TRAINS,
        Method("closed form", OWN + "measure", chosen=True, tracked=True),
        Method("textbook: tan α − α, Newton", MEASURE + "by_newton"),
    ),
    _task(
        "mesh", MESHES,
        Method("closed forms, edges placed by Newton", OWN + "mesh", chosen=True),
        Method("tan α − α and arc cosines, three sizes only", PROFILES + "mesh_by_book"),
    ),
    _task("identify", MESHES, Method("textbook: tan α − α, spur, best shift only", PROFILES + "identify_by_book")),
    _task(
        "data-block", MESHES,
        Method("closed forms, rounded last", OWN + "data_block", chosen=True),
        Method("textbook: tan α − α, external, some only", PROFILES + "block_by_book"),
    ),
    _task(
        "profile", MESHES,
        Method("textbook: end of the rack's flank, external", PROFILES + "profile_by_book"),
        Method("trochoid and involute by halving, external", PROFILES + "profile_by_halving"),
    ),
)  # fmt: skip
