"""A particle: projectiles, falls, turning tubes and frames, inclines, circles."""
