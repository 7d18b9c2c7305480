"""Further ways to answer the questions of skid."""
