"""Skids and flights: the textbook's formula for every task."""

from dynamics_cli.accuracy.questions import Method, Question

HERE = "dynamics_cli.accuracy.alternatives.skid."
# The name of the cases, what the textbook does, and its function.
TEXTBOOK = (
    ("speed", "sine and cosine of the slope", "roads:speed_by_slope_angle"),
    ("distance", "difference of squares", "roads:distance_by_squares"),
    ("friction", "sums of squares in one pass", "roads:friction_by_sums"),
    ("drag_factor", "sine and cosine of the slope", "roads:drag_by_angles"),
    ("stop", "v·t + v²/2a, cubes while brakes take hold", "roads:stop_by_book"),
    ("yaw", "angles added", "roads:yaw_by_bank_angle"),
    ("vault_least_speed", "rise plus slant", "flights:least_vault_by_book"),
    ("vault_known_angle", "range formula as printed", "flights:vault_by_book"),
    ("pedestrian", "Searle, slide as a difference", "flights:throw_by_searle"),
    ("avoid", "root of the quadratic as taught", "roads:avoid_by_roots"),
    ("spin", "speeds subtracted", "roads:spin_by_differences"),
)
QUESTIONS = tuple(
    Question("skid", "", "", "skid.json", cases, Method(f"textbook: {words}", HERE + function))
    for cases, words, function in TEXTBOOK
)
