"""Planar linkages as users write them: their equations, and all ways to put them together."""
