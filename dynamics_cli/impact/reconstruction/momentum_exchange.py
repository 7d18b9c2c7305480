"""The impulse that two vehicles exchanged, along any heading, and their ΔV."""

from dynamics_cli.impact.conventions import (
    Axes,
    DeltaV,
    PdofZero,
    clock,
    direction_of,
    pdof,
)
from dynamics_cli.impact.reconstruction.momentum_terms import Term
from dynamics_cli.numerics.elementary import absolute, cos, hypot, sin, where
from dynamics_cli.numerics.number import is_array
from dynamics_cli.sampling import drawing

Pair = tuple[float, float]


def _velocity(term: Term, axes: Axes) -> Pair:
    x, y = direction_of(term.heading, axes)  # type: ignore[arg-type]
    return term.speed * x, term.speed * y  # type: ignore[operator]


class Exchange:
    """The impulse on the first vehicle along any heading, from whichever vehicle has the smaller momenta.

    Sine and cosine take differences of headings, so that inaccessible components do not spoil the result. Vehicles that
    met on one line have exchanged a known impulse along it: `straight` is its heading and its amount on the first.
    """

    def __init__(self, terms: list[Term], axes: Axes, straight: Pair | None = None) -> None:
        self.terms = terms
        self.axes = axes
        self.straight = straight
        self.plane = [_velocity(term, axes) for term in terms]
        self.left = -1.0 if axes == "compass" else 1.0
        amounts = [absolute(t.amount) for t in terms]
        self.first_smaller = amounts[0] + amounts[2] <= amounts[1] + amounts[3]
        self.impulse = self.components(None)

    def _turned(self, index: int, heading: float | None) -> Pair:
        """Velocity of one vehicle along a heading (None: along the x-axis) and across it."""
        term = self.terms[index]
        if heading is None:
            return self.plane[index]
        if heading is term.heading:
            return term.speed, 0.0  # type: ignore[return-value]
        apart = term.heading - heading  # type: ignore[operator]
        return term.speed * cos(apart), self.left * (term.speed * sin(apart))  # type: ignore[operator]

    def _along_the_line(self, line: float, amount: float, heading: float | None) -> Pair:
        if heading is None:
            x, y = direction_of(line, self.axes)
            return amount * x, amount * y
        if heading is line:
            return amount, 0.0
        return amount * cos(line - heading), self.left * (amount * sin(line - heading))

    def components(self, heading: float | None) -> Pair:
        """Impulse along a heading, and to its left (in SAE axes to its right); along the axes x and y for None."""
        if self.straight is not None:
            return self._along_the_line(*self.straight, heading)
        if heading is not None and drawing():
            # of samples no digit is lost that counts, and sines of arrays are slow
            (px, py), (x, y) = self.impulse, direction_of(heading, self.axes)
            return px * x + py * y, py * x - px * y
        smaller = self.first_smaller
        impulses: list[Pair] = []
        for before, after, mass, required in (
            (0, 2, self.terms[0].mass, smaller),
            (3, 1, self.terms[1].mass, ~smaller if is_array(smaller) else not smaller),
        ):
            if not is_array(smaller) and not required:
                continue
            old, new = self._turned(before, heading), self._turned(after, heading)
            impulses.append((mass * (new[0] - old[0]), mass * (new[1] - old[1])))
        if len(impulses) == 1:
            return impulses[0]
        return where(smaller, impulses[0][0], impulses[1][0]), where(smaller, impulses[0][1], impulses[1][1])


def change_of_velocity(
    exchange: Exchange, impulse: Pair, sign: float, term: Term, nose: float, axes: Axes, zero: PdofZero
) -> DeltaV:
    """ΔV of one vehicle from the impulse, in the scene's axes and its own."""
    change = sign / term.mass
    along, across = exchange.components(nose)
    facing = along, across
    if zero != "heading":
        facing = exchange.components(term.heading if zero == "travel" else 0.0)
    angle = _pdof(sign * facing[0], sign * facing[1], axes)
    hours = angle if zero == "heading" else _pdof(sign * along, sign * across, axes)
    x, y = change * impulse[0], change * impulse[1]
    return DeltaV((x, y), hypot(x, y), change * along, change * across, angle, clock(hours))


def _pdof(along: float, across: float, axes: Axes) -> float:
    """PDOF of an impulse with parts along and across the zero."""
    return pdof((along, across), (1.0, 0.0), axes)
