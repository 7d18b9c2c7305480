"""Published ranges of what a reconstruction has to assume, with their sources."""
