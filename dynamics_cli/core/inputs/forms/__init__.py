"""Inputs in special forms: tensors, formulas and their variables."""
