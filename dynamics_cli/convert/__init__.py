"""Units, and coordinates: conversions of every kind."""
