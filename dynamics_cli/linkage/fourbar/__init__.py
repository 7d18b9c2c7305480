"""The four-bar linkage: closure, class, coupler curves."""
