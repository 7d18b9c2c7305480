"""Approach speeds from the motion after the impact, spins among it."""
