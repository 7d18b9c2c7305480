"""Balancing of rotors and engines."""
