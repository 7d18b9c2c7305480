"""Motion along curves: formulas and named curves, events along them, arc length."""
