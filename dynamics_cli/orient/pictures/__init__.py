"""Pictures of orientation."""
