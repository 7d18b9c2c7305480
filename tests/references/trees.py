"""Inputs of references as trees of doubles: drawn, read as exact numbers, and written as text."""

import random
from typing import Any

from mpmath import mpf


def exact(tree: Any) -> Any:
    """Doubles as exact numbers."""
    if isinstance(tree, float):
        return mpf(tree)
    if isinstance(tree, dict):
        return {name: exact(part) for name, part in tree.items()}
    return [exact(part) for part in tree] if isinstance(tree, list) else tree


def written(tree: Any) -> Any:
    """Doubles as text that reads back to the same bits."""
    if isinstance(tree, float):
        return repr(tree)
    if isinstance(tree, dict):
        return {name: written(part) for name, part in tree.items()}
    return [written(part) for part in tree] if isinstance(tree, list) else tree


def draw(generator: random.Random, low: float, high: float) -> float:
    """A double as a person would write it, or any double."""
    value = generator.uniform(low, high)
    return round(value, 2) if generator.random() < 0.4 else value
