"""Trains of gears, planets, tooth numbers for a ratio, rolling wheels and belts."""
