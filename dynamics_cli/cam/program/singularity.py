"""Cam motion in the book's singularity functions: section 16.10, with the book's indices.

δ₀ is the impulse, δ₁ the step, δ₂ the ramp, δ_{n+1}(x) = xⁿ/n! for x > 0 and 0 for x < 0; δ₁(0) is taken as ½.
"""

from math import factorial, pi

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.cam.program.motion import Motion


def delta(index: int, x: float) -> float:
    """Give the book's δ of an index, 1 or more.

    `index`: the index, 1 for the step, 2 for the ramp; `x`: where. Returns its value.

    Equation
    --------
    δ_{n+1}(x) = xⁿ/n! for x ≥ 0, else 0; δ₁(0) = ½.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 16.10.

    Examples
    --------
    >>> delta(1, 0.5), delta(2, 0.5), delta(3, 0.5), delta(2, -1.0)
    (1.0, 0.5, 0.125, 0.0)
    """
    if index == 1:
        return 0.5 if x == 0.0 else float(x > 0.0)
    return x ** (index - 1) / factorial(index - 1) if x > 0.0 else 0.0


class Form:
    """A motion as Σ c δ_k(θ − θᵢ) where laws are polynomials of low degree, and law·[δ₁ − δ₁] where they are not."""

    def __init__(self, motion: "Motion") -> None:
        self.motion = motion
        self.terms: list[tuple[float, int, float]] = []
        self.gated: list[int] = []
        self._previous = [0.0] * 3
        for index, span in enumerate(motion.segments):
            if span.law is None or span.law.name in ("linear", "parabolic"):
                self._add(index)
            else:
                self.gated.append(index)
                self._end(motion.joints[index])
        self._end(motion.joints[-1])

    def _states(self, index: int) -> "list[tuple[float, list[float]]]":
        """Angle and the first three derivatives after it, for each zone of a segment."""
        motion = self.motion
        return [
            (zone.start, list(motion.in_zone(number, 0.0, 2)))
            for number, zone in enumerate(motion.zones)
            if zone.segment == index
        ]

    def _add(self, index: int) -> None:
        for angle, state in self._states(index):
            since = self._value_at(angle)
            self._step(angle, [now - then for now, then in zip(state, since, strict=True)])

    def _end(self, angle: float) -> None:
        self._step(angle, [-value for value in self._value_at(angle)])

    def _value_at(self, angle: float) -> "list[float]":
        """Derivatives of the terms so far just after an angle."""
        derivatives = [0.0] * 3
        for factor, index, place in self.terms:
            for order in range(index):
                power = index - 1 - order
                derivatives[order] += factor * (angle - place) ** power / factorial(power)
        return derivatives

    def _step(self, angle: float, steps: "list[float]") -> None:
        size = max((abs(factor) for factor, _, _ in self.terms), default=0.0)
        for order, step in enumerate(steps):
            if abs(step) > 1e-12 * size:
                self.terms.append((step, order + 1, angle))

    def at(self, theta: float) -> float:
        """The lift by the singularity functions; θ is within the turn and not at a joint."""
        total = sum(factor * delta(index, theta - place) for factor, index, place in self.terms)
        motion = self.motion
        for index in self.gated:
            gate = delta(1, theta - motion.joints[index]) - delta(1, theta - motion.joints[index + 1])
            if gate:
                total += gate * motion.at(theta, 0)[0]
        return float(total)

    def disagreement(self, count: int = 360) -> float:
        """Maximum difference from the motion itself over a turn, as a share of the stroke."""
        motion = self.motion
        least, most = motion.stroke
        size = max(abs(least), abs(most)) or 1.0
        angles = [motion.start + 2.0 * pi * (i + 0.4142135) / count for i in range(count)]
        return float(max(abs(self.at(angle) - motion.at(angle, 0)[0]) for angle in angles) / size)

    def written(self) -> str:
        """The form as text, in millimetres (or degrees) and degrees, as in the book."""
        motion = self.motion
        scale, unit = (180.0 / pi, "deg") if motion.swing else (1e3, "mm")
        parts = []
        for factor, index, place in self.terms:
            number = factor * scale * (pi / 180.0) ** (index - 1)
            away = f"θ − {place * 180.0 / pi:.6g}" if place else "θ"
            parts.append(f"{'−' if number < 0 else '+'} {abs(number):.6g}·δ{index}({away})")
        for index in self.gated:
            start, end = (motion.joints[i] * 180.0 / pi for i in (index, index + 1))
            parts.append(f"+ f{index + 1}(θ)·[δ1(θ − {start:.6g}) − δ1(θ − {end:.6g})]")
        text = " ".join(parts) or "0"
        names = [f"f{i + 1} = {motion.segments[i].law.name} of segment {i + 1}" for i in self.gated]  # type: ignore[union-attr]
        return f"s({unit}, θ in deg) = {text.removeprefix('+ ')}" + (f"; {', '.join(names)}" if names else "")
