"""Cam motions, profiles, sizes and forces."""
