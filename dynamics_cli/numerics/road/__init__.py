"""Motion of a vehicle on a road, shared by several families: drag along it, slides, phases."""
