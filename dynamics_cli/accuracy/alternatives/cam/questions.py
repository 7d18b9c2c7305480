"""Cams: the questions asked of them."""

from dynamics_cli.accuracy.questions import Comparison

LAWS = "dynamics_cli.accuracy.alternatives.cam.laws:"
EXTREMES = "dynamics_cli.accuracy.alternatives.cam.extremes:"
POINTS = "dynamics_cli.accuracy.alternatives.cam.points:"
EXPORT = "dynamics_cli.accuracy.alternatives.cam.export:"
FORCES = "dynamics_cli.accuracy.alternatives.cam.forces:"
ENTITIES = "dynamics_cli.accuracy.alternatives.cam.entities:"
SIZES = "dynamics_cli.accuracy.alternatives.cam.sizes:"
MOTIONS = "dynamics_cli.accuracy.alternatives.cam.motions:"

QUESTIONS = (
    Comparison("cam", "rise", "cam law, by its peak", LAWS + "compare"),
    Comparison("cam", "rise", "cam law, relative", LAWS + "compare_relative"),
    Comparison("cam", "rise", "cam polynomial", MOTIONS + "compare_polynomials"),
    Comparison("cam", "motion", "cam motion", MOTIONS + "compare_motions"),
    Comparison("cam", "profile", "cam extremes", EXTREMES + "compare"),
    Comparison("cam", "profile", "cam points", POINTS + "compare"),
    Comparison("cam", "export", "cam export, arcs", EXPORT + "compare_arcs"),
    Comparison("cam", "export", "cam export, cubics", EXPORT + "compare_cubics"),
    Comparison("cam", "export", "cam export, pieces for 1 µm", ENTITIES + "compare_micrometre"),
    Comparison("cam", "export", "cam export, pieces for 1 nm", ENTITIES + "compare_nanometre"),
    Comparison("cam", "size", "cam size", SIZES + "compare"),
    Comparison("cam", "force", "cam force", FORCES + "compare"),
)
