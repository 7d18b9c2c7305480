"""Trees of rigid bodies in space, joined by joints of every kind."""
