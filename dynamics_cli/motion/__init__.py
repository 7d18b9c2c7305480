"""Motion of systems of bodies."""
