"""Given inertia tensors: their properties, and the torque of a moving body."""
