"""What is wrong with a surface: open edges, crossings, repeated and overlapping parts."""
