"""Further ways to answer the questions of inertia."""
