"""Bodies of a planar scene: names, joints, forces, equations, start."""
