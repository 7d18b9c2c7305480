"""Work, power and energy."""
