"""Orientation in numbers: quaternions, and angles in the 24 sequences."""
