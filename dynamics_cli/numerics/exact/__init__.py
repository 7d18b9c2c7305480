"""Exact and many-digit arithmetic: rationals, decimals, constants, exact factors."""
