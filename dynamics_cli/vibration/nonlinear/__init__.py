"""Nonlinear oscillators: Krylov and Bogoliuboff beside the integrated truth."""
