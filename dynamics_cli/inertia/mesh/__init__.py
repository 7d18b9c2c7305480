"""Bodies bounded by triangles: reading them, proving them closed, integrating over them."""
