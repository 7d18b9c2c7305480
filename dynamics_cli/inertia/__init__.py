"""Mass properties and principal axes."""
