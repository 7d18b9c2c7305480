"""Inputs in forms of their own: tensors, formulas and their variables."""
