"""Given inertia tensors: what they say, and the torque of a moving body."""
