"""Where an arm reaches: the area in the plane of its links, its border, and the postures at a point."""
