"""Stability: Routh–Hurwitz, gains, ranges of coefficients, delays, matrices, equilibria, sampled systems."""
