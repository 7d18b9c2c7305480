"""Eigenvalues of symmetric 3 × 3 matrices, with proved residual bounds."""
