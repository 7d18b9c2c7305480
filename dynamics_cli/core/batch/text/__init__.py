"""Lines of CSV and JSON, sorted by shape and turned into columns of exact numbers."""
