"""Motion of a point: straight, on a circle, in every system of coordinates, along curves and measured tracks."""
