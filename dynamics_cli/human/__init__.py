"""The human body: segment masses, postures, joint moments, gait, falls."""
