"""Chebyshev interpolants of smooth functions, and their extremes."""
