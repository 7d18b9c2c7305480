"""Cams: the questions asked of them."""

from dynamics_cli.accuracy.questions import Comparison

LAWS = "dynamics_cli.accuracy.rivals.cam_laws:"

QUESTIONS = (
    Comparison("cam", "rise", "cam law, by its peak", LAWS + "compare"),
    Comparison("cam", "rise", "cam law, relative", LAWS + "compare_relative"),
)
