"""Orientation in numbers: rotations, quaternions, and angles in the 24 sequences."""
