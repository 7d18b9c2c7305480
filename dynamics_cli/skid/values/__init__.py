"""Published ranges of quantities that a reconstruction must assume, with their sources."""
