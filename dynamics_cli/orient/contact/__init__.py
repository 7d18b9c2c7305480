"""Bodies that roll on others, and joints between shafts."""
