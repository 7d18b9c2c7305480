"""Orientation: turns in every notation, angular velocity and acceleration, rolling."""
