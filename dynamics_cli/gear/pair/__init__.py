"""Two cylindrical gears, or a gear and a rack: engagement, contact, forces, interference."""
