"""Conservation of momentum in the plane with up to two unknowns: m₁v₁ + m₂v₂ = m₁u₁ + m₂u₂, solved in closed form.

Four vectors meet in the equation: two before, two after. Each has a magnitude and a direction; those not given
are unknown. Directions are headings of one sense of rotation, so every axis convention gives the same sines.
"""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute, acos, atan2, cos, hypot, sin, sqrt, where
from dynamics_cli.quantities import Impulse, RoadSpeed
from dynamics_cli.records import Choice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

PI = 3.141592653589793
CHECK_HEADINGS = "check headings (they are directions of travel) and the speeds after"


class Branch(Choice):
    """Which of two solutions: the larger or smaller speed, or the first unknown heading left or right of the rest."""

    names = ("larger", "smaller", "left", "right")


class Term:
    """One momentum: sign in the equation, mass, speed and heading (None: unknown), name; the vehicle's own, if any."""

    def __init__(
        self, sign: float, mass: float, speed: float | None, heading: float | None, name: str, own: str | None = None
    ) -> None:
        self.sign = sign
        self.mass = mass
        self.speed = speed
        self.heading = heading
        self.name = name
        self.after = name.endswith(" exit")
        self.vehicle = own or name.removesuffix(" exit")

    @property
    def called(self) -> str:
        """What it is called in a sentence."""
        return f"{self.vehicle} after the impact" if self.after else self.vehicle

    @property
    def heading_name(self) -> str:
        """The parameter that gives its heading."""
        side, _, after = self.name.removeprefix("the ").partition(" ")
        return f"{side}.{after or 'approach'}_heading"

    @property
    def speed_name(self) -> str:
        """The parameter that gives its speed, and the result."""
        return self.heading_name.replace("heading", "speed")

    @property
    def amount(self) -> float:
        """Signed size of a known momentum."""
        assert self.speed is not None
        return self.sign * (self.mass * self.speed)

    @property
    def vector(self) -> tuple[float, float]:
        """A known momentum with its sign."""
        assert self.heading is not None
        return self.amount * cos(self.heading), self.amount * sin(self.heading)


class Solution:
    """The completed terms; how well the angles determine them, and the closing error of the equation."""

    def __init__(self, condition: float | None = None, closure: float | None = None) -> None:
        self.condition = condition
        self.closure = closure


def unknowns(terms: "Sequence[Term]") -> list[str]:
    """Names of the unknown quantities."""
    return [
        f"the {quantity} of {t.vehicle} {'after' if t.after else 'before'} the impact"
        for t in terms
        for quantity in ("speed", "heading")
        if getattr(t, quantity) is None
    ]


def solve(terms: "Sequence[Term]", branch: Branch | None) -> Solution:
    """Fill in the unknowns of the terms."""
    missing = unknowns(terms)
    require(
        len(missing) <= 2,
        "{count} unknowns ({missing}), but momentum in the plane gives two equations",
        count=len(missing),
        missing=", ".join(missing),
        code="too-many-unknowns",
        hint="give the missing speeds or headings; a vehicle at rest has speed 0 and any heading",
    )
    sizes = [t for t in terms if t.speed is None]
    turns = [t for t in terms if t.heading is None]
    rest = [t for t in terms if t.speed is not None and t.heading is not None]
    if not missing:
        return Solution(closure=hypot(*_sum(rest)))
    if len(sizes) == 2:
        return _two_sizes(sizes[0], sizes[1], rest)
    if len(sizes) == 1 and not turns:
        return _one_size(sizes[0], rest)
    if len(turns) == 1 and not sizes:
        return _one_heading(turns[0], rest)
    if len(turns) == 2:
        return _two_headings(turns[0], turns[1], rest, branch)
    if sizes[0] is turns[0]:
        return _one_vector(sizes[0], rest)
    return _size_and_heading(sizes[0], turns[0], rest, branch)


def angle_condition(first: float, second: float) -> float:
    """Condition of two directions: the cotangent of half the angle between their lines, 1 at 90 degrees."""
    apart = second - first
    return (1.0 + absolute(cos(apart))) / absolute(sin(apart))


def _two_sizes(first: Term, second: Term, rest: "Sequence[Term]") -> Solution:
    assert first.heading is not None and second.heading is not None  # noqa: PT018
    sine = sin(second.heading - first.heading)
    require(
        absolute(sine) > 1e-9,
        "{one} and {other} lie on one line: momentum cannot tell their speeds apart",
        one=first.called,
        other=second.called,
        code="collinear",
        hint="give the crush energies or equivalent speeds of both vehicles: the energy decides",
    )
    first.speed = -_across(rest, second.heading) / (first.sign * first.mass * sine)
    second.speed = _across(rest, first.heading) / (second.sign * second.mass * sine)
    require_forward(first.speed >= 0.0, first, first.speed)
    require_forward(second.speed >= 0.0, second, second.speed)
    return Solution(condition=angle_condition(first.heading, second.heading))


def _across(rest: "Sequence[Term]", heading: float) -> float:
    """Cross product of the known momenta with the direction of a heading."""
    total: float = 0.0
    for term in rest:
        assert term.heading is not None
        total = total + term.amount * sin(heading - term.heading)
    return total


def _along(rest: "Sequence[Term]", heading: float) -> float:
    """The known momenta along a heading."""
    total: float = 0.0
    for term in rest:
        assert term.heading is not None
        total = total + term.amount * cos(heading - term.heading)
    return total


def _sum(rest: "Sequence[Term]") -> tuple[float, float]:
    x: float = 0.0
    y: float = 0.0
    for term in rest:
        along, across = term.vector
        x, y = x + along, y + across
    return x, y


def require_forward(forward: bool, term: Term, speed: float | None, hint: str = CHECK_HEADINGS) -> None:
    """Refuse a speed against its heading."""
    require(
        forward,
        "the speed of {name} would be {speed}: it would have moved backwards",
        name=term.called,
        speed=(speed, RoadSpeed),
        code="backwards",
        hint=hint,
    )


def _one_size(term: Term, rest: "Sequence[Term]") -> Solution:
    """One speed from two equations: from the momentum along its heading; the remainder across is the closing error."""
    assert term.heading is not None
    term.speed = -_along(rest, term.heading) / (term.sign * term.mass)
    require_forward(term.speed >= 0.0, term, term.speed)
    return Solution(closure=absolute(_across(rest, term.heading)))


def _one_heading(term: Term, rest: "Sequence[Term]") -> Solution:
    """One heading: that of the required momentum, whose magnitude may not quite close."""
    x, y = _sum(rest)
    _require_direction(x, y, term)
    term.heading = atan2(-term.sign * y, -term.sign * x)
    return Solution(closure=absolute(hypot(x, y) - absolute(term.amount)))


def _require_direction(x: float, y: float, term: Term) -> None:
    require(
        hypot(x, y) > 0.0,
        "{name} would have no momentum, hence no heading",
        name=term.called,
        code="no-heading",
        hint="give its heading",
    )


def _one_vector(term: Term, rest: "Sequence[Term]") -> Solution:
    x, y = _sum(rest)
    _require_direction(x, y, term)
    term.speed = hypot(x, y) / term.mass
    term.heading = atan2(-term.sign * y, -term.sign * x)
    return Solution()


def _size_and_heading(sized: Term, turned: Term, rest: "Sequence[Term]", branch: Branch | None) -> Solution:
    """The speed of one and the heading of another: a quadratic, whose nonnegative speeds count."""
    assert sized.heading is not None
    along = -sized.sign * _along(rest, sized.heading)
    across = _across(rest, sized.heading)
    reach = absolute(turned.amount)
    require(
        reach >= absolute(across),
        "the momentum of {name}, {reach:6}, is too small to close the equation: {needed:6} are needed",
        name=turned.called,
        reach=(reach, Impulse),
        needed=(absolute(across), Impulse),
        code="no-solution",
    )
    root = sqrt((reach - absolute(across)) * (reach + absolute(across)))
    upper, lower = (along + root) / sized.mass, (along - root) / sized.mass
    require_forward(upper >= 0.0, sized, upper)
    require(
        (lower < 0.0) | (lower == upper) | (branch is not None),
        "two speeds of {name} close the equation, {lower:6} and {upper:6}",
        name=sized.called,
        lower=(lower, RoadSpeed),
        upper=(upper, RoadSpeed),
        code="ambiguous",
        hint="choose with --branch larger or --branch smaller",
    )
    sized.speed = where((lower >= 0.0) & (branch == "smaller"), lower, upper)
    x, y = _sum([*rest, sized])
    turned.heading = atan2(-turned.sign * y, -turned.sign * x)
    return Solution()


def _two_headings(first: Term, second: Term, rest: "Sequence[Term]", branch: Branch | None) -> Solution:
    """Two headings: a triangle of three known sides, which may lie on either side of the known one."""
    x, y = _sum(rest)
    side, a, b = hypot(x, y), absolute(first.amount), absolute(second.amount)
    require((side > 0.0) & (a > 0.0), "the momenta form no triangle: one of its sides is zero", code="no-solution")
    cosine = (side * side + (a - b) * (a + b)) / (2.0 * side * a)
    require(
        absolute(cosine) <= 1.0,
        "the momenta form no triangle: sides of {known:6}, {one:6} and {other:6} do not close",
        known=(side, Impulse),
        one=(a, Impulse),
        other=(b, Impulse),
        code="no-solution",
    )
    require(
        branch is not None,
        "two mirrored pairs of headings close the equation",
        code="ambiguous",
        hint="choose with --branch left or --branch right: {name} to that side of the known momentum",
        name=first.called,
    )
    turn = acos(cosine)
    base = atan2(-first.sign * y, -first.sign * x)
    first.heading = base + turn if branch in ("left", "larger") else base - turn
    x, y = _sum([*rest, first])
    second.heading = atan2(-second.sign * y, -second.sign * x)
    return Solution()
