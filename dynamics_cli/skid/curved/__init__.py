"""Curved ways: yaw marks from surveyed points, and swerves."""
