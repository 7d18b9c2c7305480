"""Arms as users describe them, and the frames of their links."""
