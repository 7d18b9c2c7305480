"""Inverse kinematics: every set of joint angles that gives a pose."""
