"""Two exact profiles turned through each other: contact, clearances and overlaps."""
