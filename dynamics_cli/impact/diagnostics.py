"""What every impact says about its own answer: checks of two sides, and numbers that leave the range."""

from dynamics_cli.errors import require
from dynamics_cli.records import Check

# Between these, products and quotients of several numbers keep all their digits.
SMALLEST, LARGEST = 1e-40, 1e40
# An angle may be as small as it likes.
ANGLES = ("heading", "nose", "angle", "swing", "normal")
# A residual check that fails is a fault of the program, so it leaves room for sums of many roundings.
TOLERANCE = 1e-12


def plain(x: float) -> float:
    """The number inside a tracked number; anything else as it is."""
    return getattr(x, "value", x)


def single(*values: object) -> bool:
    """Whether these are single numbers: advice and checks are told of one case, never of an array of them."""
    return not any(getattr(value, "ndim", 0) for value in values)


def balance(name: str, left: float, right: float, scale: float, least: float = TOLERANCE) -> tuple[Check, ...]:
    """Check that two sides agree relative to `scale`, or within the rounding bounds that they carry.

    Nothing for arrays, nor where the sides are so small or large that digits may be lost.
    """
    if not single(left, right, scale):
        return ()
    size = abs(plain(scale))
    if not 1e-140 < size < 1e280:
        return ()
    error: float = (getattr(left, "error", 0.0) + getattr(right, "error", 0.0)) / size
    if not error < 1.0:
        return ()
    tolerance = max(least, 1.01 * error)
    residual = abs(plain(left) - plain(right)) / size
    return (Check(name=name, passed=residual <= tolerance, value=residual, tolerance=tolerance),)


def not_above(name: str, value: float, limit: float, scale: float) -> tuple[Check, ...]:
    """Check that `value` does not exceed `limit` by more than rounding."""
    if not single(value, limit, scale):
        return ()
    size = abs(plain(scale))
    if not 1e-140 < size < 1e280:
        return ()
    excess = max((plain(value) - plain(limit)) / size, 0.0)
    return (Check(name=name, passed=excess <= TOLERANCE, value=excess, tolerance=TOLERANCE),)


def require_finite(value: float, what: str) -> None:
    """Refuse an answer beyond the largest double."""
    require(
        (value - value) == 0.0,
        what + " leaves the range of a double",
        code="range",
        hint="check the size of the inputs",
    )


def require_sizes(**given: object) -> None:
    """Refuse numbers so small or large that a calculation of several of them would leave the range of a double."""
    for name, value in given.items():
        _require_size(name, value)


def _require_size(name: str, value: object) -> None:
    if value is None or isinstance(value, (str, bool)):
        return
    fields = getattr(value, "fields", None)
    if fields is not None:
        for field in fields:
            _require_size(f"{name}.{field}", getattr(value, field))
    elif isinstance(value, tuple):
        for index, part in enumerate(value):
            _require_size(f"{name}[{index}]", part)
    elif not name.endswith(ANGLES):
        size: float = abs(value)  # type: ignore[arg-type]
        require(
            (size == 0.0) | ((size > SMALLEST) & (size < LARGEST)),
            name + " is {0:.3g} in SI units: the calculation holds sizes from 1e-40 to 1e40",
            value,
            code="range",
            hint="check the size of the number and its unit",
        )
