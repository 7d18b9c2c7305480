"""Slider-cranks and quick returns."""
