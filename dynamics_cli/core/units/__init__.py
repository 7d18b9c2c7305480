"""Units: exact definitions of names in SI; conversion and display of quantities."""
