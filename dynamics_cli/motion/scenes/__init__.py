"""Planar scenes of bodies: motion and equilibrium."""
