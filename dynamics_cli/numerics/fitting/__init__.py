"""Arcs, cubics and lines fitted to a curve, with a proved deviation."""
