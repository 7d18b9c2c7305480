"""Uncertain inputs as they are written: distributions, values and vectors."""
