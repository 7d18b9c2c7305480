"""Impacts of particles: central, oblique, dropped, pendulums, chains."""
