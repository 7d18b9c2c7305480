"""Faults of a surface: open edges, crossings, repeated and overlapping parts."""
