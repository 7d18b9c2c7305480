"""A cam as files: arcs, cubics or lines within a stated deviation, and tables for machines."""
