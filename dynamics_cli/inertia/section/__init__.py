"""Area properties of plane sections."""
