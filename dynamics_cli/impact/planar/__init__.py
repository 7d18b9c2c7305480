"""Planar impact of rigid bodies with friction."""
