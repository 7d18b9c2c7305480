"""Programs of cam motion: segments read, joined into one revolution, and reported."""
