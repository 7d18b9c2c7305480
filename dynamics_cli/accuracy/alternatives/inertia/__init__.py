"""Alternatives to the program's methods for mass properties."""
