"""Measured tracks: the file, and velocity and acceleration with their noise."""
