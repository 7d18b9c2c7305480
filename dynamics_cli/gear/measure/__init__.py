"""Measuring a gear: sizes over teeth and pins, unknown gears, the data for its drawing."""
