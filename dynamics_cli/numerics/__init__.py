"""Mathematics without physics: the elementary functions of every formula, and the bounds of their errors."""
