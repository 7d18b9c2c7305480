"""Motion along curves: formulas and named curves, what happens on the way, arc length."""
