"""Help text about the language of motion programs."""

PROGRAM_NOTES = (
    "--program: clauses separated by semicolons: rise LIFT in ANGLE LAW; dwell ANGLE; return [to LIFT] in ANGLE LAW. "
    "A lift in deg swings an arm; angles may be ranges, 0-90 rise 20 mm; 90-150 dwell; one clause may leave its angle "
    "out and takes the rest of the turn; the law is 3-4-5 unless named (dynamics cam laws). All: docs/scenes.md."
)

# The values that scene templates show.
PROGRAM_SCENE = {"program": "rise 20 mm in 90 deg; dwell 60 deg; return in 90 deg; dwell"}
ROLLER_SCENE = {**PROGRAM_SCENE, "follower": "roller", "base_radius": "40 mm", "roller_radius": "8 mm"}
