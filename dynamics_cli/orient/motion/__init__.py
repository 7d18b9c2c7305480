"""Motion of bodies that turn: angular velocity and acceleration, and points of the body."""
