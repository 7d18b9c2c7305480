"""Reconstruction of crashes: momentum, crush, and yaw inertia of vehicles."""
