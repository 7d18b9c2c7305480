"""Straight motion: phases of constant acceleration, and laws of the acceleration."""
