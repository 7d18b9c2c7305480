"""Laws of forces: springs, gravity, friction, and first moments of mass."""
