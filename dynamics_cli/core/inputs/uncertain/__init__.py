"""Uncertain inputs as written: distributions, values and vectors."""
