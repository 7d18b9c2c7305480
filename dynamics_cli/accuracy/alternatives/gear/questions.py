"""Gears: the questions asked of them, and the textbook's method for each."""

from dynamics_cli.accuracy.questions import Comparison, Method, Question, textbooks

HERE = "dynamics_cli.accuracy.alternatives.gear."
INVOLUTE, PROGRAM = HERE + "involute:", HERE + "own:"
SIZES, TRAINS, MESHES = "gear_geometry.json", "gear_trains.json", "gear_meshes.json"

QUESTIONS = (
    Question(
        "gear", "pair", "inverse involute", SIZES, "inverse",
        Method("series", INVOLUTE + "chosen_inverse", chosen=True, tracked=True),
        Method("Newton on tan φ − φ", INVOLUTE + "newton"),
    ),
    Question(
        "gear", "pair", "involute function", SIZES, "inv",
        Method("series below 0.98 rad", INVOLUTE + "chosen_involute", chosen=True, tracked=True),
        Method("tan φ − φ", INVOLUTE + "textbook_involute"),
    ),
    Question(
        "gear", "profile", "undercut junction", TRAINS, "root",
        Method("bracketed, of differences", INVOLUTE + "chosen_root", chosen=True, tracked=True),
        Method("Newton on half angles", INVOLUTE + "root_by_newton"),
    ),
    Comparison("gear", "ratio", "gear ratio", HERE + "ratio:compare"),
    # whose references are in other words than their tasks' results
    Question(
        "gear", "pair", "gear pair", SIZES, "pair",
        Method("closed form", PROGRAM + "pair", chosen=True, tracked=True),
    ),
    Question(
        "gear", "measure", "gear measure", TRAINS, "measure",
        Method("closed form", PROGRAM + "measure", chosen=True, tracked=True),
    ),
    Question(
        "gear", "mesh", "gear mesh", MESHES, "mesh",
        Method("closed forms, edges placed by Newton", PROGRAM + "mesh", chosen=True),
    ),
    Question(
        "gear", "data-block", "gear data-block", MESHES, "data_block",
        Method("closed forms, rounded last", PROGRAM + "data_block", chosen=True),
    ),
    *textbooks(
        "gear", MESHES, HERE,
        ("profile", "textbook: end of the rack's flank, external", "involute:profile"),
    ),
)  # fmt: skip
