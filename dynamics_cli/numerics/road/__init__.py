"""Motion of a vehicle on a road that several families need: drag along it, slides, phases."""
