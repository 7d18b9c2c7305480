"""Equilibria of potentials and of states with any rates."""
