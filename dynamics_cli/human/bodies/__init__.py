"""A body in a posture: tables of its segments, persons, figures, mass properties."""
