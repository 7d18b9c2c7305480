"""Alternatives to the program's methods for skids and flights."""
