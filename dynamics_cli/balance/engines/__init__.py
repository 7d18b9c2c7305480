"""Piston engines: their inertia forces by order, and balance shafts."""
