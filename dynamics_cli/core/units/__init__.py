"""Units: what a name means in SI, exactly; quantities converted and shown."""
