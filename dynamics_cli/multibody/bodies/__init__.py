"""A scene of bodies in space as a tree of links with loops."""
