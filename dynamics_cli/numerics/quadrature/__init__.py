"""Quadrature: Gauss rules, sparse grids and lattices."""
