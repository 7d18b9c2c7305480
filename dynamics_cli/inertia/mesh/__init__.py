"""Bodies bounded by triangles: reading, proof of closure, integration."""
