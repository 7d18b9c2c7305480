"""One cylindrical gear: its rack, diameters, root, profile and limits."""
