"""A crash from the change of velocity that one vehicle recorded."""
