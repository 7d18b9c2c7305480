"""What the help says of the language of motion programs."""

PROGRAM_NOTES = (
    "--program: clauses separated by semicolons: rise LIFT in ANGLE LAW; dwell ANGLE; return [to LIFT] in ANGLE LAW. "
    "A lift in deg swings an arm; one clause may leave its angle out and takes the rest of the turn; the law is 3-4-5 "
    "unless named (dynamics cam laws). The whole language: docs/scenes.md."
)
