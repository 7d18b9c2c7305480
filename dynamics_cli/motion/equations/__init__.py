"""Equations of motion of a scene at an instant, by Kane's method and by Lagrange's."""
