"""One case answered: the model chosen, the physics called, its limits, bounds and formulas."""
