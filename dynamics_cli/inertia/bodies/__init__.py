"""Mass properties of one body: amount, moments, principal axes, rotations."""
