"""All assemblies of a scene: dyads in closed form, each based on parts already placed, the rest by Newton."""

from itertools import pairwise

import numpy as np

from dynamics_cli.numerics.linkages.records import GROUND, Scene, Slide
from dynamics_cli.numerics.linkages.system import Shape, System

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Any

    Pins = dict[str, complex]
    # the pin or link with several places, and each place with its name
    Choices = tuple[str, list[tuple[str, Pins]]]

# Number of starts of Newton's method for assemblies that are not dyads.
STARTS = 240
STEPS = 60
SETTLED = 1e-13
SAME = 1e-7
# Relative rounding of a square root's argument: a toggle is still closed.
TOUCH = 1e-13


class Assembly:
    """One assembly of the linkage; `solution` numbers those that only Newton's method distinguishes."""

    def __init__(self, at: "Pins", words: "tuple[tuple[str, str], ...]", dyads: int, solution: str = "") -> None:
        self.at = at
        self.words = words
        self.dyads = dyads
        self.solution = solution

    @property
    def text(self) -> str:
        """The decisions in words."""
        return (
            ", ".join([*(f"{pin} {word}" for pin, word in self.words), *filter(None, [self.solution])])
            or "the only one"
        )


class Assembler:
    """Walks through the decisions."""

    def __init__(self, system: System) -> None:
        self.system = system
        self.scene: Scene = system.scene
        # the smallest gap found, and the pins that could not be joined
        self.gap: tuple[float, str] = (np.inf, "")
        self.newton = False

    def all(self) -> "list[Assembly]":
        """Every assembly, in order."""
        solutions: list[Assembly] = []
        for assembly in self._walk(dict(self.system.known), (), 0):
            if all(max(abs(assembly.at[p] - earlier.at[p]) for p in assembly.at) > SAME for earlier in solutions):
                solutions.append(assembly)
        return solutions

    def _walk(self, at: "Pins", words: "tuple[tuple[str, str], ...]", dyads: int) -> "Iterator[Assembly]":
        at = dict(at)
        while self._carry(at):
            pass
        if all(pin in at for pin in self.system.unknown):
            yield from self._closed(at, words, dyads)
            return
        choices = next(self._choices(at), None)
        if choices is None:
            self.newton = True
            solutions = list(self._by_newton(at))
            for number, solution in enumerate(solutions, 1):
                numbered = f"solution {number} of {len(solutions)}" if len(solutions) > 1 else ""
                yield Assembly(solution, words, dyads, numbered)
            return
        name, places = choices
        for word, more in places:
            yield from self._walk(at | more, (*words, (name, word)) if word else words, dyads + 1)

    def _closed(self, at: "Pins", words: "tuple[tuple[str, str], ...]", dyads: int) -> "Iterator[Assembly]":
        """The assembly, if the conditions not used to place its pins hold too."""
        q = self.system.vector(at)
        gaps = np.abs(self.system.residuals(q))
        worst = float(gaps.max(initial=0.0))
        if worst <= SAME:
            yield Assembly(at, words, dyads)
        elif worst < self.gap[0]:
            self.gap = (worst, self.system.names[int(np.argmax(gaps))])

    def _direction(self, shape: Shape, at: "Pins") -> "complex | None":
        """The unit direction of a link's own x axis where it is known."""
        if shape.name == GROUND:
            return 1.0 + 0j
        placed = [pin for pin in shape.points if pin in at]
        for first, second in pairwise(placed):
            apart = shape.points[second] - shape.points[first]
            if apart:
                turn = (at[second] - at[first]) / apart
                return turn / abs(turn) if turn else None
        return None

    def _carry(self, at: "Pins") -> bool:
        """Place the parts that need no decision; returns whether there were any."""
        for driver in self.scene.drivers:
            if driver.point:
                slide = next(s for s in self.scene.slides if s.point == driver.point)
                if driver.point not in at and slide.start in at and slide.end in at:
                    line = at[slide.end] - at[slide.start]
                    at[driver.point] = at[slide.start] + line / abs(line) * driver.position / self.system.scale
                    return True
                continue
            shape, other = self.system.shapes[driver.link], self.system.shapes[driver.against]
            direction = self._direction(other, at)
            if direction is not None and self._fill(shape, at, direction * np.exp(1j * driver.angle)):
                return True
            direction = self._direction(shape, at)
            if direction is not None and self._fill(other, at, direction * np.exp(-1j * driver.angle)):
                return True
        for shape in self.system.shapes.values():
            direction = self._direction(shape, at)
            if direction is not None and self._fill(shape, at, direction):
                return True
        return False

    def _fill(self, shape: Shape, at: "Pins", way: complex) -> bool:
        """Place all points of a link of known direction that has one placed."""
        start = next((pin for pin in shape.points if pin in at), None)
        missing = [pin for pin in shape.points if pin not in at]
        if start is None or not missing:
            return False
        for pin in missing:
            at[pin] = at[start] + way * (shape.points[pin] - shape.points[start])
        return True

    def _choices(self, at: "Pins") -> "Iterator[Choices]":
        """Decisions that can be taken now."""
        for pin in self.system.unknown:
            if pin in at:
                continue
            circles = []
            for shape in self.system.shapes.values():
                start = next((pin_name for pin_name in shape.points if pin_name in at), None)
                if pin in shape.points and start is not None:
                    circles.append((at[start], abs(shape.points[pin] - shape.points[start]), shape.name))
            lines = [s for s in self.scene.slides if s.point == pin and s.start in at and s.end in at]
            if len(circles) >= 2:
                yield pin, self._circles(pin, circles[0], circles[1])
            elif circles and lines:
                yield pin, self._circle_line(pin, circles[0], lines[0], at)
            elif len(lines) >= 2:
                yield pin, self._lines(pin, lines[0], lines[1], at)
        for slide in self.scene.slides:
            shape = self.system.shapes[slide.link]
            pivot = next((pin_name for pin_name in shape.points if pin_name in at), None)
            if slide.point in at and pivot is not None and self._direction(shape, at) is None:
                yield slide.link, self._slot(shape, slide, pivot, at)

    def _missed(self, gap: float, decision: str) -> "list[tuple[str, Pins]]":
        if gap < self.gap[0]:
            self.gap = (gap, decision)
        return []

    def _circles(self, pin: str, first_circle: "Any", second_circle: "Any") -> "list[tuple[str, Pins]]":
        (centre, radius, name), (second, reach, second_name) = first_circle, second_circle
        centres_apart = second - centre
        f = abs(centres_apart)
        decision = f"{pin} on {name} and {second_name}"
        first, last = (radius + reach - f) * (radius + reach + f), (f - abs(radius - reach)) * (f + abs(radius - reach))
        size = (radius + reach) ** 2
        if f == 0.0 or first < -TOUCH * size or last < -TOUCH * size:
            return self._missed(max(f - radius - reach, abs(radius - reach) - f), decision)
        root = max(first, 0.0) ** 0.5 * max(last, 0.0) ** 0.5
        along = f * f + (radius - reach) * (radius + reach)
        places = [
            (word, {pin: centre + centres_apart * complex(along, sign * root) / (2.0 * f * f)})
            for word, sign in (("left", 1.0), ("right", -1.0))
        ]
        return places if root else [("", places[0][1])]

    def _circle_line(self, pin: str, circle: "Any", slide: Slide, at: "Pins") -> "list[tuple[str, Pins]]":
        centre, radius, name = circle
        line = at[slide.end] - at[slide.start]
        line = line / abs(line)
        away = (centre - at[slide.start]) * line.conjugate()
        square = (radius - abs(away.imag)) * (radius + abs(away.imag))
        if square < -TOUCH * radius * radius:
            return self._missed(abs(away.imag) - radius, f"{pin} on {name} and its slide")
        root = max(square, 0.0) ** 0.5
        places = [
            (word, {pin: at[slide.start] + line * (away.real + sign * root)})
            for word, sign in (("ahead", 1.0), ("behind", -1.0))
        ]
        return places if root else [("", places[0][1])]

    def _lines(self, pin: str, first: Slide, second_slide: Slide, at: "Pins") -> "list[tuple[str, Pins]]":
        line, second = at[first.end] - at[first.start], at[second_slide.end] - at[second_slide.start]
        across = (line.conjugate() * second).imag
        if across == 0.0:
            return self._missed(np.inf, f"{pin} on two parallel slides")
        fraction = ((at[second_slide.start] - at[first.start]).conjugate() * second).imag / across
        return [("", {pin: at[first.start] + fraction * line})]

    def _slot(self, shape: Shape, slide: Slide, pivot: str, at: "Pins") -> "list[tuple[str, Pins]]":
        """A link on one pin whose line passes through another."""
        start, line = shape.points[slide.start], shape.points[slide.end] - shape.points[slide.start]
        line = line / abs(line)
        # the line as seen from the pivot, in the link's own axes along the line
        height = ((start - shape.points[pivot]) * line.conjugate()).imag
        to_slot = at[slide.point] - at[pivot]
        square = (abs(to_slot) - abs(height)) * (abs(to_slot) + abs(height))
        if abs(to_slot) == 0.0 or square < -TOUCH * abs(to_slot) ** 2:
            return self._missed(abs(height) - abs(to_slot), f"{slide.point} on the line of {shape.name}")
        places = []
        for word, sign in (("ahead", 1.0), ("behind", -1.0)):
            local = complex(sign * max(square, 0.0) ** 0.5, height) * line
            turn = to_slot / local
            turn = turn / abs(turn)
            places.append((
                word, {pin: at[pivot] + turn * (shape.points[pin] - shape.points[pivot]) for pin in shape.points}
            ))  # fmt: skip
        return places

    def _by_newton(self, at: "Pins") -> "Iterator[Pins]":
        """Assemblies without dyads, by Newton's method from sketches and from distributed starts."""
        system = self.system
        rest = [pin for pin in system.unknown if pin not in at]
        sketch = {near.pin: complex(*near.at) / system.scale for near in self.scene.near}
        middle = sum(at.values()) / max(1, len(at))
        golden = 0.6180339887498949
        solutions: list[Any] = []
        best = np.inf
        for start in range(STARTS):
            guess = dict(at)
            for index, pin in enumerate(rest):
                phase = (start * golden * (index + 1) + 0.37 * index) % 1.0
                radius = 2.0 * ((start * 0.7548776662466927 + 0.29 * index) % 1.0)
                guess[pin] = middle + radius * np.exp(2j * np.pi * phase)
            if start == 0:
                guess |= {pin: place for pin, place in sketch.items() if pin in guess}
            q, gap = refined(system, system.vector(guess))
            best = min(best, gap)
            if gap <= 1e3 * SETTLED and all(np.abs(q - other).max() > SAME for other in solutions):
                solutions.append(q)
        if not solutions:
            self._missed(best, "links that can only be placed together")
        solutions.sort(key=lambda q: q.round(9).tolist())
        for q in solutions:
            places = system.positions(q)
            # dyads already placed keep their side
            if all(abs(places[pin] - at[pin]) < SAME for pin in at):
                yield places


def refined(system: System, q: "Any") -> "tuple[Any, float]":
    """Newton's method with halved steps; the solution and its largest residual."""
    gap = float(np.abs(system.residuals(q)).max(initial=0.0))
    for _ in range(STEPS):
        if gap <= SETTLED * 0.01:
            break
        step = np.linalg.lstsq(system.jacobian(q), -system.residuals(q))[0]
        damping = 1.0
        while damping > 0.02:
            new = q + damping * step
            residual = float(np.abs(system.residuals(new)).max())
            if residual < gap:
                break
            damping *= 0.5
        else:
            break
        q, gap = new, residual
    return q, gap
