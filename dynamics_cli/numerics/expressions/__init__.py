"""Formulas that people type: grammar and evaluation, exact derivatives by jets, poles, motion under a law."""

from dynamics_cli.numerics.expressions.grammar import FUNCTIONS, Expression, begin, check_names, constant, parse

__all__ = ["FUNCTIONS", "Expression", "begin", "check_names", "constant", "parse"]
