"""The unit-aware library all families share: from text or JSON to SI numbers, and from records to documents."""
