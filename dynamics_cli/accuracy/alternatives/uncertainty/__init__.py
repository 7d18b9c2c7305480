"""Alternatives to the program's methods for propagation of uncertainty."""
