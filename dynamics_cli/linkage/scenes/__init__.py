"""Linkages from scenes: assemblies, motion, mobility."""
