"""Programs of cam motion: reading segments, joining them into one revolution, reporting."""
