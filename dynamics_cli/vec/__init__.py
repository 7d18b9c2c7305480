"""Vectors, frames, lines and planes, small matrices."""
