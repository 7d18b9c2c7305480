"""Time and distance of a crash: phases of motion, two parties that meet, and sight."""
