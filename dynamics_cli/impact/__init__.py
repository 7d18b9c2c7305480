"""Impact and restitution."""
