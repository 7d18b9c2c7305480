"""Checks of impact results, and refusal of numbers that leave the range of a double."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.quantities import Ratio
from dynamics_cli.records import Check

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

# Between these, products and quotients of several numbers keep all their digits.
SMALLEST, LARGEST = 1e-40, 1e40
# Angles and ratios of speeds may be arbitrarily small.
ANY_SMALLNESS = ("heading", "nose", "angle", "swing", "normal", "restitution")
# A residual check that fails is an internal error, so it allows for sums of many roundings.
TOLERANCE = 1e-12


def balance(name: str, left: float, right: float, scale: float, least: float = TOLERANCE) -> tuple[Check, ...]:
    """Check that two sides agree relative to `scale`, or within the rounding bounds that they carry.

    No check for arrays, or for sides so small or large that digits may be lost.
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


def momentum_kept(
    masses: "Sequence[float | None]",
    before: "Sequence[Sequence[float]]",
    after: "Sequence[Sequence[float]]",
    impulse: float,
) -> tuple[Check, ...]:
    """Check the momentum of two bodies along each axis; no check where one is fixed."""
    one, two = masses
    if one is None or two is None:
        return ()
    checks: tuple[Check, ...] = ()
    for axis in range(len(before[0])):
        held = one * before[0][axis], two * before[1][axis]
        left = one * after[0][axis] + two * after[1][axis]
        size = impulse + absolute(held[0]) + absolute(held[1])
        checks += balance(f"momentum along {'xyz'[axis]}", held[0] + held[1], left, size)
    return checks


def require_finite(value: float, what: str) -> None:
    """Refuse an answer beyond the largest double."""
    require(
        (value - value) == 0.0,
        "{what} leaves the range of a double",
        what=what,
        code="range",
        hint="check the size of the inputs",
    )


def require_sizes(**numbers: object) -> None:
    """Refuse numbers so small or large that a calculation of several of them would leave the range of a double."""
    for name, value in numbers.items():
        _require_size(name, value)


def _require_size(name: str, value: object) -> None:
    if value is None or isinstance(value, (str, bool)):
        return
    fields = getattr(value, "fields", None)
    if fields is not None:
        for field in fields:
            part = getattr(value, field)
            # the fields of an alternative appear beside those of its body
            _require_size(name if hasattr(part, "fields") else f"{name}.{field}", part)
    elif isinstance(value, tuple):
        for index, part in enumerate(value):
            _require_size(f"{name}[{index}]", part)
    elif not name.endswith(ANY_SMALLNESS):
        size: float = abs(value)  # type: ignore[arg-type]
        require(
            (size == 0.0) | ((size > SMALLEST) & (size < LARGEST)),
            "{name} is {value:3} in SI units: the calculation holds sizes from 1e-40 to 1e40",
            name=name,
            value=(value, Ratio),
            code="range",
            hint="check the number and its unit",
        )
