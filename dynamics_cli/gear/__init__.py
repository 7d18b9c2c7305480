"""Gear geometry, measurement, trains and ratios."""
