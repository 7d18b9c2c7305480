"""Trees of bodies at an instant."""
