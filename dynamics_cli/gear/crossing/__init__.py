"""Gears on shafts that cross or meet: bevel, crossed helical, hypoid and worm pairs."""
