"""Methods of propagation: quantiles by grids, lattices, lines and samples, and the choice among them."""
