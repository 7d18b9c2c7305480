"""Motion over time, rest, and small motions."""
