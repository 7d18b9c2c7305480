"""Pendulums: simple, compound, conical, damped; lengths for a period."""
