"""Assemblies of parts and holes: composed, compared, reported and written."""
