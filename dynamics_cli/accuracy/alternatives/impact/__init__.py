"""Alternatives to the program's methods for impacts."""
