"""Impact of rigid bodies in space with friction, and scenes of two bodies."""
