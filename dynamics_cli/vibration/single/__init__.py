"""One mass on a spring."""
