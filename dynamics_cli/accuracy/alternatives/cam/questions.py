"""Cams: the questions asked of them."""

from dynamics_cli.accuracy.questions import Comparison

HERE = "dynamics_cli.accuracy.alternatives.cam."
# The task, the question, and the function that compares the methods.
ROWS = (
    ("rise", "cam law", "laws:compare"),
    ("rise", "cam polynomial", "laws:compare_polynomials"),
    ("motion", "cam motion", "laws:compare_motions"),
    ("profile", "cam extremes", "extremes:compare"),
    ("profile", "cam points", "extremes:compare_points"),
    ("size", "cam size", "sizes:compare"),
    ("force", "cam force", "forces:compare"),
)
QUESTIONS = tuple(Comparison("cam", task, name, HERE + function) for task, name, function in ROWS)
