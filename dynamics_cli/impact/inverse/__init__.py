"""Approach speeds from the motion after the impact, including spins."""
