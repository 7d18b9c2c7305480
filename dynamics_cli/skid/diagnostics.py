"""What every skid calculation says about its own answer: residual checks, and the plain numbers that advice quotes."""

from dynamics_cli.records import Check

# A residual check that fails is a fault of the program, so it leaves room for long sums of roundings.
TOLERANCE = 1e-12
DEGREES = 57.29577951308232


def plain(x: float) -> float:
    """The number inside a tracked number; anything else as it is."""
    return getattr(x, "value", x)


def single(*values: object) -> bool:
    """Whether these are single numbers: advice and checks are told of one case, never of an array of them."""
    return not any(getattr(value, "ndim", 0) for value in values)


def balance(name: str, left: float, right: float, scale: float) -> tuple[Check, ...]:
    """Check that two sides agree relative to `scale`; nothing for arrays, nor where squares overflow."""
    if not single(left, right, scale):
        return ()
    size = abs(plain(scale))
    if not 1e-280 < size < 1e280:
        return ()
    residual = abs(plain(left) - plain(right)) / size
    return (Check(name=name, passed=residual <= TOLERANCE, value=residual, tolerance=TOLERANCE),)
