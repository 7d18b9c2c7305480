"""Forces and moments of joints: at rest, at an instant, over a stride."""
