"""The radial cam and its followers: contact, profile, curvature, undercut."""
