"""Relative motion of two points: constant accelerations, formulas, measured tracks."""
