"""Uncertain values: their distributions, how they go through any model, and how the outcome is told."""
